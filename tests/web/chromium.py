"""Chromium without a window, by its debugging pipe: JSON messages that end with a zero byte."""
import base64
import json
import os
import pathlib
import shutil
import subprocess

# Mesa's driver by way of ANGLE: four times as fast as Chromium's own on a CPU.
MESA = ["--use-gl=angle", "--use-angle=gl-egl", "--ignore-gpu-blocklist"]
SWIFTSHADER = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]

NUMBERS = {"Tab": 9, "Enter": 13, "Escape": 27, " ": 32, "PageDown": 34, "End": 35, "ArrowUp": 38, "ArrowRight": 39,
           "F1": 112, "F3": 114, "F12": 123, "/": 191}
CODES = {" ": "Space", "/": "Slash"}


def named(key):
    """A key as the protocol has it."""
    code = "Key" + key.upper() if key.isalpha() and len(key) == 1 else "Digit" + key if key.isdigit() else CODES.get(key, key)
    return {"key": key, "code": code, "windowsVirtualKeyCode": NUMBERS.get(key) or ord(key.upper())}


class Chromium:
    name = "Chromium"
    lacks = ()  # presets
    tolerance, most = 0, 0.0  # of its pictures against the program's: codes, and in which share of the pixels more

    def __init__(self, folder, size, *flags):
        """A profile is kept in the folder. Without flags it draws no WebGL."""
        to_read, self.to = os.pipe()
        self.of, to_write = os.pipe()
        # Chromium reads its file 3 and writes its file 4.
        self.process = subprocess.Popen(
            ["/bin/sh", "-c", f'exec "$0" "$@" 3<&{to_read} 4>&{to_write}', path_of_chromium(), "--headless", "--no-sandbox", *(flags or ["--disable-gpu"]),
             "--remote-debugging-pipe", "--hide-scrollbars", f"--user-data-dir={folder}", "about:blank"],
            pass_fds=(to_read, to_write), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_read)
        os.close(to_write)
        self.pending = b""
        self.next_id = 0
        self.session = None
        self.complaints = []
        self.own = ("file:", "data:", "about:")  # what a page may ask for
        self.size = size
        self.ask("Browser.setDownloadBehavior", behavior="allow", downloadPath=str(folder / "downloads"))
        self.target = self.ask("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.ask("Target.attachToTarget", targetId=self.target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.ask(domain + ".enable")
        self.screen(size, 1)

    def message(self):
        while b"\0" not in self.pending:
            block = os.read(self.of, 1 << 16)
            if not block:
                raise RuntimeError("Chromium has ended")
            self.pending += block
        line, self.pending = self.pending.split(b"\0", 1)
        return json.loads(line)

    def ask(self, method, **params):
        self.next_id += 1
        question = {"id": self.next_id, "method": method, "params": params}
        if self.session:
            question["sessionId"] = self.session
        os.write(self.to, json.dumps(question).encode() + b"\0")
        while True:
            answer = self.message()
            self.note(answer)
            if answer.get("id") == self.next_id:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]

    def ask_browser(self, method, **params):
        """Of the browser and not of its page."""
        page, self.session = self.session, None
        try:
            return self.ask(method, **params)
        finally:
            self.session = page

    def note(self, m):
        if m.get("method") == "Runtime.exceptionThrown":
            self.complaints.append(json.dumps(m["params"]["exceptionDetails"])[:400])
        if m.get("method") == "Log.entryAdded" and m["params"]["entry"]["level"] == "error":
            self.complaints.append(m["params"]["entry"]["text"])
        if m.get("method") == "Network.requestWillBeSent":
            url = m["params"]["request"]["url"]
            if not url.startswith(self.own):
                self.complaints.append("asked the network for " + url)

    def js(self, expression):
        result = self.ask("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in result:
            raise RuntimeError(f"{expression}: {result['exceptionDetails']}")
        return result["result"].get("value")

    def open(self, url):
        self.ask("Page.navigate", url=url)
        self.js("new Promise(done => document.readyState === 'complete' ? done() : addEventListener('load', done))")

    def screen(self, size, device_pixels):
        """So many pixels of a page, each of so many of the device, and of the kind that is touched where it is fine."""
        self.ask("Emulation.setDeviceMetricsOverride", width=size[0], height=size[1], deviceScaleFactor=device_pixels, mobile=device_pixels > 1)

    def mouse(self, x, y, kind="mouseMoved"):
        button = {} if kind == "mouseMoved" else {"button": "left", "clickCount": 1}
        self.ask("Input.dispatchMouseEvent", type=kind, x=x, y=y, **button)

    def wheel(self, x, y, pixels):
        self.ask("Input.dispatchMouseEvent", type="mouseWheel", x=x, y=y, deltaX=0, deltaY=pixels)

    def touch(self, kind, *points):
        """kind: touchStart, touchMove, touchEnd; the points of all fingers that are down."""
        self.ask("Input.dispatchTouchEvent", type=kind, touchPoints=[{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(points)])

    def key(self, key, control=False):
        held = {"modifiers": 2} if control else {}
        if control:
            self.ask("Input.dispatchKeyEvent", type="keyDown", key="Control", code="ControlLeft", windowsVirtualKeyCode=17, **held)
        text = {"text": key} if len(key) == 1 and not control else {}
        self.ask("Input.dispatchKeyEvent", type="keyDown", **named(key), **text, **held)
        self.ask("Input.dispatchKeyEvent", type="keyUp", **named(key), **held)
        if control:
            self.ask("Input.dispatchKeyEvent", type="keyUp", key="Control", code="ControlLeft", windowsVirtualKeyCode=17)

    def drop(self, x, y, *files):
        data = {"items": [], "files": [str(f) for f in files], "dragOperationsMask": 1}
        for kind in ("dragEnter", "dragOver", "drop"):
            self.ask("Input.dispatchDragEvent", type=kind, x=x, y=y, data=data)

    def cover(self):
        """By another tab."""
        self.other = self.ask_browser("Target.createTarget", url="about:blank")["targetId"]
        self.ask_browser("Target.activateTarget", targetId=self.other)

    def uncover(self):
        self.ask_browser("Target.closeTarget", targetId=self.other)
        self.ask_browser("Target.activateTarget", targetId=self.target)

    def picture(self, x=0, y=0, size=None):
        """PNG."""
        w, h = size or self.size
        shot = self.ask("Page.captureScreenshot", format="png", clip={"x": x, "y": y, "width": w, "height": h, "scale": 1})
        return base64.b64decode(shot["data"])

    def shot(self, file):
        shot = self.ask("Page.captureScreenshot", format="png")
        pathlib.Path(file).write_bytes(base64.b64decode(shot["data"]))

    def close(self):
        try:
            self.ask("Browser.close")
        except (RuntimeError, OSError):
            pass
        self.process.wait(20)


def path_of_chromium():
    return shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")


def there_is_chromium():
    """If not, says so."""
    if not path_of_chromium():
        print("skipped: there is no Chromium here; install the package chromium")
    return bool(path_of_chromium())
