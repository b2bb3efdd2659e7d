/* promise.cc - see promise.h. */
#include "promise.h"
#include "costs.h"
#include "../contract/program_image.h"
#include "leaves.h"
#include "output.h"
#include "rounds.h"
#include "tree-ssa-loop-ivopts.h"
#include "varasm.h"
#include "variable.h"
#include <algorithm>
#include <string>

namespace
{
/* Promises of less are not worth their code: 10 us of a 40 MHz processor. */
const int64_t worth_telling = 400 * NXC_UNITS_PER_CLOCK;
/* Nor is a variable in a loop whose rounds cost less, but for those that run seldom. */
const int64_t worth_keeping = 20 * NXC_UNITS_PER_CLOCK;
const int64_t most_units = INT64_MAX / 64; /* no counter is ever greater */
const int64_t most_times = 1 << 14; /* as much as the rest of a round costs, an inner loop adds to it */
const size_t most_outside = 2;      /* functions of other files in a loop */

struct silent_function {
    int64_t units; /* of the cheapest way */
    bool checks;
};
std::map<unsigned, silent_function> silent; /* by DECL_UID */
std::set<std::string> told;                 /* those that other files may call */
std::map<std::string, tree> flags;          /* bytes that tell which functions of other files are */

/* What a block's statements do, or a loop's. */
struct deeds {
    bool calls = false;        /* what the simulator may serve */
    bool others = false;       /* calls of functions that check */
    std::vector<tree> outside; /* functions of other files called, each once */

    bool any_served() const { return calls || !outside.empty(); }
    void add_outside(tree function)
    {
        if (std::find(outside.begin(), outside.end(), function) == outside.end())
            outside.push_back(function);
    }
    void add(const deeds &d)
    {
        calls |= d.calls, others |= d.others;
        for (tree function : d.outside)
            add_outside(function);
    }
};

struct block_cost : deeds {
    int64_t units = 0; /* in all */
    int64_t first = 0; /* up to the first call that may be served */
};

struct loop_cost : deeds {
    int64_t rounds = 0; /* how often it goes back at least, whenever it is entered */
    int64_t least = 0;  /* units of a round that goes back, if nothing in it is served */
    int64_t added = 0;  /* units of those rounds */
    /* The variable, where a round begins, and later in it, when it is already for the rounds after the next; NULL: none is
     * kept. exact: it comes to 0 in the last round. */
    tree before = NULL_TREE, after = NULL_TREE;
    bool exact = false;
};

typedef std::map<basic_block, int64_t> block_ways; /* from where blocks begin */

class promising
{
  public:
    promising(bitmap c, const std::set<basic_block> &s, std::set<gimple *> &o) : checked(c), slow(s), own(o)
    {
    }
    std::map<basic_block, promise> run();

  private:
    void cost_blocks();
    void look_at_loop(class loop *loop);
    bool is_of_last(class loop *loop, edge e);
    int64_t cheapest_way(class loop *loop, basic_block bb, std::map<basic_block, int64_t> &known);
    int64_t rounds_on(edge e);
    int64_t way_from(basic_block bb, class loop *within, block_ways &known);
    const block_ways &ways_to_end(class loop *within);
    int64_t way(basic_block bb, class loop *inner, class loop *within);
    void accept_silent();
    bool is_worth_keeping(class loop *loop);
    tree append_inner(gimple_seq *seq, class loop *outer, class loop *inner);
    tree append_round(gimple_seq *seq, class loop *loop);
    tree append_units(gimple_seq *seq, class loop *loop, tree a_round);
    void keep(class loop *loop);
    tree all_silent(gimple_seq *seq, const std::vector<tree> &outside);
    promise at(basic_block bb);

    bitmap checked;
    const std::set<basic_block> &slow;
    std::set<gimple *> &own;
    std::map<basic_block, block_cost> blocks;
    std::map<class loop *, loop_cost> loops;
    std::vector<basic_block> post_order;
    std::map<class loop *, block_ways> ways; /* ways_to_end */
};

/* --- calls ------------------------------------------------------------------------------------------------- */

/* A leading * is GCC's own. */
std::string symbol_of(tree function)
{
    const char *name = IDENTIFIER_POINTER(DECL_ASSEMBLER_NAME(function));
    return std::string("nxc_silent.") + (*name == '*' ? name + 1 : name);
}

/* A function of another of the program's files. */
bool is_outside(tree callee)
{
    return callee && TREE_PUBLIC(callee) && DECL_EXTERNAL(callee) && !fndecl_built_in_p(callee) &&
           !DECL_IN_SYSTEM_HEADER(callee);
}

/* Adds a call; answers the units of the function called. */
int64_t add_call(gcall *call, deeds &d)
{
    tree callee = gimple_call_fndecl(call);
    if (costs_call_is_quiet(call) || leaves_is_call(call))
        return leaves_cost(call);
    auto known = callee ? silent.find(DECL_UID(callee)) : silent.end();
    if (known != silent.end()) {
        d.others |= known->second.checks;
        return known->second.units;
    }
    if (is_outside(callee))
        d.add_outside(callee);
    else
        d.calls = true;
    return 0;
}

void promising::cost_blocks()
{
    basic_block bb;
    FOR_EACH_BB_FN (bb, cfun) {
        block_cost &c = blocks[bb];
        for (gimple_stmt_iterator gsi = gsi_start_nondebug_bb(bb); !gsi_end_p(gsi); gsi_next_nondebug(&gsi)) {
            gimple *stmt = gsi_stmt(gsi);
            if (own.count(stmt))
                continue;
            int64_t units = costs_of(stmt);
            if (gcall *call = dyn_cast<gcall *>(stmt))
                units += add_call(call, c);
            c.calls |= gimple_code(stmt) == GIMPLE_ASM;
            c.units = std::min(most_units, c.units + units);
            if (!c.any_served())
                c.first = c.units;
        }
    }
}

/* --- ways -------------------------------------------------------------------------------------------------- */

/* What a loop adds where it is entered. */
int64_t promising::rounds_on(edge e)
{
    class loop *loop = e->dest->loop_father;
    return e->dest == loop->header && !flow_bb_inside_loop_p(loop, e->src) ? loops[loop].added : 0;
}

/* The round in which a variable that changes by the same in each comes to a constant, for ways that are gone then only:
 * GCC tells it only of tests that every round makes. */
int64_t rounds_until_equal(class loop *loop, edge e)
{
    gcond *test = safe_dyn_cast<gcond *>(last_stmt(e->src));
    affine_iv iv;
    if (!test || gimple_cond_code(test) != (e->flags & EDGE_TRUE_VALUE ? EQ_EXPR : NE_EXPR) ||
        !tree_fits_shwi_p(gimple_cond_rhs(test)) ||
        !simple_iv(loop, loop, gimple_cond_lhs(test), &iv, false) || !tree_fits_shwi_p(iv.base) ||
        !tree_fits_shwi_p(iv.step) || integer_zerop(iv.step))
        return 0;
    int64_t way, begin = tree_to_shwi(iv.base), step = tree_to_shwi(iv.step);
    if (__builtin_sub_overflow(tree_to_shwi(gimple_cond_rhs(test)), begin, &way) || way % step ||
        way / step < 0)
        return 0;
    return way / step;
}

/* How often a loop goes back at least before it may go this way, as far as that is always the same; else 0. */
int64_t rounds_before(class loop *loop, edge e)
{
    tree_niter_desc n;
    if (e->flags & EDGE_COMPLEX)
        return 0;
    if (number_of_iterations_exit_assumptions(loop, e, &n, NULL, false) && integer_onep(n.assumptions) &&
        integer_zerop(n.may_be_zero) && tree_fits_shwi_p(n.niter))
        return tree_to_shwi(n.niter);
    return rounds_until_equal(loop, e);
}

/* The same for a way out: all that lead to it count. */
int64_t rounds_before_exit(class loop *loop, edge exit)
{
    int64_t most = rounds_before(loop, exit);
    for (basic_block bb = exit->src; bb != loop->header; bb = get_immediate_dominator(CDI_DOMINATORS, bb))
        if (single_pred_p(bb))
            most = std::max(most, rounds_before(loop, single_pred_edge(bb)));
    return most;
}

/* How often it goes back at least before it is left. */
int64_t least_rounds(class loop *loop)
{
    int64_t least = INT64_MAX;
    for (edge exit : get_loop_exit_edges(loop))
        least = std::min(least, rounds_before_exit(loop, exit));
    return least == INT64_MAX ? 0 : least;
}

/* Is it a way that no round goes of those which are counted, but only the last? */
bool promising::is_of_last(class loop *loop, edge e)
{
    int64_t rounds = loops[loop].rounds;
    return rounds > 0 && !single_succ_p(e->src) && e->src->loop_father == loop &&
           rounds_before(loop, e) >= rounds;
}

/* From the beginning of a round that goes back to the end of a block. */
int64_t promising::cheapest_way(class loop *loop, basic_block bb, std::map<basic_block, int64_t> &known)
{
    auto found = known.find(bb);
    if (found != known.end())
        return found->second;
    int64_t before = bb == loop->header ? 0 : most_units;
    edge e;
    edge_iterator i;
    if (bb != loop->header)
        FOR_EACH_EDGE (e, i, bb->preds)
            if (!dominated_by_p(CDI_DOMINATORS, e->src, bb) && !is_of_last(loop, e))
                before = std::min(before, cheapest_way(loop, e->src, known) + rounds_on(e));
    return known[bb] = std::min(most_units, before + blocks[bb].units);
}

void promising::look_at_loop(class loop *loop)
{
    loop_cost &l = loops[loop];
    basic_block *body = get_loop_body(loop);
    for (unsigned i = 0; i < loop->num_nodes; i++) {
        l.add(blocks[body[i]]);
        l.calls |= (body[i]->flags & BB_IRREDUCIBLE_LOOP) != 0;
    }
    free(body);
    if (l.calls)
        return;
    l.rounds = least_rounds(loop);
    std::map<basic_block, int64_t> known;
    l.least = cheapest_way(loop, loop->latch, known);
    if (!l.any_served())
        l.added = l.rounds < most_units / (l.least + 1) ? l.rounds * l.least : most_units;
}

/* From a block's beginning, as far as ways from those behind it are known. */
int64_t promising::way_from(basic_block bb, class loop *within, block_ways &known)
{
    const block_cost &c = blocks[bb];
    if (within ? bb == within->latch : c.any_served() || !EDGE_COUNT(bb->succs))
        return within ? c.units : c.first;
    int64_t rest = most_units;
    edge e;
    edge_iterator i;
    FOR_EACH_EDGE (e, i, bb->succs)
        if (!within || (e->dest != within->header && flow_bb_inside_loop_p(within, e->dest)))
            rest = std::min(rest, known[e->dest] + rounds_on(e));
    return std::min(most_units, c.units + rest);
}

/* To the end of a loop's round; NULL: to the next call that may be served, or the function's end. They become shorter until
 * none does. */
const block_ways &promising::ways_to_end(class loop *within)
{
    block_ways &known = ways[within];
    if (!known.empty())
        return known;
    std::vector<basic_block> order;
    for (basic_block bb : post_order)
        if (!within || flow_bb_inside_loop_p(within, bb))
            order.push_back(bb), known[bb] = most_units;
    known[EXIT_BLOCK_PTR_FOR_FN(cfun)] = 0;
    for (bool again = true; again;) {
        again = false;
        for (basic_block bb : order) {
            int64_t way = way_from(bb, within, known);
            again |= way < known[bb];
            known[bb] = way;
        }
    }
    return known;
}

void promising::accept_silent()
{
    for (auto &b : blocks)
        if (b.second.any_served())
            return;
    tree decl = current_function_decl;
    if (!decl_binds_to_current_def_p(decl))
        return;
    silent[DECL_UID(decl)] = {ways_to_end(NULL).at(single_succ(ENTRY_BLOCK_PTR_FOR_FN(cfun))),
                              !bitmap_empty_p(checked)};
    if (TREE_PUBLIC(decl) && !DECL_WEAK(decl) && !DECL_COMDAT(decl))
        told.insert(symbol_of(decl));
}

/* --- rounds to come ---------------------------------------------------------------------------------------- */

/* The byte that tells whether a function of another file is silent. */
tree flag_of(tree function)
{
    std::string name = symbol_of(function);
    tree &flag = flags[name];
    if (!flag)
        flag = variable_declare(name.c_str(), unsigned_char_type_node);
    return flag;
}

/* Appends: are they all? */
tree promising::all_silent(gimple_seq *seq, const std::vector<tree> &outside)
{
    tree all = NULL_TREE;
    for (tree function : outside) {
        tree flag = make_ssa_name(unsigned_char_type_node);
        gimple_seq_add_stmt_without_update(seq, gimple_build_assign(flag, flag_of(function)));
        all = all ? gimple_build(seq, BIT_AND_EXPR, unsigned_char_type_node, all, flag) : flag;
    }
    return gimple_build(seq, NE_EXPR, boolean_type_node, all, build_int_cst(unsigned_char_type_node, 0));
}

/* One that is paid for where it is entered does not check; nor do its inner loops. */
bool promising::is_worth_keeping(class loop *loop)
{
    const loop_cost &l = loops[loop];
    return !l.calls && l.outside.size() <= most_outside && bitmap_bit_p(checked, loop->header->index) &&
           l.least >= (slow.count(loop->header) ? 1 : worth_keeping);
}

/* Appends rounds, or 0 where that is only known to be the limit or more, or not at all. */
tree append_known(gimple_seq *seq, class loop *loop, const tree_niter_desc &n, int64_t limit)
{
    tree rounds = rounds_append(seq, loop, n, limit);
    tree known = gimple_build(seq, LT_EXPR, boolean_type_node, rounds, build_int_cst(units_type(), limit));
    return gimple_build(seq, COND_EXPR, units_type(), known, rounds, build_int_cst(units_type(), 0));
}

/* Appends the units that an inner loop adds to the cheapest round each time it is entered, which are known where the outer one is.
 * NULL: they are not. */
tree promising::append_inner(gimple_seq *seq, class loop *outer, class loop *inner)
{
    const loop_cost &l = loops[inner];
    tree_niter_desc n;
    if (l.rounds || !l.least || !rounds_foresee(inner, &n))
        return NULL_TREE;
    for (tree *t : {&n.niter, &n.may_be_zero, &n.assumptions})
        if (!expr_invariant_in_loop_p(outer, *t = expand_simple_operations(*t)))
            return NULL_TREE;
    const int64_t limit = most_times * loops[outer].least / l.least;
    return gimple_build(seq, MULT_EXPR, units_type(), append_known(seq, inner, n, limit),
                        build_int_cst(units_type(), l.least));
}

/* The loop within `outer` into which a way leads and nowhere else; NULL: there is none. */
class loop *loop_behind(edge way, class loop *outer)
{
    basic_block bb = way->dest;
    while (bb->loop_father == outer && bb != outer->latch && single_succ_p(bb))
        bb = single_succ(bb);
    class loop *loop = bb->loop_father;
    return loop_outer(loop) == outer && bb == loop->header ? loop : NULL;
}

/* The block in each of the outer loop's rounds that go back from which one comes to an inner one, or past it. */
basic_block fork_before(class loop *outer, class loop *inner)
{
    basic_block bb = inner->header;
    while (!dominated_by_p(CDI_DOMINATORS, outer->latch, bb))
        bb = get_immediate_dominator(CDI_DOMINATORS, bb);
    return bb;
}

/* Appends the units of a round that goes back: the cheapest, and what inner loops add in each. Of two between which a round
 * chooses, that is the less: prepay.h makes two of one. */
tree promising::append_round(gimple_seq *seq, class loop *loop)
{
    const int64_t least = loops[loop].least;
    tree sum = build_int_cst(units_type(), least);
    for (class loop *inner = least < most_units / most_times ? loop->inner : NULL; inner;
         inner = inner->next) {
        basic_block fork = fork_before(loop, inner);
        tree units = NULL_TREE;
        if (fork == inner->header) {
            units = append_inner(seq, loop, inner);
        } else if (EDGE_COUNT(fork->succs) == 2 && inner == loop_behind(EDGE_SUCC(fork, 0), loop)) {
            class loop *other = loop_behind(EDGE_SUCC(fork, 1), loop);
            tree one = other ? append_inner(seq, loop, inner) : NULL_TREE;
            tree two = one ? append_inner(seq, loop, other) : NULL_TREE;
            units = two ? gimple_build(seq, MIN_EXPR, units_type(), one, two) : NULL_TREE;
        }
        if (units)
            sum = gimple_build(seq, PLUS_EXPR, units_type(), sum, units);
    }
    return sum;
}

/* Appends the units of the rounds to come where a loop is entered; NULL: not known. */
tree promising::append_units(gimple_seq *seq, class loop *loop, tree a_round)
{
    const loop_cost &l = loops[loop];
    int64_t limit = most_units / l.least;
    tree zero = build_int_cst(units_type(), 0), rounds;
    tree_niter_desc n;
    if (!tree_fits_shwi_p(a_round))
        limit /= most_times;
    if (l.rounds)
        rounds = build_int_cst(units_type(), std::min(limit, l.rounds));
    else if (rounds_foresee(loop, &n))
        rounds = append_known(seq, loop, n, limit);
    else
        return NULL_TREE;
    tree units = gimple_build(seq, MULT_EXPR, units_type(), rounds, a_round);
    if (!l.outside.empty())
        units = gimple_build(seq, COND_EXPR, units_type(), all_silent(seq, l.outside), units, zero);
    return units;
}

/* Makes the variable of a loop, if it is worth it. */
void promising::keep(class loop *loop)
{
    if (!is_worth_keeping(loop))
        return;
    gimple_seq seq = NULL;
    tree a_round = append_round(&seq, loop), units = append_units(&seq, loop, a_round);
    if (!units || integer_zerop(units))
        return;
    tree step = gimple_build(&seq, NEGATE_EXPR, units_type(), a_round);
    for (gimple_stmt_iterator gsi = gsi_start(seq); !gsi_end_p(gsi); gsi_next(&gsi))
        own.insert(gsi_stmt(gsi));
    if (seq)
        gsi_insert_seq_on_edge_immediate(loop_preheader_edge(loop), seq);
    loop_cost &l = loops[loop];
    gimple_stmt_iterator begin = gsi_after_labels(loop->header);
    create_iv(units, step, NULL_TREE, loop, &begin, false, &l.before, &l.after);
    own.insert(SSA_NAME_DEF_STMT(l.after));
    l.exact =
        tree_fits_shwi_p(a_round) && l.outside.empty() && (!l.rounds || rounds_constant(loop) == l.rounds);
}

/* The units of a way from bb to the end of a round of `within`, or to the next call: beside those of the rounds to come of
 * the loops around it that have a variable, up to `last`, not included. Of a loop in which it lies, but not where a round
 * begins, either no round is to come, or one begins behind its own round's end, and the rest are those of the variable but
 * one. */
int64_t promising::way(basic_block bb, class loop *last, class loop *within)
{
    int64_t least = ways_to_end(within).at(bb);
    for (class loop *loop = bb->loop_father; loop != last; loop = loop_outer(loop))
        if (loops[loop].before && bb != loop->header)
            least = std::min(least,
                             way(bb, loop, loop) - loops[loop].least + ways_to_end(within).at(loop->header));
    return least;
}

promise promising::at(basic_block bb)
{
    promise p;
    class loop *loop = bb->loop_father;
    for (; loop_outer(loop) && !loops[loop].calls; loop = loop_outer(loop)) {
        const loop_cost &l = loops[loop];
        if (!l.before)
            continue;
        bool begins = bb == loop->header;
        p.more.push_back({begins ? l.before : l.after, begins ? 0 : l.least, !l.exact});
        p.for_others = p.for_others || (begins && l.others && l.least >= worth_telling);
    }
    p.least = way(bb, loop, NULL);
    return p;
}

std::map<basic_block, promise> promising::run()
{
    loop_optimizer_init(LOOPS_NORMAL | LOOPS_HAVE_RECORDED_EXITS);
    calculate_dominance_info(CDI_DOMINATORS);
    scev_initialize();
    cost_blocks();
    std::vector<int> order(n_basic_blocks_for_fn(cfun));
    order.resize(post_order_compute(order.data(), false, false));
    for (int index : order)
        post_order.push_back(BASIC_BLOCK_FOR_FN(cfun, index));
    for (auto loop : loops_list(cfun, LI_FROM_INNERMOST))
        look_at_loop(loop);
    accept_silent();
    for (auto loop : loops_list(cfun, 0))
        keep(loop);
    std::map<basic_block, promise> found;
    basic_block bb;
    FOR_EACH_BB_FN (bb, cfun) {
        if (!bitmap_bit_p(checked, bb->index))
            continue;
        promise p = at(bb);
        if (p.least >= worth_telling || !p.more.empty())
            found[bb] = p;
    }
    scev_finalize();
    loop_optimizer_finalize();
    return found;
}
} // namespace

std::map<basic_block, promise> promise_find(bitmap checked, const std::set<basic_block> &slow,
                                            std::set<gimple *> &own)
{
    return promising(checked, slow, own).run();
}

void promise_append(gimple_seq *seq, const promise &p, int64_t paid, tree quiet, tree left)
{
    tree now = make_ssa_name(units_type()), before = make_ssa_name(units_type());
    gimple_seq_add_stmt_without_update(seq, gimple_build_assign(now, left));
    gimple_seq_add_stmt_without_update(seq, gimple_build_assign(before, quiet));
    tree end = gimple_build(seq, PLUS_EXPR, units_type(), now, build_int_cst(units_type(), paid - p.least));
    for (const rounds_to_come &r : p.more) {
        tree more = gimple_build(seq, PLUS_EXPR, units_type(), r.more, build_int_cst(units_type(), r.add));
        if (r.at_least_0)
            more = gimple_build(seq, MAX_EXPR, units_type(), more, build_int_cst(units_type(), 0));
        end = gimple_build(seq, MINUS_EXPR, units_type(), end, more);
    }
    end = gimple_build(seq, MIN_EXPR, units_type(), before, end);
    gimple_seq_add_stmt_without_update(seq, gimple_build_assign(quiet, end));
}

static void write_flag(const char *binding, const char *name, bool yes)
{
    fprintf(asm_out_file, "\t.%s %s\n\t.hidden %s\n%s:\t.byte %d\n", binding, name, name, name, yes);
}

/* The file that has the function says yes, those that call it say no: the linker takes the first's word. */
void promise_write_silent()
{
    if (!asm_out_file || (told.empty() && flags.empty()))
        return;
    fputs("\t.section .rodata\n", asm_out_file);
    for (const std::string &name : told)
        write_flag("globl", name.c_str(), true);
    for (const auto &flag : flags)
        write_flag("weak", flag.first.c_str(), false);
}
