/* race_texts.h - what places of a program are in its source. Finding a line takes milliseconds of host
 * time, so each is found once. */
#ifndef OBSERVE_RACE_TEXTS_H
#define OBSERVE_RACE_TEXTS_H
#include "races/node_races.h"
#include "observe/race_report.h"

struct race_texts;
struct race_texts *race_texts_new(void);
void race_texts_free(struct race_texts *t);
/* A copy of a text, which lasts as long as t. Equal texts are the same. */
const char *race_text(struct race_texts *t, const char *text);
/* The source of a return address, an offset in a program. False: it is in NX's library, and none of the
 * program's. */
bool race_text_of_call(struct race_texts *t, const struct node_image *file, uint32_t returns,
                       struct race_frame *frame);
/* The frames of a place, the innermost first; returns how many, at least one. *variable: "" if it is not
 * known. */
size_t race_text_of_place(struct race_texts *t, const struct node_races *r, uint32_t place,
                          struct race_frame frames[RACE_MOST_FRAMES], const char **variable);
/* The name of what a call on a line is given a pointer to; "": that is not known, or there are several. */
const char *race_text_given(struct race_texts *t, const struct node_races *r, const struct race_frame *call);
/* The name of the variable of static memory at an offset; "": there is none. */
const char *race_text_of_data(struct race_texts *t, const struct node_image *file, uintptr_t offset);
#endif
