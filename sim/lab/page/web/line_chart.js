/* line_chart.js - curves: a point's figures under the mouse or by the arrow keys, lines switched off in
 * the legend, linear or logarithmic scales. */
/* d3 is there only when the page starts. */
function markerOf(i) {
    return [
        d3.symbolCircle, d3.symbolSquare, d3.symbolTriangle, d3.symbolDiamond, d3.symbolCross, d3.symbolStar,
        d3.symbolWye
    ][i % 7];
}
const DASHES = ['', '7 3', '2 3', '9 3 2 3', '4 2', '12 4', '1 3', '6 2 1 2'];

/* Draws into a new figure element, which is returned with a method update(options).
 * options: { title, xLabel, yLabel, logX, logY, ticksX, zero, height,
 *            series: [ { name, points: [ { x, y, tip, spread, marked } ], line, hollow, style, ideal } ] }
 * ticksX: values of the horizontal axis that get a label; zero: a line at 0; spread: half the length of
 * a point's error bar; marked: with a ring around it; line: false: markers only; hollow: rings instead of
 * dots; style: the number of its colour and marker, by default its place among the series; ideal: a grey
 * dotted line without markers, to compare with. */
function lineChart(options) {
    const chart = {hidden: new Set(), near: null};
    const holder = element('div'), tip = element('div', {class: 'tip', role: 'status'});
    const caption = element('figcaption'), legend = element('ul', {class: 'legend'});
    chart.figure = element('figure', {}, caption, holder, tip, legend);
    chart.update = changed => {
        Object.assign(options, changed);
        caption.textContent = options.title || '';
        drawLegend();
        draw(holder.clientWidth);
    };
    function shown() {
        return options.series.map((s, i) => ({...s, style: s.style ?? i})).filter(s => !chart.hidden.has(s.name));
    }
    function drawLegend() {
        legend.hidden = options.series.length < 2;
        legend.replaceChildren(...options.series.map((s, i) => element('li', {}, button('', () => {
            chart.hidden.has(s.name) ? chart.hidden.delete(s.name) : chart.hidden.add(s.name);
            chart.update({});
            legend.querySelectorAll('button')[i].focus();
        }, {'aria-pressed': String(!chart.hidden.has(s.name))}))));
        legend.querySelectorAll('button').forEach(
            (b, i) => b.append(legendKey(options.series[i], options.series[i].style ?? i), options.series[i].name));
    }
    function draw(width) {
        if (width > 0)
            holder.replaceChildren(drawChart(chart, options, shown(), width, tip));
    }
    onWidth(holder, draw);
    chart.update({});
    return chart;
}

function symbolPath(type, size) { return d3.symbol().type(type).size(size)(); }

/* How the markers of a series are painted. */
function markerPaint(series, i) {
    const tone = `var(--c${i % 8})`;
    return {
        fill: series.hollow ? 'var(--ground)' : tone,
        stroke: tone,
        'stroke-width': series.hollow ? 2 : 0
    };
}

/* How the line of a series is painted. */
function linePaint(series, i) {
    return series.ideal ? {stroke: 'var(--soft)', 'stroke-width': 1.5, 'stroke-dasharray': '1 3'}
                        : {stroke: `var(--c${i % 8})`, 'stroke-width': 2, 'stroke-dasharray': DASHES[i % 8]};
}

function legendKey(series, i) {
    const mark = series.ideal ? null : svgElement(
        'path', {d: symbolPath(markerOf(i), 40), transform: 'translate(14 7)', ...markerPaint(series, i)});
    const line = series.line === false
        ? null
        : svgElement('line', {x1: 0, x2: 28, y1: 7, y2: 7, ...linePaint(series, i)});
    return svgElement('svg', {width: 28, height: 14, 'aria-hidden': 'true'}, line, mark);
}

/* The range of the values, a little wider, or to 0 where that is near. */
function extent(values, log, zero) {
    let [least, most] = d3.extent(values);
    if (least === undefined)
        return log ? [1, 10] : [0, 1];
    if (log)
        return least === most ? [least / 2, most * 2] : [least / 1.12, most * 1.12];
    if (zero || (least > 0 && least < most * 0.6))
        least = Math.min(least, 0);
    if (zero)
        most = Math.max(most, 0);
    const space = (most - least || Math.abs(most) || 1) * 0.06;
    return [least === 0 ? 0 : least - space, most + space];
}

function makeScale(values, log, zero, range) {
    return (log ? d3.scaleLog() : d3.scaleLinear()).domain(extent(values, log, zero)).range(range);
}

/* Digits of a decade that get a tick, from many to few. */
const DIGITS = [[1, 2, 3, 4, 5, 6, 7, 8, 9], [1, 2, 3, 4, 5, 6, 8], [1, 2, 3, 5, 7], [1, 2, 5], [1]];

/* Ticks of a scale, about so many. Of a logarithmic one the most digits that leave so many pixels between
 * labels: 1 must not give way to 0.9. */
function ticksOf(scale, log, count, least) {
    if (!log)
        return scale.ticks(count);
    const all = scale.ticks(10), leading = t => Math.round(t / 10 ** Math.floor(Math.log10(t) + 1e-9));
    if (!all.length)
        return scale.domain();
    const sets = DIGITS.map(digits => all.filter(t => digits.includes(leading(t))));
    const fits = ticks => ticks.length <= count * 1.6 && apart(ticks, scale, least).length === ticks.length;
    return sets.find(fits) || apart(sets.at(-1).length ? sets.at(-1) : all, scale, least);
}

/* Which of the ticks leave so many pixels to the label before. */
function apart(ticks, scale, least) {
    let last = -Infinity;
    return ticks.filter(t => {
        const here = scale(t);
        if (Math.abs(here - last) < least)
            return false;
        last = here;
        return true;
    });
}

function drawChart(chart, o, series, width, tip) {
    const height = o.height || 300, margin = {left: 62, right: 16, top: 12, bottom: 44};
    const points = series.flatMap(s => s.points.map(p => ({...p, series: s})));
    const usable = points.filter(p => (!o.logX || p.x > 0) && (!o.logY || p.y > 0));
    const all = o.series.flatMap(s => s.points);
    const x = makeScale(
        all.map(p => p.x).filter(v => !o.logX || v > 0), o.logX, false, [margin.left, width - margin.right]);
    if (!o.logX)
        x.domain(padded(d3.extent(all, p => p.x)));
    const spread = p => (p.spread ? [p.y - p.spread, p.y + p.spread] : [p.y]);
    const y = makeScale(usable.flatMap(spread).filter(v => !o.logY || v > 0), o.logY, o.zero,
        [height - margin.bottom, margin.top]);
    const svg = svgElement('svg', {
        width,
        height,
        viewBox: `0 0 ${width} ${height}`,
        tabindex: '0',
        role: 'img',
        'aria-label':
            `${o.title || 'Curves'}: ${o.yLabel} against ${o.xLabel}. Arrow keys go from point to point.`
    });
    svg.append(axes(o, x, y, width, height, margin));
    for (const s of series)
        svg.append(drawSeries(s, usable.filter(p => p.series === s), x, y));
    const ring = svgElement('circle', {class: 'near', r: 8, visibility: 'hidden'});
    svg.append(ring);
    followPoints(svg, ring, tip, usable.filter(p => !p.series.ideal), x, y, o, width);
    return svg;
}

function padded([least, most]) {
    const space = (most - least || 1) * 0.04;
    return [least - space, most + space];
}

function axes(o, x, y, width, height, margin) {
    const g = svgElement('g', {'aria-hidden': 'true'}), grid = svgElement('g', {class: 'grid'});
    const across = apart(o.ticksX ? o.ticksX.filter(t => t >= x.domain()[0] && t <= x.domain()[1])
                                  : ticksOf(x, o.logX, width / 90, 34),
        x, 34);
    const unit = axisUnit(o.yLabel, d3.max(o.series.flatMap(s => s.points), p => Math.abs(p.y)));
    for (const t of ticksOf(y, o.logY, height / 50, 16)) {
        grid.append(svgElement('line', {x1: margin.left, x2: width - margin.right, y1: y(t), y2: y(t)}));
        g.append(svgElement(
            'text', {x: margin.left - 8, y: y(t) + 4, 'text-anchor': 'end'}, axisNumber(t * unit.times)));
    }
    for (const t of across) {
        grid.append(svgElement('line', {x1: x(t), x2: x(t), y1: margin.top, y2: height - margin.bottom}));
        g.append(svgElement(
            'text', {x: x(t), y: height - margin.bottom + 17, 'text-anchor': 'middle'}, axisNumber(t)));
    }
    g.prepend(grid);
    if (o.zero)
        g.append(svgElement(
            'line', {class: 'zero', x1: margin.left, x2: width - margin.right, y1: y(0), y2: y(0)}));
    g.append(svgElement('text', {
        class: 'label',
        x: (margin.left + width - margin.right) / 2,
        y: height - 8,
        'text-anchor': 'middle'
    },
                 o.xLabel),
        svgElement('text', {
            class: 'label',
            transform: `translate(14 ${(margin.top + height - margin.bottom) / 2}) rotate(-90)`,
            'text-anchor': 'middle'
        },
            unit.label));
    return g;
}

/* Short times have an axis in ms or µs, as in the pictures of a study (chart_data.c): by how much its seconds
 * are multiplied, and its label. most: the greatest of the times. */
function axisUnit(label, most) {
    const [unit, times] = !most ? ['s', 1] : most < 1e-3 ? ['µs', 1e6] : most < 0.1 ? ['ms', 1e3] : ['s', 1];
    return /(^|, )s$/.test(label) ? {times, label: label.replace(/s$/, unit)} : {times: 1, label};
}

function axisNumber(t) {
    return Math.abs(t) >= 1e6 ? d3.format('.6~s')(t) : String(Number(t.toPrecision(6)));
}

function drawSeries(s, points, x, y) {
    const i = s.style, stroke = `var(--c${i % 8})`, g = svgElement('g', {'data-series': s.name});
    const sorted = s.line === false ? points : [...points].sort((a, b) => a.x - b.x);
    if (s.line !== false)
        g.append(svgElement('path', {
            d: d3.line().x(p => x(p.x)).y(p => y(p.y))(sorted) || '',
            fill: 'none',
            ...linePaint(s, i)
        }));
    for (const p of s.ideal ? [] : sorted) {
        if (p.spread)
            g.append(svgElement('line', {
                x1: x(p.x),
                x2: x(p.x),
                y1: y(p.y - p.spread),
                y2: y(p.y + p.spread),
                stroke,
                'stroke-width': 1.5
            }));
        if (p.marked)
            g.append(
                svgElement('circle', {class: 'marked', cx: x(p.x), cy: y(p.y), r: 9, stroke, fill: 'none'}));
        g.append(svgElement('path', {
            d: symbolPath(markerOf(i), s.hollow ? 60 : 46),
            transform: `translate(${x(p.x)} ${y(p.y)})`,
            ...markerPaint(s, i)
        }));
    }
    return g;
}

/* Shows the figures of the point next to the mouse, or that the arrow keys lead to. */
function followPoints(svg, ring, tip, points, x, y, o, width) {
    let at = -1;
    const order =
        points.map((p, i) => i).sort((a, b) => points[a].x - points[b].x || points[a].y - points[b].y);
    function show(i) {
        at = i;
        const p = points[i];
        ring.setAttribute('visibility', p ? 'visible' : 'hidden');
        tip.textContent = p ? p.tip || `${p.series.name}\n${o.xLabel} ${figure(p.x)}: ${figure(p.y)}` : '';
        if (!p)
            return;
        ring.setAttribute('cx', x(p.x));
        ring.setAttribute('cy', y(p.y));
        const left = Math.min(x(p.x) + 12, width - tip.offsetWidth - 4);
        tip.style.left = Math.max(0, left) + 'px';
        tip.style.top = Math.max(0, svg.offsetTop || 0) + y(p.y) - tip.offsetHeight + 16 + 'px';
    }
    svg.addEventListener('pointermove', e => {
        const box = svg.getBoundingClientRect(), px = e.clientX - box.left, py = e.clientY - box.top;
        let best = -1, least = 40 * 40;
        points.forEach((p, i) => {
            const d = (x(p.x) - px) ** 2 + (y(p.y) - py) ** 2;
            if (d < least)
                best = i, least = d;
        });
        show(best);
    });
    svg.addEventListener('pointerleave', () => show(-1));
    svg.addEventListener('blur', () => show(-1));
    svg.addEventListener('keydown', e => {
        const step = {ArrowRight: 1, ArrowLeft: -1, ArrowUp: 1, ArrowDown: -1}[e.key];
        if (!step || !points.length)
            return;
        e.preventDefault();
        const here = order.indexOf(at);
        show(order[(here + step + order.length) % order.length] ?? order[0]);
    });
}
