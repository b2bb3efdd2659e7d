/* own_folder.h - a folder for one run: what is in another folder is there as links. */
#ifndef LAB_EXPLORE_OWN_FOLDER_H
#define LAB_EXPLORE_OWN_FOLDER_H
#include <stdbool.h>

/* Makes the folder `path` with links to all that is in `like`, but for the name `except` (NULL: none). False
 * with errno. */
bool own_folder_make(const char *path, const char *like, const char *except);
/* Removes the folder with all that the run has left in it. */
void own_folder_remove(const char *path);
#endif
