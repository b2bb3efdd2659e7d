/* symbols.cc - see symbols.h. */
#include "base/symbols.h"
#include <string>

namespace
{
tree all; /* a list of all variables made here, for the garbage collector */

const ggc_root_tab roots[] = {
    {&all, 1, sizeof all, &gt_ggc_mx_tree_node, &gt_pch_nx_tree_node},
    LAST_GGC_ROOT_TAB,
};

tree make(const char *name, tree type)
{
    tree var = build_decl(BUILTINS_LOCATION, VAR_DECL, get_identifier(name), type);
    TREE_USED(var) = 1;
    TREE_ADDRESSABLE(var) = 1;
    DECL_ARTIFICIAL(var) = 1;
    DECL_IGNORED_P(var) = 1;
    return var;
}

tree keep(tree var)
{
    all = tree_cons(NULL_TREE, var, all);
    varpool_node::get_create(var); /* later passes ask for it */
    return var;
}
} // namespace

tree symbols_declare(const char *name, tree type)
{
    tree var = make(name, type);
    DECL_EXTERNAL(var) = 1;
    TREE_PUBLIC(var) = 1;
    DECL_VISIBILITY(var) = VISIBILITY_HIDDEN;
    DECL_VISIBILITY_SPECIFIED(var) = 1;
    return keep(var);
}

tree symbols_define_local(const char *name, tree type)
{
    tree var = make(name, type);
    SET_DECL_ASSEMBLER_NAME(var, get_identifier(("*.L" + std::string(name)).c_str()));
    TREE_STATIC(var) = 1;
    TREE_ASM_WRITTEN(var) = 1; /* GCC must not write it */
    return keep(var);
}

const ggc_root_tab *symbols_gc_roots()
{
    return roots;
}
