/* asan_globals.h - red zones behind the variables of a compiled file, and the table of these variables:
 * struct nxc_asan_global of contract/asan.h.
 *
 * With -fdata-sections each variable has a section of its own, to whose end the zone is added. A common
 * variable, for which the linker finds room, asks for more. GCC itself knows nothing of the zones, so that it
 * compiles and counts the program as without them.
 *
 * Left out: variables that have a section by the source's wish, and texts. */
#ifndef NXCC_ASAN_GLOBALS_H
#define NXCC_ASAN_GLOBALS_H

/* plugin: the name that GCC gave it. */
void asan_globals_register(const char *plugin);
#endif
