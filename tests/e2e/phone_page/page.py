"""The phone's page, used as a phone uses it; pictures of its cards are kept in a folder that is named.

    page.py [PICTURES]
"""

import contextlib
import json
import pathlib
import re
import sys
import tempfile
import time

from phone import PATIENCE_S, Phone
from stub import ASSETS, CARDS, Stub, heartbeat, shaky

MOST_BYTES = 60000
NASTY = "<img src=x onerror=alert(1)>"
SIZES = [(320, 568), (360, 800), (800, 360)]
MOST_LATE_MS = 90  # of a piece, on a machine that does other work; the page gives up at 100


def hold(holds, *what):
    if not holds:
        sys.exit("expected otherwise: " + " ".join(str(one) for one in what))


def until(holds, what):
    end = time.monotonic() + PATIENCE_S
    while not holds():
        hold(time.monotonic() < end, "waited for", what)
        time.sleep(0.02)


class Story:
    """A stub of the program and a phone that has joined it."""

    def __init__(self, phone, language="en", nickname="Kim", vibrates=True):
        self.phone, self.stub = phone, Stub()
        phone.open(self.stub.address(), language, vibrates)
        self.start(nickname)

    def start(self, nickname):
        self.phone.value(f"document.getElementById('nickname').value = {nickname!r}")
        self.phone.tap("form button")
        self.phone.until("document.querySelector('form') == null", "joined")
        until(lambda: self.stub.polls, "a poll")

    def show(self, card, ready="h1"):
        self.phone.value("void (window.old_heading = document.querySelector('h1'))")
        self.stub.show(card)
        self.phone.until(f"document.querySelector('h1') != old_heading && document.querySelector({ready!r}) != null",
                         card["kind"])

    def played_whole(self):
        self.phone.until("document.querySelector('.playing') == null", "the end of a play")

    def end(self):
        found = self.phone.complaints()
        hold(not found, "complaints:", found)
        self.stub.close_phones()


def hold_size():
    sizes = {path.name: path.stat().st_size for path in ASSETS.iterdir()}
    hold(sum(sizes.values()) <= MOST_BYTES, sizes)
    texts = json.loads((ASSETS / "texts.json").read_text())
    keys = {language: set(words) for language, words in texts.items()}
    hold(set(keys) == {"en", "de", "ko"} and keys["en"] == keys["de"] == keys["ko"], "keys of texts", keys)
    for key, text in texts["en"].items():
        values = [set(re.findall(r"{\w+}", texts[language][key])) for language in texts]
        hold(all(one == values[0] for one in values), "values in texts", key, text)
    html = (ASSETS / "index.html").read_text()
    inline = re.findall(r"<style|\sstyle=|\son\w+=|<script(?![^>]*src)", html)
    foreign = re.findall(r"http:(?!//www.w3.org/2000/svg)|https:", html)
    hold(not inline and not foreign, "inline or foreign", inline, foreign)
    unused = [key for key in texts["en"] if f'"{key}"' not in (ASSETS / "phone.js").read_text()]
    hold(not unused, "texts without a use:", unused)


def luminance(colour):
    parts = [int(colour[k:k + 2], 16) / 255 for k in (1, 3, 5)]
    return sum(w * (c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4)
               for w, c in zip((0.2126, 0.7152, 0.0722), parts))


def contrast(one, other):
    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


def hold_contrast():
    css = (ASSETS / "phone.css").read_text()
    for block in re.findall(r":root \{(.*?)\}", css, re.S):
        colour = {name: value if len(value) == 7 else "#" + "".join(2 * c for c in value[1:])
                  for name, value in re.findall(r"--([\w-]+): (#\w+)", block)}
        pairs = [(text, ground, 4.5) for text in ("text", "dim", "accent", "right")
                 for ground in ("ground", "surface", "tint")]
        pairs += [("accent-text", "accent", 4.5), ("dim", "line", 4.5), ("warning", "ground", 4.5),
                  ("warning", "warning-ground", 4.5), ("text", "warning-ground", 4.5),
                  ("edge", "ground", 3), ("edge", "surface", 3)]
        weak = {pair: contrast(colour[pair[0]], colour[pair[1]]) for pair in pairs
                if contrast(colour[pair[0]], colour[pair[1]]) < pair[2]}
        hold(not weak, "contrast", weak)


def test_joining(phone):
    """Nothing is asked of the computer before Start; a reload is the same phone; names stay text."""
    stub = Stub()
    phone.open(stub.address())
    hold(not stub.joined and not phone.calls(), "joined by itself")
    hold("nowhere else" in phone.text(), "what is kept is said")
    phone.tap("form button")
    phone.until("document.getElementById('status').textContent == 'Enter a nickname first.'")
    phone.value(f"document.getElementById('nickname').value = {NASTY!r}")
    stub.faults += [("join", 500), ("join", 503), ("next", 0), ("next", 500), ("next", 500)]
    phone.tap("form button")
    phone.until("/Too many/.test(document.getElementById('status').textContent)", "full is said")
    hold(len(phone.calls()) == 1, "a tap on Start vibrates")
    phone.tap("form button")
    phone.until("document.querySelector('.stage') != null", "the wait card")
    phone.until("document.getElementById('status').className == 'trouble'", "a lost poll is said")
    phone.until("document.getElementById('status').textContent == ''", "and over")
    polls = len(stub.polls)
    phone.value("void window.dispatchEvent(new Event('online'))")
    until(lambda: len(stub.polls) > polls, "a poll as the network is back")
    hold(phone.value("document.getElementById('status').textContent == ''"), "and no trouble")
    hold(NASTY in phone.text() and phone.value("document.querySelector('img') == null"), "a name is text")
    hold(stub.joined[-1] == {"nickname": NASTY, "vibrates": True, "language": "en"}, stub.joined)
    phone.reload()
    hold(phone.value("document.querySelector('form button').textContent") == "Continue", "comes back")
    phone.tap("form button")
    phone.until("document.querySelector('.stage') != null")
    hold(len(stub.phones) == 1 and stub.joined[-1]["phone"] in stub.phones, "the same phone")
    hold(phone.value("document.getElementById('level').getBoundingClientRect().width") == 0, "nothing plays")
    hold(not phone.complaints(), phone.complaints())


def test_closing(phone):
    story = Story(phone)
    story.stub.play([400, 100], loop=True)
    phone.until("calls.length > 2", "a loop")
    story.stub.close_phones()
    phone.until("/disconnected/.test(document.body.innerText)", "a closed phone is told so")
    calls = phone.calls()
    hold(calls[-1]["ms"] == [0], "and is silent", calls)
    polls = len(story.stub.polls)
    time.sleep(1)
    hold(len(story.stub.polls) == polls, "and asks no more")
    hold(phone.value("Object.keys(sessionStorage).length") == 0, "and forgets its key")
    story.end()
    waiting = Story(phone)
    waiting.show(CARDS["choice"], ".option")
    waiting.stub.faults += [("tell", 500)] * 20
    phone.tap(".option")
    until(lambda: len(waiting.stub.faults) < 20, "an answer that does not arrive")
    waiting.stub.close_phones()
    phone.until("/did not reach/.test(document.body.innerText)", "an answer that is lost is said")
    waiting.end()
    other = Story(phone)
    other.stub.token = "another"
    other.stub.play([100])
    phone.until("/no longer valid/.test(document.body.innerText)", "an old address is told so")
    other.end()


def test_window_plays(phone):
    story = Story(phone)
    phone.calls()
    story.stub.play([30, 10, 40, 20])
    until(lambda: story.stub.played == [1], "the play is told")
    hold([call["ms"] for call in phone.calls()] == [[30, 10, 40, 20]], "exactly what came")
    story.stub.play([0, 200, 50])
    phone.until("calls.some(({ms}) => ms[0] == 50)", "a beginning silence is waited for")
    hold([call["ms"] for call in phone.calls() if call["ms"] != [0]] == [[50]], "and not played as a tick")
    story.stub.play([2000])
    phone.until("document.getElementById('level').getBoundingClientRect().width > 300", "the bar")
    phone.calls()
    story.stub.play([])
    phone.until("calls.length > 0", "stopped")
    hold({call["ms"][0] for call in phone.calls()} == {0}, "by vibrate(0)")
    until(lambda: len(story.stub.played) == 3, "plays are told, a stop is not")
    phone.look(motion="reduce")
    phone.calls()
    story.stub.play([60, 3000, 60])
    phone.until("calls.some(({ms}) => ms[0] == 60)")
    time.sleep(0.5)
    hold(phone.value("document.getElementById('level').getBoundingClientRect().width") > 350, "a calm bar")
    phone.look()
    phone.until("document.getElementById('level').getBoundingClientRect().width == 0", "a bar that follows")
    phone.calls()
    test_loop(phone, story)
    test_loop_alone(phone, story)
    test_plays_and_reload(phone, story)
    test_local_stop(phone, story)
    story.end()


def test_loop(phone, story):
    story.stub.play([100, 150], loop=True)
    phone.until("calls.length >= 8", "rounds of a loop")
    calls = [call for call in phone.calls() if call["ms"] != [0]]
    hold(all(call["ms"] == [100, 150] for call in calls), calls)
    times = [call["at"] - calls[0]["at"] - 250 * k for k, call in enumerate(calls)]
    hold(min(times) > -MOST_LATE_MS and max(times) < MOST_LATE_MS, "rounds drift", times)


def test_loop_alone(phone, story):
    """While the computer is away nobody could stop a loop: the page does."""
    story.stub.faults += [("next", 500)] * 3
    story.stub.show({"kind": "wait"})  # ends the poll that waits
    until(lambda: not story.stub.faults, "a computer that is away")
    phone.until("calls.length > 0 && calls[calls.length - 1].ms[0] == 0", "the loop ends")
    story.stub.play([100, 150], loop=True)
    phone.until("calls[calls.length - 1].ms[0] == 100", "and another one begins")


def test_plays_and_reload(phone, story):
    """After a reload a loop continues; a play that has been, or that came meanwhile, is over."""
    phone.reload()
    phone.tap("form button")
    phone.until("calls.some(({ms}) => ms[0] == 100)", "the loop continues")
    for meanwhile in (False, True):
        if not meanwhile:
            story.stub.play([44])
            phone.until("calls.some(({ms}) => ms[0] == 44)")
        phone.reload()
        if meanwhile:
            story.stub.play([45])
        polls = len(story.stub.polls)
        phone.tap("form button")
        until(lambda: len(story.stub.polls) > polls + 1, "polls after a reload")
        hold([call["ms"] for call in phone.calls()] == [[30]], "no old play")
    story.stub.play([100, 150], loop=True)
    phone.until("calls.length > 0")


def test_local_stop(phone, story):
    """The person may stop what the window plays; what they play stops it, too, and the other way round."""
    phone.tap("#controls > button")
    phone.until("calls.length > 0 && calls[calls.length - 1].ms[0] == 0", "Stop stops")
    phone.calls()
    story.show({"kind": "feel", "patterns": [{"name": "A", "ms": [3000], "loss": ""}]}, ".row")
    story.stub.play([5000])
    phone.until("calls.length == 1")
    phone.tap(".row")
    phone.until("calls.length == 3 && document.querySelector('.row.playing')", "a tap takes over")
    hold([call["ms"] for call in phone.calls()] == [[5000], [0], [3000]], "in this order")
    story.stub.play([60])
    phone.until("calls.length == 2 && !document.querySelector('.row.playing')", "the window takes over")
    hold([call["ms"] for call in phone.calls()] == [[0], [60]], "in that order")


def test_pieces(phone):
    """A long pattern is cut into pieces of at most 99 entries, which keep time."""
    story = Story(phone)
    ms = shaky(4.5, 13, 17) + [12000, 500, 40, 11000, 30]
    ms = ms[:299] + [1600] + ms[300:]
    for attempt in range(3):  # a machine that does other work may be late once
        phone.calls()
        story.stub.play(ms)
        time.sleep(sum(ms) / 1000)
        phone.until("document.querySelector('#controls > button').getAttribute('aria-disabled') == 'true'", "the end")
        if hold_pieces(phone.calls(), ms, attempt == 2):
            break
    hold_old_play(phone, story)
    story.end()


def on_times(entries, begin=0.0):
    """Stretches (from, to) that are on, those that touch as one."""
    found = []
    for k, entry in enumerate(entries):
        if k % 2 == 0 and entry:
            if found and abs(found[-1][1] - begin) < 1e-6:
                found[-1] = (found[-1][0], begin + entry)
            else:
                found.append((begin, begin + entry))
        begin += entry
    return found


def hold_pieces(calls, ms, must):
    calls = [call for call in calls if call["ms"] != [0]]
    hold(all(len(call["ms"]) <= 99 and max(call["ms"]) <= 10000 for call in calls), "pieces", calls)
    due, late = 0.0, []
    expected = on_times(ms)
    for call in calls:
        ons = on_times(call["ms"])
        due = expected[0][0]
        late.append(call["at"] - calls[0]["at"] - due)
        for begin, end in ons:
            first = expected.pop(0)
            same = abs(first[0] - due - begin) < 1e-6 and abs(first[1] - due - end) < 1e-6
            hold(same, "another pattern", call, first)
    hold(not expected, "pulses were lost", expected)
    fine = min(late) > -MOST_LATE_MS and max(late) < MOST_LATE_MS
    hold(fine or not must, "pieces are late", late)
    return fine


def hold_old_play(phone, story):
    """A play that came while the phone was away is over, a loop is not."""
    for loop in (False, True):
        phone.calls()
        story.stub.faults += [("next", 500)] * 4
        story.stub.show({"kind": "wait"})
        until(lambda: not story.stub.faults, "a phone that is away")
        story.stub.play([80, 300], loop=loop)
        serial = next(iter(story.stub.phones.values())).play["serial"]
        until(lambda: story.stub.polls[-1]["play"] == serial, "the play has come")
        hold(bool(phone.calls()) == loop, "an old play", loop)


def test_feel(phone):
    story = Story(phone)
    story.show(CARDS["feel"], ".row")
    hold(phone.value("document.querySelectorAll('.row .drawing .on').length") == 4, "drawings")
    hold(NASTY in phone.text() and phone.value("document.querySelector('img') == null"), "a pattern's name is text")
    phone.calls()
    phone.tap(".row", 3)
    phone.until("document.querySelectorAll('.row')[3].getAttribute('aria-pressed') == 'true'")
    phone.tap(".row", 3)
    phone.until("document.querySelector('.row.playing') == null")
    hold([call["ms"] for call in phone.calls()] == [[1400], [0]], "a second tap stops")
    phone.value("document.querySelectorAll('.row')[1].focus()")
    phone.press("Enter", 13)
    phone.until("calls.length == 1", "by the keyboard")
    story.show({"kind": "tomorrow's card", "patterns": 5}, ".stage")
    hold(phone.calls()[-1]["ms"] == [0], "a card that is gone is silent; one that is not known is wait")
    story.end()


def places(phone, selector):
    return phone.value(f"[...document.querySelectorAll({selector!r})].map(e => {{ const r = e.getBoundingClientRect();"
                       " return [r.x, r.y, r.width, r.height].map(Math.round); })")


def test_choice(phone):
    story = Story(phone)
    phone.turn(360, 800)
    story.show(CARDS["choice"], ".option")
    before = places(phone, ".option, .row")
    story.stub.faults += [("tell", 0), ("tell", 500), ("tell", 429)]
    phone.tap(".option", 0)
    phone.until("document.querySelector('.option').getAttribute('aria-disabled') == 'true'", "locked while it is sent")
    phone.tap(".option", 1)
    until(lambda: len(story.stub.answers) == 1, "the answer is sent until it arrives")
    phone.until("document.querySelector('.option').getAttribute('aria-disabled') == 'false'", "and open again")
    hold(phone.value("document.querySelector('.option.mine .text').firstChild.data") == "AM 4 Hz", "mine is marked")
    phone.tap(".option", 1)
    until(lambda: [one["answer"] for one in story.stub.answers] == [{"option": 0}, {"option": 1}], "changed")
    story.stub.show(CARDS["choice_revealed"])
    phone.until("document.querySelector('.option.right') != null", "revealed")
    hold(places(phone, ".option, .row") == before, "nothing jumps", before, places(phone, ".option, .row"))
    tally = phone.value("[...document.querySelectorAll('.votes')].map(e => e.textContent).join()")
    hold(tally == "3,12,9,1", tally)
    hold("<b>here</b>" in phone.text() and "fast enough" in phone.text(), "texts are text")
    phone.tap(".option", 3)
    time.sleep(0.3)
    hold(len(story.stub.answers) == 2, "no answer after the result")
    # An answer that comes too late is said to have been lost.
    story.show({**CARDS["choice"], "id": "q4"}, ".option")
    story.stub.faults += [("tell", 409)]
    phone.tap(".option", 2)
    phone.until("/may not count/.test(document.getElementById('status').textContent)", "a late answer is said")
    hold(phone.value("document.querySelector('.option.mine') == null"), "and not marked")
    story.end()


def test_trial(phone):
    story = Story(phone)
    card = {**CARDS["trial"], "ms": [[200], [200], [100, 50, 50]]}
    story.show(card, ".feel")
    hold("7 of 20" in phone.text(), "progress")
    before = places(phone, "button")
    phone.tap(".pick", 2)
    phone.tap(".feel", 0)
    phone.until("document.querySelector('.feel.playing') != null")
    phone.tap(".feel", 0)  # cut short
    phone.until("/cut short/.test(document.getElementById('status').textContent)", "a cut play is said")
    phone.value("is_willing = false")
    phone.tap(".feel", 0)
    story.played_whole()
    phone.value("is_willing = true")
    for k in (0, 1, 2, 1):
        felt = phone.value("document.querySelectorAll('.felt').length")
        locked = phone.value("document.querySelectorAll('.pick[aria-disabled=true]').length")
        hold(locked == (0 if felt == 3 else 3), "locked until all are felt whole", felt, locked)
        phone.tap(".feel", k)
        phone.until("document.querySelector('.feel.playing') != null")
        story.played_whole()
    hold(places(phone, "button") == before, "nothing jumps")
    hold(not story.stub.answers, "no answer yet")
    phone.tap(".pick", 2)
    phone.tap(".pick", 1)
    until(lambda: story.stub.answers, "an answer")
    time.sleep(0.2)
    phone.reload()
    phone.tap("form button")
    phone.until("document.querySelector('.feel[aria-disabled=true]')", "a reload does not ask again")
    (sent,) = story.stub.answers
    hold(sent["card"] == "t7" and sent["answer"]["option"] == 2 and sent["answer"]["plays"] == [1, 2, 1], sent)
    hold(sent["answer"]["response_ms"] > 800, sent)
    story.end()


def feel_both(phone, story, order=(0, 1)):
    for side in order:
        phone.tap(".feel", side)
        phone.until("document.querySelector('.feel.playing') != null")
        story.played_whole()


def touch_scale(phone, share):
    x, y, width, height = places(phone, "input[type=range]")[0]
    phone.tap_at(x + 16 + share * (width - 32), y + height / 2)


def test_rating(phone):
    story = Story(phone)
    card = {**CARDS["rating"], "patterns": [{"ms": [120]}, {"ms": [60, 40, 20]}, {"ms": [150]}]}
    story.show(card, ".scale")
    hold("2 of 4" in phone.text(), "continues at done")
    before = places(phone, "button, input")
    touch_scale(phone, 0.5)
    hold(phone.value("document.querySelector('.untouched') != null"), "no value before both are felt")
    feel_both(phone, story, (1, 0, 1))
    phone.value("document.querySelector('input').focus()")
    phone.press("ArrowRight", 39)
    hold(phone.value("document.querySelector('.untouched') != null"), "arrows have nowhere to begin")
    hold(phone.value("document.querySelector('.value').textContent") == "–", "no value until touched")
    hold(phone.value("document.querySelector('.primary').getAttribute('aria-disabled')") == "true", "no Next")
    touch_scale(phone, 0.5)
    phone.until("document.querySelector('.value').textContent == '50'", "the middle can be touched")
    phone.press("7", 55)
    phone.press("ArrowRight", 39)
    phone.until("document.querySelector('.value').textContent == '71'", "keys put and move it")
    hold(places(phone, "button, input") == before, "nothing jumps")
    phone.tap(".primary")
    until(lambda: len(story.stub.answers) == 1, "an answer")
    sent = story.stub.answers[0]["answer"]
    hold(sent.pop("response_ms") > 300, sent)
    hold(sent == {"k": 1, "similarity": 71, "plays": [1, 2], "first": "right"}, sent)
    phone.until("/3 of 4/.test(document.body.innerText) && document.querySelector('.untouched')", "the next pair")
    # The program says how far it is: the card of now is left as it is.
    feel_both(phone, story, (0,))
    story.stub.show({**card, "done": 2})
    until(lambda: story.stub.polls[-1]["card"] == next(iter(story.stub.phones.values())).card["serial"], "the news")
    hold(phone.value("document.querySelectorAll('.felt').length") == 1, "news of the same pair change nothing")
    test_rating_reload(phone, story, card)
    story.end()


def test_rating_reload(phone, story, card):
    """An answer that was under way at a reload is not lost, and its pair is not asked for again."""
    feel_both(phone, story)
    touch_scale(phone, 0)
    story.stub.faults += [("tell", 500)] * 3
    phone.tap(".primary")
    until(lambda: not story.stub.faults or len(story.stub.faults) < 3, "under way")
    phone.reload()
    hold(len(story.stub.answers) == 1, "not arrived")
    story.stub.faults.clear()
    phone.tap("form button")
    until(lambda: len(story.stub.answers) == 2, "sent after the reload")
    phone.until("/4 of 4/.test(document.body.innerText)", "continues behind it")
    sent = story.stub.answers[1]["answer"]
    hold(sent["k"] == 2 and sent["similarity"] == 0, sent)
    phone.until("document.querySelector('.feel[aria-disabled=false]')")
    feel_both(phone, story)
    touch_scale(phone, 1)
    phone.tap(".primary")
    phone.until("/all pairs/.test(document.body.innerText)", "all are rated")
    hold([one["answer"]["k"] for one in story.stub.answers] == [1, 2, 3], story.stub.answers)


def test_without_vibration(phone):
    story = Story(phone, vibrates=False)
    hold(story.stub.joined[0]["vibrates"] is False, story.stub.joined)
    story.stub.play([600])
    phone.until("document.getElementById('level').getBoundingClientRect().width > 300", "the picture of a play")
    for name in ("trial", "rating"):
        story.show(CARDS[name])
        hold("cannot take part" in phone.text(), name)
    story.show({**CARDS["choice"], "ms": [100]}, ".option")
    phone.tap(".option", 1)
    until(lambda: story.stub.answers, "answers work all the same")
    hold(not story.stub.played, "nothing was played")
    story.end()


# What no card may do at any size: be wider than the screen, have a target below 44 px, text that is cut off.
LOOK = """(() => {
  const all = [...document.querySelectorAll('header *, main *')];
  const shown = e => e.getClientRects().length > 0 && getComputedStyle(e).visibility != 'hidden' && !e.closest('svg');
  const name = e => e.tagName + '.' + e.className + ' ' + e.textContent.slice(0, 30);
  const isWide = r => r.right > innerWidth + 0.5 || r.left < -0.5;
  const wide = all.filter(e => shown(e) && !e.closest('#track') && isWide(e.getBoundingClientRect())).map(name);
  const small = [...document.querySelectorAll('button, input')].filter(e => {
    const r = e.getBoundingClientRect(); return r.width < 44 || r.height < 44; }).map(name);
  const cut = [...document.querySelectorAll('button, h1, h2, p, span, label')].filter(e => shown(e) && e.id != 'who' &&
    e.scrollWidth > e.clientWidth + 1 && e.clientWidth > 0).map(name);
  return {wide, small, cut, scrolls: document.documentElement.scrollWidth > innerWidth,
          unnamed: [...document.querySelectorAll('button, input')].filter(e => !e.textContent.trim() &&
            !e.getAttribute('aria-label') && !document.querySelector(`label[for="${e.id}"]`)).length};
})()"""
FINE = {"wide": [], "small": [], "cut": [], "scrolls": False, "unnamed": 0}


def test_layout(phone, language):
    stub = Stub()
    phone.turn(360, 800)
    phone.open(stub.address(), language)
    hold(phone.value("document.documentElement.lang") == language, "the phone's language")
    hold_layout(phone, language, "start")
    story = Story(phone, language, "A name of 24 characters")
    for name, card in CARDS.items():
        story.stub.show(card)
        serial = next(iter(story.stub.phones.values())).card["serial"]
        until(lambda: story.stub.polls[-1]["card"] == serial, name)
        hold_layout(phone, language, name)
    story.end()


def hold_layout(phone, language, name):
    for width, height in SIZES:
        for size in ("100%", "200%"):
            phone.turn(width, height)
            phone.value(f"document.documentElement.style.fontSize = '{size}'")
            seen = phone.value(LOOK)
            hold(seen == FINE, name, language, width, height, size, seen)
    phone.value("document.documentElement.style.fontSize = ''")


# ------------------------------------------------------------------------------------------------ pictures


def photograph(phone, folder, language, theme, size):
    """A picture of every card; those that are felt are half done, and the scale is put."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    phone.look(theme)
    phone.turn(*size)

    def keep(name):
        time.sleep(0.5)  # transitions
        phone.picture(folder / f"{name}_{language}_{theme}_{size[0]}.png")

    for vibrates in (False, True):
        phone.open(Stub().address(), language, vibrates)
        keep("start" if vibrates else "start_iphone")
    story = Story(phone, language)
    for name, card in CARDS.items():
        story.stub.show(card)
        serial = next(iter(story.stub.phones.values())).card["serial"]
        until(lambda: story.stub.polls[-1]["card"] == serial, name)
        if name == "wait":
            keep("wait_idle")
            story.stub.play(heartbeat(6), loop=True)
            phone.until("calls.length > 0")
            time.sleep(1.0)
        if name == "feel":
            story.stub.play([])
            time.sleep(0.2)
            phone.tap(".row", 1)
        if name == "trial":
            feel_both(phone, story, (0, 1))
            phone.tap(".feel", 2)
        if name == "rating":
            keep("rating_begin")
            feel_both(phone, story)
            touch_scale(phone, 0.37)
        phone.value("window.scrollTo(0, 0)")
        keep(name)
    story.stub.faults += [("next", 500)] * 2
    story.stub.play([50])
    phone.until("document.getElementById('status').className == 'trouble'")
    keep("trouble")
    story.stub.close_phones()
    phone.until("document.querySelector('#controls').childElementCount == 0 && !document.querySelector('.trouble')")
    keep("closed")
    phone.look()


def main():
    hold_size()
    hold_contrast()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile, \
            contextlib.closing(Phone(profile)) as phone:
        if len(sys.argv) > 1:
            for theme in ("light", "dark"):
                for size in ((360, 800), (800, 360)):
                    photograph(phone, sys.argv[1], "en", theme, size)
            for language in ("de", "ko"):
                photograph(phone, sys.argv[1], language, "light", (360, 800))
        for test in (test_joining, test_closing, test_window_plays, test_pieces, test_feel, test_choice, test_trial,
                     test_rating, test_without_vibration):
            phone.turn(360, 800)
            test(phone)
        for language in ("en", "de", "ko"):
            test_layout(phone, language)


main()
