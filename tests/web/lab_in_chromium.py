#!/usr/bin/env python3
"""Opens the lab's page in Chromium from disk, as a student does, and presses keys: lab_in_chromium.py PAGE [--shots FOLDER]

With --shots it leaves pictures of what it saw: to be looked at. Exit code 77: there is no Chromium here."""
import argparse
import pathlib
import sys
import tempfile
import time

from browser import Browser, check, failures, find_chromium

# Mesa's driver by way of ANGLE: four times as fast as Chromium's own on a CPU.
FLAGS = ["--use-gl=angle", "--use-angle=gl-egl", "--ignore-gpu-blocklist"]
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


def press(b, key, code, number):
    for kind in ("keyDown", "keyUp"):
        text = {"text": key} if kind == "keyDown" and len(key) == 1 else {}
        b.ask("Input.dispatchKeyEvent", type=kind, key=key, code=code, windowsVirtualKeyCode=number, **text)
    wait_for_frames(b, 3)


def open_page(b, url):
    begin = time.monotonic()
    b.open(url)
    there = wait_for_frames(b, 1)
    print(f"        first frame after {time.monotonic() - begin:.1f} s")
    check(there and said(b) == "", f"{url.rpartition('/')[2]} opens and says nothing is wrong: {said(b)[:200]}")


def use(b, page, shot):
    open_page(b, page)
    wait_for_frames(b, 5)
    shot("start")
    first = picture(b)
    press(b, "c", "KeyC", 67)
    check(picture(b) != first, "C draws the light volumes' other faces")
    shot("cull")
    press(b, "x", "KeyX", 88)
    check(picture(b) == first, "and X takes the sound choice again, to the same picture")
    press(b, "3", "Digit3", 51)
    check(picture(b) != first, "3 shows the normals")
    shot("normals")
    press(b, "F12", "F12", 123)
    saved = b.js("document.body.dataset.saved || ''")
    check(saved.endswith(".png"), f"F12 gives a picture to keep: {saved}")
    open_page(b, page + "?preset=exact&lights=16")
    wait_for_frames(b, 5)
    shot("exact")
    open_page(b, page + "?lesson=what-is-in-a-g-buffer")
    wait_for_frames(b, 5)
    shot("lesson")
    open_page(b, page + "?pitfall=near-plane-cut")
    wait_for_frames(b, 5)
    shot("pitfall")
    b.open(page + "?preset=nowhere")
    time.sleep(3)
    check("nowhere" in said(b), "a preset that is not there is named: " + said(b)[:120])
    check(not b.complaints, f"nothing is complained of and nothing is fetched: {b.complaints[:3]}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("page", type=pathlib.Path)
    parser.add_argument("--shots", type=pathlib.Path)
    asked = parser.parse_args()
    chromium = find_chromium()
    if not chromium:
        return 77
    with tempfile.TemporaryDirectory() as temporary:
        browser = Browser(chromium, pathlib.Path(temporary) / "profile", *FLAGS)

        def shot(name):
            if asked.shots:
                asked.shots.mkdir(parents=True, exist_ok=True)
                browser.shot(asked.shots / (name + ".png"))

        try:
            browser.ask("Emulation.setDeviceMetricsOverride", width=1280, height=720, deviceScaleFactor=1, mobile=False)
            use(browser, asked.page.resolve().as_uri(), shot)
        finally:
            browser.close()
    print(f"{len(failures)} checks failed" if failures else "all checks hold")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
