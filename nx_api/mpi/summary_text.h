/* summary_text.h - the summary of a run, for people and for programs. */
#ifndef MPI_SUMMARY_TEXT_H
#define MPI_SUMMARY_TEXT_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { SUMMARY_MOST_CALLS = 40 };

/* The waits in a call. */
struct summary_wait {
    char call[24];
    uint64_t times;
    double seconds;
};

/* What a node did, as it is sent. */
struct summary_part {
    uint64_t sent, bytes, handlers;
    double ended_s, handlers_s;
    int64_t exit_code;
    bool failed;
    char host[64];
    size_t wait_count;
    struct summary_wait waits[SUMMARY_MOST_CALLS];
};

void summary_write_text(const struct summary_part *parts, uint32_t count);
/* With the names of touchstone run --json, where there are any. */
void summary_write_json(const struct summary_part *parts, uint32_t count, bool deadlock, const char *path);
#endif
