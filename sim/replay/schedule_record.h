/* schedule_record.h - writes the schedule of a run while it goes on (touchstone run --record), each line when
 * what it tells is committed: doc/schedule-format.md. */
#ifndef REPLAY_SCHEDULE_RECORD_H
#define REPLAY_SCHEDULE_RECORD_H
#include "replay/numbering.h"

/* The head of the file. usual: `drawn` is NULL; else the text of --timing that the delays are drawn by.
 * program: its file, and its number of elf_loaded_sum(). */
void schedule_record_begin(const struct node_system *s, const char *drawn, const char *file,
                           uint32_t program);
/* The run is over: messages that nobody has received. */
void schedule_record_end(const struct node_system *s);

/* A message, or one to all nodes, has been sent. */
void schedule_record_send(const struct node *n, const struct message *first, vtime late);
/* A receive has its message: at a time, or (VT_NEVER) its program never asked for it. */
void schedule_record_match(const struct node *n, const struct numbered_receive *r, vtime at);
void schedule_record_interrupt(const struct node *n, uint64_t k, vtime due, vtime late);
void schedule_record_handler(struct node *n, uint64_t k, vtime due, const struct numbered_receive *r,
                             const char *line);
#endif
