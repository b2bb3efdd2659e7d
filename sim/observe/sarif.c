/* sarif.c - see sarif.h. Lines of source are known by their file's name: it stands for the path. */
#include "observe/sarif.h"
#include <stdlib.h>
#include <string.h>
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "observe/json_file.h"
#include "observe/race_print.h"

/* --- parts of a result ---------------------------------------------------------------------------------- */

/* A file's name as a relative URI (RFC 3986); malloc'd. */
static char *uri_of(const char *file, size_t length)
{
    static const char PLAIN[] = "-._~/ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789";
    char *uri;
    size_t size;
    FILE *f = xchecked(open_memstream(&uri, &size));
    for (size_t i = 0; i < length; i++)
        if (strchr(PLAIN, file[i]))
            fputc(file[i], f);
        else
            fprintf(f, "%%%02X", (unsigned char)file[i]);
    fclose(f);
    return uri;
}

/* A place; text: what happened there, NULL: nothing to say. */
static json_t *location(const char *file, size_t length, int line, const char *text)
{
    char *uri = uri_of(file, length);
    json_t *o = xchecked(json_pack("{s:{s:{s:s}, s:{s:i}}}", "physicalLocation", "artifactLocation", "uri",
                                   uri, "region", "startLine", line));
    if (text)
        json_set(o, "message", xchecked(json_pack("{s:o}", "text", json_text(text))));
    free(uri);
    return o;
}

/* The place that the first `length` letters name, "ring.c:17"; NULL: none. */
static json_t *named(const char *text, size_t length, const char *what)
{
    const char *colon = memrchr(text, ':', length);
    int line = colon ? atoi(colon + 1) : 0;
    return line > 0 ? location(text, (size_t)(colon - text), line, what) : NULL;
}

/* "40 bytes, ring.c:3": a variable, and where it is declared. */
static bool is_of_variable(const char *text)
{
    size_t digits = strspn(text, "0123456789");
    return digits && strncmp(text + digits, " byte", 5) == 0;
}

/* The first place in parentheses that a report names, and at which something has happened. */
static json_t *first_named(const char *text)
{
    json_t *found = NULL;
    for (const char *at = text; !found && (at = strchr(at, '(')); at++)
        if (!is_of_variable(at + 1))
            found = named(at + 1, strcspn(at + 1, "()\n"), NULL);
    return found;
}

/* Takes over first and others; first NULL: no place is known. */
static json_t *result(const char *rule, const char *level, const char *text, json_t *first, json_t *others)
{
    json_t *o = xchecked(json_pack("{s:s, s:s, s:{s:o}, s:o}", "ruleId", rule, "level", level, "message",
                                   "text", json_text(text), "locations", json_array()));
    if (first)
        json_append(json_object_get(o, "locations"), first);
    if (others && json_array_size(others))
        json_set(o, "relatedLocations", others);
    else
        json_decref(others);
    return o;
}

/* --- findings ------------------------------------------------------------------------------------------- */

static json_t *side_location(const struct race_report_side *s)
{
    const struct race_frame *f = &s->frames[0];
    char *text = xasprintf("the %s %s here", s->in_handler ? "handler" : "main program",
                           s->call     ? s->call
                           : s->writes ? "writes"
                                       : "reads");
    json_t *o = *f->file && f->line > 0 ? location(f->file, strlen(f->file), f->line, text) : NULL;
    free(text);
    return o;
}

static bool has_line(const json_t *list, const json_t *place)
{
    size_t i;
    json_t *other;
    json_array_foreach(list, i,
                       other) if (json_equal(json_object_get(other, "physicalLocation"),
                                             json_object_get(place, "physicalLocation"))) return true;
    return false;
}

/* Takes over place; NULL, and a line that is there already, add nothing. */
static void add_line(json_t *lines, json_t *place)
{
    if (!place || has_line(lines, place))
        json_decref(place);
    else
        json_append(lines, place);
}

static json_t *take_first(json_t *lines)
{
    json_t *first = json_incref(json_array_get(lines, 0));
    json_array_remove(lines, 0);
    return first;
}

/* The races of the variable of race i, which is the first of them: what it is and why, then the others. */
static json_t *race_result(const struct race_reports *t, size_t i)
{
    char *head = race_print_head(&t->list[i]), *why = race_print_why(&t->list[i]);
    char *text = xasprintf("%s: %s", head, why);
    json_t *lines = xchecked(json_array());
    free(why);
    free(head);
    for (size_t k = i; k < t->count; k++) {
        if (t->list[k].group != i)
            continue;
        if (k > i) {
            head = race_print_head(&t->list[k]);
            char *longer = xasprintf("%s. Also: %s", text, head + strcspn(head, ":") + 2);
            free(head);
            free(text);
            text = longer;
        }
        add_line(lines, side_location(&t->list[k].side[0]));
        add_line(lines, side_location(&t->list[k].side[1]));
    }
    json_t *first = take_first(lines), *o = result("race", "warning", text, first, lines);
    free(text);
    return o;
}

static bool gave_up(const struct waitfor_node *n)
{
    return n->state == WAITFOR_ENDED && n->exit_status != 0;
}

/* The line at which a node waits, or ended with an error; NULL: it does neither, or its line is not known. */
static json_t *stands_at(const struct waitfor_node *n)
{
    bool waits = n->state == WAITFOR_WAITS;
    if (!n->line || (!waits && !gave_up(n)))
        return NULL;
    char *text = waits ? NULL : xasprintf("%s ended here with exit(%d)", n->name, n->exit_status);
    json_t *place = named(n->line, strlen(n->line), waits ? n->why : text);
    free(text);
    return place;
}

/* Each line at which nodes stand is there once. If a node ended with an error, that is the cause, and its
 * line the first. */
static json_t *deadlock_result(const struct machine *m)
{
    json_t *cause = NULL, *lines = xchecked(json_array());
    for (uint32_t i = 0; i < m->waits->count; i++) {
        const struct waitfor_node *n = &m->waits->nodes[i];
        json_t *place = stands_at(n);
        if (place && !cause && gave_up(n) && !has_line(lines, place))
            cause = place;
        else
            add_line(lines, place);
    }
    const char *rule = cause ? "exit" : "deadlock";
    if (!cause)
        cause = take_first(lines);
    return result(rule, "error", m->message ? m->message : "deadlock", cause, lines);
}

/* "heap-buffer-overflow" of a report of --asan; "exit" of an exit with an error; else "crash". */
static char *rule_of(const char *message)
{
    if (strstr(message, " with exit("))
        return xstrdup("exit");
    const char *at = strstr(message, ": ");
    size_t length = at ? strspn(at + 2, "abcdefghijklmnopqrstuvwxyz-") : 0;
    return length && at[2 + length] == ':' && memchr(at + 2, '-', length) ? xstrndup(at + 2, length)
                                                                          : xstrdup("crash");
}

static json_t *error_result(const char *message)
{
    char *rule = rule_of(message);
    json_t *o = result(rule, "error", message, first_named(message), NULL);
    free(rule);
    return o;
}

static json_t *results(const struct machine *m, const struct race_reports *races)
{
    json_t *list = xchecked(json_array());
    for (size_t i = 0; i < races->count; i++)
        if (races->list[i].group == i)
            json_append(list, race_result(races, i));
    if (m->waits)
        json_append(list, deadlock_result(m));
    else if (m->outcome == MACHINE_FAILED && m->message)
        json_append(list, error_result(m->message));
    return list;
}

/* --- rules ---------------------------------------------------------------------------------------------- */

/* What the findings of a rule are, and what to do; those that are not here are kinds of errors of --asan. */
static const struct {
    const char *id, *what, *help;
} RULES[] = {
    {"race", "A handler and the main program use the same bytes, with no order between them",
     "What the program computes depends on when a message comes. Mask the handlers around the accesses "
     "(masktrap), or wait for what tells that the handler has run."},
    {"deadlock", "Every program waits, and no message is under way",
     "The message says for each node what it waits for, and why that does not come."},
    {"exit", "A program ended with an error",
     "Its own output says why. Programs that wait for its messages wait in vain."},
    {"crash", "A program crashed, or was stopped with an error",
     "The message has the calls that led there. Build the program with nxcc -g, so that it has lines, and "
     "with --asan, so that the first wrong access is told."}};

static json_t *rule_json(const char *id)
{
    const char *what = "The program uses memory that it may not",
               *help = "AddressSanitizer found this (nxcc --asan): the line is that of the wrong access.";
    for (size_t i = 0; i < sizeof RULES / sizeof *RULES; i++)
        if (!strcmp(id, RULES[i].id))
            what = RULES[i].what, help = RULES[i].help;
    return xchecked(json_pack("{s:s, s:{s:s}, s:{s:s}}", "id", id, "shortDescription", "text", what, "help",
                              "text", help));
}

/* The rules of the results, each once. */
static json_t *rules(const json_t *list)
{
    json_t *known = json_object(), *all = xchecked(json_array()), *o;
    size_t i;
    json_array_foreach(list, i, o)
    {
        const char *id = json_string_value(json_object_get(o, "ruleId"));
        if (json_object_get(known, id))
            continue;
        json_set(known, id, json_true());
        json_append(all, rule_json(id));
    }
    json_decref(known);
    return all;
}

char *sarif_write(const struct machine *m, const struct race_reports *races, const char *version,
                  const char *path)
{
    json_t *list = results(m, races);
    json_t *root = xchecked(json_pack("{s:s, s:s, s:[{s:{s:{s:s, s:s, s:o}}, s:o}]}", "$schema",
                                      "https://json.schemastore.org/sarif-2.1.0.json", "version", "2.1.0",
                                      "runs", "tool", "driver", "name", "touchstone", "version", version,
                                      "rules", rules(list), "results", list));
    return json_file_write(root, path);
}
