"""try_server.py ADDRESS STUDY - asks a touchstone serve for what it must give and for what it must not, on 127.0.0.1 only:
prints "ok RULE" or "not ok RULE", as tests/run reads it. STUDY is the folder that it shows: nodes 2 and 4, share 0.5 and 1, and
case, of which "long" runs until it is stopped. Each wait has an end, which nothing but a fault comes to."""
import json
import os
import socket
import sys
import time
from urllib.parse import urlsplit

address, study = sys.argv[1:]
parts = urlsplit(address)
HOST, TOKEN = parts.netloc, parts.query
PORT = parts.port
ORIGIN = f"http://{HOST}"
PATIENCE = float(os.environ.get("PATIENCE", 600))  # tests/patience.bash


def rule(name, holds, why=""):
    print(("ok " if holds else "not ok ") + name + ("" if holds else f" ({why})"), flush=True)


def connect(timeout=PATIENCE):
    return socket.create_connection(("127.0.0.1", PORT), timeout)


def take(sock, end=lambda text: False):
    """What comes until the connection ends, nothing has come for the socket's timeout, or end() holds."""
    text = b""
    try:
        while not end(text):
            part = sock.recv(1 << 16)
            if not part:
                break
            text += part
    except (TimeoutError, ConnectionError):
        pass
    return text


def send(text):
    """The status of the answer to these bytes, 0 if there is none, and the body."""
    with connect() as sock:
        try:
            sock.sendall(text)
        except ConnectionError:
            pass
        head, _, body = take(sock).partition(b"\r\n\r\n")
    first = head.split(b"\r\n")[0].split()
    return (int(first[1]) if len(first) > 1 else 0), body, head


def ask(path, method="GET", body=None, host=HOST, origin=None, token=TOKEN, more=""):
    """As send(), of a request with these parts."""
    body = b"" if body is None else body if isinstance(body, bytes) else json.dumps(body).encode()
    query = "" if token is None else ("&" if "?" in path else "?") + token
    head = f"{method} {path}{query} HTTP/1.1\r\nConnection: close\r\n"
    head += "" if host is None else f"Host: {host}\r\n"
    head += "" if origin is None else f"Origin: {origin}\r\n"
    head += f"Content-Length: {len(body)}\r\n" if body or method == "POST" else ""
    return send((head + more + "\r\n").encode() + body)


def status(*args, **kwargs):
    return ask(*args, **kwargs)[0]


def data():
    return json.loads(ask("/data?study=0")[1])


def post(path, body):
    code, text, _ = ask(path, "POST", body, origin=ORIGIN)
    return code, json.loads(text)


def until(holds):
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        if holds():
            return True
        time.sleep(0.05)
    return False


class Events:
    """A stream of events, kept open."""

    def __init__(self):
        self.sock = connect(0.2)
        self.sock.sendall(f"GET /events?{TOKEN} HTTP/1.1\r\nHost: {HOST}\r\n\r\n".encode())
        self.text = b""

    def latest(self):
        self.text += take(self.sock, lambda text: True) or take(self.sock, lambda text: b"\n\n" in text)
        lines = [line[6:] for line in self.text.split(b"\n") if line.startswith(b"data: ")]
        return json.loads(lines[-1]) if lines and lines[-1].endswith(b"}") else {}

    def run(self, number):
        found = [r for r in self.latest().get("runs", []) if r["id"] == number]
        return found[0]["state"] if found else None

    def all_states(self, number):
        lines = [line[6:] for line in self.text.split(b"\n") if line.startswith(b"data: ")]
        return {r["state"] for line in lines for r in json.loads(line)["runs"] if r["id"] == number}


def children(word):
    """Processes of the study's program whose command has the word."""
    program = os.path.dirname(study) + "/prog"
    found = []
    for number in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{number}/cmdline", "rb") as file:
                command = file.read().split(b"\0")
                if program.encode() in command and word.encode() in command:
                    found.append(int(number))
        except OSError:
            pass
    return found


def check_who_may_ask():
    code, page, head = ask("/")
    rule("the page is there for who has the token", code == 200 and page.startswith(b"<!doctype html>"), code)
    rule("it may ask its own server only", b"connect-src &#39;self&#39;" in page or b"connect-src 'self'" in page)
    rule("nobody may keep it or show it in a frame", b"no-store" in head and b"frame-ancestors 'none'" in head, head)
    wrong = "token=" + TOKEN[6:-1] + ("0" if TOKEN[-1] != "0" else "1")
    for name, token in ("none", None), ("wrong", wrong), ("short", TOKEN[:-1]), ("empty", "token="):
        got = {path: status(path, token=token) for path in ("/", "/data?study=0", "/events")}
        rule(f"token {name}: 403", set(got.values()) == {403}, got)
    for name, host in (("of another", f"evil.example:{PORT}"), ("without port", "127.0.0.1"), ("missing", None),
                       ("of another port", f"127.0.0.1:{PORT + 1}"), ("twice", f"{HOST}\r\nHost: {HOST}")):
        rule(f"Host {name}: 403", status("/", host=host) in (400, 403), status("/", host=host))
    rule("Host localhost is the same server", status("/", host=f"localhost:{PORT}") == 200)
    for origin in "http://evil.example", f"https://{HOST}", "null", f"http://{HOST}.evil.example":
        rule(f"Origin {origin}: 403", status("/data?study=0", origin=origin) == 403)
    stop = {"id": 1}
    rule("a POST without Origin: 403", status("/stop", "POST", stop) == 403)
    rule("a POST of another page: 403", status("/stop", "POST", stop, origin="http://evil.example") == 403)
    rule("a POST without token: 403", status("/stop", "POST", stop, origin=ORIGIN, token=None) == 403)


def check_what_may_be_asked():
    for path in ("/../../../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "//etc/passwd", "/study/journal", "/data/", "/favicon.ico",
                 "/data%00", "/index.html"):
        code, body, _ = ask(path)
        rule(f"{path}: 404", code == 404 and b"root:" not in body, code)
    for number in "1", "-1", "", "0x0", "99999999999999999999", "..":
        rule(f"study={number}: 404", status(f"/data?study={number}") == 404)
    for method, path in ("POST", "/"), ("GET", "/points"), ("DELETE", "/data?study=0"), ("PUT", "/points"), ("GET", "/stop"):
        got = ask(path, method, origin=ORIGIN)
        rule(f"{method} {path}: 405", got[0] == 405 and b"Allow: " in got[2], got)
    rule("an unknown method is refused", status("BREW", "/") in (0, 400, 404, 405, 501))
    rule("a body too long: 413", status("/points?study=0", "POST", b"x" * 20000, origin=ORIGIN) == 413)
    huge = f"POST /points?study=0&{TOKEN} HTTP/1.1\r\nHost: {HOST}\r\nOrigin: {ORIGIN}\r\nContent-Length: 99999999999\r\n\r\n"
    rule("a body that is said to be too long: 413", send(huge.encode())[0] == 413)
    rule("headers too long are refused", status("/", more="X: " + "x" * 20000 + "\r\n") in (0, 400, 413))
    rule("an address too long is refused", status("/" + "x" * 600) == 414)
    for name, body in (("no JSON", b"{"), ("a list", b"[]"), ("nothing", b"")):
        rule(f"a body that is {name}: 400", status("/points?study=0", "POST", body, origin=ORIGIN) == 400)


def check_points(events):
    good = {"nodes": "8", "share": "0.5", "case": "short"}
    for name, request, word in (
            ("no number of nodes", {"values": {**good, "nodes": "8; id"}}, "nodes: a number"),
            ("nodes that the machine has not", {"values": {**good, "nodes": "100000"}}, "nodes"),
            ("half a node", {"values": {**good, "nodes": "2.5"}}, "whole number"),
            ("arguments in a value", {"values": {**good, "share": "1 -o /etc/passwd"}}, "share: a number"),
            ("a case that is none", {"values": {**good, "case": "longer"}}, "case"),
            ("an axis that is none", {"values": {**good, "program": "/bin/sh"}}, "program"),
            ("a point that the study leaves out", {"values": {**good, "share": "40"}}, "share < 40"),
            ("a value missing", {"values": {"nodes": "8"}}, "a value is needed"),
            ("a setting that is a text", {"values": good, "set": ["cpu=/etc/passwd"]}, "KEY=NUMBER"),
            ("a setting that is an option", {"values": good, "set": ["--host=3"]}, "KEY=NUMBER"),
            ("a key that no machine has", {"values": good, "set": ["system.call=3"]}, "unknown key"),
            ("a number out of range", {"values": good, "set": ["system.call_us=-3"]}, "call_us"),
            ("a point that is there", {"values": {**good, "nodes": 4}}, "result already")):
        code, answer = post("/points?study=0", request)
        rule(f"not run: {name}", code in (400, 409) and word in answer.get("error", ""), (code, answer))
    code, answer = post("/points?study=0", {"values": good})
    rule("a point is run", code == 202 and until(lambda: events.run(answer["id"]) == "done"), answer)
    now = data()
    added = [p for p in now["points"] if p.get("added")]
    rule("it is among the others", len(added) == 1 and added[0]["nodes"] == 8 and added[0]["sum"] == 4, added)
    rule("its value is on the axis, in order", now["axes"]["nodes"] == [2, 4, 8], now["axes"])
    base = next(p for p in now["points"] if p["nodes"] == 2 and p["share"] == 0.5)
    want = 2 * base["time_s"] / added[0]["time_s"]
    rule("its speed-up is against the study's fewest nodes", abs(added[0]["speedup"] / want - 1) < 1e-9, added[0])
    code, answer = post("/points?study=0", {"values": good, "set": ["system.call_us=500"]})
    rule("a number of the machine changes it", until(lambda: events.run(answer["id"]) == "done"), answer)
    now = data()
    slow = [p for p in now["points"] if p.get("set") == "system.call_us=500"]
    rule("it is slower", len(slow) == 1 and slow[0]["time_s"] > added[0]["time_s"], slow)
    rule("settings are an axis", now["axes"]["set"] == ["", "system.call_us=500"], now["axes"])
    rule("it is in the folder", os.path.getsize(f"{study}/added/journal") > 500)


def check_stop(events):
    long = {"nodes": "2", "share": "0.5", "case": "long"}
    code, answer = post("/points?study=0", {"values": long})
    number = answer.get("id", 0)
    rule("an endless run begins", code == 202 and until(lambda: events.run(number) == "running"), (code, answer))
    until(lambda: children("endless-word"))
    found = children("endless-word")
    rule("it is a child", len(found) == 1, found)
    rule("the same is not begun twice", post("/points?study=0", {"values": long})[0] == 409)
    leaked = []
    for fd in os.listdir(f"/proc/{found[0]}/fd") if found else []:
        target = os.readlink(f"/proc/{found[0]}/fd/{fd}")
        leaked += [target] if target.startswith("socket:") else []
    rule("it has no socket of the server", not leaked, leaked)
    rule("it is stopped", post("/stop", {"id": number})[0] == 200 and until(lambda: events.run(number) == "stopped"))
    rule("the child is gone", until(lambda: not children("endless-word")), children("endless-word"))
    rule("it is no point", not [p for p in data()["points"] if p["case"] == "long"])
    rule("what is over cannot be stopped", post("/stop", {"id": number})[0] == 404)


def is_open(sock):
    sock.settimeout(0)
    try:
        return sock.recv(1 << 16) != b""
    except BlockingIOError:
        return True
    except OSError:
        return False


def check_hostile():
    """200 half requests of several kinds, and more connections than the server keeps."""
    starts = [b"", b"G", f"GET /?{TOKEN} HTTP/1.1\r\nHost: {HOST}\r\n".encode(), b"\x16\x03\x01\x02\x00\x01\x00",
              f"POST /stop?{TOKEN} HTTP/1.1\r\nHost: {HOST}\r\nContent-Length: 1000\r\n\r\n{{".encode()]
    held = []

    def answered_among(count, path, kinds):
        """Is a whole request answered while half ones are kept? Those are shut down after some seconds."""
        halves = [connect() for _ in range(count)]
        for i, sock in enumerate(halves):
            sock.sendall(kinds[i % len(kinds)])
        held.extend(halves)
        return status(path) == 200 and any(map(is_open, halves))

    rule("among 200 half requests a whole one is answered", until(lambda: answered_among(200, "/data?study=0", starts)))
    rule("among 650, too", until(lambda: answered_among(450, "/", [b""])))
    slow = held[-450:]

    def all_gone():
        for sock in slow:  # a byte a second each
            try:
                sock.sendall(b"G")
            except OSError:
                pass
        time.sleep(1)
        return not any(map(is_open, held))

    rule("all of them are shut down in the end", until(all_gone))
    for sock in held:
        sock.close()
    rule("the server is as before", status("/") == 200)


def main():
    check_who_may_ask()
    check_what_may_be_asked()
    events = Events()
    rule("events tell of the study", until(lambda: events.latest().get("studies", [{}])[0].get("done") == 4), events.text)
    check_points(events)
    check_stop(events)
    check_hostile()


main()
