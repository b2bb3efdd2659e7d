/* summary_text.c - see summary_text.h. */
#include "nx_api/mpi/summary_text.h"
#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "nx_api/contract/spread.h"

static double waited(const struct summary_part *p)
{
    double sum = 0;
    for (size_t i = 0; i < p->wait_count; i++)
        sum += p->waits[i].seconds;
    return sum;
}

static double computed(const struct summary_part *p)
{
    return p->ended_s - waited(p) - p->handlers_s;
}

static double latest(const struct summary_part *parts, uint32_t count)
{
    struct spread s = {.count = 0};
    for (uint32_t i = 0; i < count; i++)
        spread_add(&s, parts[i].ended_s);
    return s.most;
}

static uint32_t hosts(const struct summary_part *parts, uint32_t count)
{
    uint32_t different = 0;
    for (uint32_t i = 0; i < count; i++) {
        uint32_t k = 0;
        while (strcmp(parts[k].host, parts[i].host) != 0)
            k++;
        different += k == i;
    }
    return different;
}

/* --- for people --- */

static void print_messages(FILE *f, const struct summary_part *parts, uint32_t count)
{
    struct spread sent = {.count = 0}, bytes = {.count = 0};
    for (uint32_t i = 0; i < count; i++) {
        spread_add(&sent, (double)parts[i].sent);
        spread_add(&bytes, (double)parts[i].bytes);
    }
    fprintf(f, "messages       %.0f, %.0f bytes; a node sent %.0f to %.0f, %.0f to %.0f bytes\n", sent.sum,
            bytes.sum, sent.least, sent.most, bytes.least, bytes.most);
}

static void print_spread(FILE *f, const char *what, const struct spread *s)
{
    fprintf(f, "  %s %.6f s", what, s->sum / s->count);
    if (s->count > 1)
        fprintf(f, " (%.6f to %.6f)", s->least, s->most);
}

static void print_nodes(FILE *f, const struct summary_part *parts, uint32_t count)
{
    struct spread busy = {.count = 0}, idle = {.count = 0}, handlers = {.count = 0};
    for (uint32_t i = 0; i < count; i++) {
        spread_add(&busy, computed(&parts[i]));
        spread_add(&idle, waited(&parts[i]));
        spread_add(&handlers, parts[i].handlers_s);
    }
    fprintf(f, "nodes          %u %s:", count, count == 1 ? "node" : "nodes");
    print_spread(f, "busy", &busy);
    print_spread(f, "waiting", &idle);
    print_spread(f, "in handlers", &handlers);
    fputc('\n', f);
}

static const struct summary_wait *find(const struct summary_part *p, const char *call)
{
    for (size_t i = 0; i < p->wait_count; i++)
        if (strcmp(p->waits[i].call, call) == 0)
            return &p->waits[i];
    return NULL;
}

/* Is this the first node that has waited in its i-th call? */
static bool is_first(const struct summary_part *parts, uint32_t node, size_t i)
{
    for (uint32_t k = 0; k < node; k++)
        if (find(&parts[k], parts[node].waits[i].call))
            return false;
    return true;
}

static void print_waits_of(FILE *f, const struct summary_part *parts, uint32_t count, const char *call)
{
    struct spread s = {.count = 0};
    uint64_t times = 0;
    for (uint32_t i = 0; i < count; i++) {
        const struct summary_wait *w = find(&parts[i], call);
        spread_add(&s, w ? w->seconds : 0);
        times += w ? w->times : 0;
    }
    fprintf(f, "waits          in %s %" PRIu64 " times:", call, times);
    print_spread(f, "a node", &s);
    fputc('\n', f);
}

static void print_handlers(FILE *f, const struct summary_part *parts, uint32_t count)
{
    struct spread s = {.count = 0};
    for (uint32_t i = 0; i < count; i++)
        spread_add(&s, (double)parts[i].handlers);
    if (s.sum > 0)
        fprintf(f, "interrupts     %.0f handlers run; a node ran %.0f to %.0f\n", s.sum, s.least, s.most);
}

/* In one piece: mpirun forwards what other nodes write, too. */
void summary_write_text(const struct summary_part *parts, uint32_t count)
{
    char *text;
    size_t size;
    FILE *f = open_memstream(&text, &size);
    if (!f)
        return;
    uint32_t n = hosts(parts, count);
    fprintf(f, "time           %.6f s on %u %s of %u %s\n", latest(parts, count), count,
            count == 1 ? "node" : "nodes", n, n == 1 ? "computer" : "computers");
    print_messages(f, parts, count);
    print_nodes(f, parts, count);
    for (uint32_t i = 0; i < count; i++)
        for (size_t k = 0; k < parts[i].wait_count; k++)
            if (is_first(parts, i, k))
                print_waits_of(f, parts, count, parts[i].waits[k].call);
    print_handlers(f, parts, count);
    fclose(f);
    fwrite(text, 1, size, stderr);
    free(text);
}

/* --- for programs --- */

static void put_text(FILE *f, const char *s)
{
    fputc('"', f);
    for (; *s; s++)
        if (*s == '"' || *s == '\\' || (unsigned char)*s < ' ')
            fprintf(f, "\\u%04x", (unsigned char)*s);
        else
            fputc(*s, f);
    fputc('"', f);
}

static void put_node(FILE *f, const struct summary_part *p)
{
    fputs("  {\"host\": ", f);
    put_text(f, p->host);
    fprintf(f, ", \"ended_s\": %.9f, \"busy_s\": %.9f, \"idle_s\": %.9f, \"handlers_s\": %.9f,\n", p->ended_s,
            computed(p), waited(p), p->handlers_s);
    fprintf(f, "   \"messages_sent\": %" PRIu64 ", \"bytes_sent\": %" PRIu64 ", \"handlers\": %" PRIu64,
            p->sent, p->bytes, p->handlers);
    fprintf(f, ", \"exit_code\": %" PRId64 ",\n   \"waits\": [", p->exit_code);
    for (size_t i = 0; i < p->wait_count; i++)
        fprintf(f, "%s{\"call\": \"%s\", \"idle_s\": %.9f, \"waits\": %" PRIu64 "}", i ? ", " : "",
                p->waits[i].call, p->waits[i].seconds, p->waits[i].times);
    fputs("]}", f);
}

static const char *outcome(const struct summary_part *parts, uint32_t count, bool deadlock)
{
    bool failed = false;
    for (uint32_t i = 0; i < count; i++)
        failed |= parts[i].failed;
    return deadlock ? "deadlock" : failed ? "failed" : "ended";
}

static void put_all(FILE *f, const struct summary_part *parts, uint32_t count, bool deadlock)
{
    uint64_t sent = 0, bytes = 0;
    for (uint32_t i = 0; i < count; i++)
        sent += parts[i].sent, bytes += parts[i].bytes;
    fputs("{\"program\": ", f);
    put_text(f, program_invocation_short_name);
    fprintf(f, ", \"nodes\": %u, \"outcome\": \"%s\", \"wall_time_s\": %.9f,\n", count,
            outcome(parts, count, deadlock), latest(parts, count));
    fprintf(f, " \"messages\": %" PRIu64 ", \"bytes\": %" PRIu64 ",\n \"node\": [\n", sent, bytes);
    for (uint32_t i = 0; i < count; i++) {
        put_node(f, &parts[i]);
        fputs(i + 1 < count ? ",\n" : "\n", f);
    }
    fputs(" ]}\n", f);
}

/* Under another name at first: what was in the file stays if there is no room. */
void summary_write_json(const struct summary_part *parts, uint32_t count, bool deadlock, const char *path)
{
    char *new = malloc(strlen(path) + sizeof ".new");
    if (!new)
        return;
    strcat(strcpy(new, path), ".new");
    FILE *f = fopen(new, "w");
    if (f)
        put_all(f, parts, count, deadlock);
    bool failed = !f || ferror(f);
    if ((f && fclose(f) != 0) || failed || rename(new, path) != 0) {
        fprintf(stderr, "nx: NX_SUMMARY_JSON: %s cannot be written: %s\n", path, strerror(errno));
        remove(new);
    }
    free(new);
}
