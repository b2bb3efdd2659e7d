/* study_section.js - curves of a study: any figure against any axis, a line for each value of another
 * axis. */

function studySummary(data) {
    const failed = data.points.filter(p => p.failure).length;
    return {
        kind: 'Study',
        big: data.title || 'Study',
        small: `${plural(data.points.length, 'point')}${failed ? `, ${failed} failed` : ''}; ${
            Object.keys(data.axes).join(', ')}`
    };
}

/* Figures that are no axis and of which some point has a number, the best known first. */
function studyFigures(data) {
    const known =
        ['time_s', 'total_s', 'idle_pct', 'speedup', 'speed_per_node', 'virtual_time_s', 'messages', 'bytes'];
    const found = new Set();
    for (const point of data.points)
        for (const [key, value] of Object.entries(point))
            if (typeof value === 'number' && !(key in data.axes))
                found.add(key);
    return [...known.filter(k => found.has(k)), ...[...found].filter(k => !known.includes(k)).sort()];
}

/* Figures of touchstone's own whose names are no words; as in pictures (chart_data.c). */
const FIGURE_WORDS = {speedup: 'speed-up', speed_per_node: 'speed-up / nodes'};

/* A figure's name for people: "idle, %" of idle_pct. */
function figureWords(key) {
    if (Object.hasOwn(FIGURE_WORDS, key))
        return FIGURE_WORDS[key];
    const [, stem, unit] = key.match(/^(.*?)(?:_(s|ms|us|ps|pct|bytes))?$/);
    return stem.replace(/_/g, ' ') + (unit ? ', ' + (unit === 'pct' ? '%' : unit) : '');
}

function isNumeric(values) { return values.length > 1 && values.every(v => typeof v === 'number'); }

function studySection(data, name) {
    const section = addSection(data.title || 'Study', 'Study: ' + (data.title || baseName(name)),
        [
            data.about, `Program ${data.program}; results in ${name}.`,
            data.baseline && `Baseline of speed-ups: ${data.baseline}.`
        ].filter(Boolean)
            .join(' '),
        name);
    const axes = Object.keys(data.axes), figures = studyFigures(data);
    const numeric = axes.filter(a => isNumeric(data.axes[a]));
    section.append(studyFailures(data));
    if (!numeric.length || !figures.length)
        section.append(element('p', {}, 'No axis has several numbers, so there are no curves.'));
    else
        section.append(...studyCurves(data, axes, figures, numeric, section));
    section.append(later('The table behind', () => studyTable(data, axes)));
    return section;
}

function studyFailures(data) {
    const failed = data.points.filter(p => p.failure), axes = Object.keys(data.axes);
    if (!failed.length)
        return '';
    return later(`${plural(failed.length, 'point')} failed`,
        () => figureTable('Failed points',
            [
                ...axes.map(a => ({name: a, text: true, get: p => p[a]})),
                {name: 'why', text: true, get: p => p.failure}
            ],
            failed));
}

function studyTable(data, axes) {
    const keys = new Set(axes);
    for (const p of data.points)
        Object.keys(p).filter(k => typeof p[k] !== 'object').forEach(k => keys.add(k));
    return figureTable('All points',
        [...keys].map(k => ({name: k, text: typeof data.points[0]?.[k] === 'string', get: p => p[k]})),
        data.points, 100);
}

/* The values at which the other axes are held so that the most points are on the curves. */
function fullestHold(data, state) {
    const held = Object.keys(data.axes).filter(a => a !== state.x && a !== state.lines), counts = new Map();
    for (const p of data.points.filter(p => isOnCurves(p, state))) {
        const key = JSON.stringify(held.map(a => data.axes[a].indexOf(p[a])));
        counts.set(key, (counts.get(key) || 0) + 1);
    }
    const most = d3.max(counts.values());
    const best = [...counts.keys()].find(key => counts.get(key) === most);
    return best ? Object.fromEntries(JSON.parse(best).map((index, i) => [held[i], index])) : {};
}

function isOnCurves(point, state) { return typeof point[state.y] === 'number' && !point.failure; }

/* section.showPoint(point) then shows that point, whatever the axes are held at now. */
function studyCurves(data, axes, figures, numeric, section) {
    const several = axes.filter(a => data.axes[a].length > 1);
    const state = {x: numeric.includes('nodes') ? 'nodes' : numeric[0], y: figures[0]};
    state.lines = several.find(a => a !== state.x) || '';
    state.hold = fullestHold(data, state);
    const powers = data.axes[state.x].every(
        (v, i, all) => v > 0 && (i < 2 || Math.abs(v / all[i - 1] - all[1] / all[0]) < 0.6));
    const chart = lineChart({logX: powers, logY: powers, height: 400, ...studyOptions(data, axes, state)});
    const controls = element('div', {class: 'controls'});
    const update = () => {
        chart.hidden.clear();
        controls.replaceChildren(
            ...studyControls(data, axes, several, figures, numeric, state, chart, update, powers));
        chart.update(studyOptions(data, axes, state));
    };
    update();
    section.showPoint = point => {
        if (!isOnCurves(point, state))
            return;
        for (const a of axes.filter(a => a !== state.x && a !== state.lines))
            state.hold[a] = data.axes[a].indexOf(point[a]);
        update();
    };
    const added =
        data.points.some(p => p.added) ? 'A ring marks a point that was added to the study\'s own.' : '';
    return [controls, chart.figure, element('p', {class: 'note'}, added)];
}

function studyControls(data, axes, several, figures, numeric, state, chart, update, powers) {
    const names = list => list.map(a => [a, a]),
          held = several.filter(a => a !== state.x && a !== state.lines);
    const keep = (key, value) => {
        state[key] = value;
        if (state.lines === state.x)
            state.lines = several.find(a => a !== state.x) || '';
        update();
        document.activeElement === document.body &&
            chart.figure.closest('section').querySelector('select').focus();
    };
    return [
        choice('Figure', figures.map(key => [key, figureWords(key)]), state.y, v => keep('y', v)),
        choice('against', names(numeric), state.x, v => keep('x', v)),
        choice('a line for each', [...names(several.filter(a => a !== state.x)), ['', '(one line)']],
            state.lines, v => keep('lines', v)),
        ...held.map(a => choice(a, data.axes[a].map((v, i) => [i, valueText(v)]), state.hold[a] || 0,
                        v => {
                            state.hold[a] = Number(v);
                            update();
                        })),
        checkbox('logarithmic x', state.logX ?? powers,
            on => {
                state.logX = on;
                chart.update({logX: on});
            }),
        checkbox('logarithmic y', state.logY ?? powers,
            on => {
                state.logY = on;
                chart.update({logY: on});
            })
    ];
}

/* The line that speeds are compared with, where nodes are the horizontal axis. */
function idealSeries(data, state) {
    if (state.x !== 'nodes' || !Object.hasOwn(FIGURE_WORDS, state.y))
        return [];
    const points = d3.extent(data.axes.nodes).map(x => ({x, y: state.y === 'speedup' ? x : 1}));
    return [{name: 'ideal', ideal: true, points}];
}

/* The study's own points have no settings of the machine: '' on the axis `set` (merged_points.c). */
function valueText(value) { return value === '' ? 'as in the study' : String(value); }

function studyOptions(data, axes, state) {
    const held = axes.filter(a => a !== state.x && a !== state.lines);
    const points = data.points.filter(
        p => isOnCurves(p, state) &&
             held.every(a => p[a] === data.axes[a][state.hold[a] || 0] || data.axes[a].length < 2));
    const series = (state.lines ? data.axes[state.lines] : [null]).map(value => ({
        name:
            value === null
                ? figureWords(state.y)
                : `${state.lines === 'scheme' || typeof value === 'string' ? '' : state.lines + ' '}${valueText(value)}`,
        points: points.filter(p => value === null || p[state.lines] === value).map(p => ({
            x: p[state.x],
            y: p[state.y],
            marked: p.added,
            tip: `${axes.map(a => `${a} ${valueText(p[a])}`).join(', ')}\n${figureWords(state.y)}: ${p[state.y]}`
        }))
    }));
    return {
        title: `${figureWords(state.y).split(', ')[0]} against ${state.x}`,
        xLabel: state.x,
        yLabel: figureWords(state.y),
        series: [...series, ...idealSeries(data, state)],
        ticksX: data.axes[state.x].length <= 16 ? [...data.axes[state.x]].sort((a, b) => a - b) : null
    };
}
