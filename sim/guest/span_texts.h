/* span_texts.h - the texts of a machine that has more nodes than the host allows mappings: a file in memory
 * with the shape of a region's spans (span.h), in which each span has a program's text and is zero otherwise.
 * Regions of that shape map the file in one piece. So the nodes in the same place of all regions share the
 * pages of their text; any other page is the node's own from the time it is written to. */
#ifndef GUEST_SPAN_TEXTS_H
#define GUEST_SPAN_TEXTS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "node/node.h"

struct span_texts;

/* For regions of so many spans of 2^shift bytes. NULL: the host has no such files. */
struct span_texts *span_texts_new(uint32_t spans, uint32_t shift);
void span_texts_free(struct span_texts *t);
bool span_texts_fit(const struct span_texts *t, uint32_t spans, uint32_t shift);
/* Maps bytes of the file, from an offset on, over what lies there. */
bool span_texts_map(const struct span_texts *t, char *there, size_t offset, size_t bytes);
/* A program begins at an offset of the file. Is its text in that span? If the span has no text, it is to have
 * that one, which the caller writes. */
enum node_text span_texts_claim(struct span_texts *t, const struct node_image *img, size_t offset);
/* False: the host has no room. */
bool span_texts_write(const struct span_texts *t, size_t offset, const void *text, size_t bytes);
#endif
