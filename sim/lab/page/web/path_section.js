/* path_section.js - why a run took its time: what touchstone trace why --json found. Times are
 * picoseconds: BigInt() takes them as numbers, and as texts where a number of JavaScript would not hold
 * them. */

/* Classes of the path, and causes of waits, as touchstone trace why prints them. A key that is not here
 * is the name, with _ for each space. */
const CLASS_TEXTS = {
    calls: 'system: the program\'s calls',
    other_messages: 'system: other messages',
    message: 'system: the message itself',
    absent: 'no program',
    unknown: 'services, or unknown',
};

function pathSummary(data) {
    const length = BigInt(data.critical_path.length_ps);
    const most =
        [...data.critical_path.by_class].sort((a, b) => Number(BigInt(b.time_ps) - BigInt(a.time_ps)))[0];
    return {
        kind: 'Critical path',
        big: `${percent(most.time_ps, length)} ${causeText(most.class)}`,
        small: `${baseName(data.program)}: ${roughly(Number(length))}, along ${
            plural(data.critical_path.step_count, 'step')}`
    };
}

function share(part, whole) { return Number(BigInt(whole)) ? Number(BigInt(part)) / Number(BigInt(whole)) * 100 : 0; }

/* In a sentence; a column has equal decimals instead. */
function percent(part, whole) {
    const value = share(part, whole);
    return value.toFixed(value < 10 ? 2 : 1) + '\u00a0%';
}

function causeText(key) { return CLASS_TEXTS[key] || key.replace(/_/g, ' '); }

function pathSection(data, name) {
    const length = BigInt(data.critical_path.length_ps), path = data.critical_path;
    const section = addSection(`Why ${baseName(data.program)} took ${roughly(Number(length))}`,
        'Why: ' + baseName(name),
        `The critical path of ${data.trace}, on ${plural(data.nodes, 'node')} of ${data.machine} (${name}).`,
        name);
    section.append(...data.sentences.map(text => element('p', {class: 'prose'}, text)));
    section.append(element('h3', {}, 'The critical path by class'), ...classTable(path.by_class, length));
    for (const [key, title] of [['by_node', 'node'], ['by_function', 'function'], ['by_call', 'call'],
             ['by_message', 'message']])
        if (path[key] && path[key].length)
            section.append(later(`The path by ${title}`, () => shareTable(path[key], title, length)));
    section.append(...waitParts(data.waits));
    if (data.reruns)
        section.append(element('h3', {}, 'If it were otherwise'), ...rerunTable(data.reruns, length));
    return section;
}

/* of: what the shares are of. */
function timeColumns(whole, most, of) {
    return [
        {name: 'time', get: r => BigInt(r.time_ps)},
        {name: `% of ${of}`, get: r => r.time_ps, show: v => share(v, whole).toFixed(2) + ' %'},
        {name: '', text: true, get: r => Number(BigInt(r.time_ps)), show: v => shareBar(v, most)},
    ];
}

function mostOf(rows) { return d3.max([1, d3.max(rows, r => Number(BigInt(r.time_ps)))]); }

function classTable(rows, length) {
    const some = rows.filter(r => BigInt(r.time_ps) > 0n);
    return figureTable('The critical path by class',
        [
            {name: 'Class', text: true, get: r => r.class, show: causeText},
            ...timeColumns(length, mostOf(some), 'the run'),
            {name: 'the run without it, at least', get: r => BigInt(r.at_least_without_ps)}
        ],
        some);
}

function shareTable(rows, title, length) {
    return figureTable(`The path by ${title}`,
        [
            {name: title[0].toUpperCase() + title.slice(1), text: true, get: r => r.what},
            ...timeColumns(length, mostOf(rows), 'the run'), {name: 'steps', get: r => r.steps}
        ],
        rows);
}

function waitParts(waits) {
    const causes = Object.entries(waits.by_cause_ps).map(([cause, time_ps]) => ({cause, time_ps}));
    const some = causes.filter(r => BigInt(r.time_ps) > 0n)
                     .sort((a, b) => Number(BigInt(b.time_ps) - BigInt(a.time_ps)));
    const head = element('h3', {}, 'What all nodes waited for');
    if (!some.length)
        return [head, element('p', {}, 'No node waited.')];
    return [
        head,
        ...figureTable('Waits by cause',
            [
                {name: 'Cause', text: true, get: r => r.cause, show: causeText},
                ...timeColumns(waits.idle_ps, mostOf(some), 'all waiting')
            ],
            some),
        later('Waits that are alike',
            () => figureTable('Waits that are alike',
                [
                    {name: 'Cause', text: true, get: g => g.cause, show: causeText},
                    {name: 'waited', get: g => BigInt(g.idle_ps)}, {name: 'waits', get: g => g.waits},
                    {name: 'nodes', get: g => g.nodes}, {name: 'in', text: true, get: g => g.in},
                    {name: 'type', get: g => g.type, show: v => v === undefined ? '' : String(v)},
                    {name: 'partner', text: true, get: g => g.partner},
                    {name: 'sent by', text: true, get: g => g.sent_by}
                ],
                waits.groups))
    ];
}

function rerunTable(reruns, length) {
    return figureTable('Other runs',
        [
            {name: 'Change', text: true, get: r => r.what || r.change},
            {name: 'settings', text: true, get: r => r.settings.join(', ')},
            {name: 'the run would take', get: r => r.error || BigInt(r.end_ps)}, {
                name: 'times faster',
                get: r => r.error ? '' : Number(length) / Math.max(1, Number(BigInt(r.end_ps))),
                show: v => v === '' ? '' : v.toFixed(3)
            }
        ],
        reruns);
}

/* Draws the path into the timelines of its trace: of that name, or the only one. */
function linkPaths(paths, timelines) {
    for (const {data, name} of paths) {
        const steps = data.critical_path.steps;
        const own = timelines.filter(t => baseName(t.name) === baseName(data.trace));
        const timeline = own[0] || (timelines.length === 1 ? timelines[0] : null);
        if (steps && timeline)
            timeline.showPath(steps, name);
    }
}
