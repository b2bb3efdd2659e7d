/* elements.js - makes the elements of the page. Texts become text nodes only, so that a name of a program
 * can never become markup. */

/* element('td', { class: 'text', onclick: f }, 'some text', anotherElement, null) */
function element(tag, attributes, ...children) {
    return fillElement(document.createElement(tag), attributes, children);
}

function svgElement(tag, attributes, ...children) {
    return fillElement(document.createElementNS('http://www.w3.org/2000/svg', tag), attributes, children);
}

function fillElement(e, attributes, children) {
    for (const [name, value] of Object.entries(attributes || {})) {
        if (name.startsWith('on'))
            e.addEventListener(name.slice(2), value);
        else if (value === true)
            e.setAttribute(name, '');
        else if (value !== false && value !== null && value !== undefined)
            e.setAttribute(name, value);
    }
    e.append(...children.flat(Infinity).filter(c => c !== null && c !== undefined));
    return e;
}

let sectionCount = 0;

/* Adds a section with its heading and its place in the navigation. name: of what it shows, if other sections
 * may be called alike: followSections() tells them apart by it. */
function addSection(title, short, about, name = '') {
    const id = 'section-' + ++sectionCount, heading = element('h2', {id: id + '-title'}, title);
    const section = element('section', {id, 'aria-labelledby': id + '-title'}, heading);
    if (about)
        section.append(element('p', {class: 'about'}, about));
    document.getElementById('main').append(section);
    document.getElementById('sections').append(element('li', {},
        element('a', {href: '#' + id, 'data-short': short, 'data-name': name}, short)));
    return section;
}

/* A command line, which breaks between its words, not behind the hyphen of an option. */
function commandText(text) {
    return text.split(' ').flatMap((word, i) => [i ? ' ' : '', element('span', {class: 'word'}, word)]);
}

/* [ [term, value], ... ] */
function facts(list) {
    return element('dl', {class: 'facts'},
        list.filter(([, value]) => value !== null && value !== undefined && value !== '')
            .map(([term, value]) => [element('dt', {}, term), element('dd', {}, value)]));
}

function labelled(text, control) { return element('label', {}, text, control); }

/* choices: [ [value, text], ... ] */
function choice(label, choices, value, onchange) {
    const select = element('select', {onchange: () => onchange(select.value)}, choices.map(([v,
        text]) => element('option', {value: v, selected: String(v) === String(value)}, text)));
    return labelled(label, select);
}

function checkbox(label, checked, onchange) {
    const input = element('input', {type: 'checkbox', checked, onchange: () => onchange(input.checked)});
    return element('label', {}, input, label);
}

function button(text, onclick, attributes) {
    return element('button', {type: 'button', onclick, ...attributes}, text);
}

/* A part that is made when it is opened. make() returns elements. */
function later(title, make) {
    const details = element('details', {
        ontoggle: () => {
            if (details.open && details.children.length === 1)
                details.append(...[make()].flat());
        }
    },
        element('summary', {}, title));
    return details;
}

/* Calls draw(width) now and whenever the width of the element, or the colour scheme, changes. */
function onWidth(e, draw) {
    let width = 0;
    const follow = () => {
        if (Math.abs(e.clientWidth - width) >= 1 && e.clientWidth > 0)
            draw(width = e.clientWidth);
    };
    follow();
    /* Drawing within the observer's own call would be an error in the console. */
    new ResizeObserver(() => requestAnimationFrame(follow)).observe(e);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => width && draw(width));
}

/* The value of a colour of page.css, such as "waiting". */
function colour(name) {
    return getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();
}

/* "#rrggbb" as [r, g, b]. */
function rgb(hex) { return [1, 3, 5].map(i => parseInt(hex.slice(i, i + 2), 16)); }

/* A number for people. */
function figure(value, digits = 4) {
    if (typeof value !== 'number')
        return value === null || value === undefined ? '' : String(value);
    if (Number.isInteger(value))
        return grouped(String(value));
    const size = Math.abs(value);
    if (size >= 1e9 || (size < 1e-4 && size > 0))
        return value.toExponential(digits - 1);
    return String(Number(value.toPrecision(Math.max(digits, Math.ceil(Math.log10(size + 1)) + 1))));
}

/* A text for people; the exact form is shown under the mouse, and after a click in its place. */
function rounded(shown, exact) {
    return shown === exact ? shown : element('span', {class: 'rounded', title: exact}, shown);
}

document.addEventListener('click', e => {
    const text = e.target.closest('.rounded');
    if (text)
        [text.textContent, text.title] = [text.title, text.textContent];
});

/* So many decimals leave the greatest of the numbers five figures. */
function decimalsFor(numbers) {
    const most = numbers.reduce((m, v) => Math.max(m, Math.abs(v)), 0);
    return most > 0 ? Math.min(12, Math.max(0, 4 - Math.floor(Math.log10(most)))) : 0;
}

/* With so many decimals, and its thousands apart. */
function fixed(value, decimals) {
    const [whole, rest] = Math.abs(value).toFixed(decimals).split('.');
    return (value < 0 ? '\u2212' : '') + grouped(whole) + (rest ? '.' + rest : '');
}

/* A time in seconds, given as a number of seconds or as a BigInt of picoseconds. */
function timeFigure(value) {
    return typeof value === 'bigint' ? rounded(roughly(Number(value)), moment(value))
                                     : rounded(roughly(value * 1e12), seconds(value));
}

function plural(count, one, many) {
    return grouped(String(count)) + ' ' + (count === 1 ? one : many || one + 's');
}

/* What follows the last slash. */
function baseName(path) { return String(path).replace(/\/+$/, '').replace(/^.*\//, ''); }
