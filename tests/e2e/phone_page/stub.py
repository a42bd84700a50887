"""Stands for the program in front of the phone's page: its protocol, without the program.

    stub.py [PORT]      shows one card after the other, as Enter is pressed; prints answers

Left out: limits of sizes and rates, wrong tokens but for the empty 404, more than a few phones.
"""

import http.server
import json
import pathlib
import secrets
import threading
import time

ASSETS = pathlib.Path(__file__).resolve().parents[3] / "assets" / "phone"
TYPES = {"index.html": "text/html", "phone.js": "text/javascript", "phone.css": "text/css",
         "texts.json": "application/json"}
POLICY = "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src 'self' data:"
LONGEST_POLL_S = 20


class Phone:
    def __init__(self, number, nickname):
        self.number, self.nickname = number, nickname
        self.card = {"serial": 1, "kind": "wait"}
        self.play = {"serial": 0, "ms": [], "loop": False, "stop": True}


class Stub:
    def __init__(self, port=0):
        self.token = secrets.token_urlsafe(16)
        self.phones = {}
        self.joined, self.answers, self.played, self.polls = [], [], [], []
        self.faults = []  # what the next requests get in place of an answer: (route, status; 0 ends the connection)
        self.changed = threading.Condition()
        handler = type("Bound", (Handler,), {"stub": self})
        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", port), handler)
        self.server.daemon_threads = True
        self.server.handle_error = lambda *_: None  # pages leave without a word
        threading.Thread(target=self.server.serve_forever, daemon=True).start()

    def address(self):
        return f"http://127.0.0.1:{self.server.server_port}/{self.token}/"

    def show(self, card):
        with self.changed:
            for phone in self.phones.values():
                phone.card = {**card, "serial": phone.card["serial"] + 1}
            self.changed.notify_all()

    def play(self, ms, loop=False):
        with self.changed:
            for phone in self.phones.values():
                phone.play = {"serial": phone.play["serial"] + 1, "ms": ms, "loop": loop, "stop": not ms}
            self.changed.notify_all()

    def close_phones(self):
        with self.changed:
            self.phones.clear()
            self.changed.notify_all()

    def fault(self, route):
        """The status that is asked for in place of an answer; None without one."""
        with self.changed:
            for fault in self.faults:
                if fault[0] == route:
                    self.faults.remove(fault)
                    return fault[1]
        return None

    def join(self, body):
        self.joined.append(body)
        with self.changed:
            key = body.get("phone")
            if key not in self.phones:
                key = secrets.token_urlsafe(16)
                self.phones[key] = Phone(len(self.phones) + 1, body["nickname"])
            phone = self.phones[key]
            return 200, {"phone": key, "number": phone.number, "nickname": phone.nickname}

    def next(self, body):
        self.polls.append(body)
        end = time.monotonic() + LONGEST_POLL_S
        with self.changed:
            while phone := self.phones.get(body["phone"]):
                news = phone.card["serial"] != body["card"] or phone.play["serial"] != body["play"]
                if news or not self.changed.wait(end - time.monotonic()):
                    return 200, {what: now if now["serial"] != body[what] else {"serial": body[what]}
                                 for what, now in (("card", phone.card), ("play", phone.play))}
        return 410, None

    def tell(self, body):
        with self.changed:
            phone = self.phones.get(body["phone"])
            if not phone:
                return 410, None
            if "played" in body:
                self.played.append(body["played"])
                return 204, None
            if body["card"] != phone.card.get("id"):
                return 409, None
            self.answers.append(body)
            if phone.card["kind"] == "choice":
                phone.card = {**phone.card, "mine": body["answer"]["option"], "serial": phone.card["serial"] + 1}
                self.changed.notify_all()
            return 204, None


class Handler(http.server.BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    stub = None

    def log_message(self, *_):
        pass

    def send(self, status, kind="application/json", data=b""):
        self.send_response(status)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Security-Policy", POLICY)
        self.send_header("Cache-Control", "no-store")
        self.send_header("Content-Length", str(len(data)))
        self.end_headers()
        self.wfile.write(data)

    def route(self):
        head = f"/{self.stub.token}/"
        return self.path[len(head):] if self.path.startswith(head) else None

    def do_GET(self):
        name = {"": "index.html"}.get(self.route(), self.route())
        if name not in TYPES:
            self.send(404)
        else:
            self.send(200, TYPES[name] + "; charset=utf-8", (ASSETS / name).read_bytes())

    def do_POST(self):
        body = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        route = self.route()
        if route not in ("join", "next", "tell"):
            return self.send(404)
        fault = self.stub.fault(route)
        if fault == 0:
            self.close_connection = True
            return None
        status, answer = (fault, None) if fault else getattr(self.stub, route)(body)
        try:
            self.send(status, data=json.dumps(answer).encode() if answer is not None else b"")
        except (BrokenPipeError, ConnectionResetError):
            pass  # the page has left this poll


def heartbeat(count=3):
    return [60, 90, 40, 600] * count


def shaky(seconds, on_ms=15, off_ms=15):
    return [on_ms, off_ms] * round(1000 * seconds / (on_ms + off_ms))


QUESTION = {
    "kind": "choice", "id": "q3", "ask": "Which of these is closest to the plain tone?", "ms": shaky(1.2),
    "options": ["AM 4 Hz", "AM 40 Hz", "AM 80 Hz", "All three feel the same to most people <b>here</b>"],
}
# One of every card, by the name of its picture.
CARDS = {
    "wait": {"kind": "wait"},
    "feel": {"kind": "feel", "patterns": [
        {"name": "Heartbeat", "ms": heartbeat(2), "loss": ""},
        {"name": "Rain on a tin roof", "ms": [15, 40, 15, 90, 20, 25, 15, 130, 30, 60, 15, 15, 15, 200, 20, 45, 15],
         "loss": "12 ms were too short to be felt."},
        {"name": "<img src=x onerror=alert(1)>", "ms": shaky(0.9), "loss": ""},
        {"name": "Long hum", "ms": [1400],
         "loss": "The rise of the amplitude is played in steps, as a phone's motor has one strength."},
    ]},
    "choice": QUESTION,
    "choice_revealed": {**QUESTION, "mine": 1, "revealed": {
        "right": [2], "votes": [3, 12, 9, 1], "text": "Waves that are fast enough return to the plain tone."}},
    "trial": {"kind": "trial", "id": "t7", "at": 7, "of": 20, "ms": [heartbeat(1), heartbeat(1), [60, 90, 120, 520]]},
    "rating": {"kind": "rating", "id": "r1", "patterns": [{"ms": heartbeat(1)}, {"ms": shaky(0.6)}, {"ms": [300]}],
               "trials": [[0, 1], [2, 2], [1, 2], [2, 0]], "done": 1},
    "thanks": {"kind": "thanks", "text": "The map of the class is on the screen now."},
}


def main():
    import sys
    stub = Stub(int(sys.argv[1]) if len(sys.argv) > 1 else 0)
    print(stub.address())
    while True:
        for name, card in CARDS.items():
            input(f"Enter: {name} ")
            stub.show(card)
            print(stub.answers, stub.played)


if __name__ == "__main__":
    main()
