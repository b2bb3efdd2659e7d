/* profile.cc - see profile.h. The tables of a compiled file are written as assembly at the end of the file.
 * They refer to each other by distances in bytes, so that nothing is relocated. */
#include "base/gcc.h"
#include "base/costs.h"
#include "counting/profile.h"
#include "output.h"
#include "base/symbols.h"
#include "base/texts.h"
#include "../contract/program_image.h"

bool profile_on;

namespace
{
const char FIND[] = "nxc_find_path"; /* runtime.c */

/* A struct nxc_cell to be written. */
struct cell {
    int parent; /* of a line: its function's cell; of a function: that into which it is inlined; -1: none */
    std::string file, function, called; /* function "": a line */
    int line;
    bool operator<(const cell &o) const
    {
        return std::tie(parent, file, function, called, line) <
               std::tie(o.parent, o.file, o.function, o.called, o.line);
    }
};

/* A struct nxc_body to be written. */
struct body_table {
    int cell;
    std::vector<profile_shares> slots;
};

std::vector<cell> cells;
std::map<cell, int> known;
std::vector<body_table> bodies;
tree body_array, path_word;

int find_cell(const cell &c)
{
    auto found = known.find(c);
    if (found != known.end())
        return found->second;
    cells.push_back(c);
    return known[c] = (int)cells.size() - 1;
}

/* The function in the source of which GCC made a clone or a part. */
tree as_written(tree function)
{
    return DECL_ORIGIN(function);
}

int function_cell(int parent, tree function)
{
    function = as_written(function);
    const char *name = DECL_NAME(function) ? IDENTIFIER_POINTER(DECL_NAME(function)) : "?";
    return find_cell({parent, DECL_SOURCE_FILE(function), name, "", (int)DECL_SOURCE_LINE(function)});
}

/* The functions inlined into each other in which a statement is written, the outermost first. */
std::vector<tree> inlined_functions(gimple *stmt)
{
    std::vector<tree> all;
    for (tree b = gimple_block(stmt); b && TREE_CODE(b) == BLOCK; b = BLOCK_SUPERCONTEXT(b)) {
        if (!inlined_function_outer_scope_p(b))
            continue;
        tree origin = BLOCK_ABSTRACT_ORIGIN(b);
        if (origin && TREE_CODE(origin) == FUNCTION_DECL)
            all.insert(all.begin(), as_written(origin));
    }
    return all;
}

/* The cell of the function in which a statement is written. */
int function_of(int body, gimple *stmt)
{
    int cell = bodies[body].cell;
    tree before = as_written(current_function_decl);
    for (tree function : inlined_functions(stmt)) {
        if (function != before) /* otherwise a part of a function that GCC split, and put together again */
            cell = function_cell(cell, function);
        before = function;
    }
    return cell;
}

/* The line of a statement, or of its function if it has none. */
int line_cell(int function, gimple *stmt, const char *called)
{
    location_t at = gimple_location(stmt);
    expanded_location x = expand_location(at);
    if (LOCATION_LOCUS(at) <= BUILTINS_LOCATION || !x.file)
        return find_cell({function, cells[function].file, "", called, cells[function].line});
    return find_cell({function, x.file, "", called, x.line});
}

tree path_type()
{
    return build_pointer_type(units_type());
}

/* A word of a path. */
tree word_of(tree path, size_t offset)
{
    return build2(MEM_REF, units_type(), path, build_int_cst(path_type(), (HOST_WIDE_INT)offset));
}

tree new_path_word()
{
    if (!path_word)
        path_word = symbols_declare("nxc_path", units_type());
    return path_word;
}

void set_path_word(gimple_seq *seq, tree path)
{
    tree word = make_ssa_name(units_type());
    gimple_seq_add_stmt_without_update(seq, gimple_build_assign(word, NOP_EXPR, path));
    gimple_seq_add_stmt_without_update(seq, gimple_build_assign(new_path_word(), word));
}

/* Returns the value of the word where the sequence ends. */
tree get_path_word(gimple_seq *seq)
{
    tree word = make_ssa_name(units_type());
    gimple_seq_add_stmt_without_update(seq, gimple_build_assign(word, new_path_word()));
    return word;
}

tree address_of_body(int body)
{
    if (!body_array)
        body_array = symbols_define_local("nxc_bodies", build_array_type_nelts(units_type(), 1 << 20));
    size_t words = sizeof(struct nxc_body) / 8;
    return build_fold_addr_expr(build4(ARRAY_REF, units_type(), body_array,
                                       build_int_cst(sizetype, (HOST_WIDE_INT)(words * body)), NULL_TREE,
                                       NULL_TREE));
}
} // namespace

/* --- one function --------------------------------------------------------------------------------------- */

profiling::profiling(function *f, bool memory, bool (*needs_counter)(gimple *))
    : fun(f), in_memory(memory), calls(false), body((int)bodies.size())
{
    bodies.push_back({function_cell(-1, current_function_decl), {}});
    path = make_ssa_name(path_type());
    caller = make_ssa_name(units_type());
    if (!in_memory) {
        if (!current_loops)
            loop_optimizer_init(AVOID_CFG_MODIFICATIONS);
        else if (loops_state_satisfies_p(LOOPS_NEED_FIXUP))
            fix_loop_structure(NULL);
    }
    basic_block bb;
    FOR_EACH_BB_FN (bb, fun)
        for (gimple_stmt_iterator gsi = gsi_start_bb(bb); !gsi_end_p(gsi); gsi_next(&gsi)) {
            if (!needs_counter(gsi_stmt(gsi)))
                continue;
            calls = true;
            for (class loop *l = in_memory ? NULL : bb->loop_father; l; l = loop_outer(l))
                open_loops.insert(l->num);
        }
    open_loops.insert(0); /* the function: the root of GCC's loop tree */
}

int profiling::cell_of(gimple *stmt) const
{
    const char *called = costs_priced_call(stmt);
    return line_cell(function_of(body, stmt), stmt, called ? called : "");
}

/* A leaf's cost is told for its first line: it is the same on all paths through the leaf. */
int profiling::cell_of_leaf(gcall *call) const
{
    int leaf = function_cell(function_of(body, call), gimple_call_fndecl(call));
    return find_cell({leaf, cells[leaf].file, "", "", cells[leaf].line});
}

/* The outermost closed loop around bb, or NULL. */
class loop *profiling::closed_loop(basic_block bb) const
{
    class loop *outermost = NULL;
    if (!in_memory)
        for (class loop *l = bb->loop_father; l && !open_loops.count(l->num); l = loop_outer(l))
            outermost = l;
    return outermost;
}

void profiling::add_to_path(gimple_seq *seq, int slot, tree amount) const
{
    size_t offset = offsetof(struct nxc_path, counts) + 8 * (size_t)slot;
    tree was = make_ssa_name(units_type()), is = make_ssa_name(units_type());
    gimple_seq_add_stmt_without_update(seq, gimple_build_assign(was, word_of(path, offset)));
    gimple_seq_add_stmt_without_update(seq, gimple_build_assign(is, PLUS_EXPR, was, amount));
    gimple_seq_add_stmt_without_update(seq, gimple_build_assign(word_of(path, offset), is));
}

void profiling::add_to_slot(gimple_seq *seq, basic_block bb, int slot, tree amount)
{
    class loop *loop = closed_loop(bb);
    if (!loop) {
        add_to_path(seq, slot, amount);
        return;
    }
    tree &sum = sums[{loop->num, slot}];
    if (!sum)
        sum = create_tmp_reg(units_type(), "part");
    gimple_seq_add_stmt_without_update(seq, gimple_build_assign(sum, PLUS_EXPR, sum, amount));
}

void profiling::add(gimple_seq *seq, basic_block bb, int cell, tree amount)
{
    auto found = slot_of_cell.find(cell);
    if (found == slot_of_cell.end()) {
        bodies[body].slots.push_back({{cell, 1}});
        found = slot_of_cell.insert({cell, (int)bodies[body].slots.size() - 1}).first;
    }
    add_to_slot(seq, bb, found->second, amount);
}

void profiling::add(gimple_seq *seq, basic_block bb, const profile_shares &shares, tree times)
{
    if (shares.empty())
        return;
    bodies[body].slots.push_back(shares);
    add_to_slot(seq, bb, (int)bodies[body].slots.size() - 1, times);
}

/* Behind longjmp, nxc_path is that of the function that has jumped. */
void profiling::before_call(gimple_seq *seq) const
{
    if (in_memory)
        set_path_word(seq, path);
}

tree profiling::before_preemption(gimple_seq *seq, basic_block bb) const
{
    flush(seq, bb);
    tree before = calls ? NULL_TREE : get_path_word(seq);
    if (in_memory || !calls)
        set_path_word(seq, path);
    return before;
}

void profiling::behind_preemption(gimple_seq *seq, tree before) const
{
    if (before)
        gimple_seq_add_stmt_without_update(seq, gimple_build_assign(new_path_word(), before));
}

void profiling::flush(gimple_seq *seq, basic_block bb) const
{
    class loop *loop = closed_loop(bb);
    for (auto &s : sums) {
        if (!loop || s.first.first != loop->num)
            continue;
        add_to_path(seq, s.first.second, s.second);
        gimple_seq_add_stmt_without_update(seq, gimple_build_assign(s.second, units_constant(0)));
    }
}

/* Sets the sums to 0 where a loop is entered. GCC's loops are entered only at their headers. */
void profiling::begin_sums(class loop *loop) const
{
    edge e;
    edge_iterator ei;
    FOR_EACH_EDGE (e, ei, loop->header->preds)
        if (!flow_bb_inside_loop_p(loop, e->src))
            for (auto &s : sums)
                if (s.first.first == loop->num)
                    gsi_insert_on_edge(e, gimple_build_assign(s.second, units_constant(0)));
}

/* Adds the sums to their counts where a loop is left. */
void profiling::end_sums(class loop *loop) const
{
    basic_block bb;
    FOR_EACH_BB_FN (bb, fun) {
        edge e;
        edge_iterator ei;
        FOR_EACH_EDGE (e, ei, bb->succs) {
            if (!flow_bb_inside_loop_p(loop, bb) || flow_bb_inside_loop_p(loop, e->dest))
                continue;
            gimple_seq seq = NULL;
            flush(&seq, bb);
            gsi_insert_seq_on_edge(e, seq);
        }
    }
}

/* Finds the path, by inline assembly: the routine saves every register but that of its result. */
void profiling::enter() const
{
    vec<tree, va_gc> *outputs = NULL, *inputs = NULL, *clobbers = NULL;
    auto operand = [](const char *constraint, tree value) {
        tree text = build_string((int)strlen(constraint) + 1, constraint);
        return build_tree_list(build_tree_list(NULL_TREE, text), value);
    };
    tree given = make_ssa_name(path_type());
    gimple_seq seq = NULL;
    if (calls)
        gimple_seq_add_stmt_without_update(&seq, gimple_build_assign(caller, new_path_word()));
    gimple_seq_add_stmt_without_update(
        &seq, gimple_build_assign(given, fold_convert(path_type(), address_of_body(body))));
    vec_safe_push(outputs, operand("=a", path));
    vec_safe_push(inputs, operand("0", given));
    vec_safe_push(clobbers, build_tree_list(NULL_TREE, build_string(6, "memory")));
    std::string code = std::string("call\t") + FIND;
    gasm *call = gimple_build_asm_vec(code.c_str(), inputs, outputs, clobbers, NULL);
    gimple_asm_set_volatile(call, true);
    SSA_NAME_DEF_STMT(path) = call;
    gimple_seq_add_stmt_without_update(&seq, call);
    if (calls)
        set_path_word(&seq, path);
    gsi_insert_seq_on_edge_immediate(single_succ_edge(ENTRY_BLOCK_PTR_FOR_FN(fun)), seq);
}

void profiling::leave() const
{
    edge e;
    edge_iterator ei;
    FOR_EACH_EDGE (e, ei, EXIT_BLOCK_PTR_FOR_FN(fun)->preds) {
        gimple_stmt_iterator gsi = gsi_last_nondebug_bb(e->src);
        if (gsi_end_p(gsi) || gimple_code(gsi_stmt(gsi)) != GIMPLE_RETURN)
            continue;
        gimple_seq seq = NULL;
        gimple_seq_add_stmt_without_update(&seq, gimple_build_assign(new_path_word(), caller));
        gsi_insert_seq_before(&gsi, seq, GSI_SAME_STMT);
    }
}

void profiling::finish()
{
    int done = 0;
    for (auto &s : sums) {
        if (s.first.first == done)
            continue;
        done = s.first.first;
        begin_sums(get_loop(fun, done));
        end_sums(get_loop(fun, done));
    }
    if (!sums.empty())
        gsi_commit_edge_inserts();
    enter();
    if (calls)
        leave();
}

/* --- the compiled file ---------------------------------------------------------------------------------- */

namespace
{
void write_bodies()
{
    size_t weight = 0;
    fputs("\t.section nxc_bodies,\"a\"\n\t.balign 8\n.Lnxc_bodies:\n", asm_out_file);
    for (size_t i = 0; i < bodies.size(); i++) {
        size_t weights = 0;
        for (const profile_shares &slot : bodies[i].slots)
            weights += slot.size();
        size_t at = sizeof(struct nxc_body) * i;
        fprintf(asm_out_file,
                "\t.long .Lnxc_cells-.Lnxc_bodies-%zu, .Lnxc_weights-.Lnxc_bodies+%zd, %d, %zu, %zu, 0\n", at,
                (ssize_t)(sizeof(struct nxc_weight) * weight) - (ssize_t)at, bodies[i].cell,
                bodies[i].slots.size(), weights);
        weight += weights;
    }
}

void write_cells()
{
    texts all("nxc_text");
    auto write = [&all](const char *end, const std::string &s) {
        if (s.empty())
            fprintf(asm_out_file, "0%s", end);
        else
            fprintf(asm_out_file, ".Lnxc_text%d-.Lnxc_cells%s", all.number(s), end);
    };
    fputs(".Lnxc_cells:\n", asm_out_file);
    for (const cell &c : cells) {
        fprintf(asm_out_file, "\t.long %d, ", c.parent);
        write(", ", remap_macro_filename(c.file.c_str())); /* -ffile-prefix-map */
        write(", ", c.function);
        write(", ", c.called);
        fprintf(asm_out_file, "%d\n", c.line);
    }
    all.write();
}
} // namespace

void profile_write_tables()
{
    if (bodies.empty() || !asm_out_file)
        return;
    write_bodies();
    fputs("\t.section .rodata.nxc,\"a\"\n\t.balign 8\n.Lnxc_weights:\n", asm_out_file);
    for (const body_table &b : bodies)
        for (size_t slot = 0; slot < b.slots.size(); slot++)
            for (auto &share : b.slots[slot])
                fprintf(asm_out_file, "\t.quad %lld\n\t.long %zu, %d\n", (long long)share.second, slot,
                        share.first);
    write_cells();
}
