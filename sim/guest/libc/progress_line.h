/* progress_line.h - the last line of a terminal, which shows how far a run has come. It is taken away before
 * a program writes anything, and never shown behind an unfinished line of output. */
#ifndef GUEST_LIBC_PROGRESS_LINE_H
#define GUEST_LIBC_PROGRESS_LINE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* f: the terminal. All else is 0 at first. */
struct progress_line {
    FILE *f;
    int shown;       /* letters on the terminal */
    bool unfinished; /* a program has written part of a line */
};

/* Shows text, of less than 80 letters, in place of what is shown. */
void progress_line_show(struct progress_line *p, const char *text);
/* Takes away what is shown. */
void progress_line_clear(struct progress_line *p);
/* A program is going to write these bytes, at least one. */
void progress_line_make_way(struct progress_line *p, const char *bytes, size_t count);
#endif
