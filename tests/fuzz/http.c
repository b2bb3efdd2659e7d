/* http.c - requests to touchstone serve (lab/serve/answers.h), as a client's bytes on a connection. What
 * the bytes ask for is answered, up to the start of a run; "TOKEN" in them is the server's. */
#include <event2/http.h>
#include <event2/listener.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>
#include "fuzz.h"
#include "kernel/xalloc.h"
#include "lab/serve/answers.h"

static const char STUDY[] = "title = \"T\"; program = \"prog\"; machine = \"delta\"; nodes = 2;\n"
                            "axes = ( { name = \"share\"; values = ( 0.5, 1 ); arguments = \"{}\"; } );\n";

static struct live_study *study(void)
{
    static struct live_study *made;
    char *error = NULL;
    if (made)
        return made;
    char *path = fuzz_path("study.cfg"), *program = xchecked(realpath("/bin/true", NULL));
    fuzz_file("study.cfg", STUDY, sizeof STUDY - 1);
    char *note =
        xasprintf("{\"study\": \"%s\", \"program\": \"%s\", \"points\": 2, \"set\": [], \"arguments\": [], "
                  "\"header\": {\"title\": \"T\", \"axes\": {\"share\": [0.5, 1]}}}",
                  path, program);
    fuzz_file("study.json", note, strlen(note));
    made = live_study_open(fuzz_folder(), &error);
    if (!made)
        abort();
    free(path), free(program), free(note);
    return made;
}

static struct evconnlistener *listen_here(struct event_base *base, struct sockaddr_un *at)
{
    *at = (struct sockaddr_un){.sun_family = AF_UNIX};
    snprintf(at->sun_path, sizeof at->sun_path, "%s/socket", fuzz_folder());
    unlink(at->sun_path);
    return xchecked(evconnlistener_new_bind(base, NULL, NULL, LEV_OPT_CLOSE_ON_FREE | LEV_OPT_CLOSE_ON_EXEC,
                                            8, (const struct sockaddr *)at, sizeof *at));
}

/* The request comes in one piece, and the client sends no more. */
static int send_request(const struct sockaddr_un *at, const char *bytes, size_t size)
{
    int fd = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (fd < 0 || connect(fd, (const struct sockaddr *)at, sizeof *at) != 0)
        abort();
    if (send(fd, bytes, size, MSG_NOSIGNAL) != (ssize_t)size)
        abort();
    shutdown(fd, SHUT_WR);
    return fd;
}

static void answer_all(struct event_base *base)
{
    for (int i = 0; i < 8; i++)
        event_base_loop(base, EVLOOP_NONBLOCK);
}

static void serve_request(struct server *s, const char *bytes, size_t size)
{
    struct sockaddr_un at;
    struct event_base *base = xchecked(event_base_new());
    s->http = xchecked(evhttp_new(base));
    s->connections = connections_new(s->http, base);
    evhttp_set_max_headers_size(s->http, SERVE_MOST_HEADERS);
    evhttp_set_max_body_size(s->http, SERVE_MOST_BODY);
    evhttp_set_allowed_methods(s->http, UINT16_MAX);
    evhttp_set_gencb(s->http, answer, s);
    if (!evhttp_bind_listener(s->http, listen_here(base, &at)))
        abort();
    int fd = send_request(&at, bytes, size);
    answer_all(base);
    close(fd);
    answer_all(base);
    evhttp_free(s->http);
    connections_free(s->connections);
    event_base_free(base);
}

/* Replaces each TOKEN; malloc'd. */
static char *with_token(const uint8_t *bytes, size_t size, const char *token, size_t *length)
{
    static const char WORD[] = "TOKEN";
    char *text;
    FILE *out = xchecked(open_memstream(&text, length));
    for (size_t i = 0; i < size;) {
        bool is = size - i >= 5 && !memcmp(bytes + i, WORD, 5);
        fwrite(is ? token : (const char *)bytes + i, 1, is ? TOKEN_DIGITS : 1, out);
        i += is ? 5 : 1;
    }
    fclose(out);
    return text;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    char page[] = "<!DOCTYPE html>", *error = NULL;
    struct live_study *studies[] = {study()};
    char *machines = xchecked(realpath("machines", NULL));
    struct serve_options options = {.places = {"/bin/true", machines, stderr}};
    struct server s = {
        .options = &options, .studies = studies, .count = 1, .page = page, .size = sizeof page - 1};
    if (size > SERVE_MOST_HEADERS)
        return free(machines), 0;
    s.name = (struct server_name){.address = "127.0.0.1", .port = 80};
    strcpy(s.name.token, "0123456789abcdef0123456789abcdef");
    s.streams = event_streams_new();
    s.runs = added_runs_new(&options.places, &error);
    if (!s.runs)
        abort();
    size_t length;
    char *text = with_token(bytes, size, s.name.token, &length);
    serve_request(&s, text, length);
    added_runs_free(s.runs);
    event_streams_free(s.streams);
    free(text);
    free(machines);
    return 0;
}
