/* run_files.h - the files of text that a run writes as it goes on: its history and its schedule. */
#ifndef CLI_RUN_FILES_H
#define CLI_RUN_FILES_H
#include "files/atomic_file.h"

struct run_files {
    struct atomic_file history, schedule; /* out NULL: not wanted */
};

/* Opens them; a path that is NULL: not wanted. Returns NULL, or an error, malloc'd: then none is open. */
char *run_files_begin(struct run_files *f, const char *history, const char *schedule);
/* The run begins: what had their names before is given up. */
void run_files_replace(struct run_files *f);
/* Closes them. Returns NULL, or an error, malloc'd. */
char *run_files_end(struct run_files *f);
/* Gives them up: what had their names before stays. */
void run_files_drop(struct run_files *f);
#endif
