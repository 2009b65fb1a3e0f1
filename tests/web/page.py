"""The lab's page in a browser: what a test does with it, and what it reads from it."""
import time

from checks import check

PATIENCE_S = 60  # for one frame beside other work


def frames(b):
    return int(b.js("document.body.dataset.frames || '0'"))


def wait_for_frames(b, more):
    begin, now = time.monotonic(), frames(b)
    while frames(b) < now + more and time.monotonic() - begin < PATIENCE_S:
        time.sleep(0.05)
    return frames(b) >= now + more


def said(b):
    return b.js("document.querySelector('#said').textContent.trim()")


def picture(b):
    """Of the first screen's large view, without what lies over it."""
    return b.picture(40, 60, (500, 200))


def press(b, key, control=False):
    b.key(key, control)
    wait_for_frames(b, 3)


def words(b):
    return b.js("document.querySelector('#words').textContent")


def rest(b):
    """Until nothing moves any more: the address then says what is shown."""
    time.sleep(0.5)
    wait_for_frames(b, 6)


def open_page(b, url):
    begin = time.monotonic()
    b.open("about:blank")  # else another # is no other page
    b.open(url)
    there = wait_for_frames(b, 1)
    print(f"        first frame after {time.monotonic() - begin:.1f} s")
    wait_for_frames(b, 5)
    check(there and said(b) == "", f"{url.rpartition('/')[2][:60]} opens and says nothing is wrong: {said(b)[:200]}")
