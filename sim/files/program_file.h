/* program_file.h - the search for a program that somebody names: in a folder, or among
 * those that come with touchstone. */
#ifndef FILES_PROGRAM_FILE_H
#define FILES_PROGRAM_FILE_H

/* The path of the program `name`, malloc'd. A relative name is looked for in the folder `here` (NULL: the
 * current one), then in the folder `brought` of the programs that come with touchstone. If it is in none,
 * NULL, and *error, malloc'd, lists where it was looked for. */
char *program_file_find(const char *name, const char *here, const char *brought, char **error);
#endif
