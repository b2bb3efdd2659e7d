/* profile_section.js - a profile: where the nodes' time went, by function of the program. */
function profileSummary(data) {
    const top = [...data.functions].sort((a, b) => b.share - a.share)[0];
    return {
        kind: 'Profile',
        big: top ? `${(top.share * 100).toFixed(1)} % in ${top.function}` : 'no function',
        small: `${baseName(data.program)} on ${plural(data.nodes, 'node')} of ${data.machine}; ${
            roughly(data.virtual_time_s * 1e12)}`
    };
}

function profileSection(data, name) {
    const section = addSection(`Profile of ${baseName(data.program)}`, 'Profile: ' + baseName(name),
        [
            ...commandText([data.program, ...data.arguments].join(' ')),
            `, on ${plural(data.nodes, 'node')} of ${data.machine} (${name}). Times are sums over the nodes, `,
            'counted and not sampled.'
        ],
        name);
    const functions = [...data.functions].sort((a, b) => b.seconds - a.seconds);
    const most = functions.length ? functions[0].share : 1;
    section.append(element('h3', {}, 'By function'),
        ...figureTable('Functions',
            [
                {name: 'Function', text: true, get: f => f.function},
                {name: 'computing', get: f => picoseconds(f.seconds)}, {
                    name: 'share of the nodes\' time',
                    get: f => f.share,
                    show: v => `${(v * 100).toFixed(2)} %`
                },
                {name: '', text: true, get: f => f.share, show: v => shareBar(v, most)},
                {name: 'at', text: true, get: f => f.line ? `${f.file}:${f.line}` : f.file},
                {name: 'called', text: true, get: f => f.called || ''}
            ],
            functions, 30));
    for (const [kind, times] of Object.entries(data.classes))
        section.append(...profileClass(kind, times));
    return section;
}

function shareBar(value, most) {
    const bar = element('span', {class: 'bar', 'aria-hidden': 'true'});
    bar.style.width = `${Math.max(1, value / most * 160)}px`;
    return bar;
}

function profileClass(kind, times) {
    const all = times.node_time_s;
    const share = v => `${roughly(v * 1e12)}, ${(all ? v / all * 100 : 0).toFixed(2)} %`;
    const tasks = Object.entries(times.tasks).map(([k, v]) => [k.replace(/_s$/, ''), share(v)]);
    return [
        element(
            'h3', {}, `${plural(times.nodes, 'node')}${kind === 'with_handlers' ? ' with handlers' : ''}`),
        facts([
            ['computing', share(times.computing_s)], ['system', share(times.system_s)],
            ['waiting (idle)', share(times.idle_s)]
        ]),
        later('The system\'s time by task, and the waits by call',
            () => [facts(tasks),
                ...figureTable('Waits',
                    [
                        {name: 'Call', text: true, get: w => w.call},
                        {name: 'waited', get: w => picoseconds(w.idle_s)}, {name: 'waits', get: w => w.waits}
                    ],
                    times.waits)])
    ];
}
