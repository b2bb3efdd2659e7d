"""schemas.py - the page of all keys of JSON files, from share/schemas/*.schema.json (JSON Schema 2020-12): a table for each schema,
and one for each of its definitions, with type and description of each key."""
import json
import re

from markdown import code, escape, index, sentence, table


def name_of(reference):
    """What a $ref refers to: a definition, or another schema, or a definition of that."""
    schema, _, path = reference.partition("#")
    definition = path.removeprefix("/$defs/")
    file = re.sub(r".*/schemas/([\w-]+)/\d+$", r"\1", schema)
    return " of ".join(filter(None, [definition, file]))


def named_by(pattern):
    """The keys that match a pattern such as ^files\\. as files.<name>."""
    return pattern.removeprefix("^").replace("\\.", ".") + "<name>" if re.fullmatch(r"\^[\w.\\]+", pattern) else f"<{pattern}>"


def choices(part):
    return [each for kind in ("anyOf", "oneOf", "allOf") for each in part.get(kind, [])]


def kind(part):
    """The type in words."""
    if "$ref" in part:
        return name_of(part["$ref"])
    if "const" in part:
        return json.dumps(part["const"])
    if "enum" in part:
        return ", ".join(json.dumps(value) for value in part["enum"])
    kinds = part.get("type", [])
    kinds = [kinds] if isinstance(kinds, str) else list(kinds)
    items = part.get("items")
    if "array" in kinds and isinstance(items, dict) and kind(items):
        kinds[kinds.index("array")] = "list of " + kind(items)
    return " or ".join(dict.fromkeys(kinds + [kind(each) for each in choices(part)]))


def row(path, part, needed):
    words = [escape(sentence(part.get("description", "")))] + ([f"({escape(part['unit'])})"] if "unit" in part else [])
    return [code(path), escape(kind(part)), " ".join(filter(None, words + ([] if needed else ["*Optional.*"])))]


def rows_of(part, path=""):
    """The rows of all keys within a part of a schema, whose own path is given."""
    rows = []
    prefix = path + "." if path else ""
    members = [(key, value, key in part.get("required", [])) for key, value in part.get("properties", {}).items()]
    members += [(named_by(pattern), value, True) for pattern, value in part.get("patternProperties", {}).items()]
    if isinstance(part.get("additionalProperties"), dict):
        members.append(("<name>", part["additionalProperties"], True))
    for key, value, needed in members:
        rows.append(row(prefix + key, value, needed))
        rows += rows_of(value, prefix + key)
    for inner in [part.get("items")] + part.get("prefixItems", []):
        rows += rows_of(inner, path + "[]") if isinstance(inner, dict) else []
    for each in choices(part):
        rows += rows_of(each, path)
    return [each for i, each in enumerate(rows) if each not in rows[:i]]


def definition(name, part):
    """What a schema calls by a name."""
    said = escape(sentence(part.get("description", "")))
    rows = rows_of(part)
    what = "" if rows and part.get("type") == "object" else f" ({escape(kind(part))})" if kind(part) else ""
    return f"**{escape(name)}**{what}{': ' + said if said else ''}\n\n" + (table(["key", "type", "what it is"], rows) if rows else "")


def section(path):
    schema = json.loads(path.read_text())
    name = path.name.removesuffix(".schema.json")
    out = f"## {escape(schema.get('title', name))}\n\n" + index(f"{name} (JSON)", f"JSON, {name}")
    out += f"{escape(schema.get('description', ''))} The schema is {code('share/schemas/' + path.name)}.\n\n"
    rows = rows_of(schema)
    if rows:
        out += table(["key", "type", "what it is"], rows)
    else:
        out += f"It is {escape(kind(schema))}:\n\n"
    return out + "".join(definition(each, part) for each, part in schema.get("$defs", {}).items())


INTRODUCTION = """# Keys of JSON files

```{index} JSON
```

This chapter is made from the schemas in share/schemas (JSON Schema 2020-12), which the tests hold against the files that the commands
write. `a.b` is the key b of the object a; `a[].b` is the key b of each object of the list a; `<name>` stands for any name. A type such
as *node* is one of the tables that follow; *race of races* is that of the schema races.

"""


def schemas_of(root):
    return sorted((root / "share/schemas").glob("*.schema.json"))


def page(root):
    return INTRODUCTION + "".join(section(path) for path in schemas_of(root))
