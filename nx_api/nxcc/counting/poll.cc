/* poll.cc - the pass of nxcc --mpi: at each loop and function entry the program polls whether a handler is
 * due. Time is real on MPI, so that nothing is counted. nx_api/mpi/tick.h has the other side.
 *
 * A poll is one piece of inline assembly: a compare with memory and a branch that is not taken. The branch
 * leads to code out of line that saves every register. So the poll changes nothing for the register
 * allocator, and a leaf function stays a leaf. The code moves the stack pointer by 128 bytes first, because a
 * leaf function keeps data below it (the red zone).
 */
#include "counting/poll.h"

static const char poll_text[] = "cmpl\t$0, nxc_due(%%rip)\n"
                                "\tjne\t771f\n"
                                "772:\n"
                                "\t.subsection 1\n"
                                "771:\tleaq\t-128(%%rsp), %%rsp\n"
                                "\tcall\tnxc_enter\n"
                                "\tleaq\t128(%%rsp), %%rsp\n"
                                "\tjmp\t772b\n"
                                "\t.previous";

/* A call of longjmp is the back edge of a loop around setjmp, which no search finds. */
static bool jumps(basic_block bb)
{
    gimple_stmt_iterator gsi = gsi_last_nondebug_bb(bb);
    tree callee = gsi_end_p(gsi) || !is_gimple_call(gsi_stmt(gsi)) ? NULL : gimple_call_fndecl(gsi_stmt(gsi));
    if (!callee || !DECL_EXTERNAL(callee) || !DECL_NAME(callee))
        return false;
    const char *name = IDENTIFIER_POINTER(DECL_NAME(callee));
    return !strcmp(name, "longjmp") || !strcmp(name, "_longjmp") || !strcmp(name, "siglongjmp");
}

/* Every cycle of blocks has a back edge of a depth-first search, whatever shape the loop has. A function
 * without calls cannot be part of a recursion, so that the polls of its loops suffice. */
void poll_mark(function *fun, bool calls, bitmap poll_blocks)
{
    bitmap_clear(poll_blocks);
    mark_dfs_back_edges();
    basic_block bb;
    FOR_EACH_BB_FN (bb, fun) {
        edge e;
        edge_iterator ei;
        FOR_EACH_EDGE (e, ei, bb->succs)
            if (e->flags & EDGE_DFS_BACK)
                bitmap_set_bit(poll_blocks, e->dest->index);
        if (jumps(bb))
            bitmap_set_bit(poll_blocks, bb->index);
    }
    if (calls)
        bitmap_set_bit(poll_blocks, single_succ(ENTRY_BLOCK_PTR_FOR_FN(fun))->index);
}

namespace
{
bool has_calls(function *fun)
{
    basic_block bb;
    FOR_EACH_BB_FN (bb, fun)
        for (gimple_stmt_iterator gsi = gsi_start_bb(bb); !gsi_end_p(gsi); gsi_next(&gsi))
            if (is_gimple_call(gsi_stmt(gsi)) && !gimple_call_internal_p(gsi_stmt(gsi)))
                return true;
    return false;
}

/* A call of setjmp must stay the first statement of its block. */
bool may_begin_with_poll(basic_block bb)
{
    gimple_stmt_iterator gsi = gsi_start_nondebug_after_labels_bb(bb);
    gcall *call = gsi_end_p(gsi) ? NULL : dyn_cast<gcall *>(gsi_stmt(gsi));
    return !call || !(gimple_call_flags(call) & ECF_RETURNS_TWICE);
}

void insert_poll(basic_block bb)
{
    vec<tree, va_gc> *clobbers = NULL;
    vec_safe_push(clobbers, build_tree_list(NULL_TREE, build_string(6, "memory")));
    gasm *statement = gimple_build_asm_vec(poll_text, NULL, NULL, clobbers, NULL);
    gimple_asm_set_volatile(statement, true);
    gimple_stmt_iterator gsi = gsi_after_labels(bb);
    gsi_insert_before(&gsi, statement, GSI_NEW_STMT);
}

const pass_data poll_data = {
    GIMPLE_PASS, "poll", OPTGROUP_NONE, TV_NONE, PROP_cfg | PROP_ssa, 0, 0, 0, TODO_update_ssa,
};

class poll_pass : public gimple_opt_pass
{
  public:
    explicit poll_pass(gcc::context *context) : gimple_opt_pass(poll_data, context) {}
    opt_pass *clone() override { return new poll_pass(m_ctxt); }
    unsigned int execute(function *f) override
    {
        auto_bitmap poll_blocks;
        poll_mark(f, has_calls(f), poll_blocks);
        basic_block bb;
        FOR_EACH_BB_FN (bb, f)
            if (bitmap_bit_p(poll_blocks, bb->index) && may_begin_with_poll(bb))
                insert_poll(bb);
        return 0;
    }
};
} // namespace

opt_pass *poll_make_pass()
{
    return new poll_pass(g);
}
