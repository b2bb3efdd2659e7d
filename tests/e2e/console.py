"""console.py PAGE - gives the commands of a page's console blocks, and compares what they print with what the page
says: "ok ..." or "not ok ..." for each. A line "..." stands for any lines; without one, all must be equal."""
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


found = 0
for command, shown in commands(open(sys.argv[1]).read()):
    run = subprocess.run(command, shell=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    equal = re.fullmatch(pattern(shown), run.stdout, re.S)
    print("ok" if equal else "not ok", command)
    if not equal:
        print("".join("# " + line + "\n" for line in run.stdout.splitlines()), end="")
    found += 1
if not found:
    print("not ok: the page has no commands")
