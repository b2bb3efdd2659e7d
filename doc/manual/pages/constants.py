"""constants.py - the page of all constants, from machines/*.cfg, machines/cpu/*.cfg and bench/paper/fitted.cfg: each with its
value, its standing and its source, as the comment beside it says."""
import pathlib
import re
from dataclasses import dataclass, field
from decimal import Decimal

from markdown import code, escape, fence, index, sentence, table

STANDINGS = ("read", "known", "derived", "fitted", "open")
KEY = re.compile(r"^(\s*)([a-z_]+)\s*=\s*([^;{(]+?)\s*;\s*(?:#\s*(.*))?$")
MORE_KEYS = re.compile(r"([a-z_]+)\s*=\s*([^;]+);")


@dataclass
class Constant:
    group: str
    key: str
    value: str
    standing: str
    source: str
    above: str = ""  # the comment that stands above it, and above those that follow

    @property
    def name(self):
        return f"{self.group}.{self.key}" if self.group else self.key


@dataclass
class File:
    path: pathlib.Path
    head: list = field(default_factory=list)  # the comment at its beginning, paragraphs
    constants: list = field(default_factory=list)
    groups: dict = field(default_factory=dict)  # what the comment above a group says of it

    def text(self, key):
        return next(c.value.strip('"') for c in self.constants if c.name == key)


def lines_of(path):
    """The lines of a file and, in their place, of those that it includes; a list of (is it included, line)."""
    for line in path.read_text().splitlines():
        included = re.match(r'@include "(.*)"', line)
        if included:
            yield from ((True, inner) for _, inner in lines_of(path.parent / included[1]))
        else:
            yield False, line


def standing_of(comment, before):
    """The standing that a comment begins with, and the rest of the comment. `before`: the constant above, whose standing holds
    where a comment says "the same", or there is none."""
    found = re.match(r"(?i)(" + "|".join(STANDINGS) + r")\b[:.,]?\s*(.*)", comment, re.S)
    if found:
        return found[1].lower(), found[2]
    later = re.search(r"\b(" + "|".join(STANDINGS) + r"):", comment)  # as in "128 nodes - known: ..."
    if later:
        return later[1], comment
    return (before.standing if before else ""), comment or "as above"


def finish(constant, before):
    text = constant.value == constant.value.strip('"')
    if constant.source or text:
        constant.standing, constant.source = standing_of(constant.source, before)
    constant.source = re.sub(r"\s+", " ", constant.source).strip()


def read(path):
    """All constants of a machine or cpu file, those of the files that it includes, too."""
    file = File(path)
    group, comment, at_head, last = "", [], True, None
    for included, line in lines_of(path):
        bare = line.strip()
        if re.match(r"calls = \(", bare):
            break
        if bare.startswith("#"):
            if last is not None and line.startswith(" " * 20):
                last.source += " " + bare.lstrip("# ")
            else:
                comment.append(re.sub(r"^# ?", "", bare))
                last = None
            continue
        if not bare and comment:
            if group == "" and (at_head or included):
                if not file.constants or not included:
                    file.head.append("\n".join(comment))
                comment = []
                at_head = False
            continue
        last = None
        opened = re.match(r"([a-z_]+) = \{$", bare)
        if opened:
            group = opened[1]
            file.groups[group] = "\n".join(comment)
            comment = []
        elif bare == "};":
            group = ""
        else:
            last = add(file, group, line, comment)
            comment = []
    before = None
    for constant in file.constants:
        finish(constant, before)
        before = constant
    return file


def add(file, group, line, comment):
    """Adds the constants of a line; returns the one whose comment may go on below."""
    found = KEY.match(line)
    if not found:
        return None
    constant = Constant(group, found[2], found[3], "", found[4] or "", "\n".join(comment))
    file.constants.append(constant)
    return constant


# --- pages ---


def paragraphs(comment):
    """A comment as Markdown: lines that are indented stay as they are."""
    out = []
    for part in comment.split("\n\n"):
        if re.search(r"^ {2,}\S", part, re.M):
            out.append(fence(part))
        else:
            out.append(escape(part.replace("\n", " ").strip("- ")).replace("\\`", "`") + "\n")
    return "\n".join(out) + "\n"


def head_of(file):
    """What a file says at its beginning, without the words that the page explains once."""
    parts = [part for part in "\n\n".join(file.head).split("\n\n")]
    text = "\n".join(parts)
    text = re.sub(r"(?m)^Standing of (each number|a figure):.*(\n {2,}.*)*\n?", "", text)
    return text.strip("\n")


def rows_of(constants):
    return [[code(c.key), code(c.value.strip('"')), c.standing or "-", escape(sentence(c.source))] for c in constants]


def tables_of(file, group):
    """A group's constants: a table for each part of it that has a comment of its own."""
    parts = []
    for constant in (c for c in file.constants if c.group == group):
        if constant.above or not parts:
            parts.append([])
        parts[-1].append(constant)
    out = ""
    for part in parts:
        out += paragraphs(part[0].above) if part[0].above else ""
        out += table(["key", "value", "standing", "source"], rows_of(part))
    return out


def groups_of(file):
    return list(dict.fromkeys(c.group for c in file.constants if c.group))


def machine_page(file):
    name = file.path.stem
    out = f"## {name}\n\n" + index(f"{name} (machine)")
    out += f"{escape(file.text('description'))} ({code('machines/' + file.path.name)}).\n\n"
    out += fence(head_of(file))
    for group in groups_of(file):
        out += f"### {name}: {group}\n\n"
        out += paragraphs(file.groups[group]) if file.groups[group] else ""
        out += tables_of(file, group)
    return out


GROUPS = ("topology", "node", "net", "system", "cfs", "host")


def in_microseconds(constant):
    """Its name and value, as microseconds if the file has nanoseconds."""
    name, value = constant.name, constant.value.strip('"')
    if re.search(r"_ns($|_per)", name):
        name, value = re.sub(r"_ns($|_per)", r"_us\1", name), format((Decimal(value) / 1000).normalize(), "f")
    return name, value


def side_by_side(files):
    """All machines in one table."""
    values = [dict(in_microseconds(c) for c in file.constants if c.group) for file in files]
    names = sorted(dict.fromkeys(name for v in values for name in v), key=lambda name: GROUPS.index(name.split(".")[0]))
    rows = [[code(name)] + [code(v.get(name, "")) or "-" for v in values] for name in names]
    return table(["key"] + [file.path.stem for file in files], rows)


def clocks_side_by_side(files):
    names = list(dict.fromkeys(c.name for file in files for c in file.constants if c.group == "clocks"))
    values = [{c.name: c.value for c in file.constants} for file in files]
    rows = [[code(name.split(".")[1])] + [code(v.get(name, "")) for v in values] for name in names]
    return table(["operation, clocks"] + [file.path.stem for file in files], rows)


def cpu_page(file):
    name = file.path.stem
    out = f"### {name}\n\n" + index(f"{name} (processor)")
    out += f"{escape(file.text('name'))} ({code('machines/cpu/' + file.path.name)}).\n\n" + fence(head_of(file))
    out += tables_of(file, "")
    for group in groups_of(file):
        out += f"#### {name}: {group}\n\n"
        out += paragraphs(file.groups[group]) if file.groups[group] else ""
        out += tables_of(file, group)
    return out


CALL = re.compile(r"\{ name = \"([^\"]+)\";([^}]*)\}")
SIDE_BY_SIDE = 4  # calls in a row, of those that have a number and nothing else


def of_what(values):
    """What a call's cost is multiplied by."""
    for key, which in ("elements", "elements of"), ("made", "elements made in"):
        if key in values:
            return f"{which} argument {values[key]}"
    of = values.get("of", "")
    return "the result" if of == "0" else f"argument {of}" if of.isdigit() else "arguments " + of.strip("( )").replace(", ", " x ") if of else ""


def call_groups(text):
    """The list of calls, by the comments that stand between them: [comment, [(name, values, comment beside it)]]."""
    groups = []
    for line in text[text.index("calls = (") :].splitlines()[1:]:
        if line.strip().startswith("#"):
            groups.append([re.sub(r" {3,}", "; ", line.strip("# ")), []])
        beside = line.rpartition("#")[2].strip() if "#" in line else ""
        for name, rest in CALL.findall(line):
            groups[-1][1].append((name, dict(re.findall(r"(\w+) = (\([^)]*\)|[^;]+);", rest)), beside))
    return groups


def plain_calls(calls):
    """Several calls a row: name, clocks, name, clocks ..."""
    cells = [cell for name, values, _ in calls for cell in (code(name), values["base"])]
    width = 2 * SIDE_BY_SIDE
    cells += [""] * (-len(cells) % width)
    return table(["call", "clocks"] * SIDE_BY_SIDE, [cells[i : i + width] for i in range(0, len(cells), width)]) if calls else ""


def other_calls(calls):
    rows = [[code(name), values["base"], values.get("per", ""), of_what(values), escape(sentence(beside))] for name, values, beside in calls]
    return table(["call", "clocks", "for each unit", "of", "source"], rows) if rows else ""


def calls_page(path):
    text = path.read_text()
    head = "\n".join(re.sub(r"^# ?", "", line) for line in text[: text.index("calls = (")].splitlines())
    out = "### Calls of the C and Fortran libraries\n\n" + index("library calls, cost of") + paragraphs(head)
    for comment, calls in call_groups(text):
        plain = [call for call in calls if set(call[1]) == {"base"} and not call[2]]
        out += f"{escape(sentence(comment))}:\n\n" + plain_calls(plain) + other_calls([call for call in calls if call not in plain])
    return out


# --- what was fitted ---


def strings_of(text, name):
    """The tuples of strings of a list, as ( "what", "settled by", "alternative" ... )."""
    body = re.search(r"^" + name + r" = \((.*?)^\);", text, re.S | re.M)[1]
    body = re.sub(r"^\s*#.*$", "", body, flags=re.M)
    tuples, depth = [], 0
    for token in re.findall(r'"[^"]*"|[()]', body):
        if token == "(":
            depth += 1
            tuples.append([])
        elif token == ")":
            depth -= 1
        elif depth:
            tuples[-1].append(token.strip('"'))
    return tuples


def fitted_page(path):
    text = path.read_text()
    head = re.search(r"^# Constants 1 to 3.*?(?=^factors)", text, re.S | re.M)[0]
    factors = re.findall(r'file = "([^"]+)";\s+factor = ([0-9.]+);\s+fitted_to = "([^"]+)"', text)
    out = "## What was fitted, and to what\n\n"
    out += index("fitted constants", "choices made with the paper's tables in view")
    out += "Five constants were fitted to figures of the paper's tables. Three are cost factors of the paper's program:\n\n"
    out += table(["source file", "cost factor", "fitted to"], [[code("app/" + file), code(factor), escape(to)] for file, factor, to in factors])
    out += fence("\n".join(re.sub(r"^# ?", "", line) for line in head.splitlines()))
    out += "The other two:\n\n"
    out += table(["constant", "fitted to", "tried instead"],
                 [[escape(t[0]), escape(t[1]), ", ".join(map(code, t[2:]))] for t in strings_of(text, "constants")])
    out += ("Besides, algorithms and policies were chosen that the paper leaves open, or that its tables confirm. "
            "A value in the last column was tried; bench/paper/CHOICES.md has the errors with it.\n\n")
    out += table(["choice", "settled by", "tried instead"],
                 [[escape(t[0]), escape(t[1]), ", ".join(map(code, t[2:])) or "-"] for t in strings_of(text, "policies")])
    return out


INTRODUCTION = """# Every constant, with its source

```{index} constants
```
```{index} standing of constants
```

This chapter is made from the machine files, the processor files and the list of what was fitted; so it has the numbers that the
simulator uses. The comment beside each number in these files says what its standing is, and where it comes from:

| standing | means |
|---|---|
| read | taken from a readable copy of the source named |
| known | widely quoted from the source named, whose table was not at hand |
| derived | arithmetic on other numbers |
| fitted | chosen so that figures of the named source come out |
| open | no figure was found: a choice, and what it rests on |

`touchstone run --set KEY=VALUE`, such as `--set net.short_hop_ns=50`, replaces a number for one run, and an axis of a study runs through
several ([what if?](what-if.md)). [The model](model.md) says what each key means.

## All machines side by side

"""


def page(root):
    machines = sorted((root / "machines").glob("*.cfg"))
    cpus = sorted(p for p in (root / "machines/cpu").glob("*.cfg") if p.stem != "i860-calls")
    files, processors = [read(p) for p in machines], [read(p) for p in cpus]
    out = INTRODUCTION + side_by_side(files) + fitted_page(root / "bench/paper/fitted.cfg")
    out += "".join(machine_page(file) for file in files)
    out += "## Processors\n\n" + index("processor files") + clocks_side_by_side(processors)
    out += "".join(cpu_page(file) for file in processors)
    return out + calls_page(root / "machines/cpu/i860-calls.cfg")
