"""offline.py - makes the HTML manual work from a file, without a server and without Debian's /javascript: furo's parts become one
script and one style, and the search gets the pages' texts in a script, since a page that is a file may not fetch other files."""
import html
import json
import pathlib
import re

STYLES = pathlib.Path("/usr/share/javascript")  # where @import url(/javascript/...) leads on a server of Debian


def bundle_script(scripts):
    """furo.js imports Gumshoe as a module, which a page that is a file may not do: it becomes a global, defined before."""
    furo, gumshoe = scripts / "furo.js", scripts / "gumshoe-patched.js"
    text, count = re.subn(r'^import Gumshoe from .*\n', "", furo.read_text(), flags=re.M)
    if count:
        furo.write_text(gumshoe.read_text() + text)
        gumshoe.unlink()


def bundle_style(style):
    """Puts what the style imports in its place."""
    style.write_text(re.sub(r"@import url\(/javascript/([^)]+)\);", lambda found: (STYLES / found[1]).read_text(), style.read_text()))


def write_texts(app, static):
    """The text of each page, by its address, in the form in which Sphinx's search reads pages."""
    texts = {app.builder.get_target_uri(name): f'<div role="main">{html.escape(app.env.get_doctree(name).astext())}</div>'
             for name in sorted(app.env.found_docs)}
    (static / "search_texts.js").write_text(f"const searchTexts = {json.dumps(texts, ensure_ascii=False, sort_keys=True)};\n")


def add_search(app, pagename, templatename, context, doctree):
    if pagename == "search":
        app.add_js_file("search_texts.js")
        app.add_js_file("search_file.js")


def finish(app, problem):
    if problem or app.builder.name != "html":
        return
    static = pathlib.Path(app.outdir) / "_static"
    if app.config.html_theme == "furo":
        bundle_script(static / "scripts")
        bundle_style(static / "styles/furo.css")
    write_texts(app, static)


def setup(app):
    app.connect("html-page-context", add_search)
    app.connect("build-finished", finish)
    return {"parallel_read_safe": True}
