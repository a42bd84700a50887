"""Uses the window in a page (app/web) as a person does, in headless Chromium.

    web_page.py BUILD --from disk|server|headers [--matrices FOLDER] [--edits 400] [--pictures FOLDER]

BUILD is build/web. From the disk its one file is opened, from a server its folder; with headers the
server sets the page apart as threads need it, without them the page's service worker does. FOLDER has NAME.csv, what
"tactspace predict" writes of each set that is to be compared. Prints how long what a person waits for took.
"""

import argparse
import base64
import contextlib
import functools
import gzip
import http.server
import json
import pathlib
import sys
import tempfile
import threading
import time

from browser import Browser

BEFORE_THE_PAGE = """
self.environment_for_tests = {TACTSPACE_WIDGET_RECTS: '/tmp/widgets'};
Object.defineProperty(navigator, 'clipboard', {value: {writeText: async (text) => { self.copied = text; }}});
self.vibrated = [];
Navigator.prototype.vibrate = function (ms) { self.vibrated.push(ms); return true; };
// What is played goes past here on its way out: of each piece and channel the largest sample.
self.heard = [];
const connect = AudioNode.prototype.connect;
AudioNode.prototype.connect = function (to, ...more) {
  if (to !== this.context.destination) return connect.call(this, to, ...more);
  const tap = this.context.createScriptProcessor(1024, 2, 2);
  tap.onaudioprocess = (event) => {
    const peaks = [];
    for (let channel = 0; channel < 2; ++channel) {
      let peak = 0;
      for (const sample of event.inputBuffer.getChannelData(channel)) peak = Math.max(peak, Math.abs(sample));
      peaks.push(peak);
    }
    self.heard.push(peaks);
  };
  self.taps = [...(self.taps || []), tap];
  connect.call(tap, this.context.destination);
  return connect.call(this, tap);
};
"""
# Controllers that are pretended, where a part wants some: what they are told is kept, and they answer as real ones do
# to what they are asked. Given are those that were allowed before; null is a browser without WebHID.
BEFORE_THE_PAGE += """
self.told = [];
class Pad extends EventTarget {
  constructor(kind) {
    super();
    Object.assign(this, {opened: false, ...{
      dualshock: {vendorId: 0x054c, productId: 0x09cc, productName: 'Wireless Controller', outputs: [5]},
      joycon: {vendorId: 0x057e, productId: 0x2006, productName: 'Joy-Con (L)', outputs: [1, 3, 16, 17, 18]},
    }[kind]});
    const reportsOf = (ids) => ids.map((reportId) => ({reportId, items: []}));
    this.collections = [{usagePage: 1, usage: 5, inputReports: [], featureReports: [],
                         outputReports: reportsOf(this.outputs)}];
  }
  async open() { this.opened = true; }
  async close() { this.opened = false; }
  async sendReport(id, data) {
    if (!this.opened || !navigator.hid.there.includes(this)) throw new DOMException('gone', 'NotAllowedError');
    const bytes = [id, ...new Uint8Array(data.buffer, data.byteOffset, data.byteLength)];
    self.told.push(bytes);
    if (id !== 1) return;
    const answer = new DataView(new ArrayBuffer(48));
    answer.setUint8(12, 0x80);
    answer.setUint8(13, bytes[10]);
    setTimeout(() => this.dispatchEvent(Object.assign(new Event('inputreport'), {reportId: 0x21, data: answer})), 5);
  }
  async receiveFeatureReport() { throw new DOMException('none', 'NotAllowedError'); }
}
class Pads extends EventTarget {
  constructor(kinds) {
    super();
    this.there = kinds.map((kind) => new Pad(kind));
  }
  async getDevices() { return [...this.there]; }
  async requestDevice(options) {
    self.asked = {filters: options.filters, isAfterPress: navigator.userActivation.isActive};
    const pad = new Pad(self.offered);
    this.there.push(pad);
    return [pad];
  }
  unplug() {
    const device = this.there.pop();
    device.opened = false;
    this.dispatchEvent(Object.assign(new Event('disconnect'), {device}));
  }
}
self.pretend_pads = (kinds) => {
  Object.defineProperty(navigator, 'hid', {value: kinds ? new Pads(kinds) : undefined});
};
"""
CTRL, SHIFT = 2, 8
MODIFIER_KEYS = ((CTRL, "Control", "ControlLeft", 17), (SHIFT, "Shift", "ShiftLeft", 16))
MAP = "title:Perceptual space"


SETS = pathlib.Path(__file__).resolve().parents[2] / "assets" / "sets"
NAMED = "rhythms_tactspace.tactspace.json"  # beside the page, where a server hands it out
TWELVE = "pm_2023_twelve.tactspace.json"
WITHIN = "park_choi_2011_am_4hz.tactspace.json"  # in the address itself


class Server(http.server.SimpleHTTPRequestHandler):
    headers_too = False
    packed = {}  # what was sent, compressed, by path: as servers do that many people load a page from

    def do_GET(self):
        path = pathlib.Path(self.translate_path(self.path))
        if not path.is_file():
            return super().do_GET()
        content = self.pack(path)
        self.send_response(200)
        self.send_header("Content-Type", self.guess_type(path))
        self.send_header("Content-Encoding", "gzip")
        self.send_header("Content-Length", str(len(content)))
        self.end_headers()
        self.wfile.write(content)

    @classmethod
    def pack(cls, path):
        key = (path, path.stat().st_mtime)
        return cls.packed.get(key) or cls.packed.setdefault(key, gzip.compress(path.read_bytes(), 9))

    def translate_path(self, path):
        beside = SETS / path.lstrip("/")
        return str(beside) if beside.is_file() else super().translate_path(path)

    def end_headers(self):
        if self.headers_too:
            self.send_header("Cross-Origin-Opener-Policy", "same-origin")
            self.send_header("Cross-Origin-Embedder-Policy", "require-corp")
        super().end_headers()

    def log_message(self, *_):
        pass


def serve(folder, headers):
    kind = type("Kind", (Server,), {"headers_too": headers})
    for path in pathlib.Path(folder).glob("tactspace.*"):  # before anybody waits for them
        kind.pack(path)
    return serve_by(kind, folder)


def serve_by(kind, folder):
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(kind, directory=folder))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return f"http://127.0.0.1:{server.server_port}"


class Page:
    def __init__(self, browser, downloads):
        self.browser = browser
        self.downloads = downloads
        browser.ask("Browser.setDownloadBehavior", behavior="allow", downloadPath=str(downloads))
        browser.open_tab()
        for domain in ("Page", "Log", "Runtime"):
            browser.ask(domain + ".enable")
        browser.ask("Page.addScriptToEvaluateOnNewDocument", source=BEFORE_THE_PAGE)
        self.screen(1280, 800)

    def screen(self, width, height, touch=False):
        self.browser.ask("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1,
                         mobile=touch)
        self.browser.ask("Emulation.setTouchEmulationEnabled", enabled=touch)

    def value(self, expression):
        try:
            found = self.browser.ask("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        except SystemExit:  # the page went meanwhile
            return None
        return found["result"].get("value")

    def fail(self, what):
        self.picture("failed.png")
        widgets = {name: one[4] for name, one in self.widgets().items() if not name.startswith("point:")}
        sys.exit(f"{what}: did not happen; the page says {self.value('said.textContent')!r}, its title is "
                 f"{self.value('document.title')!r}; {json.dumps(self.messages())[:3000]}\n{json.dumps(widgets)[:6000]}")

    def until(self, true, what, seconds=300.0):
        """Waits for a condition; the clock only ends a page that never comes to it."""
        end = time.monotonic() + seconds
        while not (found := true()):
            if time.monotonic() > end:
                self.fail(what)
            time.sleep(0.05)
        return found

    def messages(self):
        logged = [one["entry"]["text"] for one in self.browser.all_of("Log.entryAdded")]
        thrown = [str(one["exceptionDetails"].get("exception", {}).get("description")) for one in
                  self.browser.all_of("Runtime.exceptionThrown")]
        said = [str([a.get("value") for a in one["args"]]) for one in
                self.browser.all_of("Runtime.consoleAPICalled")]
        return logged + thrown + said

    def widgets(self):
        """What is on the screen, by name: its rectangle and its value."""
        lines = self.value("typeof FS !== 'undefined' && FS.analyzePath('/tmp/widgets').exists ? "
                           "FS.readFile('/tmp/widgets', {encoding: 'utf8'}) : ''") or ""
        found = {}
        for line in lines.splitlines():
            name, left, top, right, bottom, value = line.split("\t")
            found.setdefault(name, (int(left), int(top), int(right), int(bottom), value))
        return found

    def widget(self, name, what, wanted=lambda value: True, seconds=300.0):
        def look():
            widget = self.widgets().get(name)
            return widget if widget and wanted(widget[4]) else None
        return self.until(look, what, seconds)

    def exact(self, what):
        return self.widget(MAP, what, lambda value: "exact, " in value)  # behind the stress, where it is narrow

    def mouse(self, kind, x, y):
        self.browser.ask("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1,
                         buttons=0 if kind == "mouseReleased" else 1)

    def click(self, name):
        left, top, right, bottom, _ = self.rests(name)
        x, y = (left + right) // 2, (top + bottom) // 2
        self.browser.ask("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)
        for kind in ("mousePressed", "mouseReleased"):
            self.mouse(kind, x, y)

    def tap(self, name):
        left, top, right, bottom, _ = self.rests(name)
        at = [{"x": (left + right) // 2, "y": (top + bottom) // 2}]
        self.browser.ask("Input.dispatchTouchEvent", type="touchStart", touchPoints=at)
        self.browser.ask("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])

    def rests(self, name):
        """Where a thing is, once it stands where it stood a moment before."""
        last = [None]

        def look():
            before, last[0] = last[0], self.widgets().get(name)
            return last[0] if last[0] and before and last[0][:4] == before[:4] else None
        return self.until(look, f"{name} is there and rests", 60.0)

    def key(self, key, code, modifiers=0, number=0):
        # As a hand does: first the modifiers go down, and last they come up.
        held = [one for one in MODIFIER_KEYS if modifiers & one[0]]
        presses = [("rawKeyDown", one) for one in held] + [("rawKeyDown", (modifiers, key, code, number))]
        presses += [("keyUp", (modifiers, key, code, number))] + [("keyUp", one) for one in reversed(held)]
        for kind, (flags, name, place, virtual) in presses:
            self.browser.ask("Input.dispatchKeyEvent", type=kind, key=name, code=place, modifiers=flags,
                             windowsVirtualKeyCode=virtual)

    def type(self, text):
        for sign in text:
            self.browser.ask("Input.dispatchKeyEvent", type="keyDown", key=sign, text=sign)
            self.browser.ask("Input.dispatchKeyEvent", type="keyUp", key=sign)

    def command(self, name):
        self.key("p", "KeyP", CTRL, 80)
        self.until(lambda: any(one.startswith("palette:") for one in self.widgets()), "the palette is open")
        self.type(name)
        self.until(lambda: next((one for one in self.widgets() if one.startswith("palette:")), "") ==
                   "palette:" + name, f"the palette offers {name} first")
        self.key("Enter", "Enter", 0, 13)

    def picture(self, path):
        shot = self.browser.ask("Page.captureScreenshot")
        pathlib.Path(path).write_bytes(base64.b64decode(shot["data"]))


def open_page(page, address):
    began = time.monotonic()
    page.browser.ask("Page.navigate", url=address)
    page.until(lambda: (page.value("document.title") or "").endswith(" - tactspace"), "the window opens")
    print(f"first view after {time.monotonic() - began:.1f} s")
    page.exact("an exact map")
    print(f"exact map of the twelve after {time.monotonic() - began:.1f} s; threads: "
          f"{page.value('self.crossOriginIsolated')}")


def data_of(content):
    return "data:;base64," + base64.b64encode(content).decode()


def follow(page, address, link, first):
    """Opens the page with the set of a link, whose first pattern has that name."""
    page.browser.ask("Page.navigate", url="about:blank")
    page.browser.ask("Page.navigate", url=f"{address}#set={link}")
    page.until(lambda: "row:" + first in page.widgets(), f"the set with {first} is open", 60)


def visit(page, address, name):
    """Opens the page with a set: beside it, or within the address from the disk, where a page may read nothing else."""
    content = (SETS / name).read_bytes()
    first = json.loads(content)["patterns"][0]["name"]
    follow(page, address, data_of(content) if address.startswith("file:") else name, first)


def same_matrices(page, address, folder):
    """The matrix of each set has the bytes of the terminal's."""
    for path in sorted(pathlib.Path(folder).glob("*.csv")):
        visit(page, address, path.stem + ".tactspace.json")
        page.exact(f"the exact map of {path.stem}")
        page.value("self.copied = ''; 0")
        page.command("Copy table")
        page.until(lambda: page.value("self.copied"), "the matrix is copied", 60)
        copied = page.value("self.copied")
        if copied.encode() != path.read_bytes():
            pathlib.Path("copied.csv").write_text(copied)
            sys.exit(f"the matrix of {path.stem} has other bytes than the terminal's: copied.csv")
    print(f"{len(list(pathlib.Path(folder).glob('*.csv')))} matrices have the bytes of the terminal's")
    page.browser.ask("Page.navigate", url="about:blank")
    open_page(page, address)


def slide(page, share):
    """Drags a slider there from its left; the button stays down."""
    left, top, right, bottom, before = page.rests("slider:modulation_hz")
    y = (top + bottom) // 2
    at = left + int(share * (right - left))
    page.mouse("mousePressed", at - 20, y)
    for step in range(1, 6):
        page.mouse("mouseMoved", at - 20 + 4 * step, y)
    return at, y, before


def edit(page):
    """A slider is dragged: the map follows, says that it is a preview, and is exact again."""
    points = [one[:4] for name, one in page.widgets().items() if name.startswith("point:")]
    at, y, before = slide(page, 0.6)
    began = time.monotonic()
    page.widget("slider:modulation_hz", "the slider follows the mouse", lambda value: value != before)
    page.widget(MAP, "a preview of the map", lambda value: "preview" in value)
    print(f"preview {1000 * (time.monotonic() - began):.0f} ms after the slider was moved")
    page.mouse("mouseReleased", at, y)
    began = time.monotonic()
    page.exact("an exact map after the edit")
    print(f"exact {time.monotonic() - began:.1f} s after the edit")
    moved = [one[:4] for name, one in page.widgets().items() if name.startswith("point:")]
    if moved == points:
        sys.exit("no point of the map has moved")


def play(page):
    """The pattern is played at the sound output: on the chosen channel, at 10 %, until it is stopped."""
    page.click("device")
    page.click("device:audio/Web/default")
    page.widget("device", "the output is chosen", lambda value: "Sound of this device" in value)
    page.value("self.heard = []; 0")
    page.key(" ", "Space", 0, 32)
    page.until(lambda: page.value("self.heard.some((peaks) => peaks[0] > 1e-4)"), "something is heard", 60)
    page.until(lambda: page.value("self.heard.length > 30"), "it plays on", 60)
    page.key("Escape", "Escape", 0, 27)
    # Esc ends the sound at once: nothing is on its way that could fade.
    page.until(lambda: page.value("Object.keys(webSound.open).length") == 0, "Esc ends the sound", 60)
    page.until(lambda: page.value("webSound.context.state") == "suspended", "nothing sounds any more", 60)
    loudest, other = page.value("[0, 1].map((c) => Math.max(...self.heard.map((peaks) => peaks[c])))")
    print(f"played: largest sample {loudest:.3f} of full scale, {other:.3f} on the other channel")
    if not 0.005 < loudest <= 0.1 * 0.8 + 1e-6 or other != 0:
        sys.exit("expected 10 % of the level on the left channel alone")


def reload(page):
    page.value("self.is_old = true")
    page.browser.ask("Page.reload")
    page.until(lambda: not page.value("self.is_old"), "the page goes", 60)
    page.exact("the page is there again")


def save_and_reopen(page):
    page.key("S", "KeyS", CTRL + SHIFT, 83)
    page.widget("file name", "the file dialog opens")
    page.key("a", "KeyA", CTRL, 65)
    page.type("edited")
    page.widget("file name", "a name is typed", lambda value: value == "edited")
    page.key("Enter", "Enter", 0, 13)
    file = page.downloads / "edited.tactspace.json"
    page.until(lambda: file.exists() and file.stat().st_size > 0, "what is saved is downloaded", 60)
    saved = file.read_text()
    value = page.widgets()["slider:modulation_hz"][4]
    reload(page)
    again = file.rename(page.downloads / "again.tactspace.json")
    drop(page, again)
    page.widget("document", "the file opens again", lambda value: "again" in value or "PM 2023" in value, 60)
    page.widget("slider:modulation_hz", "its edit is there", lambda again: again == value, 60)
    page.exact("its exact map")
    print(f"saved {len(saved)} bytes as a download, and dropped again: modulation {value} Hz")


def drop(page, path):
    page.value("FS.writeFile('/tmp/widgets', ''); self.dropped = new DataTransfer();"
               f"dropped.items.add(new File([{json.dumps(path.read_text())}], {json.dumps(path.name)}));"
               "dispatchEvent(new DragEvent('drop', {dataTransfer: dropped, cancelable: true})); 0")


def named(page, address):
    """A set that the address names or holds is open; where it cannot be had, the page says what to do instead."""
    def told():
        return page.value("missing.hidden ? '' : missing.firstChild.textContent")

    def visit(name):
        page.browser.ask("Page.navigate", url="about:blank")
        page.browser.ask("Page.navigate", url=f"{address}#set={name}")
        page.until(lambda: (page.value("document.title") or "").endswith(" - tactspace"), "the page opens", 60)

    def is_open(name):
        first = json.loads((SETS / name).read_text())["patterns"][0]["name"]
        page.until(lambda: "row:" + first in page.widgets(), f"{name} is open", 60)

    visit(NAMED)
    if address.startswith("file:"):
        sentence = page.until(told, "the page says that the set is not open", 60)
        if not ("may not read the files beside it: drop the file here" in sentence and sentence.startswith(NAMED)):
            sys.exit(f"the page says {sentence!r}")
        drop(page, SETS / NAMED)
        page.until(lambda: not told(), "the sentence goes", 60)
    is_open(NAMED)
    visit("data:;base64," + base64.b64encode((SETS / WITHIN).read_bytes()).decode())
    is_open(WITHIN)
    visit("nowhere.json")
    sentence = page.until(told, "the page says that there is no such set", 60)
    page.value("missing.lastChild.click()")
    page.until(lambda: not told(), "the sentence is closed", 60)
    page.browser.ask("Page.navigate", url="about:blank")
    open_page(page, address)
    print(f"a set named in the address; of one that is not there: {sentence!r}")


def long_work(page, address):
    """A search of hours: while it runs the window answers, the map follows and is exact again; Cancel ends it."""
    rated = json.loads((SETS / TWELVE).read_text())
    labels = [pattern["name"] for pattern in rated["patterns"]]
    pairs = len(labels) * (len(labels) - 1) // 2
    rated["ratings"] = [{"name": "people", "labels": labels, "condensed": [(7 * k % pairs) / pairs for k in range(pairs)]}]
    follow(page, address, data_of(json.dumps(rated).encode()), labels[0])
    page.exact("an exact map of the rated set")
    page.command("Train on ratings")
    page.click("train:0.025")
    page.click("button:train")
    page.widget("progress:training", "the search is under way")
    page.value("""self.gaps = []; (function look(before) {
        requestAnimationFrame((now) => { self.gaps.push(now - before); look(now); });
    })(performance.now()); 0""")
    at, y, before = slide(page, 0.4)
    began = time.monotonic()
    page.widget("slider:modulation_hz", "the slider follows while the search runs", lambda value: value != before)
    page.widget(MAP, "a preview of the map while the search runs", lambda value: "preview" in value)
    preview_ms = 1000 * (time.monotonic() - began)
    page.mouse("mouseReleased", at, y)
    began = time.monotonic()
    page.exact("an exact map while the search runs")
    exact_s = time.monotonic() - began
    page.widget("progress:training", "the search is still under way")
    page.click("link:cancel training")
    began = time.monotonic()
    page.until(lambda: "progress:training" not in page.widgets(), "the search ends", 20)
    longest_ms = page.value("Math.max(...self.gaps)")
    print(f"while a model is trained: preview after {preview_ms:.0f} ms, exact after {exact_s:.1f} s, {longest_ms:.0f} ms "
          f"between two frames at most, cancelled within {time.monotonic() - began:.1f} s")
    if longest_ms > 1500:
        sys.exit("the picture waited for the search")


def many_edits(page, count):
    """Memory after many edits is what it was after half of them: 50 maps are kept, and stacks of work that pauses."""
    def memory():
        return page.value("wasmMemory.buffer.byteLength") >> 20
    few = 0
    for edit_number in range(count):
        at, y, _ = slide(page, 0.2 + 0.6 * (edit_number % 10) / 10)
        page.mouse("mouseReleased", at, y)
        if edit_number % 20 == 19:
            page.exact("an exact map between edits")
        if edit_number == count // 2:
            page.exact("an exact map after half of the edits")
            few = memory()
    page.exact("an exact map after all edits")
    print(f"memory {few} MB after {count // 2} edits, {memory()} MB after {count}")
    if memory() > 1.1 * few:
        sys.exit("memory grows with edits")


def one_pane(page, pictures):
    """On a phone held upright one pane fills the page, and buttons below it lead to each of them."""
    page.screen(390, 844, touch=True)
    reload(page)
    for button, pane in (("List", "Patterns"), ("Editor", "Editor"), ("Stages", "Physiology"), ("Answers", "Matrix"),
                         ("Map", "Perceptual space")):
        page.tap("pane button:" + button)
        left, top, right, bottom, _ = page.widget("pane:" + pane, f"{button} shows its pane", seconds=60)
        if right - left < 370 or bottom - top < 500:
            sys.exit(f"{pane} has {right - left} x {bottom - top} px")
        left, top, right, bottom, _ = page.rests("pane button:" + button)
        if min(right - left, bottom - top) < 43:  # 44, but for the rounding of both ends
            sys.exit(f"{button} has {right - left} x {bottom - top} px: too small for a finger")
        if pictures:
            page.picture(pathlib.Path(pictures) / f"390_{button.lower()}.png")
    print("at 390 x 844 each pane fills the page")


def light(page, pictures):
    """The light theme, to be looked at."""
    for width, height, name in ((1280, 800, "light_1280"), (390, 844, "light_390")):
        page.screen(width, height, touch=width < 400)
        reload(page)
        page.command("Light")
        page.until(lambda: not any(one.startswith("palette:") for one in page.widgets()), "the palette closes", 60)
        page.rests("pane:Perceptual space")
        if pictures:
            page.picture(pathlib.Path(pictures) / (name + ".png"))
    page.command("Dark")


def lesson_by_touch(page, pictures):
    page.screen(390, 844, touch=True)
    reload(page)
    page.command("Thresholds by frequency")
    page.widget("tour", "the lesson is open", lambda value: value.startswith("1 of "))
    seen = []
    for _ in range(40):
        widgets = page.widgets()
        if "tour:next" not in widgets:
            break
        state = (widgets["tour"][4], "lesson:answer" in widgets)
        if pictures and state not in seen:
            page.picture(pathlib.Path(pictures) / f"lesson_{len(seen) + 1}.png")
        seen.append(state)
        left, top, right, bottom, _ = widgets["tour:next"]
        if min(right - left, bottom - top) < 43:  # 44, but for the rounding of both ends
            sys.exit(f"a target of {right - left} x {bottom - top} px is too small for a finger")
        if "option:1" in widgets and not state[1]:
            page.tap("option:1")
        page.tap("tour:next")
        page.until(lambda: "tour" not in (now := page.widgets()) or
                   (now["tour"][4], "lesson:answer" in now) != state, f"the lesson continues after {state}", 120)
    last = seen[-1][0].split(" of ")
    if last[0] != last[1]:
        sys.exit(f"the lesson did not come to its last card: {seen}")
    page.tap("tour:finish")
    page.until(lambda: "tour" not in page.widgets(), "the lesson ends", 60)
    print(f"a lesson of {last[1]} cards, by touch")


def fingers(page):
    """One finger turns the map; two move it, and zoom it as they part."""
    page.screen(1024, 768, touch=True)
    reload(page)
    page.until(lambda: "points move" not in page.widgets(), "the points rest", 60)

    def points():
        return [((one[0] + one[2]) / 2, (one[1] + one[3]) / 2) for name, one in sorted(page.widgets().items())
                if name.startswith("point:")]

    def middle(places):
        return [sum(one[k] for one in places) / len(places) for k in (0, 1)]

    def spread(places):
        at = middle(places)
        return sum(((one[0] - at[0]) ** 2 + (one[1] - at[1]) ** 2) ** 0.5 for one in places) / len(places)

    left, top, right, bottom, _ = page.rests("pane:Perceptual space")
    x, y = (left + right) / 2, (top + bottom) / 2 + 20

    def touch(kind, *places):
        page.browser.ask("Input.dispatchTouchEvent", type=kind, touchPoints=[{"x": a, "y": b} for a, b in places])
        # A frame each, as fingers take.
        page.value("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(0))))")

    def drag(ways, move):
        touch("touchStart", *ways)
        for step in range(1, 9):
            touch("touchMove", *(move(place, step) for place in ways))
        touch("touchEnd")
        page.until(lambda: "points move" not in page.widgets(), "the points rest", 60)

    before = points()
    drag([(x - 40, y), (x + 40, y)], lambda at, step: (at[0] + 5 * step, at[1]))
    moved = points()
    if not 20 < middle(moved)[0] - middle(before)[0] < 60:
        page.fail(f"two fingers move the map, from {middle(before)} to {middle(moved)}")
    drag([(x - 40, y), (x + 40, y)], lambda at, step: (at[0] + (5 if at[0] > x else -5) * step, at[1]))
    parted = points()
    if spread(parted) < 1.2 * spread(moved):
        page.fail(f"two fingers zoom the map, from {spread(moved)} to {spread(parted)}")
    drag([(x, y + 60)], lambda at, step: (at[0] + 8 * step, at[1]))
    if points() == parted:
        page.fail("a finger turns the map")
    print("the map is moved, zoomed and turned by fingers")


def vibrate(page):
    """On a phone the pattern is played by its own motor."""
    page.tap("device")
    page.tap("device:phones/this")
    page.widget("device", "this phone is chosen", lambda value: "This phone" in value)
    page.key(" ", "Space", 0, 32)
    page.until(lambda: page.value("self.vibrated.some((ms) => Array.isArray(ms) && ms.length > 0)"), "it vibrates", 60)
    ms = page.value("self.vibrated.find((ms) => Array.isArray(ms) && ms.length > 0)")
    page.key("Escape", "Escape", 0, 27)
    page.until(lambda: page.value("self.vibrated.at(-1) === 0"), "Esc stops it", 60)
    print(f"this phone: {len(ms)} on-off times, {sum(ms)} ms")


# By the number of its report: its length, and whether it asks for no vibration.
REPORTS = {
    0x05: (32, lambda report: report[4] == report[5] == 0),
    0x10: (10, lambda report: report[2:10] == [0x00, 0x01, 0x40, 0x40] * 2),
    0x01: (49, lambda report: report[2:10] == [0x00, 0x01, 0x40, 0x40] * 2),
}
NEUTRAL = 5  # reports that end each play


def controller(page, source):
    """Controllers that are pretended are allowed, listed, played on, silenced, hidden and unplugged."""
    pretended = []

    def without_pads():
        for script in pretended:
            page.browser.ask("Page.removeScriptToEvaluateOnNewDocument", identifier=script)
        pretended.clear()

    def with_pads(kinds):
        without_pads()
        script = f"pretend_pads({json.dumps(kinds)});"
        added = page.browser.ask("Page.addScriptToEvaluateOnNewDocument", source=script)
        pretended.append(added["identifier"])
        reload(page)

    def menu():
        page.click("device")
        page.widget("device:dialog", "the list of devices is open", seconds=60)

    def told():
        reports = page.value("self.told")
        for report in reports:
            if report[0] not in REPORTS or len(report) != REPORTS[report[0]][0]:
                sys.exit(f"a report that no controller is sent on the desktop: {report}")
        return reports

    def is_neutral(report):
        return REPORTS[report[0]][1](report)

    def rests(what):
        page.until(lambda: len(last := told()[-NEUTRAL:]) == NEUTRAL and all(map(is_neutral, last)), what, 60)

    def play(what):
        page.value("self.told = []; 0")
        page.key(" ", "Space", 0, 32)
        page.until(lambda: not all(map(is_neutral, told())), f"{what} is told to vibrate", 60)

    page.screen(1280, 800)
    with_pads(None)
    menu()
    sentence = page.widget("device:no controllers", "a browser without WebHID says so", seconds=60)[4]
    with_pads([])
    menu()
    if source == "disk":  # without threads
        told_why = page.widget("device:no controllers", "the page says why it has no controllers", seconds=60)[4]
        if "device:connect" in page.widgets() or told_why == sentence:
            sys.exit(f"a page from the disk offers controllers, or says {told_why!r}")
        without_pads()
        reload(page)
        print(f"controllers: {told_why!r}")
        return
    for kind, device in (("dualshock", "hid:054c:09cc:"), ("joycon", "hid:057e:2006:")):
        page.value(f"self.offered = {json.dumps(kind)}; 0")
        if "device:connect" not in page.widgets():
            menu()
        page.click("device:connect")
        page.until(lambda: page.value("!!self.asked"), "the browser asks which controller", 60)
        asked = page.value("self.asked")
        if not asked["isAfterPress"] or {"vendorId": 0x054c, "productId": 0x0ce6} not in asked["filters"]:
            sys.exit(f"the browser was asked {asked}")
        page.until(lambda: "device:connect" not in page.widgets(), "the menu closes", 60)
        menu()
        name = page.until(lambda: next((one for one in page.widgets() if one.startswith("device:" + device)), None),
                          f"{kind} is listed", 60)
        page.click(name)
        page.widget("device", f"{kind} is chosen", lambda value: "No device" not in value and "Sound" not in value, 60)
        play(kind)
        count = len(told())
        page.until(lambda: len(told()) > count + 3, "it goes on", 60)
        page.key("Escape", "Escape", 0, 27)
        rests("Esc puts it to rest")
        strong = sum(not is_neutral(report) for report in told())
        play(kind)
        page.value("Object.defineProperty(document, 'hidden', {get: () => true, configurable: true});"
                   "document.dispatchEvent(new Event('visibilitychange')); 0")
        rests("a hidden page puts it to rest")
        page.value("delete document.hidden; 0")
        play(kind)
        page.value("navigator.hid.unplug(); 0")
        menu()
        page.widget("device advice", "the list of devices says that it is gone", seconds=60)
        page.key("Escape", "Escape", 0, 27)
        page.until(lambda: "device:dialog" not in page.widgets(), "the menu closes", 60)
        print(f"{kind}: {strong} reports of {REPORTS[told()[0][0]][0]} bytes, and at rest after Esc, hidden, unplugged")
    with_pads(["joycon"])
    menu()
    page.until(lambda: any(one.startswith("device:hid:057e:2006:") for one in page.widgets()),
               "a controller that was allowed before is listed", 60)
    without_pads()
    reload(page)
    print(f"without WebHID: {sentence!r}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--from", dest="source", choices=("disk", "server", "headers"), default="disk")
    parser.add_argument("--matrices")
    parser.add_argument("--edits", type=int, default=400)
    parser.add_argument("--pictures")
    parser.add_argument("--mbit-s", type=float, help="of the line to the server, with 40 ms to it and back")
    parser.add_argument("--only", help="names of parts, with commas between them")
    args = parser.parse_args()
    if args.source == "disk":
        address = (args.build / "tactspace.html").resolve(strict=True).as_uri()
    else:
        address = serve(args.build / "page", args.source == "headers") + "/tactspace.html"
    with contextlib.ExitStack() as at_end:
        folder = pathlib.Path(at_end.enter_context(tempfile.TemporaryDirectory(ignore_cleanup_errors=True)))
        (folder / "downloads").mkdir()
        browser = Browser(folder / "profile", "--use-angle=swiftshader --enable-unsafe-swiftshader")
        at_end.callback(browser.process.wait)
        at_end.callback(browser.process.terminate)
        page = Page(browser, folder / "downloads")
        if args.mbit_s:
            browser.ask("Network.enable")
            browser.ask("Network.emulateNetworkConditions", offline=False, latency=40,
                        downloadThroughput=args.mbit_s * 1e6 / 8, uploadThroughput=args.mbit_s * 1e6 / 8)
        open_page(page, address)
        parts = {
            "picture": lambda: args.pictures and page.picture(pathlib.Path(args.pictures) / f"{args.source}_1280.png"),
            "matrices": lambda: args.matrices and same_matrices(page, address, args.matrices),
            "edit": lambda: edit(page),
            "play": lambda: play(page),
            "controller": lambda: controller(page, args.source),
            "save": lambda: save_and_reopen(page),
            "edits": lambda: many_edits(page, args.edits),
            "work": lambda: long_work(page, address),
            "named": lambda: named(page, address),
            "pane": lambda: one_pane(page, args.pictures),
            "light": lambda: light(page, args.pictures),
            "lesson": lambda: lesson_by_touch(page, args.pictures),
            "fingers": lambda: fingers(page),
            "vibrate": lambda: vibrate(page),
        }
        for name, part in parts.items():
            if not args.only or name in args.only.split(","):
                part()
        for message in page.messages():
            print("said:", message[:400])


if __name__ == "__main__":
    main()
