/* profile.cc - see profile.h. The cells of a compiled file are one array, .Lnxc_cells. It is written as
 * assembly at the end of the file, when their number is known. */
#include "gcc.h"
#include "costs.h"
#include "profile.h"
#include "output.h"
#include "symbols.h"
#include <string>

bool profile_on;

namespace
{
/* A struct nxc_cell (image.h) to be written. */
struct cell {
    std::string file, function, called; /* called: the library function, "" none */
    int line;
    int body; /* the cell of the body of which this is a part; -1: this is a body */
};

enum { CELL_BYTES = 48 }; /* sizeof(struct nxc_cell) */

/* In which function a statement is written, what it calls, and the body of which it is a part. Functions are
 * identified by their DECL_UID, which never changes. */
struct cell_key {
    unsigned function;
    std::string called;
    int body;
    bool operator<(const cell_key &o) const
    {
        return std::tie(function, called, body) < std::tie(o.function, o.called, o.body);
    }
};

std::vector<cell> cells;
std::map<cell_key, int> known;
tree array; /* .Lnxc_cells, as longs */

/* The function in the source of which GCC made a clone or a part. */
tree as_written(tree function)
{
    return DECL_ORIGIN(function);
}

int find_cell(tree function, const char *called, int body)
{
    function = as_written(function);
    /* a function and each of its clones have a body of their own */
    cell_key key = {body < 0 ? DECL_UID(current_function_decl) : DECL_UID(function), called, body};
    auto found = known.find(key);
    if (found != known.end())
        return found->second;
    const char *name = DECL_NAME(function) ? IDENTIFIER_POINTER(DECL_NAME(function)) : "?";
    cells.push_back({DECL_SOURCE_FILE(function), name, called, DECL_SOURCE_LINE(function), body});
    return known[key] = (int)cells.size() - 1;
}

/* nxc_cell.units of a cell, in memory. */
tree units_of(int cell)
{
    if (!array)
        array = symbols_define_local("nxc_cells", build_array_type_nelts(units_type(), 1 << 20));
    return build2(MEM_REF, units_type(), build_fold_addr_expr(array),
                  build_int_cst(build_pointer_type(units_type()), cell * CELL_BYTES));
}

void add_to_cell(gimple_seq *seq, int cell, tree amount)
{
    tree was = make_ssa_name(units_type());
    tree is = make_ssa_name(units_type());
    gimple_seq_add_stmt_without_update(seq, gimple_build_assign(was, units_of(cell)));
    gimple_seq_add_stmt_without_update(seq, gimple_build_assign(is, PLUS_EXPR, was, amount));
    gimple_seq_add_stmt_without_update(seq, gimple_build_assign(units_of(cell), is));
}

void write_string(const std::string &s)
{
    fputs("\t.string \"", asm_out_file);
    for (char c : s) {
        if (c == '"' || c == '\\')
            fputc('\\', asm_out_file);
        fputc(c, asm_out_file);
    }
    fputs("\"\n", asm_out_file);
}
} // namespace

/* --- one function --------------------------------------------------------------------------------------- */

profiling::profiling(function *f, bool memory, bool (*needs_counter)(gimple *)) : fun(f), in_memory(memory)
{
    body = find_cell(current_function_decl, "", -1);
    if (in_memory)
        return;
    if (!current_loops)
        loop_optimizer_init(AVOID_CFG_MODIFICATIONS);
    else if (loops_state_satisfies_p(LOOPS_NEED_FIXUP))
        fix_loop_structure(NULL);
    basic_block bb;
    FOR_EACH_BB_FN (bb, fun)
        for (gimple_stmt_iterator gsi = gsi_start_bb(bb); !gsi_end_p(gsi); gsi_next(&gsi))
            if (needs_counter(gsi_stmt(gsi)))
                for (class loop *l = bb->loop_father; l; l = loop_outer(l))
                    open_loops.insert(l->num);
    open_loops.insert(0); /* the function: the root of GCC's loop tree */
}

int profiling::cell_of(gimple *stmt) const
{
    tree function = costs_written_in(stmt);
    const char *called = costs_priced_call(stmt);
    if (!called && as_written(function) == as_written(current_function_decl))
        return body;
    return find_cell(function, called ? called : "", body);
}

int profiling::cell_of_leaf(tree function) const
{
    return find_cell(function, "", body);
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

void profiling::add(gimple_seq *seq, basic_block bb, int cell, tree amount)
{
    if (in_memory)
        add_to_cell(seq, body, amount);
    if (cell == body)
        return;
    class loop *loop = closed_loop(bb);
    if (!loop) {
        add_to_cell(seq, cell, amount);
        return;
    }
    tree &sum = sums[{loop->num, cell}];
    if (!sum)
        sum = create_tmp_reg(units_type(), "part");
    gimple_seq_add_stmt_without_update(seq, gimple_build_assign(sum, PLUS_EXPR, sum, amount));
}

void profiling::give_away(gimple_seq *seq, tree counter, tree left) const
{
    tree was = make_ssa_name(units_type());
    tree spent = make_ssa_name(units_type());
    gimple_seq_add_stmt_without_update(seq, gimple_build_assign(was, counter));
    gimple_seq_add_stmt_without_update(seq, gimple_build_assign(spent, MINUS_EXPR, was, left));
    add_to_cell(seq, body, spent);
}

void profiling::flush(gimple_seq *seq, basic_block bb) const
{
    class loop *loop = closed_loop(bb);
    for (auto &s : sums) {
        if (!loop || s.first.first != loop->num)
            continue;
        add_to_cell(seq, s.first.second, s.second);
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

/* Adds the sums to their cells where a loop is left. */
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
}

/* --- the compiled file ---------------------------------------------------------------------------------- */

void profile_write_cells()
{
    if (cells.empty() || !asm_out_file)
        return;
    fputs("\t.section nxc_cells,\"aw\"\n\t.balign 8\n.Lnxc_cells:\n", asm_out_file);
    for (size_t i = 0; i < cells.size(); i++) {
        fprintf(asm_out_file, "\t.quad 0, .Lnxc_file%zu, .Lnxc_function%zu, ", i, i);
        fprintf(asm_out_file, cells[i].called.empty() ? "0" : ".Lnxc_called%zu", i);
        fprintf(asm_out_file, cells[i].body < 0 ? ", 0, " : ", .Lnxc_cells+%d, ", cells[i].body * CELL_BYTES);
        fprintf(asm_out_file, "%d\n", cells[i].line);
    }
    fputs("\t.section .rodata.str1.1,\"aMS\",@progbits,1\n", asm_out_file);
    for (size_t i = 0; i < cells.size(); i++) {
        fprintf(asm_out_file, ".Lnxc_file%zu:\n", i);
        write_string(cells[i].file);
        fprintf(asm_out_file, ".Lnxc_function%zu:\n", i);
        write_string(cells[i].function);
        if (cells[i].called.empty())
            continue;
        fprintf(asm_out_file, ".Lnxc_called%zu:\n", i);
        write_string(cells[i].called);
    }
}
