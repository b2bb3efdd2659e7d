/* source.h - a Fortran file as lines, in which statements can be rewritten. */
#ifndef DRIVER_SOURCE_H
#define DRIVER_SOURCE_H
#include <stdbool.h>
#include <stddef.h>

struct line {
    char *text;    /* without the newline; fixed form: tabs in the first six columns are blanks */
    size_t origin; /* number of the line in the file as it was read, from 1 */
    bool changed;  /* since source_settle */
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

/* The compiler says that logicals are compared in line `line` (from 1) behind column `column`. Rewrites that
 * comparison. False: it is not found, or the statement has been changed since source_settle. */
bool source_compare_logicals(struct source *s, size_t line, size_t column);

#endif
