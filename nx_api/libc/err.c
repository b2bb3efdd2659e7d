/* err.c - messages of errors and warnings on stderr, by BSD's functions and GNU's: "PROGRAM: TEXT", and what
 * errno says. */
#define _GNU_SOURCE
#include <err.h>
#include <errno.h>
#include <error.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* In one piece: other nodes write to the same file. If memory is short, the format must do. */
static void say(const char *program, const char *where, const char *format, va_list list, const char *reason)
{
    char *text = NULL;
    if (format && vasprintf(&text, format, list) < 0)
        text = NULL;
    const char *what = text ? text : format ? format : "";
    fprintf(stderr, "%s%s%s%s%s\n", program, where, what, format && reason ? ": " : "", reason ? reason : "");
    free(text);
}

static void say_short(const char *format, va_list list, const char *reason)
{
    say(program_invocation_short_name, ": ", format, list, reason);
}

void vwarn(const char *format, va_list list)
{
    say_short(format, list, strerror(errno));
}

void vwarnx(const char *format, va_list list)
{
    say_short(format, list, NULL);
}

void verr(int status, const char *format, va_list list)
{
    vwarn(format, list);
    exit(status);
}

void verrx(int status, const char *format, va_list list)
{
    vwarnx(format, list);
    exit(status);
}

#define WITH_LIST(call)                                                                                      \
    va_list list;                                                                                            \
    va_start(list, format);                                                                                  \
    call;                                                                                                    \
    va_end(list)

void warn(const char *format, ...)
{
    WITH_LIST(vwarn(format, list));
}

void warnx(const char *format, ...)
{
    WITH_LIST(vwarnx(format, list));
}

void err(int status, const char *format, ...)
{
    WITH_LIST(verr(status, format, list));
}

void errx(int status, const char *format, ...)
{
    WITH_LIST(verrx(status, format, list));
}

/* --- GNU's --- */

unsigned error_message_count;
int error_one_per_line;
void (*error_print_progname)(void);

/* where: behind the program's name, which a function of the program's may print in its place. */
static void tell(int status, int code, const char *where, const char *format, va_list list)
{
    const char *name = error_print_progname ? "" : program_invocation_name;
    fflush(stdout);
    if (error_print_progname)
        error_print_progname();
    error_message_count++;
    say(name, where, format, list, code ? strerror(code) : NULL);
    if (status)
        exit(status);
}

void error(int status, int code, const char *format, ...)
{
    WITH_LIST(tell(status, code, error_print_progname ? "" : ": ", format, list));
}

void error_at_line(int status, int code, const char *file, unsigned line, const char *format, ...)
{
    static const char *last_file;
    static unsigned last_line;
    char where[1000] = ": ";
    if (error_one_per_line && last_file && file && line == last_line && !strcmp(file, last_file))
        return;
    last_file = file;
    last_line = line;
    if (file)
        snprintf(where, sizeof where, ":%s:%u: ", file, line);
    WITH_LIST(tell(status, code, where, format, list));
}
