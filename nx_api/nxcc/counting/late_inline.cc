/* late_inline.cc - see late_inline.h. */
#include "counting/late_inline.h"
#include "counting/count.h"
#include "counting/counter_flow.h"
#include "runtime/enter.h"
#include "tree-inline.h"
#include "varasm.h"

namespace
{
/* The greatest sizes, in GCC's units, of functions called in several places, and in one. */
const int most = 20, most_once = 50;

std::map<unsigned, cgraph_node *> kept_bodies; /* counted bodies, by DECL_UID of their functions */

/* --- keeping bodies ------------------------------------------------------------------------------------- */

/* Is it no call, and no assembly but that of polls? */
bool may_stand_twice(gimple *stmt)
{
    gasm *assembly = dyn_cast<gasm *>(stmt);
    return assembly ? !strcmp(gimple_asm_string(assembly), NXC_CALL_ENTER)
                    : !is_gimple_call(stmt) || gimple_call_internal_p(stmt);
}

bool may_stand_twice(function *fun)
{
    basic_block bb;
    FOR_EACH_BB_FN (bb, fun)
        for (gimple_stmt_iterator i = gsi_start_bb(bb); !gsi_end_p(i); gsi_next(&i))
            if (!may_stand_twice(gsi_stmt(i)))
                return false;
    return true;
}

bool is_small(cgraph_node *node)
{
    bool once = node->local && !node->address_taken && !node->callers->next_caller;
    return estimate_num_insns_fn(node->decl, &eni_size_weights) <= (once ? most_once : most);
}

/* Is it of use to functions that are still to be compiled? */
bool is_wanted(function *fun)
{
    cgraph_node *node = cgraph_node::get(fun->decl);
    return node && node->callers && decl_binds_to_current_def_p(fun->decl) && !DECL_STATIC_CHAIN(fun->decl) &&
           is_small(node) && may_stand_twice(fun) && tree_inlinable_function_p(fun->decl);
}

/* GCC needs the call graph of what it copies, and has dropped that of this function. */
void drop_calls(cgraph_node *node)
{
    node->remove_callees();
    node->remove_all_references();
}

void keep_body(function *fun)
{
    cgraph_node *node = cgraph_node::get(fun->decl);
    cgraph_edge::rebuild_edges();
    cgraph_node *body = node->create_version_clone_with_body(vNULL, NULL, NULL, NULL, NULL, "counted");
    drop_calls(node);
    if (!body)
        return;
    DECL_STRUCT_FUNCTION(body->decl)->after_inlining = 0; /* GCC's inliner asks for it */
    kept_bodies[DECL_UID(fun->decl)] = body;
}

/* --- inlining ------------------------------------------------------------------------------------------- */

bool has_same_options(tree a, tree b)
{
    return DECL_FUNCTION_SPECIFIC_TARGET(a) == DECL_FUNCTION_SPECIFIC_TARGET(b) &&
           DECL_FUNCTION_SPECIFIC_OPTIMIZATION(a) == DECL_FUNCTION_SPECIFIC_OPTIMIZATION(b);
}

/* Old programs call functions with other arguments than these have, or use a result where there is none. */
bool fits(gimple *call, tree callee)
{
    unsigned n = 0;
    for (tree p = DECL_ARGUMENTS(callee); p; p = DECL_CHAIN(p), n++) {
        tree type = n < gimple_call_num_args(call) ? TREE_TYPE(gimple_call_arg(call, n)) : void_type_node;
        if (!useless_type_conversion_p(TREE_TYPE(p), type) &&
            !useless_type_conversion_p(DECL_ARG_TYPE(p), type))
            return false;
    }
    tree result = gimple_call_lhs(call);
    return n == gimple_call_num_args(call) &&
           (!result || useless_type_conversion_p(TREE_TYPE(result), TREE_TYPE(DECL_RESULT(callee))));
}

/* The body to take the place of a call, or NULL. */
cgraph_node *body_of(gimple *stmt)
{
    tree callee = is_gimple_call(stmt) ? gimple_call_fndecl(stmt) : NULL_TREE;
    auto found = callee ? kept_bodies.find(DECL_UID(callee)) : kept_bodies.end();
    return found != kept_bodies.end() && fits(stmt, found->second->decl) &&
                   has_same_options(callee, current_function_decl)
               ? found->second
               : NULL;
}

/* Is there such a call? Where the counter cannot be in a register, calls stay. */
bool calls_bodies(function *fun)
{
    basic_block bb;
    FOR_EACH_BB_FN (bb, fun)
        for (gimple_stmt_iterator i = gsi_start_bb(bb); !gsi_end_p(i); gsi_next(&i))
            if (body_of(gsi_stmt(i)))
                return count_is_in_register(fun);
    return false;
}

unsigned inline_bodies(function *fun)
{
    cgraph_node *node = cgraph_node::get(fun->decl);
    cgraph_edge::rebuild_edges();
    for (cgraph_edge *e = node->callees; e; e = e->next_callee)
        if (cgraph_node *body = body_of(e->call_stmt)) {
            e->redirect_callee(body->create_clone(body->decl, e->count, false, vNULL, false, node, NULL));
            e->inline_failed = CIF_OK;
        }
    unsigned todo = optimize_inline_calls(fun->decl);
    drop_calls(node);
    update_ssa(TODO_update_ssa);
    counter_flow_clean(fun, count_counter(), count_needs_counter);
    return todo;
}

/* Gives back the bodies of which no caller is left. */
void drop_bodies()
{
    for (auto i = kept_bodies.begin(); i != kept_bodies.end();) {
        cgraph_node *of = cgraph_node::get(DECL_ABSTRACT_ORIGIN(i->second->decl));
        bool dropped = !of || !of->callers;
        if (dropped)
            i->second->remove();
        i = dropped ? kept_bodies.erase(i) : std::next(i);
    }
}

/* --- the passes ----------------------------------------------------------------------------------------- */

const pass_data inline_data = {
    GIMPLE_PASS, "late_inline", OPTGROUP_INLINE, TV_NONE, PROP_cfg | PROP_ssa, 0, 0, 0, 0,
};

class inline_pass : public gimple_opt_pass
{
  public:
    explicit inline_pass(gcc::context *context) : gimple_opt_pass(inline_data, context) {}
    bool gate(function *fun) override { return calls_bodies(fun); }
    unsigned int execute(function *fun) override { return inline_bodies(fun); }
};

const pass_data keep_data = {
    GIMPLE_PASS, "keep_body", OPTGROUP_INLINE, TV_NONE, PROP_cfg | PROP_ssa, 0, 0, 0, 0,
};

class keep_pass : public gimple_opt_pass
{
  public:
    explicit keep_pass(gcc::context *context) : gimple_opt_pass(keep_data, context) {}
    unsigned int execute(function *fun) override
    {
        drop_bodies();
        if (is_wanted(fun))
            keep_body(fun);
        return 0;
    }
};
} // namespace

void late_inline_register(const char *plugin, const char *before)
{
    register_pass_info into = {new inline_pass(g), before, 1, PASS_POS_INSERT_BEFORE};
    register_callback(plugin, PLUGIN_PASS_MANAGER_SETUP, NULL, &into);
    register_pass_info keep = {new keep_pass(g), before, 1, PASS_POS_INSERT_BEFORE};
    register_callback(plugin, PLUGIN_PASS_MANAGER_SETUP, NULL, &keep);
}
