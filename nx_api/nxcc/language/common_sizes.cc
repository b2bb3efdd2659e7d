/* common_sizes.cc - records COMMON blocks of Fortran, and variables of C that several files may define (its
 * tentative definitions). Files mean one and the same memory by a name, and the linker takes the largest
 * size without a word: files that disagree about the size mostly disagree about what lies where. The records
 * are in section .nxc_commons, which is not loaded, for nxcc to compare when it links
 * (driver/common_blocks.c). A record is a line
 *
 *     f NAME BYTES FILE:LINE      a block of Fortran
 *     c NAME BYTES FILE:LINE      a variable of C
 *
 * Fortran's blank COMMON may have other sizes in other files, and has no record. */
#include "base/gcc.h"
#include "language/common_sizes.h"
#include "langhooks.h"
#include "base/records.h"

namespace
{
std::set<std::string> records;

void record(char language, tree variable)
{
    std::string name = IDENTIFIER_POINTER(DECL_ASSEMBLER_NAME(variable));
    expanded_location at = expand_location(DECL_SOURCE_LOCATION(variable));
    if (name == "__BLNK__" || !at.file || !tree_fits_uhwi_p(DECL_SIZE_UNIT(variable)))
        return;
    records.insert(std::string(1, language) + " " + name + " " +
                   std::to_string(tree_to_uhwi(DECL_SIZE_UNIT(variable))) + " " + at.file + ":" +
                   std::to_string(at.line));
}

/* Before checks make room behind variables (checks/asan_globals.cc). */
void scan_variables(void *, void *)
{
    char language = strncmp(lang_hooks.name, "GNU Fortran", 11) ? 'c' : 'f';
    varpool_node *v;
    FOR_EACH_VARIABLE(v)
    if (DECL_COMMON(v->decl) && TREE_PUBLIC(v->decl) && !DECL_EXTERNAL(v->decl) && DECL_SIZE_UNIT(v->decl))
        record(language, v->decl);
}

void finish_unit(void *, void *)
{
    records_write(".nxc_commons", "", records);
}
} // namespace

void common_sizes_register(const char *plugin)
{
    register_callback(plugin, PLUGIN_ALL_IPA_PASSES_START, scan_variables, NULL);
    register_callback(plugin, PLUGIN_FINISH_UNIT, finish_unit, NULL);
}
