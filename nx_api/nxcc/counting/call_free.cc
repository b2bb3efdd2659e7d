/* call_free.cc - see call_free.h. */
#include "counting/call_free.h"
#include "output.h"
#include "base/symbols.h"
#include "varasm.h"
#include <map>
#include <set>
#include <string>

namespace
{
std::map<unsigned, call_free_function> functions; /* of this file, by DECL_UID */
std::set<std::string> exported;                   /* flags of those that other files may call */
std::map<std::string, tree> imported;             /* flags of functions of other files that this file calls */

/* The symbol of a function's flag. GCC marks an assembler name as final by a leading asterisk. */
std::string symbol_of(tree function)
{
    const char *name = IDENTIFIER_POINTER(DECL_ASSEMBLER_NAME(function));
    return std::string("nxc_call_free.") + (*name == '*' ? name + 1 : name);
}

/* The byte that tells whether a function of another file is call-free. */
tree flag_of(tree function)
{
    std::string name = symbol_of(function);
    tree &flag = imported[name];
    if (!flag)
        flag = symbols_declare(name.c_str(), unsigned_char_type_node);
    return flag;
}

void write_flag(const char *binding, const char *name, bool yes)
{
    fprintf(asm_out_file, "\t.%s %s\n\t.hidden %s\n%s:\t.byte %d\n", binding, name, name, name, yes);
}
} // namespace

const call_free_function *call_free_find(tree callee)
{
    auto known = callee ? functions.find(DECL_UID(callee)) : functions.end();
    return known == functions.end() ? nullptr : &known->second;
}

void call_free_add(const call_free_function &f)
{
    tree decl = current_function_decl;
    if (!decl_binds_to_current_def_p(decl))
        return;
    functions[DECL_UID(decl)] = f;
    if (TREE_PUBLIC(decl) && !DECL_WEAK(decl) && !DECL_COMDAT(decl))
        exported.insert(symbol_of(decl));
}

bool call_free_is_external(tree callee)
{
    return callee && TREE_PUBLIC(callee) && DECL_EXTERNAL(callee) && !fndecl_built_in_p(callee) &&
           !DECL_IN_SYSTEM_HEADER(callee);
}

tree call_free_append_all(gimple_seq *seq, const std::vector<tree> &external)
{
    tree all = NULL_TREE;
    for (tree function : external) {
        tree flag = make_ssa_name(unsigned_char_type_node);
        gimple_seq_add_stmt_without_update(seq, gimple_build_assign(flag, flag_of(function)));
        all = all ? gimple_build(seq, BIT_AND_EXPR, unsigned_char_type_node, all, flag) : flag;
    }
    return gimple_build(seq, NE_EXPR, boolean_type_node, all, build_int_cst(unsigned_char_type_node, 0));
}

void call_free_write_flags()
{
    if (!asm_out_file || (exported.empty() && imported.empty()))
        return;
    fputs("\t.section .rodata\n", asm_out_file);
    for (const std::string &name : exported)
        write_flag("globl", name.c_str(), true);
    for (const auto &flag : imported)
        write_flag("weak", flag.first.c_str(), false);
}
