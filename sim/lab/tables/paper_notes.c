/* paper_notes.c - what paper.cfg says about single rows, each named TABLE:NODES, and the names of the program's messages; see
 * the head of bench/paper/paper.cfg. All of it may be left out. */
#include "lab/tables/paper_notes.h"
#include "kernel/xalloc.h"

#include <stdlib.h>
#include <string.h>

bool paper_row_name(const char *text, unsigned *table, unsigned *nodes)
{
    char *end;
    long t = strtol(text, &end, 10);
    if (end == text || *end != ':' || t < 1 || t > 99)
        return false;
    const char *second = end + 1;
    long n = strtol(second, &end, 10);
    *table = (unsigned)t;
    *nodes = (unsigned)n;
    return end != second && !*end && n >= 1 && n <= 65536;
}

struct paper_row *paper_find(const struct paper *p, const char *name)
{
    unsigned table, nodes;
    if (!paper_row_name(name, &table, &nodes))
        return NULL;
    for (size_t t = 0; t < p->count; t++)
        for (size_t i = 0; p->tables[t].number == table && i < p->tables[t].count; i++)
            if (p->tables[t].rows[i].nodes == nodes)
                return &p->tables[t].rows[i];
    return NULL;
}

/* The row that a text of a list names; NULL once an error is kept. */
static struct paper_row *row_of(struct cfg_reader *r, struct paper *p, config_setting_t *at, const char *key,
                                const char *name)
{
    struct paper_row *row = name ? paper_find(p, name) : NULL;
    if (!row)
        cfg_fail(r, at, key, "must name rows of the tables, such as \"1:16\" (table:nodes)%s%s",
                 name ? ", not " : "", name ? name : "");
    return row;
}

/* The list, empty when it is left out. */
static bool optional_list(struct cfg_reader *r, const char *key, config_setting_t **list, unsigned *count)
{
    *count = 0;
    if (!config_setting_get_member(r->root, key))
        return true;
    if (!cfg_list(r, r->root, key, list))
        return false;
    *count = (unsigned)config_setting_length(*list);
    return true;
}

/* Marks the row, and those of other tables that are the same run. */
static void mark(struct paper *p, const struct paper_row *row, bool ties)
{
    for (size_t t = 0; t < p->count; t++)
        for (size_t i = 0; i < p->tables[t].count; i++) {
            struct paper_row *other = &p->tables[t].rows[i];
            if (other->nodes == row->nodes && strcmp(other->arguments, row->arguments) == 0)
                *(ties ? &other->ties : &other->fitted) = true;
        }
}

static bool read_marks(struct cfg_reader *r, struct paper *p, const char *key, bool ties)
{
    config_setting_t *list;
    unsigned count;
    if (!optional_list(r, key, &list, &count))
        return false;
    for (unsigned i = 0; i < count; i++) {
        config_setting_t *s = config_setting_get_elem(list, i);
        struct paper_row *row = row_of(r, p, s, key, config_setting_get_string(s));
        if (!row)
            return false;
        mark(p, row, ties);
    }
    return true;
}

static bool read_remarks(struct cfg_reader *r, struct paper *p)
{
    config_setting_t *list;
    unsigned count;
    if (!optional_list(r, "remarks", &list, &count))
        return false;
    for (unsigned i = 0; i < count; i++) {
        config_setting_t *s = config_setting_get_elem(list, i);
        const char *name = config_setting_get_string_elem(s, 0), *text = config_setting_get_string_elem(s, 1);
        struct paper_row *row = row_of(r, p, s, "remarks", name);
        if (!row || (!text && !cfg_fail(r, s, "remarks", "must hold lists of two texts: ( row, remark )")))
            return false;
        free(row->remark);
        row->remark = xstrdup(text);
    }
    return true;
}

static bool read_messages(struct cfg_reader *r, struct paper *p)
{
    config_setting_t *list;
    unsigned count;
    if (!optional_list(r, "messages", &list, &count))
        return false;
    p->messages = xcalloc(count + 1, sizeof *p->messages);
    for (unsigned i = 0; i < count; i++) {
        config_setting_t *s = config_setting_get_elem(list, i);
        const char *name = config_setting_get_string_elem(s, 2);
        if (!config_setting_is_list(s) || !name)
            return cfg_fail(r, s, "messages", "must hold lists: ( first type, last type, name )");
        p->messages[p->message_count++] = (struct paper_message){
            config_setting_get_int_elem(s, 0), config_setting_get_int_elem(s, 1), xstrdup(name)};
    }
    return true;
}

bool paper_read_notes(struct cfg_reader *r, struct paper *p)
{
    return read_marks(r, p, "fitted_rows", false) && read_marks(r, p, "tie_rows", true) &&
           read_remarks(r, p) && read_messages(r, p);
}

const char *paper_message_name(const struct paper *p, long type)
{
    for (size_t i = 0; i < p->message_count; i++)
        if (type >= p->messages[i].first && type <= p->messages[i].last)
            return p->messages[i].name;
    return NULL;
}
