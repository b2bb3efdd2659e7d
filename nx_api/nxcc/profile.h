/* profile.h - what a program has spent, by function: for programs built with nxcc --profile.
 *
 * Units are kept in cells (struct nxc_cell in image.h). Each compiled function has a cell for its *body*,
 * that is for all that its code spends, and a cell for each *part* of the body that belongs elsewhere: to a
 * function that is inlined into it, or to a library function in the cost table. A part is added to its cell
 * where it is charged:
 *
 *     left -= 7; part of twice() in main() += 3        the rest of the segment needs no addition
 *
 * The body's cell is brought up to date only where the function gives control away. The counter in memory has
 * the value from when the function last got control, so that the difference has been spent since:
 *
 *     body of main() += counter - left; counter = left; call
 *
 * A *closed loop* gives control to nobody. In a closed loop a part is summed up in a register variable, which
 * is set to 0 where the loop is entered, and added to the cell where the loop is left, and before a poll
 * preempts. A function that counts in memory has no `left`: it adds each charge to its body's cell as well.
 *
 * The profile changes no cost: the same program built without --profile counts the same.
 */
#ifndef NXCC_PROFILE_H
#define NXCC_PROFILE_H
#include <map>
#include <set>
#include <utility>

/* False: no cell is made, and nothing below may be called. */
extern bool profile_on;

/* Units, by cell. */
typedef std::map<int, int64_t> profile_shares;

/* The cells of the function that is being compiled. */
class profiling
{
  public:
    /* in_memory: the function counts without a register. needs_counter: may a statement read or change the
     * counter? */
    profiling(function *f, bool in_memory, bool (*needs_counter)(gimple *));
    /* The cell for the cost of stmt. */
    int cell_of(gimple *stmt) const;
    /* The cell for the cost of a caller-charged leaf. */
    int cell_of_leaf(tree function) const;
    /* Appends: amount has been charged in bb, for a cell. */
    void add(gimple_seq *seq, basic_block bb, int cell, tree amount);
    /* Appends: control is about to be given away; left will be stored to the counter. */
    void give_away(gimple_seq *seq, tree counter, tree left) const;
    /* Appends: adds the sums of bb's closed loop to their cells and sets them to 0. */
    void flush(gimple_seq *seq, basic_block bb) const;
    /* To be called last: puts the beginnings and ends of the sums on the loops' edges. */
    void finish();

  private:
    class loop *closed_loop(basic_block bb) const;
    void begin_sums(class loop *loop) const;
    void end_sums(class loop *loop) const;

    function *fun;
    bool in_memory;
    int body;
    std::set<int> open_loops;                 /* numbers of the loops that are not closed */
    std::map<std::pair<int, int>, tree> sums; /* by loop number and cell */
};

/* At the end of a compiled file: writes its cells to the assembly. */
void profile_write_cells();
#endif
