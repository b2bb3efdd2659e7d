/* trace_data.js - a trace as page_trace.c wrote it, and what is said of its parts. */

/* What a piece of a node's time is drawn as: names, order and colours as in touchstone trace show. */
const PIECE_COLOURS = ['computing', 'handler', 'system', 'call', 'waiting', 'ended'];
const PIECE_NAMES =
    ['computing', 'handler computing', 'system (message)', 'system (call)', 'waiting', 'ended'];
const STATE_DRAWN = [0, 3, 4, 2, 5]; /* of enum trace_state */
const TASK_NAMES =
    ['sending a message', 'receiving a message', 'feeding the network', 'emptying the network'];
const PIECE_BLOCK = 64; /* pieces whose times are summed, so that drawing can pass over them */

/* "type 5"; of MPI's messages "tag 5 in MPI_COMM_WORLD", as nx_api/waitfor/waitfor_mpi.c has it. */
function typeText(type, pid) {
    const FIRST_CONTEXT = 1 << 24, number = (pid - FIRST_CONTEXT) >> 1;
    if (pid < FIRST_CONTEXT)
        return `type ${type}`;
    return `${pid & 1 ? 'collective' : 'tag'} ${type} in ${
        ['MPI_COMM_WORLD', 'MPI_COMM_SELF'][number] || `communicator ${number}`}`;
}

async function readTrace(script) { return new Trace(readColumns(await takeBytes(script))); }

class Trace {
    constructor(columns) {
        Object.assign(this, columns.header);
        this.columns = columns;
        this.from = BigInt(columns.header.from);
        this.to = BigInt(columns.header.to);
        this.end = BigInt(columns.header.end);
        this.start = Number(this.from);
        this.stop = Math.max(Number(this.to), this.start + 1);
        this.pieceEnd = columns['piece.end'].numbers();
        this.pieceCount = this.pieceEnd.length;
        this.rows = this.nodes.map((n, i) => ({...n, index: i})).filter(n => n.traced && n.pieces);
        this.activity =
            this.columns['piece.state'].map(s => ((s & 7) === 0 && s & 8 ? 1 : STATE_DRAWN[s & 7]));
        this.colourBy('activity');
        this.sortMessages();
        this.findHosts();
        this.orderBy('number', false);
    }
    /* Where there is a host, it loads the nodes' programs. */
    pieceNames() {
        return this.rows.some(row => row.name === 'host') ?
            [...PIECE_NAMES.slice(0, -1), 'no program'] : PIECE_NAMES;
    }
    pieceName(row, i) {
        const later = i < row.first + row.pieces - 1;
        return this.activity[i] === 5 && later ? 'no program yet' : PIECE_NAMES[this.activity[i]];
    }
    /* What pieces are drawn as, this.drawn[i], is one of this.kinds. By call or function: the eight that
     * take most of the time have colours. Computing is for the functions that worked, as in touchstone
     * trace why, and a call for the function that calls. */
    colourBy(what) {
        this.kinds = this.pieceNames().map((name, i) => ({name, tone: PIECE_COLOURS[i]}));
        this.drawn = this.activity;
        if (what !== 'activity')
            this.drawNamed(what);
        this.sumBlocks();
    }
    /* The function's name in the source: GCC calls parts of functions f.part.0 and the like. */
    callFunction(call) { return this.text(this.columns['call.place'][call]).split(/[,.]/)[0] || 'unknown'; }
    /* The functions that computed in a piece, "force or main"; '': not known, or it is no computing. */
    workedText(i) { return this.text(this.columns['piece.worked'][i]); }
    /* The name that a piece is drawn by; null: none. */
    drawnName(what, i) {
        const call = this.columns['piece.call'][i], computes = this.activity[i] < 2;
        if (what === 'call')
            return call >= 0 ? this.callName(call) : null;
        if (computes)
            return this.workedText(i) || 'unknown';
        return call >= 0 ? this.callFunction(call) : null;
    }
    drawNamed(what) {
        const times = new Map(), names = new Array(this.pieceCount).fill(null);
        for (const row of this.rows)
            for (let i = row.first, from = this.start; i < row.first + row.pieces; from = this.pieceEnd[i++]) {
                const name = names[i] = this.drawnName(what, i);
                if (name !== null)
                    times.set(name, (times.get(name) || 0) + this.pieceEnd[i] - from);
            }
        const most = [...times].sort((a, b) => b[1] - a[1]).slice(0, 8).map(([name]) => name);
        const kindOf = new Map(most.map((name, i) => [name, i + 2]));
        this.kinds = [
            {name: `no ${what}`, tone: 'waiting'}, {name: this.pieceNames()[5], tone: 'ended'},
            ...most.map((name, i) => ({name, tone: 'c' + i})), {name: `other ${what}s`, tone: 'soft'}
        ];
        const none = i => (this.activity[i] === 5 ? 1 : 0), other = this.kinds.length - 1;
        this.drawn = Uint8Array.from(names, (n, i) => (n === null ? none(i) : kindOf.get(n) ?? other));
    }
    /* Hosts serve the others: they send and receive more than twice as many messages as the mean. */
    findHosts() {
        const counts = new Map(this.rows.map(row => [row.index, 0])), c = this.columns;
        for (let i = 0; i < this.messageCount; i++)
            for (const end of [c['message.from'][i], c['message.to'][i]])
                if (counts.has(end))
                    counts.set(end, counts.get(end) + 1);
        const mean = [...counts.values()].reduce((a, b) => a + b, 0) / (counts.size || 1);
        for (const row of this.rows)
            row.host = row.name === 'host' || (mean > 0 && counts.get(row.index) > 2 * mean);
        this.hosts = this.rows.filter(row => row.host).length;
    }
    /* The order of the rows: by number, or by waiting, the longest first; with hosts before all others. */
    orderBy(what, hostsFirst) {
        const waits = new Map(this.rows.map(row => [row, what === 'idle' ? this.waiting(row) : 0]));
        this.rows.sort(
            (a, b) => (hostsFirst ? b.host - a.host : 0) || waits.get(b) - waits.get(a) || a.index - b.index);
        this.pinned = hostsFirst ? this.hosts : 0;
        this.placeMessages();
    }
    waiting(row) {
        let sum = 0;
        for (let i = row.first, from = this.start; i < row.first + row.pieces; from = this.pieceEnd[i++])
            sum += this.activity[i] === 4 ? this.pieceEnd[i] - from : 0;
        return sum;
    }
    /* For each block of pieces of one node: the time of each kind. */
    sumBlocks() {
        const kinds = this.kinds.length;
        this.blockSums = new Float64Array((Math.floor(this.pieceCount / PIECE_BLOCK) + 1) * kinds);
        for (const row of this.rows)
            for (let i = row.first, from = this.start; i < row.first + row.pieces; i++) {
                this.blockSums[Math.floor(i / PIECE_BLOCK) * kinds + this.drawn[i]] +=
                    this.pieceEnd[i] - from;
                from = this.pieceEnd[i];
            }
    }
    /* Messages are in order of sending; latest[i]: when the last of those up to i was over. */
    sortMessages() {
        const c = this.columns, count = c['message.from'].length;
        this.messageCount = count;
        this.sentAt = c['message.sent'].numbers();
        this.overAt = new Float64Array(count);
        this.latest = new Float64Array(count);
        for (let i = 0, latest = 0; i < count; i++) {
            this.overAt[i] = this.messageOver(i);
            this.latest[i] = latest = Math.max(latest, this.overAt[i]);
        }
    }
    /* The rows of its ends, -1 of those that have none. */
    placeMessages() {
        const c = this.columns,
              rowOf = new Int32Array(this.nodes.length + 1).fill(-1); /* the last: services */
        this.rows.forEach((row, i) => { rowOf[row.index] = i; });
        this.fromRow = c['message.from'].map(n => rowOf[n < 0 ? this.nodes.length : n]);
        this.toRow = c['message.to'].map(n => rowOf[n < 0 ? this.nodes.length : n]);
    }
    /* When the message is there: where its arrow ends. */
    messageOver(i) {
        for (const name of ['complete', 'left', 'moved', 'entered', 'sent'])
            if (!this.columns['message.' + name].isNever(i))
                return this.columns['message.' + name].number(i);
        return this.sentAt[i];
    }
    /* The piece of the row at that time, by bisection. */
    pieceAt(row, time) {
        let low = row.first, high = row.first + row.pieces - 1;
        while (low < high) {
            const middle = (low + high) >> 1;
            if (this.pieceEnd[middle] > time)
                high = middle;
            else
                low = middle + 1;
        }
        return low;
    }
    pieceFrom(row, i) { return i === row.first ? this.from : this.columns['piece.end'].at(i - 1); }
    nodeName(index) { return index >= 0 ? this.nodes[index].name : 'a service'; }
    text(number) { return number >= 0 ? this.texts[number] : ''; }
    callName(call) { return this.text(this.columns['call.called'][call]); }
    /* What the call was given: "type" or "id" (msgwait, iowait and their kin), or nothing. */
    givenWord(call) {
        const c = this.columns;
        return !(c['call.flags'][call] & 1)                        ? ''
            : /^_?(msg|io)/.test(this.names[c['call.name'][call]]) ? 'id'
                                                                   : 'type';
    }
    /* "crecv, type 5, at relax, relax.c:12" */
    callText(call) {
        const c = this.columns, name = this.names[c['call.name'][call]], called = this.callName(call),
              given = this.givenWord(call);
        return [
            name === called ? name : `${called} (${name})`,
            given && `${given} ${c['call.type'][call]}`,
            c['call.place'][call] >= 0 ? `at ${this.text(c['call.place'][call])}` : '',
            c['call.flags'][call] & 4 ? 'made by a handler' : '',
            c['call.flags'][call] & 2 ? 'not finished' : ''
        ].filter(Boolean)
            .join(', ');
    }
    messageText(i) {
        const c = this.columns,
              part = (name, text) =>
                  (c['message.' + name].isNever(i) ? '' : `${text} ${moment(c['message.' + name].at(i))}`);
        return `message ${i}: ${this.nodeName(c['message.from'][i])} to ${
                   this.nodeName(c['message.to'][i])}, ${
                   typeText(c['message.type'][i], c['message.pid'][i])}, ` +
               `${grouped(String(c['message.bytes'].at(i)))} bytes; ` + [
                   part('sent', 'sent'), part('asked', 'asked'), part('granted', 'granted'),
                   part('moved', 'has its path'), part('left', 'left the network'),
                   part('complete', 'complete'), part('taken', 'taken')
               ].filter(Boolean).join(', ');
    }
    /* What is known of a piece, in lines. */
    pieceText(row, i) {
        const c = this.columns, state = c['piece.state'][i], call = c['piece.call'][i],
              wait = c['piece.wait'][i];
        const from = this.pieceFrom(row, i), to = c['piece.end'].at(i), handler = c['piece.handler'][i],
              system = c['piece.system'][i];
        const lines = [`${row.name}: ${this.pieceName(row, i)} for ${duration(to - from)}, from ${
            moment(from)} to ${moment(to)}`];
        if (system >= 0)
            lines.push(`The operating system is ${TASK_NAMES[c['system.task'][system]] || 'busy'}.`);
        else if ((state & 7) === 3 && handler >= 0)
            lines.push('The operating system enters or leaves the handler.');
        if (wait >= 0)
            lines.push(this.waitText(wait));
        if (this.workedText(i))
            lines.push(`Function: ${this.workedText(i)}`);
        if (call >= 0)
            lines.push('Call: ' + this.callText(call));
        if (handler >= 0)
            lines.push(`Handler for type ${c['handler.type'][handler]}, due ${
                moment(c['handler.due'].at(handler))}`);
        for (const message of this.pieceMessages(i))
            lines.push(this.messageText(message));
        return lines;
    }
    /* The same in short, for the tip under the mouse. */
    pieceTip(row, i) {
        const call = this.columns['piece.call'][i],
              from = i === row.first ? this.start : this.pieceEnd[i - 1];
        return `${row.name}: ${this.pieceName(row, i)}, ${roughly(this.pieceEnd[i] - from)}` +
               (call >= 0              ? '\n' + this.callText(call)
                    : this.workedText(i) ? '\nin ' + this.workedText(i)
                                         : '');
    }
    waitText(wait) {
        const c = this.columns, flags = c['wait.flags'][wait], from = c['wait.from'][wait];
        return `Waits ${flags & 2 ? 'until a message has left' : 'for a message'}${
            flags & 1 ? `, type ${c['wait.type'][wait]}`
                      : ''}${from >= 0 ? `, from ${this.nodeName(from)}` : ''}.`;
    }
    /* The messages of the piece's call or handler. */
    pieceMessages(i) {
        const c = this.columns, call = c['piece.call'][i], handler = c['piece.handler'][i], found = [];
        if (call >= 0)
            found.push(c['call.sent'][call], c['call.taken'][call]);
        else if (handler >= 0)
            found.push(c['handler.message'][handler]);
        return found.filter(m => m >= 0);
    }
    /* What a call did: "csend, type 5 on node 3". Words of the query must all be in it. */
    search(query, most) {
        const words = query.toLowerCase().match(/\S+/g) || [], c = this.columns, found = [],
              numbers = {type: null, node: null, message: null};
        if (!words.length)
            return {found, count: 0};
        const texts = words.filter((w, i) => {
            const number = /^-?\d+$/.test(w) && words[i - 1] in numbers;
            if (number)
                numbers[words[i - 1]] = Number(w);
            return !number && !(w in numbers && /^-?\d+$/.test(words[i + 1] || ''));
        });
        if (numbers.message !== null)
            return this.searchMessage(numbers.message);
        const fits = list => list.map(t => texts.map(w => t.toLowerCase().includes(w)));
        const names = fits(this.names), others = fits(this.texts);
        let count = 0;
        for (let i = 0; i < c['call.node'].length; i++) {
            if ((numbers.type !== null && !(this.givenWord(i) === 'type' && c['call.type'][i] === numbers.type)) ||
                (numbers.node !== null && this.nodes[c['call.node'][i]].name !== `node ${numbers.node}`))
                continue;
            const name = names[c['call.name'][i]], called = others[c['call.called'][i]],
                  place = others[c['call.place'][i]];
            if (texts.every((w, k) => name[k] || called[k] || (place && place[k]) ||
                                      this.nodes[c['call.node'][i]].name === w)) {
                count++;
                if (found.length < most)
                    found.push({call: i});
            }
        }
        return {found, count};
    }
    searchMessage(i) {
        const there = i >= 0 && i < this.messageCount;
        return {found: there ? [{message: i}] : [], count: there ? 1 : 0};
    }
}

/* "4 nodes and the host"; "4 nodes of ipsc860 and its host". */
function nodesText(rows, machine) {
    const nodes = rows.filter(row => row.name !== 'host').length;
    return plural(nodes, 'node') + (machine ? ` of ${machine}` : '') +
           (nodes < rows.length ? ` and ${machine ? 'its' : 'the'} host` : '');
}

/* "in 253.3 ms"; of a trace of which the page has a part: "from 0 s to 20.00 ms of 253.3 ms". */
function spanText(trace) {
    const part = partText(trace), end = roughly(Number(trace.end));
    return part ? `from ${part} of ${end}` : `in ${end}`;
}

/* "0 s to 20.00 ms"; '': the page has the whole run. */
function partText({from, to, end}) {
    return from > 0n || to < end ? `${roughly(Number(from))} to ${roughly(Number(to))}` : '';
}

function traceSummary(trace) {
    const part = partText(trace);
    return {
        kind: 'Trace',
        big: roughly(Number(trace.end)),
        small: `${baseName(trace.program)} on ${nodesText(trace.nodes.filter(n => n.ran), trace.machine)}; ${
            plural(trace.pieceCount, 'interval')}, ${plural(trace.messageCount, 'message')}${part ? ' from ' + part : ''}${
            trace.complete ? '' : '; the trace ends early'}`
    };
}
