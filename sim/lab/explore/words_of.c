/* words_of.c - see words_of.h. */
#include "files/virtual_time.h"
#include "lab/explore/words_of.h"
#include <inttypes.h>
#include <stdio.h>

const char *rec_node_name(uint32_t node, uint32_t nodes, char buf[REC_NAME])
{
    if (node == nodes)
        snprintf(buf, REC_NAME, "the host");
    else
        snprintf(buf, REC_NAME, "node %" PRIu32, node);
    return buf;
}

const char *rec_duration(int64_t ps, char buf[REC_TIME])
{
    snprintf(buf, REC_TIME, "%s", duration_text((double)ps / (double)VT_SECOND).text);
    return buf;
}

const char *rec_time(vtime t, char buf[REC_TIME])
{
    if (t == VT_NEVER)
        snprintf(buf, REC_TIME, "an unknown time");
    else
        snprintf(buf, REC_TIME, "%s", virtual_time_moment(t).text);
    return buf;
}

const char *rec_ordinal(uint64_t from_0, char buf[REC_ORDINAL])
{
    uint64_t n = from_0 + 1;
    const char *end = n % 100 / 10 == 1 ? "th"
                      : n % 10 == 1     ? "st"
                      : n % 10 == 2     ? "nd"
                      : n % 10 == 3     ? "rd"
                                        : "th";
    snprintf(buf, REC_ORDINAL, "%" PRIu64 "%s", n, end);
    return buf;
}
