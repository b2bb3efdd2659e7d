/* text.h - the end when something is wrong, and strings made like printf's. */
#ifndef DRIVER_TEXT_H
#define DRIVER_TEXT_H
#include <stdbool.h>

/* Says what is wrong, after the name nxcc was called by, and exits with status 1. */
__attribute__((format(printf, 1, 2), noreturn)) void fail(const char *format, ...);
/* Says why a program could not be run, when execvp has returned with errno, and what to do; exits with
 * status 1. */
_Noreturn void fail_to_run(const char *program);
/* For free(). */
__attribute__((format(printf, 1, 2))) char *text(const char *format, ...);
/* Appends a word to a list for people: "PMPI_Isend, PMPI_Test". *list is NULL at first; for free(). */
void text_list(char **list, const char *word);
/* Is a word in a list, which NULL ends? */
bool is_one_of(const char *word, const char *const *list);

#endif
