/* race_sites.h - the table of a compiled file's accesses to memory: struct nxc_race_site of contract/races.h.
 *
 * The table is written as assembly at the end of the file. Inline assembly refers to a site as
 * .Lnxc_races+OFFSET. */
#ifndef NXCC_RACE_SITES_H
#define NXCC_RACE_SITES_H
#include "base/gcc.h"
#include <string>

/* Does the source say that what a statement accesses is no race? */
bool race_site_is_ignored(gimple *stmt);
/* The offset of a site in the table, in bytes. stmt accesses the variable; bytes: 0 if the program tells
 * them; flags: enum nxc_race_flags. Equal sites are one. */
size_t race_site(gimple *stmt, const std::string &variable, unsigned bytes, unsigned flags);
/* A site for the declaration of a local variable, which is no access and tells no bytes. */
size_t race_site_of_declaration(tree variable, tree function, unsigned flags);
/* At the end of a compiled file: writes the table. */
void race_sites_write();
#endif
