/* run_section.js - results of a run: where each node's time went. */
function nodeParts(nodes) {
    const away = nodes.some(n => n.name === 'host') ? 'no program' : 'ended';
    return [
        ['busy_s', 'computing', 'computing'], ['system_s', 'system', 'system'],
        ['idle_s', 'waiting (idle)', 'waiting'], ['away_s', away, 'ended']
    ];
}

function runSummary(data) {
    return {
        kind: 'Run',
        big: roughly(data.virtual_time_s * 1e12),
        small: `${baseName(data.program)} on ${plural(data.nodes, 'node')} of ${data.machine}; ${
            data.outcome}; ${plural(data.messages, 'message')}`
    };
}

function runSection(data, name) {
    const section = addSection(`Run of ${baseName(data.program)}`, 'Run: ' + baseName(name),
        [...commandText([data.program, ...data.arguments].join(' ')), ` (${name})`], name);
    section.append(facts([
        ['Virtual time', timeFigure(data.virtual_time_s)],
        ['Outcome', data.outcome + (data.message ? ': ' + data.message : '')],
        [
            'Machine', `${plural(data.nodes, 'node')} of ${data.machine}${
                           data.settings.length ? ', ' + data.settings.join(', ') : ''}`
        ],
        ['Messages', `${grouped(String(data.messages))}, ${plural(data.bytes, 'byte')}`],
        ['Digest', data.digest],
        ['Simulated in', `${roughly(data.wall_time_s * 1e12)} of this computer's time`]
    ]));
    const nodes = [
        ...data.node.map((n, i) => ({...n, name: `node ${i}`})),
        ...data.host ? [{...data.host, name: 'host'}] : []
    ];
    section.append(nodeBars(nodes, data.virtual_time_s));
    section.append(later('The table behind: each node', () => nodeTable(nodes)));
    section.append(later('What the nodes waited in', () => waitsTable(nodes)));
    if (data.files && Object.values(data.files).some(Boolean))
        section.append(element('h3', {}, 'Files'),
            facts(Object.entries(data.files).map(([k, v]) => [k.replace(/_/g, ' '), figure(v)])));
    return section;
}

function nodeTable(nodes) {
    return figureTable('Each node',
        [
            {name: 'Node', text: true, get: n => n.name},
            ...nodeParts(nodes).map(([key, text]) => ({name: text + ', s', get: n => n[key]})),
            {name: 'ended at, s', get: n => n.ended_s}, {name: 'handlers', get: n => n.handlers},
            {name: 'messages sent', get: n => n.messages_sent},
            {name: 'memory, bytes', get: n => n.memory_peak_bytes}
        ],
        nodes);
}

/* The waits of all nodes by call and type, the longest first. */
function waitsTable(nodes) {
    const sums = new Map();
    for (const n of nodes)
        for (const w of n.waits) {
            const key = `${w.call} ${w.type ?? ''}`;
            const sum = sums.get(key) || {call: w.call, type: w.type, idle: 0, waits: 0, nodes: 0};
            sum.idle += w.idle_s;
            sum.waits += w.waits;
            sum.nodes++;
            sums.set(key, sum);
        }
    return figureTable('Waits',
        [
            {name: 'Call', text: true, get: w => w.call},
            {name: 'type', get: w => w.type, show: v => (v === undefined ? '' : String(v))},
            {name: 'idle, s of all nodes', get: w => w.idle}, {name: 'waits', get: w => w.waits},
            {name: 'nodes', get: w => w.nodes}
        ],
        [...sums.values()].sort((a, b) => b.idle - a.idle));
}

/* A column a node: computing, system and idle time, of the whole run. */
function nodeBars(nodes, total) {
    const holder = element('div'), tip = element('div', {class: 'tip', role: 'status'});
    const legend = element('ul', {class: 'legend'}, nodeParts(nodes).map(([, text, c]) => {
        const box = element('span', {class: 'swatch'});
        box.style.backgroundColor = `var(--${c})`;
        return element('li', {class: 'key'}, box, text);
    }));
    onWidth(holder, width => holder.replaceChildren(drawBars(nodes, total, width, tip)));
    return element(
        'figure', {}, element('figcaption', {}, 'Where each node\'s time went'), holder, tip, legend);
}

function drawBars(nodes, total, width, tip) {
    const height = 260, margin = {left: 62, right: 10, top: 10, bottom: 40};
    const x = d3.scaleLinear().domain([0, nodes.length]).range([margin.left, width - margin.right]);
    const y = d3.scaleLinear().domain([0, total]).range([height - margin.bottom, margin.top]);
    const svg = svgElement('svg', {
        width,
        height,
        viewBox: `0 0 ${width} ${height}`,
        role: 'img',
        'aria-label': 'Computing, system and idle time of each node; the table behind has the figures'
    });
    const grid = svgElement('g', {class: 'grid'}), unit = axisUnit('s', total);
    for (const t of y.ticks(5))
        grid.append(svgElement('line', {x1: margin.left, x2: width - margin.right, y1: y(t), y2: y(t)}),
            svgElement('text', {x: margin.left - 8, y: y(t) + 4, 'text-anchor': 'end'},
                axisNumber(t * unit.times)));
    svg.append(grid);
    const gap = x(1) - x(0) > 4 ? Math.min(3, (x(1) - x(0)) * 0.15) : 0;
    const parts = nodeParts(nodes);
    nodes.forEach((n, i) => {
        let sum = 0;
        for (const [key, , c] of parts) {
            const value = n[key] || 0;
            svg.append(svgElement('rect', {
                x: x(i),
                width: Math.max(0.5, x(1) - x(0) - gap),
                y: y(sum + value),
                height: Math.max(0, y(sum) - y(sum + value)),
                fill: `var(--${c})`
            }));
            sum += value;
        }
    });
    for (const t of apart(
             x.ticks(Math.min(nodes.length, width / 60)).filter(t => Number.isInteger(t) && t < nodes.length),
             x, 30))
        svg.append(svgElement('text',
            {x: (x(t) + x(t + 1) - gap) / 2, y: height - margin.bottom + 16, 'text-anchor': 'middle'},
            nodes[t].name === 'host' ? 'host' : t));
    svg.append(
        svgElement('text',
            {class: 'label', x: (margin.left + width) / 2, y: height - 6, 'text-anchor': 'middle'}, 'node'),
        svgElement('text', {
            class: 'label',
            transform: `translate(14 ${height / 2 - 15}) rotate(-90)`,
            'text-anchor': 'middle'
        },
            unit.label));
    svg.addEventListener('pointermove', e => {
        const i = Math.floor(x.invert(e.clientX - svg.getBoundingClientRect().left)), n = nodes[i];
        tip.textContent =
            n ? `${n.name}\n` +
                    parts.map(([key, text]) => `${text} ${figure(n[key] || 0, 6)} s`).join('\n')
              : '';
        tip.style.left = Math.max(0, Math.min(x(i) + 14, width - tip.offsetWidth - 4)) + 'px';
        tip.style.top = '2rem';
    });
    svg.addEventListener('pointerleave', () => { tip.textContent = ''; });
    return svg;
}
