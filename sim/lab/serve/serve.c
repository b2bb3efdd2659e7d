/* serve.c - see serve.h. */
#include "lab/serve/serve.h"
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"
#include "lab/page/page.h"
#include "lab/serve/answers.h"
#include "lab/serve/listening.h"

/* --- what is shown -------------------------------------------------------------------------------------- */

static bool add_study(struct server *s, const char *dir, char **error)
{
    struct live_study *study = live_study_open(dir, error);
    if (!study)
        return false;
    s->studies = xreallocarray(s->studies, s->count + 1, sizeof(struct live_study *));
    s->studies[s->count++] = study;
    return true;
}

/* Makes the page of all that is not a study; studies come to it as data. */
static bool make_page(struct server *s, char **error)
{
    struct page *p = page_new();
    bool ok = true;
    page_set_live(p);
    for (const char *const *input = s->options->inputs; ok && *input; input++)
        ok = live_study_is(*input) ? add_study(s, *input, error) : page_add(p, *input, NULL, error);
    FILE *out = ok ? xchecked(open_memstream(&s->page, &s->size)) : NULL;
    if (ok)
        ok = page_write(p, s->count ? s->studies[0]->name : NULL, out);
    if (out && (fclose(out) != 0 || !ok))
        xexhausted();
    page_free(p);
    return ok;
}

/* --- the server in the pool's loop ---------------------------------------------------------------------- */

static void tell_address(const struct server *s)
{
    bool six = strchr(s->name.address, ':');
    const char *host = s->name.everywhere ? "localhost" : s->name.address;
    fprintf(s->options->out,
            six && !s->name.everywhere ? "http://[%s]:%u/?token=%s\n" : "http://%s:%u/?token=%s\n", host,
            s->name.port, s->name.token);
    fflush(s->options->out);
}

static bool began(void *arg, struct event_base *base)
{
    struct server *s = arg;
    s->http = xchecked(evhttp_new(base));
    s->connections = connections_new(s->http, base);
    evhttp_set_max_headers_size(s->http, SERVE_MOST_HEADERS);
    evhttp_set_max_body_size(s->http, SERVE_MOST_BODY);
    evhttp_set_timeout(s->http, SERVE_IDLE_S);
    evhttp_set_allowed_methods(s->http, UINT16_MAX); /* answer() says which */
    evhttp_set_gencb(s->http, answer, s);
    struct evconnlistener *l = listening_at(base, s->options->address, &s->name.port, &s->error);
    if (!l)
        return false;
    if (!evhttp_bind_listener(s->http, l))
        xexhausted();
    tell_address(s);
    return true;
}

static void ending(void *arg)
{
    struct server *s = arg;
    evhttp_free(s->http);
    connections_free(s->connections);
}

static enum pool_next next(void *arg, struct pool_job **job)
{
    struct server *s = arg;
    return added_runs_next(s->runs, job);
}

static void ended(void *arg, struct pool_job *job)
{
    struct server *s = arg;
    added_runs_ended(s->runs, job);
    answer_news(s);
}

static void second(void *arg)
{
    struct server *s = arg;
    connections_sweep(s->connections);
    for (size_t i = 0; i < s->count; i++)
        live_study_look(s->studies[i]);
    answer_news(s);
}

/* --- all ------------------------------------------------------------------------------------------------ */

static bool begin(struct server *s, char **error)
{
    if (!token_make(s->name.token))
        return *error = xasprintf("the system has no random numbers for a token: %m"), false;
    s->name.address = xstrdup(s->options->address);
    s->name.port = s->options->port;
    s->name.everywhere = listening_is_everywhere(s->options->address);
    s->streams = event_streams_new();
    return make_page(s, error) && (s->runs = added_runs_new(&s->options->places, error));
}

static void end(struct server *s)
{
    for (size_t i = 0; i < s->count; i++)
        live_study_close(s->studies[i]);
    if (s->runs)
        added_runs_free(s->runs);
    if (s->streams)
        event_streams_free(s->streams);
    free(s->studies);
    free(s->page);
    free(s->name.address);
}

bool serve(const struct serve_options *options, char **error)
{
    struct server s = {.options = options};
    struct pool_source source = {
        .next = next, .ended = ended, .second = second, .arg = &s, .began = began, .ending = ending};
    signal(SIGPIPE, SIG_IGN); /* a client may be gone */
    listening_raise_limit();
    bool ok = begin(&s, error);
    if (ok)
        pool_run_from(&source, options->at_once);
    end(&s);
    if (s.error)
        *error = s.error;
    return ok && !s.error;
}
