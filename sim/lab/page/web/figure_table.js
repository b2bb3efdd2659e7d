/* figure_table.js - tables of figures: they scroll in a region of their own, and show many rows only when
 * asked. */

/* columns: [ { name, text, get(row), show(value) } ]; text: true for texts. Numbers without show() have equal
 * decimals in a column, and picoseconds, which are BigInts, the unit of the column's longest time. */
function figureTable(label, columns, rows, most = 200) {
    columns = columns.map(c => (c.text || c.show ? c : {...c, show: showAlike(rows.map(c.get))}));
    const body = element('tbody');
    const table = element('table', {},
        element('thead', {},
            element('tr', {},
                columns.map(c => element('th', {scope: 'col', class: c.text ? 'text' : null}, c.name)))),
        body);
    const region =
        element('div', {class: 'scroll tall', role: 'region', 'aria-label': label, tabindex: '0'}, table);
    let shown = 0;
    const more = button('', () => addRows(shown + 2000));
    function addRows(upTo) {
        const part = document.createDocumentFragment();
        for (; shown < Math.min(upTo, rows.length); shown++)
            part.append(element('tr', {}, columns.map(c => cell(c, rows[shown]))));
        body.append(part);
        more.textContent = `Show more of the ${grouped(String(rows.length))} rows`;
        more.hidden = shown >= rows.length;
    }
    addRows(most);
    return [region, more];
}

/* How to show each of the values. */
function showAlike(values) {
    const unit = durationUnit(values.reduce((m, v) => (typeof v === 'bigint' && v > m ? v : m), 0n));
    const number = v => (typeof v === 'bigint' ? Number(v) / Number(PICOSECONDS[unit]) : v);
    const parts = values.map(number).filter(v => typeof v === 'number' && !Number.isInteger(v));
    const decimals = decimalsFor(parts.length ? values.map(number).filter(v => typeof v === 'number') : []);
    const timeText = v => rounded(`${fixed(number(v), decimals)}\u00a0${UNIT_TEXT[unit]}`, inUnit(v, unit));
    return v => (typeof v === 'bigint'   ? timeText(v)
                 : typeof v !== 'number' ? figure(v)
                 : parts.length          ? rounded(fixed(v, decimals), String(v))
                                         : grouped(String(v)));
}

function cell(column, row) {
    const value = column.get(row), shown = column.show ? column.show(value, row) : figure(value);
    return element('td', {class: column.text ? 'text' : null}, shown);
}
