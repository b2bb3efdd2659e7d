/* call_tree_write.c - a call tree as JSON: see call_tree.h. Most of it are texts, since a number an element
 * would make the file ten times as large. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "observe/call_tree.h"
#include "observe/json_file.h"

static const char KINDS[] = {
    [SPOT_ROOT] = 'r', [SPOT_FUNCTION] = 'f', [SPOT_INLINED] = 'i', [SPOT_LIBRARY] = 'l',
    [SPOT_CALL] = 'c', [SPOT_WAITING] = 'w',  [SPOT_OTHER] = 'o'};

/* Takes the text that a stream has been writing. */
static json_t *take(FILE *f, char **text)
{
    fclose(f);
    json_t *j = json_text(*text);
    free(*text);
    return j;
}

static json_t *spot_json(const struct spot *s)
{
    char *text;
    size_t length;
    FILE *f = xchecked(open_memstream(&text, &length));
    fprintf(f, "%" PRIu32 " %c %" PRId32 " %s\t%s", s->parent, KINDS[s->kind], s->line, s->name, s->file);
    return take(f, &text);
}

static bool is_empty(const struct share *s, uint32_t nodes)
{
    for (uint32_t k = 0; k < nodes; k++)
        if (s->time[k])
            return false;
    return true;
}

static json_t *share_json(const struct share *s, uint32_t nodes)
{
    char *text;
    size_t length;
    FILE *f = xchecked(open_memstream(&text, &length));
    fprintf(f, "%" PRIu32 " %" PRId32 " %s\t", s->spot, s->line, s->file);
    for (uint32_t k = 0, last; k < nodes; k = last + 1) {
        for (last = k; last + 1 < nodes && s->time[last + 1] == s->time[k];)
            last++;
        if (!s->time[k])
            continue;
        fprintf(f, last > k ? "%" PRIu32 "-%" PRIu32 : "%" PRIu32, k, last);
        fprintf(f, ":%" PRIu64 " ", s->time[k]);
    }
    return take(f, &text);
}

json_t *call_tree_json(const struct call_tree *t)
{
    json_t *spots = json_array(), *shares = json_array();
    for (uint32_t i = 0; i < t->spot_count; i++)
        json_append(spots, spot_json(&t->spots[i]));
    for (uint32_t i = 0; i < t->share_count; i++)
        if (!is_empty(&t->shares[i], t->nodes))
            json_append(shares, share_json(&t->shares[i], t->nodes));
    return json_pack("{s:o, s:o}", "spots", spots, "shares", shares);
}
