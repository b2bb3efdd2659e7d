"""check_live.py ADDRESS [PICTURE] - uses the page of a touchstone serve in a browser as a person does: prints "ok RULE" or
"not ok RULE", as tests/run reads it. The study is that of try_server.py. PICTURE: a file for a screenshot."""
import os
import sys

from selenium.common.exceptions import WebDriverException
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)) + "/../page")
from browser import Browser # noqa: E402

address = sys.argv[1]


rules = []


def rule(name, holds, why=""):
    rules.append(("ok " if holds else "not ok ") + name + ("" if holds else f" ({why})"))


def field(b, axis):
    return b.driver.find_element(By.CSS_SELECTOR, f'.live [name="axis {axis}"]')


def fill(b, **values):
    for name, value in values.items():
        f = field(b, name)
        if f.tag_name == "select":
            f.send_keys(value)
        else:
            f.clear()
            f.send_keys(value)


def main(b, nodes):
    b.driver.get(address)
    markers = "return document.querySelectorAll('main svg g[data-series] path[transform]').length"
    before = b.until(markers)
    rule("the study is shown", "Groups" in b.run("return document.querySelector('main').textContent"))
    rule("the page is called by it", b.until("return document.querySelector('h1').textContent === 'Groups' && document.title.startsWith('Groups')"))
    rule("with what its speed-ups compare with", b.until("return document.querySelector('main').textContent.includes('Baseline of speed-ups: nodes ')"))
    rule("with its progress", "points" in b.run("return document.querySelector('.live [role=status]').textContent"))
    choice = "[...document.querySelectorAll('main .controls select')].find(s => s.parentElement.textContent.startsWith('Figure'))"
    b.run(f"const s = {choice}; s.value = 'total_s'; s.dispatchEvent(new Event('change'))")
    b.run("document.querySelector('.live summary').click()")
    rule("a form has a field for each axis", b.until("return document.querySelectorAll('.live [name]').length === 4"))
    fill(b, nodes=str(nodes), share="0.5", case="short")
    field(b, "nodes").send_keys(Keys.ENTER)
    rule("a point joins the curve", b.until(f"return document.querySelectorAll('.runs [data-state=done]').length && ({markers[7:]}) > {before}"))
    rule("the figure is the one chosen before", b.run(f"return {choice}.value") == "total_s")
    rule("the form is open as before", field(b, "nodes").is_displayed() and field(b, "nodes").get_attribute("value") == str(nodes))
    rule("the keyboard is where it was", b.run("return document.activeElement.name") == "axis nodes",
         b.run("return document.activeElement.outerHTML.slice(0, 80)"))
    rings = "document.querySelectorAll('main svg g[data-series] circle.marked').length"
    rule("with a ring around it", b.run("return " + rings) > 0)
    b.run("document.querySelector('.live [name=set]').value = 'node.clock_mhz=20'")
    field(b, "nodes").send_keys(Keys.ENTER)
    b.until("return document.querySelectorAll('.runs [data-state=done]').length === 2")
    held = """[...document.querySelectorAll('main .controls select')].find(s => s.parentElement.textContent.startsWith('set'))
        ?.selectedOptions[0].text"""
    rule("a point that was run is seen, whatever axes were held at", b.until(f"return ({held}) === 'node.clock_mhz=20' && {rings} === 1"))
    rule("the study's own points are named beside it", b.run("""return [...document.querySelectorAll('main .controls select')]
        .find(s => s.parentElement.textContent.startsWith('set')).options[0].text""") == "as in the study")
    b.run("document.querySelector('.live [name=set]').value = ''")
    fill(b, nodes="many")
    field(b, "nodes").send_keys(Keys.ENTER)
    rule("a mistake is said", "nodes: a number is needed" in
         b.until("return document.querySelector('.live [role=alert]').textContent"))
    fill(b, nodes="2", case="long")
    field(b, "nodes").send_keys(Keys.ENTER)
    b.until("return document.querySelector('.runs [data-state=running] button')")
    if len(sys.argv) > 2:
        b.driver.save_screenshot(sys.argv[2])
    b.run("document.querySelector('.runs [data-state=running] button').click()")
    rule("a run is stopped", b.until("return document.querySelector('.runs [data-state=stopped]')") is not None)
    asked = [url for url in b.requests() if not url.startswith(address.split("/?")[0]) and url[:5] not in ("data:", "blob:")]
    rule("nothing was asked of others", not asked, asked)
    b.resize(360)
    wide = b.run("return document.documentElement.scrollWidth")
    rule("360 pixels are enough", wide <= 360, wide)
    bad = [m for m in b.said() if "400" not in m]
    rule("the browser had nothing to say", not bad, bad)


# A page that is drawn anew while the driver has an element in hand makes the driver fail, not the page: then all begins again,
# with another point.
TRIES = 3
for again in range(TRIES):
    rules.clear()
    browser = Browser()
    try:
        main(browser, 12 + again)
        break
    except WebDriverException:
        if again == TRIES - 1:
            raise
    finally:
        browser.close()
print("\n".join(rules), flush=True)
