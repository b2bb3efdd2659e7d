/* subject.h - what is explored: a program with its arguments on a machine; and its runs as commands.
 *
 * Runs are touchstone run, each a process of its own with a folder of its own, in which the files of the
 * current folder are links; but for the file that runs are compared by. So runs at a time do not write into
 * each other's files. */
#ifndef LAB_EXPLORE_SUBJECT_H
#define LAB_EXPLORE_SUBJECT_H
#include <jansson.h>
#include "files/program_file.h"
#include "lab/jobs/digest.h"

/* The texts are the caller's, and last as long. */
struct subject_options {
    const char *runner;     /* the touchstone that runs */
    const char *machines;   /* the folder of machine files */
    const char *machine;    /* as in run -m */
    const char *host;       /* the host's program; NULL: none */
    const char *const *set; /* settings KEY=VALUE, ended by NULL; or NULL */
    const char *const
        *host_files;      /* of --host-files, ended by NULL; or NULL. Runs find them in the environment */
    char *const *program; /* with its arguments; count of them */
    int program_count;
    const struct named_program *programs; /* those among these words */
    size_t programs_count;
    unsigned nodes;             /* of the first program; 0: as many as the host program asks for */
    double max_virtual_s;       /* of a run; 0: no limit */
    unsigned max_unreceived_mb; /* as in run --max-unreceived; 0: the usual */
    const char *rules;          /* how runs are compared, as a text: other rules are other results */
    const char *compare_file;   /* a file that the program writes, by which runs are compared; NULL: none */
    const char *input;          /* standard input of each run: so many bytes */
    size_t input_bytes;
};

struct subject {
    struct subject_options options;
    char *folder;         /* the current one */
    char *program, *host; /* absolute paths; NULL: none */
    char *machine;        /* as run -m takes it from any folder */
    char *input;          /* the file of the input; NULL: it is empty */
    struct digest digest; /* of all that a run depends on, but for its timing and files that it reads */
};

/* NULL with *error malloc'd: a program, machine or setting that cannot be used. */
struct subject *subject_open(const struct subject_options *o, char **error);
void subject_close(struct subject *s);

/* Writes the input into a file in that folder, named by its digest. False with *error malloc'd. */
bool subject_keep_input(struct subject *s, const char *folder, char **error);

/* Sets the limit of runs that have none: it follows from other results, and so is no part of the digest. */
void subject_limit(struct subject *s, double max_virtual_s);

/* How a run is timed: one of both is not NULL. */
struct run_timing {
    const char *timing;   /* run --timing */
    const char *schedule; /* the text of a schedule (run --replay) */
};

/* The digest of a run: equal for equal results. NULL, NULL: of the usual timing. */
struct digest subject_run_key(const struct subject *s, const struct run_timing *t);

/* Where a run's files are; replay NULL: none. cfs is the folder of /cfs. */
struct run_files {
    const char *json, *record, *replay, *cfs;
};
/* The command, ended by NULL, to be freed by words_free(). */
char **subject_command(const struct subject *s, const char *timing, const struct run_files *f);
/* The command that a user repeats the run by, in the current folder; malloc'd. limited: the run came to the
 * limit of virtual time, and would go on without one. */
char *subject_command_text(const struct subject *s, const char *timing, const char *replay, bool limited);
/* Did a run that took so long come to the limit? */
bool subject_is_limited(const struct subject *s, double virtual_s);
#endif
