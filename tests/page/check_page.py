"""check_page.py PAGE MANY TWO FOLDER - tries a page in a browser: prints "ok RULE" or "not ok RULE", as tests/run reads it.

PAGE shows what tests/e2e/page.sh made, MANY a trace of 100,000 intervals, TWO that and another, and two
studies of one title. FOLDER has the files that the page was made of."""
import base64
import json
import re
import sys

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

from browser import Browser
import vision

page, many, two, folder = sys.argv[1:]


def rule(name, holds, why=""):
    print(("ok " if holds else "not ok ") + name + ("" if holds else f" ({why})"), flush=True)


def load(name):
    with open(f"{folder}/{name}", encoding="utf-8") as file:
        return json.load(file)


def picoseconds(text):
    """Of "0 s", "2.6878 ms", "10 µs"."""
    number, unit = text.replace("\u202f", "").replace("\u00a0", " ").split(" ")
    return float(number) * {"s": 1e12, "ms": 1e9, "µs": 1e6, "ns": 1e3, "ps": 1}[unit]


def is_rounded(shown, value):
    """To thousandths or finer, with no more of an error than that makes."""
    digits = len(shown.partition(".")[2])
    return digits >= 3 and abs(float(shown) - value) <= 0.5001 * 10 ** -digits


def section(b, word):
    """The section whose heading has the word."""
    for s in b.driver.find_elements(By.CSS_SELECTOR, "main > section"):
        if word in s.find_element(By.TAG_NAME, "h2").text:
            return s
    raise AssertionError(f"no section {word}")


def show(b, element):
    b.run("arguments[0].scrollIntoView({block: 'center', behavior: 'instant'})", element)


def check_tables(b):
    rows = load("paper/tables.json")["rows"]
    shown = b.run("""return [...document.querySelectorAll('main table')].filter(t => t.querySelector('td.error'))
        .flatMap(t => [...t.tBodies[0].rows].map(r => [...r.cells].map(c => c.textContent)))""")
    rule("tables: a row each", len(shown) == len(rows) and len(rows) >= 8, f"{len(shown)} of {len(rows)}")
    wrong = [(s, r["nodes"]) for s, r in zip(shown, rows)
             if int(s[0].rstrip("\u2009†")) != r["nodes"] or not is_rounded(s[1], r["total_s"])
             or float(s[2]) != r["paper_total_s"] or abs(float(s[3].replace("\u2212", "-")) - r["error_pct"]) > 0.006]
    rule("tables: times, the paper's and errors are right", not wrong, wrong)
    heads = b.run("return [...document.querySelectorAll('main thead tr:last-child th')].map(c => c.textContent)")
    rule("tables: one word for what was simulated, as in text and picture", "simulated" in heads and "computed" not in heads, heads)
    looks = b.run("""return [...document.querySelectorAll('figure')].filter(f => f.textContent.includes('residuals'))
        .map(f => [...f.querySelectorAll('g[data-series="fitted to"] > path')].map(p => p.getAttribute('d') + p.getAttribute('stroke')))""")
    rule("tables: fitted rows look the same in each table", len([of for of in looks if of]) > 1 and
         len({look for of in looks for look in of}) == 1, looks)
    tones = b.run("return [...document.querySelectorAll('td.error')].map(c => getComputedStyle(c).backgroundColor)")
    slow = [t for t, r in zip(tones, rows) if r["error_pct"] > 0.1]
    fast = [t for t, r in zip(tones, rows) if r["error_pct"] < -0.1]
    rule("tables: slower and faster have other colours", slow and fast and not
         {t.split(",")[0] for t in slow} & {t.split(",")[0] for t in fast}, (slow, fast))


def check_study(b):
    s = section(b, "Halves")
    show(b, s)
    rule("study: what its speed-ups are of", f"Baseline of speed-ups: {load('study/results.json')['baseline']}." in s.text, s.text[:300])
    points = [p for p in load("study/results.json")["points"] if not p["failure"]]
    curves = lambda: b.run("return arguments[0].querySelectorAll('svg g[data-series]').length", s)
    markers = lambda: b.run("return arguments[0].querySelectorAll('svg g[data-series] path[transform]').length", s)
    before = curves()
    rule("study: a curve a value, a marker a point", before == 2 and markers() == len(points), (before, markers()))
    b.run("arguments[0].click()", s.find_element(By.CSS_SELECTOR, ".legend button"))
    rule("study: the legend switches a curve off", curves() == before - 1)
    b.run("arguments[0].click()", s.find_element(By.CSS_SELECTOR, ".legend button"))
    rule("study: and on", curves() == before)
    ticks = lambda: b.run("return [...arguments[0].querySelectorAll('svg text')].map(t => t.textContent).join()", s)
    logarithmic = ticks()
    b.run("arguments[0].click()", s.find_elements(By.CSS_SELECTOR, ".controls input[type=checkbox]")[1])
    held = b.run("""return fullestHold({axes: {n: [1, 2], kind: ['none', 'some', 'all']}, points: [{n: 1, kind: 'none', t: 1, failure: 'x'},
        {n: 1, kind: 'some', t: 1}, {n: 1, kind: 'all', t: 1}, {n: 2, kind: 'all', t: 1}]}, {x: 'n', y: 't', lines: ''})""")
    rule("study: other axes are held where most points are", held == {"kind": 2}, held)
    rule("study: linear or logarithmic", ticks() != logarithmic)
    few = b.run("""return [[0.57, 2.8], [0.5, 5], [5.5, 8.9], [1, 100], [1, 1e9]].map(range =>
        ticksOf(d3.scaleLog().domain(range).range([244, 0]), true, 6, 16).map(t => Number(t.toPrecision(3))))""")
    rule("study: a logarithmic axis has ticks also within a decade, and never 0.9 for 1", few[:2] == [
        [0.6, 0.7, 0.8, 0.9, 1, 2], [0.5, 0.6, 0.8, 1, 2, 3, 4, 5]] and len(few[2]) > 2 and few[3:] == [
            [1, 2, 5, 10, 20, 50, 100], [10 ** i for i in range(10)]], few)
    numbers = b.run("return [0.00005, 0.00015, 0.0004, 12500000, 0.5, 20].map(axisNumber)")
    rule("study: an axis has numbers of one kind, small ones too", numbers == ["0.00005", "0.00015", "0.0004", "12.5M", "0.5", "20"], numbers)
    units = b.run("return [['time, s', 0.0007], ['s', 0.09], ['time, s', 0.2], ['s', 0], ['steps', 0.0007]].map(a => Object.values(axisUnit(...a)).join(' '))")
    rule("study: short times have an axis in their own unit", units == ["1000000 time, µs", "1000 ms", "1 time, s", "1 s", "1 steps"], units)
    label = b.run("""const chart = lineChart({xLabel: 'n', yLabel: 'time, s', series: [{name: 'a', points: [{x: 1, y: 0.02}, {x: 2, y: 0.099}]}]});
        document.body.append(chart.figure);
        chart.update({});
        const label = [...chart.figure.querySelectorAll('text.label')].map(t => t.textContent).at(-1);
        chart.figure.remove();
        return label""")
    rule("study: the greatest time decides, not the end of its axis", label == "time, ms", label)
    named = b.run("return ['time_s', 'idle_pct', 'nodes_of_done_groups', 'memory_peak_bytes', 'speedup'].map(figureWords)")
    rule("study: figures have names for people", named == ["time, s", "idle, %", "nodes of done groups", "memory peak, bytes", "speed-up"] and
         "time against nodes" in s.text, named)
    ideal = b.run("""const of = y => idealSeries({axes: {nodes: [2, 8, 4]}}, {x: 'nodes', y}).map(s => s.points.map(p => [p.x, p.y]));
        return [of('speedup'), of('speed_per_node'), of('time_s')]""")
    rule("study: speeds have the ideal line beside them", ideal == [[[[2, 2], [8, 8]]], [[[2, 1], [8, 1]]], []], ideal)
    chart = s.find_element(By.CSS_SELECTOR, "figure svg")
    b.run("arguments[0].focus()", chart)
    chart.send_keys(Keys.ARROW_RIGHT)
    tip = s.find_element(By.CSS_SELECTOR, ".tip").text
    rule("study: a point's figures are shown, whole", any(f"nodes {p['nodes']}, share {p['share']}\ntime, s: {p['time_s']}" == tip for p in points), tip)
    details = [d for d in s.find_elements(By.TAG_NAME, "details") if "table behind" in d.text][0]
    b.run("arguments[0].open = true", details)
    b.until("return document.querySelector('details[open] table')")
    text = b.run("return arguments[0].textContent", details)
    columns = b.run("""return [...arguments[0].querySelectorAll('tbody tr')].map(r => [...r.cells].map(c =>
        [c.textContent, c.querySelector('.rounded')?.title ?? c.textContent]))""", details)
    exact = {e for row in columns for _, e in row}
    rule("study: the table behind has each figure, exactly", all(str(p["total_s"]) in exact for p in points), sorted(exact)[:20])
    decimals = [{len(shown.split(".")[1]) for shown, e in column if shown != e and "." in shown} for column in zip(*columns)]
    rule("study: a column's numbers have equal decimals", any(decimals) and all(len(d) < 2 for d in decimals), decimals)


def check_run(b):
    plain = lambda text: text.replace("\u202f", "").replace("\u00a0", " ")
    data = load("run.json")
    text = section(b, "Run of").text.replace("\u202f", "").replace("\u00a0", " ")
    rough = b.run("return [73.1e12, 0.99996e12, 5e6, -30.1e9, 12345.6e12, 0].map(roughly)")
    rule("durations have four figures", plain("|".join(rough)) == "73.10 s|1.000 s|5.000 µs|-30.10 ms|12346 s|0 s", rough)
    column = b.run("const c = [20000000n, 500000n, 0n]; return c.map(showAlike(c)).map(v => v.textContent ?? v)")
    rule("durations in a column have the unit of the longest", plain("|".join(column)) == "20.000 µs|0.500 µs|0.000 µs", column)
    rule("run: its virtual time for people", f"{data['virtual_time_s'] * 1e3:#.4g} ms" in text, text[:300])
    exact = f"{data['virtual_time_s']!r} s"
    time = section(b, "Run of").find_element(By.CSS_SELECTOR, ".rounded")
    rule("run: all digits under the mouse", plain(time.get_attribute("title")) == exact, time.get_attribute("title"))
    b.run("arguments[0].click()", time)
    rule("run: and after a click", plain(time.text) == exact, time.text)
    b.run("arguments[0].click()", time)
    rule("run: its digest", data["digest"] in text)


def check_timeline(b):
    s = section(b, "Timeline")
    words = b.run("return [...arguments[0].querySelectorAll('.about .word')].map(e => e.textContent)", s)
    rule("timeline: a command breaks between its words, not in an option", words[0].endswith("touchstone") and "-m" in words and
         "--trace" in words, words)
    shares = b.run("return [482, 7, 0].map(v => timeColumns(1000, 1, 'the run')[1].show(v))")
    rule("why: a column's shares have equal decimals", shares == ["48.20 %", "0.70 %", "0.00 %"], shares)
    canvas = s.find_element(By.TAG_NAME, "canvas")
    show(b, canvas)
    begin, end = s.find_elements(By.CSS_SELECTOR, ".controls input[type=text]")[:2]
    interval = lambda: (begin.get_attribute("value"), end.get_attribute("value"))
    pieces = b.run("""const t = arguments[0].timeline.trace, c = t.columns;
        return t.rows.map(r => String(c['piece.end'].at(r.first + r.pieces - 1)))""", canvas)
    last = b.run("return String(arguments[0].timeline.trace.end)", canvas)
    exact = str(round(load("run.json")["virtual_time_s"] * 1e12))
    rule("timeline: pieces reach the end, to the picosecond", set(pieces) == {last} and last == exact, (last, exact, pieces))
    whole = interval()
    rule("timeline: it begins with the whole run", whole[0] == "0 s" and abs(picoseconds(whole[1]) - int(last)) < 1e-4 * int(last)
         and b.run("const t = arguments[0].timeline; return String(t.viewTo()) === String(t.trace.end)", canvas), whole)
    b.run("arguments[0].click()", s.find_element(By.CSS_SELECTOR, "[aria-label='Zoom in']"))
    rule("timeline: a button zooms", interval()[0] != "0 s", interval())
    zoomed = interval()
    canvas.send_keys(Keys.ARROW_RIGHT)
    rule("timeline: a key moves", interval() != zoomed)
    canvas.send_keys("0")
    rule("timeline: a key shows all again", interval() == whole, interval())
    ActionChains(b.driver).move_to_element(canvas).click().perform()
    b.run("""arguments[0].dispatchEvent(new WheelEvent('wheel', {deltaY: -400, bubbles: true, cancelable: true}))""", canvas)
    rule("timeline: the wheel zooms once it is clicked", interval() != whole)
    told = s.find_element(By.CSS_SELECTOR, ".readout").text
    rule("timeline: a click tells what a piece is", told.startswith("node ") and " from " in told, told)
    canvas.send_keys("0")
    ActionChains(b.driver).move_to_element(canvas).click_and_hold().move_by_offset(90, 0).release().perform()
    begin.clear()
    begin.send_keys("0.01ms" + Keys.ENTER)
    b.run("arguments[0].blur()", begin)
    rule("timeline: an interval can be typed", interval()[0] == "10 µs", interval())
    canvas.send_keys("0")
    search = s.find_element(By.CSS_SELECTOR, "input[type=search]")
    search.send_keys("crecv type 5 node 3")
    found = [e.text for e in s.find_elements(By.CSS_SELECTOR, ".results button")]
    rule("timeline: search finds calls", len(found) == 20 and all("node 3" in f and "crecv, type 5" in f and "many.c" in f for f in found),
         (len(found), found[:1]))
    search.send_keys(Keys.ENTER)
    rule("timeline: and goes to one", interval() != whole and "crecv" in s.find_element(By.CSS_SELECTOR, ".readout").text)
    search.clear()
    search.send_keys("msgwait")
    found = [e.text for e in s.find_elements(By.CSS_SELECTOR, ".results button")]
    rule("timeline: what msgwait is given is an id, no type", len(found) == 8 and all("msgwait, id 1, at" in f for f in found), found[:2])
    canvas.send_keys("0")
    check_first_row(b, canvas)
    check_under_mouse(b, s, canvas)
    check_orders(b, s, canvas)
    check_arrows(b, s, canvas)
    check_shares(b, s, last)


def check_printed(b):
    b.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    breaks = b.run("""return [...document.querySelectorAll('main > section > h2 + p')].map(p => {
        const style = getComputedStyle(p); return `${style.breakAfter} ${style.breakInside}`; })""")
    hints = b.run("""return [...document.querySelectorAll('p, span')].filter(p => p.checkVisibility() && !p.firstElementChild &&
        /Click|click|mouse/.test(p.textContent)).map(p => p.textContent)""")
    b.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
    rule("printed: no hints that are for the screen", hints == [], hints)
    rule("printed: a heading and what follows it stay with their picture", breaks and set(breaks) == {"avoid avoid"}, breaks)


def check_first_row(b, canvas):
    """The label of node 0 was hidden below the axis of time where rows are low."""
    tones = b.run("""const t = arguments[0].timeline, {left, axis, scale} = t.painter.layout, tones = new Set();
        const height = t.view.rowHeight;
        t.view.rowHeight = 6;
        t.paint();
        const d = arguments[0].getContext('2d').getImageData(0, axis * scale, (left - 6) * scale, 11 * scale).data;
        for (let i = 0; i < d.length; i += 4) tones.add(d[i]);
        t.view.rowHeight = height;
        t.paint();
        return tones.size""", canvas)
    rule("timeline: the first row has its label", tones > 5, tones)


def check_under_mouse(b, s, canvas):
    ActionChains(b.driver).move_to_element(canvas).perform()
    tip = lambda: s.find_element(By.CSS_SELECTOR, ".plot .tip").text
    rule("timeline: the mouse shows what a node does", tip().startswith("node ") and ", " in tip(), tip())
    ActionChains(b.driver).key_down(Keys.SHIFT).move_to_element(canvas).click_and_hold().move_by_offset(200, 0) \
        .release().key_up(Keys.SHIFT).perform()
    told = s.find_element(By.CSS_SELECTOR, ".readout").text.replace("\u00a0", " ")
    shares = [float(part.split()[-1]) for part in told.split(": ", 1)[1].split(" %.")[0].replace(" %", "").split(", ")]
    rule("timeline: an interval that is chosen has its sums", "of 8 nodes: computing" in told and abs(sum(shares) - 100) < 0.5 and
         0 not in shares, told)
    ends = re.match(r"From ([0-9.]+) \S?s to ([0-9.]+) \S?s, ", told)
    rule("timeline: the interval's ends have few digits", ends and all(len(e) <= 8 for e in ends.groups()), told)
    before = b.run("return arguments[0].timeline.view.to - arguments[0].timeline.view.from", canvas)
    b.run("arguments[0].click()", s.find_element(By.CSS_SELECTOR, ".readout button"))
    rule("timeline: and can be looked into",
         b.run("return arguments[0].timeline.view.to - arguments[0].timeline.view.from", canvas) < before / 2)
    canvas.send_keys("0")


def check_orders(b, s, canvas):
    choose = lambda text, value: b.run("""const label = [...arguments[0].querySelectorAll('.controls label')]
        .find(l => l.textContent.startsWith(arguments[1])), c = label.querySelector('select');
        c.value = arguments[2];
        c.dispatchEvent(new Event('change'))""", s, text, value)
    idle = {f"node {i}": n["idle_s"] for i, n in enumerate(load("run.json")["node"])}
    names = lambda: b.run("return arguments[0].timeline.trace.rows.map(r => r.name)", canvas)
    choose("order", "idle")
    rule("timeline: the longest waiting are first", [idle[n] for n in names()] == sorted(idle.values(), reverse=True), names())
    choose("order", "number")
    rule("timeline: or in order of their numbers", names() == list(idle))
    legend = lambda: [e.text for e in s.find_elements(By.CSS_SELECTOR, ".legend .key")]
    activities = legend()
    choose("colour by", "call")
    rule("timeline: colours by call", "crecv" in legend() and "csend" in legend(), legend())
    choose("colour by", "function")
    rule("timeline: colours by function", "main" in legend(), legend())
    computing = b.run("""const t = arguments[0].timeline.trace, times = {};
        for (const row of t.rows)
            for (let i = row.first; i < row.first + row.pieces; i++)
                if (t.activity[i] === 0) {
                    const name = t.kinds[t.drawn[i]].name, from = i === row.first ? t.start : t.pieceEnd[i - 1];
                    times[name] = (times[name] || 0) + t.pieceEnd[i] - from;
                }
        return times""", canvas)
    rule("timeline: computing has the colour of the function that worked, not of the next call",
         computing.get("relax", 0) > 0.8 * sum(computing.values()), computing)
    ActionChains(b.driver).key_down(Keys.SHIFT).move_to_element(canvas).click_and_hold().move_by_offset(200, 0) \
        .release().key_up(Keys.SHIFT).perform()
    told = s.find_element(By.CSS_SELECTOR, ".readout").text
    rule("timeline: the sums of an interval are those of the colours", "of 8 nodes: no function" in told and ", main " in told, told)
    choose("colour by", "activity")
    told = s.find_element(By.CSS_SELECTOR, ".readout").text
    rule("timeline: also when these change", "of 8 nodes: computing" in told, told)
    rule("timeline: and by activity again", legend() == activities == ["computing", "handler computing", "system (message)",
                                                                       "system (call)", "waiting", "ended"], legend())
    places = b.run("""const t = arguments[0].timeline, {trace, painter, view} = t;
        trace.rows[5].host = true;
        trace.hosts = 1;
        t.orderBy({hostsFirst: true});
        view.rowHeight = 200;
        t.scrollRows(3);
        const found = [trace.rows[0].name, painter.y(0, view), painter.rowAt(painter.layout.axis + 5, view), view.top,
            painter.rowAt(painter.layout.axis + 205, view)];
        view.rowHeight = 2;
        t.orderBy({});
        const low = [painter.y(1, view) - painter.y(0, view), painter.y(2, view) - painter.y(1, view), painter.rowAt(painter.y(1, view), view)];
        view.rowHeight = 22;
        trace.rows[0].host = false;
        t.orderBy({hostsFirst: false});
        return [...found, painter.layout.axis, low]""", canvas)
    rule("timeline: where rows are low, hosts on top are higher", places[6] == [12, 2, 1], places)
    rule("timeline: hosts stay on top", places[0] == "node 5" and places[1] == places[5] and places[2] == 0 and places[3] > 0
         and places[4] == 1 + int(places[3]), places)


def check_arrows(b, s, canvas):
    pixels = lambda: b.run("arguments[0].timeline.paint(); return arguments[0].toDataURL()", canvas)
    with_arrows = pixels()
    b.run("arguments[0].click()", s.find_element(By.CSS_SELECTOR, ".controls input[type=checkbox]"))
    rule("timeline: messages can be switched off", pixels() != with_arrows)


def check_shares(b, s, last):
    details = [d for d in s.find_elements(By.TAG_NAME, "details") if "table behind" in d.text][0]
    b.run("arguments[0].open = true", details)
    cells = b.until("""const rows = [...arguments[0].querySelectorAll('tbody tr')];
        return rows.length && rows.map(r => [...r.cells].slice(1).map(c => c.querySelector('.rounded')?.title ?? c.textContent))""".replace("arguments[0]",
                    "[...document.querySelectorAll('details[open]')].at(-1)"))
    number = lambda text: round(picoseconds(text))
    sums = {sum(number(c) for c in row) for row in cells}
    rule("timeline: the states of each node add up to the run", sums == {int(last)}, (sums, last))


def check_trace_rest(b):
    matrix = section(b, "Who sends")
    show(b, matrix)
    canvas = matrix.find_element(By.TAG_NAME, "canvas")
    canvas.send_keys(Keys.ARROW_RIGHT)
    canvas.send_keys(Keys.ARROW_RIGHT)
    rule("matrix: keys lead to a pair and its bytes", "node 0 to node 1: " in matrix.find_element(By.CSS_SELECTOR, ".readout").text)
    channels = section(b, "channels")
    show(b, channels)
    drawn = b.run("""const c = arguments[0], copy = document.createElement('canvas'), tones = new Set();
        copy.width = c.width;
        copy.height = c.height;
        const g = copy.getContext('2d', {willReadFrequently: true});
        g.drawImage(c, 0, 0);
        const d = g.getImageData(0, 0, copy.width, copy.height).data;
        for (let i = 0; i < d.length; i += 4) tones.add(d[i] << 16 | d[i + 1] << 8 | d[i + 2]); return tones.size""",
                  channels.find_element(By.TAG_NAME, "canvas"))
    rule("channels: a map in colours", drawn > 10, drawn)
    why = section(b, "Flame")
    said = b.run("return flameSummary('main;relax 500\\nmain;csend 200\\nmain;crecv;wait 300').big")
    rule("flame graph: its card has the largest frame", said == "50.0 % in relax", said)
    said = b.run("""return [['node 0', 'node 1'], ['node 0', 'host']].map(names => traceSummary({program: 'farm', machine: 'delta',
        nodes: [...names.map(name => ({name, ran: true})), {name: 'node 7', ran: false}], end: '5', pieceCount: 7, messageCount: 2, complete: true}).small)""")
    rule("a trace's card: its host is none of the nodes", [t.split(";")[0] for t in said] ==
         ["farm on 2 nodes of delta", "farm on 1 node of delta and its host"], said)
    said = b.run("return [20000000000n, 253300000000n].map(to => spanText({from: 0n, to, end: 253300000000n}).replaceAll('\u00a0', ' '))")
    rule("a part of a run is called that", said == ["from 0 s to 20.00 ms of 253.3 ms", "in 253.3 ms"], said)
    said = b.run("""const m = sumMatrix({nodes: [['node 0', true], ['node 1', false], ['host', true]].map(([name, ran]) => ({name, ran})),
        columns: {'message.from': [0, 2], 'message.to': [2, -1], 'message.bytes': {number: () => 8}}, messageCount: 2}, 'bytes', null);
        return [m.names.join(), m.count, [...m.sums].join()]""")
    rule("a matrix has the nodes that had a program", said == ["node 0,host,services", 3, "1,8,5,8"], said)
    said = b.run("""const m = {sums: new Map([[5, 8], [7, 9], [20000 * 40000 + 3, 1]]), stride: 40000, count: 40000, most: 9,
        names: Array.from({length: 40000}, (_, i) => 'node ' + i)}, rects = [];
        const canvas = document.createElement('canvas'), g = canvas.getContext('2d'), fill = g.fillRect.bind(g);
        g.fillRect = (...at) => { rects.push(at); fill(...at); };
        drawMatrix(canvas, m, 602, null);
        const pair = ({from, to}) => from + ' ' + to;
        return [rects.length, canvas.clientWidth || parseFloat(canvas.style.width), pair(m.pairAt(0.05, 0.01)),
            pair(m.pairAt(0, 277)), pair(m.pairAt(-5, 9999))]""")
    rule("a matrix of many nodes: a pixel for pairs that share it, and the mouse finds the largest", said[0] == 4 and said[1] <= 602 and
         said[2:] == ["0 7", "20000 3", "39999 0"], said)
    said = b.run("""const trace = {nodes: [{name: 'node 0', ran: true}, {name: 'node 1', ran: true}], sentAt: [], overAt: [], messageCount: 1,
        columns: {'message.from': [0], 'message.to': [1], 'message.bytes': {number: () => 0}}}, m = sumMatrix(trace, 'bytes', null), tones = [];
        const canvas = document.createElement('canvas'), g = canvas.getContext('2d'), fill = g.fillRect.bind(g), line = element('p');
        g.fillRect = (...at) => { tones.push(g.fillStyle); fill(...at); };
        drawMatrix(canvas, m, 602, null);
        showScale(line, m, 'bytes');
        return [tones.at(-1) !== tones.at(-2), line.textContent]""")
    rule("a matrix of messages without bytes: their pair is drawn, and the scale has no more", said == [True, "0  0 bytes"], said)
    said = b.run("""const columns = {'message.from': [0, 1], 'message.to': [65535, -1], 'message.bytes': {at: () => 8n}};
        return pairsTable({messageCount: 2, columns, nodeName: n => 'node ' + n})[0].querySelectorAll('tbody tr').length""")
    rule("the table of pairs keeps those of very many nodes apart", said == 2, said)
    said = b.run("""const drawn = [], g = document.createElement('canvas').getContext('2d'), places = [];
        places[100] = {x: 0, y: 0};
        g.fillText = text => drawn.push(text);
        drawNodes(g, {trace: {nodes: [{address: 100}], topology: {positions: 128}}, places, ports: [], cell: 70, space: 0}, () => '#000000');
        return drawn""")
    placed = b.run("""const channels = [8, 10].map(from => ({from, to: null})), map = {trace: {channels, columns: {'channel.uses': [1, 2]},
        topology: {dimension: 3, columns: 0, positions: 8, addresses: 11, host: true}}};
        layOut(map);
        return [8, 9, 10].map(a => map.places[a] ? [map.places[a].x, map.places[a].y] : null)""")
    rule("channels: a cube's services that were used, and its host, stand beside their nodes", placed == [[-0.38, -0.38], None, [-0.38, 0.38]], placed)
    rule("channels: numbers of three digits stand in their circles", said == ["100"], said)
    said = b.run("""const section = flameSection('main 0\\n', 'none'), text = section.textContent, link = document.querySelector('nav li:last-child');
        section.remove();
        link.remove();
        return [flameSummary('# none\\n').big, text.includes('No stack took any time.'), text.includes('NaN')]""")
    rule("a flame graph of stacks that took no time", said == ["no frame", True, False], said)
    said = b.run("return ['node 1', 'host'].map(name => nodeParts([{name: 'node 0'}, {name}])[3][1])")
    rule("a run's bars: only where a host loads programs, nodes have none at first", said == ["ended", "no program"], said)
    frame = [g for g in why.find_elements(By.CSS_SELECTOR, "g[role=button]") if g.get_attribute("aria-label").startswith("crecv")][0]
    rule("flame graph: a frame's share", frame.get_attribute("aria-label") == "crecv, 30.00 %", frame.get_attribute("aria-label"))
    wide = b.run("return arguments[0].querySelector('rect').getBBox().width", frame)
    b.run("arguments[0].dispatchEvent(new MouseEvent('click'))", frame)
    now = b.run("return document.querySelector('g[aria-label^=crecv] rect').getBBox().width")
    rule("flame graph: a click widens it", now > 3 * wide, (wide, now))


def mean_tone(picture):
    """Of all pixels that are not as the first one, which is of the ground."""
    pixels = [picture[i:i + 3] for i in range(0, len(picture), 3)]
    return [sum(tones) / len(tones) for tones in zip(*(p for p in pixels if p != pixels[0]))]


def check_surfaces(b):
    s = section(b, "Surfaces")
    canvas = s.find_element(By.TAG_NAME, "canvas")
    show(b, canvas)
    picture = lambda: b.run("""return new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => {
        const c = arguments[0], copy = document.createElement('canvas'); copy.width = 160; copy.height = 90;
        const g = copy.getContext('2d', {willReadFrequently: true}); g.drawImage(c, 0, 0, 160, 90);
        done([...g.getImageData(0, 0, 160, 90).data].filter((v, i) => i % 4 < 3)) })))""", canvas)
    tones = lambda p: len({tuple(p[i:i + 3]) for i in range(0, len(p), 3)})
    first = picture()
    rule("surfaces: WebGL draws them", tones(first) > 50, tones(first))
    flip = "for (const m of arguments[0].view.meshes) { const n = m.geometry.attributes.normal; n.array.forEach((v, i, all) => { all[i] = -v; }); n.needsUpdate = true; } arguments[0].view.draw()"
    b.run(flip, canvas)
    parts = [v / w for v, w in zip(mean_tone(picture()), mean_tone(first))]
    b.run(flip, canvas)
    rule("surfaces: normals may point to either side", all(0.99 < part < 1.01 for part in parts), parts)
    toggle = "arguments[0].querySelector('.plot ~ ul button').click()"
    b.run("arguments[0].querySelector('.plot ~ ul input').click()", s)
    clear = picture()
    b.run(toggle, s), b.run(toggle, s)
    rule("surfaces: one that is hidden and shown again looks as before", picture() == clear)
    b.run("arguments[0].querySelector('.plot ~ ul input').click()", s)
    outside = b.run("""const {view} = arguments[0], box = new THREE.Box3(), out = [];
        view.meshes.forEach(m => box.expandByObject(m));
        for (const x of [box.min.x, box.max.x]) for (const y of [box.min.y, box.max.y]) for (const z of [box.min.z, box.max.z]) {
            const p = new THREE.Vector3(x, y, z).project(view.camera);
            out.push(Math.abs(p.x), Math.abs(p.y));
        }
        return Math.max(...out)""", canvas)
    rule("surfaces: the first view shows them whole, and large", 0.8 < outside <= 1, outside)
    canvas.send_keys(Keys.ARROW_LEFT * 4)
    turned = picture()
    rule("surfaces: keys turn them", turned != first)
    ActionChains(b.driver).move_to_element(canvas).click_and_hold().move_by_offset(60, 20).release().perform()
    rule("surfaces: the mouse turns them", picture() != turned)
    canvas.send_keys("0")
    before = picture()
    see_through = "arguments[0].querySelector('.plot ~ ul input').click()"
    b.run(see_through, s)
    clear = picture()
    b.run(see_through, s)
    ground, whole = sum(before[:3]), sum(mean_tone(before))
    rule("surfaces: one that is seen through is nearer to the ground's tone",
         abs(sum(mean_tone(clear)) - ground) < 0.97 * abs(whole - ground), (ground, whole, mean_tone(clear)))
    rule("surfaces: and is whole again", picture() == before)
    b.run("const c = arguments[0].querySelector('select'); c.value = 'node'; c.dispatchEvent(new Event('change'))", s)
    rule("surfaces: coloured by node", picture() != before)


def check_keyboard(b):
    """Tab leads to everything that a mouse reaches."""
    b.run("document.querySelectorAll('details[open]').forEach(d => { d.open = false; }); document.activeElement.blur(); scrollTo(0, 0)")
    wanted = b.run("""window.reached = new Set(); document.addEventListener('focusin', e => reached.add(e.target));
        window.wanted = [...document.querySelectorAll('a[href], button, select, input, summary, canvas, [role=button][tabindex]')]
            .filter(e => !e.disabled && e.getClientRects().length && !(e.closest('details:not([open])') && e.tagName !== 'SUMMARY'));
        return wanted.length""")
    body = b.driver.find_element(By.TAG_NAME, "body")
    for _ in range(0, wanted + 60, 20):
        ActionChains(b.driver).send_keys(Keys.TAB * 20).perform()
    missed = b.run("return wanted.filter(e => !reached.has(e)).map(e => e.outerHTML.slice(0, 90))")
    rule(f"keyboard: Tab reaches all {wanted} controls", wanted > 40 and not missed, missed[:3])
    nameless = b.run("""return wanted.filter(e => !(e.textContent.trim() || e.getAttribute('aria-label') || e.labels?.length || e.title))
        .map(e => e.outerHTML.slice(0, 90))""")
    rule("keyboard: each has a name", not nameless, nameless)
    marks = b.run("""return ['header', 'nav', 'main', 'footer'].every(t => document.querySelectorAll(`body > ${t}`).length === 1) &&
        [...document.querySelectorAll('main > section')].every(s => document.getElementById(s.getAttribute('aria-labelledby')))""")
    rule("screen reader: landmarks, and a heading names each section", marks)
    here = lambda top: b.run("""scrollTo({top: arguments[0], behavior: 'instant'}); markSection();
        return document.querySelector('nav [aria-current=true]').hash""", top)
    links = b.run("return [...document.querySelectorAll('nav a')].map(a => a.hash)")
    third = b.run("return document.querySelector(arguments[0]).getBoundingClientRect().top + scrollY", links[2])
    rule("the navigation marks the section at the top", [here(0), here(third)] == [links[0], links[2]], (links, here(0), here(third)))


def check_widths(b):
    for width, dark in ((360, False), (768, True)):
        b.resize(width, 740, dark)
        b.until(f"return innerWidth === {width}")
        wide = b.until("return new Promise(d => requestAnimationFrame(() => setTimeout(() => d(document.documentElement.scrollWidth), 200)))")
        rule(f"{width} pixels: nothing sticks out", wide <= width, wide)
    tone = b.run("return getComputedStyle(document.body).backgroundColor")
    rule("dark: the ground is", sum(int(v) for v in tone[4:-1].split(",")) < 120, tone)
    b.resize(1280)


def check_markup(b):
    rule("a name of markup stays text", b.run("return document.title !== 'struck' && document.querySelector('main').textContent.includes('<script>document.title')")
         and b.run("return window.struck === undefined && !document.querySelector('main script, main img, header img')"))


def check_colours(b):
    """Activities are far apart on light and dark ground, for all kinds of colour vision."""
    for dark in (False, True):
        b.resize(1280, 900, dark)
        tones = b.run("return ['computing', 'handler', 'system', 'call', 'waiting'].map(colour)")
        least = min((vision.distance(a, c, kind), a, c, kind) for kind in vision.KINDS
                    for a in tones for c in tones if a != c)
        rule(f"colours of activities are apart, {'dark' if dark else 'light'}", least[0] > 35, least)
    b.resize(1280)


def check_speed(b):
    b.open(many)
    canvas = b.driver.find_element(By.CSS_SELECTOR, ".plot canvas")
    pieces, times = b.run("""const t = arguments[0].timeline, list = [];
        for (let i = 0; i < 40; i++) {
            t.setRange(t.trace.stop * i / 400, t.trace.stop * (0.9 + i / 400));
            const from = performance.now();
            t.paint();
            list.push(performance.now() - from);
        }
        return [t.trace.pieceCount, list.sort((a, b) => a - b)]""", canvas)
    print(f"# {pieces} intervals: a redraw takes {times[0]:.1f} ms at best, {times[20]:.1f} ms in the middle of 40")
    rule("timeline: 100,000 intervals are redrawn in a frame", pieces >= 100000 and times[0] < 33, (pieces, times[0]))


def check_together(b):
    b.open(two)
    b.run("window.timelines = [...document.querySelectorAll('.plot canvas')].map(c => c.timeline).filter(t => t)")
    views = lambda: b.run("return timelines.map(t => [t.view.from, t.view.to])")
    first, second = [e for e in b.driver.find_elements(By.CSS_SELECTOR, "main > section")
                     if e.find_element(By.TAG_NAME, "h2").text.startswith("Timeline")]
    neighbours = "return arguments[0].nextElementSibling === arguments[1]"
    rule("two timelines: one follows the other", b.run(neighbours, first, second))
    stops = b.run("return timelines.map(t => t.trace.stop)")
    rule("two timelines: both show the longer run", stops[0] != stops[1] and views() == [[0, max(stops)]] * 2, (stops, views()))
    behind = """const t = timelines.find(t => t.trace.stop < t.view.to), {painter, view, trace: {stop}} = t, {axis, scale} = painter.layout;
        t.paint();
        const row = t.canvas.getContext('2d').getImageData(0, (axis + 6) * scale, t.canvas.width, 1).data, {to} = view;
        const at = time => row.slice(4 * Math.round(painter.x(time, view) * scale)).slice(0, 3).join();
        return [at(stop * 0.5), at((stop + to) / 2), at((stop + 3 * to) / 4)]"""
    tones = b.run(behind)
    rule("two timelines: behind the shorter run there is nothing", tones[1] == tones[2] != tones[0], tones)
    zoom = "arguments[0].querySelector(\"[aria-label='Zoom in']\").click()"
    b.run(zoom, second)
    rule("two timelines: the first follows the second", views()[0] == views()[1] and views()[0][0] > 0, views())
    box = second.find_element(By.XPATH, ".//label[contains(., 'all runs show')]/input")
    b.run("arguments[0].click()", box)
    b.run(zoom, first)
    rule("two timelines: unless that is switched off", views()[0] != views()[1], views())
    b.run("arguments[0].click()", box)
    rule("two timelines: switched on again, it follows at once", views()[0] == views()[1], views())


def check_nested(b):
    """In the page of two; its surfaces are within each other."""
    canvas = section(b, "Surfaces").find_element(By.TAG_NAME, "canvas")
    shown = b.run("return arguments[0].view.meshes.map(m => m.material.uniforms.opacity.value)", canvas)
    with open(f"{folder}/rendered", encoding="utf-8") as file:
        rendered = [float(line.split("opacity ")[1]) for line in file if "opacity" in line]
    rule("surfaces: those around others are seen through, as touchstone render draws them",
         len(shown) == 3 and all(abs(s - r) < 1e-3 for s, r in zip(shown, rendered)) and rendered[0] == 1 > rendered[1], (shown, rendered))
    sides = b.run("return arguments[0].view.meshes.map(m => [m.far.visible, m.far.renderOrder, m.renderOrder, m.material.side])", canvas)
    rule("surfaces: far sides are drawn before what is within them, near ones after it",
         sides == [[False, 0, 0, 2], [True, -1, 1, 0], [True, -2, 2, 0]], sides)
    checked = b.run("return arguments[0].view.clearBoxes.map(c => c.checked)", canvas)
    rule("surfaces: and their boxes say so", checked == [False, True, True], checked)
    show(b, canvas)
    mean = """const [image] = arguments, copy = document.createElement('canvas'), g = copy.getContext('2d', {willReadFrequently: true});
        copy.width = 640;
        copy.height = Math.round(640 * image.height / image.width);
        g.drawImage(image, 0, 0, copy.width, copy.height);
        const d = g.getImageData(0, 0, copy.width, copy.height).data, sums = [0, 0, 0, 0];
        for (let i = 0; i < d.length; i += 4)
            if (d[i] !== d[0] || d[i + 1] !== d[1] || d[i + 2] !== d[2])
                for (let k = 0; k < 4; k++) sums[k] += k < 3 ? d[i + k] : 1;
        return sums.slice(0, 3).map(v => v / sums[3])"""
    with open(f"{folder}/nested.png", "rb") as file:
        png = "data:image/png;base64," + base64.b64encode(file.read()).decode()
    b.run("window.rendered = new Image(); rendered.src = arguments[0]; return rendered.decode()", png)
    here, there = b.run(mean, canvas), b.run(mean.replace("arguments,", "[rendered],"))
    rule("surfaces: they have the tones of touchstone render",
         all(abs(v - w) < 6 for v, w in zip(here, there)), (here, there))
    upper = b.run("""return new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => {
        const copy = document.createElement('canvas'), g = copy.getContext('2d', {willReadFrequently: true});
        copy.width = 640;
        copy.height = 360;
        g.drawImage(arguments[0], 0, 0, 640, 360);
        const d = g.getImageData(0, 0, 640, 180).data, sums = [];
        for (let i = 0; i < d.length; i += 4)
            if (d[i] !== d[0] || d[i + 1] !== d[1] || d[i + 2] !== d[2]) sums.push(d[i] + d[i + 1] + d[i + 2]);
        done(sums.sort((a, b) => a - b)) })))""", canvas)
    dark, middle = upper[len(upper) // 100], upper[len(upper) // 2]
    rule("surfaces: a coarse one has no dark triangles at its outline", dark > 0.35 * middle, (dark, middle))


def check_names(b):
    links = b.run("return [...document.querySelectorAll('nav a')].map(a => a.textContent)")
    rule("two studies of one title are told apart in the navigation", [l for l in links if l.startswith("Study")] == [
        "Study: Halves (study)", "Study: Halves (twin)"], links)
    rule("what no other is called has a short name there", "Timeline: run.trace" in links, links)


browser = Browser()
try:
    browser.open(page)
    for check in (check_tables, check_printed, check_study, check_run, check_timeline, check_trace_rest, check_surfaces, check_keyboard,
                  check_widths, check_markup, check_colours, check_speed, check_together,
                  check_nested, check_names):
        try:
            check(browser)
        except Exception as problem:  # what is not there is a rule that does not hold
            rule(f"{check.__name__} comes to its end", False, f"{type(problem).__name__}: {str(problem)[:500]}")
    said = browser.said()
    rule("the console stays silent", not said, said[:3])
    asked = [u for u in browser.requests() if not u.startswith(("data:", "blob:"))]
    rule("nothing is fetched but the pages", set(asked) == {"file://" + page, "file://" + many, "file://" + two}, asked)
finally:
    browser.close()
