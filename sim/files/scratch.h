/* scratch.h - folders for what is gone at the end of a run. A process that is killed leaves its folder behind: the next that makes
 * one removes it. A folder is locked (flock) by the process it belongs to, and an unlocked one is nobody's. */
#ifndef FILES_SCRATCH_H
#define FILES_SCRATCH_H

struct scratch {
    char *path;
    int lock;
};

/* A new folder NAME-XXXXXX in TMPDIR, or in /tmp. path is NULL if it cannot be made; errno says why. Removes folders of that
 * name whose processes are gone. */
struct scratch scratch_new(const char *name);
/* Removes it with all that is in it. path may be NULL. */
void scratch_remove(struct scratch *s);
#endif
