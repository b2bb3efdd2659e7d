/* errors.c - errors at run time, STOP, EXIT and ABORT, instead of GNU Fortran's error.c, stop.c, exit.c,
 * abort.c and backtrace.c: an error that the program does not ask for (IOSTAT=, ERR= ...) ends it with a
 * message that has node, time, file and line; and what it wrote to its units before is written. (Without
 * frame pointers, which the library's own functions lack, a report misses the line that called them.) */
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/uio.h>
#include <unistd.h>
#include "libgfortran.h"

#define FRAME __builtin_frame_address(0)
#define ALIAS(name) __attribute__((alias(#name)))

enum { TEXT = 400 };

/* --- ending --- */

/* Closing may fail in its turn, perhaps of the same cause. */
static void close_units(void)
{
    static bool closing;
    if (closing)
        return;
    closing = true;
    _gfortrani_close_units();
}

_Noreturn static void die(const void *frame, const char *format, ...)
{
    char text[TEXT];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    close_units();
    nx_die(text, frame);
}

_Noreturn void _gfortrani_exit_error(int status)
{
    close_units();
    exit(status);
}

_Noreturn void _gfortrani_sys_abort(void)
{
    die(FRAME, "abort");
}
void _gfortran_abort(void) ALIAS(_gfortrani_sys_abort); /* CALL ABORT */

/* --- what the library writes --- */

long _gfortrani_estr_write(const char *s)
{
    return write(STDERR_FILENO, s, strlen(s));
}

long _gfortrani_estr_writev(const struct iovec *parts, int count)
{
    return writev(STDERR_FILENO, parts, count);
}

int _gfortrani_st_printf(const char *format, ...)
{
    char text[TEXT];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    return (int)_gfortrani_estr_write(text);
}

char *_gfortrani_gf_strerror(int code, char *buf, size_t size)
{
    (void)buf, (void)size;
    return strerror(code);
}

/* The report that follows has what there is to say. Weak: CALL BACKTRACE is an undefined reference of
 * GNU's own. */
__attribute__((weak)) void _gfortrani_show_backtrace(bool in_handler)
{
    (void)in_handler;
}

/* --- errors of I/O statements --- */

const char *_gfortrani_translate_error(int code)
{
    static const struct {
        int code;
        const char *text;
    } known[] = {
        {ERROR_EOR, "end of record"},
        {ERROR_END, "end of file"},
        {0, "no error"},
        {5001, "options of the statement contradict each other"},
        {5002, "an option of the statement has a bad value"},
        {5003, "an option of the statement is missing"},
        {5004, "the file is open on another unit"},
        {5005, "the unit is not connected"},
        {5006, "error in the format"},
        {5007, "the file was not opened for this action"},
        {5008, "reading or writing past the end of the file"},
        {5009, "the unformatted file is damaged"},
        {5010, "the input is not a value of this type"},
        {5011, "the number read is too large"},
        {5012, "internal error of the Fortran library"},
        {5013, "internal unit: past its end"},
        {5015, "longer than a record of the direct-access file"},
        {5016, "past the end of a record of the unformatted file"},
        {5017, "the records of the unformatted file are damaged: written in another form?"},
        {5018, "an internal unit cannot be inquired about"},
        {5019, "WAIT for an ID that is not in use"},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (known[i].code == code)
            return known[i].text;
    return code == ERROR_OS ? strerror(errno) : "unknown error";
}

/* Fortran's texts have a length, and blanks behind. */
static void copy_padded(char *to, size_t bytes, const char *text)
{
    size_t n = strnlen(text, bytes);
    memcpy(to, text, n);
    memset(to + n, ' ', bytes - n);
}

_Noreturn static void die_in(const struct statement *s, const char *text)
{
    char *file = s->unit >= 0 ? _gfortrani_filename_from_unit(s->unit) : NULL;
    char unit[TEXT / 2] = "";
    if (s->unit >= 0)
        snprintf(unit, sizeof unit, file ? " (unit %d, file '%s')" : " (unit %d)", (int)s->unit, file);
    die(NULL, "%s:%d: Fortran run-time error: %s%s", s->file, (int)s->line, text, unit);
}

/* True: the program sees to it. */
bool _gfortrani_generate_error_common(struct statement *s, int code, const char *text)
{
    static const struct {
        int result, label;
    } ways[] = {{RESULT_ERROR, HAS_ERR}, {RESULT_END, HAS_END}, {RESULT_EOR, HAS_EOR}};
    int system_error = errno;
    if ((s->flags & RESULT_MASK) == RESULT_ERROR)
        return true; /* the first error counts */
    if (s->flags & HAS_STATUS)
        *s->status = code == ERROR_OS ? system_error : code;
    if (!text)
        text = _gfortrani_translate_error(code);
    if (s->flags & HAS_MESSAGE)
        copy_padded(s->message, s->message_bytes, text);
    int way = code == ERROR_END ? 1 : code == ERROR_EOR ? 2 : 0;
    s->flags = (s->flags & ~RESULT_MASK) | ways[way].result;
    if (s->flags & (ways[way].label | HAS_STATUS))
        return true;
    die_in(s, text);
}

void _gfortrani_generate_error(struct statement *s, int code, const char *text)
{
    _gfortrani_generate_error_common(s, code, text);
}
void _gfortran_generate_error(struct statement *, int, const char *) ALIAS(_gfortrani_generate_error);

void _gfortrani_generate_warning(struct statement *s, const char *text)
{
    _gfortrani_st_printf("%s:%d: Fortran run-time warning: %s\n", s->file, (int)s->line, text);
}

void _gfortrani_show_locus(struct statement *s)
{
    (void)s; /* die_in has said it */
}

/* Everything that the library can do is allowed to all programs. */
bool _gfortrani_notify_std(struct statement *s, int standard, const char *text)
{
    (void)s, (void)standard, (void)text;
    return true;
}

int _gfortrani_notification_std(int standard)
{
    (void)standard;
    return 0; /* nothing to say */
}

_Noreturn void _gfortrani_internal_error(struct statement *s, const char *text)
{
    if (s)
        die_in(s, text);
    die(FRAME, "internal error of the Fortran library: %s", text);
}

/* --- other errors --- */

_Noreturn void _gfortrani_os_error(const char *text)
{
    die(FRAME, "Fortran run-time error: %s: %s", text, strerror(errno));
}
_Noreturn void _gfortran_os_error(const char *) ALIAS(_gfortrani_os_error);

_Noreturn void _gfortrani_runtime_error(const char *format, ...)
{
    char text[TEXT];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    die(FRAME, "Fortran run-time error: %s", text);
}
_Noreturn void _gfortran_runtime_error(const char *, ...) ALIAS(_gfortrani_runtime_error);

/* "At line 7 of file a.f" as "a.f:7". */
static const char *place(const char *where, char *buf, size_t size)
{
    int line, name = 0;
    if (sscanf(where, "At line %d of file %n", &line, &name) < 1 || !name)
        return where;
    snprintf(buf, size, "%s:%d", where + name, line);
    return buf;
}

_Noreturn void _gfortrani_runtime_error_at(const char *where, const char *format, ...)
{
    char text[TEXT], at[TEXT];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    die(FRAME, "%s: Fortran run-time error: %s", place(where, at, sizeof at), text);
}
_Noreturn void _gfortran_runtime_error_at(const char *, const char *, ...) ALIAS(_gfortrani_runtime_error_at);

_Noreturn void _gfortrani_os_error_at(const char *where, const char *format, ...)
{
    char text[TEXT], at[TEXT];
    int why = errno;
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    die(FRAME, "%s: Fortran run-time error: %s: %s", place(where, at, sizeof at), text, strerror(why));
}
_Noreturn void _gfortran_os_error_at(const char *, const char *, ...) ALIAS(_gfortrani_os_error_at);

void _gfortrani_runtime_warning_at(const char *where, const char *format, ...)
{
    char text[TEXT];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    char at[TEXT];
    _gfortrani_st_printf("%s: Fortran run-time warning: %s\n", place(where, at, sizeof at), text);
}
void _gfortran_runtime_warning_at(const char *, const char *, ...) ALIAS(_gfortrani_runtime_warning_at);

/* --- STOP and EXIT --- */

/* STOP prints nothing but what follows it, and the number is the node's exit status. */
_Noreturn void _gfortran_stop_numeric(int status, bool quiet)
{
    if (status != 0 && !quiet)
        _gfortrani_st_printf("STOP %d\n", status);
    exit(status);
}

_Noreturn void _gfortran_stop_string(const char *text, size_t bytes, bool quiet)
{
    if (text && !quiet)
        _gfortrani_st_printf("STOP %.*s\n", (int)bytes, text);
    exit(0);
}

/* CALL EXIT */
_Noreturn void _gfortran_exit_i4(const int32_t *status)
{
    exit(status ? *status : 0);
}

_Noreturn void _gfortran_exit_i8(const int64_t *status)
{
    exit(status ? (int)*status : 0);
}

_Noreturn void _gfortran_error_stop_numeric(int status, bool quiet)
{
    (void)quiet;
    die(FRAME, "ERROR STOP %d", status);
}

_Noreturn void _gfortran_error_stop_string(const char *text, size_t bytes, bool quiet)
{
    (void)quiet;
    die(FRAME, "ERROR STOP %.*s", (int)bytes, text);
}
