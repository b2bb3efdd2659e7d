/* f77_machine.c - the machine, its clocks and processes, from Fortran. */
#include <stdlib.h>
#include <string.h>
#include "f77_entry.h"

#define VALUE(name)                                                                                          \
    ENTRY integer name##_(void)                                                                              \
    {                                                                                                        \
        return (integer)name();                                                                              \
    }
VALUE(mynode)
VALUE(myphysnode)
VALUE(numnodes)
VALUE(myhost)
VALUE(nodedim)
VALUE(mypid)
VALUE(myptype)
VALUE(mclock)

/* GNU Fortran's intrinsic function MCLOCK, which a program calls unless it declares MCLOCK EXTERNAL. */
ENTRY integer _gfortran_mclock(void)
{
    return (integer)mclock();
}

ENTRY double dclock_(void)
{
    return dclock();
}

ENTRY void flick_(void)
{
    flick();
}

ENTRY void led_(in *state)
{
    led(*state);
}

ENTRY integer gray_(in *n)
{
    return (integer)gray(*n);
}

ENTRY integer ginv_(in *n)
{
    return (integer)ginv(*n);
}

/* --- the Paragon's submesh --- */

ENTRY integer mypart_(integer *rows, integer *columns)
{
    long r, c;
    integer result = (integer)mypart(&r, &c);
    *rows = (integer)r, *columns = (integer)c;
    return result;
}

ENTRY integer nx_app_rect_(integer *rows, integer *columns)
{
    long r, c;
    integer result = (integer)nx_app_rect(&r, &c);
    *rows = (integer)r, *columns = (integer)c;
    return result;
}

/* The program is on its nodes already (nx.h), so the arguments are ignored. */
ENTRY integer nx_initve_() /* any arguments */
{
    return (integer)numnodes();
}

ENTRY integer nx_nfork_(in nodes[], in *count, in *ptype, integer pids[])
{
    (void)nodes, (void)count, (void)ptype, (void)pids;
    return 0;
}

VALUE(nx_waitall)

ENTRY integer nx_pri_(in *process_group, in *priority)
{
    return (integer)nx_pri(*process_group, *priority);
}

/* --- processes --- */

ENTRY void setpid_(in *pid)
{
    setpid(*pid);
}

ENTRY void setptype_(in *ptype)
{
    setptype(*ptype);
}

ENTRY void killproc_(in *node, in *pid)
{
    killproc(*node, *pid);
}

ENTRY void killcube_(in *node, in *pid)
{
    killcube(*node, *pid);
}

ENTRY void waitall_(in *node, in *pid)
{
    waitall(*node, *pid);
}

ENTRY void waitone_(in *node, in *pid, integer *ended_node, integer *ended_pid, integer *status)
{
    long n, p, s;
    waitone(*node, *pid, &n, &p, &s);
    *ended_node = (integer)n, *ended_pid = (integer)p, *status = (integer)s;
}

extern long handler(long trap, void (*f)(void)), load(const char *path, long node, long pid); /* see nx.h */

ENTRY void handler_(in *trap, void (*f)(void))
{
    handler(*trap, f);
}

ENTRY void load_(const char *path, in *node, in *pid, size_t bytes)
{
    char *name = nx_fortran_text(path, bytes, "load");
    load(name, *node, *pid);
    free(name);
}

ENTRY void nxperror_(const char *what, size_t bytes)
{
    char *text = nx_fortran_text(what, bytes, "nxperror");
    nxperror(text);
    free(text);
}

ENTRY void nx_perror_(const char *what, size_t bytes)
{
    nxperror_(what, bytes);
}

/* --- extended arithmetic: an INTEGER(2) holds the low half, then the high --- */

static esize_t size_of(in e[2])
{
    return (esize_t){e[0], e[1]};
}

static void put(integer e[2], esize_t s)
{
    e[0] = (integer)s.slow, e[1] = (integer)s.shigh;
}

ENTRY void hwclock_(integer ticks[2])
{
    esize_t s;
    hwclock(&s);
    put(ticks, s);
}

ENTRY void eadd_(in a[2], in b[2], integer result[2])
{
    put(result, eadd(size_of(a), size_of(b)));
}

ENTRY void esub_(in a[2], in b[2], integer result[2])
{
    put(result, esub(size_of(a), size_of(b)));
}

ENTRY void emul_(in a[2], in *n, integer result[2])
{
    put(result, emul(size_of(a), *n));
}

ENTRY integer ediv_(in a[2], in *n)
{
    return (integer)ediv(size_of(a), *n);
}

ENTRY integer emod_(in a[2], in *n)
{
    return (integer)emod(size_of(a), *n);
}

ENTRY integer ecmp_(in a[2], in b[2])
{
    return (integer)ecmp(size_of(a), size_of(b));
}

ENTRY void stoe_(const char *s, integer result[2], size_t bytes)
{
    char *text = nx_fortran_text(s, bytes, "stoe");
    put(result, stoe(text));
    free(text);
}

/* Blanks behind the digits; what does not fit is cut off. */
ENTRY void etos_(in a[2], char *s, size_t bytes)
{
    char digits[24];
    etos(size_of(a), digits);
    size_t n = strnlen(digits, bytes);
    memcpy(s, digits, n);
    memset(s + n, ' ', bytes - n);
}
