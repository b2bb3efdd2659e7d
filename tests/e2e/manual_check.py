"""manual_check.py ROOT SOURCE BUILD - is everything in the pages of the manual that are made (SOURCE, by doc/manual/pages)? "ok" or
"not ok" for each kind. What is to be there is read from machine files, --help, headers, schemas and glossary once more, in the
simplest way."""
import json
import pathlib
import re
import subprocess
import sys

root, source, build = map(pathlib.Path, sys.argv[1:])


def say(what, found, missing):
    """found: how many there are in all, which must be some."""
    if missing or not found:
        print(f"not ok {what}: {len(missing)} of {found} are missing: " + ", ".join(map(str, missing[:20])))
    else:
        print(f"ok {what} ({found})")


def section(page, title):
    """A section of a page, to the next heading of its level."""
    text = (source / page).read_text()
    return re.search(rf"^(#+) {re.escape(title)}\n(.*?)(?=^\1 |\Z)", text, re.S | re.M)[2]


def assignments(path):
    """(key, value) of all lines of a machine or cpu file and of what it includes, but for lists."""
    text = re.sub(r'@include "(.*)"', lambda found: (path.parent / found[1]).read_text(), path.read_text())
    text = re.sub(r"#.*", "", text).split("calls = (")[0]
    return re.findall(r"\b([a-z_]+)\s*=\s*([^;{}()\s][^;{}()]*?)\s*;", text)


def constants():
    files = [(p, p.stem) for p in sorted((root / "machines").glob("*.cfg"))]
    files += [(p, p.stem) for p in sorted((root / "machines/cpu").glob("*.cfg")) if p.stem != "i860-calls"]
    found, missing = 0, []
    for path, title in files:
        made = section("constants.md", title)
        for key, value in assignments(path):
            found += 1
            said = re.search(rf"^\| `{key}` \| `{re.escape(value.strip(chr(34)))}` \| (\S+) \|", made, re.M)
            if key not in ("name", "description") and (not said or (said[1] == "-" and key not in ("kind", "cpu"))):
                missing.append(f"{title}.{key}")
    say("each constant has a row with its value and its standing", found, missing)
    calls = re.findall(r'name = "([^"]+)"', (root / "machines/cpu/i860-calls.cfg").read_text())
    made = section("constants.md", "Processors")
    say("each library call has its cost", len(calls), [call for call in calls if f"| `{call}` |" not in made])
    text = re.sub(r"(?m)^\s*#.*$", "", (root / "bench/paper/fitted.cfg").read_text())
    fitted = [re.sub(r"([\\`*_<>\[\]{}#|$~^])", r"\\\1", what) for what in re.findall(r'^    \( "([^"]+)"', text, re.M)]
    fitted += re.findall(r"factor = ([0-9.]+)", text)
    made = section("constants.md", "What was fitted, and to what")
    say("each fitted constant and choice is there", len(fitted), [what for what in fitted if what not in made])


def keys_are_explained():
    """Each key of a machine file is in the chapter that says what it does, or in that of formats."""
    model, formats = (root / "doc/manual/model.md").read_text(), (root / "doc/manual/formats.md").read_text()
    keys = {key for path in (root / "machines").glob("*.cfg") for key, _ in assignments(path)}
    bare = {re.sub(r"_(us|ns)(_per_byte)?$", "", key) for key in keys}
    say("each key of a machine file is in the chapter on formats", len(bare), [k for k in bare if f"`{k}`" not in formats])
    inside = bare - {"name", "description", "cpu", "clock_mhz", "hwclock_mhz"}
    say("each key of a machine file is explained by the model", len(inside), [k for k in inside if not re.search(rf"\b{k}", model)])


def help_of(words):
    return subprocess.run(words + ["--help"], stdout=subprocess.PIPE, text=True, check=True).stdout


def options():
    touchstone = str(build / "touchstone")
    names = re.findall(r"^  ([a-z]+)  ", help_of([touchstone]), re.M)
    commands = [[touchstone, name] for name in names] + [[touchstone, "trace", name] for name in ("info", "show", "export", "why")]
    found, missing = 0, []
    for words in commands + [[str(build / "nxcc")]]:
        title = " ".join(["touchstone"] + words[1:]) if words[1:] else "nxcc, nxf77"
        made = section("commands.md", title)
        for option in re.findall(r"^ {2,6}(?:-\w, )?(-[\w-]+)", help_of(words), re.M):
            if option in ("-h", "--usage", "--help", "--version"):
                continue
            found += 1
            if not re.search(rf"^```\{{option\}}.*(^|[ ,]){re.escape(option)}\b", made, re.M):
                missing.append(f"{title} {option}")
    say("each option of each command is there", found, missing)


def calls():
    made = (source / "calls.md").read_text()
    definitions = "".join((root / "nx_api" / name).read_text() for name in ("contract/calls.def", "common/reductions.def"))
    names = re.findall(r"^(?:NX_[A-Z]*|REDUCTION)\(([a-z_0-9]+)", definitions, re.M)
    names = [name for name in names if name not in ("nx_gopen_one", "handler")]  # gopen's own; served, but not declared
    say("each call is in the index", len(names), [name for name in names if "```{index} " + name + " (NX)" not in made])


def glossary():
    made = (source / "glossary.md").read_text()
    rows = re.findall(r"^\| ([^|]+?)(?: \*)? \|", (root / "doc/glossary.md").read_text(), re.M)
    words = [word for word in rows if word not in ("term", "---")]
    say("each word of the glossary is in the index", len(words), [word for word in words if f"<single: {word}>" not in made])


def keys_of(schema):
    """All names of properties, at any depth."""
    inner = list(schema.get("properties", {}).values()) + list(schema.get("$defs", {}).values())
    inner += [schema[kind] for kind in ("items", "additionalProperties") if isinstance(schema.get(kind), dict)]
    return set(schema.get("properties", {})).union(*map(keys_of, inner))


def json_keys():
    found, missing = 0, []
    for path in sorted((root / "share/schemas").glob("*.schema.json")):
        schema = json.loads(path.read_text())
        keys, made = keys_of(schema), section("json.md", schema["title"])
        found += len(keys)
        missing += [f"{path.name}: {key}" for key in sorted(keys) if not re.search(rf"^\| `([^`]*\.)?{re.escape(key)}` \|", made, re.M)]
    say("each key of a schema is in its section", found, missing)


constants()
keys_are_explained()
options()
calls()
glossary()
json_keys()
