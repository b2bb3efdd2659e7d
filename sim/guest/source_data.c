/* source_data.c - see source_data.h. */
#include "guest/source_data.h"
#include <dwarf.h>
#include <elfutils/libdw.h>
#include <stdbool.h>
#include "kernel/xalloc.h"

/* Where a variable begins: a constant address, perhaps with a constant to be added (in a common block). */
static bool begin_of(Dwarf_Die *variable, Dwarf_Addr *begin)
{
    Dwarf_Attribute location;
    Dwarf_Op *op;
    size_t count;
    if (!dwarf_attr(variable, DW_AT_location, &location) || dwarf_getlocation(&location, &op, &count) != 0)
        return false;
    if (count < 1 || count > 2 || op[0].atom != DW_OP_addr || (count == 2 && op[1].atom != DW_OP_plus_uconst))
        return false;
    *begin = op[0].number + (count == 2 ? op[1].number : 0);
    return true;
}

static bool holds(Dwarf_Die *variable, Dwarf_Addr address)
{
    Dwarf_Attribute attribute;
    Dwarf_Die type;
    Dwarf_Addr begin;
    Dwarf_Word size;
    return begin_of(variable, &begin) && dwarf_attr_integrate(variable, DW_AT_type, &attribute) &&
           dwarf_formref_die(&attribute, &type) && dwarf_aggregate_size(&type, &size) == 0 &&
           address - begin < size;
}

/* The name of the variable among the entries from *die on, and what they contain; NULL: it is not there. */
static const char *find(Dwarf_Die *die, Dwarf_Addr address)
{
    Dwarf_Die child;
    const char *name = NULL;
    do {
        if (dwarf_tag(die) == DW_TAG_variable && holds(die, address))
            name = dwarf_diename(die);
        else if (dwarf_child(die, &child) == 0)
            name = find(&child, address);
    } while (!name && dwarf_siblingof(die, die) == 0);
    return name;
}

static char *ask(Dwarf *dwarf, Dwarf_Addr address)
{
    Dwarf_Die unit, first;
    for (Dwarf_CU *cu = NULL; dwarf_get_units(dwarf, cu, &cu, NULL, NULL, &unit, NULL) == 0;) {
        const char *name = dwarf_child(&unit, &first) == 0 ? find(&first, address) : NULL;
        if (name)
            return xstrdup(name);
    }
    return NULL;
}

char *source_data(const void *file, size_t bytes, uint64_t address)
{
    elf_version(EV_CURRENT);
    Elf *elf = elf_memory((char *)(uintptr_t)file, bytes);
    Dwarf *dwarf = elf ? dwarf_begin_elf(elf, DWARF_C_READ, NULL) : NULL;
    char *name = dwarf ? ask(dwarf, address) : NULL;
    dwarf_end(dwarf);
    elf_end(elf);
    return name;
}
