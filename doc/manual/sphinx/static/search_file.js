/* search_file.js - where the manual is read from files, its search gets pages' texts from search_texts.js. */
if (location.protocol === 'file:') {
    const ask = window.fetch;
    window.fetch = address => {
        const text = searchTexts[String(address).replace(/[?#].*/, '').replace(/^.*\//, '')];
        return text ? Promise.resolve(new Response(text)) : ask(address);
    };
}
