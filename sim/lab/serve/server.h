/* server.h - what a server consists of: serve.c puts it together, answers.c lets it answer. */
#ifndef LAB_SERVE_SERVER_H
#define LAB_SERVE_SERVER_H
#include <event2/http.h>
#include "lab/serve/connections.h"
#include "lab/serve/event_streams.h"
#include "lab/serve/request_check.h"
#include "lab/serve/serve.h"

struct server {
    const struct serve_options *options;
    struct server_name name;
    struct evhttp *http;
    struct connections *connections;
    struct event_streams *streams;
    struct live_study **studies; /* count of them */
    size_t count;
    struct added_runs *runs;
    char *page; /* the HTML, size bytes */
    size_t size;
    char *error; /* why it cannot listen */
};
#endif
