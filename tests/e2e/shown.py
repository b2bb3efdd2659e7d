"""shown.py PAGE OUTPUT [exact] - does the output have what the page shows? Blocks are those between plain ``` lines, ```out and ```console,
and those that stand four columns in; those that begin with a line of the output are looked at, and all their lines must then be in it.
Numbers may be others: so a page tells when a report's words have changed, and not when a machine's times have; "exact": they may not.
"..." ends a line of which the rest is left out, or stands for lines. Prints "ok" or "not ok" for each block."""
import re
import sys

page, output = sys.argv[1:3]
exact = sys.argv[3:] == ["exact"]


def plain(line):
    """The line with single blanks, and, unless they must be exact, without its numbers and units of time."""
    if exact:
        return " ".join(line.split())
    numbers = r"0x[0-9a-f]+|[+-]?\d[\d.,]*"
    return " ".join(re.sub(rf"({numbers})( [mun]?s\b)?", "0", line).split())


def is_input(line):
    """What a reader types: into a shell or gdb, or as an answer."""
    return line.lstrip().startswith(("$ ", "(gdb)")) or line.endswith("(y or [n]) y")


def blocks(text):
    """Those that may be output: between fences of no other language, or indented."""
    kind, block = None, []
    for line in text.splitlines() + [""]:
        if kind is None and line.startswith("```"):
            kind = line[3:]
        elif line == "```":
            if kind in ("", "out", "console"):
                yield block
            kind, block = None, []
        elif kind is not None or line.startswith("    "):
            block.append(line)
        elif block and line.strip():
            yield block
            block = []
    yield block


said = [plain(line) for line in open(output, encoding="utf-8")]


def is_said(line):
    line = plain(line)
    if line.endswith("..."):
        return any(s.startswith(line[:-3].rstrip()) for s in said)
    return line in said


found = 0
for block in blocks(open(page, encoding="utf-8").read()):
    lines = [line for line in block if line.strip() and not is_input(line)]
    if not lines or not is_said(lines[0]):
        continue
    found += 1
    missing = [line for line in lines if not is_said(line)]
    print(("not ok" if missing else "ok"), f"{page.rsplit('/', 1)[-1]} shows: {lines[0].strip()[:70]}")
    for line in missing[:5]:
        print("#", line)
print("ok" if found else "not ok", f"{page.rsplit('/', 1)[-1]} shows something of it: {found} blocks")
