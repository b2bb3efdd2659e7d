/* exact_time.js - virtual times as people read them. Times are BigInts of picoseconds. Where one is
 * rounded, its exact form can be had (elements.js, rounded()). */
const PICOSECONDS = {
    s: 1000000000000n,
    ms: 1000000000n,
    us: 1000000n,
    ns: 1000n,
    ps: 1n
};
const UNIT_TEXT = {
    s: 's',
    ms: 'ms',
    us: 'µs',
    ns: 'ns',
    ps: 'ps'
};

/* Groups of three digits, apart by narrow spaces. */
function grouped(digits, fromLeft) {
    const space = '\u202f';
    return fromLeft ? digits.replace(/(\d{3})(?=\d)/g, '$1' + space)
                    : digits.replace(/\B(?=(\d{3})+$)/g, space);
}

function inUnit(time, unit) {
    const one = PICOSECONDS[unit], whole = time / one, rest = time % one;
    const decimals = rest ? String(rest).padStart(String(one).length - 1, '0').replace(/0+$/, '') : '';
    return grouped(String(whole)) + (decimals ? '.' + grouped(decimals, true) : '') + '\u00a0' +
           UNIT_TEXT[unit];
}

/* A moment: in seconds. */
function moment(time) { return inUnit(time, 's'); }

/* The unit that leaves something before the point; of no time, seconds. */
function durationUnit(time) {
    return time ? ['s', 'ms', 'us', 'ns', 'ps'].find(unit => time >= PICOSECONDS[unit]) : 's';
}

function duration(time) { return time < 0n ? '-' + duration(-time) : inUnit(time, durationUnit(time)); }

/* A duration that is not exact, to four figures: for axes and shares. Digits and units are those of the
 * texts that touchstone prints (files/virtual_time.c): what is less than a unit after rounding has the next. */
function roughly(picoseconds) {
    if (!picoseconds)
        return '0\u00a0s';
    for (const unit of ['s', 'ms', 'us', 'ns']) {
        const value = picoseconds / Number(PICOSECONDS[unit]), size = Math.abs(value);
        if (size >= 0.99995)
            return (size < 1000 ? value.toPrecision(4) : value.toFixed(0)) + '\u00a0' + UNIT_TEXT[unit];
    }
    return Math.round(picoseconds) + '\u00a0ps';
}

/* "1.5", "12ms", "3 us" as picoseconds; null if the text is no time. */
function parseTime(text) {
    const found = /^(\d+)(?:\.(\d*))?(s|ms|us|µs|ns|ps)?$/.exec(text.replace(/[\s\u202f\u00a0]/g, ''));
    if (!found)
        return null;
    const unit = (found[3] || 's').replace('µ', 'u'), places = String(PICOSECONDS[unit]).length - 1;
    const decimals = (found[2] || '').padEnd(places, '0').slice(0, places);
    return BigInt(found[1]) * PICOSECONDS[unit] + BigInt(decimals || 0);
}

/* A text that parseTime reads, with as many digits as tell moments apart on a screen that shows so long a
 * span. */
function shortTime(time, span) {
    const unit = durationUnit(time), one = Number(PICOSECONDS[unit]);
    const decimals = Math.min(12, Math.max(0, 4 + Math.floor(Math.log10(one)) - Math.floor(Math.log10(span))));
    return `${Number((Number(time) / one).toFixed(decimals))} ${UNIT_TEXT[unit]}`;
}

/* A number of seconds as a time. */
function picoseconds(value) { return BigInt(Math.round(value * 1e12)); }

/* Seconds as a file of results has them, all digits. */
function seconds(value) {
    const [whole, decimals] = String(value).split('.');
    return value === Math.abs(value) && !String(value).includes('e')
               ? grouped(whole) + (decimals ? '.' + grouped(decimals, true) : '') + '\u00a0s'
               : `${value}\u00a0s`;
}
