/* profile.h - what a program has cost, by function: for programs built with nxcc --profile.
 *
 * Cost is kept in cells (struct nxc_cell in image.h). Each function compiled has one for its body, that is all that its
 * code costs, and further ones for the parts of this that belong elsewhere: to a function inlined into it, or to a
 * library call that the cost table prices. A part is added where it is paid:
 *
 *     left -= 7; part of twice() in main() += 3        what else a stretch costs is the function's own: no more to do
 *
 * The body needs no additions but at its ends. What lies in memory is what was left when the function last got control,
 * so that before it stores `left` there, to give control away, it adds the difference:
 *
 *     body of main() += counter - left; counter = left; call
 *
 * In a loop that gives control to nobody, a part is summed up in a register variable, from 0 where the loop is entered
 * to the cell where it is left (and before a check of it calls the simulator). A function that counts in memory has no
 * `left`: it adds each payment to its body as well.
 *
 * The cost itself is untouched: the same program built without --profile counts the same.
 */
#ifndef NXCC_PROFILE_H
#define NXCC_PROFILE_H
#include <map>
#include <set>
#include <utility>

/* False: no cell is made, and the functions below are not to be called. */
extern bool profile_on;

/* Units by cell. */
typedef std::map<int, int64_t> profile_shares;

/* The cells of one function while it is made to count. */
class profiling
{
  public:
    /* in_memory: it counts without a register. looks: may this statement look at the counter? */
    profiling(function *f, bool in_memory, bool (*needs_counter)(gimple *));
    /* The cell of what stmt costs. */
    int cell_of(gimple *stmt) const;
    /* The cell of what another function costs that leaves paying to this one. */
    int cell_of_leaf(tree function) const;
    /* Appends: amount has been paid in bb for cell. */
    void add(gimple_seq *seq, basic_block bb, int cell, tree amount);
    /* Appends: control is about to be given away; the counter in memory will be left. */
    void give_away(gimple_seq *seq, tree counter, tree left) const;
    /* Appends: the sums of bb's loop go to their cells and begin anew. */
    void flush(gimple_seq *seq, basic_block bb) const;
    /* When all has been added: begins and ends the sums at the loops' edges. */
    void finish();

  private:
    class loop *closed_loop(basic_block bb) const;
    void begin_sums(class loop *loop) const;
    void end_sums(class loop *loop) const;

    function *fun;
    bool in_memory;
    int body;
    std::set<int> open_loops;                       /* numbers of loops in which the counter may be looked at */
    std::map<std::pair<int, int>, tree> sums; /* by number of loop, and cell */
};

/* Writes the unit's cells to the assembly. */
void profile_write_cells();
#endif
