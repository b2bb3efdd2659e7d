/* data_names.cc - records the variables of other files that a file uses: in section .nxc_data, which is not
 * loaded, as texts that end with 0. An undefined symbol of an object file does not tell a variable from a
 * function, and nxcc --stubs has a stand-in for functions only (driver/stubs.c).
 */
#include "base/gcc.h"
#include "language/data_names.h"
#include "output.h"

namespace
{
bool is_data_of_another_file(tree decl)
{
    return DECL_EXTERNAL(decl) && TREE_PUBLIC(decl) && !DECL_ARTIFICIAL(decl) &&
           DECL_ASSEMBLER_NAME_SET_P(decl) && TREE_SYMBOL_REFERENCED(DECL_ASSEMBLER_NAME(decl)) &&
           !in_system_header_at(DECL_SOURCE_LOCATION(decl));
}

bool main_takes_environment;

/* Such a program is given a copy of the environment when it begins, as one that uses `environ` is. */
void look_at_main(void *decl, void *)
{
    tree d = static_cast<tree>(decl);
    if (DECL_NAME(d) && MAIN_NAME_P(DECL_NAME(d)) && TREE_PUBLIC(d) && list_length(DECL_ARGUMENTS(d)) >= 3)
        main_takes_environment = true;
}

void finish_unit(void *, void *)
{
    varpool_node *v;
    if (!asm_out_file)
        return;
    FOR_EACH_VARIABLE(v)
    if (is_data_of_another_file(v->decl))
        fprintf(asm_out_file, "\t.section .nxc_data,\"\",@progbits\n\t.asciz \"%s\"\n",
                IDENTIFIER_POINTER(DECL_ASSEMBLER_NAME(v->decl)));
    if (main_takes_environment)
        fputs("\t.section .data\n\t.balign 8\n\t.quad environ\n", asm_out_file);
}
} // namespace

void data_names_register(const char *plugin)
{
    register_callback(plugin, PLUGIN_FINISH_PARSE_FUNCTION, look_at_main, NULL);
    register_callback(plugin, PLUGIN_FINISH_UNIT, finish_unit, NULL);
}
