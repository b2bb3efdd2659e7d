/* timeline_section.js - the timeline of a trace: zoom, pan, search, messages, and all that is known of a
 * piece. */

function traceSections(trace, name) {
    const section = addSection(`Timeline of ${baseName(trace.program)} on ${trace.machine}`, 'Timeline: ' + baseName(name),
        [...commandText(trace.command), ` (${name}): ${nodesText(trace.nodes.filter(n => n.traced && n.ran))}, ${
            plural(trace.pieceCount,
                'interval')}, ${plural(trace.messageCount, 'message')} ${spanText(trace)}.`],
        name);
    if (!trace.rows.length) {
        section.append(element('p', {}, 'No node of the trace did anything that took time.'));
        return section;
    }
    const timeline = trace.timeline = new Timeline(trace, section, name);
    matrixSection(trace, name, timeline);
    channelsSection(trace, name);
    return section;
}

class Timeline {
    constructor(trace, section, name) {
        Object.assign(this, {
            trace,
            section,
            name,
            selected: null,
            span: null,
            found: [],
            message: -1,
            onrange: [],
            bounds: trace, /* what can be shown: all of it */
            order: {by: 'number', hostsFirst: false}
        });
        const shown = trace.rows.length;
        this.view = {
            from: trace.start,
            to: trace.stop,
            top: 0,
            rowHeight: shown > 267 ? Math.max(1, 534 / shown) : Math.min(22, Math.floor(534 / shown))
        };
        this.canPin = trace.hosts > 0 && trace.hosts <= shown / 4;
        /* Where rows are low, a few hosts begin pinned: their rows are then higher (as in trace show). */
        this.order.hostsFirst = this.canPin && trace.hosts <= 16 && this.view.rowHeight < 12;
        trace.orderBy(this.order.by, this.order.hostsFirst);
        this.messages = trace.messageCount > 0 && trace.messageCount <= 400;
        this.makeCanvas();
        this.makeControls();
        section.append(this.controls, this.plot, this.legend, this.readout, this.makeSearch(),
            later('The table behind: each node in the interval shown', () => this.makeShares()),
            element('p', {class: 'note hint'},
                'Click the timeline; then the wheel or two fingers zoom, and dragging moves. Keys: ',
                keys('← →'), ' move, ', keys('+ −'), ' zoom, ', keys('0'), ' everything, ', keys('↑ ↓'),
                ' another node, ', keys(', .'), ' the piece before and after, ', keys('Esc'),
                ' gives the wheel back to the page. Shift and dragging choose an interval, and show its sums. ',
                'Where intervals are narrower than a pixel, its colour is the mix of theirs.'));
        onWidth(this.plot, width => this.resize(width));
        this.showRange();
    }
    makeCanvas() {
        this.canvas = element('canvas', {
            tabindex: '0',
            role: 'application',
            'aria-label': 'Timeline of the nodes',
            'aria-describedby': this.section.id + '-readout'
        });
        this.tip = element('div', {class: 'tip', 'aria-hidden': 'true'});
        this.plot = element('div', {class: 'plot'}, this.canvas, this.tip);
        this.legend = element('ul', {class: 'legend'});
        this.fillLegend();
        this.readout = element('div',
            {class: 'readout', id: this.section.id + '-readout', role: 'status', 'aria-live': 'polite'},
            element('p', {class: 'hint'}, 'Click a piece, or press ', keys(','), ' or ', keys('.'), ' to see what it is.'));
        this.painter = new TimelinePainter(this.trace, this.canvas);
        this.canvas.timeline = this; /* for whoever drives the page */
        this.canvas.addEventListener('keydown', e => this.key(e));
        this.canvas.addEventListener('focus', () => this.canvas.classList.add('active'));
        this.canvas.addEventListener('blur', () => this.canvas.classList.remove('active'));
        this.canvas.addEventListener('click', e => this.click(e));
        this.canvas.addEventListener('pointermove', e => this.hover(e));
        this.canvas.addEventListener('pointerleave', () => { this.tip.textContent = ''; });
        this.canvas.addEventListener('wheel', e => this.wheel(e), {passive: false});
        this.followPointers();
    }
    resize(width) {
        const {rows, pinned} = this.trace, {rowHeight} = this.view,
              more = this.painter.pinnedHeight(this.view) - pinned * rowHeight;
        const height = Math.min(Math.max(rows.length * rowHeight + 26, 120), 560) + more;
        this.painter.readColours();
        this.painter.resize(width, height, devicePixelRatio || 1);
        this.draw();
    }
    /* Draws before the browser shows the next picture, once however often it is asked. */
    draw() {
        if (!this.waiting)
            this.waiting = requestAnimationFrame(() => {
                this.waiting = 0;
                this.paint();
            });
    }
    paint() {
        this.noteRows();
        const arrows = this.painter.paint(this.view, {
            selected: this.selected,
            marks: this.found,
            messages: this.messages,
            message: this.message,
            path: this.pathShown ? this.path : null,
            span: this.span
        });
        this.arrowNote.textContent =
            this.messages && arrows.drawn < arrows.count
                ? `${grouped(String(arrows.drawn))} of ${grouped(String(arrows.count))} drawn`
                : '';
    }
    /* Which rows are seen, unless all are. */
    noteRows() {
        const {first, last} = this.painter.visibleRows(this.view), rows = this.trace.rows;
        this.rowNote.textContent = last - first >= rows.length - this.trace.pinned
                                       ? ''
                                       : `${rows[first].name} to ${rows[last - 1].name} of ${
                                             rows.length}: drag, or Page Up and Page Down`;
    }
    fillLegend() {
        this.legend.replaceChildren(...this.trace.kinds.map(({name, tone}) => {
            const box = element('span', {class: 'swatch'});
            box.style.backgroundColor = `var(--${tone})`;
            return element('li', {class: 'key'}, box, name);
        }));
    }
    colourBy(what) {
        this.trace.colourBy(what);
        this.painter.readColours();
        this.fillLegend();
        this.draw();
        if (this.span)
            this.showSpan();
    }
    /* Orders the rows; what is selected stays so, wherever its row is now. */
    orderBy(order) {
        const row = this.selected && this.trace.rows[this.selected.row];
        Object.assign(this.order, order);
        this.trace.orderBy(this.order.by, this.order.hostsFirst);
        if (row)
            this.selected.row = this.trace.rows.indexOf(row);
        this.placePath();
        this.resize(this.plot.clientWidth);
        this.clampTop();
    }
    makeControls() {
        const range = text => element('input', {
            type: 'text',
            'aria-label': text,
            spellcheck: 'false',
            autocomplete: 'off',
            onchange: () => this.readRange()
        });
        this.fromInput = range('From, such as 1.5 s or 12 ms');
        this.toInput = range('To, such as 1.5 s or 12 ms');
        this.arrowNote = element('span', {class: 'note'});
        this.rowNote = element('span', {class: 'note'});
        const rowSizes = [2, 3, 6, 12, 16, 22].map(n => [n, n < 6 ? `small (${n})`
                                                            : n < 16 ? `middle (${n})`
                                                                     : `large (${n})`]);
        const all = Math.min(22, 534 / this.trace.rows.length);
        rowSizes.push([all, 'all in view']);
        if (!rowSizes.some(([n]) => n === this.view.rowHeight))
            rowSizes.push([this.view.rowHeight, 'to fit']);
        this.controls = element('div', {class: 'controls'},
            element('span', {class: 'group', role: 'group', 'aria-label': 'Zoom'},
                button('−', () => this.zoom(2), {'aria-label': 'Zoom out'}),
                button('+', () => this.zoom(0.5), {'aria-label': 'Zoom in'}),
                button('All', () => this.setRange(this.bounds.start, this.bounds.stop)),
                button('◀', () => this.move(-0.5), {'aria-label': 'Earlier'}),
                button('▶', () => this.move(0.5), {'aria-label': 'Later'})),
            labelled('from', this.fromInput), labelled('to', this.toInput),
            choice('rows', rowSizes, this.view.rowHeight,
                v => {
                    this.view.rowHeight = Number(v);
                    this.resize(this.plot.clientWidth);
                    this.clampTop();
                }),
            choice('order', [['number', 'by number'], ['idle', 'the longest waiting first']], 'number',
                by => this.orderBy({by})),
            this.canPin
                ? checkbox('hosts on top', this.order.hostsFirst, on => this.orderBy({hostsFirst: on}))
                : null,
            choice('colour by',
                [['activity', 'activity'], ['call', 'call'], ['function', 'function']],
                'activity', what => this.colourBy(what)),
            checkbox('messages', this.messages, on => {
                this.messages = on;
                this.draw();
            }), this.arrowNote, this.rowNote);
    }
    /* steps: of the critical path, as touchstone trace why --json --path has them. */
    showPath(steps, name) {
        this.path = steps.map(s => ({from: Number(s.begin_ps), to: Number(s.end_ps), node: s.node}));
        this.path.sort((a, b) => a.from - b.from);
        this.placePath();
        this.pathShown = true;
        this.controls.append(checkbox(`critical path (${name})`, true, on => {
            this.pathShown = on;
            this.draw();
        }));
        this.draw();
    }
    placePath() {
        const rows = new Map(this.trace.rows.map((row, i) => [row.index, i]));
        for (const step of this.path || [])
            step.row = rows.get(step.node) ?? -1;
    }
    /* --- what is shown --- */
    setRange(from, to) {
        const {start, stop} = this.bounds, least = Math.min(1000, stop - start);
        const span = Math.min(Math.max(to - from, least), stop - start);
        const middle = (from + to) / 2;
        this.view.from = Math.min(Math.max(to - from < least ? middle - span / 2 : from, start), stop - span);
        this.view.to = this.view.from + span;
        this.showRange();
        this.draw();
    }
    showRange() {
        this.shown =
            [[this.fromInput, this.viewFrom()], [this.toInput, this.viewTo()]].map(([input, time]) => {
                input.value = shortTime(time, this.view.to - this.view.from);
                return {text: input.value, time};
            });
        for (const f of this.onrange)
            f();
    }
    viewFrom() {
        return this.view.from <= this.bounds.start ? this.bounds.from : BigInt(Math.floor(this.view.from));
    }
    viewTo() { return this.view.to >= this.bounds.stop ? this.bounds.to : BigInt(Math.ceil(this.view.to)); }
    readRange() {
        const [from, to] = [this.fromInput, this.toInput].map(
            ({value}, i) => value === this.shown[i].text ? this.shown[i].time : parseTime(value));
        for (const [input, time] of [[this.fromInput, from], [this.toInput, to]])
            input.setCustomValidity(time === null ? 'A time such as 1.5 s, 12 ms or 3 us' : '');
        if (from === null || to === null || to <= from)
            return void (this.fromInput.reportValidity() && this.toInput.reportValidity());
        this.setRange(Number(from), Number(to));
    }
    zoom(factor, around = (this.view.from + this.view.to) / 2) {
        const {from, to} = this.view;
        this.setRange(around - (around - from) * factor, around + (to - around) * factor);
    }
    move(share) {
        const by = (this.view.to - this.view.from) * share;
        this.setRange(this.view.from + by, this.view.to + by);
    }
    clampTop() {
        const rows = this.painter.rowsInView(this.view); /* pinned in both */
        this.view.top = Math.max(0, Math.min(this.view.top, this.trace.rows.length - rows));
    }
    scrollRows(by) {
        this.view.top += by;
        this.clampTop();
        this.draw();
    }
    /* --- mouse and fingers --- */
    wheel(e) {
        if (document.activeElement !== this.canvas && !e.ctrlKey)
            return;
        e.preventDefault();
        const lines = e.deltaMode === 1 ? 16 : 1;
        if (e.shiftKey)
            this.scrollRows((e.deltaX || e.deltaY) * lines / this.view.rowHeight / 2);
        else if (Math.abs(e.deltaX) > Math.abs(e.deltaY))
            this.move(e.deltaX * lines / this.canvas.clientWidth);
        else
            this.zoom(1.0015 ** (e.deltaY * lines), this.painter.timeAt(e.offsetX, this.view));
    }
    /* One pointer drags, two zoom. A finger moves the page until the timeline has been clicked. */
    followPointers() {
        const down = new Map();
        this.canvas.addEventListener('pointerdown', e => {
            if (e.pointerType !== 'mouse' && !this.canvas.classList.contains('active'))
                return;
            down.set(e.pointerId, {x: e.offsetX, y: e.offsetY});
            this.dragged = 0;
            this.chooses = e.shiftKey;
            if (this.chooses)
                this.span = {from: this.timeAt(e.offsetX), to: this.timeAt(e.offsetX)};
            this.canvas.setPointerCapture(e.pointerId);
        });
        this.canvas.addEventListener('pointermove', e => {
            const was = down.get(e.pointerId);
            if (!was)
                return;
            const now = {x: e.offsetX, y: e.offsetY}, other = [...down].find(([id]) => id !== e.pointerId);
            down.set(e.pointerId, now);
            this.dragged += Math.abs(now.x - was.x) + Math.abs(now.y - was.y);
            if (this.chooses)
                this.chooseTo(this.timeAt(now.x));
            else if (other)
                this.pinch(was, now, other[1]);
            else
                this.drag(now.x - was.x, now.y - was.y);
        });
        for (const name of ['pointerup', 'pointercancel'])
            this.canvas.addEventListener(name, e => down.delete(e.pointerId));
    }
    drag(dx, dy) {
        this.view.top -= dy / this.view.rowHeight;
        this.clampTop();
        this.move(-dx / (this.painter.layout.width - this.painter.layout.left));
    }
    pinch(was, now, other) {
        const before = Math.abs(was.x - other.x), after = Math.abs(now.x - other.x);
        if (before > 4 && after > 4)
            this.zoom(before / after, this.painter.timeAt(other.x, this.view));
    }
    click(e) {
        this.canvas.focus();
        const row = this.painter.rowAt(e.offsetY, this.view);
        if (this.chooses)
            return this.dragged > 6 ? this.showSpan() : this.dropSpan();
        if (this.dragged > 6 || row < 0 || row >= this.trace.rows.length ||
            e.offsetY < this.painter.layout.axis || this.isOutside(e.offsetX))
            return;
        this.select(row, this.trace.pieceAt(this.trace.rows[row], this.painter.timeAt(e.offsetX, this.view)));
    }
    timeAt(x) {
        return Math.min(this.trace.stop, Math.max(this.trace.start, this.painter.timeAt(x, this.view)));
    }
    /* Is x before or behind the run, where only another one has something? */
    isOutside(x) { return this.timeAt(x) !== this.painter.timeAt(x, this.view); }
    /* Tells what is under the mouse. */
    hover(e) {
        const {axis, left, width} = this.painter.layout, row = this.painter.rowAt(e.offsetY, this.view);
        if (e.buttons || e.offsetY < axis || e.offsetX < left || !this.trace.rows[row] ||
            this.isOutside(e.offsetX)) {
            this.tip.textContent = '';
            return;
        }
        const piece = this.trace.pieceAt(this.trace.rows[row], this.painter.timeAt(e.offsetX, this.view));
        this.tip.textContent = this.trace.pieceTip(this.trace.rows[row], piece);
        this.tip.style.left = Math.max(0, Math.min(e.offsetX + 14, width - this.tip.offsetWidth - 4)) + 'px';
        const below = e.offsetY + 18, {height} = this.painter.layout;
        this.tip.style.top =
            (below + this.tip.offsetHeight < height ? below : e.offsetY - this.tip.offsetHeight - 8) + 'px';
    }
    /* --- an interval that is chosen --- */
    chooseTo(time) {
        this.span.to = time;
        this.draw();
    }
    dropSpan() {
        this.span = null;
        this.draw();
    }
    /* What all nodes did in it, by what the pieces' colours tell. */
    showSpan() {
        const {kinds, drawn} = this.trace;
        const [from, to] =
            [this.span.from, this.span.to].sort((a, b) => a - b).map(t => BigInt(Math.round(t)));
        const all = kinds.map(() => 0n);
        for (const row of this.trace.rows)
            this.sums(row, from, to, drawn, kinds.length).forEach((sum, k) => { all[k] += sum; });
        const whole = all.reduce((a, b) => a + b, 0n), span = Number(to - from);
        const end = time => rounded(shortTime(time, span), moment(time));
        this.readout.replaceChildren(
            element('p', {}, 'From ', end(from), ' to ', end(to),
                `, ${roughly(span)}, of ${nodesText(this.trace.rows)}: `,
                all.map((sum, k) => (sum ? `${kinds[k].name} ${percent(sum, whole)}` : ''))
                    .filter(text => text)
                    .join(', '),
                '.'),
            button('Zoom in on it', () => {
                this.setRange(Number(from), Number(to));
                this.dropSpan();
            }));
        this.draw();
    }
    /* --- keys --- */
    key(e) {
        const actions = {
            ArrowLeft: () => this.move(-0.15),
            ArrowRight: () => this.move(0.15),
            '+': () => this.zoom(0.6),
            '=': () => this.zoom(0.6),
            '-': () => this.zoom(1 / 0.6),
            0: () => this.setRange(this.bounds.start, this.bounds.stop),
            Home: () => this.setRange(this.bounds.start, this.bounds.start + this.view.to - this.view.from),
            End: () => this.setRange(this.bounds.stop - this.view.to + this.view.from, this.bounds.stop),
            ArrowUp: () => this.selectRow(-1),
            ArrowDown: () => this.selectRow(1),
            PageUp: () => this.scrollRows(-10),
            PageDown: () => this.scrollRows(10),
            '.': () => this.selectPiece(1),
            ',': () => this.selectPiece(-1),
            Escape: () => this.canvas.blur()
        };
        if (!actions[e.key] || e.ctrlKey || e.metaKey || e.altKey)
            return;
        e.preventDefault();
        actions[e.key]();
    }
    selectRow(by) {
        const row =
            Math.max(0, Math.min(this.trace.rows.length - 1, this.selected ? this.selected.row + by : 0));
        const time = this.selected ? this.selectedMiddle() : (this.view.from + this.view.to) / 2;
        this.select(row, this.trace.pieceAt(this.trace.rows[row], time), true);
    }
    selectedMiddle() {
        const row = this.trace.rows[this.selected.row], i = this.selected.piece;
        const from = i === row.first ? this.trace.start : this.trace.pieceEnd[i - 1];
        return (Math.max(from, this.view.from) + Math.min(this.trace.pieceEnd[i], this.view.to)) / 2;
    }
    selectPiece(by) {
        if (!this.selected)
            return this.selectRow(0);
        const row = this.trace.rows[this.selected.row];
        this.select(this.selected.row,
            Math.max(row.first, Math.min(row.first + row.pieces - 1, this.selected.piece + by)), true);
    }
    /* Selects a piece; reveal: and moves so that it is seen. */
    select(row, piece, reveal) {
        this.selected = {row, piece};
        this.message = this.trace.pieceMessages(piece)[0] ?? -1;
        this.readout.replaceChildren(
            ...this.trace.pieceText(this.trace.rows[row], piece).map(line => element('p', {}, line)));
        if (reveal)
            this.reveal(row, piece);
        this.draw();
    }
    reveal(row, piece) {
        const r = this.trace.rows[row],
              from = piece === r.first ? this.trace.start : this.trace.pieceEnd[piece - 1],
              to = this.trace.pieceEnd[piece];
        const span = this.view.to - this.view.from, rows = this.painter.rowsInView(this.view);
        if (to < this.view.from || from > this.view.to)
            this.setRange((from + to) / 2 - span / 2, (from + to) / 2 + span / 2);
        const {pinned} = this.trace;
        if (row >= pinned && (row < this.view.top + pinned || row >= this.view.top + rows - 1))
            this.view.top = row - rows / 2;
        this.clampTop();
    }
    /* --- search --- */
    makeSearch() {
        this.hits = element('ol', {class: 'results', 'aria-label': 'What was found'});
        this.hitNote = element('span', {class: 'note', role: 'status'});
        const input = element('input', {
            type: 'search',
            placeholder: 'crecv type 5 node 3',
            oninput: () => this.search(input.value),
            onkeydown: e => {
                if (e.key === 'Enter')
                    this.nextHit(e.shiftKey ? -1 : 1);
            }
        });
        return element('div', {},
            element('div', {class: 'controls', role: 'search'}, labelled('Search', input),
                button('Previous', () => this.nextHit(-1)), button('Next', () => this.nextHit(1)),
                this.hitNote),
            this.hits);
    }
    search(query) {
        const {found, count} = this.trace.search(query, 2000);
        this.found = found;
        this.hit = -1;
        this.hitNote.textContent =
            query.trim() ? `${plural(count, 'call')} found${
                               count > found.length
                                   ? `, the first ${grouped(String(found.length))} marked`
                                   : ''}; words may be calls, functions, type 5, node 3, message 12`
                         : '';
        this.hits.replaceChildren(...found.slice(0, 100).map(
            (hit, i) => element('li', {}, button(this.hitText(hit), () => this.showHit(i)))));
        this.draw();
    }
    hitText({call, message}) {
        if (message !== undefined)
            return this.trace.messageText(message);
        const c = this.trace.columns;
        return `${this.trace.nodes[c['call.node'][call]].name}, ${moment(c['call.begin'].at(call))}: ${
            this.trace.callText(call)}, ${duration(c['call.end'].at(call) - c['call.begin'].at(call))}`;
    }
    nextHit(by) {
        if (this.found.length)
            this.showHit((this.hit + by + this.found.length) % this.found.length);
    }
    showHit(i) {
        this.hit = i;
        this.hits.querySelectorAll('button').forEach(
            (b, k) => (k === i ? b.setAttribute('aria-current', 'true') : b.removeAttribute('aria-current')));
        this.hits.querySelector('[aria-current]')?.scrollIntoView({block: 'nearest'});
        const {call, message} = this.found[i], c = this.trace.columns;
        const from = message === undefined ? c['call.begin'].number(call) : this.trace.sentAt[message];
        const to = message === undefined ? c['call.end'].number(call) : this.trace.overAt[message];
        const node = message === undefined ? c['call.node'][call] : Math.max(0, c['message.from'][message]);
        const row = this.trace.rows.findIndex(r => r.index === node), space = Math.max((to - from) * 3, 1e6);
        if (row < 0)
            return;
        if (this.view.to - this.view.from > space * 40 || from < this.view.from || to > this.view.to)
            this.setRange(from - space, to + space);
        this.select(row, this.trace.pieceAt(this.trace.rows[row], from), true);
        if (message !== undefined) {
            this.message = message;
            this.readout.replaceChildren(element('p', {}, this.trace.messageText(message)));
        }
    }
    /* --- the table behind --- */
    makeShares() {
        const holder = element('div'), fill = () => holder.replaceChildren(...this.sharesTable());
        const follow = button('Of the interval shown now', fill);
        fill();
        return [holder, follow];
    }
    sharesTable() {
        const from = this.viewFrom(), to = this.viewTo();
        const rows = this.trace.rows.map(row => ({
            name: row.name,
            sums: this.sums(row, from, to, this.trace.activity, PIECE_NAMES.length)
        }));
        return [
            element('p', {class: 'note'}, 'From ', timeFigure(from), ' to ', timeFigure(to), '.'),
            ...figureTable('Each node\'s time',
                [
                    {name: 'Node', text: true, get: r => r.name},
                    ...this.trace.pieceNames().map((name, k) => ({name, get: r => r.sums[k]}))
                ],
                rows, 1024)
        ];
    }
    /* The node's exact time within the interval, by the kinds of its pieces. */
    sums(row, from, to, kindOf, kinds) {
        const c = this.trace.columns, ends = c['piece.end'], sums = new Array(kinds).fill(0n);
        const first = this.trace.pieceAt(row, Number(from) - 1), most = (a, b) => (a > b ? a : b);
        for (let i = first, begin = this.trace.pieceFrom(row, first);
             i < row.first + row.pieces && begin < to; i++) {
            const end = ends.at(i), part = (end < to ? end : to) - most(begin, from);
            if (part > 0n)
                sums[kindOf[i]] += part;
            begin = end;
        }
        return sums;
    }
}

function keys(text) { return text.split(' ').map(k => element('kbd', {}, k)); }
