/* host.h - the part of a machine file that describes the computer on which host programs run. */
#ifndef CFG_HOST_H
#define CFG_HOST_H
#include "config/config.h"
#include "config/reader.h"

/* Reads host = { ... } into m->host; all zero when the machine has none. net = { ... } has been read. */
bool cfg_read_host(struct cfg_reader *r, struct cfg_machine *m);
#endif
