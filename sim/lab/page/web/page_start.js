/* page_start.js - makes the sections, one behind the other, of the items of the page's data. */

/* For each kind: how it is read, its section, and its card in the summary. */
const KINDS = {
    tables: {read: readJson, section: tablesSection, summary: tablesSummary},
    study: {read: readJson, section: studySection, summary: studySummary},
    run: {read: readJson, section: runSection, summary: runSummary},
    profile: {read: readJson, section: profileSection, summary: profileSummary},
    trace: {read: readTrace, section: traceSections, summary: traceSummary},
    deadlock: {read: readJson, section: deadlockSection, summary: deadlockSummary},
    path: {read: readJson, section: pathSection, summary: pathSummary},
    stacks: {read: takeText, section: flameSection, summary: flameSummary},
    surface: {read: readTables, section: null, summary: surfaceSummary},
};

async function readJson(script) { return JSON.parse(await takeText(script)); }

async function readTables(script) { return readColumns(await takeBytes(script)); }

/* All surfaces share a section, for they are seen together. */
async function startPage() {
    const state = document.getElementById('state'),
          scripts = [...document.querySelectorAll('script[data-kind]')];
    const items = scripts.filter(s => s.dataset.kind in KINDS);
    const surfaces = [], paths = [], timelines = [];
    await runLibrary('d3');
    const summary = addSection('Summary', 'Summary'), cards = element('ul', {class: 'cards'});
    summary.append(cards);
    for (const script of items) {
        const {kind, name} = script.dataset, card = element('li');
        state.textContent = `Reading ${name} ...`;
        await new Promise(done => setTimeout(done)); /* lets the browser draw */
        cards.append(card);
        try {
            const data = await KINDS[kind].read(script);
            const section = KINDS[kind].section ? KINDS[kind].section(data, name) : null;
            if (kind === 'surface')
                surfaces.push({data, name, card});
            if (kind === 'path')
                paths.push({data, name});
            if (data.timeline)
                timelines.push(data.timeline);
            fillCard(card, KINDS[kind].summary(data, name), name, section);
        } catch (problem) {
            card.append(element('p', {class: 'problem'}, `${name} cannot be shown: ${problem.message}`));
            console.error(problem);
        }
    }
    linkPaths(paths, timelines);
    showTogether(timelines);
    if (surfaces.length)
        await showSurfaces(surfaces);
    state.remove();
    followSections();
    await new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)));
    document.documentElement.dataset.ready = 'yes'; /* for whoever drives the page */
}

async function showSurfaces(surfaces) {
    await runLibrary('three');
    const section = surfaceSection(surfaces);
    for (const s of surfaces)
        s.card.querySelector('a').href = '#' + section.id;
}

function fillCard(card, {kind, big, small}, name, section) {
    card.append(element('p', {class: 'kind'}, kind),
        element('a', {href: section ? '#' + section.id : '#'}, name), element('p', {class: 'big'}, big),
        element('p', {class: 'small'}, small));
}

/* Marks in the navigation the section that the upper part of the screen shows. */
function markSection() {
    const links = [...document.querySelectorAll('nav a')], sections = links.map(a => document.querySelector(a.hash));
    const shown = sections.filter(section => section?.getBoundingClientRect().top < 200).pop() || sections[0];
    links.forEach((a, i) => a.setAttribute('aria-current', String(sections[i] === shown)));
}

/* Links of the navigation that would read the same have the names of what they lead to. */
function tellApart() {
    const links = [...document.querySelectorAll('nav a')];
    for (const link of links) {
        const {short, name} = link.dataset;
        const alike = name && links.some(other => other !== link && other.dataset.short === short);
        link.textContent = alike ? `${short} (${name})` : short;
    }
}

/* May be called again when sections are others. */
function followSections() {
    tellApart();
    addEventListener('scroll', markSection, {passive: true});
    markSection();
}

startPage().catch(problem => {
    document.getElementById('state').textContent = `The page cannot be shown as a whole: ${problem.message}`;
    console.error(problem);
});
