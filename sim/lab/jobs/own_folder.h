/* own_folder.h - a folder for one run: what is in another folder is there as links. */
#ifndef LAB_JOBS_OWN_FOLDER_H
#define LAB_JOBS_OWN_FOLDER_H
#include <stdbool.h>
#include <time.h>

/* Makes the folder `path` with links to all that is in `like`, but for the file `except`, whose path begins
 * there (NULL: none), and for files that have changed after `until` (NULL: all count). If the folder is
 * there, what a run has left in it is removed, and links that are right stay: they cost most of a short run.
 * False with errno. */
bool own_folder_make(const char *path, const char *like, const char *except, const struct timespec *until);
/* A place for such folders in `scratch`; malloc'd, NULL with errno. From a folder there, names in the words
 * (NAME, or KEY=NAME) that begin with ../ lead where they lead from `like`. words is ended by NULL. */
char *own_folder_place(const char *scratch, const char *like, char *const *words);
#endif
