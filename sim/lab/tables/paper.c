/* paper.c - see paper.h. */
#include "lab/tables/paper.h"
#include "lab/study/spec.h"

#include <stdlib.h>

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
    return end != second && !*end && n >= 1 && n <= SPEC_MAX_NODES;
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

const char *paper_message_name(const struct paper *p, long type)
{
    for (size_t i = 0; i < p->message_count; i++)
        if (type >= p->messages[i].first && type <= p->messages[i].last)
            return p->messages[i].name;
    return NULL;
}

void paper_free(struct paper *p)
{
    if (!p)
        return;
    for (size_t t = 0; t < p->count; t++) {
        for (size_t i = 0; i < p->tables[t].count; i++)
            free(p->tables[t].rows[i].arguments), free(p->tables[t].rows[i].remark);
        free(p->tables[t].rows);
        free(p->tables[t].title);
    }
    for (size_t i = 0; i < p->message_count; i++)
        free(p->messages[i].name);
    free(p->messages);
    free(p->tables);
    free(p->machine);
    free(p->program);
    free(p);
}
