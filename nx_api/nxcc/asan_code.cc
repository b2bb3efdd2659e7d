/* asan_code.cc - see asan_code.h. */
#include "asan_code.h"
#include "../contract/asan.h"
#include <string>

namespace
{
tree constraint(const char *text, tree value)
{
    tree string = build_string((int)strlen(text) + 1, text);
    return build_tree_list(build_tree_list(NULL_TREE, string), value);
}

/* Code with two scratch registers, %0 and %1, and an object, %2. */
gasm *build(const std::string &text, tree object)
{
    vec<tree, va_gc> *in = NULL, *out = NULL;
    for (int i = 0; i < 2; i++)
        vec_safe_push(out, constraint("=&r", make_ssa_name(ptr_type_node)));
    vec_safe_push(in, constraint("m", unshare_expr(object)));
    gasm *code = gimple_build_asm_vec(ggc_strdup(text.c_str()), in, out, NULL, NULL);
    gimple_asm_set_volatile(code, true);
    for (unsigned i = 0; i < gimple_asm_noutputs(code); i++)
        SSA_NAME_DEF_STMT(TREE_VALUE(gimple_asm_output_op(code, i))) = code;
    return code;
}

std::string number(size_t n)
{
    return std::to_string(n);
}

/* %0 = the object's address. */
std::string take_address(size_t shift)
{
    return "leaq\t%2, %0\n" + (shift ? "\taddq\t$" + number(shift) + ", %0\n" : "");
}

/* reg = the address of the shadow, if the address in reg has one; otherwise goes to the label. */
std::string find_shadow(const std::string &reg, const std::string &label)
{
    return "\tsubq\tnxc_asan_low(%%rip), " + reg + "\n\tcmpq\tnxc_asan_bytes(%%rip), " + reg + "\n\tjae\t" +
           label + "\n\tshrq\t$3, " + reg + "\n\taddq\tnxc_asan_shadow(%%rip), " + reg + "\n";
}

/* The comparison that sees the shadow of all bytes of an access, wherever it begins. */
const char *comparison(unsigned bytes)
{
    return bytes == 1 ? "cmpb" : bytes <= 9 ? "cmpw" : bytes <= 25 ? "cmpl" : "cmpq";
}

/* Sets the shadow of a local variable's last grain, of which the variable has a part, and of its zone. */
std::string mark(size_t bytes, unsigned part, unsigned zone)
{
    size_t grains = nxc_asan_zone_at(bytes) / NXC_ASAN_GRAIN;
    std::string s = "\tmovl\t$" + number(zone * 0x01010101u) + ", " + number(grains) + "(%0)\n";
    if (bytes % NXC_ASAN_GRAIN)
        s += "\tmovb\t$" + number(part) + ", " + number(grains - 1) + "(%0)\n";
    return s;
}
static_assert(NXC_ASAN_ZONE == 4 * NXC_ASAN_GRAIN, "mark() sets the shadow of a zone by one instruction");
} // namespace

gasm *asan_code_access(tree object, int shift, unsigned bytes, size_t site)
{
    return build(take_address((size_t)shift) + "\tmovq\t%0, %1\n" + find_shadow("%1", "772f") + "\t" +
                     comparison(bytes) +
                     "\t$0, (%1)\n"
                     "\tjne\t771f\n"
                     "772:\n"
                     "\t.subsection 1\n"
                     "771:\tmovq\t%%rax, nxc_race_saved(%%rip)\n"
                     "\tmovq\t%%rcx, nxc_race_saved+8(%%rip)\n"
                     "\tmovq\t%0, %%rax\n"
                     "\tleaq\t.Lnxc_races+" +
                     number(site) +
                     "(%%rip), %%rcx\n"
                     "\tcall\tnxc_race_tell\n"
                     "\tjmp\t772b\n"
                     "\t.previous",
                 object);
}

gasm *asan_code_begin_local(tree variable, size_t bytes, size_t site)
{
    size_t at = nxc_asan_zone_at(bytes) + NXC_ASAN_LOCAL_AT;
    return build(take_address(0) + "\tleaq\t.Lnxc_races+" + number(site) + "(%%rip), %1\n\tmovq\t%1, " +
                     number(at) + "(%0)\n\tmovq\t$" + number(bytes) + ", " + number(at + 8) + "(%0)\n" +
                     find_shadow("%0", "771f") + mark(bytes, bytes % NXC_ASAN_GRAIN, NXC_ASAN_LOCAL) +
                     "771:",
                 variable);
}

gasm *asan_code_end_local(tree variable, size_t bytes)
{
    return build(take_address(0) + find_shadow("%0", "771f") + mark(bytes, 0, 0) + "771:", variable);
}
