/* race_spin.h - reads of variables for whose change a loop waits: ad-hoc synchronisation (Jannesari & Tichy,
 * "Identifying ad-hoc synchronization for enhanced race detection", IPDPS 2010).
 *
 *     while (!done) flick();                      done
 *     for (;;) { masktrap(1); if (queue.count) break; masktrap(0); }      queue.count
 *
 * A loop waits for the value read if the value decides whether the loop is left, together with constants,
 * values from before the loop, and values read in the same way; the address does not change in the loop; and
 * the loop writes nothing that the read may see, and calls nothing but NX's calls that let handlers run. */
#ifndef NXCC_RACE_SPIN_H
#define NXCC_RACE_SPIN_H
#include "base/gcc.h"
#include <set>

/* The statements of the function being compiled that read such variables. The loops' structure is known. */
std::set<gimple *> race_spin_find(function *fun);
#endif
