#!/usr/bin/env python3
"""Reads what touchstone trace export wrote, by tools that are not touchstone's, and checks each format's rules.

    read_export.py json|paje|otf2|picl|csv FILE    prints, in picoseconds and in order of the nodes' and messages' numbers:
        node 0 computing 123 waiting 45 system 6
        message node 0 to node 1 type 7 bytes 1024
    read_export.py table FILE                      checks a table of csv; prints its number of rows
    read_export.py run FILE                        prints the nodes of what touchstone run --json FILE wrote

Messages are those with both ends. Ends with status 1 and a sentence if a rule is broken."""
import collections
import csv
import decimal
import json
import re
import subprocess
import sys

decimal.getcontext().prec = 40
PICOSECONDS = {"s": 10**12, "us": 10**6}
STATES = ("computing", "waiting", "system")


def rule(holds, what):
    if not holds:
        sys.exit("broken: " + what)


def ps(number, unit="s"):
    """A decimal number, as text or Decimal, in picoseconds: a whole number of them."""
    value = decimal.Decimal(number) * PICOSECONDS[unit]
    rule(value == int(value), f"{number} {unit} is a whole number of picoseconds")
    return int(value)


class Found:
    """What a format says of nodes and messages."""

    def __init__(self):
        self.sums = {}  # name of a node: state: picoseconds
        self.messages = []  # (order, from, to, type, bytes)

    def node(self, name):
        return self.sums.setdefault(name, dict.fromkeys(STATES, 0))

    def show(self):
        for name in sorted(self.sums, key=lambda n: (not n.startswith("node "), int((re.findall(r"\d+", n) or [0])[0]))):
            print(name, *(f"{state} {self.sums[name][state]}" for state in STATES))
        for _, sender, to, kind, size in sorted(self.messages):
            print(f"message {sender} to {to} type {kind} bytes {size}")


class Slices:
    """Slices that nest. The time of a call that is in no slice inside of it is the system's."""

    OWN = {"computing": "computing", "waiting": "waiting", "system": "system", "call": "system", "handler": None}

    def __init__(self, sums):
        self.sums, self.open, self.last = sums, [], 0

    def enter(self, time, kind, name):
        self.spend(time)
        self.open.append((kind, name))

    def leave(self, time, name=None):
        rule(self.open, f"a slice that ends at {time} has begun")
        self.spend(time)
        ended = self.open.pop()[1]
        rule(name in (None, ended), f"{name} ends before {ended} inside of it")

    def spend(self, time):
        """All until now belongs to the innermost slice."""
        rule(time >= self.last, f"{time} comes before {self.last}")
        state = self.OWN[self.open[-1][0]] if self.open else None
        if state:
            self.sums[state] += time - self.last
        elif self.open:
            rule(time == self.last, "a handler's time is in the slices inside of it")
        self.last = time

    def end(self):
        rule(not self.open, f"{self.open} ended")


def kind_of(name):
    return name.split(":")[0] if name.split(":")[0] in STATES + ("handler",) else "call"


# --- json ---


def json_events(path):
    with open(path, encoding="utf-8") as file:
        trace = json.load(file, parse_float=decimal.Decimal)
    rule(trace["displayTimeUnit"] == "ns", "the unit shown is the nanosecond")
    return trace["traceEvents"]


def read_json(path):
    found, arrows, names = Found(), collections.defaultdict(dict), {}
    threads = collections.defaultdict(list)
    for e in json_events(path):
        rule(e["pid"] == 1 and e["tid"] > 0, "there is one process, of threads from 1 on")
        if e["ph"] == "M" and e["name"] == "thread_name":
            names[e["tid"]] = e["args"]["name"]
        elif e["ph"] != "M":
            threads[e["tid"]].append(e)
    for tid, name in names.items():
        slices = Slices(found.node(name))
        for e in threads[tid]:
            at = ps(e["ts"], "us")
            if e["ph"] == "B":
                slices.enter(at, e["cat"], e["name"])
            elif e["ph"] == "E":
                slices.leave(at, e["name"])
            else:
                rule(e["ph"] in ("s", "f") and slices.open, f"the arrow of message {e['id']} is at a slice")
                rule(e["ph"] not in arrows[e["id"]], f"message {e['id']} has one {e['ph']}")
                arrows[e["id"]][e["ph"]] = (tid, at, e["args"])
        slices.end()
    for key, arrow in arrows.items():
        rule(set(arrow) == {"s", "f"}, f"message {key} has a start and a finish")
        rule(arrow["s"][1] <= arrow["f"][1], f"message {key} is sent before it comes")
        args = arrow["s"][2]
        found.messages.append((key, names[arrow["s"][0]], names[arrow["f"][0]], args["type"], args["bytes"]))
    return found


# --- paje, by pajeng's pj_dump ---


def output(*command):
    ran = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
    rule(ran.returncode == 0 and not ran.stderr, f"{command[0]} accepts it: {ran.stderr}")
    return ran.stdout.splitlines()


def read_paje(path):
    found, calls = Found(), collections.defaultdict(list)
    for line in output("pj_dump", "-l", "12", "-u", path):
        cells = line.split(", ")
        if cells[0] == "Container" and cells[2] == "Node":
            found.node(cells[-1])
        elif cells[0] == "State" and cells[2] == "State":
            state = {"in a call": "system", "in the system": "system"}.get(cells[7], cells[7])
            if state in STATES:
                found.node(cells[1])[state] += ps(cells[4]) - ps(cells[3])
        elif cells[0] == "State":
            calls[cells[1]].append((ps(cells[3]), -ps(cells[4]), cells[7]))
        elif cells[0] == "Link":
            rule(ps(cells[3]) <= ps(cells[4]), f"message {cells[9]} is sent before it comes")
            found.messages.append((int(cells[9]), cells[7], cells[8], int(cells[6].split()[1]), int(cells[10])))
    for node in calls.values():
        inside = []
        for begin, end, name in sorted(node):
            while inside and inside[-1] <= begin:
                inside.pop()
            rule(not inside or -end <= inside[-1], f"{name} at {begin} ends within what it is in")
            inside.append(-end)
    return found


# --- otf2, by otf2-print ---

NAMED = re.compile(r'(\w+): (?:"([^"]*)"|(\d+)(?: \("([^"]*)" <\d+>\))?)')


def read_otf2(path):
    found, slices, names = Found(), {}, {}
    ends, last = collections.defaultdict(dict), None
    for line in output("otf2-print", "-G", path + "/traces.otf2"):
        if line.startswith("CLOCK_PROPERTIES"):
            rule("Ticks per Seconds: 1000000000000" in line, "the clock ticks in picoseconds")
        if line.startswith("LOCATION "):
            names[int(line.split()[1])] = re.search(r'Name: "([^"]*)"', line)[1]
    for name in names.values():
        slices[name] = Slices(found.node(name))
    for line in output("otf2-print", path + "/traces.otf2"):
        words = line.split()
        values = {key: text or number for key, text, number, _ in NAMED.findall(line)}
        if words and words[0] in ("ENTER", "LEAVE"):
            name, time = values["Region"], int(words[2])
            if words[0] == "ENTER":
                slices[names[int(words[1])]].enter(time, kind_of(name), name)
            else:
                slices[names[int(words[1])]].leave(time, name)
        elif words and words[0] in ("MPI_SEND", "MPI_RECV"):
            last = (words[0], int(words[2]), names[int(words[1])], values)
        elif last and "ADDITIONAL" in line:
            ends[int(re.search(r"UINT32; (\d+)", line)[1])][last[0]] = last
    for key, of in ends.items():
        rule(set(of) == {"MPI_SEND", "MPI_RECV"}, f"message {key} has both ends")
        send, receive = of["MPI_SEND"], of["MPI_RECV"]
        rule(send[1] <= receive[1], f"message {key} is sent before it comes")
        rule(all(send[3][k] == receive[3][k] for k in ("Tag", "Length")), f"message {key} is one")
        found.messages.append((key, send[2], receive[2], int(send[3]["Tag"]), int(send[3]["Length"])))
    check_pairs(ends)
    for of in slices.values():
        of.end()
    return found


def check_pairs(ends):
    """Readers pair messages of the same nodes and type by their order: these pairs are those of the attribute."""
    for what, other in (("MPI_SEND", "MPI_RECV"), ("MPI_RECV", "MPI_SEND")):
        queues = collections.defaultdict(list)
        for key, of in sorted(ends.items(), key=lambda item: item[1][what][1]):
            queues[(of["MPI_SEND"][2], of["MPI_RECV"][2], of["MPI_SEND"][3]["Tag"])].append(of[other][1])
        for queue in queues.values():
            rule(queue == sorted(queue), "messages of one type between two nodes keep their order")


# --- picl, by the description of its records ---

PICL_STATES = {-21: "system", -51: "system", -602: "system", -52: "waiting", -601: "waiting"}


def picl_records(path):
    last = -1
    with open(path, encoding="ascii") as file:
        for line in file:
            words = line.split()
            record, event, time = int(words[0]), int(words[1]), ps(words[2])
            processor, process, count = (int(w) for w in words[3:6])
            fields = [int(w) for w in words[7:]]
            rule(record in (-3, -4) and process == processor, line)
            rule(len(fields) == count and (count == 0) == (len(words) == 6), f"the fields are counted: {line}")
            rule(count == 0 or words[6] == "2", f"the fields are whole numbers: {line}")
            rule(time >= last, f"the records are in order of time: {line}")
            last = time
            yield record, event, time, processor, fields


def read_picl(path):
    found, traced, inside = Found(), {}, {}
    sends = collections.defaultdict(list)
    order = 0
    for record, event, time, processor, fields in picl_records(path):
        name = f"node {processor}"
        sums = found.node(name)
        if event == -901:
            rule((record == -3) == (processor not in traced), f"{name} is traced once")
            sums["computing"] += -time if record == -3 else time
            traced[processor] = True
            continue
        if record == -3:
            rule(processor not in inside, f"{name} is in one event at a time, at {time}")
            inside[processor] = (event, time)
            if event == -21:
                order += 1
                sends[(processor, fields[2], fields[1], fields[0])].append(order)
            continue
        began, since = inside.pop(processor)
        rule(began == event, f"{name} ends {event}, which it began as {began}")
        sums[PICL_STATES[event]] += time - since
        sums["computing"] -= time - since
        if event in (-51, -52):
            size, kind, sender, _ = fields
            sent = sends[(sender, processor, kind, size)]
            rule(sent, f"what {name} receives at {time} was sent")
            found.messages.append((sent.pop(0), f"node {sender}", name, kind, size))
    rule(not inside, f"all events end: {inside}")
    return found


# --- csv ---


def rows(path):
    with open(path, encoding="utf-8", newline="") as file:
        table = list(csv.reader(file))
    rule(all(len(row) == len(table[0]) for row in table), f"{path}: all rows have as many cells as the first")
    for row in table[1:]:
        for name, cell in zip(table[0], row):
            rule(not name.endswith("_s") or not cell or re.fullmatch(r"\d+\.\d{12}", cell), f"{name} {cell} is a time")
    return [dict(zip(table[0], row)) for row in table[1:]]


def read_csv(path):
    found, last = Found(), {}
    stem = path[: -len(".csv")]
    for row in rows(stem + "-pieces.csv"):
        begin, end, node = ps(row["begin_s"]), ps(row["end_s"]), row["node"]
        rule(last.get(node, begin) == begin, f"{node}: a piece begins at {begin}, where the one before it ends")
        last[node] = end
        state = {"in a call": "system", "in the system": "system"}.get(row["state"], row["state"])
        if state in STATES:
            found.node(node)[state] += end - begin
    for row in rows(stem + "-messages.csv"):
        if row["from"] and row["to"] and row["sending_call"]:
            found.messages.append((int(row["message"]), row["from"], row["to"], int(row["type"]), int(row["bytes"])))
    return found


# --- what the run itself says ---


def read_run(path):
    found = Found()
    with open(path, encoding="utf-8") as file:
        run = json.load(file)
    nodes = {f"node {i}": of for i, of in enumerate(run["node"])}
    if "host" in run:
        nodes["host"] = run["host"]
    for name, of in nodes.items():
        sums = found.node(name)
        for state, figure in zip(STATES, ("busy_s", "idle_s", "system_s")):
            sums[state] = round(of[figure] * 10**12)
    return found


READERS = {"json": read_json, "paje": read_paje, "otf2": read_otf2, "picl": read_picl, "csv": read_csv, "run": read_run}
if sys.argv[1] == "table":
    print(len(rows(sys.argv[2])))
else:
    READERS[sys.argv[1]](sys.argv[2]).show()
