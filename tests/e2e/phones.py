"""Phones for the story "phones": real pages in headless Chromium that are told what to do line by line, and simulated
ones that speak the protocol.

    phones.py real                  reads lines of JSON [NAME, METHOD, ARGUMENT..] of Phone, answers each by one line
    phones.py class ADDRESS COUNT   so many raters join, rate all pairs, and say how many answers were taken
    phones.py outside ADDRESS       what has no business there is refused
"""

import concurrent.futures
import contextlib
import http.client
import json
import pathlib
import socket
import sys
import tempfile
import urllib.parse

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "phone_page"))
from phone import Phone  # noqa: E402


def real():
    phones = {}
    with contextlib.ExitStack() as end:
        for line in sys.stdin:
            name, method, *arguments = json.loads(line)
            if name not in phones:
                profile = end.enter_context(tempfile.TemporaryDirectory(ignore_cleanup_errors=True))
                phones[name] = Phone(profile)
                end.callback(phones[name].close)
            print(json.dumps(getattr(phones[name], method)(*arguments)), flush=True)


class Served:
    def __init__(self, address):
        self.parts = urllib.parse.urlsplit(address)
        self.token = self.parts.path.strip("/")

    def ask(self, route, body=None, method="POST", token=None):
        connection = http.client.HTTPConnection(self.parts.hostname, self.parts.port, timeout=60)
        text = body if isinstance(body, (bytes, type(None))) else json.dumps(body)
        connection.request(method, f"/{self.token if token is None else token}/{route}", text)
        answer = connection.getresponse()
        found = answer.status, answer.read(), dict(answer.getheaders())
        connection.close()
        return found


def rate(served, nickname):
    """Feels pairs by how far their numbers are apart, and notices identical ones."""
    status, text, _ = served.ask("join", {"nickname": nickname, "vibrates": True, "language": "en"})
    if status != 200:
        sys.exit(f"{nickname}: {status} {text}")
    key = json.loads(text)["phone"]
    card, play = {"serial": 0}, {"serial": 0}
    while card.get("kind") != "rating":
        status, text, _ = served.ask("next", {"phone": key, "card": card["serial"], "play": play["serial"]})
        if status != 200:
            sys.exit(f"{nickname}: {status} {text}")
        news = json.loads(text)
        card, play = news["card"], news["play"]
    taken = 0
    for k, (left, right) in enumerate(card["trials"]):
        answer = {"k": k, "similarity": 100 if left == right else max(0, 80 - 20 * abs(left - right)),
                  "plays": [1, 1], "first": "left", "response_ms": 4000 + k}
        status = 429
        while status == 429:  # a thumb is slower than this loop
            status, _, _ = served.ask("tell", {"phone": key, "card": card["id"], "answer": answer})
        taken += status == 204
    return taken, len(card["trials"])


def rate_together(address, count):
    served = Served(address)
    with concurrent.futures.ThreadPoolExecutor(16) as pool:
        counts = list(pool.map(lambda k: rate(served, f"Rater {k + 1}"), range(count)))
    for taken, asked in counts:
        if taken != asked:
            sys.exit(f"{taken} of {asked} answers were taken")
    print(sum(taken for taken, _ in counts))


def raw(served, text):
    with socket.create_connection((served.parts.hostname, served.parts.port), timeout=60) as one:
        with contextlib.suppress(OSError):
            one.sendall(text)
        found = b""
        with contextlib.suppress(OSError):
            while piece := one.recv(1 << 16):
                found += piece
    return found


def outside(address):
    served = Served(address)
    wrong = "A" * len(served.token)
    nothing = served.ask("", method="GET", token=wrong)
    for route, token in (("", "x"), ("phone.js", wrong), ("../../../../etc/passwd", None), ("..%2f..%2fetc%2fpasswd", None),
                         ("phone.js/", None), ("join", wrong), ("none", None)):
        status, text, headers = served.ask(route, method="GET", token=token)
        if status not in (404, 405) or text:
            sys.exit(f"GET {route!r} of {token!r}: {status} {text!r}")
    if nothing[0] != 404 or nothing[1]:
        sys.exit(f"a wrong token: {nothing}")
    status, text, headers = served.ask("", method="GET")
    if status != 200 or "default-src 'none'" not in headers.get("Content-Security-Policy", ""):
        sys.exit(f"the page: {status} {headers}")
    if any(name.lower().startswith("access-control") for name in headers):
        sys.exit(f"shared with other sites: {headers}")
    for body in (b"{", b"[" * 4000, b"\xff\xfe", b'{"nickname": 5, "vibrates": true, "language": "en"}', b"x" * 5000):
        status, text, _ = served.ask("join", body)
        if status not in (400, 413):
            sys.exit(f"{body[:40]!r}: {status} {text!r}")
    path = served.parts.path.encode()
    for request in (b"POST " + path + b"join HTTP/1.1\r\nHost: x\r\nContent-Length: 999999999\r\n\r\n{}",
                    b"GET " + path + b"x" * 20000 + b" HTTP/1.1\r\n\r\n",
                    b"GET " + path + b" HTTP/1.1\r\n" + b"A: b\r\n" * 20000 + b"\r\n",
                    b"\x16\x03\x01\x02\x00\x01" * 20):
        answer = raw(served, request)
        if answer.startswith(b"HTTP/1.1 200"):
            sys.exit(f"{request[:60]!r}: {answer[:80]!r}")
    if served.ask("", method="GET")[0] != 200:
        sys.exit("the page is gone")


if __name__ == "__main__":
    {"real": real, "class": lambda address, count: rate_together(address, int(count)), "outside": outside}[sys.argv[1]](
        *sys.argv[2:])
