"""Firefox in a display of its own, by Marionette: a socket of JSON messages with their length before them."""
import base64
import json
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import time

CONTROL = "\ue009"
KEYS = {"Tab": "\ue004", "Enter": "\ue006", "Escape": "\ue00c", "PageDown": "\ue00f", "End": "\ue010", "ArrowUp": "\ue013", "ArrowRight": "\ue014",
        "F1": "\ue031", "F3": "\ue033", "F12": "\ue03c"}  # as WebDriver (W3C 2018, Keyboard Actions) has them
START_S = 60


class Firefox:
    name = "Firefox"
    lacks = ("exact", "compact")  # presets: depth that runs from 1 to 0 needs EXT_clip_control
    # Of its pictures against the program's: codes, and in which share of the pixels more. All presets but stereo's two are the
    # same to the bit. Those march a height map, which makes a step of a rounding: .009 % were measured.
    tolerance, most = 2, 0.0005

    def __init__(self, folder, size):
        """A profile is kept in the folder."""
        folder.mkdir(parents=True)
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        preferences = {
            "marionette.port": port,
            "webgl.force-enabled": True,            # on a CPU as well
            "dom.w3c_touch_events.enabled": 1,      # without a screen that can be touched
            "devtools.console.stdout.content": True,
            "browser.download.folderList": 2,       # what is saved goes where the next line says
            "browser.download.dir": str(folder / "downloads"),
        }
        (folder / "user.js").write_text("".join(f"user_pref({json.dumps(k)}, {json.dumps(v)});\n" for k, v in preferences.items()))
        self.log = folder / "log.txt"
        with self.log.open("w") as log:
            self.process = subprocess.Popen(
                ["xvfb-run", "-a", "-s", f"-screen 0 {size[0] + 200}x{size[1] + 300}x24", path_of_firefox(), "--marionette", "--remote-allow-system-access",
                 "--no-remote", "--profile", str(folder), "about:blank"], stdout=log, stderr=subprocess.STDOUT, start_new_session=True)
        self.socket = self.connected(port)
        self.pending = b""
        self.next_id = 0
        self.own = ()
        self.message()  # who it is
        self.ask("WebDriver:NewSession", capabilities={})
        self.ask("WebDriver:SetTimeouts", script=300000, pageLoad=60000)
        self.size = size
        self.screen(size, 1)

    def connected(self, port):
        begin = time.monotonic()
        while True:
            try:
                return socket.create_connection(("127.0.0.1", port))
            except OSError:
                if time.monotonic() - begin > START_S or self.process.poll() is not None:
                    raise RuntimeError("Firefox does not start: " + self.log.read_text()[-400:])
                time.sleep(0.1)

    def message(self):
        while b":" not in self.pending or len(self.pending) < self.pending.index(b":") + 1 + int(self.pending.partition(b":")[0]):
            block = self.socket.recv(1 << 20)
            if not block:
                raise RuntimeError("Firefox has ended")
            self.pending += block
        length, _, rest = self.pending.partition(b":")
        self.pending = rest[int(length):]
        return json.loads(rest[:int(length)])

    def ask(self, command, **params):
        self.next_id += 1
        question = json.dumps([0, self.next_id, command, params]).encode()
        self.socket.sendall(str(len(question)).encode() + b":" + question)
        _, _, error, result = self.message()
        if error:
            raise RuntimeError(f"{command}: {error['error']}: {error['message']}")
        return result["value"] if isinstance(result, dict) and set(result) == {"value"} else result

    def act(self, kind, name, *actions, **more):
        self.ask("WebDriver:PerformActions", actions=[{"type": kind, "id": name, "actions": list(actions), **more}])

    @property
    def complaints(self):
        """Of the page: Firefox's own scripts complain as well, where there is no network."""
        own = ("RSLoader", "resource:", "chrome:")
        return [line for line in self.log.read_text(errors="replace").splitlines()
                if line.startswith(("console.error: ", "JavaScript error: ")) and not any(name in line for name in own)]

    def js(self, expression):
        script = "const [text, done] = arguments; Promise.resolve().then(() => window.eval(text)).then(v => done({value: v}), e => done({error: String(e)}));"
        result = self.ask("WebDriver:ExecuteAsyncScript", script=script, args=[expression], sandbox=None)
        if "error" in result:
            raise RuntimeError(f"{expression}: {result['error']}")
        return result.get("value")

    def open(self, url):
        self.ask("WebDriver:Navigate", url=url)

    def of_browser(self, script):
        self.ask("Marionette:SetContext", value="chrome")
        try:
            self.ask("WebDriver:ExecuteScript", script=script, args=[])
        finally:
            self.ask("Marionette:SetContext", value="content")

    def screen(self, size, device_pixels):
        """So many pixels of a page, each of so many of the device."""
        self.of_browser(f"Services.prefs.setStringPref('layout.css.devPixelsPerPx', '{device_pixels}')")
        for _ in range(5):  # what lies around the page has a size of its own
            inner = self.js("[innerWidth, innerHeight]")
            if inner == list(size):
                return
            outer = self.ask("WebDriver:GetWindowRect")
            self.ask("WebDriver:SetWindowRect", width=outer["width"] + size[0] - inner[0], height=outer["height"] + size[1] - inner[1])
            time.sleep(0.3)
        raise RuntimeError(f"a page of {size} cannot be had: {inner}")

    def mouse(self, x, y, kind="mouseMoved"):
        action = {"mousePressed": {"type": "pointerDown", "button": 0}, "mouseReleased": {"type": "pointerUp", "button": 0},
                  "mouseMoved": {"type": "pointerMove", "duration": 0, "x": round(x), "y": round(y)}}[kind]
        self.act("pointer", "mouse", action, parameters={"pointerType": "mouse"})

    def wheel(self, x, y, pixels):
        self.act("wheel", "wheel", {"type": "scroll", "x": x, "y": y, "deltaX": 0, "deltaY": pixels, "duration": 0})

    def touch(self, kind, *points):
        """kind: touchStart, touchMove, touchEnd; the points of all fingers that are down."""
        def place(point):
            return {"type": "pointerMove", "duration": 0, "x": round(point[0]), "y": round(point[1])}
        if kind == "touchEnd":
            fingers = [[{"type": "pointerUp", "button": 0}] for _ in range(self.fingers)]
        else:
            fingers = [[place(p)] + ([{"type": "pointerDown", "button": 0}] if kind == "touchStart" else []) for p in points]
            self.fingers = len(points)
        self.ask("WebDriver:PerformActions", actions=[
            {"type": "pointer", "id": f"finger {i}", "parameters": {"pointerType": "touch"}, "actions": actions} for i, actions in enumerate(fingers)])

    def key(self, key, control=False):
        value = KEYS.get(key, key)
        down, up = {"type": "keyDown", "value": value}, {"type": "keyUp", "value": value}
        held = ({"type": "keyDown", "value": CONTROL}, {"type": "keyUp", "value": CONTROL}) if control else ()
        self.act("key", "keyboard", *held[:1], down, up, *held[1:])

    def drop(self, x, y, *files):
        data = [[f.name, base64.b64encode(f.read_bytes()).decode()] for f in files]
        self.js(f"""{{
          const data = new DataTransfer();
          for (const [name, bytes] of {json.dumps(data)}) data.items.add(new File([Uint8Array.from(atob(bytes), c => c.charCodeAt(0))], name));
          for (const kind of ['dragenter', 'dragover', 'drop'])
            canvas.dispatchEvent(new DragEvent(kind, {{dataTransfer: data, clientX: {x}, clientY: {y}, bubbles: true, cancelable: true}}));
          0;
        }}""")

    def cover(self):
        """By another tab. The page can still be asked."""
        self.other = self.ask("WebDriver:NewWindow", type="tab", focus=True)["handle"]

    def uncover(self):
        own = self.ask("WebDriver:GetWindowHandle")
        self.ask("WebDriver:SwitchToWindow", handle=self.other, focus=False)
        self.ask("WebDriver:CloseWindow")
        self.ask("WebDriver:SwitchToWindow", handle=own, focus=True)

    def picture(self, x=0, y=0, size=None):
        """Rows of RGB bytes."""
        w, h = size or self.size
        png = base64.b64decode(self.ask("WebDriver:TakeScreenshot", full=False))
        return subprocess.run(["convert", "png:-", "-crop", f"{w}x{h}+{x}+{y}", "+repage", "-depth", "8", "rgb:-"], input=png, check=True, capture_output=True).stdout

    def shot(self, file):
        pathlib.Path(file).write_bytes(base64.b64decode(self.ask("WebDriver:TakeScreenshot", full=False)))

    def close(self):
        try:
            self.ask("Marionette:Quit", flags=["eForceQuit"])
        except (RuntimeError, OSError):
            pass
        try:
            self.process.wait(20)
        except subprocess.TimeoutExpired:
            os.killpg(self.process.pid, signal.SIGTERM)


def path_of_firefox():
    return shutil.which("firefox-esr") or shutil.which("firefox")


def there_is_firefox():
    """If not, says so."""
    if not path_of_firefox():
        print("skipped: there is no Firefox here; install the package firefox-esr")
    return bool(path_of_firefox())
