"""touchstone.py - touchstone's runs and results in Python and notebooks: tables of what its commands write.

    import touchstone
    r = touchstone.run("ring", machine="ipsc860", nodes=16)   # compiled by nxcc -O2 -o ring ring.c
    r.time_s, r.nodes                                          # a table: a row a node
    touchstone.results("out/study")                            # a row a point
    touchstone.trace("ring.trace", "messages")                 # a row a message
    touchstone.why("ring.trace")                               # why the run took its time
    touchstone.profile("ring.json")                            # a row a function; lines=True: a line of source
    touchstone.machines(), touchstone.numbers("delta")         # machines; a machine's numbers with their sources

A table is a pandas.DataFrame if pandas is installed, else a Table: a list of dicts that notebooks show as a table. Times are in seconds
where the name ends in _s, in picoseconds where it ends in _ps. What a command reports as an error is raised as touchstone.Error;
a warning is Python's.

The module has no compiled part, and calls the command touchstone: the one that $TOUCHSTONE names, else that of the installation
that the module belongs to, else that of $PATH."""
import csv
import html
import io
import json
import os
import pathlib
import re
import shutil
import subprocess
import warnings

__all__ = ["Error", "Run", "Table", "Why", "machines", "numbers", "profile", "results", "run", "trace", "why"]


class Error(Exception):
    """What a command of touchstone said on standard error. status: its exit status."""

    def __init__(self, text, status):
        super().__init__(text.strip())
        self.status = status


# --- tables ---------------------------------------------------------------------------------------------------------


MOST_ROWS, MOST_WIDTH = 20, 50  # of a table, at the prompt


def _shown(value):
    text = f"{value:.6g}" if isinstance(value, float) else str(value)
    return text if len(text) <= MOST_WIDTH else text[: MOST_WIDTH - 3] + "..."


class Table(list):
    """Rows, each a dict, as the prompt and a notebook show them; what pandas.DataFrame(table) takes."""

    @property
    def columns(self):
        return list(dict.fromkeys(key for row in self for key in row))

    def column(self, name):
        return [row.get(name) for row in self]

    def __repr__(self):
        """As text: the columns that have room on a terminal, of the first rows."""
        head, room = self.columns, shutil.get_terminal_size().columns
        lines = [head] + [[_shown(row.get(c, "")) for c in head] for row in self[:MOST_ROWS]]
        widths = [max(map(len, column)) for column in zip(*lines)]
        count = 0
        while count < len(head) and (not count or sum(widths[:count + 1]) + 2 * count <= room):
            count += 1
        text = ["  ".join(v.rjust(w) for v, w in zip(line[:count], widths)) for line in lines]
        more = [f"{left} {what}{'' if left == 1 else 's'} more"
                for left, what in ((len(self) - MOST_ROWS, "row"), (len(head) - count, "column")) if left > 0]
        return "\n".join(text + ([f"... {' and '.join(more)}"] if more else []))

    def _repr_html_(self):
        def line(tag, values):
            return "<tr>" + "".join(f"<{tag}>{html.escape(str(v))}</{tag}>" for v in values) + "</tr>"

        rows = [line("td", (row.get(c, "") for c in self.columns)) for row in self]
        return "<table>" + line("th", self.columns) + "".join(rows) + "</table>"


def _table(rows):
    try:
        from pandas import DataFrame
    except ImportError:
        return Table(rows)
    return DataFrame(rows)


def _flat(row, before=""):
    """{"tasks": {"calls_s": 1}} as {"tasks.calls_s": 1}; lists are left out."""
    flat = {}
    for key, value in row.items():
        if isinstance(value, dict):
            flat.update(_flat(value, f"{before}{key}."))
        elif not isinstance(value, list):
            flat[before + key] = value
    return flat


NUMBER = re.compile(r"-?(?:0|[1-9][0-9]*)(\.[0-9]+)?(e[+-]?[0-9]+)?")


def _value(text):
    """A number as the commands write it; other texts are texts, also those that Python would take for numbers: 08, 1_000, inf."""
    found = NUMBER.fullmatch(text)
    return text if not found else float(text) if found[1] or found[2] else int(text)


def _of_csv(text):
    """Digests are texts, also those of decimal digits only, which would be other numbers."""
    rows = list(csv.DictReader(io.StringIO(text)))
    if any(None in row or None in row.values() for row in rows):
        raise ValueError("a row has more values than the first line, or fewer")
    return _table([{key: value if key == "digest" else _value(value) for key, value in row.items()} for row in rows])


# --- the command ----------------------------------------------------------------------------------------------------


def _binary():
    here = pathlib.Path(__file__).resolve()
    beside = [here.parent / "../../../bin/touchstone", here.parent / "../../build/touchstone"]
    found = [str(path) for path in beside if os.access(path, os.X_OK)]
    return os.environ.get("TOUCHSTONE") or (found + [shutil.which("touchstone") or "touchstone"])[0]


def _call(*words, good=(0,)):  # (what the programs of a run write on standard error is no warning)
    binary = _binary()
    try:
        done = subprocess.run([binary, *map(str, words)], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              encoding="utf-8", errors="replace", check=False)  # (programs print any bytes)
    except OSError as error:
        raise Error(f"{binary} cannot be run: {error.strerror}; $TOUCHSTONE names another", 127) from error
    if done.returncode not in good:
        raise Error(done.stderr, done.returncode)
    if words[0] != "run" and done.stderr:
        warnings.warn(done.stderr.strip(), stacklevel=3)
    return done


# --- runs -----------------------------------------------------------------------------------------------------------


class Run:
    """A run that has ended.

    output    what the programs wrote on standard output and standard error
    status    its exit status: 0; 1 a failure, 2 a deadlock, 3 races
    outcome   how it ended: "ended", "deadlock" ...
    figures   all that touchstone run --json writes
    nodes     a row a node
    time_s    its virtual time"""

    def __init__(self, figures, output, status):
        self.figures, self.output, self.status = figures, output, status
        self.time_s = figures["virtual_time_s"]
        self.outcome = figures["outcome"]
        self.nodes = _table([{"node": i, **_flat(node)} for i, node in enumerate(figures["node"])])

    def __repr__(self):
        nodes = f"{self.figures['nodes']} node{'s' if self.figures['nodes'] != 1 else ''}"
        text = f"{self.figures['program']} on {nodes} of {self.figures['machine']}: {self.time_s:.6g} s"
        return text if self.outcome == "ended" else f"{text}, {self.outcome}"

    def _repr_html_(self):
        output = f"<pre>{html.escape(self.output)}</pre>" if self.output else ""
        return f"<p>{html.escape(repr(self))}</p>" + output + self.nodes._repr_html_()


def run(program, *arguments, machine=None, nodes=None, set=(), options=()):  # noqa: A002 (as the option is called)
    """Runs a program built by nxcc. set: {"system.interrupt_us": 0}, or settings such as ("system.interrupt_us=0",);
    options: others of touchstone run, such as ("--trace", "ring.trace")."""
    words = ["run", "-q", "--json", "-", *options]
    words += ["-m", machine] if machine else []
    words += ["-n", nodes] if nodes is not None else []
    if isinstance(set, dict):
        set = [f"{key}={value}" for key, value in set.items()]  # noqa: A001
    for setting in [set] if isinstance(set, str) else set:
        words += ["--set", setting]
    done = _call(*words, program, *arguments, good=(0, 1, 2, 3))
    if not done.stdout:
        raise Error(done.stderr, done.returncode)
    try:
        figures = json.loads(done.stdout)
    except ValueError as error:
        raise Error("the run's figures are not on standard output: options must not have a --json of their own", 64) from error
    return Run(figures, done.stderr, done.returncode)


# --- what runs have left --------------------------------------------------------------------------------------------


def results(folder):
    """A study's points, of its folder."""
    points = pathlib.Path(folder) / "results.csv"
    if not points.is_file():
        raise Error(f"{folder} has no results.csv, which touchstone study writes when all points are run", 65)
    try:
        return _of_csv(points.read_text(encoding="utf-8"))
    except (ValueError, csv.Error) as error:
        raise Error(f"{points}: no table of touchstone study: {error}", 65) from error


def trace(path, table="pieces"):
    """A table of a trace: pieces, calls, waits, handlers, systems, messages or blocks."""
    return _of_csv(_call("trace", "export", "-f", "csv", "--table", table, path).stdout)


class Why:
    """Why a run took its time: text, and tables of the critical path by class, node, function, call and message."""

    def __init__(self, found):
        self.found = found
        self.text = "\n\n".join(found["sentences"])
        for key, rows in found["critical_path"].items():
            if key.startswith("by_"):
                setattr(self, key, _table(rows))

    def __repr__(self):
        return self.text

    def _repr_html_(self):
        said = "".join(f"<p>{html.escape(sentence)}</p>" for sentence in self.found["sentences"])
        return said + self.by_class._repr_html_() + self.by_function._repr_html_()


def why(path, than=None):
    """What touchstone trace why says of a trace. than: another trace, to compare with."""
    return Why(json.loads(_call("trace", "why", "--json", "-", *(["--than", than] if than else []), path).stdout))


def profile(path, lines=False):
    """Where the time of touchstone run --profile went, by function, or by line of source."""
    if lines:
        return _table(json.loads(_call("profile", "--lines", "--json", "-", path).stdout))
    try:
        return _table([_flat(row) for row in json.loads(pathlib.Path(path).read_text(encoding="utf-8"))["functions"]])
    except OSError as error:
        raise Error(f"{path}: {error.strerror}", 65) from error
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise Error(f"{path}: no profile of touchstone run --profile", 65) from error


# --- machines -------------------------------------------------------------------------------------------------------


def machines():
    """The machines."""
    return _table(json.loads(_call("machines", "--json", "-").stdout)["machines"])


def numbers(machine):
    """A machine's numbers: key, value, standing, source."""
    return _table(json.loads(_call("machines", "show", "--json", "-", machine).stdout)["machines"][0]["numbers"])
