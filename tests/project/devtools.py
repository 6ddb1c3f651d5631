"""Chromium, spoken to by the DevTools protocol."""
import base64, contextlib, json, os, shutil, socket, struct, subprocess, sys, tempfile, time, urllib.request


def wait(holds, what):
    for _ in range(3000):
        if holds(): return
        time.sleep(0.02)
    sys.exit(f"after a minute there is no {what}")


class Page:
    """A tab of a browser, spoken to by the DevTools protocol."""

    def __init__(self, port, prelude=""):
        tab = json.load(urllib.request.urlopen(
            urllib.request.Request(f"http://127.0.0.1:{port}/json/new?about:blank", method="PUT")))
        path = tab["webSocketDebuggerUrl"].split("/", 3)[3]
        self.socket, self.count, self.complaints, self.prelude = socket.create_connection(("127.0.0.1", port)), 0, [], prelude
        self.stream = self.socket.makefile("rb")
        self.socket.sendall(f"GET /{path} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                            f"Sec-WebSocket-Key: {base64.b64encode(os.urandom(16)).decode()}\r\n"
                            "Sec-WebSocket-Version: 13\r\n\r\n".encode())
        while self.stream.readline() not in (b"\r\n", b""): pass
        for domain in ("Page", "Runtime"): self.call(domain + ".enable")

    def message(self):
        text = b""
        while True:
            first, length = self.stream.read(2)
            if length == 126: length = struct.unpack(">H", self.stream.read(2))[0]
            elif length == 127: length = struct.unpack(">Q", self.stream.read(8))[0]
            text += self.stream.read(length)
            if first & 0x80: return json.loads(text)

    def call(self, method, **parameters):
        self.count += 1
        text = json.dumps({"id": self.count, "method": method, "params": parameters}).encode()
        length = struct.pack(">BH", 0xfe, len(text)) if len(text) < 1 << 16 else struct.pack(">BQ", 0xff, len(text))
        self.socket.sendall(b"\x81" + length + bytes(4) + text)  # masked by zeros
        while (reply := self.message()).get("id") != self.count:
            if reply.get("method") == "Runtime.exceptionThrown" or reply.get("params", {}).get("type") == "error":
                self.complaints.append(reply["params"])
        return reply["result"]

    def value(self, script):
        reply = self.call("Runtime.evaluate", expression="(async () => {" + self.prelude + script + "})()", awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in reply: raise RuntimeError(str(reply["exceptionDetails"])[:500])
        return reply["result"].get("value")


def check(holds, what):
    if not holds: sys.exit(what)


def press(page, key, code):
    for kind in ("rawKeyDown", "keyUp"):
        page.call("Input.dispatchKeyEvent", type=kind, key=key, code=key, windowsVirtualKeyCode=code)


@contextlib.contextmanager
def chromium():
    """The port of a browser of its own; where there is none, the test is skipped."""
    program = shutil.which("chromium")
    if not program:
        print("skipped: there is no chromium")
        sys.exit(77)
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as home:
        browser = subprocess.Popen([program, "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
                                    "--disable-background-networking", "--disable-component-update", "--disable-sync",
                                    "--remote-debugging-port=0", "--user-data-dir=" + home], env={**os.environ, "HOME": home}, stderr=subprocess.DEVNULL)
        try:
            port = os.path.join(home, "DevToolsActivePort")
            wait(lambda: os.path.exists(port) and open(port).read().count("\n"), "browser")
            yield int(open(port).read().split()[0])
        finally:
            browser.kill()
            browser.wait()
