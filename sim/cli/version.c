/* version.c - see version.h. */
#include "cli/version.h"
#include <limits.h>
#include <string.h>
#include <unistd.h>
#include "config/config.h"

const char CLI_VERSION[] = TOUCHSTONE_VERSION; /* from the Makefile */

enum { COMMIT_SIZE = 64 };

/* The first word of a file; "" if there is none. */
static void read_word(const char *path, char word[COMMIT_SIZE])
{
    FILE *f = fopen(path, "re");
    *word = '\0';
    if (f && !fgets(word, COMMIT_SIZE, f))
        *word = '\0';
    word[strcspn(word, " \n")] = '\0';
    if (f)
        fclose(f);
}

static void find_commit(char commit[COMMIT_SIZE])
{
    /* from the binary's folder: in a build; installed; installed, the reference engine */
    static const char *const PLACES[] = {"node/commit", "../lib/touchstone/commit", "commit"};
    char path[PATH_MAX];
    ssize_t length = readlink("/proc/self/exe", path, sizeof path - 32);
    path[length < 0 ? 0 : length] = '\0';
    char *slash = strrchr(path, '/');
    *commit = '\0';
    for (size_t i = 0; slash && !*commit && i < sizeof PLACES / sizeof *PLACES; i++) {
        strcpy(slash + 1, PLACES[i]);
        read_word(path, commit);
    }
}

void cli_version_print(FILE *f)
{
    char commit[COMMIT_SIZE];
    find_commit(commit);
    fprintf(f, "touchstone %s\n", CLI_VERSION);
    fprintf(f, "commit %s\n", *commit ? commit : "unknown");
    fprintf(f, "machine files of format %d\n", CFG_FORMAT);
    fprintf(f, "built with GCC %s\n", __VERSION__);
}
