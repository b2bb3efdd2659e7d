/* machine.c - the machine, its clocks and processes, and extended arithmetic, from Fortran. */
#include <stdlib.h>
#include <string.h>
#include "f77_entry.h"

#define VALUE(name)                                                                                          \
    FACE integer name##_(void)                                                                               \
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

/* GNU Fortran has an intrinsic function of this name, which it takes if the program does not say EXTERNAL. */
FACE integer _gfortran_mclock(void)
{
    return (integer)mclock();
}

FACE double dclock_(void)
{
    return dclock();
}

FACE void flick_(void)
{
    flick();
}

FACE void led_(in *state)
{
    led(*state);
}

FACE integer gray_(in *n)
{
    return (integer)gray(*n);
}

FACE integer ginv_(in *n)
{
    return (integer)ginv(*n);
}

/* --- the Paragon's submesh --- */

FACE integer mypart_(integer *rows, integer *columns)
{
    long r, c;
    integer result = (integer)mypart(&r, &c);
    *rows = (integer)r, *columns = (integer)c;
    return result;
}

FACE integer nx_app_rect_(integer *rows, integer *columns)
{
    long r, c;
    integer result = (integer)nx_app_rect(&r, &c);
    *rows = (integer)r, *columns = (integer)c;
    return result;
}

/* The program is on its nodes already: see nx.h. The arguments do not matter. */
FACE integer nx_initve_(void)
{
    return (integer)numnodes();
}

FACE integer nx_nfork_(in nodes[], in *count, in *ptype, integer pids[])
{
    (void)nodes, (void)count, (void)ptype, (void)pids;
    return 0;
}

VALUE(nx_waitall)

FACE integer nx_pri_(in *process_group, in *priority)
{
    return (integer)nx_pri(*process_group, *priority);
}

/* --- processes --- */

FACE void setpid_(in *pid)
{
    setpid(*pid);
}

FACE void setptype_(in *ptype)
{
    setptype(*ptype);
}

FACE void killproc_(in *node, in *pid)
{
    killproc(*node, *pid);
}

FACE void killcube_(in *node, in *pid)
{
    killcube(*node, *pid);
}

FACE void waitall_(in *node, in *pid)
{
    waitall(*node, *pid);
}

FACE void waitone_(in *node, in *pid, integer *ended_node, integer *ended_pid, integer *status)
{
    long n, p, s;
    waitone(*node, *pid, &n, &p, &s);
    *ended_node = (integer)n, *ended_pid = (integer)p, *status = (integer)s;
}

extern long handler(long trap, void (*f)(void)), load(const char *path, long node, long pid); /* see nx.h */

FACE void handler_(in *trap, void (*f)(void))
{
    handler(*trap, f);
}

FACE void load_(const char *path, in *node, in *pid, size_t bytes)
{
    char *name = nx_fortran_text(path, bytes, "load");
    load(name, *node, *pid);
    free(name);
}

FACE void nxperror_(const char *what, size_t bytes)
{
    char *text = nx_fortran_text(what, bytes, "nxperror");
    nxperror(text);
    free(text);
}

FACE void nx_perror_(const char *what, size_t bytes)
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

FACE void hwclock_(integer ticks[2])
{
    esize_t s;
    hwclock(&s);
    put(ticks, s);
}

FACE void eadd_(in a[2], in b[2], integer result[2])
{
    put(result, eadd(size_of(a), size_of(b)));
}

FACE void esub_(in a[2], in b[2], integer result[2])
{
    put(result, esub(size_of(a), size_of(b)));
}

FACE void emul_(in a[2], in *n, integer result[2])
{
    put(result, emul(size_of(a), *n));
}

FACE integer ediv_(in a[2], in *n)
{
    return (integer)ediv(size_of(a), *n);
}

FACE integer emod_(in a[2], in *n)
{
    return (integer)emod(size_of(a), *n);
}

FACE integer ecmp_(in a[2], in b[2])
{
    return (integer)ecmp(size_of(a), size_of(b));
}

FACE void stoe_(const char *s, integer result[2], size_t bytes)
{
    char *text = nx_fortran_text(s, bytes, "stoe");
    put(result, stoe(text));
    free(text);
}

/* Blanks behind the digits; what does not fit is cut off. */
FACE void etos_(in a[2], char *s, size_t bytes)
{
    char digits[24];
    etos(size_of(a), digits);
    size_t n = strnlen(digits, bytes);
    memcpy(s, digits, n);
    memset(s + n, ' ', bytes - n);
}
