#!/usr/bin/env python3
"""Opens a study's page in Chromium from disk and uses it: hover, keys, families, axes, sort, filter, compare.

page_in_chromium.py PROGRAM [--page FILE] [--shots FOLDER]
Without --page it measures a small study first. With --shots it leaves pictures of what it saw: to be looked at.
Exit code 77: there is no Chromium here."""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
import time

from checks import check, failures
from chromium import Chromium, there_is_chromium

SPEC = {"name": "web", "label": "Two layouts & <b>markup</b>", "base": {"scene": "builtin:layers", "size": "128x72", "lights": 4},
        "permute": [{"layout": ["exact", "compact"], "normal.encoding": ["oct8", "oct16", "xy-sqrt"]},
                    {"lights.source": ["rig"], "lights.rig": ["nothere.json"]}],
        "x": "bytes_per_pixel", "y": "rmse_linear", "family": "layout"}

DOTS = "[...document.querySelectorAll('figure .drawing > svg .dot')]"


def middle_of(b, selector):
    return b.js(f"(() => {{ const r = document.querySelector({json.dumps(selector)}).getBoundingClientRect();"
                " return [r.x + r.width / 2, r.y + r.height / 2]; })()")


def use(b, shot):
    rows = b.js("document.querySelectorAll('#rows tbody tr').length")
    dots = b.js(DOTS + ".length")
    check(rows > 0 and dots > 0, f"{rows} rows and {dots} dots are there")
    check(b.js("document.documentElement.classList.contains('script')"), "the script runs")
    check(b.js("document.querySelectorAll('b').length") == b.js("document.querySelectorAll('tr.marked b').length"), "no text became markup")

    x, y = middle_of(b, "figure .drawing > svg .dot path")
    b.mouse(x, y)
    words = b.js("document.querySelector('#tip').hidden ? '' : document.querySelector('#tip').textContent")
    check("error:" in words and "cost:" in words, "a dot under the mouse says its error and its cost: " + words.replace("\n", " | ")[:120])
    check(b.js("[...document.querySelectorAll('#tip img')].every(i => i.complete && i.naturalWidth > 0)") and
          b.js("document.querySelectorAll('#tip img').length") == 2, "and shows its picture and its error map")
    shot("hover")
    b.mouse(1, 1)
    check(b.js("document.querySelector('#tip').hidden"), "away from it the words go")

    b.js("document.querySelector('figure .drawing > svg').focus()")
    b.key("ArrowRight")
    first = b.js("document.querySelector('#tip').textContent")
    b.key("ArrowUp")
    b.key("ArrowRight")
    check(first and b.js("!document.querySelector('#tip').hidden"), "the arrow keys reach dots")
    b.key("Enter")
    check(b.js("document.querySelectorAll('tr.picked').length") == 1, "Enter picks the dot's row")
    b.key("Escape")
    check(b.js("document.querySelector('#tip').hidden"), "Esc closes the words")

    b.js("document.querySelector('tr:not(.picked) [data-pick]').click()")
    check(b.js("!document.querySelector('#compared').hidden"), "two rows are compared")
    check(b.js("document.querySelectorAll('#compared img').length") >= 2, "with their pictures")
    check(b.js("document.querySelectorAll('#compared tr.differs').length") > 0, "and what differs is marked")

    place = DOTS + "[0].getAttribute('transform')"
    before = b.js(place)
    b.js("document.querySelector('input[data-log=x]').click()")
    check(b.js(place) != before, "the axis switches between logarithmic and linear")
    b.js("document.querySelector('input[data-log=x]').click()")
    check(b.js(place) == before, "and back")

    seen = DOTS + ".filter(d => getComputedStyle(d).display !== 'none').length"
    all_seen = b.js(seen)
    b.js("document.querySelector('input[data-family]').click()")
    check(b.js(seen) < all_seen, "a family can be switched off")
    b.js("document.querySelector('input[data-family]').click()")
    b.js("document.querySelector('input[data-front]').click()")
    check(b.js("getComputedStyle(document.querySelector('polyline.front')).display") == "none", "the front can be switched off")
    b.js("document.querySelector('input[data-front]').click()")

    b.js("{ const f = document.querySelector('#filter'); f.value = 'no such words'; f.dispatchEvent(new Event('input')); }")
    check(b.js("document.querySelector('#count').textContent") == f"0 of {rows} rows", "a filter that nothing fits leaves nothing")
    word = b.js("document.querySelector('#rows tbody th').textContent.split(' ').pop()")
    b.js(f"{{ const f = document.querySelector('#filter'); f.value = {json.dumps(word)}; f.dispatchEvent(new Event('input')); }}")
    left = b.js("[...document.querySelectorAll('#rows tbody tr')].filter(r => !r.hidden).length")
    check(0 < left <= rows, f"'{word}' leaves {left} rows")
    b.js("{ const f = document.querySelector('#filter'); f.value = ''; f.dispatchEvent(new Event('input')); }")

    b.js("[...document.querySelectorAll('#rows thead th button')][2].click()")
    numbers = b.js("[...document.querySelectorAll('#rows tbody tr')].map(r => r.cells[4].dataset.n).filter(n => n !== undefined).map(Number)")
    check(numbers == sorted(numbers) and len(numbers) > 0, "a column sorts by number")
    b.js("[...document.querySelectorAll('#rows thead th button')][2].click()")
    numbers = b.js("[...document.querySelectorAll('#rows tbody tr')].map(r => r.cells[4].dataset.n).filter(n => n !== undefined).map(Number)")
    check(numbers == sorted(numbers, reverse=True), "and the other way round")

    b.js("navigator.clipboard.writeText = async (text) => { window.copied = text; }")
    b.js("document.querySelector('[data-copy]').click()")
    check((b.js("window.copied") or "").startswith("gbufferlab bench"), "a row's command can be copied")
    b.js("document.querySelector('#compared').scrollIntoView()")
    shot("compared")
    b.js("scrollTo(0, 0)")
    b.ask("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "dark"}])
    check(b.js("getComputedStyle(document.body).backgroundColor") != "rgb(255, 255, 255)", "it is dark where that is wished")
    shot("dark")
    check(b.complaints == [], "the browser has nothing to complain of: " + "; ".join(b.complaints))


def without_script(b, url, shot):
    b.ask("Emulation.setScriptExecutionDisabled", value=True)
    b.ask("Emulation.setEmulatedMedia", media="", features=[])
    b.ask("Page.navigate", url=url)
    while b.js("document.readyState") != "complete" or not b.js("location.href").startswith("file:"):
        time.sleep(0.05)
    check(not b.js("document.documentElement.classList.contains('script')"), "without its script")
    check(b.js("document.querySelectorAll('#rows tbody tr').length") > 0 and b.js(DOTS + ".length") > 0, "chart and table are there")
    check(b.js("[...document.querySelectorAll('.js')].every(e => getComputedStyle(e).display === 'none')"), "and no control that would do nothing")
    shot("without-script")
    b.ask("Emulation.setScriptExecutionDisabled", value=False)


def small_study(program, folder):
    spec = folder / "spec-in.json"
    spec.write_text(json.dumps(SPEC))
    result = subprocess.run([program, "study", spec, "-o", folder / "out"], capture_output=True, text=True)
    if result.returncode != 1:  # one of its rows fails, and is to
        sys.exit(f"the study did not end as it should: {result.returncode} {result.stderr}")
    return folder / "out/study.html"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--page", type=pathlib.Path)
    parser.add_argument("--shots", type=pathlib.Path)
    asked = parser.parse_args()
    if not there_is_chromium():
        return 77
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        page = asked.page or small_study(asked.program.resolve(), folder)
        if asked.shots:
            asked.shots.mkdir(parents=True, exist_ok=True)
        browser = Chromium(folder / "profile", (1500, 1000))

        def shot(name):
            if asked.shots:
                browser.shot(asked.shots / (name + ".png"))

        try:
            browser.open(page.resolve().as_uri())
            use(browser, shot)
            without_script(browser, page.resolve().as_uri(), shot)
        finally:
            browser.close()
    print(f"{len(failures)} checks failed" if failures else "all checks hold")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
