/* cfs_section.h - the group cfs = { ... } of a machine file: its Concurrent File System. */
#ifndef CONFIG_CFS_SECTION_H
#define CONFIG_CFS_SECTION_H
#include "config/config.h"
#include "config/reader.h"

/* Reads the group from r's root into c; sets io_nodes to 0 if there is no such group. Returns false with r's
 * error set. */
bool cfg_read_cfs(struct cfg_reader *r, struct cfg_cfs *c);
#endif
