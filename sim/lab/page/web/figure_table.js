/* figure_table.js - tables of figures: they scroll in a region of their own, and show many rows only when
 * asked. */

/* columns: [ { name, text, get(row), show(value) } ]; text: true for texts. */
function figureTable(label, columns, rows, most = 200) {
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

function cell(column, row) {
    const value = column.get(row), shown = column.show ? column.show(value, row) : figure(value);
    return element('td', {class: column.text ? 'text' : null}, shown);
}
