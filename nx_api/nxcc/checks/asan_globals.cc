/* asan_globals.cc - see asan_globals.h. */
#include "base/gcc.h"
#include "checks/asan_globals.h"
#include "output.h"
#include "rtl.h"
#include "varasm.h"
#include "base/texts.h"
#include "../contract/asan.h"
#include <stddef.h>

namespace
{
noswitch_section_callback write_common;

bool is_of_source(tree decl)
{
    return DECL_NAME(decl) && strncmp(IDENTIFIER_POINTER(DECL_NAME(decl)), "nxc_", 4);
}

bool write_larger_common(tree decl, const char *name, unsigned HOST_WIDE_INT size,
                         unsigned HOST_WIDE_INT rounded)
{
    unsigned zone = is_of_source(decl) ? NXC_ASAN_ZONE : 0;
    return write_common(decl, name, size + zone, rounded + zone);
}

void begin_file(void *, void *)
{
    write_common = comm_section->noswitch.callback;
    comm_section->noswitch.callback = write_larger_common;
}

bool is_common(tree decl)
{
    return get_variable_section(decl, false) == comm_section;
}

bool has_own_section(const varpool_node *v)
{
    section *s = get_variable_section(v->decl, false);
    return SECTION_STYLE(s) == SECTION_NAMED && v->implicit_section &&
           !(s->common.flags & (SECTION_MERGE | SECTION_LINKONCE | SECTION_TLS));
}

bool is_protected(const varpool_node *v)
{
    tree decl = v->decl, size = DECL_SIZE_UNIT(decl);
    return !DECL_EXTERNAL(decl) && TREE_ASM_WRITTEN(decl) && !v->alias && is_of_source(decl) && size &&
           tree_fits_uhwi_p(size) && !integer_zerop(size) && (is_common(decl) || has_own_section(v));
}

void write_zone(tree decl)
{
    if (is_common(decl))
        return;
    switch_to_section(get_variable_section(decl, false));
    assemble_zeros(NXC_ASAN_ZONE);
}

void write_entry(tree decl, texts &all)
{
    expanded_location x = expand_location(DECL_SOURCE_LOCATION(decl));
    fputs("\t.quad ", asm_out_file);
    assemble_name(asm_out_file, XSTR(XEXP(DECL_RTL(decl), 0), 0));
    fprintf(asm_out_file, "-.\n\t.quad %llu\n", (unsigned long long)tree_to_uhwi(DECL_SIZE_UNIT(decl)));
    fprintf(asm_out_file, "\t.long .Lnxc_global_text%d-.+%zu\n",
            all.number(IDENTIFIER_POINTER(DECL_NAME(decl))), offsetof(nxc_asan_global, name));
    fprintf(asm_out_file, "\t.long .Lnxc_global_text%d-.+%zu\n", all.number(x.file ? x.file : ""),
            offsetof(nxc_asan_global, file));
    fprintf(asm_out_file, "\t.long %d, %d\n", x.line, is_common(decl));
}

void write_table(const std::vector<tree> &decls)
{
    texts all("nxc_global_text");
    fputs("\t.section nxc_globals,\"a\"\n\t.balign 8\n", asm_out_file);
    for (tree decl : decls)
        write_entry(decl, all);
    fputs("\t.section .rodata.nxc,\"a\"\n", asm_out_file);
    all.write();
}

/* Also a file without variables, or without an access that needs a look, makes the program a checked one: the
 * runtime is linked. */
void finish_file(void *, void *)
{
    varpool_node *v;
    std::vector<tree> decls;
    if (!asm_out_file)
        return;
    FOR_EACH_VARIABLE(v)
    if (is_protected(v))
        decls.push_back(v->decl);
    for (tree decl : decls)
        write_zone(decl);
    if (!decls.empty())
        write_table(decls);
    fputs("\t.section .rodata.nxc,\"a\"\n\t.balign 4\n\t.long nxc_asan-., nxc_races_on-.\n", asm_out_file);
}
} // namespace

void asan_globals_register(const char *plugin)
{
    register_callback(plugin, PLUGIN_START_UNIT, begin_file, NULL);
    register_callback(plugin, PLUGIN_FINISH_UNIT, finish_file, NULL);
}
