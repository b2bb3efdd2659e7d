"""stage.py BUILD SOURCE - puts all of the manual's pages into the folder SOURCE, as Sphinx reads them: those of doc/manual, the
long pages of doc, reports of bench, and the pages that are made from machine files, headers, --help of BUILD's programs, and schemas.

All pages lie in one folder. A link to another page of the manual leads there; one to a file that is not part of the manual becomes
the file's name. A line "<!-- include: bench/paper/REPORT.md ## How exact -->" stands for that section of that file."""
import pathlib
import re
import shutil
import sys

import calls
import commands
import constants
import schemas
from markdown import index

ROOT = pathlib.Path(__file__).resolve().parents[3]

# Pages from elsewhere than doc and doc/manual, and what they are called here.
OTHERS = {
    "bench/paper/REPORT.md": "paper-report.md",
    "bench/paper/CHOICES.md": "paper-choices.md",
    "bench/paper/README.md": "paper-program.md",
    "bench/machine/REPORT.md": "machine-report.md",
    "bench/speed/NOTES.md": "speed-notes.md",
}
LEFT_OUT = {"house.md"}  # for those who change touchstone
LANGUAGES = {"c", "sh", "console", "fortran", "json", "python", "make", "text", "yaml"}  # others are shown without colours


def pages():
    """Each page's file, by its path from the root, and its name in the manual."""
    found = {f"doc/{path.name}": path.name for path in sorted((ROOT / "doc").glob("*.md")) if path.name not in LEFT_OUT}
    found.update({f"doc/manual/{path.name}": path.name for path in sorted((ROOT / "doc/manual").glob("*.md"))})
    found.update(OTHERS)
    return found


PAGES = pages()
MADE = {"constants.md", "commands.md", "calls.md", "json.md"}


def outside_of_code(text, change):
    """Applies a change to what stands outside of fenced code."""
    parts = re.split(r"(^```.*?^```$)", text, flags=re.S | re.M)
    return "".join(part if part.startswith("```") else change(part) for part in parts)


def section_of(path, heading):
    """A section of a file: from its heading, which is left out, to the next of its level or above."""
    text = (ROOT / path).read_text()
    level = len(heading) - len(heading.lstrip("#"))
    found = re.search(rf"^{re.escape(heading)}\n(.*?)(?=^#{{1,{level}}} |\Z)", text, re.S | re.M)
    if not found:
        sys.exit(f"doc/manual: {path} has no section '{heading}'")
    return found[1].strip("\n")


def included(text):
    """The text with the sections that it includes, links and all."""
    def replace(found):
        path, heading = found[1], found[2]
        return links(section_of(path, heading), path)
    return re.sub(r"^<!-- include: (\S+) (#+ .*?) -->$", replace, text, flags=re.M)


def link_from(path):
    """How a link that stands in a file of that path becomes one of the manual's."""
    folder = (ROOT / path).parent

    def replace(found):
        picture, label, target = found[1], found[2], found[3]
        if re.match(r"[a-z]+:", target) or target.startswith("#"):
            return found[0]
        file, _, anchor = target.partition("#")
        if file in MADE:
            return found[0]
        there = (folder / file).resolve()
        name = str(there.relative_to(ROOT))
        if picture:
            return f"![{label}]({pictures_name(name)})"
        if name == "README.md":
            return f"[{label}](index.md)"
        if name in PAGES:
            return f"[{label}]({PAGES[name]}{'#' + anchor if anchor else ''})"
        return label if name in label else f"{label} (`{name}`)"
    return replace


def pictures_name(path):
    return "pictures/" + path.removeprefix("doc/pictures/").replace("/", "-")


def links(text, path):
    return outside_of_code(text, lambda part: re.sub(r"(!?)\[([^\]]*)\]\(([^)\s]+)\)", link_from(path), part))


def languages(text):
    return re.sub(r"^```(\w+)$", lambda found: "```" + (found[1] if found[1] in LANGUAGES else "text"), text, flags=re.M)


def glossary(text):
    """The first cell of each row is an entry of the index."""
    def replace(found):
        word = found[1].strip()
        entry = word.rstrip(" *")
        return "| {index}`" + entry + " <single: " + entry + ">`" + (" \\*" if word.endswith("*") else "") + " |" if entry not in ("term", "---") else found[0]
    return re.sub(r"^\| ?([^|]*?) ?\|", replace, text, flags=re.M)


# Entries of the index for pages that have none in their text: they are for readers of plain Markdown, too.
ENTRIES = {
    "asan.md": ["out of bounds", "AddressSanitizer"],
    "cluster.md": ["MPI", "cluster", "mpirun"],
    "deadlocks.md": ["deadlock", "wait-for graph"],
    "debugger.md": ["debugger", "gdb", "SIGUSR1"],
    "exercises.md": ["exercises", "latency", "bandwidth"],
    "exercises-solutions.md": ["solutions of the exercises"],
    "explore.md": ["exploration of timings"],
    "host-programs.md": ["host programs", "System Resource Manager"],
    "livelock.md": ["livelock"],
    "mpi-programs.md": ["MPI programs", "mpicc", "mpif90"],
    "old-programs.md": ["old programs", "Fortran", "K&R C"],
    "page.md": ["HTML page of results"],
    "profile.md": ["profile", "flame graph"],
    "races.md": ["races"],
    "replay.md": ["recording a run", "replaying a run"],
    "schedule-format.md": ["schedule file"],
    "serve.md": ["server of results"],
    "surface-files.md": ["PLY files"],
    "surfaces.md": ["surfaces", "pictures of surfaces"],
    "time.md": ["time, rules of", "reference engine", "proof"],
    "trace-export.md": ["Perfetto", "Paje", "OTF2", "PICL", "CSV of a trace"],
    "trace-format.md": ["trace file"],
    "trace-show.md": ["pictures of a run", "Gantt chart"],
    "trace-why.md": ["critical path"],
    "tutorial.md": ["tutorial", "Jacobi's method"],
    "what-if.md": ["studies", "baseline", "fit of a machine to measurements"],
    "when-it-hangs.md": ["hangs"],
    "paper-report.md": ["accuracy", "tables of the paper"],
    "paper-choices.md": ["choices, effects of"],
    "paper-program.md": ["model program"],
    "machine-report.md": ["microbenchmarks"],
    "speed-notes.md": ["speed"],
}


def with_entries(text, name):
    heading, _, rest = text.partition("\n")
    return heading + "\n\n" + "".join("```{index} " + entry + "\n```\n" for entry in ENTRIES.get(name, [])) + rest


def index_comments(text):
    """<!-- index: one; another --> becomes entries of the index."""
    return re.sub(r"^<!-- index: (.*?) -->$", lambda found: "\n" + index(*re.split(r"; *", found[1])).strip() + "\n", text, flags=re.M)


def as_page(path, name):
    text = index_comments(included(links((ROOT / path).read_text(), path)))
    text = re.sub(r"^<!--.*?-->\n", "", text, flags=re.M)
    return with_entries(languages(glossary(text) if name == "glossary.md" else text), name)


def chapters(text):
    """The list of contents with the pages of doc that no part names, as its last part."""
    named = re.findall(r"^([a-z][\w-]*)$", text, re.M)
    more = [name.removesuffix(".md") for name in PAGES.values() if name != "index.md" and name.removesuffix(".md") not in named]
    known = {name.removesuffix(".md") for name in list(PAGES.values()) + list(MADE)}
    missing = [name for name in named if name not in known]
    if missing:
        sys.exit("doc/manual/index.md: there is no page " + ", ".join(missing))
    if more:
        text += "\n```{toctree}\n:maxdepth: 2\n:caption: More\n\n" + "\n".join(more) + "\n```\n"
    return text


def copy_pictures(source):
    """All pictures that pages show."""
    for path in PAGES:
        text = re.sub(r"^```.*?^```$", "", (ROOT / path).read_text(), flags=re.S | re.M)
        for target in re.findall(r"!\[[^\]]*\]\(([^)\s]+)\)", text):
            picture = ((ROOT / path).parent / target).resolve()
            to = source / pictures_name(str(picture.relative_to(ROOT)))
            to.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(picture, to)


def main(build, source):
    shutil.rmtree(source, ignore_errors=True)
    source.mkdir(parents=True)
    for path, name in PAGES.items():
        text = as_page(path, name)
        (source / name).write_text(chapters(text) if name == "index.md" else text)
    (source / "constants.md").write_text(constants.page(ROOT))
    (source / "calls.md").write_text(calls.page(ROOT))
    (source / "commands.md").write_text(commands.page(build))
    (source / "json.md").write_text(schemas.page(ROOT))
    copy_pictures(source)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]))
