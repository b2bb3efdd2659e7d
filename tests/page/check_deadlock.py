"""check_deadlock.py PAGE - a page's section "Deadlock": its picture is drawn, its report is there, nothing is fetched."""
import sys

from browser import Browser

browser = Browser()
try:
    browser.open(sys.argv[1])
    found = browser.run("""
        const section = [...document.querySelectorAll('main section')].find(s => s.querySelector('h2').textContent === 'Deadlock');
        const picture = section?.querySelector('img');
        return {
            width: picture?.naturalWidth || 0, alt: picture?.alt || '',
            report: section?.querySelector('pre')?.textContent || '',
            card: [...document.querySelectorAll('.cards .kind')].some(c => c.textContent === 'Deadlock')
        };""")
    for name, holds in (("a picture is drawn", found["width"] >= 960), ("it has words for who does not see it", found["alt"]),
                        ("the report is there", "crecvx(7)" in found["report"]), ("the summary has a card", found["card"])):
        print(("ok " if holds else "not ok ") + "page: " + name)
finally:
    browser.driver.quit()
