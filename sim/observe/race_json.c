/* race_json.c - see race_json.h. */
#include "observe/race_json.h"
#include <stdlib.h>
#include "files/json_set.h"
#include "observe/json_file.h"
#include "observe/race_print.h"

static json_t *frame_json(const struct race_frame *f)
{
    return json_pack("{s:o, s:o, s:i}", "function", json_text(f->function), "file", json_text(f->file),
                     "line", f->line);
}

static json_t *side_json(const struct race_report_side *s)
{
    json_t *stack = json_array();
    for (size_t i = 0; i < s->depth; i++)
        json_append(stack, frame_json(&s->frames[i]));
    json_t *j = json_pack("{s:s, s:b, s:b, s:o}", "in", s->in_handler ? "handler" : "main", "reads", s->reads,
                          "writes", s->writes, "stack", stack);
    if (s->call)
        json_set(j, "call", json_text(s->call));
    if (s->at != VT_NEVER)
        json_set(j, "at_s", json_real(vt_seconds(s->at)));
    if (!s->posted_by)
        return j;
    json_set(j, "posted_by", json_text(s->posted_by));
    json_set(j, "posted", frame_json(&s->posted));
    return j;
}

static json_t *own_text(char *text)
{
    json_t *j = json_text(text);
    free(text);
    return j;
}

static json_t *report_json(const struct race_report *r)
{
    static const char *const WHAT[] = {"accesses", "update", "buffer sent", "buffer received", "two buffers"};
    return json_pack("{s:s, s:o, s:o, s:o, s:[o, o], s:I, s:o, s:s}", "what", WHAT[r->what], "text",
                     own_text(race_print_head(r)), "variable", json_text(r->variable), "why",
                     own_text(race_print_why(r)), "accesses", side_json(&r->side[0]), side_json(&r->side[1]),
                     "count", (json_int_t)r->count, "nodes", own_text(race_print_nodes(r)), "first_on",
                     r->node);
}

json_t *race_json(const struct race_reports *t)
{
    json_t *list = json_array();
    for (size_t i = 0; i < t->count; i++)
        json_append(list, report_json(&t->list[i]));
    return list;
}

char *race_json_write(const struct race_reports *t, const char *path)
{
    return json_file_write(json_pack("{s:s, s:b, s:o, s:I}", "format", "touchstone races 1", "checked",
                                     t->checked, "races", race_json(t), "suppressed",
                                     (json_int_t)t->suppressed),
                           path);
}
