/* scratch.h - folders for the temporary files of a run. Each process keeps its folder locked (flock). A
 * killed process leaves its folder behind, unlocked; the next process of that user that makes such a folder,
 * whatever for, removes it. */
#ifndef FILES_SCRATCH_H
#define FILES_SCRATCH_H

struct scratch {
    char *path;
    int lock;
};

/* Makes a folder NAME-XXXXXX in TMPDIR or /tmp, and removes the folders whose processes are gone. name is one
 * of scratch.c's list. path is NULL, and errno set, if the folder cannot be made. */
struct scratch scratch_new(const char *name);
/* Removes the folder and everything in it. path may be NULL. */
void scratch_remove(struct scratch *s);
#endif
