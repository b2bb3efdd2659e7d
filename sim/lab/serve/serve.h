/* serve.h - a page (lab/page/page.h) that is live: studies' progress, and single points run on request. A
 * server of HTTP by libevent, in the loop of the process pool that runs the points.
 *
 *     GET  /           the page
 *     GET  /data       ?study=N: its data as results.json, with added points, and the form for more (JSON)
 *     GET  /events     server-sent events: { studies: [progress ...], runs: [...] }
 *     POST /points     ?study=N: runs a point (added_runs.h); { id }, or { error }
 *     POST /stop       { id }: stops a run
 *
 * request_check.h says what is asked of each request, connections.h of each connection. No path in a request
 * names a file. */
#ifndef LAB_SERVE_SERVE_H
#define LAB_SERVE_SERVE_H
#include <stdbool.h>
#include <stddef.h>
#include "lab/serve/added_runs.h"

enum { SERVE_MOST_HEADERS = 8192, SERVE_MOST_BODY = 16384, SERVE_IDLE_S = 10 };

struct serve_options {
    const char *address;       /* to listen at: 127.0.0.1, ::1 */
    unsigned port;             /* 0: any that is free */
    const char *const *inputs; /* folders of studies, and what else page_add() takes; ended by NULL */
    unsigned at_once;          /* runs at a time */
    struct added_places places;
    FILE *out; /* for the address */
};

/* Serves until SIGINT, SIGTERM or SIGHUP. False with *error malloc'd. */
bool serve(const struct serve_options *options, char **error);
#endif
