'use strict';
/* data_items.js - the data in the page's script elements of type text/plain: base64 of deflated bytes. */

/* Base64 to bytes, in parts, so that a text of 100 MB needs no copy of its size. */
function base64Bytes(text) {
    const length = text.length / 4 * 3 - (text.endsWith('==') ? 2 : text.endsWith('=') ? 1 : 0);
    const bytes = new Uint8Array(length), part = 1 << 20;
    for (let from = 0, at = 0; from < text.length; from += part) {
        const some = atob(text.slice(from, from + part));
        for (let i = 0; i < some.length; i++)
            bytes[at++] = some.charCodeAt(i);
    }
    return bytes;
}

async function inflated(text) {
    const stream = new Blob([base64Bytes(text)]).stream().pipeThrough(new DecompressionStream('deflate'));
    return new Response(stream).arrayBuffer();
}

/* Takes the bytes of a script element, which is then empty. */
async function takeBytes(script) {
    const text = script.textContent;
    script.textContent = '';
    return inflated(text);
}

async function takeText(script) { return new TextDecoder().decode(await takeBytes(script)); }

/* Integers of 64 bits, as lower and upper halves. at() is exact; number() is exact up to 2^53, and is for
 * drawing. */
class Wide {
    constructor(lower, upper) {
        this.lower = lower;
        this.upper = upper;
        this.length = lower.length;
    }
    at(i) { return BigInt(this.upper[i]) << 32n | BigInt(this.lower[i]); }
    number(i) { return this.upper[i] * 4294967296 + this.lower[i]; }
    /* The largest number stands for: it never came. */
    isNever(i) { return this.upper[i] === 0xffffffff && this.lower[i] === 0xffffffff; }
    numbers() {
        const list = new Float64Array(this.length);
        for (let i = 0; i < this.length; i++)
            list[i] = this.number(i);
        return list;
    }
}

/* Makes numbers of differences, modulo 2^64: from the one before, or from the same place of base. */
function addWide(wide, base) {
    const {lower, upper} = wide;
    let beforeLower = 0, beforeUpper = 0;
    for (let i = 0; i < lower.length; i++) {
        if (base) {
            beforeLower = base.lower[i];
            beforeUpper = base.upper[i];
        }
        const sum = lower[i] + beforeLower;
        lower[i] = sum;
        upper[i] += beforeUpper + (sum > 0xffffffff ? 1 : 0);
        beforeLower = lower[i];
        beforeUpper = upper[i];
    }
}

/* As addWide, for typed arrays, whose elements wrap by themselves. */
function addNarrow(list, base) {
    for (let i = 0; i < list.length; i++)
        list[i] += base ? base[i] : i ? list[i - 1] : 0;
}

const COLUMN_TYPES = {
    u8: Uint8Array,
    u16: Uint16Array,
    i32: Int32Array,
    f32: Float32Array
};

/* Tables as data_columns.h describes them: { header, and each column by its name }. */
function readColumns(buffer) {
    const headerBytes = new DataView(buffer).getUint32(0, true);
    const header = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 8, headerBytes)));
    const columns = {header};
    let at = 8 + headerBytes;
    for (const {name, type, count, base} of header.columns) {
        let column, bytes;
        if (type === 'u64') {
            column =
                new Wide(new Uint32Array(buffer, at, count), new Uint32Array(buffer, at + 4 * count, count));
            bytes = 8 * count;
        } else {
            column = new COLUMN_TYPES[type](buffer, at, count);
            bytes = column.byteLength;
        }
        if (base !== undefined)
            (type === 'u64' ? addWide : addNarrow)(column, base === '' ? null : columns[base]);
        columns[name] = column;
        at += Math.ceil(bytes / 8) * 8;
    }
    return columns;
}

/* Runs a library, which becomes a global variable. The page's policy knows the hash of its text. */
async function runLibrary(name) {
    const data = document.querySelector(`script[data-kind="library"][data-name="${name}"]`);
    const script = document.createElement('script');
    script.textContent = await takeText(data);
    document.head.append(script);
    script.remove();
}
