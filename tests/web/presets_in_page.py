"""Each preset's picture in the page against the program's."""
import base64
import json
import subprocess

from checks import check
from page import open_page, press, words

FILE_IN_BASE64 = """window.fileInBase64 = path => {
  lab.FS.ignorePermissions = true;
  return btoa([...lab.FS.readFile(path)].map(x => String.fromCharCode(x)).join(''));
}"""


def pixels(file, size):
    """Rows of RGB bytes, of the upper left part of this size."""
    out = subprocess.run(["convert", file, "-crop", f"{size[0]}x{size[1]}+0+0", "+repage", "-depth", "8", "rgb:-"], check=True, capture_output=True)
    return [out.stdout[3 * size[0] * y:3 * size[0] * (y + 1)] for y in range(size[1])]


TITLE = (220, 24)  # pixels of the panel's name, and its frame
FRAME = 3


def differing(a, b, size, tolerance):
    """Pixels that are more codes of 255 apart in any channel; the panel's name and frame are left out."""
    count = 0
    for y in range(FRAME, size[1] - FRAME):
        begin = TITLE[0] if y < TITLE[1] else FRAME
        rows = [r[y][3 * begin:3 * (size[0] - FRAME)] for r in (a, b)]
        if rows[0] != rows[1]:
            apart = [abs(x - y) > tolerance for x, y in zip(*rows)]
            count += sum(any(apart[i:i + 3]) for i in range(0, len(apart), 3))
    return count


def compare(b, page, folder, program, only=None):
    """What F12 saves of each preset, against what the program draws from the settings in that very file."""
    size = (640, 360)
    for preset in json.loads(subprocess.run([program, "list", "presets", "--json"], check=True, capture_output=True).stdout):
        if only and preset["id"] not in only:
            continue
        open_page(b, f"{page}?preset={preset['id']}")
        if preset["id"] in b.lacks:
            check("stands in for" in words(b), f"what this browser lacks gives way, and is named: {words(b)[-120:]!r}")
        b.js("canvas.focus()")
        press(b, "F12")
        b.js(FILE_IN_BASE64)
        figure = folder / f"{preset['id']}.png"
        figure.write_bytes(base64.b64decode(b.js("fileInBase64('/out/' + document.body.dataset.saved)")))
        native = folder / preset["id"]
        subprocess.run([program, "render", "--gl", "es3", "--state", figure, "--only", "final", "-o", native], check=True, capture_output=True)
        off = differing(pixels(figure, size), pixels(native / "final.png", size), size, b.tolerance)
        share = off / (size[0] * size[1])
        check(share <= b.most, f"{preset['id']}: {share:.3%} of the pixels are more than {b.tolerance} codes off the program's")
