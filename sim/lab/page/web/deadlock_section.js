/* deadlock_section.js - a deadlock: who waits for whom, as touchstone has drawn it, and the report. */
function deadlockSummary(data) {
    const lines = data.report.split('\n').map(l => l.trim()).filter(l => l);
    return {kind: 'Deadlock', big: 'every program waits', small: lines[0] || ''};
}

function deadlockSection(data, name) {
    const section = addSection('Deadlock', 'Deadlock: ' + baseName(name),
        `Why every program of the run waits, and no message is under way (${name}).`, name);
    const picture = element('img', {
        class: 'drawn',
        src: 'data:image/svg+xml;base64,' + btoa(data.svg),
        alt: 'Who waits for whom; the report below has the same in words.'
    });
    section.append(picture, element('h3', {}, 'Report'), element('pre', {class: 'report', tabindex: 0}, data.report));
    return section;
}
