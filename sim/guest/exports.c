/* exports.c - exports.def as a table. It is searched from its start: a program asks for a few dozen names,
 * once. */
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include "guest/exports.h"

/* The functions are declared under other names and bound by assembler name: their C declarations, and
 * macros of the same name, do not matter here and differ from void (*)(void). */
#define CALL(name) extern void call_##name(void) __asm__("node_" #name);
#define LIBC(name) extern void libc_##name(void) __asm__(#name);
#define DATA(name)
#include "guest/exports.def"
#undef CALL
#undef LIBC
#undef DATA

#define CALL(name) {#name, call_##name},
#define LIBC(name) {#name, libc_##name},
#define DATA(name) {#name, NULL},
static const struct node_export table[] = {
#include "guest/exports.def"
};

static const struct node_export *find(const char *name)
{
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++)
        if (strcmp(table[i].name, name) == 0)
            return &table[i];
    return NULL;
}

const struct node_export *node_export_find(const char *name, bool long32)
{
    char own[64];
    snprintf(own, sizeof own, "long32_%s", name);
    const struct node_export *e = long32 ? find(own) : NULL;
    return e ? e : find(name);
}

const char *node_export_name(uintptr_t address)
{
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++)
        if (table[i].code && (uintptr_t)table[i].code == address)
            return table[i].name;
    return NULL;
}
