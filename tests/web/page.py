"""The lab's page in a Chromium: what a test does with it, and what it reads from it."""
import time

from browser import check

# Mesa's driver by way of ANGLE: four times as fast as Chromium's own on a CPU.
FLAGS = ["--use-gl=angle", "--use-angle=gl-egl", "--ignore-gpu-blocklist"]
SWIFTSHADER = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
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
    return b.ask("Page.captureScreenshot", format="png", clip={"x": 40, "y": 60, "width": 500, "height": 200, "scale": 1})["data"]


CONTROL = 2  # of a key's modifiers


def press(b, key, code, number, modifiers=0):
    for kind in ("keyDown", "keyUp"):
        text = {"text": key} if kind == "keyDown" and len(key) == 1 and not modifiers else {}
        b.ask("Input.dispatchKeyEvent", type=kind, key=key, code=code, windowsVirtualKeyCode=number, modifiers=modifiers, **text)
    wait_for_frames(b, 3)


def letter(b, name, modifiers=0):
    press(b, name, "Key" + name.upper(), ord(name.upper()), modifiers)


def with_control(b, name):
    control = {"key": "Control", "code": "ControlLeft", "windowsVirtualKeyCode": 17}
    b.ask("Input.dispatchKeyEvent", type="keyDown", modifiers=CONTROL, **control)
    letter(b, name, CONTROL)
    b.ask("Input.dispatchKeyEvent", type="keyUp", **control)
    wait_for_frames(b, 3)


def words(b):
    return b.js("document.querySelector('#words').textContent")


def touch(b, kind, *points):
    b.ask("Input.dispatchTouchEvent", type=kind, touchPoints=[{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(points)])


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
