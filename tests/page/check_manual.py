"""check_manual.py FOLDER - opens the manual's HTML from files, as a reader does: prints "ok RULE" or "not ok RULE", as tests/run
reads it."""
import sys

from browser import Browser

folder = sys.argv[1]


def rule(name, holds, why=""):
    print(("ok " if holds else "not ok ") + name + ("" if holds else f" ({why})"), flush=True)


def opened(b, page, until):
    b.driver.get(f"file://{folder}/{page}")
    return b.until(until)


b = Browser()
try:
    text = opened(b, "index.html", "return document.querySelector('article')?.textContent")
    rule("the manual's first page says what touchstone is", "runs parallel programs unmodified on simulated nodes" in text, text[:200])
    theme = "return document.body.dataset.theme"
    before = b.run(theme)
    b.run("document.querySelector('.theme-toggle').click()")
    rule("the theme's script works", b.run(theme) != before, before)
    opened(b, "calls.html", "return document.title")
    extract = opened(b, "search.html?q=masktrap", "return [...document.querySelectorAll('#search-results .context')].map(e => e.textContent)")
    rule("the search shows extracts", any("masktrap" in e for e in extract), extract[:3])
    said = [m for m in b.said() if "Changed to" not in m]  # the theme says so
    rule("no page has an error", not said, said[:3])
    asked = {u for u in b.requests() if not u.startswith((f"file://{folder}/", "data:"))}
    rule("nothing is fetched but the manual's files", not asked, sorted(asked)[:3])
finally:
    b.close()
