/* say.c - see say.h. */
#include "cli/say.h"
#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "cli/options.h"
#include "files/ink.h"
#include "kernel/xalloc.h"

/* The line's first word, if it is what the lines of a report turn on: the length of "  cycle:", else 0. */
static int head_of(const char *line)
{
    static const char *const HEADS[] = {"  cycle:", "  knot:"};
    for (size_t i = 0; i < sizeof HEADS / sizeof *HEADS; i++)
        if (!strncmp(line, HEADS[i], strlen(HEADS[i])))
            return (int)strlen(HEADS[i]);
    return 0;
}

static void say_line(const char *line, int length, bool first_of_many, const struct ink *ink)
{
    int head = head_of(line);
    if (first_of_many)
        fprintf(stderr, "%s%.*s%s\n", ink->bold, length, line, ink->off);
    else if (head)
        fprintf(stderr, "%s%.*s%s%.*s\n", ink->yellow, head, line, ink->off, length - head, line + head);
    else
        fprintf(stderr, "%.*s\n", length, line);
}

static void say(const char *command, const char *format, va_list list, const char *colour,
                const struct ink *ink)
{
    char *text = xvasprintf(format, list);
    bool many = strchr(text, '\n');
    fprintf(stderr, "%stouchstone %s:%s ", colour, command, ink->off);
    for (const char *line = text; line;) {
        size_t length = strcspn(line, "\n");
        say_line(line, (int)length, many && line == text, ink);
        line = line[length] ? line + length + 1 : NULL;
    }
    free(text);
}

void cli_say_error(const char *command, const char *format, ...)
{
    struct ink ink = ink_for(stderr);
    va_list list;
    va_start(list, format);
    say(command, format, list, ink.red, &ink);
    va_end(list);
}

void cli_say_warning(const char *command, const char *format, ...)
{
    struct ink ink = ink_for(stderr);
    va_list list;
    va_start(list, format);
    say(command, format, list, ink.yellow, &ink);
    va_end(list);
}

void cli_say_doing(const char *what, const char *object)
{
    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\r%s %s ...\033[K", what, object);
}

void cli_say_done(void)
{
    if (isatty(STDERR_FILENO))
        fputs("\r\033[K", stderr);
}

int cli_failed(const char *command, char *error, int status)
{
    cli_say_error(command, "%s", error);
    free(error);
    return status;
}

static void check_output(int status, void *command)
{
    if (!status && (fflush(stdout) || ferror(stdout)))
        _exit(cli_failed(command, xasprintf("standard output cannot be written: %m"), CLI_EXIT_OUTPUT));
}

void cli_watch_output(const char *command)
{
    on_exit(check_output, (char *)(uintptr_t)command);
}
