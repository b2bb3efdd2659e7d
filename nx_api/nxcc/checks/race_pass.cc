/* race_pass.cc - see race_pass.h. */
#include "checks/race_pass.h"
#include "checks/asan_code.h"
#include "checks/asan_locals.h"
#include "base/costs.h"
#include "checks/race_address.h"
#include "checks/race_code.h"
#include "checks/race_library.h"
#include "checks/race_loops.h"
#include "checks/race_names.h"
#include "checks/race_reach.h"
#include "runtime/race_runtime.h"
#include "checks/race_sites.h"
#include "checks/race_spin.h"
#include "checks/race_written.h"
#include "../contract/races.h"
#include <string>
#include <vector>

namespace
{
struct access {
    tree ref;
    bool write;
};

/* What has been told on the way to a statement. */
typedef std::vector<access> told_list;

class telling
{
  public:
    explicit telling(function *f) : fun(f) {}
    virtual ~telling() {}
    void run();

  protected:
    void tell_blocks();
    virtual void tell(gimple *stmt, tree ref, bool write, told_list &told);
    /* Is a library function's access through a pointer told? */
    virtual bool concerns(tree pointer) const { return race_reach_behind(pointer); }
    virtual void list_given(gcall *call);

    function *fun;

  private:
    void find_ranges();
    void tell_ranges();
    void tell_block(basic_block bb);
    void tell_statement(gimple *stmt, told_list &told);
    void tell_call(gcall *call, told_list &told);
    void tell_argument(gcall *call, const race_argument &a);

    std::set<gimple *> spins;
    std::vector<race_loop_access> ranges;
    std::set<std::pair<gimple *, bool>>
        in_ranges;                        /* the accesses of them, by statement and whether it writes */
    std::map<int, told_list> told_at_end; /* of blocks, by index */
};

/* The bytes that an access concerns: they begin `shift` bytes behind an object that has an address. */
struct extent {
    tree object;
    int shift;
    tree bytes; /* constant or not; NULL: not known */
};

/* A bit-field is read with the bytes that it touches, and written with its whole storage unit. */
extent extent_of_bit_field(tree ref, bool write)
{
    tree field = TREE_OPERAND(ref, 1), unit = DECL_BIT_FIELD_REPRESENTATIVE(field);
    if (write && unit)
        field = unit;
    HOST_WIDE_INT first = int_bit_position(field);
    HOST_WIDE_INT bytes =
        (first + tree_to_shwi(DECL_SIZE(field)) + BITS_PER_UNIT - 1) / BITS_PER_UNIT - first / BITS_PER_UNIT;
    return {TREE_OPERAND(ref, 0), (int)(first / BITS_PER_UNIT), size_int(bytes)};
}

/* A part of a complex number is told as the number. */
extent extent_of(tree ref, bool write)
{
    while (handled_component_p(ref) && TREE_CODE(ref) != COMPONENT_REF && TREE_CODE(ref) != ARRAY_REF)
        ref = TREE_OPERAND(ref, 0);
    if (TREE_CODE(ref) == COMPONENT_REF && DECL_BIT_FIELD(TREE_OPERAND(ref, 1)))
        return extent_of_bit_field(ref, write);
    return {ref, 0, TYPE_SIZE_UNIT(TREE_TYPE(ref))};
}

bool has_been_told(const told_list &told, tree ref, bool write)
{
    for (const access &a : told)
        if ((a.write || !write) && operand_equal_p(a.ref, ref, 0))
            return true;
    return false;
}

/* May others run, or may what GCC knows of addresses change, at a statement? */
bool ends_what_is_told(gimple *stmt)
{
    gcall *call = dyn_cast<gcall *>(stmt);
    return gimple_code(stmt) == GIMPLE_ASM || (call && !costs_call_is_uncounted(call));
}

const unsigned most_bytes = 0xffff; /* of struct nxc_race_site.bytes */

gimple_stmt_iterator insert(gimple_stmt_iterator gsi, gimple *stmt, gasm *code, bool after)
{
    gimple_set_location(code, gimple_location(stmt));
    if (after)
        gsi_insert_after(&gsi, code, GSI_NEW_STMT);
    else
        gsi_insert_before(&gsi, code, GSI_SAME_STMT);
    return gsi;
}

void insert_access(gimple *stmt, const extent &e, const std::string &name, unsigned flags)
{
    unsigned bytes = (unsigned)tree_to_uhwi(e.bytes);
    insert(gsi_for_stmt(stmt), stmt, race_code_access(e.object, e.shift, race_site(stmt, name, bytes, flags)),
           false);
}

/* For objects of 64 KB and more. */
void insert_large_access(gimple *stmt, const extent &e, const std::string &name, unsigned flags)
{
    gimple_stmt_iterator gsi = gsi_for_stmt(stmt);
    tree address = force_gimple_operand_gsi(&gsi, build_fold_addr_expr(unshare_expr(e.object)), true,
                                            NULL_TREE, true, GSI_SAME_STMT);
    insert(gsi, stmt, race_code_range(address, e.bytes, race_site(stmt, name, 0, flags)), false);
}

unsigned flags_of(gimple *stmt, bool write)
{
    return (write ? NXC_RACE_WRITE : 0) | (race_site_is_ignored(stmt) ? NXC_RACE_IGNORE : 0);
}

void telling::tell(gimple *stmt, tree ref, bool write, told_list &told)
{
    if (in_ranges.count({stmt, write}) || !race_reach(ref) || has_been_told(told, ref, write))
        return;
    extent e = extent_of(ref, write);
    if (!e.bytes || !tree_fits_uhwi_p(e.bytes) || integer_zerop(e.bytes))
        return;
    unsigned flags = flags_of(stmt, write) | (TREE_THIS_VOLATILE(ref) ? NXC_RACE_VOLATILE : 0) |
                     (!write && spins.count(stmt) ? NXC_RACE_SPIN : 0);
    if (!(flags & (NXC_RACE_IGNORE | NXC_RACE_SPIN))) /* these do not stand for others */
        told.push_back({ref, write});
    if (tree_to_uhwi(e.bytes) <= most_bytes)
        insert_access(stmt, e, race_name(stmt, ref, write), flags);
    else if (TREE_CODE(get_base_address(e.object)) != TARGET_MEM_REF)
        insert_large_access(stmt, e, race_name(stmt, ref, write), flags);
}

/* Appends the product of a call's arguments. */
tree append_product(gimple_seq *seq, gcall *call, const race_argument &a)
{
    tree bytes = size_int(a.times);
    for (int i : {a.first, a.second})
        if (i >= 0)
            bytes = gimple_build(seq, MULT_EXPR, size_type_node, bytes,
                                 gimple_convert(seq, size_type_node, gimple_call_arg(call, i)));
    return bytes;
}

/* Appends the number of bytes of a range, as race_runtime.h has it. NULL: not known. */
tree append_bytes(gimple_seq *seq, gcall *call, const race_argument &a)
{
    switch (a.extent) {
    case RACE_BYTES:
        return append_product(seq, call, a);
    case RACE_STRING:
        if (a.first < 0)
            return build_int_cst(ssizetype, NXC_RACE_STRING);
        return gimple_build(seq, BIT_IOR_EXPR, size_type_node, append_product(seq, call, a),
                            build_int_cst(size_type_node, NXC_RACE_PART));
    case RACE_ARRAY:
        return build_int_cst(ssizetype, NXC_RACE_ARRAY);
    default:
        return TYPE_SIZE_UNIT(TREE_TYPE(TREE_TYPE(gimple_call_arg(call, a.pointer))));
    }
}

/* Tells what a library function does through a pointer. */
void telling::tell_argument(gcall *call, const race_argument &a)
{
    tree pointer = gimple_call_arg(call, a.pointer);
    bool after = a.after && !stmt_ends_bb_p(call);
    if (a.extent != RACE_ARRAY && !concerns(pointer))
        return;
    gimple_seq seq = NULL;
    tree bytes = append_bytes(&seq, call, a);
    gimple_stmt_iterator gsi = gsi_for_stmt(call);
    gsi_insert_seq_before(&gsi, seq, GSI_SAME_STMT);
    if (!bytes || integer_zerop(bytes))
        return;
    pointer = force_gimple_operand_gsi(&gsi, unshare_expr(pointer), true, NULL_TREE, true, GSI_SAME_STMT);
    tree given = gimple_call_arg(call, a.pointer);
    std::string name = a.extent == RACE_ARRAY ? race_name_of_array(call, given) : race_name_behind(given);
    size_t site = race_site(call, name, 0, flags_of(call, a.write));
    insert(gsi, call, race_code_range(pointer, bytes, site), after);
}

/* Lists what a function of a library, as NX's, is given pointers to: buffers. */
void telling::list_given(gcall *call)
{
    tree function = gimple_call_fndecl(call);
    if (!function || !DECL_EXTERNAL(function) || DECL_STRUCT_FUNCTION(function))
        return;
    for (unsigned i = 0; i < gimple_call_num_args(call); i++) {
        tree given = gimple_call_arg(call, i);
        bool data =
            POINTER_TYPE_P(TREE_TYPE(given)) && TREE_CODE(TREE_TYPE(TREE_TYPE(given))) != FUNCTION_TYPE;
        std::string name = data && race_reach_behind(given) ? race_name_behind(given) : "";
        if (!name.empty())
            race_site(call, name, 0, NXC_RACE_GIVEN);
    }
}

void telling::tell_call(gcall *call, told_list &told)
{
    list_given(call);
    for (const race_argument &a : race_library_arguments(call))
        tell_argument(call, a);
    for (unsigned i = 0; i < gimple_call_num_args(call); i++)
        tell(call, gimple_call_arg(call, i), false, told);
    if (tree result = gimple_call_lhs(call))
        tell(call, result, true, told);
}

void telling::tell_statement(gimple *stmt, told_list &told)
{
    if (gcall *call = dyn_cast<gcall *>(stmt))
        tell_call(call, told);
    if (ends_what_is_told(stmt))
        told.clear();
    if (!is_gimple_assign(stmt) || gimple_clobber_p(stmt))
        return;
    if (gimple_assign_single_p(stmt))
        tell(stmt, gimple_assign_rhs1(stmt), false, told);
    tell(stmt, gimple_assign_lhs(stmt), true, told);
}

void telling::tell_block(basic_block bb)
{
    told_list told;
    if (single_pred_p(bb) && told_at_end.count(single_pred(bb)->index))
        told = told_at_end[single_pred(bb)->index];
    auto_vec<gimple *> statements;
    for (gimple_stmt_iterator gsi = gsi_start_nondebug_after_labels_bb(bb); !gsi_end_p(gsi);
         gsi_next_nondebug(&gsi))
        statements.safe_push(gsi_stmt(gsi));
    for (gimple *stmt : statements)
        tell_statement(stmt, told);
    told_at_end[bb->index] = told;
}

void prepare_loops()
{
    if (!current_loops)
        loop_optimizer_init(AVOID_CFG_MODIFICATIONS);
    else if (loops_state_satisfies_p(LOOPS_NEED_FIXUP))
        fix_loop_structure(NULL);
    calculate_dominance_info(CDI_DOMINATORS);
}

void telling::find_ranges()
{
    for (const race_loop_access &a : race_loops_find(fun)) {
        if (!a.write && spins.count(a.stmt))
            continue;
        ranges.push_back(a);
        in_ranges.insert({a.stmt, a.write});
    }
}

void telling::tell_ranges()
{
    for (const race_loop_access &a : ranges)
        race_loops_tell(a,
                        race_site(a.stmt, race_name(a.stmt, a.ref, a.write), 0, flags_of(a.stmt, a.write)));
    gsi_commit_edge_inserts();
}

void telling::tell_blocks()
{
    auto_vec<int> order;
    order.safe_grow(n_basic_blocks_for_fn(fun));
    int n = pre_and_rev_post_order_compute_fn(fun, NULL, order.address(), false);
    for (int i = 0; i < n; i++)
        tell_block(BASIC_BLOCK_FOR_FN(fun, order[i]));
}

void telling::run()
{
    prepare_loops();
    spins = race_spin_find(fun);
    if (optimize)
        find_ranges();
    tell_blocks();
    tell_ranges();
    free_dominance_info(CDI_DOMINATORS);
}

/* --- nxcc --asan --- */

class checking : public telling
{
  public:
    explicit checking(function *f) : telling(f) {}
    void run();

  private:
    void tell(gimple *stmt, tree ref, bool write, told_list &told) override;
    bool concerns(tree) const override { return true; }
    void list_given(gcall *) override {}
};

/* Does an access of a variable lie within it, whatever the program does? */
bool is_certain(tree ref, tree base)
{
    poly_int64 offset;
    int64_t at;
    tree size = DECL_SIZE_UNIT(base), bytes = TYPE_SIZE_UNIT(TREE_TYPE(ref));
    return size && bytes && tree_fits_shwi_p(size) && tree_fits_shwi_p(bytes) &&
           get_addr_base_and_unit_offset(ref, &offset) == base && offset.is_constant(&at) && at >= 0 &&
           at + tree_to_shwi(bytes) <= tree_to_shwi(size);
}

/* May a reference go outside of what it is written for? */
bool may_go_wrong(tree ref)
{
    tree base = costs_is_memory(ref) ? get_base_address(ref) : NULL_TREE;
    if (!base || race_reach_is_own(base))
        return false;
    if (DECL_P(base))
        return TREE_CODE(base) != CONST_DECL && !(VAR_P(base) && DECL_HARD_REGISTER(base)) &&
               !is_certain(ref, base);
    return TREE_CODE(base) == MEM_REF || TREE_CODE(base) == TARGET_MEM_REF;
}

void checking::tell(gimple *stmt, tree ref, bool write, told_list &told)
{
    if (!may_go_wrong(ref) || has_been_told(told, ref, write))
        return;
    extent e = extent_of(ref, write);
    if (!e.bytes || !tree_fits_uhwi_p(e.bytes) || integer_zerop(e.bytes))
        return;
    told.push_back({ref, write});
    std::string name = race_name(stmt, ref, write);
    unsigned bytes = (unsigned)tree_to_uhwi(e.bytes), flags = write ? NXC_RACE_WRITE : 0;
    if (tree_to_uhwi(e.bytes) > ASAN_MOST_BYTES)
        insert_large_access(stmt, e, name, flags);
    else
        insert(gsi_for_stmt(stmt), stmt,
               asan_code_access(e.object, e.shift, bytes, race_site(stmt, name, bytes, flags)), false);
}

/* Tells, where a goto out of a nested function comes to, that functions have been left. */
void tell_jumps(function *f)
{
    basic_block bb;
    FOR_EACH_BB_FN (bb, f) {
        gimple_stmt_iterator gsi = gsi_start_bb(bb);
        glabel *label = gsi_end_p(gsi) ? NULL : dyn_cast<glabel *>(gsi_stmt(gsi));
        if (!label || !DECL_NONLOCAL(gimple_label_label(label)))
            continue;
        gsi = gsi_after_labels(bb);
        gsi_insert_before(&gsi,
                          race_code_range(null_pointer_node, build_int_cst(ssizetype, NXC_RACE_JUMPED), 0),
                          GSI_SAME_STMT);
    }
}

/* Locals get their zones last: what is told makes some of them variables in memory. GCC would take the frame
 * from a function that calls nobody, and the stack of a report would lack the caller. GCC keeps the frame of
 * a function that may move its stack pointer. */
void checking::run()
{
    race_address_note();
    tell_blocks();
    tell_jumps(fun);
    asan_locals_protect(fun);
    fun->calls_alloca = 1;
}

const pass_data races_data = {
    GIMPLE_PASS, "races", OPTGROUP_NONE, TV_NONE, PROP_cfg | PROP_ssa, 0, 0, 0, TODO_update_ssa,
};

class races_pass : public gimple_opt_pass
{
  public:
    explicit races_pass(gcc::context *context) : gimple_opt_pass(races_data, context) {}
    opt_pass *clone() override { return new races_pass(m_ctxt); }
    unsigned int execute(function *f) override
    {
        telling(f).run();
        return 0;
    }
};

const pass_data asan_data = {
    GIMPLE_PASS, "nxcc-asan", OPTGROUP_NONE, TV_NONE, PROP_cfg | PROP_ssa, 0, 0, 0, TODO_update_ssa,
};

class asan_pass : public gimple_opt_pass
{
  public:
    explicit asan_pass(gcc::context *context) : gimple_opt_pass(asan_data, context) {}
    opt_pass *clone() override { return new asan_pass(m_ctxt); }
    unsigned int execute(function *f) override
    {
        checking(f).run();
        return 0;
    }
};
} // namespace

opt_pass *race_pass_make()
{
    return new races_pass(g);
}

opt_pass *race_pass_make_asan()
{
    return new asan_pass(g);
}
