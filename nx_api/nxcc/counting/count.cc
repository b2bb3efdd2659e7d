/* count.cc - the counting pass: it makes a program count its own cost into the counter of image.h.
 *
 * A *segment* is a part of a basic block between two calls that need the counter. Its cost is charged in one
 * subtraction where the segment begins. A *poll* is the comparison behind the charge: it gives control to the
 * simulator (*preempts* the program) if the counter is negative. Polls stand at the heads of loops, and where
 * functions begin.
 *
 *     block:  left -= cost
 *             if (left < 0) preempt        the poll
 *             ...
 *             counter = left               the callee finds all charged that was spent before
 *             call
 *             left = counter
 *             left -= cost of the next segment
 *             ...
 *
 * `left` is a register variable of the function; GCC's SSA update turns it into SSA names. A function with
 * edges over which no register variable is safe (setjmp, computed goto, nonlocal goto) counts in memory
 * instead, at the same places and with the same costs. The pass is the last before the expansion to machine
 * code, so that it counts what is left to execute.
 *
 * Three refinements have files of their own: loops that are charged where they are entered
 * (loop_precharge.h), small functions that are charged to their callers (leaf_charge.h), and lookahead, which
 * polls give to the simulator (lookahead.h).
 *
 * preempt is inline assembly, not a call, and its target saves every register: to the register allocator a
 * poll is a branch over nothing, and a leaf function stays a leaf.
 */
#include "base/gcc.h"
#include "counting/arg_cost.h"
#include "counting/cache.h"
#include "base/costs.h"
#include "counting/count.h"
#include "counting/idle_loops.h"
#include "../contract/program_image.h"
#include "counting/leaf_charge.h"
#include "runtime/enter.h"
#include "counting/lookahead.h"
#include "counting/loop_precharge.h"
#include "counting/poll.h"
#include "counting/profile.h"
#include "counting/purity.h"
#include "base/symbols.h"
#include <memory>

#define COUNTER "nxc_left"
#define LOOKAHEAD "nxc_lookahead"

/* A library call that is known to cost more is spent in parts of so many units, with a poll behind each: 10
 * us of a 40 MHz processor. */
const int64_t longest_part = 400 * NXC_UNITS_PER_CLOCK;

bool count_in_memory;

namespace
{
tree counter, lookahead_word; /* the variables nxc_left and nxc_lookahead of runtime.c */

/* A poll to insert: behind the statement `after`, which charges, the program is preempted if value is
 * negative. The charge of a long library call may be spent in parts, so that a due handler need not wait for
 * all of it. */
struct poll {
    gimple *after;
    tree value;
    bool in_parts;
    const lookahead *ahead; /* NULL: none */
    int64_t charged;        /* units of the lookahead that have been charged at the poll */
};

/* The cost of a segment, and the functions to which the profile attributes it. */
struct segment {
    int64_t cost = 0;
    profile_shares shares; /* only with a profile */

    void add(const segment &s, int64_t times)
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
    void scan_function();
    void count_block(basic_block bb);
    gimple *hand_over(gcall *call);
    void charge_misses(gimple *stmt);
    void charge_misses_of_block(basic_block bb);
    void charge_arguments(gcall *call);
    gimple *charge_result(gcall *call, gimple *behind);
    void charge_segment(basic_block bb, gimple *behind, const segment &s);
    void precharge(const precharged_loop &loop);
    void add_lookahead(gimple_seq *seq, poll *p, basic_block bb, int64_t cost);
    void add_cost(segment *s, gimple *stmt);
    void add_leaf_cost(segment *s, gimple *stmt);
    void add_idle_cost(segment *s, basic_block bb);
    poll subtract(gimple_seq *seq, tree amount);
    poll charge(gimple_seq *seq, gimple *stmt, tree amount);
    void charge_call(gimple_seq *seq, gcall *call, tree amount);
    void store(gimple_seq *seq, tree value);
    void load_on_entry();
    void store_on_exit();
    void preempt(gimple_seq *seq);
    void preempt_in_time(gimple_seq *seq);
    void insert_poll(const poll &p);

    function *fun;
    tree left = NULL_TREE;              /* the register, or NULL: count in memory */
    bool calls = false;                 /* it calls others, so that it may be part of a recursion */
    std::unique_ptr<profiling> profile; /* NULL: none is wanted */
    auto_bitmap poll_blocks;            /* blocks that poll: the heads of cycles, and the first */
    auto_bitmap idle;                   /* of these, the heads of cycles that cost nothing otherwise */
    precharge_plan plan;
    std::map<basic_block, lookahead> lookaheads; /* of poll_blocks */
    std::set<basic_block> precharged; /* blocks of precharged loops that charge nothing themselves */
    auto_vec<poll> polls;
};

bool is_counted_call(gcall *call)
{
    return call && !costs_call_is_uncounted(call);
}

/* Does a statement need the counter in memory, because it may read or change the counter? */
bool needs_counter(gimple *stmt)
{
    return is_counted_call(dyn_cast<gcall *>(stmt)) && !leaf_charge_is_call(stmt);
}

/* Finds out whether the function calls others, and whether `left` can be a register. */
void counting::scan_function()
{
    basic_block bb;
    FOR_EACH_BB_FN (bb, fun)
        for (gimple_stmt_iterator gsi = gsi_start_bb(bb); !gsi_end_p(gsi); gsi_next(&gsi))
            if (gcall *call = dyn_cast<gcall *>(gsi_stmt(gsi))) {
                calls = calls || is_counted_call(call);
                leaf_charge_note_call(call);
            }
    if (count_is_in_register(fun))
        left = create_tmp_reg(units_type(), "left");
}

/* Appends counter -= amount. Returns a poll behind the last statement appended, of the new value. */
poll counting::subtract(gimple_seq *seq, tree amount)
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

/* Appends counter -= amount, the cost of a statement. */
poll counting::charge(gimple_seq *seq, gimple *stmt, tree amount)
{
    poll charged = subtract(seq, amount);
    if (profile)
        profile->add(seq, gimple_bb(stmt), profile->cell_of(stmt), amount);
    charged.after = gimple_seq_last_stmt(*seq);
    return charged;
}

/* Appends counter -= amount, the argument-dependent cost of a library call. */
void counting::charge_call(gimple_seq *seq, gcall *call, tree amount)
{
    poll charged = charge(seq, call, amount);
    charged.in_parts = true;
    if (TREE_CODE(amount) == INTEGER_CST && tree_to_shwi(amount) > longest_part)
        polls.safe_push(charged);
}

/* Appends counter = value, for a callee or the simulator to read. */
void counting::store(gimple_seq *seq, tree value)
{
    gimple_seq_add_stmt_without_update(seq, gimple_build_assign(counter, value));
}

/* Adds the fixed cost of a statement to a segment. */
void counting::add_cost(segment *s, gimple *stmt)
{
    int64_t cost = plan.added.count(stmt) ? 0 : costs_of(stmt);
    s->cost += cost;
    if (profile && cost)
        s->shares[profile->cell_of(stmt)] += cost;
}

/* Adds the cost of the caller-charged leaf that a statement calls, if it calls one. */
void counting::add_leaf_cost(segment *s, gimple *stmt)
{
    int64_t cost = leaf_charge_cost(stmt);
    s->cost += cost;
    if (profile && cost)
        s->shares[profile->cell_of_leaf(as_a<gcall *>(stmt))] += cost;
}

/* The source line of the first statement that has one. */
location_t location_of_statements(basic_block bb)
{
    for (gimple_stmt_iterator gsi = gsi_start_bb(bb); !gsi_end_p(gsi); gsi_next(&gsi))
        if (gimple_has_location(gsi_stmt(gsi)))
            return gimple_location(gsi_stmt(gsi));
    return UNKNOWN_LOCATION;
}

/* A source line for a block, also for the head of a loop without statements. */
location_t location_of(basic_block bb)
{
    location_t where = location_of_statements(bb);
    if (where != UNKNOWN_LOCATION)
        return where;
    edge e;
    edge_iterator ei;
    FOR_EACH_EDGE (e, ei, bb->preds)
        if (e->goto_locus != UNKNOWN_LOCATION)
            return e->goto_locus;
    return UNKNOWN_LOCATION;
}

/* Adds the cost of a jump to the head of an idle loop. A statement that does nothing gives the cost its
 * source line. */
void counting::add_idle_cost(segment *s, basic_block bb)
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

/* Gives the poll at the beginning of bb, where `cost` has been charged, its lookahead. If callees have polls
 * of their own, the lookahead is stored in each trip, whether the poll strikes or not. */
void counting::add_lookahead(gimple_seq *seq, poll *p, basic_block bb, int64_t cost)
{
    auto found = lookaheads.find(bb);
    if (found == lookaheads.end())
        return;
    p->ahead = &found->second;
    p->charged = cost;
    if (found->second.callees_poll)
        lookahead_append(seq, found->second, cost, lookahead_word, left);
}

/* Charges the segment that begins behind a statement, or with the block if behind is NULL. The block's poll
 * is there. */
void counting::charge_segment(basic_block bb, gimple *behind, const segment &s)
{
    bool poll_here = !behind && bitmap_bit_p(poll_blocks, bb->index);
    if (!s.cost && !poll_here)
        return;
    gimple_seq seq = NULL;
    if (profile)
        profile->add(&seq, bb, s.shares, units_constant(1)); /* before the poll */
    poll charged = subtract(&seq, units_constant(s.cost));
    if (poll_here) {
        add_lookahead(&seq, &charged, bb, s.cost);
        polls.safe_push(charged);
    }
    if (behind) {
        gimple_stmt_iterator gsi = gsi_for_stmt(behind);
        gsi_insert_seq_after(&gsi, seq, GSI_SAME_STMT);
    } else {
        gimple_stmt_iterator gsi = gsi_after_labels(bb);
        gsi_insert_seq_before(&gsi, seq, GSI_SAME_STMT);
    }
}

/* Charges the misses of a statement; only with a simulated cache. */
void counting::charge_misses(gimple *stmt)
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

void counting::charge_arguments(gcall *call)
{
    const call_cost *price;
    int64_t per = costs_of_call(call, &price);
    if (!per || price->is_behind())
        return;
    gimple_seq seq = NULL;
    charge_call(&seq, call, arg_cost_append(&seq, call, per, *price));
    gimple_stmt_iterator gsi = gsi_for_stmt(call);
    gsi_insert_seq_before(&gsi, seq, GSI_SAME_STMT);
}

/* Charges a call's cost that depends on its result, or on an array that it has made. Returns the last
 * statement put behind `behind`, or `behind`. */
gimple *counting::charge_result(gcall *call, gimple *behind)
{
    const call_cost *price;
    int64_t per = costs_of_call(call, &price);
    if (!per || !price->is_behind())
        return behind;
    if (price->kind == PRICED_INTEGERS && !gimple_call_lhs(call)) {
        gimple_call_set_lhs(call, make_ssa_name(gimple_call_return_type(call), call));
        update_stmt(call);
    }
    if (gimple_call_lhs(call) && !is_gimple_reg(gimple_call_lhs(call)))
        return behind;
    gimple_seq seq = NULL;
    charge_call(&seq, call, arg_cost_append(&seq, call, per, *price));
    gimple *last = gimple_seq_last_stmt(seq);
    gimple_stmt_iterator gsi = gsi_for_stmt(behind);
    gsi_insert_seq_after(&gsi, seq, GSI_SAME_STMT);
    return last;
}

/* Stores the counter before a call and loads it again behind the call. Returns the last statement that
 * belongs to the call. */
gimple *counting::hand_over(gcall *call)
{
    gimple_stmt_iterator gsi = gsi_for_stmt(call);
    gimple_seq seq = NULL;
    if (profile)
        profile->before_call(&seq);
    if (left)
        store(&seq, left);
    gsi_insert_seq_before(&gsi, seq, GSI_SAME_STMT);
    if (!left || stmt_ends_bb_p(call))
        return call;
    gimple *reload = gimple_build_assign(left, counter);
    gsi_insert_after(&gsi, reload, GSI_SAME_STMT);
    return reload;
}

/* Appends trips * each + last. */
tree append_trips(gimple_seq *seq, const precharged_loop &loop, int64_t each, int64_t last)
{
    tree sum = gimple_build(seq, MULT_EXPR, units_type(), loop.trips, units_constant(each));
    return gimple_build(seq, PLUS_EXPR, units_type(), sum, units_constant(last));
}

/* Makes the test where a loop is entered, and charges the blocks that all trips run before the precharged
 * version. */
void counting::precharge(const precharged_loop &loop)
{
    segment each, last;
    for (const precharged_block &b : loop.blocks) {
        segment once;
        for (gimple_stmt_iterator gsi = gsi_start_bb(b.bb); !gsi_end_p(gsi); gsi_next(&gsi)) {
            add_cost(&once, gsi_stmt(gsi));
            add_leaf_cost(&once, gsi_stmt(gsi));
        }
        each.add(once, b.each);
        last.add(once, b.last);
    }
    gimple_seq seq = NULL;
    tree rest = make_ssa_name(units_type());
    tree need = append_trips(&seq, loop, loop.most, loop.most);
    gimple_seq_add_stmt_without_update(&seq, gimple_build_assign(rest, MINUS_EXPR, left, need));
    gimple_cond_set_condition(loop.test, GE_EXPR, rest, units_constant(0));
    update_stmt(loop.test);
    gimple_stmt_iterator gsi = gsi_for_stmt(loop.test);
    gsi_insert_seq_before(&gsi, seq, GSI_SAME_STMT);

    seq = NULL;
    if (each.cost == loop.most && last.cost == loop.most)
        gimple_seq_add_stmt_without_update(&seq, gimple_build_assign(left, rest));
    else
        subtract(&seq, append_trips(&seq, loop, each.cost, last.cost));
    if (profile) {
        profile->add(&seq, loop.first, each.shares, loop.trips);
        profile->add(&seq, loop.first, last.shares, units_constant(1));
    }
    gsi = gsi_after_labels(loop.first);
    gsi_insert_seq_before(&gsi, seq, GSI_SAME_STMT);
}

/* Charges the cache misses of a precharged block, which no trip count tells. */
void counting::charge_misses_of_block(basic_block bb)
{
    auto_vec<gimple *> statements;
    for (gimple_stmt_iterator gsi = gsi_after_labels(bb); !gsi_end_p(gsi); gsi_next(&gsi))
        statements.safe_push(gsi_stmt(gsi));
    cache_forget();
    for (gimple *stmt : statements)
        charge_misses(stmt);
}

void counting::count_block(basic_block bb)
{
    if (precharged.count(bb))
        return;
    auto_vec<gimple *> statements;
    for (gimple_stmt_iterator gsi = gsi_after_labels(bb); !gsi_end_p(gsi); gsi_next(&gsi))
        statements.safe_push(gsi_stmt(gsi));
    segment now;
    gimple *behind = NULL;
    unsigned i;
    gimple *stmt;
    cache_forget();
    if (bitmap_bit_p(idle, bb->index))
        add_idle_cost(&now, bb);
    FOR_EACH_VEC_ELT (statements, i, stmt) {
        add_cost(&now, stmt);
        charge_misses(stmt);
        gcall *call = dyn_cast<gcall *>(stmt);
        if (!call)
            continue;
        /* Code of our own may follow it. And a call at the function's end stays a call, as compilers of 1990
         * had it: its caller keeps the frame that reports name. */
        gimple_call_set_tail(call, false);
        charge_arguments(call);
        gimple *last = call;
        if (is_counted_call(call))
            purity_forget(call);
        if (leaf_charge_is_call(call) && !behind && bitmap_bit_p(poll_blocks, bb->index)) {
            /* the leaf is charged behind the block's poll, where it would charge itself */
            charge_segment(bb, behind, now);
            now = segment();
            behind = call;
        }
        add_leaf_cost(&now, call);
        if (needs_counter(call)) {
            charge_segment(bb, behind, now);
            now = segment();
            behind = last = hand_over(call);
        }
        if (!stmt_ends_bb_p(call))
            last = charge_result(call, last);
        if (behind && needs_counter(call))
            behind = last;
    }
    if (!behind || !stmt_ends_bb_p(behind))
        charge_segment(bb, behind, now);
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

/* Appends the call of the simulator. Its target saves all registers but those of the x87 (long double), which
 * the assembly clobbers: to ask at run time whether one of them is in use takes longer than all the rest. */
void append_preemption(gimple_seq *seq)
{
    static const char *const names[] = {"memory", "st",    "st(1)", "st(2)", "st(3)",
                                        "st(4)",  "st(5)", "st(6)", "st(7)"};
    vec<tree, va_gc> *clobbers = NULL;
    for (const char *name : names)
        vec_safe_push(clobbers, build_tree_list(NULL_TREE, build_string((int)strlen(name), name)));
    gasm *call = gimple_build_asm_vec(NXC_CALL_ENTER, NULL, NULL, clobbers, NULL);
    gimple_asm_set_volatile(call, true);
    gimple_seq_add_stmt_without_update(seq, call);
}

/* Appends a preemption. */
void counting::preempt(gimple_seq *seq)
{
    if (left)
        store(seq, left);
    append_preemption(seq);
    if (left)
        gimple_seq_add_stmt_without_update(seq, gimple_build_assign(left, counter));
}

/* Appends a preemption at the end of the part of a library call in which left became negative. Parts end at
 * multiples of longest_part before the call's end. The parts behind are charged after the preemption. */
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
    tree in_part = append(TRUNC_MOD_EXPR, beyond, units_constant(longest_part));
    tree behind = append(MINUS_EXPR, beyond, in_part);
    store(seq, append(PLUS_EXPR, was, behind));
    append_preemption(seq);
    gimple_seq_add_stmt_without_update(seq, gimple_build_assign(now, counter));
    tree is = left ? left : make_ssa_name(units_type());
    gimple_seq_add_stmt_without_update(seq, gimple_build_assign(is, MINUS_EXPR, now, behind));
    if (!left)
        gimple_seq_add_stmt_without_update(seq, gimple_build_assign(counter, is));
}

/* Splits the block behind p.after, and puts the preemption into a block out of line. That block leads back to
 * the poll if the charge is spent in parts. */
void counting::insert_poll(const poll &p)
{
    basic_block bb = gimple_bb(p.after);
    edge on = split_block(bb, p.after);
    if (p.in_parts) {
        bb = split_edge(on);
        on = single_succ_edge(bb);
    }
    basic_block rest = on->dest;
    basic_block cold = create_empty_bb(bb);
    if (current_loops)
        add_bb_to_loop(cold, bb->loop_father);
    gimple_stmt_iterator gsi = gsi_last_bb(bb);
    tree value = p.value;
    if (p.in_parts && !left) {
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
    make_single_succ_edge(cold, p.in_parts ? bb : rest, EDGE_FALLTHRU);

    gimple_seq seq = NULL;
    location_t where = location_of_statements(bb); /* for those who ask where an endless loop is */
    if (where == UNKNOWN_LOCATION)
        where = location_of_statements(rest);
    if (where == UNKNOWN_LOCATION)
        where = location_of(bb);
    tree path = profile ? profile->before_preemption(&seq, bb) : NULL_TREE;
    if (p.ahead)
        lookahead_append(&seq, *p.ahead, p.charged, lookahead_word, left);
    if (p.in_parts)
        preempt_in_time(&seq);
    else
        preempt(&seq);
    if (profile)
        profile->behind_preemption(&seq, path);
    for (gimple_stmt_iterator i = gsi_start(seq); !gsi_end_p(i); gsi_next(&i))
        gimple_set_location(gsi_stmt(i), where);
    gsi = gsi_start_bb(cold);
    gsi_insert_seq_before(&gsi, seq, GSI_SAME_STMT);
}

/* Gives loops the preheaders that the analyses want. (A loop that is entered from several places gets a new
 * head: a mark that had been made before would stay outside of the loop.) */
void normalise_loops()
{
    loop_optimizer_init(LOOPS_NORMAL);
    loop_optimizer_finalize();
}

void counting::run()
{
    scan_function();
    bool analyses = left && optimize;
    if (analyses && !calls && !cache_is_simulated() && leaf_charge_accept(fun))
        return;
    if (analyses)
        normalise_loops();
    poll_mark(fun, calls, poll_blocks);
    idle_loops_find(fun, needs_counter, poll_blocks, idle);
    if (analyses) {
        plan = loop_precharge_run(needs_counter, poll_blocks);
        lookaheads = lookahead_find(poll_blocks, plan.polled, plan.added);
    }
    if (profile_on)
        profile = std::make_unique<profiling>(fun, !left, needs_counter);
    for (const precharged_loop &loop : plan.loops)
        for (const precharged_block &b : loop.blocks)
            precharged.insert(b.bb);
    basic_block bb;
    FOR_EACH_BB_FN (bb, fun)
        count_block(bb);
    for (const precharged_loop &loop : plan.loops)
        precharge(loop);
    for (const precharged_loop &loop : plan.loops)
        for (const precharged_block &b : loop.blocks)
            charge_misses_of_block(b.bb);
    if (left) {
        load_on_entry();
        store_on_exit();
    }
    if (profile)
        profile->finish();
    unsigned i;
    poll *p;
    FOR_EACH_VEC_ELT (polls, i, p)
        insert_poll(*p);
    if (current_loops)
        loops_state_set(LOOPS_NEED_FIXUP); /* the parts of a call make a loop */
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
            counter = symbols_declare(COUNTER, units_type());
            lookahead_word = symbols_declare(LOOKAHEAD, units_type());
        }
        costs_warn_if_taken_for_library(f->decl);
        counting(f).run();
        return 0;
    }
};
} // namespace

tree count_counter()
{
    return counter;
}

bool count_is_in_register(function *fun)
{
    if (count_in_memory || fun->calls_setjmp || fun->has_nonlocal_label)
        return false;
    basic_block bb;
    FOR_EACH_BB_FN (bb, fun) {
        edge e;
        edge_iterator ei;
        FOR_EACH_EDGE (e, ei, bb->succs)
            if (e->flags & (EDGE_ABNORMAL | EDGE_EH))
                return false;
    }
    return true;
}

bool count_needs_counter(gimple *stmt)
{
    return needs_counter(stmt);
}

opt_pass *count_make_pass()
{
    return new count_pass(g);
}
