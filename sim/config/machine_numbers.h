/* machine_numbers.h - the numbers of a machine file for people: each with its standing (read, known, derived,
 * fitted, open) and source, which the file has as a comment behind the number, and below. */
#ifndef CONFIG_MACHINE_NUMBERS_H
#define CONFIG_MACHINE_NUMBERS_H
#include <stddef.h>
#include "config/config.h"

struct cfg_number {
    char *key;      /* "system.call_us"; of the processor's costs, "cpu.clocks.load" */
    char *value;    /* as the file gives it, without the zeros at its end: "5", "hypercube" */
    bool is_number; /* not a text */
    char *
        standing; /* one of the words above; "set" if a setting gave it; "" if the comment begins with none */
    char *source; /* the rest of the comment; "" if there is none */
};

struct cfg_numbers {
    struct cfg_number *list; /* in the file's order, the processor's costs last */
    size_t count;
};

/* Reads those of a machine with its settings, the files that it includes and its processor's among them. NULL
 * with *error malloc'd. */
struct cfg_numbers *cfg_numbers_read(const struct cfg_machine *m, char **error);
/* The number of that key; NULL: there is none. */
const struct cfg_number *cfg_numbers_find(const struct cfg_numbers *n, const char *key);
void cfg_numbers_free(struct cfg_numbers *n);
#endif
