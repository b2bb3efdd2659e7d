/* cfs.h - the group cfs = { ... } of a machine file: its Concurrent File System. */
#ifndef CFG_CFS_H
#define CFG_CFS_H
#include "config/config.h"
#include "config/reader.h"

/* Reads it from r's root into c. A machine without the group has no such file system: io_nodes is 0. */
bool cfg_read_cfs(struct cfg_reader *r, struct cfg_cfs *c);
#endif
