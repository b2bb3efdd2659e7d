/* host_section.h - the group host = { ... } of a machine file: the computer on which host programs run. */
#ifndef CONFIG_HOST_SECTION_H
#define CONFIG_HOST_SECTION_H
#include "config/config.h"
#include "config/reader.h"

/* Reads the group into m->host; all zero if there is no such group. Call it after net = { ... } has been
 * read. Returns false with r's error set. */
bool cfg_read_host(struct cfg_reader *r, struct cfg_machine *m);
#endif
