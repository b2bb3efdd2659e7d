"""schemas.py - the page of all keys of JSON files, from share/schemas/*.schema.json (JSON Schema 2020-12): each with its type and
its description."""
import json

from markdown import code, escape, index, sentence, table


class Schema:
    """A schema's keys, as rows of a table."""

    def __init__(self, schema):
        self.root, self.rows, self.open = schema, [], []
        self.keys(schema, "")

    def resolved(self, part):
        """What a part says, and what it refers to; its own words win."""
        while "$ref" in part:
            target = self.root
            for step in part["$ref"].removeprefix("#/").split("/"):
                target = target[step.replace("~1", "/").replace("~0", "~")] if step != "#" else target
            part = {**target, **{key: value for key, value in part.items() if key != "$ref"}}
        return part

    def alternatives(self, part):
        return [self.resolved(each) for kind in ("anyOf", "oneOf", "allOf") for each in part.get(kind, [])]

    def kind(self, part):
        """The type in words."""
        part = self.resolved(part)
        if "const" in part:
            return json.dumps(part["const"])
        if "enum" in part:
            return ", ".join(json.dumps(value) for value in part["enum"])
        kind = part.get("type")
        kinds = kind if isinstance(kind, list) else [kind] if kind else []
        if "array" in kinds and isinstance(part.get("items"), dict):
            of = self.kind(part["items"])
            kinds = ["array of " + of if each == "array" and of and len(of) < 40 else each for each in kinds]
        kinds += [self.kind(each) for each in self.alternatives(part)]
        return " or ".join(dict.fromkeys(each for each in kinds if each))

    def row(self, path, part, needed):
        words = escape(sentence(part.get("description", "")))
        self.rows.append([code(path), escape(self.kind(part)), words if needed else words + (" " if words else "") + "(optional)"])

    def keys(self, part, path):
        """Adds the keys within a part of the schema, whose own path is given."""
        reference = part.get("$ref")
        if reference in self.open:
            return  # it holds itself
        self.open.append(reference) if reference else None
        part = self.resolved(part)
        for key, value in part.get("properties", {}).items():
            self.member(f"{path}.{key}" if path else key, value, key in part.get("required", []))
        for pattern, value in part.get("patternProperties", {}).items():
            self.member(f"{path}.<{pattern}>" if path else f"<{pattern}>", value, True)
        if isinstance(part.get("additionalProperties"), dict):
            self.member(f"{path}.<name>" if path else "<name>", part["additionalProperties"], True)
        for inner in [part.get("items")] + part.get("prefixItems", []):
            if isinstance(inner, dict):
                self.keys(inner, path + "[]")
        for each in [e for kind in ("anyOf", "oneOf", "allOf") for e in part.get(kind, [])]:
            self.keys(each, path)
        self.open.pop() if reference else None

    def member(self, path, value, needed):
        self.row(path, self.resolved(value), needed)
        self.keys(value, path)


def section(path):
    schema = json.loads(path.read_text())
    name = path.name.removesuffix(".schema.json")
    found = Schema(schema)
    rows = [row for i, row in enumerate(found.rows) if row not in found.rows[:i]]
    return (f"## {escape(schema.get('title', name))}\n\n" + index(f"{name} (JSON)", f"JSON, {name}") +
            f"{escape(schema.get('description', ''))} The schema is {code('share/schemas/' + path.name)}.\n\n" +
            table(["key", "type", "what it is"], rows))


INTRODUCTION = """# Keys of JSON files

```{index} JSON
```

This chapter is made from the schemas in share/schemas (JSON Schema 2020-12), which the tests hold against the files that the commands
write. `a.b` is the key b of the object a; `a[].b` is the key b of each object of the list a; `<name>` stands for any name.

"""


def schemas_of(root):
    return sorted((root / "share/schemas").glob("*.schema.json"))


def page(root):
    return INTRODUCTION + "".join(section(path) for path in schemas_of(root))
