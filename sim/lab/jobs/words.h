/* words.h - lists of words, such as arguments and settings; and texts with a hole that is filled in. */
#ifndef LAB_JOBS_WORDS_H
#define LAB_JOBS_WORDS_H

/* A list of malloc'd words ends with NULL; an empty list is NULL. Adding takes over the malloc'd text: as one
 * word, or split at its blanks. */
void words_add(char ***list, char *word);
void words_add_all(char ***list, char *text);
void words_free(char **list);

/* text with `with` in place of each `hole`; malloc'd. */
char *words_filled(const char *text, const char *hole, const char *with);
#endif
