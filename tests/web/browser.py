"""Chromium without a window, for tests of pages; and what a test says."""
import base64
import json
import os
import pathlib
import shutil
import subprocess


class Browser:
    """Chromium by its debugging pipe: JSON messages that end with a zero byte."""

    def __init__(self, chromium, profile, *flags):
        to_read, self.to = os.pipe()
        self.of, to_write = os.pipe()
        # Chromium reads its file 3 and writes its file 4.
        self.process = subprocess.Popen(
            ["/bin/sh", "-c", f'exec "$0" "$@" 3<&{to_read} 4>&{to_write}', chromium, "--headless", "--no-sandbox", *(flags or ["--disable-gpu"]),
             "--remote-debugging-pipe", "--hide-scrollbars", f"--user-data-dir={profile}", "about:blank"],
            pass_fds=(to_read, to_write), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_read)
        os.close(to_write)
        self.pending = b""
        self.next_id = 0
        self.session = None
        self.complaints = []
        self.own = ("file:", "data:", "about:")  # what a page may ask for
        self.target = self.ask("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.ask("Target.attachToTarget", targetId=self.target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.ask(domain + ".enable")

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

    def mouse(self, x, y, kind="mouseMoved"):
        button = {} if kind == "mouseMoved" else {"button": "left", "clickCount": 1}
        self.ask("Input.dispatchMouseEvent", type=kind, x=x, y=y, **button)

    def key(self, key, text=""):
        for kind in ("keyDown", "keyUp"):
            self.ask("Input.dispatchKeyEvent", type=kind, key=key, code=key,
                     windowsVirtualKeyCode={"Tab": 9, "Enter": 13, "Escape": 27}.get(key, 0), **({"text": text} if text and kind == "keyDown" else {}))

    def shot(self, file):
        picture = self.ask("Page.captureScreenshot", format="png")
        pathlib.Path(file).write_bytes(base64.b64decode(picture["data"]))

    def close(self):
        try:
            self.ask("Browser.close")
        except (RuntimeError, OSError):
            pass
        self.process.wait(20)


def find_chromium():
    """Its path; none, and says so."""
    chromium = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if not chromium:
        print("skipped: there is no Chromium here; install the package chromium")
    return chromium


failures = []


def check(holds, what):
    print(("ok      " if holds else "FAILED  ") + what)
    if not holds:
        failures.append(what)
