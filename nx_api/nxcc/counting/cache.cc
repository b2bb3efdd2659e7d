/* cache.cc - see cache.h. */
#include "base/gcc.h"
#include "counting/cache.h"
#include "base/costs.h"
#include "../contract/program_image.h"
#include "base/symbols.h"
#include <math.h>
#include <stdarg.h>

namespace
{
cache_costs cache;
tree tags; /* the variable nxc_cache of cache_runtime.c */

/* An address as base + index * step + index2 + offset; two addresses that differ in offset only are a known
 * distance apart. */
struct spot {
    tree base = NULL_TREE, index = NULL_TREE, step = NULL_TREE,
         index2 = NULL_TREE; /* base NULL: the address is of no such form */
    int64_t offset = 0;
};

/* A load in this block since the last call. */
struct known_load {
    tree ref;
    spot at;
    bool looked_up, marked;
};
std::vector<known_load> loaded;
const int farthest = 64; /* statements ahead that is_on_the_way searches */

/* --- the assembly. %0: the units; %1, %2: scratch; %3: the address; %4: nxc_cache of cache_runtime.c ---- */

std::string text(const char *format, ...) __attribute__((format(printf, 1, 2)));
std::string text(const char *format, ...)
{
    char line[200];
    va_list ap;
    va_start(ap, format);
    vsnprintf(line, sizeof line, format, ap);
    va_end(ap);
    return line;
}

/* The line that was looked at last, with its mark of a change. */
const int SEEN = (NXC_CACHE_SETS + NXC_TLB_SETS) * NXC_CACHE_SET_BYTES;

/* The code for the cache or the translation buffer: where its sets begin in nxc_cache, and its labels. At
 * label + i the code moves way i of a set to the front. marks: lines that have been stored to are marked. */
struct level_code {
    const cache_level &level;
    int begin, label;
    bool marks;

    /* The operand for way i of the set whose offset is in %1. */
    std::string way(int64_t i) const { return text("%d(%%4,%%1)", begin + 8 * (int)i); }

    /* %1 = the offset of the address's set. */
    std::string find_set() const
    {
        int shift = (int)log2((double)level.line / NXC_CACHE_SET_BYTES);
        std::string s = shift ? text("movq\t%%3, %%1\n\tshrq\t$%d, %%1\n\t", shift) : "movl\t%k3, %k1\n\t";
        return s + text("andl\t$%d, %%k1\n\t", (int)(level.sets - 1) * NXC_CACHE_SET_BYTES);
    }

    /* Compares way i with the address, by means of scratch; jump is the conditional jump behind. The mark is
     * within the line. */
    std::string compare(int64_t i, const char *scratch, const std::string &jump, bool see = false) const
    {
        std::string s = text("movq\t%s, %s\n\t", way(i).c_str(), scratch);
        if (see)
            s += text("movq\t%s, %d(%%4)\n\t", scratch, SEEN);
        return s + text("xorq\t%%3, %s\n\tcmpq\t$%d, %s\n\t", scratch, (int)level.line - 1, scratch) + jump +
               "\n\t";
    }

    /* Compares the other ways than the first; a hit jumps to its label. Leaves the line that a miss replaces
     * as the one seen last. */
    std::string compare_others() const
    {
        std::string s;
        for (int i = 1; i < level.ways; i++)
            s += compare(i, "%2", text("jbe\t%df", label + i), marks);
        if (marks && level.ways == 1)
            s += text("movq\t%s, %%2\n\tmovq\t%%2, %d(%%4)\n\t", way(0).c_str(), SEEN);
        return s;
    }

    /* Marks the first line of the set, unless it is marked: the next look-up would wait for that. */
    std::string mark() const
    {
        return text("testb\t$1, %s\n\tjnz\t774f\n\torq\t$1, %s\n774:\t", way(0).c_str(), way(0).c_str());
    }

    /* The address's line becomes the first of its set; the last line is dropped. */
    std::string bring(bool with_labels) const
    {
        std::string s;
        for (int64_t i = level.ways - 1; i > 0; i--)
            s += (with_labels ? text("%d:\t", label + (int)i) : "") + "movq\t" + way(i - 1) +
                 ", %2\n\tmovq\t%2, " + way(i) + "\n\t";
        s += marks && with_labels ? text("movq\t%d(%%4), %%2\n\t", SEEN)
                                  : text("movq\t%%3, %%2\n\tandq\t$%d, %%2\n\t", -(int)level.line);
        return s + "movq\t%2, " + way(0) + "\n\t";
    }
};

const char DONE[] = "jmp\t772b\n\t";

std::string charge(const char *operation, int64_t units)
{
    return text("%s\t$%d, %%0\n\t", operation, (int)units);
}

/* Looks up the line's page, and ends. */
std::string translate(const char *operation)
{
    const level_code tlb = {cache.tlb, NXC_CACHE_SETS * NXC_CACHE_SET_BYTES, 790, false};
    if (!tlb.level.sets)
        return DONE;
    return tlb.find_set() + tlb.compare(0, "%2", "jbe\t772b") + tlb.compare_others() +
           charge(operation, cache.tlb_miss) + tlb.bring(true) + DONE;
}

/* The whole text of a load's or store's look-up. marks: the line is stored to, at once or soon. operation:
 * how a miss is charged to %0, "subq" or "addq". */
std::string look_up_text(bool load, bool marks, const char *operation)
{
    const level_code data = {cache.data, 0, 780, cache.write_back > 0};
    const std::string mark = marks ? data.mark() : "";
    std::string s = data.find_set() + data.compare(0, mark.empty() ? "%1" : "%2", "ja\t771f") + mark +
                    "\n772:\n\t.subsection 1\n771:\t" + data.find_set() + data.compare_others();
    s += charge(operation, load ? cache.load_miss : cache.store_miss);
    if (load && data.marks)
        s +=
            text("testb\t$1, %d(%%4)\n\tjz\t773f\n\t", SEEN) + charge(operation, cache.write_back) + "773:\t";
    if (load)
        s += data.bring(false) + mark;
    s += translate(operation);
    if (data.level.ways > 1)
        s += data.bring(true) + mark + DONE;
    return s + ".previous";
}

/* --- the look-ups of a statement ------------------------------------------------------------------------ */

/* The address of a reference to memory; for a bit-field, of the structure around it. */
tree address_of(tree ref)
{
    tree base = get_base_address(ref);
    if (TREE_CODE(base) == TARGET_MEM_REF)
        return tree_mem_ref_addr(ptr_type_node, unshare_expr(base));
    while (handled_component_p(ref) && TREE_CODE(ref) != COMPONENT_REF && TREE_CODE(ref) != ARRAY_REF)
        ref = TREE_OPERAND(ref, 0);
    if (TREE_CODE(ref) == COMPONENT_REF && DECL_BIT_FIELD(TREE_OPERAND(ref, 1)))
        ref = TREE_OPERAND(ref, 0);
    if (DECL_P(base))
        TREE_ADDRESSABLE(base) = 1;
    return build_fold_addr_expr(unshare_expr(ref));
}

bool is_looked_up(tree ref)
{
    return costs_is_memory(ref) &&
           !(VAR_P(get_base_address(ref)) && DECL_HARD_REGISTER(get_base_address(ref)));
}

spot spot_of(tree ref)
{
    poly_int64 offset;
    int64_t distance;
    tree base = get_addr_base_and_unit_offset(ref, &offset);
    if (!base || !offset.is_constant(&distance))
        return {};
    if (DECL_P(base))
        return {base, NULL_TREE, NULL_TREE, NULL_TREE, distance};
    tree more = TREE_CODE(base) == TARGET_MEM_REF ? TMR_OFFSET(base) : TREE_OPERAND(base, 1);
    if (!tree_fits_shwi_p(more))
        return {};
    distance += tree_to_shwi(more);
    if (TREE_CODE(base) == TARGET_MEM_REF)
        return {TMR_BASE(base), TMR_INDEX(base), TMR_STEP(base), TMR_INDEX2(base), distance};
    return {TREE_OPERAND(base, 0), NULL_TREE, NULL_TREE, NULL_TREE, distance};
}

bool are_same(tree a, tree b)
{
    return a == b || (a && b && operand_equal_p(a, b, 0));
}

bool are_related(const spot &a, const spot &b)
{
    return a.base && b.base && are_same(a.base, b.base) && are_same(a.index, b.index) &&
           are_same(a.step, b.step) && are_same(a.index2, b.index2);
}

const known_load *load_of(tree ref)
{
    for (const known_load &l : loaded)
        if (operand_equal_p(l.ref, ref, 0))
            return &l;
    return NULL;
}

bool ends_what_is_known(gimple *stmt)
{
    return is_gimple_call(stmt) || gimple_code(stmt) == GIMPLE_ASM;
}

/* Is the test true of a statement not far behind stmt, before what is known ends? */
template <typename Test> bool any_behind(gimple *stmt, Test test)
{
    gimple_stmt_iterator gsi = gsi_for_stmt(stmt);
    gsi_next_nondebug(&gsi);
    for (int i = 0; i < farthest && !gsi_end_p(gsi) && !ends_what_is_known(gsi_stmt(gsi)); i++)
        if (test(gsi_stmt(gsi)))
            return true;
        else
            gsi_next_nondebug(&gsi);
    return false;
}

/* Does a statement behind stmt load from an address less than a line away from `from`, so that `at` lies
 * between the two? */
bool is_on_the_way(gimple *stmt, const spot &from, const spot &at)
{
    return any_behind(stmt, [&](gimple *s) {
        if (!gimple_assign_single_p(s) || !is_looked_up(gimple_assign_rhs1(s)))
            return false;
        spot to = spot_of(gimple_assign_rhs1(s));
        int64_t whole = to.offset - from.offset, part = at.offset - from.offset;
        return are_related(from, to) && llabs(whole) < cache.data.line &&
               (whole > 0 ? part >= 0 && part <= whole : part <= 0 && part >= whole);
    });
}

/* Does a statement behind stmt store to ref? */
bool is_stored_to(gimple *stmt, tree ref)
{
    return any_behind(stmt, [&](gimple *s) {
        return is_gimple_assign(s) && operand_equal_p(gimple_assign_lhs(s), ref, 0);
    });
}

/* Does `at` lie between two loads less than a line apart? Then it is in the line of one of them. */
bool is_between(gimple *stmt, const spot &at)
{
    for (const known_load &l : loaded)
        if (l.looked_up && are_related(l.at, at) && is_on_the_way(stmt, l.at, at))
            return true;
    return false;
}

void operand(vec<tree, va_gc> **list, const char *constraint, tree value)
{
    tree c = build_tree_list(NULL_TREE, build_string((int)strlen(constraint) + 1, constraint));
    vec_safe_push(*list, build_tree_list(c, value));
}

void look_up(gimple *stmt, tree ref, bool load, tree left, vec<tree> &units)
{
    const known_load *known = load_of(ref);
    if (!is_looked_up(ref) || (known && (load || known->marked || !cache.write_back)))
        return;
    spot at = load ? spot_of(ref) : spot();
    bool needed = !load || !is_between(stmt, at);
    bool marks = cache.write_back && needed && (!load || is_stored_to(stmt, ref));
    if (load)
        loaded.push_back({ref, at, needed, marks});
    if (!needed)
        return;
    gimple_stmt_iterator gsi = gsi_for_stmt(stmt);
    tree address = force_gimple_operand_gsi(&gsi, fold_convert(ptr_type_node, address_of(ref)), true,
                                            NULL_TREE, true, GSI_SAME_STMT);
    tree l = units_type(), charged = left ? left : make_ssa_name(l);
    vec<tree, va_gc> *in = NULL, *out = NULL;
    operand(&out, "=&r", charged);
    operand(&out, "=&r", make_ssa_name(l));
    operand(&out, "=&r", make_ssa_name(l));
    operand(&in, "r", address);
    operand(&in, "r", build_fold_addr_expr(tags));
    operand(&in, "0", left ? left : build_int_cst(l, 0));
    gasm *a = gimple_build_asm_vec(ggc_strdup(look_up_text(load, marks, left ? "subq" : "addq").c_str()), in,
                                   out, NULL, NULL);
    gimple_asm_set_volatile(a, true);
    for (unsigned i = 0; i < gimple_asm_noutputs(a); i++) {
        tree name = TREE_VALUE(gimple_asm_output_op(a, i));
        if (TREE_CODE(name) == SSA_NAME)
            SSA_NAME_DEF_STMT(name) = a;
    }
    gsi_insert_before(&gsi, a, GSI_SAME_STMT);
    if (!left)
        units.safe_push(charged);
}
} // namespace

void cache_use(const cache_costs &c)
{
    cache = c;
}

bool cache_is_simulated()
{
    return cache.data.sets;
}

void cache_forget()
{
    loaded.clear();
}

void cache_look_up(gimple *stmt, tree left, vec<tree> &units)
{
    if (!cache_is_simulated())
        return;
    if (ends_what_is_known(stmt))
        cache_forget();
    if (!is_gimple_assign(stmt) || gimple_clobber_p(stmt))
        return;
    if (!tags)
        tags = symbols_declare("nxc_cache", units_type());
    if (gimple_assign_single_p(stmt))
        look_up(stmt, gimple_assign_rhs1(stmt), true, left, units);
    look_up(stmt, gimple_assign_lhs(stmt), false, left, units);
}

int64_t cache_most(gimple *stmt)
{
    if (!cache_is_simulated() || !is_gimple_assign(stmt) || gimple_clobber_p(stmt))
        return 0;
    bool load = gimple_assign_single_p(stmt) && is_looked_up(gimple_assign_rhs1(stmt));
    bool store = is_looked_up(gimple_assign_lhs(stmt));
    return load * (cache.load_miss + cache.write_back + cache.tlb_miss) +
           store * (cache.store_miss + cache.tlb_miss);
}
