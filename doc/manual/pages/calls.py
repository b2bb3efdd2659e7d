"""calls.py - the page of NX's calls, from nx(3) as doc/man/nx3.awk writes it: one source for both, the headers' comments."""
import re
import subprocess

from markdown import escape, fence, index, sentence, table

HEADERS = ("nx.h", "estat.h", "pfs/pfs.h", "nx_underscore.h", "nxerrno.h", "host.h")


def nx3(root):
    headers = [str(root / "nx_api/include" / header) for header in HEADERS]
    return subprocess.run(["awk", "-v", "date=-", "-f", str(root / "doc/man/nx3.awk")] + headers,
                          stdout=subprocess.PIPE, check=True, text=True).stdout


def plain(text):
    return text.replace("\\-", "-").replace("\\&", "").replace("\\fB", "").replace("\\fR", "").replace("\\e", "\\")


def names_of(declarations):
    """The calls, constants and types that lines of C declare."""
    text = "\n".join(declarations)
    calls = [m for m in re.findall(r"^(?!#|typedef)[\w\s*]*?\b(\w+)\(", text, re.M)]
    return calls + re.findall(r"^#define (\w+)", text, re.M) + re.findall(r"^extern \w+ (\w+)", text, re.M)


class Page:
    """Takes the page line by line."""

    def __init__(self):
        self.out, self.words, self.code, self.errors = "", [], None, []
        self.skipped = True

    def end_paragraph(self):
        if self.words:
            self.out += escape(" ".join(self.words)) + "\n\n"
        self.words = []

    def end_errors(self):
        if self.errors:
            self.out += index(*(name for name, _ in self.errors))
            self.out += table(["error", "means"], [[f"`{name}`", escape(sentence(text))] for name, text in self.errors])
        self.errors = []

    def section(self, title):
        self.end_paragraph()
        self.end_errors()
        self.skipped = title in ("NAME", "SYNOPSIS", "SEE ALSO")
        if not self.skipped:
            self.out += f"## {escape(title.capitalize())}\n\n"

    def code_ends(self):
        names = names_of(self.code)
        self.out += (index(*(f"{name} (NX)" for name in names)) if names else "") + fence("\n".join(self.code), "c") + "\n"
        self.code = None

    def line(self, line):
        if line.startswith(".SH "):
            self.section(plain(line[4:]))
        elif self.skipped or line.startswith((".\\\"", ".TH")):
            pass
        elif line == ".nf":
            self.end_paragraph()
            self.code = []
        elif line == ".fi":
            self.code_ends()
        elif self.code is not None:
            self.code.append(plain(line))
        elif line == ".TP":
            self.end_paragraph()
            self.errors.append(None)
        elif self.errors and self.errors[-1] is None:
            self.errors[-1] = [plain(line).replace(".B ", ""), ""]
        elif self.errors and self.errors[-1][1] == "":
            self.errors[-1][1] = plain(line)
        elif line.startswith((".PP", ".RS", ".RE", ".br")):
            self.end_paragraph()
        else:
            self.end_errors()
            self.words.append(plain(line))


INTRODUCTION = """# NX: rules and calls

```{index} NX
```
```{index} calls
```

This chapter is made from the headers, as the manual page nx(3) is. A rule that is called "silent" is one on which Intel's manuals say
nothing: it is what programs need. tests/nx has a program for each rule, and tests/nx/RULES.md lists them.

"""


def page(root):
    made = Page()
    for line in nx3(root).splitlines():
        made.line(line)
    made.section("NAME")
    return INTRODUCTION + made.out
