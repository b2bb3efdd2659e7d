"""book.py - Sphinx builder "book": all pages as one file of HTML, book.html, for weasyprint to make the PDF of. It has a title page,
the contents and the index; book.css puts page numbers there.

Each page becomes a chapter. The name of the page comes before all ids of the page, so that ids of two pages differ, and links between
pages become links within the file."""
import datetime
import html
import os
import pathlib
import re

from sphinx.builders.html import StandaloneHTMLBuilder

TITLE = """<section class="title">
<h1>touchstone</h1>
<p class="subtitle">Programs for Intel's iPSC/860, Touchstone Delta and Paragon,<br>on simulated nodes, in exact virtual time</p>
<p class="edition">Manual of version {version}, {date}</p>
</section>
"""


def target(uri):
    """The id in the book to which a link of a page leads: page.html#id."""
    page, _, anchor = uri.partition("#")
    page = page.removesuffix(".html")
    return f"#{page}--{anchor}" if anchor else f"#{page}"


class BookBuilder(StandaloneHTMLBuilder):
    name = "book"
    epilog = "The book is in %(outdir)s."
    search = False
    allow_parallel = False

    def init(self):
        super().init()
        self.bodies, self.entries = {}, []

    def get_outdated_docs(self):
        return self.env.found_docs

    def handle_page(self, pagename, addctx, templatename="page.html", outfilename=None, event_arg=None):
        if pagename == "genindex":
            self.entries = addctx["genindexentries"]
        else:
            self.bodies[pagename] = addctx.get("body", "")

    def finish(self):
        self.gen_indices()
        self.copy_image_files()
        path = pathlib.Path(self.outdir) / "book.html"
        path.write_text(self.book())

    def book(self):
        seconds = int(os.environ.get("SOURCE_DATE_EPOCH", "0"))
        date = datetime.datetime.fromtimestamp(seconds, datetime.timezone.utc)
        title = TITLE.format(version=html.escape(self.config.version), date=date.strftime("%-d %B %Y"))
        contents = self.chapter("index").replace('class="chapter"', 'class="contents"')
        chapters = "".join(self.chapter(name) for name in self.env.toctree_includes["index"])
        style = pathlib.Path(__file__).with_name("book.css").read_text()
        colours = re.sub(r"(?m)^(?!\.highlight).*$", "", self.highlighter.get_stylesheet())
        return (f'<!doctype html><html lang="en"><head><meta charset="utf-8"><title>touchstone: manual</title>'
                f'<meta name="author" content="{html.escape(self.config.author)}">'
                f'<meta name="dcterms.created" content="{date.strftime("%Y-%m-%dT%H:%M:%SZ")}">'
                f"<style>{colours}{style}</style></head><body>\n{title}{contents}{chapters}{self.index()}</body></html>\n")

    def chapter(self, name):
        body = self.bodies[name]
        body = re.sub(r'<a class="headerlink".*?</a>', "", body)
        body = re.sub(r'\bid="([^"]+)"', rf'id="{name}--\1"', body)
        body = re.sub(r'\bhref="#([^"]+)"', rf'href="#{name}--\1"', body)
        body = re.sub(r'\bhref="([\w-]+\.html(?:#[^"]*)?)"', lambda found: f'href="{target(found[1])}"', body)
        return f'<section class="chapter" id="{name}">\n{body}</section>\n'

    def index(self):
        out = ""
        for letter, entries in self.entries:
            out += f"<h2>{html.escape(letter)}</h2>\n"
            for name, (links, within, _) in entries:
                out += self.entry(name, links, "")
                out += "".join(self.entry(each, its_links, " class=\"within\"") for each, its_links in within)
        return f'<section class="chapter index" id="genindex"><h1>Index</h1><div class="columns">{out}</div></section>'

    def entry(self, name, links, attributes):
        pages = ", ".join(f'<a href="{target(uri)}"></a>' for _, uri in links)
        return f"<p{attributes}>{html.escape(name)}{' ' if pages else ''}{pages}</p>\n"


def setup(app):
    app.add_builder(BookBuilder)
    return {"parallel_read_safe": True}
