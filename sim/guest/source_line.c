#include "guest/source_line.h"
#include <elfutils/libdw.h>
#include <pthread.h>
#include <stdbool.h>
#include "kernel/xalloc.h"

struct question {
    void *file;
    size_t bytes;
    Dwarf_Addr address;
    char *path; /* the answer; NULL: unknown */
    int line;
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

static void ask_dwarf(Dwarf *dwarf, struct question *q)
{
    Dwarf_Die unit;
    Dwarf_Line *row = unit_of(dwarf, q->address, &unit) ? dwarf_getsrc_die(&unit, q->address) : NULL;
    const char *path = row ? dwarf_linesrc(row, NULL, NULL) : NULL;
    if (path && dwarf_lineno(row, &q->line) == 0 && q->line > 0)
        q->path = xstrdup(path);
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
char *source_line(const void *file, size_t bytes, uint64_t address, int *line)
{
    struct question q = {.file = (void *)file, .bytes = bytes, .address = address};
    pthread_t thread;
    if (pthread_create(&thread, NULL, ask, &q) != 0)
        return NULL;
    pthread_join(thread, NULL);
    *line = q.line;
    return q.path;
}
