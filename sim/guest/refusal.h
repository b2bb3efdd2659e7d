/* refusal.h - the last allocation that a node was refused, for reports: few programs look at what malloc
 * answers. libc_memory.c notes it. */
#ifndef GUEST_REFUSAL_H
#define GUEST_REFUSAL_H
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

struct node;

/* Has one been refused, and hardly anything been allocated or freed since? Then what went wrong is its
 * doing. */
bool refusal_was_last(const struct node *n);
/* Prints a newline and "  its memory was exhausted: malloc of 80,000,000 bytes was refused in FUNCTION
 * (FILE:LINE): ...", if one was; otherwise nothing. */
void refusal_print(FILE *f, const struct node *n);
#endif
