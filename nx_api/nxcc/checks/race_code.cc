/* race_code.cc - see race_code.h. */
#include "checks/race_code.h"
#include <string>

namespace
{
/* What stands out of line: it is followed by a jump back. */
std::string if_wanted(const std::string &then)
{
    return "cmpb\t$0, nxc_races_on(%%rip)\n"
           "\tjne\t771f\n"
           "772:\n"
           "\t.subsection 1\n"
           "771:\t" +
           then +
           "\tjmp\t772b\n"
           "\t.previous";
}

std::string load_site(size_t site)
{
    return "\tleaq\t.Lnxc_races+" + std::to_string(site) + "(%%rip), %%rcx\n";
}

void add_input(vec<tree, va_gc> **inputs, const char *constraint, tree value)
{
    tree text = build_string((int)strlen(constraint) + 1, constraint);
    vec_safe_push(*inputs, build_tree_list(build_tree_list(NULL_TREE, text), value));
}

gasm *build(const std::string &text, vec<tree, va_gc> *inputs)
{
    gasm *code = gimple_build_asm_vec(ggc_strdup(text.c_str()), inputs, NULL, NULL, NULL);
    gimple_asm_set_volatile(code, true);
    return code;
}
} // namespace

/* The object's address may be relative to the stack pointer, so that nothing may be pushed before it is
 * computed. */
gasm *race_code_access(tree object, int shift, size_t site)
{
    vec<tree, va_gc> *inputs = NULL;
    add_input(&inputs, "m", unshare_expr(object));
    std::string then = "movq\t%%rax, nxc_race_saved(%%rip)\n"
                       "\tmovq\t%%rcx, nxc_race_saved+8(%%rip)\n"
                       "\tleaq\t%0, %%rax\n";
    if (shift)
        then += "\taddq\t$" + std::to_string(shift) + ", %%rax\n";
    return build(if_wanted(then + load_site(site) + "\tcall\tnxc_race_tell\n"), inputs);
}

gasm *race_code_range(tree address, tree bytes, size_t site)
{
    vec<tree, va_gc> *inputs = NULL;
    add_input(&inputs, "r", address);
    add_input(&inputs, "re", bytes);
    std::string then = "pushq\t%0\n"
                       "\tpushq\t%1\n"
                       "\tpushq\t%%rcx\n" +
                       load_site(site) +
                       "\tcall\tnxc_race_tell_range\n"
                       "\tpopq\t%%rcx\n"
                       "\tleaq\t16(%%rsp), %%rsp\n";
    return build(if_wanted(then), inputs);
}
