"""markdown.py - text as MyST Markdown: escapes, tables, fences, entries of the index. For the generators beside this file."""
import re


def escape(text):
    """Text that Markdown shows as it is."""
    return re.sub(r"([\\`*_<>\[\]{}#|$~^])", r"\\\1", text)


def code(text):
    """Text as code within a sentence or a table's cell."""
    ticks = "``" if "`" in text else "`"
    space = " " if "`" in text else ""
    return ticks + space + text.replace("|", "\\|") + space + ticks if text else ""


def fence(text, language="text"):
    return f"```{language}\n{text.rstrip()}\n```\n"


def table(head, rows):
    """A table of cells that are Markdown already."""
    lines = [head, ["---"] * len(head)] + rows
    return "".join("| " + " | ".join(cell.replace("\n", " ") for cell in line) + " |\n" for line in lines) + "\n"


def index(*entries):
    """Entries of the index that lead here."""
    names = [entry.replace(";", ",") for entry in entries]
    return "```{index} " + names[0] + "\n```\n\n" if len(names) == 1 else "".join(index(name) for name in names)


def sentence(text):
    """With a capital letter at its start, if it begins with a word."""
    return re.sub(r"^[a-z]+(?=[ ,.:;]|$)", lambda word: word[0].capitalize(), text)
