/* cplusplus_runtime.c - what GNU's C++ library asks of a node beyond what C programs do: destructors at exit,
 * tables for unwinding, functions of a locale, which is always "C". It is linked before that library: what
 * would be a thread's or random there is the node's and a fixed sequence here. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <elf.h>
#include <errno.h>
#include <iconv.h>
#include <langinfo.h>
#include <locale.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>
#include <unwind.h>
#include <wchar.h>
#include <wctype.h>

/* --- the end of objects: latest first, and before functions of atexit that came earlier --- */

void *__dso_handle __attribute__((visibility("hidden"))); /* the program is the only one */

static struct ending {
    struct ending *next;
    void (*destroy)(void *);
    void *object;
} * endings;

static void destroy_latest(void)
{
    struct ending *e = endings;
    endings = e->next;
    e->destroy(e->object);
    free(e);
}

int __cxa_atexit(void (*destroy)(void *), void *object, void *library);
int __cxa_atexit(void (*destroy)(void *), void *object, void *library)
{
    (void)library;
    struct ending *e = malloc(sizeof *e);
    if (!e || atexit(destroy_latest))
        return -1;
    *e = (struct ending){endings, destroy, object};
    endings = e;
    return 0;
}

/* --- what the library has as variables of a thread: there is one --- */

void *__cxa_get_globals(void);
void *__cxa_get_globals(void)
{
    static struct {
        void *caught;
        unsigned uncaught;
    } globals;
    return &globals;
}

void *__cxa_get_globals_fast(void);
void *__cxa_get_globals_fast(void)
{
    return __cxa_get_globals();
}

void *once_callable __asm__("_ZSt15__once_callable"); /* std::__once_callable */
void (*once_call)(void) __asm__("_ZSt11__once_call"); /* std::__once_call */

void __once_proxy(void);
void __once_proxy(void)
{
    once_call();
}

int __cxa_thread_atexit(void (*destroy)(void *), void *object, void *library);
int __cxa_thread_atexit(void (*destroy)(void *), void *object, void *library)
{
    return __cxa_atexit(destroy, object, library);
}

char __libc_single_threaded = 1;

/* --- exceptions --- */

/* The linker's: the program's first byte, and behind its last; its table for unwinding. */
extern const char __ehdr_start[] __attribute__((visibility("hidden")));
extern const char _end[] __attribute__((visibility("hidden")));

static const void *unwind_table(void)
{
    const Elf64_Ehdr *h = (const Elf64_Ehdr *)__ehdr_start;
    const Elf64_Phdr *p = (const Elf64_Phdr *)(__ehdr_start + h->e_phoff);
    for (int i = 0; i < h->e_phnum; i++)
        if (p[i].p_type == PT_GNU_EH_FRAME)
            return __ehdr_start + p[i].p_vaddr;
    return NULL;
}

int _dl_find_object(void *address, struct dl_find_object *found)
{
    if ((const char *)address < __ehdr_start || (const char *)address >= _end)
        return -1;
    *found = (struct dl_find_object){.dlfo_map_start = (void *)__ehdr_start,
                                     .dlfo_map_end = (void *)_end,
                                     .dlfo_eh_frame = (void *)unwind_table()};
    return 0;
}

/* An exception that nobody catches ends in abort, below functions of the library that keep no frame pointers,
 * which reports follow: abort is called as if by the function that threw. */
struct thrower {
    bool next; /* the last frame seen was the library's, of the throw */
    uintptr_t address, frame;
};

void __cxa_throw(void *object, void *type, void (*destroy)(void *));
void __cxa_rethrow(void);
_Noreturn void __real_abort(void);
_Noreturn void __wrap_abort(void);

static _Unwind_Reason_Code look(struct _Unwind_Context *c, void *arg)
{
    enum { FRAME_POINTER = 6 };
    struct thrower *t = arg;
    if (t->next) {
        t->address = _Unwind_GetIP(c), t->frame = _Unwind_GetGR(c, FRAME_POINTER);
        return _URC_NORMAL_STOP;
    }
    const void *function = _Unwind_FindEnclosingFunction((void *)(_Unwind_GetIP(c) - 1));
    t->next = function == (void *)__cxa_throw || function == (void *)__cxa_rethrow;
    return _URC_NO_REASON;
}

_Noreturn void __wrap_abort(void)
{
    struct thrower t = {0};
    _Unwind_Backtrace(look, &t);
    if (t.frame)
        __asm__ volatile("andq $-16, %%rsp\n\tpushq %0\n\tmovq %1, %%rbp\n\tjmp *__real_abort@GOTPCREL(%%rip)"
                         :
                         : "r"(t.address), "r"(t.frame));
    __real_abort();
}

/* --- std::random_device: the node's sequence, the same in each run, instead of the processor's --- */

unsigned random_value(void *device) __asm__("_ZNSt13random_device9_M_getvalEv");
unsigned random_value(void *device)
{
    unsigned value;
    (void)device;
    return getentropy(&value, sizeof value) ? 0 : value;
}

double random_entropy(const void *device) __asm__("_ZNKSt13random_device13_M_getentropyEv");
double random_entropy(const void *device)
{
    (void)device;
    return 0;
}

/* Beginning, by a token or its text, and end. */
#define NO_DEVICE(name, symbol)                                                                              \
    void name(void *device) __asm__(symbol);                                                                 \
    void name(void *device)                                                                                  \
    {                                                                                                        \
        (void)device;                                                                                        \
    }
NO_DEVICE(random_begins,
          "_ZNSt13random_device7_M_initERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEE")
NO_DEVICE(random_begins_by_text, "_ZNSt13random_device7_M_initEPKcm")
NO_DEVICE(random_ends, "_ZNSt13random_device7_M_finiEv")

/* --- locales: there is one, also as the user's own --- */

locale_t __newlocale(int mask, const char *name, locale_t base);
locale_t __newlocale(int mask, const char *name, locale_t base)
{
    if (name && *name && strcmp(name, "C") && strcmp(name, "POSIX"))
        return errno = ENOENT, (locale_t)0;
    return newlocale(mask, name, base);
}

locale_t __duplocale(locale_t l);
locale_t __duplocale(locale_t l)
{
    return l;
}

void __freelocale(locale_t l);
void __freelocale(locale_t l)
{
    (void)l;
}

locale_t __uselocale(locale_t to);
locale_t __uselocale(locale_t to)
{
    return uselocale(to);
}

/* System calls of the library's own, for threads and terminals: they fail. */
long syscall(long number, ...)
{
    (void)number;
    return errno = ENOSYS, -1;
}

int ioctl(int file, unsigned long request, ...)
{
    (void)file, (void)request;
    return errno = ENOTTY, -1;
}

/* A function of a locale, by the one without. */
#define IN_LOCALE(type, name, plain, parameters, arguments)                                                  \
    type name parameters;                                                                                    \
    type name parameters                                                                                     \
    {                                                                                                        \
        (void)l;                                                                                             \
        return plain arguments;                                                                              \
    }
IN_LOCALE(char *, __nl_langinfo_l, nl_langinfo, (nl_item item, locale_t l), (item))
IN_LOCALE(wctype_t, __wctype_l, wctype, (const char *name, locale_t l), (name))
IN_LOCALE(int, __iswctype_l, iswctype, (wint_t c, wctype_t type, locale_t l), (c, type))
IN_LOCALE(wint_t, __towupper_l, towupper, (wint_t c, locale_t l), (c))
IN_LOCALE(wint_t, __towlower_l, towlower, (wint_t c, locale_t l), (c))
IN_LOCALE(int, __strcoll_l, strcoll, (const char *a, const char *b, locale_t l), (a, b))
IN_LOCALE(size_t, __strxfrm_l, strxfrm, (char *to, const char *from, size_t n, locale_t l), (to, from, n))
IN_LOCALE(int, __wcscoll_l, wcscoll, (const wchar_t *a, const wchar_t *b, locale_t l), (a, b))
IN_LOCALE(size_t, __wcsxfrm_l, wcsxfrm, (wchar_t * to, const wchar_t *from, size_t n, locale_t l),
          (to, from, n))
IN_LOCALE(float, __strtof_l, strtof, (const char *s, char **end, locale_t l), (s, end))
IN_LOCALE(double, __strtod_l, strtod, (const char *s, char **end, locale_t l), (s, end))
IN_LOCALE(long double, strtold_l, strtold, (const char *s, char **end, locale_t l), (s, end))
IN_LOCALE(size_t, __strftime_l, strftime,
          (char *to, size_t n, const char *format, const struct tm *t, locale_t l), (to, n, format, t))
IN_LOCALE(size_t, __wcsftime_l, wcsftime,
          (wchar_t * to, size_t n, const wchar_t *format, const struct tm *t, locale_t l), (to, n, format, t))

/* A character is a byte. */
size_t mbsnrtowcs(wchar_t *to, const char **from, size_t bytes, size_t room, mbstate_t *state)
{
    size_t n = 0;
    (void)state;
    for (; n < bytes && (!to || n < room); n++) {
        unsigned char c = (unsigned char)(*from)[n];
        if (to)
            to[n] = c;
        if (!c)
            break;
    }
    if (to)
        *from = n < bytes && n < room ? NULL : *from + n;
    return n;
}

size_t wcsnrtombs(char *to, const wchar_t **from, size_t characters, size_t room, mbstate_t *state)
{
    size_t n = 0;
    (void)state;
    for (; n < characters && (!to || n < room); n++) {
        wchar_t c = (*from)[n];
        if (c > 127)
            return errno = EILSEQ, (size_t)-1;
        if (to)
            to[n] = (char)c;
        if (!c)
            break;
    }
    if (to)
        *from = n < characters && n < room ? NULL : *from + n;
    return n;
}

/* --- translations and other character sets: there are none --- */

char *bindtextdomain(const char *domain, const char *folder)
{
    (void)domain, (void)folder;
    return NULL;
}

char *bind_textdomain_codeset(const char *domain, const char *set)
{
    (void)domain, (void)set;
    return NULL;
}

iconv_t iconv_open(const char *to, const char *from)
{
    (void)to, (void)from;
    return errno = EINVAL, (iconv_t)-1;
}

int iconv_close(iconv_t c)
{
    (void)c;
    return errno = EBADF, -1;
}

size_t iconv(iconv_t c, char **from, size_t *left, char **to, size_t *room)
{
    (void)c, (void)from, (void)left, (void)to, (void)room;
    return errno = EBADF, (size_t)-1;
}
