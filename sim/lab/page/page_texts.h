/* page_texts.h - the texts of a trace that its tables refer to by number: names of what was called, places
 * in the program. Each text stands once. */
#ifndef LAB_PAGE_PAGE_TEXTS_H
#define LAB_PAGE_PAGE_TEXTS_H
#include <jansson.h>
#include <stdint.h>
#include "lab/trace/trace_model.h"

struct page_texts;

/* Knows the texts of all calls and handlers of the trace. */
struct page_texts *page_texts_new(const struct trace *t);
void page_texts_free(struct page_texts *p);

/* The number of what the program called: "gsync". */
int32_t page_texts_called(const struct page_texts *p, const struct trace_call *c);
/* The number of a place, "relax, relax.c:12"; -1: not known. */
int32_t page_texts_place(const struct page_texts *p, int32_t stack);
/* The number of the functions that a node worked in while it computed, "force", "force or main", as
 * touchstone trace why names them; -1: not known. It may be a new text. */
int32_t page_texts_worked(struct page_texts *p, const struct trace_around *around);
/* All texts, in the order of their numbers. */
json_t *page_texts_json(const struct page_texts *p);
#endif
