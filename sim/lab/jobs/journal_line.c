/* journal_line.c - see journal_line.h. */
#include "lab/jobs/journal_line.h"
#include "kernel/xalloc.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

enum { SUM = 8, KEY_AT = SUM + 1, STATE_AT = KEY_AT + DIGEST_DIGITS + 1, RECORD_AT = STATE_AT + 2 };

static void write_sum(const char *rest, size_t size, char sum[SUM + 1])
{
    snprintf(sum, SUM + 1, "%08lx", crc32_z(0, (const unsigned char *)rest, size));
}

char *journal_line_write(struct digest key, enum journal_line_state state, const json_t *record, size_t *size)
{
    char sum[SUM + 1], *json = xchecked(json_dumps(record, JSON_COMPACT));
    char *line = xasprintf("%*s %s %c %s\n", SUM, "", digest_text(key).text, (char)state, json);
    *size = strlen(line);
    write_sum(line + KEY_AT, *size - KEY_AT - 1, sum);
    memcpy(line, sum, SUM);
    free(json);
    return line;
}

bool journal_line_check(const char *line, size_t size, struct digest *key, enum journal_line_state *state)
{
    char sum[SUM + 1];
    if (size <= RECORD_AT)
        return false;
    write_sum(line + KEY_AT, size - KEY_AT, sum);
    *state = (enum journal_line_state)line[STATE_AT];
    return memcmp(line, sum, SUM) == 0 && line[SUM] == ' ' && digest_read(line + KEY_AT, key);
}

json_t *journal_line_record(const char *line, size_t size)
{
    json_t *record = size > RECORD_AT ? json_loadb(line + RECORD_AT, size - RECORD_AT, 0, NULL) : NULL;
    if (json_is_object(record))
        return record;
    json_decref(record);
    return NULL;
}
