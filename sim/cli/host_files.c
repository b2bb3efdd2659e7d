/* host_files.c - see host_files.h. */
#include "cli/host_files.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "kernel/xalloc.h"

enum { HOST_FILES = CLI_KEY + 0x5000 };

static const char VARIABLE[] = "TOUCHSTONE_HOST_FILES"; /* PATH[:ro]:PATH[:ro]... */

static const char TEXT[] =
    "Let programs use this file of this computer, or all files in this folder; with :ro, only read them. "
    "May be repeated. They may always use files below the current folder, and read files that their "
    "arguments name";
static const struct argp_option OPTIONS[] = {{"host-files", HOST_FILES, "PATH[:ro]", 0, TEXT, 0}, {0}};
/* touchstone run's stands beside --cfs. */
static const struct argp_option RUN_OPTIONS[] = {{"host-files", HOST_FILES, "PATH[:ro]", 0, TEXT, 1}, {0}};

/* --- the option --- */

static error_t keep(int key, char *arg, struct argp_state *state)
{
    struct cli_host_files *f = state->input;
    if (key != HOST_FILES)
        return ARGP_ERR_UNKNOWN;
    if (!f)
        return 0;
    f->list = xreallocarray(f->list, f->count + 2, sizeof *f->list);
    f->list[f->count++] = arg;
    f->list[f->count] = NULL;
    return 0;
}

static size_t path_length(const char *value)
{
    size_t n = strlen(value);
    return n > 3 && strcmp(value + n - 3, ":ro") == 0 ? n - 3 : n;
}

/* Adds a value to the environment. Runs may have other folders, so the path becomes absolute. */
static error_t hand_on(int key, char *arg, struct argp_state *state)
{
    if (key != HOST_FILES)
        return ARGP_ERR_UNKNOWN;
    if (memchr(arg, ':', path_length(arg)))
        argp_error(state, "--host-files: '%s' has a ':', which stands between paths here", arg);
    const char *before = getenv(VARIABLE);
    char *here = *arg == '/' ? xstrdup("") : xchecked(getcwd(NULL, 0));
    char *all = xasprintf("%s%s%s%s%s", before ? before : "", before ? ":" : "", here, *here ? "/" : "", arg);
    setenv(VARIABLE, all, 1);
    free(here);
    free(all);
    return keep(key, arg, state);
}

const struct argp CLI_HOST_FILES = {RUN_OPTIONS, keep, NULL, NULL, NULL, NULL, NULL};
const struct argp CLI_RUNS_HOST_FILES = {OPTIONS, hand_on, NULL, NULL, NULL, NULL, NULL};

/* --- the fence --- */

/* Frees path. */
static bool add(struct fence *f, char *path, bool writable, char **error)
{
    bool added = fence_add(f, path, writable);
    if (!added)
        *error = xasprintf("--host-files %s: %s", path, strerror(errno));
    free(path);
    return added;
}

static bool add_value(struct fence *f, const char *value, char **error)
{
    size_t n = path_length(value);
    return add(f, xstrndup(value, n), value[n] == 0, error);
}

static bool add_environment(struct fence *f, char **error)
{
    const char *at = getenv(VARIABLE);
    while (at && *at) {
        size_t n = strcspn(at, ":");
        const char *next = at + n;
        bool only_read = strncmp(next, ":ro", 3) == 0 && (next[3] == ':' || next[3] == 0);
        if (n > 0 && !add(f, xstrndup(at, n), !only_read, error))
            return false;
        next += only_read ? 3 : 0;
        at = *next ? next + 1 : next;
    }
    return true;
}

/* A word may be a path, or end with one: file=PATH. */
static void add_word(struct fence *f, const char *word)
{
    const char *value = strchr(word, '=');
    if (access(word, F_OK) == 0)
        fence_add(f, word, false);
    else if (value && value[1] && access(value + 1, F_OK) == 0)
        fence_add(f, value + 1, false);
}

struct fence *cli_fence(const struct cli_host_files *files, char *const *words, int count, char **error)
{
    struct fence *f = fence_new();
    bool good = add_environment(f, error);
    for (size_t i = 0; good && i < files->count; i++)
        good = add_value(f, files->list[i], error);
    for (int i = 0; i < count; i++)
        add_word(f, words[i]);
    if (good)
        return f;
    fence_free(f);
    return NULL;
}
