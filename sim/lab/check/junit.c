/* junit.c - see junit.h. */
#include "lab/check/junit.h"
#include "files/text_file.h"
#include "kernel/xalloc.h"
#include "lab/check/compare_print.h"

#include <stdlib.h>
#include <string.h>

/* The bytes of the UTF-8 character at s if XML 1.0 allows it; otherwise 0. */
static size_t xml_character(const char *s)
{
    size_t length = text_character(s);
    bool control = (unsigned char)*s < ' ' && *s != '\t' && *s != '\n';
    bool none = length == 3 && (!memcmp(s, "\xef\xbf\xbe", 3) || !memcmp(s, "\xef\xbf\xbf", 3));
    return control || none ? 0 : length;
}

/* Writes text, for content and attributes. Bytes that XML does not allow become '?': programs may print
 * anything. */
static void write_text(const char *text, FILE *out)
{
    for (const char *s = text; *s;) {
        static const char special[] = "&<>\"\n\t";
        static const char *const escaped[] = {"&amp;", "&lt;", "&gt;", "&quot;", "&#10;", "&#9;"};
        const char *found = strchr(special, *s);
        size_t length = xml_character(s);
        if (found)
            fputs(escaped[found - special], out);
        else if (length)
            fwrite(s, 1, length, out);
        else
            fputc('?', out);
        s += length ? length : 1;
    }
}

static void write_attribute(const char *name, const char *value, FILE *out)
{
    fprintf(out, " %s=\"", name);
    write_text(value, out);
    fputc('"', out);
}

/* What print writes of a point, malloc'd. */
static char *told(const struct compare_point *p, void (*print)(const struct compare_point *, FILE *))
{
    char *text = NULL;
    size_t size;
    FILE *f = xchecked(open_memstream(&text, &size));
    print(p, f);
    if (fclose(f) != 0)
        xexhausted();
    if (size && text[size - 1] == '\n')
        text[size - 1] = '\0';
    return text;
}

static void write_case(const struct compare_point *p, FILE *out)
{
    char *class = xasprintf("touchstone.%s", p->study), *all = told(p, compare_print);
    fputs("    <testcase", out);
    write_attribute("classname", class, out);
    write_attribute("name", p->name, out);
    fprintf(out, " time=\"%.9f\">", p->time_s);
    if (compare_is_failure(p->verdict)) {
        const char *element = p->verdict == COMPARE_FAILED ? "error" : "failure";
        char *brief = told(p, compare_print_short);
        fprintf(out, "\n      <%s", element);
        write_attribute("message", p->failure ? p->failure : brief, out);
        fputc('>', out);
        write_text(all, out);
        fprintf(out, "</%s>\n    ", element);
        free(brief);
    } else if (*all) {
        fputs("\n      <system-out>", out);
        write_text(all, out);
        fputs("</system-out>\n    ", out);
    }
    fputs("</testcase>\n", out);
    free(all);
    free(class);
}

/* Writes the attributes that count these test cases. */
static void write_counts(struct compare_point *const points[], size_t count, FILE *out)
{
    size_t failures = 0, errors = 0;
    double time = 0;
    for (size_t i = 0; i < count; i++) {
        failures += points[i]->verdict == COMPARE_WORSE || points[i]->verdict == COMPARE_MISSING;
        errors += points[i]->verdict == COMPARE_FAILED;
        time += points[i]->time_s;
    }
    fprintf(out, " tests=\"%zu\" failures=\"%zu\" errors=\"%zu\" time=\"%.9f\">\n", count, failures, errors,
            time);
}

void junit_write(struct compare_point *const points[], size_t count, FILE *out)
{
    fputs("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"touchstone\"", out);
    write_counts(points, count, out);
    for (size_t from = 0, to; from < count; from = to) {
        for (to = from; to < count && strcmp(points[to]->study, points[from]->study) == 0;)
            to++;
        fputs("  <testsuite", out);
        write_attribute("name", points[from]->study, out);
        write_counts(points + from, to - from, out);
        for (size_t i = from; i < to; i++)
            write_case(points[i], out);
        fputs("  </testsuite>\n", out);
    }
    fputs("</testsuites>\n", out);
}
