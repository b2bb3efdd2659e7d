"""links.py FILE.md... - do all links between pages lead somewhere? "ok" or "not ok ..." for each page: a file that is linked must be
there, and a heading that is named after # must be in it."""
import pathlib
import re
import sys

CODE = re.compile(r"^```.*?^```|`[^`\n]*`", re.S | re.M)


def slug(heading):
    """The anchor of a heading, as GitHub and MyST make it."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)|`", r"\1", heading).strip().lower()
    return re.sub(r"[^\w\- ]", "", text).replace(" ", "-")


def anchors(path):
    """Those of all headings; a second heading of the same words has -1 behind it."""
    found = []
    text = re.sub(r"^```.*?^```", "", path.read_text(), flags=re.S | re.M)
    for heading in re.findall(r"^#{1,6} (.*)$", text, re.M):
        name = slug(heading)
        count = sum(1 for each in found if each == name or re.fullmatch(re.escape(name) + r"-\d+", each))
        found.append(f"{name}-{count}" if count else name)
    return found


def wrong(page, made):
    """The links of a page that lead nowhere. `made`: pages that are made when the manual is."""
    for target in re.findall(r"\]\(([^)\s]+)\)", CODE.sub("", page.read_text())):
        if re.match(r"[a-z]+:", target):
            continue
        file, _, anchor = target.partition("#")
        there = (page.parent / file).resolve() if file else page
        if file in made:
            continue
        if not there.exists():
            yield f"{target}: there is no such file"
        elif anchor and there.suffix == ".md" and anchor not in anchors(there):
            yield f"{target}: there is no such heading"


def main(paths):
    made = {"constants.md", "commands.md", "calls.md", "json.md"}
    for page in map(pathlib.Path, paths):
        found = list(wrong(page, made if page.resolve().parent.name == "manual" else set()))
        print(f"not ok links of {page}: " + "; ".join(found) if found else f"ok links of {page.name}")


main(sys.argv[1:])
