/* test_page.c - pages: the columns of a trace are exact, and no text of the data is markup. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <cmocka.h>
#include <nettle/base64.h>
#include <stdio.h>
#include <string.h>
#include <zlib.h>
#include "lab/page/data_columns.h"
#include "lab/page/page.h"
#include "tests/lab/made_trace.h"

/* Writes the page into memory; the caller frees *text. */
static void write_page(const struct page *p, const char *title, char **text)
{
    size_t size = 0;
    FILE *out = open_memstream(text, &size);
    assert_true(page_write(p, title, out));
    fclose(out);
}

/* The bytes of base64 that ends at '<', inflated: *size of them. */
static uint8_t *inflated(const char *base64, size_t *size)
{
    enum { MOST = 1 << 20 };
    size_t length = strcspn(base64, "<"), packed = 0;
    uint8_t *deflated = xmalloc(BASE64_DECODE_LENGTH(length)), *bytes = xmalloc(MOST);
    struct base64_decode_ctx ctx;
    uLongf room = MOST;
    base64_decode_init(&ctx);
    assert_true(base64_decode_update(&ctx, &packed, deflated, length, base64));
    assert_true(base64_decode_final(&ctx));
    assert_int_equal(uncompress(bytes, &room, deflated, packed), Z_OK);
    free(deflated);
    *size = room;
    return bytes;
}

/* The data of the page's first item of that kind. */
static uint8_t *data_of(const char *page, const char *kind, size_t *size)
{
    char *mark = xasprintf("data-kind=\"%s\"", kind);
    const char *at = strstr(page, mark);
    free(mark);
    assert_non_null(at);
    return inflated(strchr(at, '>') + 1, size);
}

/* --- columns, read as web/data_items.js reads them --- */

struct table {
    json_t *header;
    const uint8_t *bytes;
    size_t first; /* of the columns */
};

static struct table table_of(const uint8_t *bytes)
{
    uint64_t length;
    memcpy(&length, bytes, sizeof length);
    assert_int_equal(length % 8, 0);
    struct table t = {json_loadb((const char *)bytes + 8, length, 0, NULL), bytes, 8 + length};
    assert_non_null(t.header);
    return t;
}

/* Number i of a column of 64 bits, without regard to its base. */
static uint64_t raw(const struct table *t, const char *name, size_t i)
{
    size_t at = t->first, k;
    json_t *column;
    json_array_foreach(json_object_get(t->header, "columns"), k, column)
    {
        size_t count = (size_t)json_integer_value(json_object_get(column, "count"));
        const char *type = json_string_value(json_object_get(column, "type"));
        size_t bytes = strcmp(type, "u64") == 0   ? 8
                       : strcmp(type, "u8") == 0  ? 1
                       : strcmp(type, "u16") == 0 ? 2
                                                  : 4;
        if (strcmp(json_string_value(json_object_get(column, "name")), name) == 0) {
            uint32_t lower, upper;
            memcpy(&lower, t->bytes + at + 4 * i, 4);
            memcpy(&upper, t->bytes + at + 4 * (count + i), 4);
            return (uint64_t)upper << 32 | lower;
        }
        at += (count * bytes + 7) / 8 * 8;
    }
    fail_msg("no column %s", name);
    return 0;
}

/* Number i of a column whose base is "". */
static uint64_t summed(const struct table *t, const char *name, size_t i)
{
    uint64_t sum = 0;
    for (size_t k = 0; k <= i; k++)
        sum += raw(t, name, k);
    return sum;
}

/* --- tests --- */

/* 100 days, and a picosecond: no number of JavaScript. */
static const vtime LATE = 8640000 * VT_SECOND + 1;

static struct trace late_trace(void)
{
    struct trace t = made_trace(2, LATE + 4000);
    t.program = "<script>alert(1)</script>";
    int32_t sending = made_call(&t, 0, "csend", TRACE_SENDS, 5, LATE, LATE + 7);
    int32_t taking = made_call(&t, 1, "crecv", TRACE_RECEIVES, 5, LATE - 3, LATE + 99);
    made_message(&t, sending, taking, 1, UINT64_C(1) << 40, LATE + 1, LATE + 2, LATE + 50, LATE + 90);
    return t;
}

static void free_made(struct trace *t)
{
    for (int32_t i = 0; i < t->name_count; i++)
        free(t->names[i]);
    free(t->names), free(t->classes), free(t->nodes), free(t->calls), free(t->waits);
    free(t->handlers), free(t->systems), free(t->messages), free(t->blocks);
}

static void times_are_exact(void **state)
{
    (void)state;
    struct trace trace = late_trace();
    struct page *p = page_new();
    size_t size;
    page_add_trace(p, "late", &trace);
    char *page = NULL;
    write_page(p, NULL, &page);
    uint8_t *bytes = data_of(page, "trace", &size);
    struct table t = table_of(bytes);
    assert_string_equal(json_string_value(json_object_get(t.header, "end")), "8640000000000004001");
    assert_true(summed(&t, "call.begin", 0) == LATE);
    assert_true(summed(&t, "call.begin", 1) == LATE - 3); /* a difference below 0 */
    assert_true(summed(&t, "call.begin", 1) + raw(&t, "call.end", 1) == LATE + 99);
    assert_true(raw(&t, "message.bytes", 0) == UINT64_C(1) << 40);
    uint64_t sent = summed(&t, "message.sent", 0),
             moved = sent + raw(&t, "message.entered", 0) + raw(&t, "message.moved", 0);
    assert_true(sent == LATE + 1 && moved == LATE + 2);
    assert_true(sent + raw(&t, "message.asked", 0) == VT_NEVER); /* a short message does not ask */
    json_decref(t.header);
    free(bytes);
    free(page);
    page_free(p);
    free_made(&trace);
}

static void names_are_no_markup(void **state)
{
    (void)state;
    struct trace trace = late_trace();
    struct page *p = page_new();
    page_add_trace(p, "\"><script>alert(2)</script>", &trace);
    char *page = NULL;
    write_page(p, "a & b's <title>", &page);
    assert_null(strstr(page, "<script>alert"));
    assert_non_null(strstr(page, "data-name=\"&#34;&#62;&#60;script&#62;alert(2)"));
    assert_non_null(strstr(page, "<h1>a &#38; b&#39;s &#60;title&#62;</h1>"));
    free(page);
    page_free(p);
    free_made(&trace);
}

static void a_page_is_written_as_often_as_asked(void **state)
{
    (void)state;
    struct trace trace = late_trace();
    struct page *p = page_new();
    page_add_trace(p, "late", &trace);
    char *once = NULL, *again = NULL;
    write_page(p, NULL, &once);
    write_page(p, NULL, &again);
    assert_string_equal(once, again);
    assert_non_null(strstr(once, "</html>"));
    free(once);
    free(again);
    page_free(p);
    free_made(&trace);
}

/* A page is called by what it is about, not by files: once where several are of one run. */
static void its_title_says_what_it_is_about(void **state)
{
    (void)state;
    struct trace trace = late_trace(), other = late_trace(), third = late_trace();
    trace.program = other.program = third.program = "/tmp/ring";
    trace.machine = "delta", other.machine = "paragon", third.machine = "ipsc860";
    struct page *p = page_new();
    char *page[4];
    page_add_trace(p, "a", &trace);
    write_page(p, NULL, &page[0]);
    page_add_trace(p, "b", &trace);
    write_page(p, NULL, &page[1]);
    page_add_trace(p, "c", &other);
    write_page(p, NULL, &page[2]);
    page_add_trace(p, "d", &third);
    page_add_trace(p, "e", &third);
    write_page(p, NULL, &page[3]);
    assert_non_null(strstr(page[0], "<h1>ring on 2 nodes of delta</h1>"));
    assert_non_null(strstr(page[1], "<h1>ring on 2 nodes of delta</h1>"));
    assert_non_null(strstr(page[2], "<h1>ring on 2 nodes of delta and ring on 2 nodes of paragon</h1>"));
    assert_non_null(strstr(page[3], "<h1>ring on 2 nodes of delta and 2 more</h1>"));
    for (int i = 0; i < 4; i++)
        free(page[i]);
    page_free(p);
    free_made(&trace);
    free_made(&other);
    free_made(&third);
}

static uint64_t square(const void *of, size_t i)
{
    return *(const uint64_t *)of * i * i;
}

static uint64_t place(const void *of, size_t i)
{
    (void)of;
    return i;
}

/* More numbers than are packed at a time, of all widths: their columns begin where the reader looks. */
static void columns_follow_each_other(void **state)
{
    (void)state;
    enum { COUNT = 20011 };
    const uint64_t times = UINT64_C(0x100000001);
    const struct column columns[] = {{"small", COLUMN_U8, COUNT, place, NULL, NULL},
                                     {"middle", COLUMN_U16, COUNT, place, NULL, ""},
                                     {"wide", COLUMN_U64, COUNT, square, &times, ""},
                                     {"from wide", COLUMN_U64, COUNT, square, &times, "wide"}};
    struct data_blob b;
    char *text = NULL;
    size_t length = 0, size;
    FILE *out = open_memstream(&text, &length);
    data_blob_begin(&b, out);
    data_columns_write(&b, json_object(), columns, 4);
    data_blob_end(&b);
    fputc('<', out);
    fclose(out);
    uint8_t *bytes = inflated(text, &size);
    struct table t = table_of(bytes);
    assert_true(summed(&t, "wide", COUNT - 1) == times * (COUNT - 1) * (COUNT - 1));
    assert_int_equal(raw(&t, "from wide", COUNT - 1), 0);
    assert_int_equal(bytes[t.first + 255], 255);
    assert_int_equal(bytes[t.first + 256], 0);
    json_decref(t.header);
    free(bytes);
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(times_are_exact),
        cmocka_unit_test(names_are_no_markup),
        cmocka_unit_test(a_page_is_written_as_often_as_asked),
        cmocka_unit_test(its_title_says_what_it_is_about),
        cmocka_unit_test(columns_follow_each_other),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
