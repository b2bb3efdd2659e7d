/* cube_service.h - the resident service that shares out a machine's nodes, and runs programs on them. */
#ifndef SRM_CUBE_SERVICE_H
#define SRM_CUBE_SERVICE_H
#include <stdio.h>
#include "config/config.h"

struct service_options {
    const struct cfg_machine *machine;
    const char *machine_path; /* for touchstone run -m, from any folder */
    const char *runner;       /* this binary */
    int socket;               /* listening; service_run closes it */
    FILE *log;
};

/* Serves until SIGINT, SIGTERM or SIGHUP; then kills the programs that run. Clients may go away at any time.
 */
void service_run(const struct service_options *options);
#endif
