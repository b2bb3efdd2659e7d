/* page.c - see page.h. */
#include "lab/page/page.h"
#include <nettle/base64.h>
#include <nettle/sha2.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "lab/page/data_blob.h"
#include "lab/page/page_item.h"
#include "lab/page/page_surface.h"
#include "lab/page/page_trace.h"
#include "lab/page/web_files.h"

struct page {
    struct page_item *items;
    size_t count;
    bool live;
};

/* As web/page_start.js calls them. */
static const char *const KIND_NAMES[PAGE_KINDS] = {"tables",   "study", "run",    "profile", "trace",
                                                   "deadlock", "path",  "stacks", "surface"};

struct page *page_new(void)
{
    return xcalloc(1, sizeof(struct page));
}

void page_free(struct page *p)
{
    for (size_t i = 0; i < p->count; i++)
        page_item_free(&p->items[i]);
    free(p->items);
    free(p);
}

static struct page_item *new_item(struct page *p)
{
    p->items = xreallocarray(p->items, p->count + 1, sizeof *p->items);
    return &p->items[p->count];
}

bool page_add(struct page *p, const char *path, const struct trace_selection *selection, char **error)
{
    bool ok = page_item_read(new_item(p), path, selection, error);
    p->count += ok;
    return ok;
}

void page_add_study(struct page *p, const char *name, json_t *results)
{
    *new_item(p) = (struct page_item){.kind = PAGE_STUDY, .name = xstrdup(name), .json = results};
    p->count++;
}

void page_add_trace(struct page *p, const char *name, const struct trace *t)
{
    *new_item(p) = (struct page_item){.kind = PAGE_TRACE, .name = xstrdup(name), .trace = t};
    p->count++;
}

bool page_has_trace(const struct page *p)
{
    for (size_t i = 0; i < p->count; i++)
        if (p->items[i].kind == PAGE_TRACE)
            return true;
    return false;
}

void page_set_live(struct page *p)
{
    p->live = true;
}

/* --- text ----------------------------------------------------------------------------------------------- */

/* Writes a text so that it is only text, in an element or an attribute. Bytes that are not ASCII stay: of
 * a name that is not UTF-8, a browser shows the replacement character. */
static void write_text(const char *text, FILE *out)
{
    for (; *text; text++) {
        if (strchr("<>&\"'", *text))
            fprintf(out, "&#%d;", *text);
        else
            fputc(*text, out);
    }
}

/* The different texts that a page may be called by. */
struct names {
    char **text;
    size_t count;
};

/* Takes over the text, which may be NULL. The page's items are often of one run: what they all say is said
 * once. */
static void name_also(struct names *n, char *text)
{
    bool said = !text;
    for (size_t i = 0; !said && i < n->count; i++)
        said = !strcmp(n->text[i], text);
    if (said)
        free(text);
    else
        n->text[n->count++] = text;
}

/* "1 more" is no shorter than the one's name. */
static char *made_title(const struct page *p)
{
    struct names n = {xreallocarray(NULL, p->count + 1, sizeof *n.text), 0};
    char *title;
    for (size_t i = 0; i < p->count; i++)
        name_also(&n, page_item_about(&p->items[i]));
    if (!n.count)
        for (size_t i = 0; i < p->count; i++)
            name_also(&n, page_item_title(&p->items[i]));
    if (n.count > 2)
        title = xasprintf("%s and %zu more", n.text[0], n.count - 1);
    else if (n.count == 2)
        title = xasprintf("%s and %s", n.text[0], n.text[1]);
    else
        title = xstrdup(n.count ? n.text[0] : "touchstone");
    while (n.count)
        free(n.text[--n.count]);
    free(n.text);
    return title;
}

static void write_title(const struct page *p, const char *title, FILE *out)
{
    char *made = title ? NULL : made_title(p);
    write_text(title ? title : made, out);
    free(made);
}

/* --- what the browser may do ---------------------------------------------------------------------------- */

static void write_hash(struct sha256_ctx *sha, FILE *out)
{
    uint8_t bytes[SHA256_DIGEST_SIZE];
    char text[BASE64_ENCODE_RAW_LENGTH(SHA256_DIGEST_SIZE) + 1] = "";
    sha256_digest(sha, sizeof bytes, bytes);
    base64_encode_raw(text, sizeof bytes, bytes);
    fprintf(out, " 'sha256-%s'", text);
}

static void write_file_hash(struct web_file f, FILE *out)
{
    struct sha256_ctx sha;
    sha256_init(&sha);
    sha256_update(&sha, f.size, (const uint8_t *)f.bytes);
    write_hash(&sha, out);
}

static void write_scripts_hash(const struct page *p, FILE *out)
{
    struct sha256_ctx sha;
    sha256_init(&sha);
    for (const struct web_script *s = WEB_SCRIPTS; s->bytes; s++)
        sha256_update(&sha, (size_t)(s->end - s->bytes), (const uint8_t *)s->bytes);
    if (p->live)
        sha256_update(&sha, web_live().size, (const uint8_t *)web_live().bytes);
    write_hash(&sha, out);
}

/* The Content-Security-Policy: nothing is fetched, and no script runs but those of touchstone, whatever a
 * name in the data may hold. */
static void write_policy(const struct page *p, FILE *out)
{
    fputs("default-src 'none'; base-uri 'none'; form-action 'none'; img-src data: blob:; style-src", out);
    write_file_hash(web_style(), out);
    fputs("; script-src", out);
    write_scripts_hash(p, out);
    write_file_hash(web_d3(), out);
    write_file_hash(web_three(), out);
    if (p->live)
        fputs("; connect-src 'self'", out);
}

/* --- data ----------------------------------------------------------------------------------------------- */

static void begin_data(const char *kind, const char *name, struct data_blob *b, FILE *out)
{
    fprintf(out, "<script type=\"text/plain\" data-kind=\"%s\" data-name=\"", kind);
    write_text(name, out);
    fputs("\">", out);
    data_blob_begin(b, out);
}

static void end_data(struct data_blob *b, FILE *out)
{
    data_blob_end(b);
    fputs("</script>\n", out);
}

static void write_library(const char *name, struct web_file f, FILE *out)
{
    struct data_blob b;
    begin_data("library", name, &b, out);
    data_blob_add(&b, f.bytes, f.size);
    end_data(&b, out);
}

static int add_part(const char *part, size_t size, void *blob)
{
    data_blob_add(blob, part, size);
    return 0;
}

static void write_json(enum page_kind kind, const char *name, const json_t *j, FILE *out)
{
    struct data_blob b;
    begin_data(KIND_NAMES[kind], name, &b, out);
    json_dump_callback(j, add_part, &b, JSON_COMPACT | JSON_REAL_PRECISION(17));
    end_data(&b, out);
}

static void write_item(const struct page_item *item, FILE *out)
{
    struct data_blob b;
    if (item->json) {
        write_json(item->kind, item->name, item->json, out);
        if (item->deadlock)
            write_json(PAGE_DEADLOCK, item->name, item->deadlock, out);
        return;
    }
    begin_data(KIND_NAMES[item->kind], item->name, &b, out);
    if (item->kind == PAGE_TRACE)
        page_trace_write(item->trace, &b);
    else if (item->kind == PAGE_SURFACE)
        page_surface_write(&item->mesh, &b);
    else
        data_blob_add(&b, item->text, strlen(item->text));
    end_data(&b, out);
}

static void write_data(const struct page *p, FILE *out)
{
    bool surfaces = false;
    for (size_t i = 0; i < p->count; i++)
        surfaces |= p->items[i].kind == PAGE_SURFACE;
    write_library("d3", web_d3(), out);
    if (surfaces)
        write_library("three", web_three(), out);
    for (size_t i = 0; i < p->count; i++)
        write_item(&p->items[i], out);
}

/* --- the page ------------------------------------------------------------------------------------------- */

static void write_file(struct web_file f, FILE *out)
{
    fwrite(f.bytes, 1, f.size, out);
}

static void write_scripts(const struct page *p, FILE *out)
{
    fputs("<script>", out);
    for (const struct web_script *s = WEB_SCRIPTS; s->bytes; s++)
        fwrite(s->bytes, 1, (size_t)(s->end - s->bytes), out);
    if (p->live)
        write_file(web_live(), out);
    fputs("</script>", out);
}

static void write_style(FILE *out)
{
    fputs("<style>", out);
    write_file(web_style(), out);
    fputs("</style>", out);
}

/* Writes what the mark stands for. */
static void write_marked(const char *mark, size_t length, const struct page *p, const char *title, FILE *out)
{
#define IS(name) (length == sizeof(name) - 1 && !memcmp(mark, (name), sizeof(name) - 1))
    if (IS("title"))
        write_title(p, title, out);
    else if (IS("policy"))
        write_policy(p, out);
    else if (IS("licences"))
        write_file(web_licences(), out);
    else if (IS("style"))
        write_style(out);
    else if (IS("data"))
        write_data(p, out);
    else if (IS("scripts"))
        write_scripts(p, out);
#undef IS
}

/* web/page.html has marks, {{title}} and the like, which no other text there has. */
bool page_write(const struct page *p, const char *title, FILE *out)
{
    struct web_file html = web_page();
    const char *at = html.bytes, *end = html.bytes + html.size, *mark;
    while ((mark = memmem(at, (size_t)(end - at), "{{", 2))) {
        const char *close = memmem(mark, (size_t)(end - mark), "}}", 2);
        fwrite(at, 1, (size_t)(mark - at), out);
        write_marked(mark + 2, (size_t)(close - mark - 2), p, title, out);
        at = close + 2;
    }
    fwrite(at, 1, (size_t)(end - at), out);
    fflush(out);
    return !ferror(out);
}
