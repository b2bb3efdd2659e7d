/* words.h - lists of words, such as arguments and settings; and texts that grow or have holes to be
 * filled. */
#ifndef FILES_WORDS_H
#define FILES_WORDS_H

/* A list of malloc'd words ends with NULL; an empty list is NULL. Adding takes over the malloc'd text: as one
 * word, or split at its blanks. */
void words_add(char ***list, char *word);
void words_add_all(char ***list, char *text);
/* An option, which is copied, and its value, which is taken over. */
void words_add_option(char ***list, const char *option, char *value);
/* Copies of all words of a list, each behind the option, if one is given. */
void words_add_each(char ***list, const char *option, const char *const *words);
void words_free(char **list);

/* Adds formatted text to the end of *text, which is malloc'd and may move. */
void words_append(char **text, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* text with `with` in place of each `hole`; malloc'd. */
char *words_filled(const char *text, const char *hole, const char *with);
/* The word as a shell takes it, in quotes where that needs them; malloc'd. */
char *words_quoted(const char *word);
#endif
