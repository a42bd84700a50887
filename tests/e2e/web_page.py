"""Opens the window in a page (app/web), in headless Chromium, and holds what a person would see of it.

    web_page.py FOLDER [--headers] [--width 1280] [--height 800] [--picture F.png]

FOLDER is build/web/page; with --headers the server sets the page apart as threads need it, otherwise
the service worker of the page does. Prints how long the first view took.
"""

import argparse
import base64
import functools
import http.server
import json
import pathlib
import sys
import tempfile
import threading
import time

from browser import Browser


class Server(http.server.SimpleHTTPRequestHandler):
    headers_too = False

    def end_headers(self):
        if self.headers_too:
            self.send_header("Cross-Origin-Opener-Policy", "same-origin")
            self.send_header("Cross-Origin-Embedder-Policy", "require-corp")
        super().end_headers()

    def log_message(self, *_):
        pass


def serve(folder, headers):
    kind = type("Kind", (Server,), {"headers_too": headers})
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(kind, directory=folder))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return f"http://127.0.0.1:{server.server_port}"


class Page:
    def __init__(self, browser, width, height):
        self.browser = browser
        target = browser.ask("Target.createTarget", url="about:blank")["targetId"]
        browser.session = browser.ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Log", "Runtime"):
            browser.ask(domain + ".enable")
        browser.ask("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    def value(self, expression):
        found = self.browser.ask("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        return found["result"].get("value")

    def until(self, expression, what, seconds=600.0):
        """Waits for a condition; the clock only ends a page that never comes to it."""
        end = time.monotonic() + seconds
        while not self.value(expression):
            if time.monotonic() > end:
                sys.exit(f"{what}: did not happen; the page says {self.value('said.textContent')!r}, " +
                         f"its title is {self.value('document.title')!r}; {json.dumps(self.messages())[:3000]}")
            time.sleep(0.1)

    def messages(self):
        logged = [one["entry"]["text"] for one in self.browser.all_of("Log.entryAdded")]
        thrown = [str(one["exceptionDetails"].get("exception", {}).get("description")) for one in
                  self.browser.all_of("Runtime.exceptionThrown")]
        said = [str([a.get("value") for a in one["args"]]) for one in
                self.browser.all_of("Runtime.consoleAPICalled")]
        return logged + thrown + said

    def widgets(self):
        """What is on the screen, by name: its rectangle and its value."""
        lines = self.value("FS.analyzePath('/tmp/widgets').exists ? FS.readFile('/tmp/widgets', {encoding: 'utf8'}) : ''")
        found = {}
        for line in lines.splitlines():
            name, left, top, right, bottom, value = line.split("\t")
            found[name] = (int(left), int(top), int(right), int(bottom), value)
        return found

    def until_widget(self, name, wanted, what, seconds=600.0):
        end = time.monotonic() + seconds
        while True:
            widget = self.widgets().get(name)
            if widget and wanted(widget[4]):
                return widget
            if time.monotonic() > end:
                sys.exit(f"{what}: did not happen; {name} is {widget}; {json.dumps(self.messages())[:3000]}")
            time.sleep(0.05)

    def mouse(self, kind, x, y):
        self.browser.ask("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1,
                         buttons=0 if kind == "mouseReleased" else 1)

    def picture(self, path):
        shot = self.browser.ask("Page.captureScreenshot")
        pathlib.Path(path).write_bytes(base64.b64decode(shot["data"]))


def edit(page):
    """A slider is dragged: the map follows, says that it is a preview, and is exact again."""
    title = "title:Perceptual space"
    page.until_widget(title, lambda value: value.startswith("exact"), "an exact map")
    cell = page.widgets()["matrix selected"][4]
    left, top, right, bottom, before = page.widgets()["slider:modulation_hz"]
    page.mouse("mousePressed", left + 8, (top + bottom) // 2)
    for step in range(1, 6):
        page.mouse("mouseMoved", left + 8 + step * (right - left - 16) // 8, (top + bottom) // 2)
    began = time.monotonic()
    page.until_widget("slider:modulation_hz", lambda value: value != before, "the slider follows the mouse")
    page.until_widget(title, lambda value: "preview" in value, "a preview of the map")
    print(f"preview {1000 * (time.monotonic() - began):.0f} ms after the slider was moved")
    page.mouse("mouseReleased", left + 8 + 5 * (right - left - 16) // 8, (top + bottom) // 2)
    page.until_widget(title, lambda value: value.startswith("exact"), "an exact map after the edit")
    print(f"exact {time.monotonic() - began:.1f} s after it; matrix of {cell!r}")


def say_from_a_file(browser, folder, width, height):
    """From the disk the page says what it lacks, and how to get it."""
    page = Page(browser, width, height)
    browser.ask("Page.navigate", url=(pathlib.Path(folder) / "tactspace.html").resolve(strict=True).as_uri())
    page.until("document.getElementById('said')?.textContent.includes('Serve its folder')", "a sentence", 60)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder")
    parser.add_argument("--headers", action="store_true")
    parser.add_argument("--width", type=int, default=1280)
    parser.add_argument("--height", type=int, default=800)
    parser.add_argument("--picture")
    parser.add_argument("--set", help="a set file beside the page, opened by its address")
    args = parser.parse_args()
    address = serve(args.folder, args.headers)
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        browser = Browser(profile, "--use-angle=swiftshader --enable-unsafe-swiftshader")
        page = Page(browser, args.width, args.height)
        began = time.monotonic()
        browser.ask("Page.addScriptToEvaluateOnNewDocument",
                    source="self.environment_for_tests = {TACTSPACE_WIDGET_RECTS: '/tmp/widgets'}")
        fragment = f"#set={args.set}" if args.set else ""
        browser.ask("Page.navigate", url=f"{address}/tactspace.html{fragment}")
        page.until("document.title.endsWith(' - tactspace')", "the window opens")
        print(f"first view after {time.monotonic() - began:.1f} s, title {page.value('document.title')!r}")
        edit(page)
        if args.picture:
            page.picture(args.picture)
        for message in page.messages():
            print("said:", message[:400])
        say_from_a_file(browser, args.folder, args.width, args.height)
        browser.process.terminate()
        browser.process.wait()


if __name__ == "__main__":
    main()
