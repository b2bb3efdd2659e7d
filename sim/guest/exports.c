/* exports.c - exports.def as a table. It is searched from its start: a program asks for a few dozen names,
 * once. */
#include "guest/exports.h"
#include <pthread.h>
#include <stdio.h>
#include <string.h>
#include "kernel/crossing.h"

/* The functions are declared under other names and bound by assembler name: their C declarations, and
 * macros of the same name, do not matter here and differ from void (*)(void). */
#define CALL(name) extern void call_##name(void) __asm__("node_" #name);
#define LIBC(name) extern void libc_##name(void) __asm__(#name);
#define DATA(name)
#include "guest/exports.def"
#undef CALL
#undef LIBC
#undef DATA

#define CALL(name) EXPORT_##name,
#define LIBC(name) EXPORT_##name,
#define DATA(name) EXPORT_##name,
enum {
#include "guest/exports.def"
    EXPORTS
};
#undef CALL
#undef LIBC
#undef DATA

#define CALL(name) #name,
#define LIBC(name) #name,
#define DATA(name) #name,
static const char *const names[] = {
#include "guest/exports.def"
};
#undef CALL
#undef LIBC
#undef DATA

#define CALL(name) [EXPORT_##name].function = call_##name,
#define LIBC(name) [EXPORT_##name].function = libc_##name,
#define DATA(name)
#define NOTHING(name) [EXPORT_##name].answer = CROSSING_NOTHING,
#define PAIR(name) [EXPORT_##name].answer = CROSSING_PAIR,
#define REAL(name) [EXPORT_##name].answer = CROSSING_REAL,
#define COMPLEX(name) [EXPORT_##name].answer = CROSSING_COMPLEX,
#define SOME(name) [EXPORT_##name].stacked = CROSSING_SOME,
#define MANY(name) [EXPORT_##name].stacked = CROSSING_MANY,
#define SETJMP(name) [EXPORT_##name].kind = CROSSING_SETJMP,
static const struct crossing_target targets[] = {
#include "guest/exports.def"
#include "guest/answer_kinds.def"
    [EXPORT_nxc_preempt].kind = CROSSING_POLL,
};

static void open_gates(void)
{
    crossing_open(targets, EXPORTS);
}

static int find(const char *name)
{
    for (int i = 0; i < EXPORTS; i++)
        if (strcmp(names[i], name) == 0)
            return i;
    return -1;
}

struct node_export node_export_find(const char *name, bool long32, bool has_errno)
{
    static pthread_once_t opened = PTHREAD_ONCE_INIT;
    char own[64];
    pthread_once(&opened, open_gates);
    snprintf(own, sizeof own, "long32_%s", name);
    int i = long32 ? find(own) : -1;
    if (i < 0)
        i = find(name);
    if (i < 0)
        return (struct node_export){0};
    return (struct node_export){names[i], targets[i].function ? crossing_gate((unsigned)i, has_errno) : 0};
}

const char *node_export_name(uintptr_t address)
{
    int i = crossing_gate_number(address);
    return i < 0 ? NULL : names[i];
}
