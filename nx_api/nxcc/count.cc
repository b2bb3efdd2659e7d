/* count.cc - the pass that makes a program count its own cost: image.h says what it counts into.
 *
 * A function's blocks are cut into stretches at the calls that may look at the counter. A stretch pays its
 * cost in one subtraction where it begins:
 *
 *     block:  left -= cost
 *             if (left < 0) preempt        only where a cycle of blocks closes, and where a function begins
 *             ...
 *             counter = left               the call sees all that was spent before it
 *             call
 *             left = counter
 *             left -= cost of the next stretch
 *             ...
 *
 * `left` is a register variable of the function; GCC's SSA updating turns it into SSA names. A function with
 * edges that no register survives in good order (setjmp, computed goto, nonlocal goto) counts in memory
 * instead: same places, same costs. The pass stands last before the expansion to machine code, so that what
 * it counts is what is left to execute.
 *
 * Loops whose rounds are known before they run are paid for there: prepay.h. Small functions may be paid for by those who
 * call them: leaves.h. Checks tell how long the program will make no call: promise.h.
 *
 * preempt is inline assembly, not a call, and its target saves every register: to the register allocator a
 * check is a branch over nothing, and a leaf function stays a leaf.
 */
#include "gcc.h"
#include "amount.h"
#include "cache.h"
#include "costs.h"
#include "count.h"
#include "../contract/program_image.h"
#include "leaves.h"
#include "poll.h"
#include "prepay.h"
#include "profile.h"
#include "promise.h"
#include "purity.h"
#include "variable.h"
#include <memory>

#define COUNTER "nxc_left"
#define QUIET "nxc_quiet"
#define PREEMPT "nxc_enter" /* runtime.c */

/* A library call that is known to cost more is checked for, and interrupted at such intervals: 10 us of a 40 MHz processor. */
const int64_t longest_amount = 400 * NXC_UNITS_PER_CLOCK;

bool count_in_memory;

namespace
{
tree counter, quiet; /* the variables nxc_left and nxc_quiet of runtime.c */

/* Where a check is to go: behind a statement that pays, if value is then negative. What a long library call costs may be
 * spent in parts, so that nothing that is due has to wait for all of it. */
struct check {
    gimple *after;
    tree value;
    bool in_parts;
    const promise *promised; /* NULL: nothing */
    int64_t paid;            /* of it */
};

/* What a stretch costs, and of whom. */
struct stretch {
    int64_t cost = 0;
    profile_shares shares; /* only with a profile */

    void add(const stretch &s, int64_t times)
    {
        cost += s.cost * times;
        for (auto &share : s.shares)
            shares[share.first] += share.second * times;
    }
};

class counting
{
  public:
    explicit counting(function *f) : fun(f) {}
    void run();

  private:
    void look_at_function();
    void count_block(basic_block bb);
    gimple *hand_over(gcall *call);
    void pay_misses(gimple *stmt);
    void pay_misses_of(basic_block bb);
    void pay_argument(gcall *call);
    gimple *pay_result(gcall *call, gimple *behind);
    void pay(basic_block bb, gimple *behind, const stretch &s);
    void pay_ahead(const prepaid_loop &loop);
    void give_promise(gimple_seq *seq, check *c, basic_block bb, int64_t cost);
    void spend(stretch *s, gimple *stmt);
    void spend_leaf(stretch *s, gimple *stmt);
    void find_idle_loops();
    bool costs_nothing(basic_block bb);
    void spend_going_back(stretch *s, basic_block bb);
    check subtract(gimple_seq *seq, tree amount);
    check charge(gimple_seq *seq, gimple *stmt, tree amount);
    void charge_call(gimple_seq *seq, gcall *call, tree amount);
    void store(gimple_seq *seq, tree value);
    void load_on_entry();
    void store_on_exit();
    void preempt(gimple_seq *seq);
    void preempt_in_time(gimple_seq *seq);
    void insert_check(const check &c);

    function *fun;
    tree left = NULL_TREE;              /* the register, or NULL: count in memory */
    bool calls = false;                 /* others, so that it may be part of a recursion */
    std::unique_ptr<profiling> profile; /* NULL: none is wanted */
    auto_bitmap checked;                /* blocks that check: the heads of cycles, and the first */
    auto_bitmap idle;                   /* of these, the heads of cycles that cost nothing otherwise */
    prepaid ahead;                      /* loops paid for where they are entered */
    std::map<basic_block, promise> promises;
    std::set<basic_block> paid; /* their blocks that pay nothing themselves */
    auto_vec<check> checks;
};

tree units_constant(int64_t units)
{
    return build_int_cst(units_type(), units);
}

bool is_loud(gcall *call)
{
    return call && !costs_call_is_quiet(call);
}

/* May it look at the counter, or change it? */
bool looks(gimple *stmt)
{
    return is_loud(dyn_cast<gcall *>(stmt)) && !leaves_is_call(stmt);
}

void counting::look_at_function()
{
    bool in_memory = count_in_memory || fun->calls_setjmp || fun->has_nonlocal_label;
    basic_block bb;
    FOR_EACH_BB_FN (bb, fun) {
        edge e;
        edge_iterator ei;
        FOR_EACH_EDGE (e, ei, bb->succs)
            in_memory = in_memory || (e->flags & (EDGE_ABNORMAL | EDGE_EH));
        for (gimple_stmt_iterator gsi = gsi_start_bb(bb); !gsi_end_p(gsi); gsi_next(&gsi))
            if (gcall *call = dyn_cast<gcall *>(gsi_stmt(gsi))) {
                calls = calls || is_loud(call);
                leaves_see_call(call);
            }
    }
    if (!in_memory)
        left = create_tmp_reg(units_type(), "left");
}

/* Appends counter -= amount. The result names the last statement and where the new value is. */
check counting::subtract(gimple_seq *seq, tree amount)
{
    if (left) {
        gimple *sub = TREE_CODE(amount) == INTEGER_CST
                          ? gimple_build_assign(left, PLUS_EXPR, left, units_constant(-tree_to_shwi(amount)))
                          : gimple_build_assign(left, MINUS_EXPR, left, amount);
        gimple_seq_add_stmt_without_update(seq, sub);
        return {sub, left, false, NULL, 0};
    }
    tree was = make_ssa_name(units_type());
    tree is = make_ssa_name(units_type());
    gimple *store = gimple_build_assign(counter, is);
    gimple_seq_add_stmt_without_update(seq, gimple_build_assign(was, counter));
    gimple_seq_add_stmt_without_update(seq, gimple_build_assign(is, MINUS_EXPR, was, amount));
    gimple_seq_add_stmt_without_update(seq, store);
    return {store, is, false, NULL, 0};
}

/* The same on behalf of a statement. */
check counting::charge(gimple_seq *seq, gimple *stmt, tree amount)
{
    check paid = subtract(seq, amount);
    if (profile)
        profile->add(seq, gimple_bb(stmt), profile->cell_of(stmt), amount);
    paid.after = gimple_seq_last_stmt(*seq);
    return paid;
}

/* The same for the part of a library call's cost that depends on its arguments or result. */
void counting::charge_call(gimple_seq *seq, gcall *call, tree amount)
{
    check paid = charge(seq, call, amount);
    paid.in_parts = true;
    if (TREE_CODE(amount) == INTEGER_CST && tree_to_shwi(amount) > longest_amount)
        checks.safe_push(paid);
}

/* Appends counter = value: somebody else may look at it now. */
void counting::store(gimple_seq *seq, tree value)
{
    if (profile && left)
        profile->give_away(seq, counter, value);
    gimple_seq_add_stmt_without_update(seq, gimple_build_assign(counter, value));
}

/* Adds the fixed cost of stmt to a stretch. */
void counting::spend(stretch *s, gimple *stmt)
{
    int64_t cost = ahead.own.count(stmt) ? 0 : costs_of(stmt);
    s->cost += cost;
    if (profile && cost)
        s->shares[profile->cell_of(stmt)] += cost;
}

/* Adds what the function costs that stmt calls, if it leaves that to us. */
void counting::spend_leaf(stretch *s, gimple *stmt)
{
    int64_t cost = leaves_cost(stmt);
    s->cost += cost;
    if (profile && cost)
        s->shares[profile->cell_of_leaf(gimple_call_fndecl(stmt))] += cost;
}

bool counting::costs_nothing(basic_block bb)
{
    for (gimple_stmt_iterator gsi = gsi_start_bb(bb); !gsi_end_p(gsi); gsi_next(&gsi))
        if (costs_of(gsi_stmt(gsi)) || leaves_cost(gsi_stmt(gsi)) || looks(gsi_stmt(gsi)))
            return false;
    return true;
}

/* In an endless loop without any work, such as for (;;); time has to go by, too, or nobody could stop it. */
void counting::find_idle_loops()
{
    auto_bitmap costless;
    basic_block bb;
    FOR_EACH_BB_FN (bb, fun)
        if (costs_nothing(bb))
            bitmap_set_bit(costless, bb->index);
    FOR_EACH_BB_FN (bb, fun) {
        if (!bitmap_bit_p(checked, bb->index) || !bitmap_bit_p(costless, bb->index))
            continue;
        auto_bitmap seen;
        std::vector<basic_block> ways{bb};
        while (!ways.empty() && !bitmap_bit_p(idle, bb->index)) {
            basic_block from = ways.back();
            ways.pop_back();
            edge e;
            edge_iterator ei;
            FOR_EACH_EDGE (e, ei, from->succs) {
                if (e->dest == bb)
                    bitmap_set_bit(idle, bb->index);
                else if (bitmap_bit_p(costless, e->dest->index) && bitmap_set_bit(seen, e->dest->index))
                    ways.push_back(e->dest);
            }
        }
    }
}

/* Where the source has a loop whose head has no statement. */
location_t location_of(basic_block bb)
{
    for (gimple_stmt_iterator gsi = gsi_start_bb(bb); !gsi_end_p(gsi); gsi_next(&gsi))
        if (gimple_has_location(gsi_stmt(gsi)))
            return gimple_location(gsi_stmt(gsi));
    edge e;
    edge_iterator ei;
    FOR_EACH_EDGE (e, ei, bb->preds)
        if (e->goto_locus != UNKNOWN_LOCATION)
            return e->goto_locus;
    return UNKNOWN_LOCATION;
}

/* The block gets a statement that does nothing and costs it: then it has a place in the source. */
void counting::spend_going_back(stretch *s, basic_block bb)
{
    gimple *nop = gimple_build_nop();
    gimple_set_location(nop, location_of(bb));
    gimple_stmt_iterator gsi = gsi_after_labels(bb);
    gsi_insert_before(&gsi, nop, GSI_SAME_STMT);
    int64_t cost = costs_of_going_back(nop);
    s->cost += cost;
    if (profile)
        s->shares[profile->cell_of(nop)] += cost;
}

/* A check where bb begins, of which `cost` has been paid, tells what is promised there; for those that are called soon it is
 * told at once. */
void counting::give_promise(gimple_seq *seq, check *c, basic_block bb, int64_t cost)
{
    auto found = promises.find(bb);
    if (found == promises.end())
        return;
    c->promised = &found->second;
    c->paid = cost;
    if (found->second.for_others)
        promise_append(seq, found->second, cost, quiet, left);
}

/* Pays for the stretch that begins behind a statement, or with the block if behind is NULL: there the check
 * is. */
void counting::pay(basic_block bb, gimple *behind, const stretch &s)
{
    bool check_here = !behind && bitmap_bit_p(checked, bb->index);
    if (!s.cost && !check_here)
        return;
    gimple_seq seq = NULL;
    check paid = subtract(&seq, units_constant(s.cost));
    for (auto &share : s.shares)
        profile->add(&seq, bb, share.first, units_constant(share.second));
    if (check_here) {
        give_promise(&seq, &paid, bb, s.cost);
        checks.safe_push(paid);
    }
    if (behind) {
        gimple_stmt_iterator gsi = gsi_for_stmt(behind);
        gsi_insert_seq_after(&gsi, seq, GSI_SAME_STMT);
    } else {
        gimple_stmt_iterator gsi = gsi_after_labels(bb);
        gsi_insert_seq_before(&gsi, seq, GSI_SAME_STMT);
    }
}

/* Only with a simulated cache. */
void counting::pay_misses(gimple *stmt)
{
    auto_vec<tree> misses;
    cache_look_up(stmt, profile ? NULL_TREE : left, misses);
    if (misses.is_empty())
        return;
    gimple_seq seq = NULL;
    for (tree units : misses)
        charge(&seq, stmt, units);
    gimple_stmt_iterator gsi = gsi_for_stmt(stmt);
    gsi_insert_seq_before(&gsi, seq, GSI_SAME_STMT);
}

void counting::pay_argument(gcall *call)
{
    const std::vector<int> *of = nullptr;
    bool elements;
    int64_t per = costs_of_call(call, &of, &elements);
    if (!per || of->at(0) == 0)
        return;
    gimple_seq seq = NULL;
    if (tree amount = amount_append(&seq, call, per, *of, elements))
        charge_call(&seq, call, amount);
    gimple_stmt_iterator gsi = gsi_for_stmt(call);
    gsi_insert_seq_before(&gsi, seq, GSI_SAME_STMT);
}

/* Returns the last statement it put behind the given one. */
gimple *counting::pay_result(gcall *call, gimple *behind)
{
    const std::vector<int> *of = nullptr;
    bool elements;
    int64_t per = costs_of_call(call, &of, &elements);
    if (!per || of->at(0) != 0)
        return behind;
    tree type = gimple_call_return_type(call);
    if (!INTEGRAL_TYPE_P(type))
        return behind;
    if (!gimple_call_lhs(call)) {
        gimple_call_set_lhs(call, make_ssa_name(type, call));
        update_stmt(call);
    }
    if (!is_gimple_reg(gimple_call_lhs(call)))
        return behind;
    gimple_call_set_tail(call, false); /* there is something left to do after it */
    gimple_seq seq = NULL;
    charge_call(&seq, call, amount_append(&seq, call, per, *of, elements));
    gimple *last = gimple_seq_last_stmt(seq);
    gimple_stmt_iterator gsi = gsi_for_stmt(behind);
    gsi_insert_seq_after(&gsi, seq, GSI_SAME_STMT);
    return last;
}

/* Lets a call see the counter and takes over what it left. Returns the last statement that belongs to the
 * call. A call marked as a tail call may stay one: if GCC makes it a jump, what follows it is dropped, and
 * rightly so, because the callee leaves the counter where this function's caller looks for it. */
gimple *counting::hand_over(gcall *call)
{
    if (!left)
        return call;
    gimple_stmt_iterator gsi = gsi_for_stmt(call);
    gimple_seq seq = NULL;
    store(&seq, left);
    gsi_insert_seq_before(&gsi, seq, GSI_SAME_STMT);
    if (stmt_ends_bb_p(call))
        return call;
    gimple *reload = gimple_build_assign(left, counter);
    gsi_insert_after(&gsi, reload, GSI_SAME_STMT);
    return reload;
}

/* Appends rounds * each + last. */
tree append_rounds(gimple_seq *seq, const prepaid_loop &loop, int64_t each, int64_t last)
{
    tree sum = gimple_build(seq, MULT_EXPR, units_type(), loop.rounds, units_constant(each));
    return gimple_build(seq, PLUS_EXPR, units_type(), sum, units_constant(last));
}

/* Where a loop is entered: pays for the blocks that all rounds run, if the dearest rounds could be paid. */
void counting::pay_ahead(const prepaid_loop &loop)
{
    stretch each, last;
    for (const prepaid_block &b : loop.blocks) {
        stretch once;
        for (gimple_stmt_iterator gsi = gsi_start_bb(b.bb); !gsi_end_p(gsi); gsi_next(&gsi)) {
            spend(&once, gsi_stmt(gsi));
            spend_leaf(&once, gsi_stmt(gsi));
        }
        each.add(once, b.each);
        last.add(once, b.last);
    }
    gimple_seq seq = NULL;
    tree rest = make_ssa_name(units_type());
    tree need = append_rounds(&seq, loop, loop.most, loop.most);
    gimple_seq_add_stmt_without_update(&seq, gimple_build_assign(rest, MINUS_EXPR, left, need));
    gimple_cond_set_condition(loop.test, GE_EXPR, rest, units_constant(0));
    update_stmt(loop.test);
    gimple_stmt_iterator gsi = gsi_for_stmt(loop.test);
    gsi_insert_seq_before(&gsi, seq, GSI_SAME_STMT);

    seq = NULL;
    if (each.cost == loop.most && last.cost == loop.most)
        gimple_seq_add_stmt_without_update(&seq, gimple_build_assign(left, rest));
    else
        subtract(&seq, append_rounds(&seq, loop, each.cost, last.cost));
    for (auto &share : each.shares)
        profile->add(&seq, loop.first, share.first,
                     append_rounds(&seq, loop, share.second, last.shares[share.first]));
    gsi = gsi_after_labels(loop.first);
    gsi_insert_seq_before(&gsi, seq, GSI_SAME_STMT);
}

/* Of a block that has been paid for ahead. */
void counting::pay_misses_of(basic_block bb)
{
    auto_vec<gimple *> statements;
    for (gimple_stmt_iterator gsi = gsi_after_labels(bb); !gsi_end_p(gsi); gsi_next(&gsi))
        statements.safe_push(gsi_stmt(gsi));
    cache_forget();
    for (gimple *stmt : statements)
        pay_misses(stmt);
}

void counting::count_block(basic_block bb)
{
    if (paid.count(bb))
        return;
    auto_vec<gimple *> statements;
    for (gimple_stmt_iterator gsi = gsi_after_labels(bb); !gsi_end_p(gsi); gsi_next(&gsi))
        statements.safe_push(gsi_stmt(gsi));
    stretch now;
    gimple *behind = NULL;
    unsigned i;
    gimple *stmt;
    cache_forget();
    if (bitmap_bit_p(idle, bb->index))
        spend_going_back(&now, bb);
    FOR_EACH_VEC_ELT (statements, i, stmt) {
        spend(&now, stmt);
        pay_misses(stmt);
        gcall *call = dyn_cast<gcall *>(stmt);
        if (!call)
            continue;
        pay_argument(call);
        gimple *last = call;
        if (is_loud(call))
            purity_forget(call);
        if (leaves_is_call(call) && !behind && bitmap_bit_p(checked, bb->index)) { /* paid behind the check */
            pay(bb, behind, now);
            now = stretch();
            behind = call;
        }
        spend_leaf(&now, call);
        if (looks(call)) {
            pay(bb, behind, now);
            now = stretch();
            behind = last = hand_over(call);
        } else {
            gimple_call_set_tail(call, false); /* the store at the function's end must come after it */
        }
        if (!stmt_ends_bb_p(call))
            last = pay_result(call, last);
        if (behind && looks(call))
            behind = last;
    }
    if (!behind || !stmt_ends_bb_p(behind))
        pay(bb, behind, now);
}

void counting::load_on_entry()
{
    edge entry = single_succ_edge(ENTRY_BLOCK_PTR_FOR_FN(fun));
    gsi_insert_on_edge_immediate(entry, gimple_build_assign(left, counter));
}

void counting::store_on_exit()
{
    edge e;
    edge_iterator ei;
    FOR_EACH_EDGE (e, ei, EXIT_BLOCK_PTR_FOR_FN(fun)->preds) {
        gimple_stmt_iterator gsi = gsi_last_nondebug_bb(e->src);
        if (gsi_end_p(gsi) || gimple_code(gsi_stmt(gsi)) != GIMPLE_RETURN)
            continue;
        gimple_seq seq = NULL;
        store(&seq, left);
        gsi_insert_seq_before(&gsi, seq, GSI_SAME_STMT);
    }
}

/* Appends the call of the simulator. It saves all but what is in x87 registers (long double): whoever has anything there puts
 * it elsewhere meanwhile, for to ask whether there is any takes longer than all the rest. */
void append_preemption(gimple_seq *seq)
{
    static const char *const names[] = {"memory", "st",    "st(1)", "st(2)", "st(3)",
                                        "st(4)",  "st(5)", "st(6)", "st(7)"};
    vec<tree, va_gc> *clobbers = NULL;
    for (const char *name : names)
        vec_safe_push(clobbers, build_tree_list(NULL_TREE, build_string((int)strlen(name), name)));
    gasm *call = gimple_build_asm_vec("call\t" PREEMPT, NULL, NULL, clobbers, NULL);
    gimple_asm_set_volatile(call, true);
    gimple_seq_add_stmt_without_update(seq, call);
}

/* Appends a preemption, with left as it is. */
void counting::preempt(gimple_seq *seq)
{
    if (left)
        store(seq, left);
    append_preemption(seq);
    if (left)
        gimple_seq_add_stmt_without_update(seq, gimple_build_assign(left, counter));
}

/* Appends a preemption at the end of the part of a library call in which left became negative; parts end at multiples of
 * longest_amount before the call's end. What is behind that part is spent after it. */
void counting::preempt_in_time(gimple_seq *seq)
{
    auto append = [seq](tree_code code, tree a, tree b) {
        tree result = make_ssa_name(units_type());
        gimple_seq_add_stmt_without_update(seq, gimple_build_assign(result, code, a, b));
        return result;
    };
    tree was = left, now = make_ssa_name(units_type());
    if (!left) {
        was = make_ssa_name(units_type());
        gimple_seq_add_stmt_without_update(seq, gimple_build_assign(was, counter));
    }
    tree beyond = append(MINUS_EXPR, units_constant(-1), was); /* spent since left was -1 */
    tree in_part = append(TRUNC_MOD_EXPR, beyond, units_constant(longest_amount));
    tree behind = append(MINUS_EXPR, beyond, in_part);
    store(seq, append(PLUS_EXPR, was, behind));
    append_preemption(seq);
    gimple_seq_add_stmt_without_update(seq, gimple_build_assign(now, counter));
    tree is = left ? left : make_ssa_name(units_type());
    gimple_seq_add_stmt_without_update(seq, gimple_build_assign(is, MINUS_EXPR, now, behind));
    if (!left)
        gimple_seq_add_stmt_without_update(seq, gimple_build_assign(counter, is));
}

/* Cuts the block behind c.after and puts the way to the simulator beside it. It leads back to the check if there are
 * parts. */
void counting::insert_check(const check &c)
{
    basic_block bb = gimple_bb(c.after);
    edge on = split_block(bb, c.after);
    if (c.in_parts) {
        bb = split_edge(on);
        on = single_succ_edge(bb);
    }
    basic_block rest = on->dest;
    basic_block cold = create_empty_bb(bb);
    if (current_loops)
        add_bb_to_loop(cold, bb->loop_father);
    gimple_stmt_iterator gsi = gsi_last_bb(bb);
    tree value = c.value;
    if (c.in_parts && !left) {
        value = make_ssa_name(units_type());
        gsi_insert_after(&gsi, gimple_build_assign(value, counter), GSI_NEW_STMT);
    }
    gsi_insert_after(&gsi, gimple_build_cond(LT_EXPR, value, units_constant(0), NULL_TREE, NULL_TREE),
                     GSI_NEW_STMT);
    on->flags = EDGE_FALSE_VALUE;
    on->probability = profile_probability::very_likely();
    edge out = make_edge(bb, cold, EDGE_TRUE_VALUE);
    out->probability = profile_probability::very_unlikely();
    cold->count = out->count();
    make_single_succ_edge(cold, c.in_parts ? bb : rest, EDGE_FALLTHRU);

    gimple_seq seq = NULL;
    location_t where = location_of(bb);
    if (profile)
        profile->flush(&seq, bb);
    if (c.promised)
        promise_append(&seq, *c.promised, c.paid, quiet, left);
    if (c.in_parts)
        preempt_in_time(&seq);
    else
        preempt(&seq);
    for (gimple_stmt_iterator i = gsi_start(seq); !gsi_end_p(i); gsi_next(&i))
        gimple_set_location(gsi_stmt(i), where);
    gsi = gsi_start_bb(cold);
    gsi_insert_seq_before(&gsi, seq, GSI_SAME_STMT);
}

void counting::run()
{
    look_at_function();
    bool foresees = left && optimize;
    if (foresees && !calls && !cache_is_simulated() && leaves_accept(fun))
        return;
    poll_mark(fun, calls, checked);
    find_idle_loops();
    if (foresees) {
        ahead = prepay_loops(looks, checked);
        promises = promise_find(checked, ahead.slow, ahead.own);
    }
    if (profile_on)
        profile = std::make_unique<profiling>(fun, !left, looks);
    for (const prepaid_loop &loop : ahead.loops)
        for (const prepaid_block &b : loop.blocks)
            paid.insert(b.bb);
    basic_block bb;
    FOR_EACH_BB_FN (bb, fun)
        count_block(bb);
    for (const prepaid_loop &loop : ahead.loops)
        pay_ahead(loop);
    for (const prepaid_loop &loop : ahead.loops)
        for (const prepaid_block &b : loop.blocks)
            pay_misses_of(b.bb);
    if (left) {
        load_on_entry();
        store_on_exit();
    }
    if (profile)
        profile->finish();
    unsigned i;
    check *c;
    FOR_EACH_VEC_ELT (checks, i, c)
        insert_check(*c);
    if (current_loops)
        loops_state_set(LOOPS_NEED_FIXUP); /* a call's parts are one */
    free_dominance_info(CDI_DOMINATORS);
    free_dominance_info(CDI_POST_DOMINATORS);
}

const pass_data count_data = {
    GIMPLE_PASS, "count", OPTGROUP_NONE, TV_NONE, PROP_cfg | PROP_ssa, 0, 0, 0, TODO_update_ssa,
};

class count_pass : public gimple_opt_pass
{
  public:
    explicit count_pass(gcc::context *context) : gimple_opt_pass(count_data, context) {}
    opt_pass *clone() override { return new count_pass(m_ctxt); }
    unsigned int execute(function *f) override
    {
        if (!counter) {
            counter = variable_declare(COUNTER, units_type());
            quiet = variable_declare(QUIET, units_type());
        }
        costs_warn_if_taken_for_library(f->decl);
        counting(f).run();
        return 0;
    }
};
} // namespace

opt_pass *count_make_pass()
{
    return new count_pass(g);
}
