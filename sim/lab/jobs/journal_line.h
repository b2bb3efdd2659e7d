/* journal_line.h - a result as one line with a checksum: in journals and in files of the result cache.
 *
 *     CHECKSUM KEY STATE {"point": {...}, ...}
 *
 * The checksum is the CRC-32 of the rest of the line, in hexadecimal. KEY is the digest of the point's
 * inputs.
 */
#ifndef LAB_JOBS_JOURNAL_LINE_H
#define LAB_JOBS_JOURNAL_LINE_H
#include "lab/jobs/digest.h"

#include <jansson.h>

enum journal_line_state { LINE_HEAD = 'h', LINE_DONE = 'd', LINE_FAILED = 'f' };

/* The line with its newline, malloc'd; *size is its length. */
char *journal_line_write(struct digest key, enum journal_line_state state, const json_t *record,
                         size_t *size);
/* Is the line, given without its newline, complete and undamaged? Then sets *key and *state. */
bool journal_line_check(const char *line, size_t size, struct digest *key, enum journal_line_state *state);
/* The record of an undamaged line, owned by the caller; NULL if the line holds no JSON object. */
json_t *journal_line_record(const char *line, size_t size);
#endif
