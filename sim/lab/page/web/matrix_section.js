/* matrix_section.js - who sent how much to whom. */

function matrixSection(trace, name, timeline) {
    if (!trace.messageCount)
        return;
    const section = addSection('Who sends to whom', 'Matrix: ' + baseName(name),
        `A row is a sender, a column a receiver; the scale is logarithmic (${name}).`, name);
    const state = {figure: 'bytes', shownOnly: false}, canvas = element('canvas', {
        tabindex: '0',
        role: 'img',
        'aria-label':
            'Communication matrix; the table behind has the figures. Arrow keys go from pair to pair.'
    });
    const plot = element('div', {class: 'plot'}, canvas),
          readout = element('div', {class: 'readout', role: 'status'});
    const scaleKey = element('p', {class: 'note'});
    let width = 0, matrix, at = null;
    const draw = () => {
        matrix = sumMatrix(trace, state.figure, state.shownOnly ? timeline.view : null);
        drawMatrix(canvas, matrix, width, at);
        showScale(scaleKey, matrix, state.figure);
        tell();
    };
    const tell = () => readout.replaceChildren(element('p', {class: at ? null : 'hint'},
        at ? pairText(matrix, at, state.figure)
           : 'The pair under the mouse, or that the arrow keys lead to.'));
    const go = (from, to) => {
        at = {
            from: Math.max(0, Math.min(matrix.count - 1, from)),
            to: Math.max(0, Math.min(matrix.count - 1, to))
        };
        drawMatrix(canvas, matrix, width, at);
        tell();
    };
    canvas.addEventListener('pointermove', e => {
        const pair = matrix.pairAt(e.offsetX - matrix.space, e.offsetY - matrix.space);
        go(pair.from, pair.to);
    });
    canvas.addEventListener('keydown', e => {
        const step = {ArrowUp: [-1, 0], ArrowDown: [1, 0], ArrowLeft: [0, -1], ArrowRight: [0, 1]}[e.key];
        if (step) {
            e.preventDefault();
            go(at ? at.from + step[0] : 0, at ? at.to + step[1] : 0);
        }
    });
    section.append(element('div', {class: 'controls'},
                       choice('Shown', [['bytes', 'bytes'], ['messages', 'messages']], 'bytes',
                           v => {
                               state.figure = v;
                               draw();
                           }),
                       checkbox('only the interval that the timeline shows', false,
                           on => {
                               state.shownOnly = on;
                               draw();
                           })),
        element('div', {class: 'beside'}, plot,
            element('div', {}, scaleKey, readout, later('The table behind', () => pairsTable(trace)))));
    timeline.onrange.push(() => state.shownOnly && width && draw());
    onWidth(section, w => {
        width = Math.min(w, 600);
        draw();
    });
}

/* Sums the messages by pair of nodes that had a program. Services have no row of their own; they share the
 * last. */
function sumMatrix(trace, what, view) {
    const nodes = trace.nodes.filter(n => n.ran), places = new Map(nodes.map((n, i) => [n, i]));
    const c = trace.columns, count = nodes.length + 1, sums = new Map(); /* of the pairs that have any */
    const place = node => places.get(trace.nodes[node]) ?? count - 1;
    let most = 0, services = false;
    for (let i = 0; i < trace.messageCount; i++) {
        if (view && (trace.sentAt[i] > view.to || trace.overAt[i] < view.from))
            continue;
        const from = place(c['message.from'][i]), to = place(c['message.to'][i]);
        services ||= from === count - 1 || to === count - 1;
        const key = from * count + to, part = what === 'bytes' ? c['message.bytes'].number(i) : 1,
              sum = (sums.get(key) || 0) + part;
        sums.set(key, sum);
        most = Math.max(most, sum);
    }
    const names = [...nodes.map(n => n.name), 'services'];
    return {sums, stride: count, count: services ? count : count - 1, most, names};
}

function matrixRamp(share) {
    return d3.interpolateRgbBasis([colour('panel'), colour('c0'), colour('ink')])(share);
}

function drawMatrix(canvas, matrix, width, at) {
    const scale = devicePixelRatio || 1, g = canvas.getContext('2d'), size = width - 2,
          space = matrix.count > 10000 ? 46 : 34; /* for a node's number */
    const cell = Math.min((size - space) / matrix.count, 28);
    Object.assign(matrix, {cell, space, gap: cell > 5 ? 1 : 0});
    const whole = matrix.cell * matrix.count, side = space + whole;
    canvas.width = (side + 2) * scale;
    canvas.height = (side + 2) * scale;
    canvas.style.height = canvas.style.width = side + 2 + 'px';
    g.scale(scale, scale);
    g.fillStyle = colour('ground');
    g.fillRect(0, 0, side + 2, side + 2);
    g.fillStyle = colour('panel');
    if (matrix.gap)
        drawEmptyCells(g, matrix);
    else
        g.fillRect(space, space, whole, whole);
    drawPairs(g, matrix);
    matrixLabels(g, matrix, at);
}

function drawEmptyCells(g, {count, cell, space, gap}) {
    for (let from = 0; from < count; from++)
        for (let to = 0; to < count; to++)
            g.fillRect(space + to * cell, space + from * cell, cell - gap, cell - gap);
}

/* Pairs that share a pixel are drawn as the largest of them, which the mouse finds there. */
function drawPairs(g, matrix) {
    const {sums, stride, count, cell, space, gap} = matrix, size = Math.max(cell, 1);
    const ramp = d3.range(65).map(i => matrixRamp(0.12 + i / 64 * 0.88)),
          most = Math.log(matrix.most + 1) || 1; /* messages may have no bytes */
    const step = Math.min(cell, 1), grid = Math.ceil(count * step), largest = new Map();
    const spot = (from, to) => Math.floor(from * step) * grid + Math.floor(to * step);
    for (const [key, sum] of sums) {
        const place = spot(Math.floor(key / stride), key % stride);
        if (!(sum <= sums.get(largest.get(place))))
            largest.set(place, key);
    }
    for (const [place, key] of largest) {
        g.fillStyle = ramp[Math.round(Math.log(sums.get(key) + 1) / most * 64)];
        g.fillRect(space + place % grid * size, space + Math.floor(place / grid) * size, size - gap, size - gap);
    }
    matrix.pairAt = (x, y) => {
        const number = at => Math.max(0, Math.min(count - 1, Math.floor(at / cell)));
        const from = number(y), to = number(x);
        const key = largest.get(spot(from, to)) ?? from * stride + to;
        return {from: Math.floor(key / stride), to: key % stride};
    };
}

function matrixLabels(g, matrix, at) {
    const {cell, space} = matrix, apart = Math.max(20, 8 * String(matrix.count).length),
          every = 2 ** Math.max(0, Math.ceil(Math.log2(apart / cell)));
    g.font = '11px system-ui, sans-serif';
    g.fillStyle = colour('soft');
    g.textBaseline = 'middle';
    for (let i = 0; i < matrix.count; i += every) {
        const name = matrix.names[i].replace('node ', '').replace('services', 'serv');
        g.textAlign = 'right';
        g.fillText(name, space - 5, space + (i + 0.5) * cell);
        g.textAlign = 'center';
        const end = space + matrix.count * cell, middle = space + (i + 0.5) * cell;
        g.fillText(name, Math.min(middle, end - g.measureText(name).width / 2), space - 10);
    }
    if (at) {
        g.strokeStyle = colour('mark');
        g.lineWidth = 2;
        const side = Math.max(cell, 1) + 1;
        g.strokeRect(space + at.to * cell - 1, space + at.from * cell - 1, side, side);
    }
}

function pairText(matrix, {from, to}, figureName) {
    const sum = matrix.sums.get(from * matrix.stride + to) || 0;
    return `${matrix.names[from]} to ${matrix.names[to]}: ${grouped(String(sum))} ${figureName}`;
}

function showScale(line, matrix, figureName) {
    const ramp = element('span', {class: 'ramp'});
    ramp.style.background =
        `linear-gradient(to right, ${d3.range(9).map(i => matrixRamp(0.12 + i / 8 * 0.88)).join(', ')})`;
    line.replaceChildren(
        `${Math.min(1, matrix.most)} `, ramp, ` ${grouped(String(matrix.most))} ${figureName}`);
}

function pairsTable(trace) {
    const c = trace.columns, pairs = new Map();
    for (let i = 0; i < trace.messageCount; i++) {
        const key = `${c['message.from'][i]} ${c['message.to'][i]}`;
        const pair = pairs.get(key) || {
            from: trace.nodeName(c['message.from'][i]),
            to: trace.nodeName(c['message.to'][i]),
            messages: 0,
            bytes: 0n
        };
        pair.messages++;
        pair.bytes += c['message.bytes'].at(i);
        pairs.set(key, pair);
    }
    return figureTable('Messages by pair',
        [
            {name: 'From', text: true, get: p => p.from}, {name: 'to', text: true, get: p => p.to},
            {name: 'messages', get: p => p.messages},
            {name: 'bytes', get: p => p.bytes, show: v => grouped(String(v))}
        ],
        [...pairs.values()].sort((a, b) => Number(b.bytes - a.bytes)));
}
