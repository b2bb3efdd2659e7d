/* trial.h - one run of a program, and its results. */
#ifndef PROVE_TRIAL_H
#define PROVE_TRIAL_H
#include "program.h"

/* The folders of a prover. */
struct place {
    const char *build;  /* the folder of the build under test */
    const char *folder; /* the prover's own */
};

enum result { HISTORY, OUTPUT, ERRORS, FIGURES, PROFILE, TRACE, SCHEDULE, RESULTS };
extern const char *const RESULT_NAMES[RESULTS];

/* All results that must be equal in every run: without the lines about host time. */
struct trial {
    char *text[RESULTS];
    bool traced, recorded;
    int status; /* as of wait(2); -1: it took too long */
};

/* way: arguments for touchstone run, such as "-w 2". A traced program writes a trace, and a recorded one its
 * schedule, except with TRIAL_UNTRACED, so that a run without them is compared with those that write them. */
#define TRIAL_UNTRACED "-w 1"
#define TRIAL_REFERENCE "--engine reference"
/* Of a recorded program: without its --timing, but with the schedule that its last run on the reference
 * engine has written. */
#define TRIAL_REPLAYED "-w 2 --replay replayed"
/* What the variable PROVE_WORDS holds when a program begins. */
#define TRIAL_WORDS "left and right"
struct trial trial_run(const struct place *place, const struct program *p, const char *way);
void trial_free(struct trial *t);
/* The first result that differs, or RESULTS if only the status does; -1: none. */
int trial_differs(const struct trial *a, const struct trial *b);
/* Shows where two texts begin to differ. */
void trial_print_difference(const char *name, const char *a, const char *b, FILE *f);
/* The command, as a user would type it. */
void trial_print_command(const struct program *p, const char *way, FILE *f);
#endif
