/* study_session.h - what the commands that run studies share: their options, and where their runs and
 * results are. */
#ifndef CLI_STUDY_SESSION_H
#define CLI_STUDY_SESSION_H
#include "cli/installation.h"
#include "cli/options.h"
#include "lab/study/study.h"

/* What the options say. */
struct cli_session_options {
    const char *cache; /* NULL: the default one */
    unsigned jobs;     /* 0: not said */
    bool no_cache;
};
extern const struct argp
    CLI_SESSION; /* -j, --cache, --no-cache, --host-files; input: struct cli_session_options * */

/* A command's study file, its folder for results and its session. */
struct cli_study_arguments {
    const char *file, *dir; /* dir NULL: not said */
    struct cli_session_options session;
};
/* For a command's parser: keeps the study file and -o DIR; other keys are cli_store's. */
error_t cli_study_argument(int key, char *arg, struct argp_state *state, struct cli_study_arguments *a);

struct cli_session {
    struct cli_installation places;
    char *cache;
};

/* Sets all of *study but its file and folder; *study points into *s. Returns false, with a message of the
 * command on standard error, if touchstone's own files are not found. */
bool cli_session_begin(struct cli_session *s, const char *command, const struct cli_session_options *options,
                       struct study_options *study);
/* Sends the study's progress nowhere, but not its errors. */
void cli_session_silence(struct study_options *study);
void cli_session_end(struct cli_session *s, const struct study_options *study);

/* The default folder for the results of .../NAME.cfg: out/NAME and the suffix. */
void cli_default_folder(const char *file, const char *suffix, char dir[PATH_MAX]);
#endif
