/* journal_points.c - see journal_points.h. */
#include "lab/serve/journal_points.h"
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "lab/jobs/journal_line.h"
#include "files/words.h"
#include "lab/page/page_item.h"
#include "lab/study/point_run.h"

enum { PART = 1 << 20 };

void journal_points_init(struct journal_points *j)
{
    *j = (struct journal_points){.points = json_object()};
}

void journal_points_free(struct journal_points *j)
{
    json_decref(j->points);
}

char *journal_points_settings(const json_t *set)
{
    char *all = xstrdup("");
    size_t i;
    json_t *one;
    json_array_foreach(set, i, one) words_append(&all, "%s%s", i ? " " : "", json_string_value(one));
    return all;
}

static json_t *set_of(const json_t *record)
{
    char *all = journal_points_settings(json_object_get(record, "set"));
    json_t *text = json_string(all);
    free(all);
    return text;
}

static json_t *flat_of(const json_t *record)
{
    json_t *flat = point_flat(json_deep_copy(json_object_get(record, "point")), record);
    if (json_object_get(record, "set"))
        json_set(flat, "set", set_of(record));
    return page_json_within_53_bits(flat);
}

static void take_line(struct journal_points *j, const char *line, size_t size, uint64_t from)
{
    struct digest key;
    enum journal_line_state state;
    if (!journal_line_check(line, size, &key, &state) || state == LINE_HEAD)
        return;
    j->since += j->read_to >= from;
    json_t *record = journal_line_record(line, size), *point = json_object_get(record, "point");
    if (json_is_object(point)) {
        json_t *known = json_pack("[O, o]", point, set_of(record));
        char *name = xchecked(json_dumps(known, JSON_COMPACT | JSON_SORT_KEYS));
        json_set(j->points, name, flat_of(record));
        free(name);
        json_decref(known);
    }
    json_decref(record);
}

void journal_points_read(struct journal_points *j, int fd, uint64_t from)
{
    struct stat st = {0};
    if (fd < 0 || fstat(fd, &st) != 0 || (uint64_t)st.st_size < j->read_to) {
        journal_points_free(j);
        journal_points_init(j);
    }
    size_t size = PART;
    char *part = fd >= 0 ? xmalloc(size) : NULL;
    for (ssize_t got; part && (got = pread(fd, part, size, (off_t)j->read_to)) > 0;) {
        const char *at = part, *newline;
        for (; (newline = memchr(at, '\n', (size_t)(part + got - at))); at = newline + 1) {
            take_line(j, at, (size_t)(newline - at), from);
            j->read_to += (uint64_t)(newline - at) + 1;
        }
        if (at == part && (size_t)got < size)
            break; /* a line that is not complete */
        if (at == part)
            part = xrealloc(part, size *= 2);
    }
    free(part);
}
