#!/usr/bin/env python3
"""How long the lab's page takes: page_times.py PAGE [--program gbufferlab]

For each browser here: start to first frame, five times; one step while 16 lights move, three times; the longest step beside
the reference. With --program one step of the program's window of the same size with --gl es3, between those."""
import argparse
import pathlib
import subprocess
import tempfile
import time

from chromium import MESA, Chromium, there_is_chromium
from firefox import Firefox, there_is_firefox
from page import frames, press, wait_for_frames

SIZE = (1280, 720)
MOVING_S = 10
LONGEST = """window.longest = 0; window.last = performance.now();
(function frame() { const now = performance.now(); longest = Math.max(longest, now - last); last = now; requestAnimationFrame(frame); })(); 0"""
# The lights of the window are set moving by its key; the time of the frames before that is taken away by a run that ends earlier.
WINDOW = """"$0" view --gl es3 --fresh --lights 16 --frames "$1" &
sleep 4; id=$(xdotool search --onlyvisible --name "G-Buffer Lab" | head -1); xdotool windowsize "$id" {} {} mousemove 10 10 key --window "$id" space
wait $!""".format(*SIZE)


def opened(b, url, more=3):
    b.open("about:blank")
    b.open(url)
    wait_for_frames(b, more)


def first_frame_ms(b, page):
    opened(b, page)
    return round(b.js("performance.getEntriesByName('first frame')[0].startTime"))


def step_ms(b, page):
    opened(b, page + "?lights=16", 8)
    b.js("canvas.focus()")
    time.sleep(3)
    press(b, " ")
    time.sleep(1)
    before, begin = frames(b), time.monotonic()
    time.sleep(MOVING_S)
    return round(1000 * (time.monotonic() - begin) / max(1, frames(b) - before))


def longest_step_ms(b, page):
    opened(b, page + "?scene=builtin:room&lights=4", 8)
    b.js("canvas.focus()")
    time.sleep(2)
    b.js(LONGEST)
    press(b, "u")
    time.sleep(14)
    return round(b.js("longest"))


def window_step_ms(program):
    def run_s(count):
        with tempfile.TemporaryDirectory() as state:
            begin = time.monotonic()
            subprocess.run(["xvfb-run", "-a", "-s", "-screen 0 {}x{}x24".format(*SIZE), "env", f"XDG_STATE_HOME={state}", "bash", "-c", WINDOW, program, str(count)],
                           check=True, capture_output=True)
            return time.monotonic() - begin
    fewer, more = 100, 200
    return round(1000 * (run_s(more) - run_s(fewer)) / (more - fewer))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("page", type=lambda p: pathlib.Path(p).resolve().as_uri())
    parser.add_argument("--program", type=lambda p: pathlib.Path(p).resolve())
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        browsers = []
        if there_is_chromium():
            browsers.append(Chromium(pathlib.Path(folder) / "chromium", SIZE, *MESA))
        if there_is_firefox():
            browsers.append(Firefox(pathlib.Path(folder) / "firefox", SIZE))
        try:
            for b in browsers:
                print(f"{b.name}: start to first frame {[first_frame_ms(b, asked.page) for _ in range(5)]} ms", flush=True)
                b.open("about:blank")
            for _ in range(3):
                for b in browsers:
                    print(f"{b.name}: one step while 16 lights move {step_ms(b, asked.page)} ms", flush=True)
                    b.open("about:blank")
                if asked.program:
                    print(f"the program: {window_step_ms(asked.program)} ms", flush=True)
            for b in browsers:
                print(f"{b.name}: longest step beside the reference {longest_step_ms(b, asked.page)} ms", flush=True)
                b.open("about:blank")
        finally:
            for b in browsers:
                b.close()


if __name__ == "__main__":
    main()
