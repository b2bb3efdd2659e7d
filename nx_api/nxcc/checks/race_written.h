/* race_written.h - the source place of an access, and its name there.
 *
 * GCC's optimisers take the source's expressions apart. So a pass of its own notes names by location before
 * they begin. If what is left of an access could be several of those, their names are joined by "or". */
#ifndef NXCC_RACE_WRITTEN_H
#define NXCC_RACE_WRITTEN_H
#include "base/gcc.h"
#include <string>

/* The pass that notes names, to stand behind the making of SSA form. */
opt_pass *race_written_make_pass();
/* Has a statement a line of its own? */
bool race_has_location(gimple *stmt);
/* Where a statement, or else one near it in its block, is written; UNKNOWN_LOCATION: not known. */
location_t race_location(gimple *stmt);
/* The function in whose source that is; "": not known. */
std::string race_function(gimple *stmt);
/* The name of a reference to memory, by which a statement reads or writes; "": it has none. */
std::string race_name(gimple *stmt, tree ref, bool write);
#endif
