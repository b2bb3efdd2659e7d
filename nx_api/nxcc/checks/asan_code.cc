/* asan_code.cc - see asan_code.h. */
#include "checks/asan_code.h"
#include "../contract/asan.h"
#include <string>

namespace
{
tree constraint(const char *text, tree value)
{
    tree string = build_string((int)strlen(text) + 1, text);
    return build_tree_list(build_tree_list(NULL_TREE, string), value);
}

/* Code with two scratch registers, %0 and %1, and what it is about, from %2 on. */
gasm *build(const std::string &text, vec<tree, va_gc> *in)
{
    vec<tree, va_gc> *out = NULL;
    for (int i = 0; i < 2; i++)
        vec_safe_push(out, constraint("=&r", make_ssa_name(ptr_type_node)));
    gasm *code = gimple_build_asm_vec(ggc_strdup(text.c_str()), in, out, NULL, NULL);
    gimple_asm_set_volatile(code, true);
    for (unsigned i = 0; i < gimple_asm_noutputs(code); i++)
        SSA_NAME_DEF_STMT(TREE_VALUE(gimple_asm_output_op(code, i))) = code;
    return code;
}

gasm *build(const std::string &text, tree object)
{
    vec<tree, va_gc> *in = NULL;
    vec_safe_push(in, constraint("m", unshare_expr(object)));
    return build(text, in);
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

/* %1 = the site's address. */
std::string load_site(size_t site)
{
    return "\tleaq\t.Lnxc_races+" + number(site) + "(%%rip), %1\n";
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

/* The shadow of memory for `why`, or 0, in as many bytes as a 32-bit word has. */
std::string word(unsigned why)
{
    return "$" + number(why * 0x01010101u);
}

/* Sets the shadow of so many grains from %0 on. %1 is lost. */
std::string fill(size_t grains, unsigned why)
{
    std::string s;
    size_t words = grains / 4;
    if (words > 8)
        s = "\tmovl\t$" + number(words) + ", %k1\n773:\tmovl\t" + word(why) +
            ", -4(%0,%1,4)\n\tdecl\t%k1\n\tjne\t773b\n";
    else
        for (size_t i = 0; i < words; i++)
            s += "\tmovl\t" + word(why) + ", " + number(4 * i) + "(%0)\n";
    for (size_t i = 4 * words; i < grains; i++)
        s += "\tmovb\t$" + number(why) + ", " + number(i) + "(%0)\n";
    return s;
}

/* Sets the shadow from %0 up to, not with, %1. */
std::string fill_up_to(unsigned why)
{
    return "773:\tcmpq\t%1, %0\n\tjae\t774f\n\tmovb\t$" + number(why) +
           ", (%0)\n\tincq\t%0\n\tjmp\t773b\n774:\n";
}

static_assert(NXC_ASAN_ZONE == 4 * NXC_ASAN_GRAIN, "one instruction sets the shadow of a zone");
} // namespace

gasm *asan_code_access(tree object, int shift, unsigned bytes, size_t site)
{
    return build(take_address((size_t)shift) + "\tmovq\t%0, %1\n" + find_shadow("%1", "771f") + "\t" +
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
    size_t zone = nxc_asan_zone_at(bytes), at = zone + NXC_ASAN_LOCAL_AT, grains = zone / NXC_ASAN_GRAIN;
    unsigned part = bytes % NXC_ASAN_GRAIN;
    std::string s = take_address(0) + load_site(site) + "\tmovq\t%1, " + number(at) + "(%0)\n\tmovq\t$" +
                    number(bytes) + ", " + number(at + 8) + "(%0)\n" + find_shadow("%0", "771f") +
                    fill(grains, 0) + "\tmovl\t" + word(NXC_ASAN_LOCAL) + ", " + number(grains) + "(%0)\n";
    if (part)
        s += "\tmovb\t$" + number(part) + ", " + number(grains - 1) + "(%0)\n";
    return build(s + "771:", variable);
}

gasm *asan_code_end_local(tree variable, size_t bytes)
{
    size_t grains = (nxc_asan_zone_at(bytes) + NXC_ASAN_ZONE) / NXC_ASAN_GRAIN;
    return build(take_address(0) + find_shadow("%0", "771f") + fill(grains, NXC_ASAN_RETURNED) + "771:",
                 variable);
}

gasm *asan_code_begin_block(tree address, tree bytes, size_t site)
{
    vec<tree, va_gc> *in = NULL;
    vec_safe_push(in, constraint("r", address));
    vec_safe_push(in, constraint("r", bytes));
    std::string at = number(NXC_ASAN_LOCAL_AT), behind = number(NXC_ASAN_LOCAL_AT + 8);
    return build("leaq\t7(%3), %0\n"
                 "\tandq\t$-8, %0\n"
                 "\taddq\t%2, %0\n" + /* the zone */
                     load_site(site) +
                     "\tmovq\t%1, " + at + "(%0)\n\tmovq\t%3, " + behind +
                     "(%0)\n"
                     "\tmovq\t%0, %1\n"
                     "\tmovq\t%2, %0\n" +
                     find_shadow("%0", "771f") + find_shadow("%1", "771f") + fill_up_to(0) + "\tmovl\t" +
                     word(NXC_ASAN_LOCAL) +
                     ", (%1)\n"
                     "\tmovl\t%k3, %k0\n"
                     "\tandl\t$7, %k0\n"
                     "\tje\t771f\n"
                     "\tmovb\t%b0, -1(%1)\n"
                     "771:",
                 in);
}

gasm *asan_code_end_blocks(tree end)
{
    vec<tree, va_gc> *in = NULL;
    if (end)
        vec_safe_push(in, constraint("r", end));
    return build("movq\t%%rsp, %0\n\tmovq\t" + std::string(end ? "%2" : "%%rbp") + ", %1\n" +
                     find_shadow("%0", "771f") + find_shadow("%1", "771f") + fill_up_to(NXC_ASAN_RETURNED) +
                     "771:",
                 in);
}
