/* path_section.js - the critical path that touchstone trace why --json found. */

function pathSummary(data) {
    return {
        kind: 'Critical path',
        big: data.total_s !== undefined ? `${data.total_s} s` : 'Critical path',
        small: data.program ? baseName(data.program) : ''
    };
}

/* The parts of the result that are lists become tables, the others facts: so whatever is found is shown. */
function pathSection(data, name) {
    const section = addSection('The critical path', 'Critical path',
        `What the run's length came from, from its end to its start (${name}).`);
    section.append(facts(Object.entries(data).filter(([, v]) => typeof v !== 'object').map(([k,
        v]) => [k.replace(/_/g, ' '), String(v)])));
    for (const [key, value] of Object.entries(data))
        if (Array.isArray(value) && value.length)
            section.append(element('h3', {}, key.replace(/_/g, ' ')), ...pathList(key, value));
    return section;
}

function pathList(key, list) {
    if (typeof list[0] !== 'object')
        return [element('ul', {}, list.map(v => element('li', {}, String(v))))];
    const keys = [...new Set(list.flatMap(row => Object.keys(row)))];
    return figureTable(key, keys.map(k => ({
        name: k.replace(/_/g, ' '),
        text: typeof list[0][k] === 'string',
        get: row => row[k],
        show: v => (typeof v === 'object' && v !== null ? JSON.stringify(v)
                    : v === null || v === undefined     ? ''
                                                        : String(v))
    })),
        list);
}
