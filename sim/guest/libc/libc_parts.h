/* libc_parts.h - struct node_libc, for the files that serve the C library's calls: libc*.c and stdio.c. */
#ifndef GUEST_LIBC_PARTS_H
#define GUEST_LIBC_PARTS_H
#include <stddef.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <wchar.h>
#include "kernel/vtime.h"
#include "guest/libc/folder.h"
#include "guest/libc/libc.h"
#include "guest/libc/descriptors.h"
#include "guest/libc/own_memory.h"
#include "guest/libc/streams.h"

/* The states of its generators. */
struct random_numbers {
    struct random_data random; /* as glibc's: additive feedback over 31 words */
    char first_state[128];
    struct drand48_data drand48;
};

enum { PROGRAM_NAMES = 4 };

/* A timer of setitimer(): first, and then every so many microseconds from a time of its clock on; 0: not. */
struct node_timer {
    vtime from;
    uint64_t first, every;
};

struct node_libc {
    struct streams streams;
    struct descriptors descriptors;
    struct random_numbers *random; /* NULL: not used yet */
    char *strtok_next;
    uint64_t entropy;
    mbstate_t multibyte;       /* of calls that pass no state */
    char *folder;              /* where relative paths start; NULL: where the simulator was started */
    char *whole[FOLDER_SLOTS]; /* folder.h */
    struct own_memory own;
    /* The program's variable; NULL: it has not asked for the environment. What is in it lies in memory of the
     * program's own. */
    char ***environ_at;
    char **environment; /* the latest list that the system has made for it */
    size_t environment_room;
    struct set_text *set; /* texts that setenv has made */
    size_t set_count;
    char **program_names[PROGRAM_NAMES]; /* the variables, NULL: it has not asked for it */
    char *unknown_error;                 /* texts and tables that the program has been given */
    unsigned short *seed48_before;       /* NULL: not yet */
    struct __locale_struct *locale;
    struct ctype_tables *ctype;
    rlim_t *soft_limits;         /* NULL: as they are at first */
    struct node_timer timers[3]; /* by ITIMER_REAL, which is the alarm, and so on */
    unsigned temporary_names;
    void (**atexit)(void);
    size_t atexit_count;
    void (*at_abort)(void); /* NULL: the program has no handler of SIGABRT */
};

/* The node's part, which is made when it is first used: many programs call nothing that needs one. */
struct node_libc *libc_of(struct node *n);

/* The program's variable `environ`, whose list is the node's own copy of what the user has given. */
char ***node_libc_environ(struct node *n);

void node_libc_free_environment(struct node_libc *c);

/* As strerror, with NX's errors, too. */
char *node_strerror(int code);
#endif
