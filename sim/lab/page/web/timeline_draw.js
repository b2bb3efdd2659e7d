/* timeline_draw.js - draws the nodes' time into a canvas. Where pieces are narrower than a pixel, the
 * pixel's colour is the mix of theirs, by their time; so nothing is left out, and drawing takes a time
 * that hardly grows with the trace. */

/* view: { from, to (ps), top (rows above, may be a fraction, without those that are pinned), rowHeight
 * (CSS pixels) }. layout: { width, height, left, axis, scale (device pixels for one) } in CSS pixels:
 * left: room for the names, axis: for the times. */
const MOST_PINNED = 178; /* CSS pixels of pinned rows where rows are low: a third of the timeline */

class TimelinePainter {
    constructor(trace, canvas) {
        this.trace = trace;
        this.canvas = canvas;
        this.buffer = document.createElement('canvas');
        this.readColours();
    }
    readColours() {
        this.colours = this.trace.kinds.map(({tone}) => rgb(colour(tone)));
        this.tones = Float64Array.from(this.colours.flat());
        this.ink = colour('ink');
        this.soft = colour('soft');
        this.line = colour('line');
        this.ground = colour('ground');
        this.mark = colour('mark');
    }
    resize(width, height, scale) {
        this.layout = {width, height, scale, left: width < 500 ? 40 : 72, axis: 26};
        this.canvas.width = Math.round(width * scale);
        this.canvas.height = Math.round(height * scale);
        this.canvas.style.height = height + 'px';
    }
    x(time, view) {
        const {left, width} = this.layout;
        return left + (time - view.from) / (view.to - view.from) * (width - left);
    }
    /* Pinned rows stay below the axis. Where rows are low, pinned ones are higher. */
    y(row, view) {
        const {pinned} = this.trace, {axis} = this.layout;
        return row < pinned ? axis + row * this.rowHeight(row, view)
                            : axis + this.pinnedHeight(view) + (row - pinned - view.top) * view.rowHeight;
    }
    rowHeight(row, view) {
        const {pinned} = this.trace;
        return row < pinned ? Math.max(view.rowHeight, Math.min(12, MOST_PINNED / pinned)) : view.rowHeight;
    }
    pinnedHeight(view) {
        return this.trace.pinned * this.rowHeight(0, view);
    }
    timeAt(x, view) {
        const {left, width} = this.layout;
        return view.from + (x - left) / (width - left) * (view.to - view.from);
    }
    rowAt(y, view) {
        const below = y - this.layout.axis, under = below - this.pinnedHeight(view);
        return under < 0 ? Math.floor(below / this.rowHeight(0, view))
                         : Math.floor(this.trace.pinned + view.top + under / view.rowHeight);
    }
    /* With those that are pinned. */
    rowsInView(view) {
        const {height, axis} = this.layout;
        return this.trace.pinned + (height - axis - this.pinnedHeight(view)) / view.rowHeight;
    }
    /* Besides those that are pinned. */
    visibleRows(view) {
        const first = this.trace.pinned + Math.max(0, Math.floor(view.top));
        const last = Math.min(this.trace.rows.length,
            Math.ceil(view.top + this.rowsInView(view)));
        return {first, last};
    }
    /* selected: { row, piece } or null; marks: calls that were found; messages: draw their arrows;
     * message: the one to be marked; path: steps of the critical path; span: { from, to } that is chosen.
     * Returns how many arrows were drawn, of how many. */
    paint(view, {selected, marks, messages, message, path, span}) {
        const g = this.canvas.getContext('2d', {alpha: false}),
              {width, height, scale, axis, left} = this.layout;
        g.setTransform(scale, 0, 0, scale, 0, 0);
        g.fillStyle = this.ground;
        g.fillRect(0, 0, width, height);
        const {first, last} = this.visibleRows(view), {pinned} = this.trace;
        this.paintRows(g, view, first, last);
        g.save();
        g.beginPath();
        g.rect(left, axis, width - left, height - axis);
        g.clip();
        this.paintNames(g, view, first, last);
        g.restore();
        this.paintRows(g, view, 0, pinned);
        g.save();
        g.beginPath();
        g.rect(left, axis, width - left, height - axis);
        g.clip();
        this.paintNames(g, view, 0, pinned);
        const arrows = messages ? this.paintMessages(g, view) : {drawn: 0, count: 0};
        if (path)
            this.paintPath(g, view, path);
        if (message >= 0)
            this.paintArrows(g, view, [message], this.mark, 2);
        this.paintSelected(g, view, selected);
        this.paintSpan(g, view, span);
        g.restore();
        this.paintAxis(g, view);
        this.paintMarks(g, view, marks);
        this.paintNodes(g, view, selected);
        return arrows;
    }
    paintRows(g, view, first, last) {
        const {left, width, scale} = this.layout;
        const columns = Math.max(1, Math.round((width - left) * scale)), rows = last - first;
        const high = this.rowHeight(first, view);
        if (rows <= 0)
            return;
        if (!this.image || this.image.width !== columns || this.image.height !== rows) {
            this.buffer.width = columns;
            this.buffer.height = rows;
            this.image = this.buffer.getContext('2d').createImageData(columns, rows);
            this.pixels = new Uint32Array(this.image.data.buffer);
        }
        for (let r = 0; r < rows; r++)
            this.fillRow(this.trace.rows[first + r], view, r * columns, columns);
        this.buffer.getContext('2d').putImageData(this.image, 0, 0);
        g.imageSmoothingEnabled = false;
        g.drawImage(this.buffer, left, this.y(first, view), columns / scale, rows * high);
        g.fillStyle = this.ground; /* outside of the run there is nothing */
        if (view.from < this.trace.start)
            g.fillRect(left, this.y(first, view), this.x(this.trace.start, view) - left, rows * high);
        if (view.to > this.trace.stop)
            g.fillRect(this.x(this.trace.stop, view), this.y(first, view), width, rows * high);
        if (high >= 6) {
            g.fillStyle = this.ground;
            for (let r = first; r <= last; r++)
                g.fillRect(left, this.y(r, view) - (high >= 12 ? 1 : 0.5), width - left,
                    high >= 12 ? 2 : 1);
        }
    }
    /* Fills the pixels of a row from its pieces: the heart of the drawing. */
    fillRow(row, view, at, columns) {
        const {trace, pixels} = this, {pieceEnd, drawn, blockSums} = trace, kinds = this.colours.length;
        const last = row.first + row.pieces - 1, step = (view.to - view.from) / columns,
              sums = new Float64Array(kinds);
        const plain = this.colours.map(c => 0xff000000 | c[2] << 16 | c[1] << 8 | c[0]);
        let i = trace.pieceAt(row, view.from), time = view.from;
        for (let column = 0; column < columns; column++) {
            const end = view.from + (column + 1) * step;
            if (pieceEnd[i] >= end || i === last) { /* one piece fills the pixel */
                pixels[at + column] = plain[drawn[i]];
                time = end;
                continue;
            }
            sums.fill(0);
            while (i < last && pieceEnd[i] < end) {
                const block = i + PIECE_BLOCK - 1;
                if (i % PIECE_BLOCK === 0 && i > row.first && block < last && pieceEnd[block] < end &&
                    time === pieceEnd[i - 1]) {
                    for (let k = 0, from = i / PIECE_BLOCK * kinds; k < kinds; k++)
                        sums[k] += blockSums[from + k];
                    time = pieceEnd[block];
                    i += PIECE_BLOCK;
                } else {
                    sums[drawn[i]] += pieceEnd[i] - time;
                    time = pieceEnd[i++];
                }
            }
            sums[drawn[i]] += end - time;
            time = end;
            pixels[at + column] = this.mixed(sums, step);
        }
    }
    mixed(sums, all) {
        const tones = this.tones;
        let r = 0, g = 0, b = 0;
        for (let k = 0, t = 0; k < sums.length; k++, t += 3) {
            const share = sums[k] / all;
            r += share * tones[t];
            g += share * tones[t + 1];
            b += share * tones[t + 2];
        }
        return (0xff000000 | Math.min(255, b) << 16 | Math.min(255, g) << 8 | Math.min(255, r)) >>> 0;
    }
    /* Names of calls, in pieces that are wide enough. */
    paintNames(g, view, first, last) {
        const high = this.rowHeight(first, view);
        if (high < 12)
            return;
        const c = this.trace.columns, least = 34;
        g.font = '11px system-ui, sans-serif';
        g.textBaseline = 'middle';
        for (let r = first; r < last; r++) {
            const row = this.trace.rows[r], end = row.first + row.pieces;
            let x = this.layout.left;
            for (let i = this.trace.pieceAt(row, view.from), n = 0;
                 i < end && n < 1500 && x < this.layout.width; i++, n++) {
                const to = Math.min(this.x(this.trace.pieceEnd[i], view), this.layout.width);
                if (to - x > least)
                    this.paintName(g, x, to, this.y(r, view) + high / 2, i, c['piece.call'][i]);
                x = Math.max(x, to);
            }
        }
    }
    paintName(g, from, to, y, piece, call) {
        const text = call >= 0                          ? this.trace.callName(call)
                     : this.trace.activity[piece] === 1 ? 'handler'
                                                        : '';
        if (!text || g.measureText(text).width + 8 > to - from)
            return;
        const [red, green, blue] = this.colours[this.trace.drawn[piece]];
        g.fillStyle = red * 0.3 + green * 0.59 + blue * 0.11 > 128 ? '#14181c' : '#ffffff';
        g.fillText(text, from + 4, y + 0.5);
    }
    /* Which messages are under way in the view: those between two indexes, some of which are over. */
    messageRange(view) {
        const {latest, sentAt, messageCount} = this.trace;
        const bisect = (list, value) => {
            let low = 0, high = messageCount;
            while (low < high) {
                const middle = (low + high) >> 1;
                if (list[middle] >= value)
                    high = middle;
                else
                    low = middle + 1;
            }
            return low;
        };
        return {first: bisect(latest, view.from), last: bisect(sentAt, view.to)};
    }
    /* Of many arrows, some are drawn: always the same ones, which a hash of their number chooses. */
    paintMessages(g, view) {
        const {first, last} = this.messageRange(view), {overAt, fromRow, toRow} = this.trace, most = 1000;
        let count = 0;
        for (let i = first; i < last; i++)
            if (overAt[i] >= view.from && fromRow[i] >= 0 && toRow[i] >= 0)
                count++;
        const limit = count > most ? most / count * 4294967296 : 4294967296, list = [];
        for (let i = first; i < last; i++)
            if (overAt[i] >= view.from && fromRow[i] >= 0 && toRow[i] >= 0 &&
                Math.imul(i, 2654435761) >>> 0 < limit)
                list.push(i);
        this.paintArrows(g, view, list, this.ink, count > 300 ? 0.4 : 0.8);
        return {drawn: list.length, count};
    }
    paintArrows(g, view, list, ink, weight) {
        const heads = new Path2D();
        g.strokeStyle = g.fillStyle = ink;
        g.lineWidth = weight;
        g.beginPath();
        for (const i of list)
            this.addArrow(g, heads, view, i);
        g.stroke();
        g.fill(heads);
    }
    addArrow(lines, heads, view, i) {
        const {fromRow, toRow, sentAt, overAt} = this.trace;
        if (fromRow[i] < 0 || toRow[i] < 0)
            return;
        const middle = row => this.y(row, view) + this.rowHeight(row, view) / 2;
        const limit = x => Math.max(-1e5, Math.min(1e5, x));
        const x1 = limit(this.x(sentAt[i], view)), y1 = middle(fromRow[i]);
        const x2 = limit(this.x(overAt[i], view)), y2 = middle(toRow[i]);
        const length = Math.hypot(x2 - x1, y2 - y1) || 1, head = Math.min(7, length);
        const dx = (x2 - x1) / length, dy = (y2 - y1) / length;
        lines.moveTo(x1, y1);
        lines.lineTo(x2, y2);
        heads.moveTo(x2, y2);
        heads.lineTo(x2 - head * dx - head / 2.5 * dy, y2 - head * dy + head / 2.5 * dx);
        heads.lineTo(x2 - head * dx + head / 2.5 * dy, y2 - head * dy - head / 2.5 * dx);
    }
    /* The critical path: along the rows, and from row to row where a message leads. */
    paintPath(g, view, path) {
        const first = d3.bisector(s => s.to).left(path, view.from);
        let x = null, row = null;
        g.beginPath();
        for (let i = Math.max(0, first - 1); i < path.length && (i === 0 || path[i - 1].from <= view.to);
             i++) {
            const s = path[i], to = this.x(s.to, view);
            if (s.row < 0 || (s.row === row && to - x < 0.5))
                continue;
            const y = this.y(s.row, view) + this.rowHeight(s.row, view) * 0.8;
            if (row === null)
                g.moveTo(Math.max(-1e5, this.x(s.from, view)), y);
            else
                g.lineTo(this.x(s.from, view), y);
            g.lineTo(Math.min(1e5, to), y);
            x = to;
            row = s.row;
        }
        g.strokeStyle = this.mark;
        g.lineWidth = Math.max(1.5, Math.min(3, view.rowHeight / 6));
        g.lineJoin = 'round';
        g.stroke();
    }
    paintSelected(g, view, selected) {
        if (!selected)
            return;
        const row = this.trace.rows[selected.row], i = selected.piece;
        const from = i === row.first ? this.trace.start : this.trace.pieceEnd[i - 1];
        const x = Math.max(this.x(from, view), this.layout.left),
              to = Math.min(this.x(this.trace.pieceEnd[i], view), this.layout.width);
        g.strokeStyle = this.ink;
        g.lineWidth = 2;
        const high = this.rowHeight(selected.row, view);
        g.strokeRect(x, this.y(selected.row, view) + 1, Math.max(2, to - x), Math.max(2, high - 2));
    }
    /* An interval that was chosen: what is beside it fades. */
    paintSpan(g, view, span) {
        if (!span)
            return;
        const {left, width, axis, height} = this.layout;
        const from = Math.max(left, this.x(Math.min(span.from, span.to), view)),
              to = Math.min(width, this.x(Math.max(span.from, span.to), view));
        g.globalAlpha = 0.55;
        g.fillStyle = this.ground;
        g.fillRect(left, axis, Math.max(0, from - left), height - axis);
        g.fillRect(to, axis, Math.max(0, width - to), height - axis);
        g.globalAlpha = 1;
        g.fillStyle = this.ink;
        g.fillRect(from - 0.5, axis, 1, height - axis);
        g.fillRect(to - 0.5, axis, 1, height - axis);
    }
    /* The time axis. Far into a run, a label is what is to be added to the moment at the left. */
    paintAxis(g, view) {
        const {left, width, axis} = this.layout, span = view.to - view.from,
                            count = Math.max(2, (width - left) / 110);
        g.fillStyle = this.ground;
        g.fillRect(0, 0, width, axis);
        g.fillStyle = g.strokeStyle = this.soft;
        g.font = '11px system-ui, sans-serif';
        g.textBaseline = 'middle';
        g.textAlign = 'left';
        const whole = span > view.to * 1e-5, origin = whole ? 0 : view.from;
        for (const t of d3.ticks(view.from - origin, view.to - origin, count)) {
            const x = this.x(origin + t, view);
            const text = t === 0 && !whole ? '+0' : (whole ? '' : '+') + axisTime(t, span);
            if (x + 4 + g.measureText(text).width < width)
                g.fillText(text, x + 4, axis / 2);
            g.fillRect(x, axis - 8, 1, 8);
        }
    }
    paintMarks(g, view, marks) {
        g.fillStyle = this.mark;
        for (const {call} of marks || [])
            if (call !== undefined) {
                const time = this.trace.columns['call.begin'].number(call);
                if (time >= view.from && time <= view.to)
                    g.fillRect(this.x(time, view) - 1, this.layout.axis - 5, 2, 5);
            }
    }
    rowName(r) {
        const name = this.trace.rows[r].name;
        return this.layout.left < 60 ? name.replace('node ', '') : name;
    }
    paintNodes(g, view, selected) {
        const {first, last} = this.visibleRows(view), {left, axis, height} = this.layout;
        g.fillStyle = this.ground;
        g.fillRect(0, axis, left - 4, height - axis);
        g.font = '11px system-ui, sans-serif';
        g.textAlign = 'right';
        g.textBaseline = 'middle';
        const every = r => [1, 2, 4, 8, 16, 32, 64].find(n => n * this.rowHeight(r, view) >= 12) || 128;
        const chosen = selected ? selected.row : -1, near = 11 / view.rowHeight, {pinned} = this.trace;
        const rows = [...d3.range(Math.min(pinned, first)), ...d3.range(first, last)];
        for (const r of rows) {
            const y = this.y(r, view) + this.rowHeight(r, view) / 2,
                  hidden = chosen >= 0 && Math.abs(r - chosen) < near;
            if (y < axis || (r >= pinned && y < axis + this.pinnedHeight(view)) ||
                (r !== chosen && (r % every(r) || hidden)))
                continue;
            g.fillStyle = r === chosen ? this.ink : this.soft;
            g.fillText(this.rowName(r), left - 10, Math.max(y, axis + 6)); /* whole, of the first row, too */
        }
        g.textAlign = 'left';
        g.fillStyle = this.ground;
        g.fillRect(0, 0, left - 4, axis);
        g.fillStyle = this.line;
        g.fillRect(left - 1, 0, 1, height);
    }
}

/* A time on the axis: in the unit of the span, with as many digits as tell the ticks apart. */
function axisTime(time, span) {
    for (const unit of ['s', 'ms', 'us', 'ns'])
        if (span >= Number(PICOSECONDS[unit]) || (unit === 's' && span >= 5e11)) {
            const one = Number(PICOSECONDS[unit]),
                  decimals = Math.max(0, Math.ceil(-Math.log10(span / one / 10)));
            return (time / one).toFixed(decimals) + ' ' + UNIT_TEXT[unit];
        }
    return Math.round(time) + ' ps';
}
