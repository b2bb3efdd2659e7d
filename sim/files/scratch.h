/* scratch.h - folders for the temporary files of a run. Each process keeps its folder locked (flock). A
 * killed process leaves its folder behind, unlocked; the next process that makes a folder of that name
 * removes it. */
#ifndef FILES_SCRATCH_H
#define FILES_SCRATCH_H

struct scratch {
    char *path;
    int lock;
};

/* Makes a folder NAME-XXXXXX in TMPDIR or /tmp, and removes folders of that name whose processes are gone.
 * path is NULL, and errno set, if the folder cannot be made. */
struct scratch scratch_new(const char *name);
/* Removes the folder and everything in it. path may be NULL. */
void scratch_remove(struct scratch *s);
#endif
