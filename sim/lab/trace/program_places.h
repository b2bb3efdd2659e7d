/* program_places.h - places in the program as text. Each different text is made once: equal texts have
 * equal addresses, and last until places_free(). */
#ifndef LAB_TRACE_PROGRAM_PLACES_H
#define LAB_TRACE_PROGRAM_PLACES_H
#include "lab/trace/trace_model.h"

struct places;

struct places *places_new(const struct trace *t);
void places_free(struct places *p);

/* "slices.c:88 (slices_prepare)", "slices_prepare"; "" if nothing is known: the innermost frame that is not
 * the library's. stack: TRACE_NONE is allowed. */
const char *places_line(struct places *p, int32_t stack);
/* "slices_prepare"; "". */
const char *places_function(struct places *p, int32_t stack);
/* The functions that a program may have worked in between two places: "force", "force or main"; with
 * "or others" where they are many. seen: a place at which it was in this time; TRACE_NONE: not known.
 * "": nothing is known. */
const char *places_worker(struct places *p, int32_t before, int32_t seen, int32_t after);
/* A call with its place: "csend at ring.c:12 (main)". */
const char *places_call(struct places *p, int32_t call);
/* Any text, made as by printf. */
const char *places_text(struct places *p, const char *format, ...) __attribute__((format(printf, 2, 3)));
#endif
