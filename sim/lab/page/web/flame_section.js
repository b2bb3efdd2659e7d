/* flame_section.js - a flame graph of folded stacks: "main;relax;csend 1234" a line. */

/* { name, value, children } of all stacks; a value holds those of its children. */
function readStacks(text) {
    const root = {name: 'all', value: 0, children: new Map()};
    for (const line of text.split('\n')) {
        const found = /^(.*) (\d+)$/.exec(line);
        if (!found || line.startsWith('#'))
            continue;
        let at = root, value = Number(found[2]);
        root.value += value;
        for (const frame of found[1].split(';')) {
            if (!at.children.has(frame))
                at.children.set(frame, {name: frame, value: 0, children: new Map()});
            at = at.children.get(frame);
            at.value += value;
        }
    }
    return root;
}

function flameSummary(text) {
    const root = readStacks(text), top = frameSums(root)[0];
    return {
        kind: 'Flame graph',
        big: root.value ? `${(top.own / root.value * 100).toFixed(1)} % in ${top.name}` : 'no frame',
        small: `${plural(text.split('\n').filter(Boolean).length, 'stack')}`
    };
}

function flameSection(text, name) {
    const section = addSection('Flame graph', 'Flame graph: ' + baseName(name),
        [
            `The width of a frame is its share of all time; what it called stands on it (${name}).`,
            element('span', {class: 'hint'}, ' A click, or Enter, widens a frame.')
        ],
        name);
    const root = readStacks(text);
    if (!root.value) {
        section.append(element('p', {}, 'No stack took any time.'));
        return section;
    }
    const flame = {
        root,
        top: root,
        query: '',
        holder: element('div'),
        readout: element('div', {class: 'readout', role: 'status'},
            element('p', {class: 'hint'}, 'The frame under the mouse, or that Tab leads to.'))
    };
    const input = element('input', {
        type: 'search',
        oninput: () => {
            flame.query = input.value.toLowerCase();
            drawFlame(flame, flame.holder.clientWidth);
        }
    });
    section.append(element('div', {class: 'controls'}, labelled('Mark frames with', input),
                       button('All', () => widen(flame, root))),
        element('figure', {}, flame.holder), flame.readout,
        later('The table behind: by frame', () => flameTable(root)));
    onWidth(flame.holder, width => drawFlame(flame, width));
    return section;
}

function widen(flame, node) {
    flame.top = node;
    drawFlame(flame, flame.holder.clientWidth);
    flame.holder.querySelector('[tabindex]')?.focus();
}

function flameColour(name) {
    let hash = 0;
    for (const ch of name)
        hash = (hash * 31 + ch.codePointAt(0)) >>> 0;
    return d3.interpolateRgb('#7fb0dc', '#bcdcf5')(hash % 97 / 96); /* blue, as computing is elsewhere */
}

function drawFlame(flame, width) {
    const height = 19, boxes = [], least = 0.6;
    const place = (node, depth, x) => {
        const w = node.value / flame.top.value * width;
        if (w < least)
            return;
        boxes.push({node, depth, x, w});
        for (const child of [...node.children.values()].sort((a, b) => (a.name < b.name ? -1 : 1))) {
            place(child, depth + 1, x);
            x += child.value / flame.top.value * width;
        }
    };
    place(flame.top, 0, 0);
    const depth = d3.max(boxes, b => b.depth) + 1;
    const svg = svgElement('svg', {
        width,
        height: depth * height,
        viewBox: `0 0 ${width} ${depth * height}`,
        role: 'group',
        'aria-label': 'Flame graph'
    });
    for (const b of boxes)
        svg.append(flameBox(flame, b, (depth - 1 - b.depth) * height, height));
    flame.holder.replaceChildren(svg);
}

function flameBox(flame, {node, x, w}, y, height) {
    const share = (node.value / flame.root.value * 100).toFixed(2),
          marked = flame.query && node.name.toLowerCase().includes(flame.query);
    const tell = () => flame.readout.replaceChildren(
        element('p', {}, `${node.name}: ${grouped(String(node.value))}, ${share} % of all`));
    const g = svgElement('g', {
        tabindex: w > 3 ? '0' : null,
        role: 'button',
        'aria-label': `${node.name}, ${share} %`,
        onclick: () => widen(flame, node),
        onpointerenter: tell,
        onfocus: tell,
        onkeydown: e => {
            if (e.key === 'Enter' || e.key === ' ') {
                e.preventDefault();
                widen(flame, node);
            }
        }
    },
        svgElement('rect', {
            x,
            y,
            width: Math.max(0.5, w - 0.7),
            height: height - 1,
            rx: 2,
            fill: marked ? 'var(--call)' : flameColour(node.name)
        }));
    const most = Math.floor((w - 8) / 6.6);
    if (most >= 3) {
        const text = svgElement('text', {x: x + 4, y: y + 13},
            node.name.length > most ? node.name.slice(0, most - 1) + '…' : node.name);
        text.style.fill = '#14181c';
        g.append(text);
    }
    return g;
}

/* By name: with what it called, and itself alone; the largest of these first. */
function frameSums(root) {
    const sums = new Map();
    const add = (node, above) => {
        const sum = sums.get(node.name) || {name: node.name, all: 0, own: 0};
        sums.set(node.name, sum);
        sum.own += node.value - [...node.children.values()].reduce((s, c) => s + c.value, 0);
        if (!above.includes(node.name))
            sum.all += node.value;
        node.children.forEach(c => add(c, [...above, node.name]));
    };
    root.children.forEach(c => add(c, []));
    return [...sums.values()].sort((a, b) => b.own - a.own);
}

function flameTable(root) {
    return figureTable('Frames',
        [
            {name: 'Frame', text: true, get: s => s.name}, {name: 'itself', get: s => s.own},
            {name: 'with what it called', get: s => s.all},
            {name: 'share', get: s => s.all / root.value, show: v => `${(v * 100).toFixed(2)} %`}
        ],
        frameSums(root));
}
