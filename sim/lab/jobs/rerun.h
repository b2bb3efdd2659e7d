/* rerun.h - runs a command again, with other numbers of the machine: what if some of its work took another
 * time? Unlike an estimate, that is exact: all that follows from the change is in it.
 *
 * Every re-run is a child process touchstone run. Each has a copy of the folder for /cfs, if the command
 * names one. */
#ifndef LAB_JOBS_RERUN_H
#define LAB_JOBS_RERUN_H
#include <stdbool.h>
#include <stdio.h>
#include <time.h>
#include "kernel/vtime.h"

/* The command, in parts: what goes before the settings, and from the program on. Both are ended by NULL. */
struct rerun_command {
    char *const *options, *const *program;
    const char *cfs;    /* the folder for /cfs, as the option --cfs; NULL: none */
    const char *folder; /* that it works in */
    const char *in;     /* the file that is its standard input; NULL: it is empty */
};

/* One re-run: what it changes, and what came of it. */
struct rerun {
    char *what; /* a clause: "if entering and leaving handlers took no time" */
    char *key;  /* for JSON: "interrupts" */
    char **set; /* settings KEY=VALUE of the machine: words.h */
    bool done;
    vtime end;   /* if done */
    char *error; /* if not: in one line */
};

struct reruns {
    struct rerun *list;
    size_t count;
    int stopped; /* the signal that ended them before their end; 0: none */
};

struct rerun_place {
    struct rerun_command command;
    const char *scratch; /* a folder for temporary files */
    unsigned at_once;    /* so many children at a time */
    FILE *progress;      /* NULL: none is shown */
    /* Not NULL: each re-run works in a folder of its own, with links to the files of the command's folder,
     * but for those that have changed since: the command has written them. */
    const struct timespec *apart;
};

/* Adds one, without settings, and takes over `what`. It stays there until the next is added. */
struct rerun *reruns_add(struct reruns *r, const char *key, char *what);
/* Makes the copies of the folder for /cfs. False with *error malloc'd. */
bool rerun_copy_cfs(const struct rerun_place *p, const struct reruns *r, char **error);
/* Runs count of them, from the first on. False with *error malloc'd: stopped by a signal, or a folder cannot
 * be made. */
bool rerun_some(const struct rerun_place *p, struct reruns *r, size_t first, size_t count, char **error);
/* The time of a run of which the figures are in that file (run --json). False if there is none. */
bool rerun_time(const char *json, vtime *end, char **error);
void reruns_free(struct reruns *r);
#endif
