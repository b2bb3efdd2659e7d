/* channels_section.js - the map of the network's channels: how busy each was, in all or in a part of the
 * run. */

function channelsSection(trace, name) {
    if (!trace.channels.length || !trace.messageCount)
        return;
    const section = addSection('The network\'s channels', 'Channels: ' + baseName(name),
        'Each way of a connection is a line of its own, the wider and darker, the longer it was held. ' +
            `A circle is a node; its own channels into and out of the network colour it (${name}).`, name);
    const map = {
        trace,
        bin: -1,
        near: -1,
        canvas: element('canvas', {
            tabindex: '0',
            role: 'img',
            'aria-label': 'Map of the channels; the table behind has the figures'
        })
    };
    const none = element('p', {class: 'hint'}, 'The channel under the mouse.');
    const plot = element('div', {class: 'plot'}, map.canvas),
          readout = element('div', {class: 'readout', role: 'status'}, none);
    layOut(map);
    map.canvas.addEventListener('pointermove', e => {
        map.near = nearestChannel(map, e.offsetX, e.offsetY);
        drawChannels(map);
        readout.replaceChildren(map.near >= 0 ? element('p', {}, channelText(map, map.near)) : none);
    });
    section.append(channelControls(map), plot, channelScale(map), readout,
        later('The table behind', () => channelTable(trace)));
    onWidth(plot, width => {
        map.width = width;
        drawChannels(map);
    });
}

/* Which part of the run is shown; the parts as an animation. */
function channelControls(map) {
    const {trace} = map, whole = partText(trace) || 'the whole run';
    const note = element('span', {class: 'note', role: 'status'}), slider = element('input', {
        type: 'range',
        min: '-1',
        max: String(trace.bins - 1),
        value: '-1',
        oninput: () => show(Number(slider.value))
    });
    const show = bin => {
        map.bin = bin;
        slider.value = bin;
        const length = (trace.stop - trace.start) / trace.bins;
        note.textContent =
            bin < 0
                ? whole
                : `${roughly(trace.start + bin * length)} to ${roughly(trace.start + (bin + 1) * length)}`;
        drawChannels(map);
    };
    let timer = 0;
    const play = button('Play', () => {
        if (timer) {
            timer = void clearInterval(timer);
            play.textContent = 'Play';
            return;
        }
        play.textContent = 'Stop';
        timer = setInterval(() => show((map.bin + 1) % trace.bins), 125);
    });
    note.textContent = whole;
    return element('div', {class: 'controls'}, labelled('Part of the run', slider), play,
        button(partText(trace) ? 'All of it' : 'Whole run', () => show(-1)), note);
}

/* Places of all addresses, in units of one position. A hypercube's lower dimensions go to the right, the
 * others down. */
function layOut(map) {
    const {topology, channels} = map.trace, cube = !topology.columns;
    const across = cube ? 2 ** Math.ceil(topology.dimension / 2) : topology.columns;
    map.cube = cube;
    map.places = [];
    for (let a = 0; a < topology.positions; a++)
        map.places[a] = {x: a % across, y: Math.floor(a / across)};
    map.columns = across;
    map.rows = Math.ceil(topology.positions / across);
    if (!cube)
        for (let a = topology.positions, i = 0; a < topology.addresses; a++, i++)
            map.places[a] = {x: across + Math.floor(i / map.rows), y: i % map.rows};
    else
        placeServices(map, topology);
    dropIdle(map);
    map.columns = d3.max(map.places, p => p?.x) + 1;
    map.rows = d3.max(map.places, p => p?.y) + 1;
    map.links = channels.map((c, i) => ({...c, index: i}))
                    .filter(c => c.to !== null && map.places[c.from] && map.places[c.to] && isLink(map, c));
    map.ports = channels.map((c, i) => ({...c, index: i})).filter(c => c.to === null);
}

/* Services that no message came to take no place. */
function dropIdle(map) {
    const {columns, channels, topology} = map.trace, used = new Set();
    channels.forEach((c, i) => columns['channel.uses'][i] && used.add(c.from).add(c.to));
    map.places.forEach((p, a) => {
        if (a >= topology.positions && !used.has(a))
            delete map.places[a];
    });
}

/* On a mesh, only neighbours have a connection; channels are numbered as if those at the edges had some,
 * too. */
function isLink(map, c) {
    const a = map.places[c.from], b = map.places[c.to];
    return map.cube || Math.abs(a.x - b.x) + Math.abs(a.y - b.y) === 1;
}

/* Services of a cube hang on nodes, evenly spread, and its host on node 0 (net/topo.h): they stand beside
 * them, the host below. */
function placeServices(map, {positions, addresses, host}) {
    const services = addresses - positions - host;
    for (let i = 0; i < services + host; i++) {
        const {x, y} = map.places[i < services ? Math.floor(i * positions / services) : 0];
        map.places[positions + i] = {x: x - 0.38, y: y + (i < services ? -0.38 : 0.38)};
    }
}

function channelShare(map, i) {
    const {trace} = map, c = trace.columns;
    return map.bin < 0 ? c['channel.busy'].number(i) / (trace.stop - trace.start)
                       : c['channel.share'][i * trace.bins + map.bin] / 65535;
}

function shareColour(share) {
    return d3.interpolateRgbBasis([colour('line'), colour('c1'), colour('mark')])(Math.min(1, share));
}

/* The busiest channel's share of the whole run is the end of the scale, or 10 %, so that a network that
 * is hardly used looks like that; of a part of it, all of the time. */
function channelScale(map) {
    map.most = d3.max([0.1, d3.max(map.trace.channels, (c, i) => channelShare({...map, bin: -1}, i))]);
    const ramp = element('span', {class: 'ramp'});
    ramp.style.background =
        `linear-gradient(to right, ${d3.range(9).map(i => shareColour(i / 8)).join(', ')})`;
    map.scaleText = element('span');
    return element('p', {class: 'note'}, 'in use 0 % ', ramp, ' ', map.scaleText, ' of the time');
}

function drawChannels(map) {
    if (!map.width)
        return;
    const scale = devicePixelRatio || 1, g = map.canvas.getContext('2d'), most = map.bin < 0 ? map.most : 1;
    const cell = Math.min(90, (map.width - 70) / map.columns, Math.max(16, 560 / map.rows)),
          height = cell * map.rows + 28;
    Object.assign(map, {cell, height, space: (map.width - cell * map.columns) / 2});
    map.canvas.width = map.width * scale;
    map.canvas.height = height * scale;
    map.canvas.style.height = height + 'px';
    g.scale(scale, scale);
    g.fillStyle = colour('ground');
    g.fillRect(0, 0, map.width, height);
    map.scaleText.textContent = `${figure(most * 100, 3)} %`;
    const ramp = d3.range(65).map(i => shareColour(i / 64)),
          tone = share => ramp[Math.round(Math.min(1, share / most) * 64)];
    for (const link of [...map.links].sort((a, b) => channelShare(map, a.index) - channelShare(map, b.index)))
        drawLink(g, map, link, tone(channelShare(map, link.index)),
            0.6 + 3.4 * Math.min(1, channelShare(map, link.index) / most) * Math.min(1, cell / 40));
    drawNodes(g, map, tone);
    numberEdges(g, map);
}

/* Where circles have no room for numbers, the nodes of the first row and of the first column have them
 * outside. */
function numberEdges(g, map) {
    const {cell} = map, every = [1, 2, 4, 8, 16, 32].find(n => n * cell >= 22) || 64;
    if (nodeRadius(map) >= NUMBERED)
        return;
    g.font = '11px system-ui, sans-serif';
    g.fillStyle = colour('soft');
    g.textBaseline = 'middle';
    map.places.forEach((place, address) => {
        const at = centre(map, address);
        if (address >= map.trace.topology.positions)
            return;
        g.textAlign = 'center';
        if (place.y === 0 && place.x % every === 0)
            g.fillText(String(address), at.x, 8);
        g.textAlign = 'right';
        if (place.x === 0 && place.y > 0 && (cell >= 11 || place.y % every === 0))
            g.fillText(String(address), at.x - cell / 2 - 2, at.y);
    });
}

const NUMBERED = 9; /* pixels: so large circles have numbers of up to three digits */

function nodeRadius(map) { return Math.min(11, map.cell * 0.22); }

function centre(map, address) {
    const p = map.places[address];
    return {x: map.space + (p.x + 0.5) * map.cell, y: 16 + (p.y + 0.5) * map.cell};
}

/* The two ends of a link and the point to which it is bent: a straight line between neighbours, moved to
 * its right, an arc over those between. */
function linkCurve(map, link) {
    const a = centre(map, link.from), b = centre(map, link.to), dx = b.x - a.x, dy = b.y - a.y,
          length = Math.hypot(dx, dy) || 1;
    const far = length / map.cell > 1.5, side = Math.min(3, map.cell / 12),
          bend = far ? Math.min(map.cell * 0.42, 6 + length * 0.09) : 0;
    const nx = -dy / length, ny = dx / length;
    return {
        a: {x: a.x + nx * side, y: a.y + ny * side},
        b: {x: b.x + nx * side, y: b.y + ny * side},
        c: {x: (a.x + b.x) / 2 + nx * (side + 2 * bend), y: (a.y + b.y) / 2 + ny * (side + 2 * bend)}
    };
}

function drawLink(g, map, link, tone, width) {
    const {a, b, c} = linkCurve(map, link);
    g.strokeStyle = link.index === map.near ? colour('ink') : tone;
    g.lineWidth = link.index === map.near ? width + 1.5 : width;
    g.beginPath();
    g.moveTo(a.x, a.y);
    g.quadraticCurveTo(c.x, c.y, b.x, b.y);
    g.stroke();
}

function drawNodes(g, map, tone) {
    const radius = nodeRadius(map), shares = new Map(), used = new Set(map.trace.nodes.map(n => n.address));
    for (const port of map.ports)
        shares.set(port.from, Math.max(shares.get(port.from) || 0, channelShare(map, port.index)));
    g.textAlign = 'center';
    g.textBaseline = 'middle';
    g.font = `${Math.min(11, Math.max(7, radius))}px system-ui, sans-serif`;
    map.places.forEach((place, address) => {
        const node = used.has(address), at = centre(map, address);
        const service = address >= map.trace.topology.positions;
        g.beginPath();
        if (service)
            g.rect(at.x - radius * 0.7, at.y - radius * 0.7, radius * 1.4, radius * 1.4);
        else
            g.arc(at.x, at.y, radius, 0, 7);
        g.fillStyle = colour('ground');
        g.fill();
        g.lineWidth = Math.max(1, radius / 4);
        g.strokeStyle = node || service ? tone(shares.get(address) || 0) : colour('line');
        g.stroke();
        g.fillStyle = colour(node ? 'ink' : 'soft');
        if (!service && radius >= NUMBERED && address < 1000)
            g.fillText(String(address), at.x, at.y + 0.5, radius * 1.75);
    });
}

/* The link next to the point: its curve is tried at some places. */
function nearestChannel(map, x, y) {
    let best = -1, least = 12 * 12;
    for (const link of map.links) {
        const {a, b, c} = linkCurve(map, link);
        for (let k = 1; k < 16; k++) {
            const t = k / 16, u = 1 - t;
            const d = (u * u * a.x + 2 * u * t * c.x + t * t * b.x - x) ** 2 +
                      (u * u * a.y + 2 * u * t * c.y + t * t * b.y - y) ** 2;
            if (d < least)
                best = link.index, least = d;
        }
    }
    return best;
}

function channelText(map, i) {
    const c = map.trace.columns;
    return `${map.trace.channels[i].name}: ${plural(c['channel.uses'][i], 'message')}, in use for ${
               duration(c['channel.busy'].at(
                   i))}; messages waited ${duration(c['channel.blocked'].at(i))} for it` +
           (map.bin < 0 ? '' : `; ${(channelShare(map, i) * 100).toFixed(1)} % of the part shown`);
}

function channelTable(trace) {
    const c = trace.columns, rows = trace.channels.map((channel, i) => ({name: channel.name, i}))
                                        .filter(r => c['channel.uses'][r.i]);
    rows.sort((a, b) => c['channel.busy'].number(b.i) - c['channel.busy'].number(a.i));
    return figureTable('Channels that were used',
        [
            {name: 'Channel', text: true, get: r => r.name},
            {name: 'messages', get: r => c['channel.uses'][r.i]},
            {name: 'in use', get: r => c['channel.busy'].at(r.i)}, {
                name: 'share',
                get: r => c['channel.busy'].number(r.i) / (trace.stop - trace.start),
                show: v => `${(v * 100).toFixed(2)} %`
            },
            {name: 'waited for', get: r => c['channel.blocked'].at(r.i)}
        ],
        rows);
}
