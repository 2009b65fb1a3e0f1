"""What the lab's page teaches with: lessons, pitfalls, overlays, A and B, the chart, the reference, exercises."""
import json
import pathlib
import re
import time

from checks import check
from page import PATIENCE_S, frames, open_page, picture, press, rest, said, wait_for_frames, words

ROOT = pathlib.Path(__file__).resolve().parents[2]
ANSWERS = ROOT / "tests" / "exercises" / "answers"
ASSETS = ROOT / "assets"


def line_of(b, begin):
    """What the words for a screen reader say in the line that begins so."""
    return next((line for line in words(b).splitlines() if line.startswith(begin)), "")


def wait_until(holds, seconds=PATIENCE_S):
    begin = time.monotonic()
    while not holds() and time.monotonic() - begin < seconds:
        time.sleep(0.2)
    return holds()


def wait_until_still(b):
    """While the reference is worked out, how far it is stands in the picture."""
    before, now = None, b.picture()
    while before != now:
        time.sleep(2)
        before, now = now, b.picture()


def addresses(b, page, shot):
    for address in ("?preset=exact&lights=16", "?lesson=what-is-in-a-g-buffer", "?pitfall=near-plane-cut", "?present=1&set=lights.cull=back"):
        open_page(b, page + address)
        shot(address.strip("?").partition("=")[0])


def lecture(b, page, shot):
    """docs/lecture.md from begin to end, as it is held: the picture and one caption."""
    steps = json.loads((ASSETS / "lessons" / "ten-minutes.json").read_text())["steps"]
    open_page(b, page + "?lesson=ten-minutes&present=1")
    b.js("canvas.focus()")
    for i, step in enumerate(steps):
        if i > 0:
            press(b, "PageDown")
        rest(b)
        asked = line_of(b, "Lesson")
        press(b, "Enter")
        rest(b)
        told = f"step {i + 1} of {len(steps)}: {step['say']}" in asked and step["answer"] not in asked and step["answer"] in line_of(b, "Lesson")
        check(told, f"step {i + 1} of the lecture says, asks, and Enter answers: {asked[:90]!r}")
        if "error" in words(b).splitlines()[0].lower():
            wait_until_still(b)
        shot(f"lecture_{i + 1}")
    address, here = b.js("location.href"), f"step {len(steps)} of {len(steps)}"
    check(f"lesson=ten-minutes:{len(steps)}#" in address, f"the address names the step: {address[:160]}")
    open_page(b, address)
    check(here in line_of(b, "Lesson"), f"and brings it back: {line_of(b, 'Lesson')[:90]!r}")


def overlays(b, page, shot):
    open_page(b, page)
    b.js("canvas.focus()")
    first = picture(b)
    press(b, "v", control=True)
    check(line_of(b, "Panel overlays") != "", "Ctrl+V lists what can be laid over the picture")
    for key, what in (("d", "footprint"), ("j", "wire")):
        before = picture(b)
        press(b, key)
        rest(b)
        check(picture(b) != before, f"{what} is laid over it")
    shot("overlays")
    press(b, "End")
    press(b, "Escape")
    rest(b)
    check(picture(b) == first, "and End takes all of it away")


def comparisons(b, page, shot):
    open_page(b, page)
    b.js("canvas.focus()")
    first = picture(b)
    press(b, "c")
    rest(b)
    changed = picture(b)
    press(b, "Tab")
    rest(b)
    check(picture(b) == first, "Tab flips to the state before the change")
    press(b, "Tab")
    rest(b)
    check(picture(b) == changed, "and back")
    press(b, "/")
    rest(b)
    check(picture(b) not in (first, changed), "/ shows both on one picture")
    shot("wipe")
    press(b, "b", control=True)
    press(b, "t")
    before = picture(b)
    press(b, "d")
    wait_until_still(b)
    check(picture(b) != before, "the truth can be B, and the difference is shown")
    shot("difference")


def chart(b, page, shot):
    open_page(b, page + "?scene=builtin:room&lights=16")
    b.js("canvas.focus()")
    press(b, "F3")
    # Of the fifteen, two need EXT_clip_control.
    done = wait_until(lambda: re.search(r" (15|13)/\1, ", line_of(b, "Panel chart")), 240)
    check(done, f"F3 measures all of the quick study: {line_of(b, 'Panel chart')[:160]}")
    shot("chart")
    before = picture(b)
    press(b, "ArrowRight")
    check("Chosen" in line_of(b, "Panel chart"), f"a point is chosen and said: {line_of(b, 'Panel chart')[-200:]}")
    press(b, "Enter")
    rest(b)
    check("settings changed" in words(b) and picture(b) != before, "Enter applies it")
    # A click does so as well: each place of a grid over the plot is tried until it meets a point.
    link = b.js("location.href")
    places = [(x, y) for y in range(90, 460, 14) for x in range(700, 1240, 14)]
    hit = None
    for x, y in places:
        b.mouse(x, y)
        if "Chosen" in line_of(b, "Panel chart") and line_of(b, "Panel chart") != hit:
            hit = line_of(b, "Panel chart")
            b.mouse(x, y, "mousePressed")
            b.mouse(x, y, "mouseReleased")
            rest(b)
            if b.js("location.href") != link:
                break
    check(b.js("location.href") != link, "and so does a click on a point")
    shot("chart_applied")


def reference(b, page, shot):
    open_page(b, page + "?scene=builtin:room&lights=4")
    b.js("canvas.focus()")
    press(b, "u")
    begin, longest = time.monotonic(), 0
    wait_until(lambda: "error" in words(b).splitlines()[0].lower())
    while time.monotonic() - begin < 20:
        before = time.monotonic()
        wait_for_frames(b, 1)
        longest = max(longest, time.monotonic() - before)
    print(f"        longest frame beside the reference: {longest:.2f} s")
    shot("error")


def verdict_of(b, answer):
    """What the page says of an answer's file, and how long it stood still for that."""
    b.js(f"document.getElementById('answer').value = {json.dumps(answer)}, document.getElementById('check').click()")
    begin = time.monotonic()
    wait_until(lambda: "checking" not in b.js("document.getElementById('verdict').textContent"), 120)
    return b.js("document.getElementById('verdict').textContent"), time.monotonic() - begin


def a_pixel_by_a_click(b, shot):
    b.js("document.getElementById('which').value = 'tangent-face', document.getElementById('which').onchange()")
    b.mouse(2, 700)  # not on the picture
    rest(b)
    take = "[...document.querySelectorAll('#helpers button')].find(b => b.textContent.includes('held pixel')).click()"
    b.js(take)
    check("no pixel is held" in b.js("document.getElementById('verdict').textContent"), "where no pixel is held that is said")
    right = json.loads((ANSWERS / "tangent-face" / "right.json").read_text())["answer"]
    b.mouse(50, 100)
    wait_for_frames(b, 3)
    size = [int(n) for n in b.js("lab.ccall('page_pixel', 'string', [], [])").split()[2:]]
    place = [(p + 0.5) * s / t for p, s, t in zip(right, size, b.js("exercise.task.size"))]
    for kind in ("mouseMoved", "mousePressed", "mouseReleased"):
        b.mouse(*place, kind)
        wait_for_frames(b, 2)
    rest(b)
    b.js(take)
    taken = b.js("document.getElementById('answer').value")
    verdict, _ = verdict_of(b, taken)
    check(verdict.startswith("right"), f"a click answers with its pixel: {taken.strip()}: {verdict[:60]!r}")
    shot("exercise_pixel")


def exercises(b, page, shot):
    open_page(b, page + "?exercise=quad-space")
    names = b.js("[...document.getElementById('which').options].map(o => o.value).join(' ')").split()
    check(sorted(names) == sorted(f.name for f in ANSWERS.iterdir()), f"all {len(names)} exercises are offered")
    check("?exercise=quad-space" in b.js("location.href"), "and the address names the one that is open")
    shown = picture(b)
    longest = 0
    for name in names:
        b.js(f"document.getElementById('which').value = '{name}', document.getElementById('which').onchange()")
        rest(b)
        for file in sorted((ANSWERS / name).iterdir()):
            verdict, seconds = verdict_of(b, file.read_text())
            longest = max(longest, seconds)
            meant = "right" if file.stem == "right" else "wrong"
            check(verdict.splitlines()[0] == meant, f"{name}, {file.stem}: {verdict[:100]!r}")
    print(f"        longest check of an answer: {longest:.1f} s")
    b.js("document.getElementById('which').value = 'quad-space', document.getElementById('which').onchange()")
    rest(b)
    check(picture(b) == shown, "an exercise's picture is the same after answers were judged")
    b.js("document.querySelector('#helpers button').click()")
    check('"answer": "view"' in b.js("document.getElementById('answer').value"), "a choice is made by a click")
    refused, _ = verdict_of(b, "nonsense")
    check("quad-space.json:1:" in refused, f"what is no answer is refused with its place: {refused!r}")
    shot("exercise")
    a_pixel_by_a_click(b, shot)


def bad_addresses(b, page):
    for query, name in (("?preset=nowhere", "nowhere"), ("?exercise=quad-spaec", "quad-space")):
        b.open("about:blank")
        b.open(page + query)
        wait_for_frames(b, 3)
        check(name in said(b) and frames(b) > 2, f"{query} is named, and the lab opens: {said(b)[:120]}")


def use(b, page, shot):
    addresses(b, page, shot)
    lecture(b, page, shot)
    overlays(b, page, shot)
    comparisons(b, page, shot)
    chart(b, page, shot)
    reference(b, page, shot)
    exercises(b, page, shot)
    bad_addresses(b, page)
