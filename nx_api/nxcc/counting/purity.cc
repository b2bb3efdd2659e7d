/* purity.cc - see purity.h. */
#include "counting/purity.h"
#include <set>

static std::set<unsigned> impure; /* functions that have lost the attribute, by DECL_UID */

void purity_forget(gcall *call)
{
    tree decl = gimple_call_fndecl(call);
    if (decl && (gimple_call_flags(call) & (ECF_CONST | ECF_PURE | ECF_NOVOPS))) {
        TREE_READONLY(decl) = 0;
        DECL_PURE_P(decl) = 0;
        DECL_LOOPING_CONST_OR_PURE_P(decl) = 0;
        DECL_IS_NOVOPS(decl) = 0;
        impure.insert(DECL_UID(decl));
    }
    tree type = gimple_call_fntype(call);
    if (TYPE_READONLY(type))
        gimple_call_set_fntype(call, build_function_type(TREE_TYPE(type), TYPE_ARG_TYPES(type)));
    if (!gimple_vdef(call))
        update_stmt(call);
}

void purity_prepare_function()
{
    if (impure.empty() || !gimple_in_ssa_p(cfun))
        return;
    basic_block bb;
    FOR_EACH_BB_FN (bb, cfun)
        for (gimple_stmt_iterator gsi = gsi_start_bb(bb); !gsi_end_p(gsi); gsi_next(&gsi)) {
            tree callee = is_gimple_call(gsi_stmt(gsi)) ? gimple_call_fndecl(gsi_stmt(gsi)) : NULL_TREE;
            if (callee && impure.count(DECL_UID(callee)))
                update_stmt(gsi_stmt(gsi));
        }
    update_ssa(TODO_update_ssa_only_virtuals);
}
