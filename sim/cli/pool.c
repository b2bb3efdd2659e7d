/* pool.c - what the subcommands that run many programs share: how many at a time, and where programs are. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/cli.h"

unsigned cli_processors(void)
{
    long cpus = sysconf(_SC_NPROCESSORS_ONLN);
    return cpus > 0 ? (unsigned)cpus : 1;
}

bool cli_jobs(const char *text, unsigned *jobs)
{
    char *end;
    long number = strtol(text, &end, 10);
    *jobs = (unsigned)number;
    return end != text && !*end && number >= 1 && number <= CLI_MAX_JOBS;
}

bool cli_find_programs(char runner[PATH_MAX], char programs[CLI_MAX_PROGRAMS])
{
    ssize_t n = readlink("/proc/self/exe", runner, PATH_MAX - 1);
    if (n <= 0)
        return false;
    runner[n] = '\0';
    int dir = (int)(strrchr(runner, '/') - runner);
    snprintf(programs, CLI_MAX_PROGRAMS, "%.*s/../lib/touchstone", dir, runner);
    if (access(programs, X_OK) != 0)
        snprintf(programs, CLI_MAX_PROGRAMS, "%.*s", dir, runner);
    return true;
}
