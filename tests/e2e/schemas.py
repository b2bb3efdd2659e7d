"""schemas.py FOLDER LIST [KEY...] - are the schemas of the folder what they should be: a description for every key, no open object,
a name that is the file's? LIST has lines of NAME FILE PATH..., with tabs between them: is the JSON file as the schema of that name
says? With paths ("." the whole, "node.0" the first of the list node): does the object there fail with an unknown key more, and
without some key? And is each key of the schemas in some of the files, but for KEY... (regular expressions)?
Prints "ok ..." or "not ok ..." for each."""
import copy
import json
import os
import re
import sys
import warnings

warnings.simplefilter("ignore", DeprecationWarning)
import jsonschema  # noqa: E402

ENDING = ".schema.json"


def load_all(folder):
    names = [f[: -len(ENDING)] for f in sorted(os.listdir(folder)) if f.endswith(ENDING)]
    return {name: json.load(open(os.path.join(folder, name + ENDING))) for name in names}


def validator(schemas, name):
    store = {schema["$id"]: schema for schema in schemas.values()}
    resolver = jsonschema.RefResolver.from_schema(schemas[name], store=store)
    return jsonschema.Draft202012Validator(schemas[name], resolver=resolver)


def objects(schema, at):
    """All schemas within a schema, with their paths."""
    yield at, schema
    for key in ("properties", "patternProperties", "$defs"):
        for name, part in schema.get(key, {}).items():
            yield from objects(part, f"{at}/{key}/{name}")
    for key in ("items", "additionalProperties"):
        if isinstance(schema.get(key), dict):
            yield from objects(schema[key], f"{at}/{key}")
    for i, part in enumerate(schema.get("oneOf", [])):
        yield from objects(part, f"{at}/oneOf/{i}")


def faults(schemas, name):
    """What is wrong with a schema itself."""
    schema = schemas[name]
    jsonschema.Draft202012Validator.check_schema(schema)
    version = schema["$id"].rsplit("/", 1)[1]
    if schema["$id"] != f"https://touchstone.invalid/schemas/{name}/{version}" or not schema.get("title"):
        yield "$id or title"
    const = schema.get("properties", {}).get("format", {}).get("const")
    if const and const != f"touchstone {name} {version}":
        yield f"format {const}"
    for at, part in objects(schema, ""):
        if not part.get("description", "").endswith("."):
            yield f"{at}: no description"
        if "properties" in part and "additionalProperties" not in part:
            yield f"{at}: other keys are allowed"
        if not {"type", "enum", "const", "$ref", "oneOf"} & set(part):
            yield f"{at}: anything is allowed"
        if "$ref" in part:
            try:
                validator(schemas, name).resolver.resolve(part["$ref"])
            except jsonschema.RefResolutionError as error:
                yield f"{at}: {error}"


def part_of(data, path):
    for step in path.split(".") if path != "." else []:
        data = data[int(step) if isinstance(data, list) else step]
    return data


def changed(data, path):
    """Copies with one change each, and what it is."""
    copied = copy.deepcopy(data)
    part_of(copied, path)["unknown key"] = {}  # no figure of a program has such a value
    yield "an unknown key", copied
    for key in part_of(data, path):
        copied = copy.deepcopy(data)
        del part_of(copied, path)[key]
        yield f"without {key}", copied


class Keys:
    """Which keys of schemas occur in files."""

    def __init__(self, schemas):
        self.schemas = {schema["$id"]: schema for schema in schemas.values()}
        self.seen = set()

    def resolve(self, part, root):
        while "$ref" in part:
            name, _, pointer = part["$ref"].partition("#")
            part = root = self.schemas[name] if name else root
            for step in pointer.split("/")[1:]:
                part = part[step]
        return part, root

    def see(self, part, root, value):
        part, root = self.resolve(part, root)
        for kind in part.get("oneOf", []):
            required = self.resolve(kind, root)[0].get("required", [])
            if isinstance(value, list) or set(required) <= set(value):
                self.see(kind, root, value)
        for key, inner in value.items() if isinstance(value, dict) else ():
            if key in part.get("properties", {}):
                self.seen.add((id(part), key))
                self.see(part["properties"][key], root, inner)
            elif isinstance(part.get("additionalProperties"), dict):
                self.see(part["additionalProperties"], root, inner)
        for inner in value if isinstance(value, list) and "items" in part else ():
            self.see(part["items"], root, inner)

    def unseen(self):
        for root in self.schemas.values():
            for at, part in objects(root, root["$id"].split("/")[-2]):
                for key in part.get("properties", {}):
                    if (id(part), key) not in self.seen:
                        yield f"{at}/{key}"


def tell(good, what, why=()):
    print("ok" if good else "not ok", what)
    for line in why:
        print("#", line[:400])


def check_file(schemas, name, file, paths):
    check = validator(schemas, name)
    data = json.load(open(file))
    errors = [f"{'/'.join(map(str, e.absolute_path))}: {e.message}" for e in check.iter_errors(data)]
    tell(not errors, f"{name}: {file} is as described", errors)
    for path in paths:
        passed = [what for what, copied in changed(data, path) if check.is_valid(copied)]
        tell("an unknown key" not in passed, f"{name}: an unknown key at {path} fails")
        tell(len(passed) < len(part_of(data, path)), f"{name}: without a required key of {path} it fails")
    return data


def main(folder, samples, *never):
    schemas = load_all(folder)
    keys = Keys(schemas)
    for name in schemas:
        found = list(faults(schemas, name))
        tell(not found, f"{name}: the schema describes every key", found)
    for line in open(samples).read().splitlines():
        name, file, *paths = line.split("\t")
        try:
            keys.see(schemas[name], schemas[name], check_file(schemas, name, file, paths))
        except (OSError, ValueError, KeyError, IndexError) as error:
            tell(False, f"{name}: {file} {paths}", [repr(error)])
    short = (key.replace("/properties", "").replace("/$defs", "").replace("/items", "") for key in keys.unseen())
    left = [key for key in sorted(short) if not any(re.fullmatch(one, key) for one in never)]
    tell(not left, "each key of each schema has been written", left)


main(*sys.argv[1:])
