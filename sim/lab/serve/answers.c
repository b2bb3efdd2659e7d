/* answers.c - see answers.h. */
#include "lab/serve/answers.h"
#include <event2/buffer.h>
#include <event2/keyvalq_struct.h>
#include <stdlib.h>
#include <string.h>
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "lab/serve/point_request.h"

/* --- replies -------------------------------------------------------------------------------------------- */

static void reply(struct evhttp_request *request, int status, const char *type, struct evbuffer *body)
{
    static const char *const ALWAYS[][2] = {{"Cache-Control", "no-store"},
                                            {"X-Content-Type-Options", "nosniff"},
                                            {"Referrer-Policy", "no-referrer"},
                                            {"Cross-Origin-Resource-Policy", "same-origin"},
                                            {"Content-Security-Policy", "frame-ancestors 'none'"}};
    struct evkeyvalq *headers = evhttp_request_get_output_headers(request);
    for (size_t i = 0; i < sizeof ALWAYS / sizeof *ALWAYS; i++)
        evhttp_add_header(headers, ALWAYS[i][0], ALWAYS[i][1]);
    evhttp_add_header(headers, "Content-Type", type);
    evhttp_send_reply(request, status, NULL, body);
}

/* Takes over the value. */
static void reply_json(struct evhttp_request *request, int status, json_t *value)
{
    struct evbuffer *body = xchecked(evbuffer_new());
    char *text = xchecked(json_dumps(value, JSON_COMPACT | JSON_REAL_PRECISION(17)));
    evbuffer_add(body, text, strlen(text));
    reply(request, status, "application/json", body);
    evbuffer_free(body);
    free(text);
    json_decref(value);
}

static void reply_error(struct evhttp_request *request, int status, const char *error)
{
    reply_json(request, status, json_pack("{s:o}", "error", json_text(error)));
}

/* --- what is asked -------------------------------------------------------------------------------------- */

/* The study that ?study=N names; NULL after an answer. */
static struct live_study *study_of(struct server *s, struct evhttp_request *request)
{
    struct evkeyvalq query = {0};
    const char *question = strchr(evhttp_request_get_uri(request), '?');
    evhttp_parse_query_str(question ? question + 1 : "", &query);
    const char *text = evhttp_find_header(&query, "study");
    size_t digits = text ? strspn(text, "0123456789") : 0;
    unsigned long number = digits && digits < 7 && !text[digits] ? strtoul(text, NULL, 10) : s->count;
    evhttp_clear_headers(&query);
    if (number < s->count)
        return s->studies[number];
    reply_error(request, 404, "there is no such study: study=0 is the first");
    return NULL;
}

/* The body as a JSON object, owned by the caller; NULL after an answer. */
static json_t *body_of(struct evhttp_request *request)
{
    struct evbuffer *in = evhttp_request_get_input_buffer(request);
    size_t size = evbuffer_get_length(in);
    const char *bytes = (const char *)evbuffer_pullup(in, -1);
    json_t *body = bytes ? json_loadb(bytes, size, JSON_REJECT_DUPLICATES, NULL) : NULL;
    if (json_is_object(body))
        return body;
    json_decref(body);
    reply_error(request, 400, "the request's body must be a JSON object");
    return NULL;
}

static void answer_page(struct server *s, struct evhttp_request *request)
{
    struct evbuffer *body = xchecked(evbuffer_new());
    evbuffer_add_reference(body, s->page, s->size, NULL, NULL);
    reply(request, 200, "text/html; charset=utf-8", body);
    evbuffer_free(body);
}

static void answer_data(struct server *s, struct evhttp_request *request)
{
    struct live_study *study = study_of(s, request);
    if (!study)
        return;
    json_t *data = live_study_data(study);
    json_set(data, "form", point_request_form(study->note));
    reply_json(request, 200, data);
}

static void answer_events(struct server *s, struct evhttp_request *request)
{
    connections_asked(s->connections, request, true);
    if (!event_streams_add(s->streams, request))
        reply_error(request, 503, "too many pages listen: close some");
}

static void answer_points(struct server *s, struct evhttp_request *request)
{
    static const int STATUS[] = {
        [ADDED_TAKEN] = 202, [ADDED_WRONG] = 400, [ADDED_KNOWN] = 409, [ADDED_TOO_MANY] = 429};
    struct live_study *study = study_of(s, request);
    json_t *body = study ? body_of(request) : NULL;
    unsigned id = 0;
    char *error = NULL;
    if (!body)
        return;
    enum added_answer is = added_runs_ask(s->runs, study, body, &id, &error);
    if (is == ADDED_TAKEN)
        reply_json(request, STATUS[is], json_pack("{s:i}", "id", (int)id));
    else
        reply_error(request, STATUS[is], error);
    free(error);
    json_decref(body);
    answer_news(s);
}

static void answer_stop(struct server *s, struct evhttp_request *request)
{
    json_t *body = body_of(request);
    if (!body)
        return;
    json_int_t id = json_integer_value(json_object_get(body, "id"));
    if (id > 0 && id <= UINT32_MAX && added_runs_stop(s->runs, (unsigned)id))
        reply_json(request, 200, json_object());
    else
        reply_error(request, 404, "there is no such run that waits or runs");
    json_decref(body);
    answer_news(s);
}

/* --- which answer --------------------------------------------------------------------------------------- */

static const struct path {
    const char *path, *method;
    enum evhttp_cmd_type command;
    void (*answer)(struct server *s, struct evhttp_request *request);
} PATHS[] = {{"/", "GET", EVHTTP_REQ_GET, answer_page},
             {"/data", "GET", EVHTTP_REQ_GET, answer_data},
             {"/events", "GET", EVHTTP_REQ_GET, answer_events},
             {"/points", "POST", EVHTTP_REQ_POST, answer_points},
             {"/stop", "POST", EVHTTP_REQ_POST, answer_stop}};

static const struct path *path_of(const char *uri)
{
    size_t length = strcspn(uri, "?");
    for (size_t i = 0; i < sizeof PATHS / sizeof *PATHS; i++)
        if (strlen(PATHS[i].path) == length && !strncmp(PATHS[i].path, uri, length))
            return &PATHS[i];
    return NULL;
}

void answer(struct evhttp_request *request, void *arg)
{
    struct server *s = arg;
    int status;
    connections_asked(s->connections, request, false);
    const char *wrong = request_wrong(request, &s->name, &status);
    const struct path *path = wrong ? NULL : path_of(evhttp_request_get_uri(request));
    if (wrong) {
        reply_error(request, status, wrong);
    } else if (!path) {
        reply_error(request, 404, "there is nothing here: the page is /");
    } else if (evhttp_request_get_command(request) != path->command) {
        evhttp_add_header(evhttp_request_get_output_headers(request), "Allow", path->method);
        reply_error(request, 405, "this path takes another method");
    } else {
        path->answer(s, request);
    }
}

void answer_news(struct server *s)
{
    json_t *studies = json_array();
    for (size_t i = 0; i < s->count; i++) {
        json_t *progress = live_study_progress(s->studies[i]);
        json_set(progress, "name", json_text(s->studies[i]->name));
        json_append(studies, progress);
    }
    json_t *news = json_pack("{s:o, s:o}", "studies", studies, "runs", added_runs_json(s->runs));
    char *text = xchecked(json_dumps(news, JSON_COMPACT));
    event_streams_send(s->streams, text);
    free(text);
    json_decref(news);
}
