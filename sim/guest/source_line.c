/* source_line.c - see source_line.h. */
#include "guest/source_line.h"
#include <dwarf.h>
#include <elfutils/libdw.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdlib.h>
#include "kernel/xalloc.h"

struct question {
    void *file;
    size_t bytes;
    Dwarf_Addr address;
    struct source_frame *frames; /* the answer, */
    size_t most, count;          /* so many; most 0: the function is asked for, */
    char *function;              /* and this is the answer */
};

/* Every compiled unit is asked whether it contains the address, since an index by address (.debug_aranges)
 * may be missing. */
static bool unit_of(Dwarf *dwarf, Dwarf_Addr address, Dwarf_Die *unit)
{
    for (Dwarf_CU *cu = NULL; dwarf_get_units(dwarf, cu, &cu, NULL, NULL, unit, NULL) == 0;)
        if (dwarf_haspc(unit, address) > 0)
            return true;
    return false;
}

static bool number_at(Dwarf_Die *die, unsigned name, Dwarf_Word *number)
{
    Dwarf_Attribute attribute;
    return dwarf_attr(die, name, &attribute) && dwarf_formudata(&attribute, number) == 0;
}

/* The line from which an inlined function is called. */
static bool add_caller(struct question *q, Dwarf_Die *unit, Dwarf_Die *inlined)
{
    Dwarf_Files *files;
    Dwarf_Word file, line;
    const char *path = dwarf_getsrcfiles(unit, &files, NULL) == 0 &&
                               number_at(inlined, DW_AT_call_file, &file) &&
                               number_at(inlined, DW_AT_call_line, &line)
                           ? dwarf_filesrc(files, file, NULL, NULL)
                           : NULL;
    if (!path || q->count == q->most)
        return false;
    const char *function = dwarf_diename(inlined);
    q->frames[q->count - 1].function = xstrdup(function ? function : "");
    q->frames[q->count++] = (struct source_frame){.path = xstrdup(path), .line = (int)line};
    return true;
}

static void add_callers(struct question *q, Dwarf_Die *unit)
{
    Dwarf_Die *innermost = NULL, *outwards = NULL;
    int count =
        dwarf_getscopes(unit, q->address, &innermost) > 0 ? dwarf_getscopes_die(&innermost[0], &outwards) : 0;
    for (int i = 0; i < count && dwarf_tag(&outwards[i]) != DW_TAG_subprogram; i++)
        if (dwarf_tag(&outwards[i]) == DW_TAG_inlined_subroutine && !add_caller(q, unit, &outwards[i]))
            break;
    free(innermost);
    free(outwards);
}

/* Names the function if the address is of its code. */
static int look_at_function(Dwarf_Die *function, void *question)
{
    struct question *q = question;
    if (dwarf_haspc(function, q->address) <= 0)
        return DWARF_CB_OK;
    const char *name = dwarf_diename(function);
    q->function = name ? xstrdup(name) : NULL;
    return DWARF_CB_ABORT;
}

static void ask_dwarf(Dwarf *dwarf, struct question *q)
{
    Dwarf_Die unit;
    int line;
    bool known = unit_of(dwarf, q->address, &unit);
    if (known && !q->most)
        dwarf_getfuncs(&unit, look_at_function, q, 0); /* also in modules of Fortran's */
    Dwarf_Line *row = known && q->most ? dwarf_getsrc_die(&unit, q->address) : NULL;
    const char *path = row ? dwarf_linesrc(row, NULL, NULL) : NULL;
    if (!path || dwarf_lineno(row, &line) != 0 || line <= 0)
        return;
    q->frames[q->count++] = (struct source_frame){.path = xstrdup(path), .line = line};
    if (q->most > 1)
        add_callers(q, &unit);
}

static void *ask(void *arg)
{
    struct question *q = arg;
    elf_version(EV_CURRENT);
    Elf *elf = elf_memory(q->file, q->bytes);
    Dwarf *dwarf = elf ? dwarf_begin_elf(elf, DWARF_C_READ, NULL) : NULL;
    if (dwarf)
        ask_dwarf(dwarf, q);
    dwarf_end(dwarf);
    elf_end(elf);
    return NULL;
}

/* Asks libdw on a thread of its own: libdw takes more stack than a node may have left. */
static struct question ask_apart(const void *file, size_t bytes, uint64_t address,
                                 struct source_frame *frames, size_t most)
{
    struct question q = {(void *)(uintptr_t)file, bytes, address, frames, most, 0, NULL};
    pthread_t thread;
    if (pthread_create(&thread, NULL, ask, &q) == 0)
        pthread_join(thread, NULL);
    return q;
}

char *source_line(const void *file, size_t bytes, uint64_t address, int *line)
{
    struct source_frame frame = {0};
    ask_apart(file, bytes, address, &frame, 1);
    *line = frame.line;
    return frame.path;
}

char *source_function(const void *file, size_t bytes, uint64_t address)
{
    return ask_apart(file, bytes, address, NULL, 0).function;
}

size_t source_frames(const void *file, size_t bytes, uint64_t address,
                     struct source_frame frames[SOURCE_MOST_FRAMES])
{
    return ask_apart(file, bytes, address, frames, SOURCE_MOST_FRAMES).count;
}
