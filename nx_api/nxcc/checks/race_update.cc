/* race_update.cc - see race_update.h. */
#include "checks/race_update.h"
#include "base/costs.h"
#include "checks/race_address.h"
#include "checks/race_code.h"
#include "checks/race_written.h"
#include "checks/race_reach.h"
#include "checks/race_sites.h"
#include "../contract/races.h"
#include <set>
#include <vector>

namespace
{
const unsigned largest_volatile = 8; /* larger ones are not accessed in one step */

bool is_volatile_word(tree ref)
{
    return costs_is_memory(ref) && TREE_THIS_VOLATILE(ref) && TYPE_SIZE_UNIT(TREE_TYPE(ref)) &&
           tree_fits_uhwi_p(TYPE_SIZE_UNIT(TREE_TYPE(ref))) &&
           tree_to_uhwi(TYPE_SIZE_UNIT(TREE_TYPE(ref))) <= largest_volatile && race_reach(ref);
}

/* Does a statement read the variable? (References to volatile variables are never equal to GCC, but their
 * addresses are.) */
bool reads(gimple *stmt, tree ref)
{
    return gimple_assign_load_p(stmt) && TREE_THIS_VOLATILE(gimple_assign_rhs1(stmt)) &&
           operand_equal_p(gimple_assign_rhs1(stmt), ref, OEP_ADDRESS_OF | OEP_MATCH_SIDE_EFFECTS);
}

/* The statements of the function that compute a value, and what they use: all that an SSA name is made of.
 * Loads and calls end the search. */
bool comes_from(tree value, tree ref)
{
    std::set<gimple *> seen;
    std::vector<tree> left = {value};
    while (!left.empty()) {
        tree name = left.back();
        left.pop_back();
        gimple *def = name && TREE_CODE(name) == SSA_NAME ? SSA_NAME_DEF_STMT(name) : NULL;
        if (!def || !seen.insert(def).second)
            continue;
        if (gphi *phi = dyn_cast<gphi *>(def))
            for (unsigned i = 0; i < gimple_phi_num_args(phi); i++)
                left.push_back(gimple_phi_arg_def(phi, i));
        if (is_gimple_assign(def) && reads(def, ref))
            return true;
        if (is_gimple_assign(def) && !gimple_assign_load_p(def))
            for (unsigned i = 1; i < gimple_num_ops(def); i++)
                left.push_back(gimple_op(def, i));
    }
    return false;
}

/* Tells of an update of a volatile variable. */
void tell(gimple *stmt)
{
    tree ref = gimple_assign_lhs(stmt);
    unsigned bytes = (unsigned)tree_to_uhwi(TYPE_SIZE_UNIT(TREE_TYPE(ref)));
    size_t site = race_site(stmt, race_name(stmt, ref, true), bytes, NXC_RACE_WRITE | NXC_RACE_UPDATE);
    gasm *code = race_code_access(ref, 0, site);
    gimple_set_location(code, gimple_location(stmt));
    gimple_stmt_iterator gsi = gsi_for_stmt(stmt);
    gsi_insert_before(&gsi, code, GSI_SAME_STMT);
}

/* A bit-field's address is none. */
bool is_update(gimple *stmt)
{
    if (!gimple_assign_single_p(stmt) || gimple_clobber_p(stmt))
        return false;
    tree ref = gimple_assign_lhs(stmt);
    return is_volatile_word(ref) &&
           !(TREE_CODE(ref) == COMPONENT_REF && DECL_BIT_FIELD(TREE_OPERAND(ref, 1))) &&
           TREE_CODE(ref) != BIT_FIELD_REF && comes_from(gimple_assign_rhs1(stmt), ref);
}

void tell_updates(function *fun)
{
    std::vector<gimple *> updates;
    basic_block bb;
    FOR_EACH_BB_FN (bb, fun)
        for (gimple_stmt_iterator gsi = gsi_start_nondebug_bb(bb); !gsi_end_p(gsi); gsi_next_nondebug(&gsi))
            if (is_update(gsi_stmt(gsi)))
                updates.push_back(gsi_stmt(gsi));
    for (gimple *stmt : updates)
        tell(stmt);
}

const pass_data updates_data = {
    GIMPLE_PASS, "race_updates", OPTGROUP_NONE, TV_NONE, PROP_cfg | PROP_ssa, 0, 0, 0, TODO_update_ssa,
};

class updates_pass : public gimple_opt_pass
{
  public:
    explicit updates_pass(gcc::context *context) : gimple_opt_pass(updates_data, context) {}
    opt_pass *clone() override { return new updates_pass(m_ctxt); }
    unsigned int execute(function *f) override
    {
        race_address_note(); /* this pass is the first that tells of anything */
        tell_updates(f);
        return 0;
    }
};
} // namespace

opt_pass *race_update_make_pass()
{
    return new updates_pass(g);
}
