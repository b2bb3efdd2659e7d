/* race_reach.cc - see race_reach.h. */
#include "checks/race_reach.h"
#include "base/costs.h"
#include "langhooks.h"
#include "tree-ssa-alias.h"

namespace
{
bool begins_with(const char *s, const char *prefix)
{
    return !strncmp(s, prefix, strlen(prefix));
}

bool is_variable_of_others(tree base)
{
    if (is_global_var(base))
        return !(TREE_READONLY(base) && !TREE_THIS_VOLATILE(base)) &&
               !(VAR_P(base) && DECL_HARD_REGISTER(base));
    bool compilers = lang_GNU_Fortran() && DECL_ARTIFICIAL(base); /* descriptors of arrays */
    return TREE_ADDRESSABLE(base) && !compilers;
}

/* May others than this function reach an object, a declaration or what a pointer points to? */
bool is_reachable_object(tree base)
{
    bool is_variable = DECL_P(base) && TREE_CODE(base) != CONST_DECL;
    if (is_variable ? !is_variable_of_others(base)
                    : TREE_CODE(base) != MEM_REF && TREE_CODE(base) != TARGET_MEM_REF)
        return false; /* or it is a constant */
    if (race_reach_is_own(base))
        return false;
    return !optimize || ref_may_alias_global_p(base, true);
}
} // namespace

bool race_reach_is_own(tree base)
{
    if (DECL_P(base))
        return DECL_ARTIFICIAL(base) && DECL_NAME(base) &&
               begins_with(IDENTIFIER_POINTER(DECL_NAME(base)), "nxc_");
    tree pointer = TREE_CODE(base) == MEM_REF ? TREE_OPERAND(base, 0) : NULL_TREE;
    gasm *code =
        pointer && TREE_CODE(pointer) == SSA_NAME ? dyn_cast<gasm *>(SSA_NAME_DEF_STMT(pointer)) : NULL;
    return code && begins_with(gimple_asm_string(code), "call\tnxc_");
}

bool race_reach(tree ref)
{
    return costs_is_memory(ref) && is_reachable_object(get_base_address(ref));
}

bool race_reach_behind(tree pointer)
{
    if (TREE_CODE(pointer) == ADDR_EXPR) {
        tree base = get_base_address(TREE_OPERAND(pointer, 0));
        return base && is_reachable_object(base);
    }
    return !optimize || TREE_CODE(pointer) != SSA_NAME || ptr_deref_may_alias_global_p(pointer, true);
}
