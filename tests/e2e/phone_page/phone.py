"""A phone: the page in headless Chromium, with a screen, a language, a theme and fingers."""

import base64
import pathlib
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from browser import Browser  # noqa: E402

PATIENCE_S = 60
# Before the page's own script: vibrations are caught, and what its policy forbids is noted.
WATCH = """
window.calls = []; window.violations = []; window.is_willing = true;
document.addEventListener('securitypolicyviolation', e => violations.push(e.violatedDirective + ' ' + e.blockedURI));
const caught = ms => { if (is_willing) calls.push({at: performance.now(), ms: [].concat(ms)}); return is_willing; };
"""
VIBRATES = "Object.defineProperty(Navigator.prototype, 'vibrate', {configurable: true, value: caught});"
VIBRATES_NOT = "delete Navigator.prototype.vibrate;"


class Phone:
    def __init__(self, profile):
        self.browser = Browser(profile)
        self.agent = self.browser.ask("Browser.getVersion")["userAgent"]
        self.script = None
        self.browser.open_tab()
        for domain in ("Page", "Network", "Log", "Runtime"):
            self.browser.ask(domain + ".enable")
        self.browser.ask("Emulation.setTouchEmulationEnabled", enabled=True)
        self.turn(360, 800)

    def turn(self, width, height):
        self.browser.ask("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1,
                         mobile=True)
        self.width, self.height = width, height

    def look(self, theme="light", motion="no-preference"):
        self.browser.ask("Emulation.setEmulatedMedia", features=[
            {"name": "prefers-color-scheme", "value": theme}, {"name": "prefers-reduced-motion", "value": motion}])

    def open(self, address, language="en", vibrates=True):
        """A new visit: nothing is kept of the last one."""
        self.browser.ask("Network.setUserAgentOverride", userAgent=self.agent, acceptLanguage=language)
        if self.script:
            self.browser.ask("Page.removeScriptToEvaluateOnNewDocument", identifier=self.script)
        self.script = self.browser.ask("Page.addScriptToEvaluateOnNewDocument",
                                       source=WATCH + (VIBRATES if vibrates else VIBRATES_NOT))["identifier"]
        self.go(address)
        self.value("localStorage.clear(), sessionStorage.clear()")
        self.reload()

    def go(self, address):
        self.browser.ask("Page.navigate", url=address)
        self.until("location.href == '%s' && document.querySelector('h1') != null" % address)

    def reload(self):
        self.value("window.is_old = true")
        self.browser.ask("Page.reload")
        self.until("!window.is_old && document.querySelector('h1') != null")

    def value(self, expression):
        found = self.browser.ask("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in found:
            sys.exit(f"{expression}: {found['exceptionDetails']}")
        return found["result"].get("value")

    def until(self, expression, what=""):
        end = time.monotonic() + PATIENCE_S
        while not self.value(f"Boolean({expression})"):
            if time.monotonic() > end:
                sys.exit(f"waited for: {what or expression}\n{self.value('document.body.innerText')}")
            time.sleep(0.02)

    def tap(self, selector, number=0):
        """A touch in the middle, by a finger: a true event, which pages may vibrate after."""
        at = self.value(f"""(() => {{
            const e = document.querySelectorAll({selector!r})[{number}]; e.scrollIntoView({{block: 'center'}});
            const r = e.getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2]; }})()""")
        self.tap_at(*at)

    def tap_at(self, x, y):
        for kind, points in (("touchStart", [{"x": x, "y": y}]), ("touchEnd", [])):
            self.browser.ask("Input.dispatchTouchEvent", type=kind, touchPoints=points)

    def press(self, key, code=0):
        text = {"Enter": "\r"}.get(key, key if len(key) == 1 else "")
        self.browser.ask("Input.dispatchKeyEvent", type="keyDown", key=key, windowsVirtualKeyCode=code, text=text)
        self.browser.ask("Input.dispatchKeyEvent", type="keyUp", key=key, windowsVirtualKeyCode=code)

    def text(self):
        return self.value("document.body.innerText")

    def calls(self):
        """What was vibrated since the last question: [{at (ms), ms}]."""
        return self.value("calls.splice(0)")

    def complaints(self):
        """Errors and warnings but those of requests, which are part of the story."""
        logged = [one["entry"]["text"] for one in self.browser.all_of("Log.entryAdded")
                  if one["entry"]["source"] != "network"]
        thrown = [str(one["exceptionDetails"]) for one in self.browser.all_of("Runtime.exceptionThrown")]
        said = [str(one["args"]) for one in self.browser.all_of("Runtime.consoleAPICalled")]
        return logged + thrown + said + self.value("violations")

    def picture(self, path):
        shot = self.browser.ask("Page.captureScreenshot")
        pathlib.Path(path).write_bytes(base64.b64decode(shot["data"]))

    def close(self):
        self.browser.process.terminate()
        self.browser.process.wait()
