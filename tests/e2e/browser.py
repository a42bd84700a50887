"""Opens a page in headless Chromium, says as JSON what is in it, and keeps pictures of it.

    browser.py PAGE EXPRESSION [--width 794] [--dark] [--picture F.png] [--print F.pdf]

Speaks the DevTools protocol over a pipe: Chromium reads from descriptor 3 and writes to 4. Output:
{"requests": [URL..], "messages": [text of errors and warnings..], "value": what the JavaScript gives}.
"""

import argparse
import base64
import json
import os
import pathlib
import subprocess
import sys
import tempfile


class Browser:
    def __init__(self, profile, more="--disable-gpu"):
        to_child, self.commands = os.pipe()
        self.answers, from_child = os.pipe()
        # Both ends are put where Chromium looks for them.
        script = f"exec 3<&{to_child} 4>&{from_child}; exec chromium --headless=new --no-sandbox " \
                 f"{more} --hide-scrollbars --disable-dev-shm-usage --remote-debugging-pipe --no-first-run " \
                 f"--disable-background-networking --mute-audio --user-data-dir={profile} about:blank"
        self.process = subprocess.Popen(["bash", "-c", script], pass_fds=(to_child, from_child),
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_child)
        os.close(from_child)
        self.rest = b""
        self.number = 0
        self.session = None
        self.events = []

    def read(self):
        while b"\0" not in self.rest:
            piece = os.read(self.answers, 1 << 16)
            if not piece:
                sys.exit("chromium ended early")
            self.rest += piece
        message, self.rest = self.rest.split(b"\0", 1)
        return json.loads(message)

    def ask(self, method, **params):
        self.number += 1
        message = {"id": self.number, "method": method, "params": params}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.commands, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.read()
            if answer.get("id") == self.number:
                if "error" in answer:
                    sys.exit(f"{method}: {answer['error']}")
                return answer["result"]
            self.events.append(answer)

    def open_tab(self):
        """Whatever is asked from then on is asked of it."""
        target = self.ask("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]

    def wait_for(self, event):
        while not any(one.get("method") == event for one in self.events):
            self.events.append(self.read())

    def all_of(self, event):
        return [one["params"] for one in self.events if one.get("method") == event]


def open_page(browser, args):
    browser.open_tab()
    for domain in ("Page", "Network", "Log", "Runtime"):
        browser.ask(domain + ".enable")
    browser.ask("Emulation.setDeviceMetricsOverride", width=args.width, height=1100, deviceScaleFactor=1,
                mobile=False)
    theme = "dark" if args.dark else "light"
    browser.ask("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": theme}])
    browser.events.clear()
    went = browser.ask("Page.navigate", url=pathlib.Path(args.page).resolve(strict=True).as_uri())
    if "errorText" in went:
        sys.exit(f"{args.page}: {went['errorText']}")
    browser.wait_for("Page.loadEventFired")


def messages_of(browser):
    logged = [one["entry"]["text"] for one in browser.all_of("Log.entryAdded")]
    thrown = [one["exceptionDetails"]["text"] for one in browser.all_of("Runtime.exceptionThrown")]
    said = [str(one["args"]) for one in browser.all_of("Runtime.consoleAPICalled")]
    return logged + thrown + said


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("page")
    parser.add_argument("expression")
    parser.add_argument("--width", type=int, default=794)
    parser.add_argument("--dark", action="store_true")
    parser.add_argument("--picture")
    parser.add_argument("--print", dest="paper")
    args = parser.parse_args()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        browser = Browser(profile)
        open_page(browser, args)
        found = browser.ask("Runtime.evaluate", expression=args.expression, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in found:
            sys.exit(json.dumps(found["exceptionDetails"]))
        if args.picture:
            shot = browser.ask("Page.captureScreenshot", captureBeyondViewport=True,
                               clip={"x": 0, "y": 0, "width": args.width, "scale": 1, "height": browser.ask(
                                   "Page.getLayoutMetrics")["cssContentSize"]["height"]})
            pathlib.Path(args.picture).write_bytes(base64.b64decode(shot["data"]))
        if args.paper:
            paper = browser.ask("Page.printToPDF", preferCSSPageSize=True, printBackground=True)
            pathlib.Path(args.paper).write_bytes(base64.b64decode(paper["data"]))
        requests = [one["request"]["url"][:80] for one in browser.all_of("Network.requestWillBeSent")]
        print(json.dumps({"requests": requests, "messages": messages_of(browser), "value": found["result"]["value"]}))
        browser.process.terminate()
        browser.process.wait()


if __name__ == "__main__":
    main()
