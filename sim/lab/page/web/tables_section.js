/* tables_section.js - Tables 1-5 beside the paper's. */

function tablesSummary(data) {
    const s = data.summary;
    return {
        kind: 'The paper\'s tables',
        big: `${figure(s.mean_error_pct, 3)} % mean error`,
        small: `${plural(s.all_rows ? s.all_rows.rows : s.rows, 'row')}; worst ${
            signed(s.worst_error_pct)} %, Table ${s.worst_table}, ${plural(s.worst_nodes, 'node')}`
    };
}

function signed(value, decimals = 2) {
    const digits = Math.abs(value).toFixed(decimals);
    return (Number(digits) === 0 ? '' : value < 0 ? '\u2212' : '+') + digits;
}

function tablesSection(data, name) {
    const section = addSection('The paper\'s tables', 'Tables',
        `Total times of Bajaj & Lin's program, simulated and as printed in the paper (${
            name}). An error is coloured by its size: `);
    section.querySelector('.about').append(errorKey());
    section.append(errorSummary(data.summary));
    for (const table of data.summary.tables)
        section.append(...oneTable(table, data.rows.filter(r => r.table === table.table)));
    section.append(fittedPart(data));
    return section;
}

function errorColour(e, value) {
    const strength = Math.min(1, Math.abs(value) / 5) * 0.75;
    e.style.backgroundColor = `rgba(${colour(value > 0 ? 'slower' : 'faster')}, ${strength.toFixed(3)})`;
}

function errorKey() {
    const key = element('span', {class: 'key'});
    for (const value of [-5, -3, -1, 0, 1, 3, 5]) {
        const box = element('span', {class: 'swatch'});
        errorColour(box, value);
        key.append(box);
    }
    key.append(' from 5 % faster than the paper to 5 % slower.');
    return key;
}

function errorSummary(s) {
    const line = e => `mean ${figure(e.mean_error_pct, 3)} %, worst ${signed(e.worst_error_pct)} % (Table ${
        e.worst_table}, ${plural(e.worst_nodes, 'node')})`;
    const rows = [['All runs', s], ['Predicted', s.predicted_rows], ['Fitted to', s.fitted_rows]];
    return facts(rows.filter(([, e]) => e && e.rows).map(([what, e]) => [`${what} (${e.rows})`, line(e)]));
}

/* Columns in pairs: simulated, with so many decimals, and the paper's, whose times are as they were printed. */
const PAPER_PAIRS = [
    ['Total time, s', 'total_s', 'paper_total_s', 3],
    ['Host idle, %', 'host_idle_pct', 'paper_host_idle_pct', 1],
    ['Slave idle, %', 'slave_idle_pct', 'paper_slave_idle_pct', 1],
    ['Speed / node', 'speed_per_node', 'paper_speed_per_node', 3]
];

function oneTable(table, rows) {
    const region =
        element('div', {class: 'scroll', role: 'region', tabindex: '0', 'aria-label': `Table ${table.table}`},
            comparedTable(rows));
    const charts = element('div', {class: 'charts'}, residuals(table, rows), timesCurve(table, rows));
    return [
        element('h3', {}, `Table ${table.table}: ${table.title}`),
        element('div', {class: 'pair'},
            element('div', {class: 'charts'}, region,
                element('p', {class: 'note'},
                    '† something of the machine was fitted to this row; the others are predicted.')),
            charts)
    ];
}

function comparedTable(rows) {
    const head = element('tr', {}, element('th', {scope: 'col', rowspan: 2}, 'Nodes'),
        PAPER_PAIRS.map(
            ([title], i) => element('th', {class: 'over', scope: 'colgroup', colspan: i ? 2 : 3}, title)));
    const second = element('tr', {},
        PAPER_PAIRS.map((pair, i) => [element('th', {scope: 'col', class: 'first'}, 'simulated'),
                            element('th', {scope: 'col'}, 'paper'),
                            i ? null : element('th', {scope: 'col'}, 'error, %')]));
    return element(
        'table', {}, element('thead', {}, head, second), element('tbody', {}, rows.map(comparedRow)));
}

function comparedRow(row) {
    const tr = element('tr', {}, element('th', {scope: 'row'}, row.nodes + (row.fitted ? '\u2009†' : '')));
    PAPER_PAIRS.forEach(([, simulated, paper, decimals], i) => {
        const show = v => rounded(v.toFixed(decimals), String(v));
        for (const key of [simulated, paper])
            tr.append(element('td', {class: key === simulated ? 'first' : null},
                typeof row[key] === 'number'  ? (key === 'paper_total_s' ? String(row[key]) : show(row[key]))
                : row.failure && key === simulated ? 'failed'
                                              : ''));
        if (i === 0) {
            const has = typeof row.error_pct === 'number';
            const error = element('td', {class: 'error'}, has ? signed(row.error_pct) : '');
            if (has)
                errorColour(error, row.error_pct);
            tr.append(error);
        }
    });
    return tr;
}

/* The errors against the nodes; a bar is what the paper's rounding leaves open. Rows look the same in all tables,
 * also where all of them are of one kind. */
function residuals(table, rows) {
    const points = kept => rows.filter(r => typeof r.error_pct === 'number' && r.fitted === kept).map(r => ({
        x: r.nodes,
        y: r.error_pct,
        spread: r.paper_rounding_pct,
        tip: `${plural(r.nodes, 'node')}: ${signed(r.error_pct)} %\nsimulated ${r.total_s} s, paper ${
            r.paper_total_s} s\nthe paper's rounding: ±${figure(r.paper_rounding_pct, 2)} %`
    }));
    return lineChart({
        title: `Table ${table.table}: residuals`,
        xLabel: 'nodes',
        yLabel: 'error, %',
        logX: true,
        zero: true,
        height: 180,
        ticksX: rows.map(r => r.nodes),
        series: [
            {name: 'predicted', points: points(false), line: false, style: 0},
            {name: 'fitted to', points: points(true), line: false, hollow: true, style: 1}
        ].filter(s => s.points.length)
    }).figure;
}

function timesCurve(table, rows) {
    const series = (name, key) => ({
        name,
        points:
            rows.filter(r => typeof r[key] === 'number')
                .map(r => ({x: r.nodes, y: r[key], tip: `${name}, ${plural(r.nodes, 'node')}: ${r[key]} s`}))
    });
    return lineChart({
        title: `Table ${table.table}: total time`,
        xLabel: 'nodes',
        yLabel: 's',
        logX: true,
        logY: true,
        height: 190,
        ticksX: rows.map(r => r.nodes),
        series:
            [series('simulated', 'total_s'), {...series('paper', 'paper_total_s'), line: false, hollow: true}]
    }).figure;
}

function fittedPart(data) {
    return later('What was fitted',
        () => figureTable('What was fitted',
            [
                {
                    name: 'What',
                    text: true,
                    get: f =>
                        f.what || `${f.file}${f.function ? ', ' + f.function : ''}: costs times ${f.factor}`
                },
                {name: 'Fitted to', text: true, get: f => f.fitted_to}
            ],
            [...data.fitted || [], ...data.fitted_choices || []]));
}
