"""console.py PAGE [WHOLE] - gives the commands of a page's console blocks, and compares what they print with what the page
says: "ok ..." or "not ok ..." for each. A line "..." stands for any lines; without one, all must be equal.

With RENEW=1 in the environment what differs is replaced in the page (in WHOLE, if PAGE is a part cut out of it): read the
change before it is committed. Between two "..." those lines are taken that are most like the old ones."""
import difflib
import os
import re
import subprocess
import sys


def commands(page):
    for block in re.findall(r"^```console\n(.*?)^```$", page, re.S | re.M):
        for part in re.split(r"^\$ ", block, flags=re.M)[1:]:
            command, _, shown = part.partition("\n")
            yield command, shown


def pattern(shown):
    lines = [".*" if line == "..." else re.escape(line + "\n") for line in shown.splitlines()]
    return "".join(lines)


def renewed(shown, printed):
    """shown, with its lines out of printed instead. An excerpt at an end of what was printed stays there."""
    excerpts = re.split(r"^\.\.\.\n", shown, flags=re.M)
    start, parts = 0, []
    for nth, excerpt in enumerate(excerpts):
        size = excerpt.count("\n")
        places = range(start, len(printed) - size + 1)
        if nth == len(excerpts) - 1:
            places = [len(printed) - size] if nth else [0]
            size = size if nth else len(printed)
        elif nth == 0:
            places = [0]
        likeness = lambda at: difflib.SequenceMatcher(None, excerpt, "".join(printed[at:at + size])).ratio()
        best = max(places, key=likeness, default=start)
        parts.append("".join(printed[best:best + size]))
        start = best + size
    return "...\n".join(parts)


def renew(path, command, shown, printed):
    text = open(path).read()
    old = f"$ {command}\n{shown}"
    if text.count(old) != 1:
        print(f"# {path} has this {text.count(old)} times: not renewed")
        return
    with open(path, "w") as page:
        page.write(text.replace(old, f"$ {command}\n{renewed(shown, printed.splitlines(keepends=True))}"))


found = 0
for command, shown in commands(open(sys.argv[1]).read()):
    run = subprocess.run(command, shell=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    equal = re.fullmatch(pattern(shown), run.stdout, re.S)
    print("ok" if equal else "not ok", command)
    if not equal:
        print("".join("# " + line + "\n" for line in run.stdout.splitlines()), end="")
        if os.environ.get("RENEW"):
            renew(sys.argv[-1], command, shown, run.stdout)
    found += 1
if not found:
    print("not ok: the page has no commands")
