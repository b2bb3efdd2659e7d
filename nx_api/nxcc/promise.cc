/* promise.cc - see promise.h. */
#include "promise.h"
#include "costs.h"
#include "image.h"
#include "leaves.h"
#include "output.h"
#include "rounds.h"
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
const size_t most_outside = 2;             /* functions of other files in a loop */

struct silent_function {
    int64_t units; /* of the cheapest way */
    bool checks;
};
std::map<unsigned, silent_function> silent; /* by DECL_UID */
std::set<std::string> told;                 /* those that other files may call */
tree flags;                                 /* a list: bytes that tell which functions of other files are */

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
    int64_t least = 0; /* units of a round, if nothing in it is served */
    int64_t added = 0; /* units of rounds that are always the same */
    /* The variable, where a round begins, and later in it; NULL: none is kept. */
    tree before = NULL_TREE, after = NULL_TREE;
};

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
    int64_t cheapest_way(class loop *loop, basic_block bb, std::map<basic_block, int64_t> &known);
    int64_t rounds_on(edge e);
    int64_t way_from(basic_block bb);
    void find_ways();
    void accept_silent();
    bool is_worth_keeping(class loop *loop);
    void keep(class loop *loop);
    tree all_silent(gimple_seq *seq, const std::vector<tree> &outside);
    promise at(basic_block bb);

    bitmap checked;
    const std::set<basic_block> &slow;
    std::set<gimple *> &own;
    std::map<basic_block, block_cost> blocks;
    std::map<class loop *, loop_cost> loops;
    std::map<basic_block, int64_t> ways; /* from a block's beginning to the next call or the end */
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

/* What rounds that are always the same add where a loop is entered. */
int64_t promising::rounds_on(edge e)
{
    class loop *loop = e->dest->loop_father;
    return e->dest == loop->header && !flow_bb_inside_loop_p(loop, e->src) ? loops[loop].added : 0;
}

/* From the beginning of a round to the end of a block. */
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
            if (!dominated_by_p(CDI_DOMINATORS, e->src, bb))
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
    std::map<basic_block, int64_t> known;
    l.least = cheapest_way(loop, loop->latch, known);
    int64_t rounds = l.any_served() ? -1 : rounds_constant(loop);
    if (rounds > 0)
        l.added = rounds < most_units / (l.least + 1) ? rounds * l.least : most_units;
}

/* From a block's beginning, as far as ways from those behind it are known. */
int64_t promising::way_from(basic_block bb)
{
    const block_cost &c = blocks[bb];
    if (c.any_served() || !EDGE_COUNT(bb->succs))
        return c.first;
    int64_t rest = most_units;
    edge e;
    edge_iterator i;
    FOR_EACH_EDGE (e, i, bb->succs)
        rest = std::min(rest, ways[e->dest] + rounds_on(e));
    return std::min(most_units, c.first + rest);
}

/* Ways become shorter until none does. */
void promising::find_ways()
{
    std::vector<int> order(n_basic_blocks_for_fn(cfun));
    int n = post_order_compute(order.data(), false, false);
    for (int i = 0; i < n; i++)
        ways[BASIC_BLOCK_FOR_FN(cfun, order[i])] = most_units;
    ways[EXIT_BLOCK_PTR_FOR_FN(cfun)] = 0;
    for (bool again = true; again;) {
        again = false;
        for (int i = 0; i < n; i++) {
            basic_block bb = BASIC_BLOCK_FOR_FN(cfun, order[i]);
            int64_t way = way_from(bb);
            again |= way < ways[bb];
            ways[bb] = way;
        }
    }
}

void promising::accept_silent()
{
    for (auto &b : blocks)
        if (b.second.any_served())
            return;
    tree decl = current_function_decl;
    if (!decl_binds_to_current_def_p(decl))
        return;
    silent[DECL_UID(decl)] = {ways[single_succ(ENTRY_BLOCK_PTR_FOR_FN(cfun))], !bitmap_empty_p(checked)};
    if (TREE_PUBLIC(decl) && !DECL_WEAK(decl) && !DECL_COMDAT(decl))
        told.insert(symbol_of(decl));
}

/* --- rounds to come ---------------------------------------------------------------------------------------- */

/* The byte that tells whether a function of another file is silent. */
tree flag_of(tree function)
{
    std::string name = symbol_of(function);
    tree identifier = get_identifier(name.c_str());
    for (tree f = flags; f; f = TREE_CHAIN(f))
        if (DECL_NAME(TREE_VALUE(f)) == identifier)
            return TREE_VALUE(f);
    tree flag = variable_declare(name.c_str(), unsigned_char_type_node);
    flags = tree_cons(NULL_TREE, flag, flags);
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

/* Makes the variable of a loop, if it is worth it. */
void promising::keep(class loop *loop)
{
    loop_cost &l = loops[loop];
    tree_niter_desc n;
    if (!is_worth_keeping(loop) || !rounds_foresee(loop, &n) || integer_zerop(n.niter))
        return;
    gimple_seq seq = NULL;
    tree zero = build_int_cst(units_type(), 0);
    int64_t limit = most_units / l.least;
    tree rounds = rounds_append(&seq, loop, n, limit);
    tree known = gimple_build(&seq, LT_EXPR, boolean_type_node, rounds, build_int_cst(units_type(), limit));
    tree units = gimple_build(&seq, MULT_EXPR, units_type(), rounds, build_int_cst(units_type(), l.least));
    units = gimple_build(&seq, COND_EXPR, units_type(), known, units, zero);
    if (!l.outside.empty())
        units = gimple_build(&seq, COND_EXPR, units_type(), all_silent(&seq, l.outside), units, zero);
    for (gimple_stmt_iterator gsi = gsi_start(seq); !gsi_end_p(gsi); gsi_next(&gsi))
        own.insert(gsi_stmt(gsi));
    if (seq)
        gsi_insert_seq_on_edge_immediate(loop_preheader_edge(loop), seq);
    gimple_stmt_iterator begin = gsi_after_labels(loop->header);
    create_iv(units, build_int_cst(units_type(), -l.least), NULL_TREE, loop, &begin, false, &l.before,
              &l.after);
    own.insert(SSA_NAME_DEF_STMT(l.after));
}

promise promising::at(basic_block bb)
{
    promise p;
    p.least = ways[bb];
    for (class loop *loop = bb->loop_father; loop_outer(loop); loop = loop_outer(loop)) {
        const loop_cost &l = loops[loop];
        if (l.calls)
            break;
        if (!l.before)
            continue;
        p.more.push_back(bb == loop->header ? l.before : l.after);
        p.least = std::min(most_units, p.least + (bb == loop->header ? 0 : l.least));
        p.for_others = p.for_others || (bb == loop->header && l.others && l.least >= worth_telling);
    }
    return p;
}

std::map<basic_block, promise> promising::run()
{
    loop_optimizer_init(LOOPS_NORMAL | LOOPS_HAVE_RECORDED_EXITS);
    calculate_dominance_info(CDI_DOMINATORS);
    scev_initialize();
    cost_blocks();
    for (auto loop : loops_list(cfun, LI_FROM_INNERMOST))
        look_at_loop(loop);
    find_ways();
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
    for (tree more : p.more)
        end = gimple_build(seq, MINUS_EXPR, units_type(), end, more);
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
    if (!asm_out_file || (told.empty() && !flags))
        return;
    fputs("\t.section .rodata\n", asm_out_file);
    for (const std::string &name : told)
        write_flag("globl", name.c_str(), true);
    for (tree f = flags; f; f = TREE_CHAIN(f))
        write_flag("weak", IDENTIFIER_POINTER(DECL_NAME(TREE_VALUE(f))), false);
}

namespace
{
const ggc_root_tab roots[] = {
    {&flags, 1, sizeof flags, &gt_ggc_mx_tree_node, &gt_pch_nx_tree_node},
    LAST_GGC_ROOT_TAB,
};
}

const ggc_root_tab *promise_roots()
{
    return roots;
}
