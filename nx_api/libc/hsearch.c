/* hsearch.c - a table of texts and what belongs to them, as System V has it: open addressing. */
#define _GNU_SOURCE
#include <errno.h>
#include <search.h>
#include <stdlib.h>
#include <string.h>

/* A place of the table, by the name that the header has for it. */
struct _ENTRY {
    ENTRY entry; /* key NULL: free */
};

static struct hsearch_data the_table;

static size_t hash_of(const char *key)
{
    size_t hash = 5381;
    for (; *key; key++)
        hash = hash * 33 + (unsigned char)*key;
    return hash;
}

/* Twice the room: about one place in two stays free. */
int hcreate_r(size_t count, struct hsearch_data *t)
{
    unsigned size = 8;
    if (t->table || count > 1u << 28) {
        errno = t->table ? EINVAL : ENOMEM;
        return 0;
    }
    while (size < 2 * count)
        size *= 2;
    t->table = calloc(size, sizeof *t->table);
    t->size = size;
    t->filled = 0;
    return t->table != NULL;
}

/* The table holds size / 2 keys at least, and never is full. */
int hsearch_r(ENTRY wanted, ACTION action, ENTRY **answer, struct hsearch_data *t)
{
    size_t at = hash_of(wanted.key) & (t->size - 1);
    for (; t->table[at].entry.key; at = (at + 1) & (t->size - 1))
        if (!strcmp(t->table[at].entry.key, wanted.key)) {
            *answer = &t->table[at].entry;
            return 1;
        }
    *answer = NULL;
    if (action == FIND || t->filled + 1 >= t->size) {
        errno = action == FIND ? ESRCH : ENOMEM;
        return 0;
    }
    t->filled++;
    t->table[at].entry = wanted;
    *answer = &t->table[at].entry;
    return 1;
}

void hdestroy_r(struct hsearch_data *t)
{
    free(t->table);
    t->table = NULL;
}

int hcreate(size_t count)
{
    return hcreate_r(count, &the_table);
}

ENTRY *hsearch(ENTRY wanted, ACTION action)
{
    ENTRY *answer;
    return hsearch_r(wanted, action, &answer, &the_table) ? answer : NULL;
}

void hdestroy(void)
{
    hdestroy_r(&the_table);
}
