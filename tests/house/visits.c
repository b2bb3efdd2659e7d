/* visits.c - what a message passes on its way: a library to be preloaded into a touchstone that was built
 * with -finstrument-functions. From the first entry of VISITS_FROM to the first exit of VISITS_TO it writes,
 * to file descriptor 9, "+ function call-site" for each function entered and "- function" for each function
 * left. All numbers are offsets in the program, in hexadecimal. See way.awk. */
#define _GNU_SOURCE
#include <link.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static uintptr_t base, from, to;
static enum { BEFORE, BETWEEN, BEHIND } at_present;

static int first_object(struct dl_phdr_info *info, size_t size, void *found)
{
    (void)size;
    *(uintptr_t *)found = info->dlpi_addr;
    return 1;
}

__attribute__((constructor)) static void begin(void)
{
    const char *f = getenv("VISITS_FROM"), *t = getenv("VISITS_TO");
    dl_iterate_phdr(first_object, &base);
    from = f ? strtoull(f, NULL, 16) : 0;
    to = t ? strtoull(t, NULL, 16) : 0;
}

void __cyg_profile_func_enter(void *function, void *site)
{
    uintptr_t at = (uintptr_t)function - base;
    if (at == from && at_present == BEFORE)
        at_present = BETWEEN;
    if (at_present == BETWEEN)
        dprintf(9, "+ %lx %lx\n", (unsigned long)at, (unsigned long)((uintptr_t)site - base));
}

void __cyg_profile_func_exit(void *function, void *site)
{
    (void)site;
    if (at_present == BETWEEN)
        dprintf(9, "- %lx\n", (unsigned long)((uintptr_t)function - base));
    if ((uintptr_t)function - base == to && at_present == BETWEEN)
        at_present = BEHIND;
}
