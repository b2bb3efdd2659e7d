/* study_folder.h - the files of a study's folder, read without leaving the folder: no symbolic link in it is
 * followed, and only regular files are opened. */
#ifndef LAB_SERVE_STUDY_FOLDER_H
#define LAB_SERVE_STUDY_FOLDER_H
#include <jansson.h>
#include <stdbool.h>
#include <sys/stat.h>

/* A file that is looked at again and again. */
struct watched_file {
    const char *name;
    struct stat seen; /* all zeros: the file was not there */
};

/* Opens the folder of that name in a folder (AT_FDCWD: path is any). make: makes it if it is missing. -1 with
 * errno. */
int study_folder_open(int in, const char *path, bool make);
/* Opens a file of the folder for reading. -1 with errno. */
int study_folder_file(int folder, const char *name);
/* The JSON object that the file holds, owned by the caller; NULL if there is none. */
json_t *study_folder_json(int folder, const char *name);

/* Looks at the file: does it differ from what was there when the function was last called? */
bool watched_file_changed(struct watched_file *f, int folder);
#endif
