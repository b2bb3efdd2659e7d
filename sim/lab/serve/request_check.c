/* request_check.c - see request_check.h. */
#include "lab/serve/request_check.h"
#include <arpa/inet.h>
#include <event2/keyvalq_struct.h>
#include <nettle/memops.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/random.h>
#include <unistd.h>

enum { MOST_URI = 512, MOST_NAME = 256 };

bool token_make(char token[TOKEN_DIGITS + 1])
{
    uint8_t bytes[TOKEN_DIGITS / 2];
    if (getrandom(bytes, sizeof bytes, 0) != sizeof bytes)
        return false;
    for (size_t i = 0; i < sizeof bytes; i++)
        snprintf(token + 2 * i, 3, "%02x", bytes[i]);
    return true;
}

/* The header's value; NULL if there is none, or more than one. */
static const char *only_header(struct evhttp_request *request, const char *name, size_t *count)
{
    struct evkeyvalq *headers = evhttp_request_get_input_headers(request);
    const char *value = NULL;
    *count = 0;
    for (const struct evkeyval *one = headers->tqh_first; one; one = one->next.tqe_next)
        if (!strcasecmp(one->key, name)) {
            value = one->value;
            ++*count;
        }
    return *count == 1 ? value : NULL;
}

/* An address, in brackets if it has colons, is no name that anybody could have made lead here. */
static bool is_address(const char *name)
{
    struct in6_addr a;
    size_t length = strlen(name);
    char inner[MOST_NAME];
    if (inet_pton(AF_INET, name, &a) == 1)
        return true;
    if (*name != '[' || length < 3 || name[length - 1] != ']')
        return false;
    snprintf(inner, sizeof inner, "%.*s", (int)length - 2, name + 1);
    return inet_pton(AF_INET6, inner, &a) == 1;
}

static bool is_own_name(const char *name, const struct server_name *s)
{
    char own[MOST_NAME] = "", bracketed[MOST_NAME];
    snprintf(bracketed, sizeof bracketed, "[%s]", s->address);
    if (!strcasecmp(name, "localhost") || !strcmp(name, s->address) || !strcmp(name, bracketed))
        return true;
    gethostname(own, sizeof own - 1);
    return s->everywhere && (is_address(name) || (*own && !strcasecmp(name, own)));
}

/* NAME:PORT, of this server? */
static bool is_own_host(const char *host, const struct server_name *s)
{
    char name[MOST_NAME], port[16];
    const char *colon = strrchr(host, ':');
    if (!colon || colon - host >= MOST_NAME)
        return false;
    snprintf(name, sizeof name, "%.*s", (int)(colon - host), host);
    snprintf(port, sizeof port, "%u", s->port);
    return !strcmp(colon + 1, port) && is_own_name(name, s);
}

/* Is the origin http:// and the host? */
static bool is_own_origin(const char *origin, const char *host)
{
    return !strncmp(origin, "http://", 7) && !strcmp(origin + 7, host);
}

static bool has_token(const char *uri, const struct server_name *s)
{
    struct evkeyvalq query;
    const char *question = strchr(uri, '?'), *token;
    if (!question || evhttp_parse_query_str(question + 1, &query) != 0)
        return false;
    token = evhttp_find_header(&query, "token");
    bool has = token && strlen(token) == TOKEN_DIGITS && memeql_sec(token, s->token, TOKEN_DIGITS);
    evhttp_clear_headers(&query);
    return has;
}

const char *request_wrong(struct evhttp_request *request, const struct server_name *s, int *status)
{
    size_t hosts, origins;
    const char *uri = evhttp_request_get_uri(request), *host = only_header(request, "Host", &hosts),
               *origin = only_header(request, "Origin", &origins);
    bool changes = evhttp_request_get_command(request) == EVHTTP_REQ_POST;
    *status = 414;
    if (!uri || strlen(uri) > MOST_URI)
        return "the address is too long";
    *status = 400;
    if (*uri != '/')
        return "the address must be a path of this server";
    *status = 403;
    if (!host || !is_own_host(host, s))
        return "this server has another name: use the address that it printed";
    if (origins > 1 || (origin && !is_own_origin(origin, host)) || (changes && !origin))
        return "only the server's own page may ask this";
    return has_token(uri, s)
               ? NULL
               : "the token is missing or wrong: use the whole address that touchstone serve printed";
}
