/* live.js - runs on pages of touchstone serve only: shows studies as they are now, runs more points and stops
 * them. A study's section is made anew when its data have changed, and looks as the reader had set it. */

const live = {
    token: new URLSearchParams(location.search).get('token') || '',
    studies: [],
    news: null
};

/* Asks the server. body: an object, which is posted. Throws what the server says is wrong. */
async function askServer(path, body) {
    const address = `${path}${path.includes('?') ? '&' : '?'}token=${encodeURIComponent(live.token)}`;
    const answer = await fetch(address, body && {method: 'POST', body: JSON.stringify(body)});
    const data = await answer.json();
    if (!answer.ok)
        throw new Error(data.error || `status ${answer.status}`);
    return data;
}

/* --- a study's progress, form and runs: a block that stays when the section is made anew ------------------- */

function newLiveStudy(number, name) {
    const study = {number, name, version: -1, wanted: -1, section: null, form: null};
    study.bar = element('progress', {max: 1, value: 0, 'aria-label': `Points of ${name} that are done`});
    study.text = element('span', {role: 'status'});
    study.fields = element('form', {class: 'controls', 'aria-label': `One more point of ${name}`,
        onsubmit: e => {
            e.preventDefault();
            askForPoint(study);
        }
    });
    study.said = element('p', {role: 'alert'});
    study.runs = element('ul', {class: 'runs', 'aria-label': `Points of ${name} that were asked for`});
    study.block = element('div', {class: 'live'}, element('p', {}, study.bar, ' ', study.text),
        later('Run one more point', () => [study.fields, study.said]), study.runs);
    return study;
}

/* A field for each axis: any number, or one of the study's values; and one for numbers of the machine. */
function fillForm(study, data) {
    const form = data.form, same = JSON.stringify(form);
    if (study.form === same)
        return;
    study.form = same;
    if (form.error) {
        study.fields.replaceChildren(element('p', {}, form.error));
        return;
    }
    const kept = new Map([...study.fields.querySelectorAll('[name]')].map(f => [f.name, f.value]));
    const before = axis => kept.get('axis ' + axis) ?? String(data.axes[axis]?.at(-1) ?? '');
    study.fields.replaceChildren(...form.map(({name, open, values}) => labelled(name, open
        ? element('input', {type: 'text', inputmode: 'decimal', required: true, size: 7, name: 'axis ' + name,
            value: before(name)})
        : element('select', {name: 'axis ' + name}, values.map(
            v => element('option', {selected: v === before(name)}, v))))),
        labelled('numbers of the machine', element('input', {type: 'text', name: 'set', value: kept.get('set') || '',
            placeholder: 'system.interrupt_us=150', title: 'KEY=NUMBER, with blanks between several'})),
        element('button', {type: 'submit'}, 'Run'));
}

async function askForPoint(study) {
    const fields = [...study.fields.querySelectorAll('[name]')], values = {};
    for (const field of fields.filter(f => f.name !== 'set'))
        values[field.name.slice('axis '.length)] = field.value;
    const set = fields.find(f => f.name === 'set').value.split(/\s+/).filter(Boolean);
    study.said.className = '';
    study.said.textContent = '';
    try {
        await askServer(`/points?study=${study.number}`, {values, set});
    } catch (problem) {
        study.said.className = 'problem';
        study.said.textContent = problem.message;
    }
}

function showRuns(study, runs) {
    const own = runs.filter(r => r.study === study.name).slice(-8), text = JSON.stringify(own);
    if (study.runsText === text)
        return;
    study.runsText = text;
    study.runs.hidden = !own.length;
    study.runs.replaceChildren(...own.map(run => element('li', {'data-state': run.state},
        `${run.name}: ${run.state}${run.error ? ', ' + run.error : ''} `,
        ['waiting', 'running'].includes(run.state)
            ? button('Stop', e => {
                e.target.disabled = true;
                askServer('/stop', {id: run.id}).catch(problem => study.said.textContent = problem.message);
            }, {'aria-label': `Stop ${run.name}`})
            : null)));
}

function showProgress(study, {all, done, failed, running}) {
    study.bar.max = all || 1;
    study.bar.value = done;
    study.text.textContent = `${grouped(String(done))} of ${plural(all, 'point')}${
        failed ? `, ${failed} failed` : ''}${running ? '; the study is running' : ''}`;
}

/* --- a study's section ------------------------------------------------------------------------------------ */

/* What the reader has chosen in a section. */
function choicesIn(section, block) {
    const own = selector => [...section.querySelectorAll(selector)].filter(e => !block.contains(e));
    return {
        controls: own('.controls label').map(label => {
            const control = label.querySelector('select, input');
            const text = label.firstChild.nodeType === Node.TEXT_NODE ? label.firstChild.data : label.textContent;
            return [text, control.type === 'checkbox' ? control.checked : control.selectedOptions?.[0]?.text];
        }),
        hidden: own('.legend button[aria-pressed="false"]').map(b => b.textContent),
        open: own('details[open] > summary').map(s => s.textContent)
    };
}

function restoreChoices(section, {controls, hidden, open}) {
    for (const [text, value] of controls) {
        const label = [...section.querySelectorAll('.controls label')].find(l => l.textContent.startsWith(text));
        const control = label?.querySelector('select, input');
        const option = [...control?.options || []].find(o => o.text === value);
        if (!control || (control.type === 'checkbox' ? control.checked === value : !option || option.selected))
            continue;
        if (option)
            control.value = option.value;
        else
            control.checked = value;
        control.dispatchEvent(new Event('change'));
    }
    for (const name of hidden)
        [...section.querySelectorAll('.legend button')].find(b => b.textContent === name)?.click();
    for (const title of open)
        for (const summary of section.querySelectorAll('details > summary'))
            if (summary.textContent === title)
                summary.parentElement.open = true;
}

/* Shows the last of the points that were added since the section was made before. */
function showAdded(study, data) {
    const added = data.points.filter(p => p.added), keys = added.map(p => JSON.stringify(Object.keys(data.axes).map(
        a => p[a] ?? ''))), before = study.added;
    study.added = new Set(keys);
    const last = before ? keys.findLastIndex(key => !before.has(key)) : -1;
    if (last >= 0)
        study.section.showPoint?.(added[last]);
}

/* Puts a study's new section, which addSection() has put last, where the old one is. */
function replaceSection(study, section) {
    const links = document.getElementById('sections'), link = links.lastElementChild;
    if (study.section) {
        const choices = choicesIn(study.section, study.block), active = document.activeElement;
        study.section.replaceWith(section);
        study.link.replaceWith(link);
        restoreChoices(section, choices);
        section.querySelector('h2').after(study.block);
        if (study.block.contains(active))
            active.focus();
    } else {
        section.querySelector('h2').after(study.block);
    }
    study.section = section;
    study.link = link;
}

function showCard(study, data) {
    const cards = document.querySelector('ul.cards');
    if (!study.card)
        cards.append(study.card = element('li'));
    study.card.replaceChildren();
    fillCard(study.card, studySummary(data), study.name, study.section);
}

/* A page of studies is called by the first. */
function showTitle(study, data) {
    if (study.number !== 0 || !data.title)
        return;
    document.querySelector('h1').textContent = data.title;
    document.title = `${data.title} - touchstone`;
}

/* Fetches a study's data until what is shown is what there is. A large study is not fetched all the time. */
async function refreshStudy(study) {
    if (study.busy)
        return;
    study.busy = true;
    while (study.version !== study.wanted) {
        const begun = performance.now();
        try {
            const version = study.wanted, data = await askServer(`/data?study=${study.number}`);
            replaceSection(study, studySection(data, study.name));
            showAdded(study, data);
            fillForm(study, data);
            showCard(study, data);
            showTitle(study, data);
            followSections();
            study.version = version;
        } catch (problem) {
            study.text.textContent = problem.message;
            console.error(problem);
            break;
        }
        await new Promise(done => setTimeout(done, 10 * (performance.now() - begun)));
    }
    study.busy = false;
}

/* --- news ------------------------------------------------------------------------------------------------- */

function takeNews(news) {
    for (const [number, progress] of (news.studies || []).entries()) {
        const study = live.studies[number] ||= newLiveStudy(number, progress.name);
        showProgress(study, progress);
        showRuns(study, news.runs);
        study.wanted = progress.version;
        refreshStudy(study);
    }
}

async function startLive() {
    while (!document.documentElement.dataset.ready)
        await new Promise(done => setTimeout(done, 20));
    const state = element('p', {role: 'status'});
    document.querySelector('footer').replaceChildren(
        element('p', {}, 'Virtual times are exact: whole picoseconds.'), state);
    const events = new EventSource(`/events?token=${encodeURIComponent(live.token)}`);
    events.onopen = () => state.textContent = 'This page is live.';
    events.onerror = () => state.textContent =
        'The server does not answer: touchstone serve has ended, or the connection is lost.';
    events.onmessage = e => takeNews(JSON.parse(e.data));
}

startLive();
