/* source.h - a Fortran file as lines, in which statements can be rewritten. */
#ifndef DRIVER_SOURCE_H
#define DRIVER_SOURCE_H
#include <stdbool.h>
#include <stddef.h>

struct line {
    char *text;     /* without the newline; fixed form: tabs in the first six columns are blanks */
    size_t origin;  /* number of the line in the file as it was read, from 1 */
    size_t settled; /* its number, from 1, when source_settle was called; 0: it is new since then */
};

struct source {
    const char *name;
    bool fixed; /* the form; its lines end at column `width` */
    size_t width;
    struct line *lines;
    size_t count;
};

struct source source_read(const char *name, bool fixed, size_t width);
/* marked: with directives that tell the compiler the original's name and line numbers. */
void source_write(const struct source *s, const char *path, bool marked);
void source_settle(struct source *s);

/* A statement: the lines it is in, its text in one piece, without label and comments, and the same with
 * its texts in quotes made invisible. */
struct statement {
    size_t first, last; /* lines, from 0 */
    char *text, *code;
    size_t count, size;
    struct place {
        size_t line, column; /* as settled; from 0 */
    } * places;
};

/* The statement that the compiler, which read the source as it was at source_settle, names by a line.
 * False: it is not there, or new. Otherwise it is for statement_forget. */
bool source_statement(const struct source *s, size_t line, struct statement *st);
void statement_forget(struct statement *st);

/* The character of the statement's text that stands behind a line and column as the compiler counts them. */
size_t statement_behind(const struct statement *st, size_t line, size_t column);

/* Puts new in place of the statement's lines, several statements if newlines are between them. The label
 * goes to the first. */
void source_replace(struct source *s, const struct statement *st, const char *new);

#endif
