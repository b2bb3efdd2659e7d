"""commands.py - the page of all commands and options, from --help of each command.

argp writes the help of touchstone's commands; with a right margin far away each option is one line. nxcc's help is a text of
its own, whose options begin four blanks from the left."""
import os
import re
import subprocess
import textwrap

from markdown import code, escape, fence, index, table

WIDE = {"ARGP_HELP_FMT": "rmargin=9999"}
USUAL = ("help", "usage", "version")  # options of every command
OPTION = re.compile(r"^ {2,6}(-\S+(?:, -\S+)*(?: [A-Z][A-Z|]*)?)(?: {2,}(\S.*))?$")
HELP_COLUMN = 29  # argp's: an option that is as long as that has one blank behind it
ENTRY = re.compile(r"^ {2}([a-z][a-z-]*) {2,}(\S.*)$")
GROUP = re.compile(r"^ ([A-Z].*):$")


def help_of(words):
    return subprocess.run(words + ["--help"], env=dict(os.environ, **WIDE), stdout=subprocess.PIPE, check=True, text=True).stdout


def option(names, text):
    """An option as Sphinx's directive: `-m <MACHINE>, --machine <MACHINE>`."""
    spoken = ", ".join(re.sub(r"^(-[^\s=\[]+)(?: |=)?(\[?.*)$", lambda m: (m[1] + " " + m[2]).strip(), name)
                       for name in names.split(", "))
    return "```{option} " + spoken + "\n" + escape(text) + "\n```\n\n"


def option_of(line):
    """The names and the text of a line that is about an option, or None."""
    found = OPTION.match(line)
    if not found and re.match(r" {2,6}-\S+$", line[:HELP_COLUMN].rstrip()) and line[HELP_COLUMN - 1:HELP_COLUMN] == " ":
        return line[:HELP_COLUMN].strip(), line[HELP_COLUMN:]
    return found and (found[1], found[2] or "")


def is_usual(names):
    return any(f"--{usual}" in names.split(", ") for usual in USUAL)


def tail(text):
    """What follows the options: paragraphs, and what is indented as it is."""
    out = ""
    for part in re.split(r"\n{2,}", text.strip("\n")):
        if part.startswith("Mandatory or optional arguments"):
            continue
        lines = part.split("\n")
        plain = 0
        while plain < len(lines) and not lines[plain].startswith(" "):
            plain += 1
        if plain:
            out += escape(" ".join(lines[:plain])) + "\n\n"
        if plain < len(lines):
            out += fence(textwrap.dedent("\n".join(lines[plain:]))) + "\n"
    return out


def head(text):
    """Usage and description."""
    lines = text.split("\n")
    usage = [line for line in lines if re.match(r"Usage: |  or: ", line)]
    rest = "\n".join(lines[len(usage):])
    return fence("\n".join(re.sub(r"^(Usage|  or): +", "", line) for line in usage)) + "\n" + tail(rest)


def parts_of(text):
    """Head, options, and tail of a help text of argp."""
    lines = text.split("\n")
    listed = [i for i, line in enumerate(lines) if option_of(line) or GROUP.match(line)]
    if not listed:
        return text, [], ""
    end = next(i for i, line in enumerate(lines) if "--version" in line) + 1
    return "\n".join(lines[:listed[0]]), lines[listed[0]:end], "\n".join(lines[end:])


def options_of(lines, name, commands):
    """The list of options and entries; `commands` gets the names of these, which have sections if it is not None."""
    out, entries = "", []
    for line in lines:
        if found := ENTRY.match(line):
            entry = code(found[1])
            if commands is not None:
                commands.append(found[1])
                entry = f"[{entry}](#{name.replace(' ', '-')}-{found[1]})"
            entries.append([entry, escape(found[2])])
            continue
        if entries:
            out += table(["", ""], entries)
            entries = []
        if found := option_of(line):
            out += "" if is_usual(found[0]) else option(*found)
        elif found := GROUP.match(line):
            out += f"**{escape(found[1])}**\n\n"
    return out


def command(words, name):
    """A command's section, and those of its own commands."""
    text = help_of(words)
    before, lines, after = parts_of(text)
    entries = [] if "COMMAND --help describes a command" in text else None
    listed = options_of(lines, name, entries)
    out = f"## {name}\n\n" + index(name) + "```{program} " + name + "\n```\n\n"
    out += head(before) + listed + tail(after)
    return out + "".join(command(words + [entry], f"{name} {entry}") for entry in entries or [])


NXCC_OPTION = re.compile(r"^ {4}(-.*?)(?: {2,}(\S.*))?$")


def compiler(words):
    """nxcc: its options are listed four blanks from the left, what they do further right."""
    out = "## nxcc, nxf77\n\n" + index("nxcc", "nxf77", "gcc, options of") + "```{program} nxcc\n```\n\n"
    parts = re.split(r"\n\n", help_of(words).strip("\n"))
    for part in parts:
        if not part.startswith("    -"):
            out += tail(part)
            continue
        listed = []
        for line in re.sub(r"(?<=\S) {3,}(--\w+ )", r"\n    \1", part).split("\n"):  # two in one line
            if found := NXCC_OPTION.match(line):
                listed.append([found[1], found[2] or ""])
            else:
                listed[-1][1] += " " + line.strip()
        out += "".join(option(names.replace(" -", ", -"), text.strip()) for names, text in listed)
    return out


INTRODUCTION = """# Commands and options

```{index} commands
```
```{index} options
```

This chapter is what each command says of itself with `--help`. Besides, each has `-h` and `--help` (the text below), `--usage` (the
options in short) and `--version`. An argument that a long option needs, its short form needs, too. Options and other arguments may come
in any order; but what follows the program in `touchstone run` and `touchstone explore` is the program's.

"""


def page(build):
    out = INTRODUCTION + compiler([f"{build}/nxcc"])
    return out + command([f"{build}/touchstone"], "touchstone")
