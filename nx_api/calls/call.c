/* call.c - the two entry points of every call, and their errors. See call.h. */
#include "nx_api/calls/call.h"
#include <ctype.h>
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "nx_api/calls/msgwait.h"
#include "nx_api/calls/shape.h"
#include "nx_api/waitfor/waitfor.h"

/* --- errors, and checks that several calls make --- */

long node_error(struct node *n, int code, const char *fmt, ...)
{
    struct node_error *e = nx_last_error(n);
    va_list ap;
    va_start(ap, fmt);
    vsnprintf(e->text, sizeof e->text, fmt, ap);
    va_end(ap);
    e->code = code;
    return -1;
}

long nx_check_node(struct node *n, long node)
{
    long count = n->sys->count;
    if (node == count && !n->sys->host)
        return node_error(n, EQNODE, "node %ld is the host, and no host program runs (nodes are 0 to %ld)",
                          node, count - 1);
    if (node != ALL_NODES && (node < 0 || node > count))
        return node_error(n, EQNODE, "there is no node %ld (nodes are 0 to %ld; -1 is all others)", node,
                          count - 1);
    return 0;
}

long nx_check_victim(struct node *n, word node)
{
    if (node == ALL_NODES || (node >= 0 && node < (word)n->sys->count))
        return 0;
    return node_error(n, EQNODE, "there is no node %d (nodes are 0 to %ld; -1 is all)", node,
                      (long)n->sys->count - 1);
}

long nx_check_buffer(struct node *n, const void *buf, long len)
{
    if (len < 0)
        return node_error(n, EQLEN, "length %ld is negative", len);
    if (len > 0 && !buf)
        return node_error(n, EQPBUF, "the buffer is a null pointer");
    return 0;
}

/* --- errors as the user sees them --- */

/* Prints the name in a parameter's declaration. */
static void print_name(FILE *f, const char *parameter, size_t length)
{
    const char *start = parameter, *end = parameter + length, *pointer = strstr(parameter, "(*");
    if (pointer && pointer < end) {
        start = pointer + 2;
        end = start + strcspn(start, ")");
    } else {
        const char *array = memchr(start, '[', length);
        end = array ? array : end;
        for (start = end; start > parameter && (isalnum(start[-1]) || start[-1] == '_');)
            start--;
    }
    fprintf(f, "%.*s", (int)(end - start), start);
}

/* Numbers and texts by their values; other pointers by their parameters' names, since addresses say nothing;
 * 0 for null. */
static void print_argument(FILE *f, const char *parameter, size_t length, va_list *ap)
{
    static const char TEXT[] = "const char *";
    if (strncmp(parameter, TEXT, sizeof TEXT - 1) == 0) {
        const char *text = va_arg(*ap, const char *);
        if (text)
            fprintf(f, "\"%.100s\"", text);
        else
            fputc('0', f);
    } else if (memchr(parameter, '*', length) || memchr(parameter, '[', length)) {
        if (va_arg(*ap, void *))
            print_name(f, parameter, length);
        else
            fputc('0', f);
    } else if (strncmp(parameter, "word", 4) == 0) {
        fprintf(f, "%d", va_arg(*ap, word));
    } else if (strncmp(parameter, "size_word", 9) == 0) {
        fprintf(f, "%u", va_arg(*ap, size_word));
    } else {
        fprintf(f, "%ld", va_arg(*ap, long));
    }
}

/* The program's call that is made of this one, if this one's first argument is a type of the library's own;
 * NULL: it is the program's. */
static const char *made_for(const char *parameters, va_list *ap)
{
    static const char TYPE[] = "(word type";
    return strncmp(parameters, TYPE, sizeof TYPE - 1) == 0 ? waitfor_operation(va_arg(*ap, word)) : NULL;
}

/* Ends the process, because the call failed. parameters: as in calls.def. */
static _Noreturn void wrong(struct node *n, const char *parameters, ...)
{
    char *text = NULL;
    size_t size;
    va_list ap;
    FILE *f = open_memstream(&text, &size);
    if (!f)
        abort();
    va_start(ap, parameters);
    const char *outer = made_for(parameters, &ap);
    va_end(ap);
    va_start(ap, parameters);
    for (const char *p = parameters + 1; strcmp(p, "void)") != 0;) {
        size_t length = strcspn(p, ","), last = p[length] ? 0 : 1;
        print_argument(f, p, length - last, &ap);
        if (last)
            break;
        fputs(", ", f);
        p += length + 2;
    }
    va_end(ap);
    fclose(f);
    node_fail(n, "%s%s%s(%s): %s", outer ? outer : "", outer ? ": " : "", n->call.name, text,
              nx_last_error(n)->text);
}

/* --- the entry points --- */

static struct node *enter(const char *call)
{
    struct node *n = node_self();
    node_enter(n, call);
    nx_begins_call(n);
    return n;
}

static struct node *enter_early(const char *call)
{
    struct node *n = node_self();
    node_enter_early(n, call);
    nx_begins_call(n);
    return n;
}

static struct node *enter_asking(const char *call)
{
    struct node *n = node_self();
    node_enter_asking(n, call);
    nx_begins_call(n);
    return n;
}

static void leave(struct node *n)
{
    nx_settle(n);
    node_leave(n);
}

/* NAME: an error ends the process. */
inline long nx_plain(struct node *n, long result)
{
    if (result < 0)
        node_fail(n, "%s: %s", n->call.name, nx_last_error(n)->text);
    leave(n);
    return result;
}

/* Not inlined: leave() may return on another thread, which has another errno, and compilers compute the
 * address of errno once in a function. */
__attribute__((noinline)) static void set_errno(int why)
{
    errno = why;
}

/* _NAME: returns the error. */
long nx_returning(struct node *n, long result)
{
    int why = result < 0 ? nx_last_error(n)->code : 0;
    leave(n);
    if (result < 0)
        set_errno(why);
    return result;
}

#define AND(...) __VA_OPT__(, ) __VA_ARGS__
#define ENTRY_POINTS(enter, name, parameters, arguments)                                                     \
    long node_##name parameters                                                                              \
    {                                                                                                        \
        struct node *self = enter(#name);                                                                    \
        long result = nxs_##name arguments;                                                                  \
        if (result < 0)                                                                                      \
            wrong(self, #parameters AND arguments);                                                          \
        return nx_plain(self, result);                                                                       \
    }                                                                                                        \
    long node__##name parameters                                                                             \
    {                                                                                                        \
        struct node *self = enter("_" #name);                                                                \
        return nx_returning(self, nxs_##name arguments);                                                     \
    }
#define NX_CALL(name, parameters, arguments) ENTRY_POINTS(enter, name, parameters, arguments)
#define NX_EARLY(name, parameters, arguments) ENTRY_POINTS(enter_early, name, parameters, arguments)
#define NX_ASKING(name, parameters, arguments) ENTRY_POINTS(enter_asking, name, parameters, arguments)
#define NX_VALUE(name, expression)                                                                           \
    long node_##name(void)                                                                                   \
    {                                                                                                        \
        const struct node *n = node_self();                                                                  \
        return expression;                                                                                   \
    }                                                                                                        \
    long node__##name(void)                                                                                  \
    {                                                                                                        \
        return node_##name();                                                                                \
    }
#define NX_OTHER(name)
#include "nx_api/contract/calls.def"
