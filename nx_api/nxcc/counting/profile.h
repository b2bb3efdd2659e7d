/* profile.h - what a program has spent, by path of calls, function and source line: for programs built with
 * nxcc --profile.
 *
 * A program keeps a tree of *paths* (struct nxc_path in program_image.h): main; relax called by main;
 * exchange called by that. A function enters its path where it begins, and leaves it where it returns:
 *
 *     path = find(&body)                     the child of nxc_path that is of this function
 *     nxc_path = path                        only if it calls others
 *     ...
 *     nxc_path = that of the caller; return
 *
 * A path has *counts*, one for each segment of the function, and one for each statement with a cost of its
 * own that depends on arguments. Where a segment is charged, its count grows by 1:
 *
 *     left -= 7; path->count[3] += 1         3 units were written in line 12, 4 in line 13 of twice()
 *
 * What one of a count costs, by function (that may be inlined), library function and line, stands in tables
 * of the compiled file, which nobody writes to: struct nxc_weight. So all that is charged is attributed to a
 * path and a line, to the unit, at the cost of one addition a segment.
 *
 * A *closed loop* gives control to nobody. In a closed loop counts are register variables, which are set to 0
 * where the loop is entered, and added to the path's where the loop is left, and before a poll preempts.
 *
 * The profile changes no cost: the same program built without --profile counts the same. */
#ifndef NXCC_PROFILE_H
#define NXCC_PROFILE_H
#include <map>
#include <set>
#include <utility>
#include <vector>

/* False: nothing below may be called. */
extern bool profile_on;

/* Units, by cell: by function, library function and line. */
typedef std::map<int, int64_t> profile_shares;

/* The counts of the function that is being compiled. */
class profiling
{
  public:
    /* in_memory: the function counts without a register. needs_counter: may a statement read or change the
     * counter? */
    profiling(function *f, bool in_memory, bool (*needs_counter)(gimple *));
    /* The cell for the cost of stmt; of the caller-charged leaf that it calls. */
    int cell_of(gimple *stmt) const;
    int cell_of_leaf(gcall *call) const;
    /* Appends: amount units have been charged in bb, for a cell. */
    void add(gimple_seq *seq, basic_block bb, int cell, tree amount);
    /* Appends: the shares have been charged in bb, so many times. */
    void add(gimple_seq *seq, basic_block bb, const profile_shares &shares, tree times);
    /* Appends what is to be done before a call, and around a preemption. `before` is what the one before the
     * preemption has returned. */
    void before_call(gimple_seq *seq) const;
    tree before_preemption(gimple_seq *seq, basic_block bb) const;
    void behind_preemption(gimple_seq *seq, tree before) const;
    /* To be called last: enters and leaves the path, and puts the beginnings and ends of the loops' counts on
     * their edges. */
    void finish();

  private:
    class loop *closed_loop(basic_block bb) const;
    void add_to_slot(gimple_seq *seq, basic_block bb, int slot, tree amount);
    void add_to_path(gimple_seq *seq, int slot, tree amount) const;
    void flush(gimple_seq *seq, basic_block bb) const;
    void begin_sums(class loop *loop) const;
    void end_sums(class loop *loop) const;
    void enter() const;
    void leave() const;

    function *fun;
    bool in_memory, calls;
    int body;
    tree path, caller;                        /* of the function, and of who has called it */
    std::map<int, int> slot_of_cell;          /* slots whose count is units of one cell */
    std::set<int> open_loops;                 /* numbers of the loops that are not closed */
    std::map<std::pair<int, int>, tree> sums; /* by loop number and slot */
};

/* At the end of a compiled file: writes its tables to the assembly. */
void profile_write_tables();
#endif
