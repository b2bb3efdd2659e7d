/* prepay.cc - see prepay.h. */
#include "prepay.h"
#include "costs.h"
#include "leaves.h"
#include <map>

namespace
{
/* A check costs little in a longer round or inner loop, and in one whose rounds take more to foresee. */
const unsigned longest_round = 100; /* statements */
const int64_t longest_inner = 32;   /* rounds */
const unsigned most_operations = 12;

class prepaying
{
  public:
    prepaying(bool (*l)(gimple *), bitmap c) : looks(l), checked(c) {}
    prepaid run();

  private:
    bool is_plain(basic_block bb, unsigned *statements) const;
    bool is_plain(class loop *loop, unsigned *statements) const;
    void look_at_loops(class loop *first);
    bool prepare(class loop *loop);
    void divide(class loop *loop, prepaid_loop &p);

    bool (*looks)(gimple *);
    bitmap checked;
    prepaid result;
    std::vector<class loop *> chosen; /* beside result.loops */
};

/* --- how often a loop goes back to its beginning --------------------------------------------------------- */

/* All of a division's kinds, by anything, are too much, but not one by a constant that is known to leave nothing. */
unsigned operations(tree expr)
{
    if (!EXPR_P(expr))
        return 0;
    switch (TREE_CODE(expr)) {
    case TRUNC_DIV_EXPR:
    case FLOOR_DIV_EXPR:
    case CEIL_DIV_EXPR:
    case ROUND_DIV_EXPR:
    case TRUNC_MOD_EXPR:
    case FLOOR_MOD_EXPR:
    case CEIL_MOD_EXPR:
    case ROUND_MOD_EXPR:
        return most_operations + 1;
    default:
        break;
    }
    unsigned sum = 1;
    for (int i = 0; i < TREE_OPERAND_LENGTH(expr); i++)
        sum += operations(TREE_OPERAND(expr, i));
    return sum;
}

/* Is it known, or can be computed where the loop is entered? Most loops' numbers are right without assumptions. */
bool foresee(class loop *loop, tree_niter_desc *n)
{
    edge exit = single_exit(loop);
    return exit && !(exit->flags & EDGE_COMPLEX) &&
           number_of_iterations_exit_assumptions(loop, exit, n, NULL) &&
           operations(n->assumptions) + operations(n->may_be_zero) + operations(n->niter) <= most_operations;
}

/* Always the same, or -1. */
int64_t constant_rounds(class loop *loop)
{
    tree_niter_desc n;
    if (!foresee(loop, &n) || !integer_onep(n.assumptions) || !integer_zerop(n.may_be_zero) ||
        !tree_fits_shwi_p(n.niter))
        return -1;
    return tree_to_shwi(n.niter);
}

tree append_value(gimple_seq *seq, tree expr)
{
    gimple_seq more = NULL;
    tree value = force_gimple_operand(unshare_expr(expr), &more, true, NULL_TREE);
    gimple_seq_add_seq_without_update(seq, more);
    return value;
}

/* Appends the number of rounds: limit if it is that or greater, or if the assumptions are wrong. */
tree append_rounds(gimple_seq *seq, class loop *loop, const tree_niter_desc &n, int64_t limit)
{
    tree type = unsigned_type_for(units_type()), most = build_int_cst(type, limit);
    tree rounds = gimple_convert(seq, unsigned_type_for(TREE_TYPE(n.niter)), append_value(seq, n.niter));
    rounds = gimple_convert(seq, type, rounds);
    if (!integer_zerop(n.may_be_zero))
        rounds = gimple_build(seq, COND_EXPR, type, append_value(seq, n.may_be_zero), build_int_cst(type, 0),
                              rounds);
    widest_int bound;
    if (wi::ges_p(n.max, limit) && !(max_loop_iterations(loop, &bound) && wi::lts_p(bound, limit)))
        rounds = gimple_build(seq, MIN_EXPR, type, rounds, most);
    if (!integer_onep(n.assumptions))
        rounds = gimple_build(seq, COND_EXPR, type, append_value(seq, n.assumptions), rounds, most);
    return gimple_convert(seq, units_type(), rounds);
}

/* --- what a loop costs ------------------------------------------------------------------------------------ */

/* Is the cost known, and looked at by nobody? */
bool prepaying::is_plain(basic_block bb, unsigned *statements) const
{
    if (bb->flags & BB_IRREDUCIBLE_LOOP)
        return false;
    for (gimple_stmt_iterator gsi = gsi_start_nondebug_bb(bb); !gsi_end_p(gsi); gsi_next_nondebug(&gsi)) {
        gimple *stmt = gsi_stmt(gsi);
        gcall *call = dyn_cast<gcall *>(stmt);
        const std::vector<int> *of;
        bool elements;
        if (looks(stmt) || gimple_code(stmt) == GIMPLE_ASM || (call && costs_of_call(call, &of, &elements)))
            return false;
        ++*statements;
    }
    return true;
}

/* The loop's own blocks, without those of inner loops. */
std::vector<basic_block> own_blocks(class loop *loop)
{
    basic_block *body = get_loop_body(loop);
    std::vector<basic_block> own;
    for (unsigned i = 0; i < loop->num_nodes; i++)
        if (body[i]->loop_father == loop)
            own.push_back(body[i]);
    free(body);
    return own;
}

bool prepaying::is_plain(class loop *loop, unsigned *statements) const
{
    for (class loop *inner = loop->inner; inner; inner = inner->next) {
        int64_t rounds = constant_rounds(inner);
        if (rounds < 0 || rounds > longest_inner || !is_plain(inner, statements))
            return false;
    }
    for (basic_block bb : own_blocks(loop))
        if (!is_plain(bb, statements))
            return false;
    return *statements <= longest_round;
}

int64_t cost_of_block(basic_block bb)
{
    int64_t sum = 0;
    for (gimple_stmt_iterator gsi = gsi_start_bb(bb); !gsi_end_p(gsi); gsi_next(&gsi))
        sum += costs_of(gsi_stmt(gsi)) + leaves_cost(gsi_stmt(gsi));
    return sum;
}

/* The units of a round that runs all blocks. */
int64_t dearest_round(class loop *loop)
{
    int64_t sum = 0;
    for (class loop *inner = loop->inner; inner; inner = inner->next)
        sum += dearest_round(inner) * (constant_rounds(inner) + 1);
    for (basic_block bb : own_blocks(loop))
        sum += cost_of_block(bb);
    return sum;
}

/* The units of a round from its beginning to the end of a block, by the cheapest way there is, inner loops once. known:
 * blocks for which that has been found. */
int64_t cheapest_way(class loop *loop, basic_block bb, std::map<basic_block, int64_t> &known)
{
    auto found = known.find(bb);
    if (found != known.end())
        return found->second;
    int64_t before = bb == loop->header ? 0 : INT64_MAX;
    edge e;
    edge_iterator i;
    if (bb != loop->header)
        FOR_EACH_EDGE (e, i, bb->preds)
            if (!dominated_by_p(CDI_DOMINATORS, e->src, bb))
                before = std::min(before, cheapest_way(loop, e->src, known));
    return known[bb] = before + cost_of_block(bb);
}

/* The blocks that every round runs. outer: how often an inner loop is entered; NULL: it is the outermost. */
void list_blocks(class loop *loop, const prepaid_block *outer, std::vector<prepaid_block> &blocks)
{
    int64_t rounds = outer ? constant_rounds(loop) : 0;
    auto runs = [&](basic_block bb) -> prepaid_block {
        int64_t each = dominated_by_p(CDI_DOMINATORS, loop->latch, bb);
        int64_t last = dominated_by_p(CDI_DOMINATORS, single_exit(loop)->src, bb);
        if (!outer)
            return {bb, each, last};
        return {bb, outer->each * (rounds * each + last), outer->last * (rounds * each + last)};
    };
    for (basic_block bb : own_blocks(loop)) {
        prepaid_block block = runs(bb);
        if (block.each || block.last)
            blocks.push_back(block);
    }
    for (class loop *inner = loop->inner; inner; inner = inner->next) {
        prepaid_block block = runs(inner->header);
        list_blocks(inner, &block, blocks);
    }
}

/* --- making the copies ------------------------------------------------------------------------------------- */

/* Computes the rounds where the loop is entered. False: it stays as it is. */
bool prepaying::prepare(class loop *loop)
{
    unsigned statements = 0;
    tree_niter_desc n;
    if (!foresee(loop, &n) || integer_zerop(n.niter) || !optimize_loop_for_speed_p(loop) ||
        !can_duplicate_loop_p(loop) || !is_plain(loop, &statements))
        return false;
    prepaid_loop p = {};
    p.most = dearest_round(loop);
    if (!p.most)
        return false;
    std::map<basic_block, int64_t> known;
    p.least = cheapest_way(loop, loop->latch, known);
    p.least_last = cheapest_way(loop, single_exit(loop)->src, known);
    list_blocks(loop, NULL, p.blocks);
    gimple_seq seq = NULL;
    p.limit = INT64_MAX / 2 / p.most; /* no counter is ever greater */
    p.rounds = append_rounds(&seq, loop, n, p.limit);
    for (gimple_stmt_iterator gsi = gsi_start(seq); !gsi_end_p(gsi); gsi_next(&gsi))
        result.own.insert(gsi_stmt(gsi));
    if (seq)
        gsi_insert_seq_on_edge_immediate(loop_preheader_edge(loop), seq);
    result.loops.push_back(p);
    chosen.push_back(loop);
    return true;
}

/* The outermost loops that can be. */
void prepaying::look_at_loops(class loop *first)
{
    for (class loop *loop = first; loop; loop = loop->next)
        if (!prepare(loop))
            look_at_loops(loop->inner);
}

/* The copy is the loop that pays as it goes, and checks. */
void prepaying::divide(class loop *loop, prepaid_loop &p)
{
    basic_block test;
    profile_probability likely = profile_probability::very_likely(), unlikely = likely.invert();
    unsigned blocks = loop->num_nodes;
    basic_block *body = get_loop_body(loop);
    class loop *copy = loop_version(loop, boolean_true_node, &test, likely, unlikely, likely, unlikely, true);
    for (unsigned i = 0; i < blocks; i++)
        if (bitmap_clear_bit(checked, body[i]->index))
            bitmap_set_bit(checked, get_bb_copy(body[i])->index);
    free(body);
    p.test = as_a<gcond *>(last_stmt(test));
    p.first = loop_preheader_edge(loop)->src;
    p.other = loop_preheader_edge(copy)->src;
    result.own.insert(p.test);
}

prepaid prepaying::run()
{
    loop_optimizer_init(LOOPS_NORMAL | LOOPS_HAVE_RECORDED_EXITS);
    rewrite_into_loop_closed_ssa(NULL, TODO_update_ssa);
    calculate_dominance_info(CDI_DOMINATORS);
    scev_initialize();
    look_at_loops(get_loop(cfun, 0)->inner);
    scev_finalize();
    initialize_original_copy_tables();
    for (size_t i = 0; i < chosen.size(); i++)
        divide(chosen[i], result.loops[i]);
    free_original_copy_tables();
    update_ssa(TODO_update_ssa);
    loop_optimizer_finalize();
    return result;
}
} // namespace

prepaid prepay_loops(bool (*looks)(gimple *), bitmap checked)
{
    return prepaying(looks, checked).run();
}
