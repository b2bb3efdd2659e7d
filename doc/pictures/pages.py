"""pages.py flame|page|surfaces FILE FOLDER - pictures of what touchstone draws for browsers, by headless Chromium."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests/page"))
from browser import Browser  # noqa: E402

kind, file, folder = sys.argv[1], str(pathlib.Path(sys.argv[2]).resolve()), pathlib.Path(sys.argv[3])


def shoot(b, name, width, height, word=None, dark=False, scale=1):
    """The top of the section whose heading has the word, or of the file."""
    b.resize(width, height, dark)
    b.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                             {"width": width, "height": height, "deviceScaleFactor": scale, "mobile": False})
    if word:
        b.run("""document.querySelector('nav').style.position = 'static';
            document.documentElement.style.scrollPaddingTop = 0;
            [...document.querySelectorAll('main > section')].find(s => s.querySelector('h2').textContent.includes(arguments[0]))
                .scrollIntoView({behavior: 'instant'})""", word)
    b.until("return new Promise(d => setTimeout(() => d(true), 1000))")  # drawn at the new size
    b.driver.save_screenshot(str(folder / f"{name}.png"))


def show_page(b):
    b.open(file)
    shoot(b, "page-tables", 1240, 580, "tables")
    canvas = "[...document.querySelectorAll('.plot canvas')].find(c => c.timeline)"
    b.run(f"const t = {canvas}.timeline, row = t.trace.rows[5]; t.select(5, t.trace.pieceAt(row, t.trace.stop / 3))")
    shoot(b, "page-timeline", 1240, 940, "Timeline")
    shoot(b, "page-phone", 360, 800, "Timeline", dark=True)


browser = Browser()
try:
    if kind == "flame":
        browser.driver.get("file://" + file)
        high = browser.run("return Math.ceil(document.documentElement.viewBox.baseVal.height || "
                           "document.documentElement.getBoundingClientRect().height)")
        shoot(browser, "profile-flame", 1200, high, scale=2)
    elif kind == "surfaces":
        browser.open(file)
        shoot(browser, "page-surfaces", 760, 860, "Surfaces")
    else:
        show_page(browser)
finally:
    browser.close()
