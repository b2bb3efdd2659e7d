/* shrink.c - see shrink.h. Leaves out operations, nodes and settings until none can be left out (delta
 * debugging; Zeller & Hildebrandt, 2002). */
#include "shrink.h"
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

enum { TRIES = 6, MOST_ROUNDS = 6 };

/* The program that is made smaller, how it is run, and which result differs. */
struct finding {
    const struct place *place;
    struct program *p;
    const char *way;
    int result;
};

/* The result that differs from the reference's; -1: none. Runs with workers are tried several times. */
static int difference(const struct finding *c, const struct program *p)
{
    struct trial right = trial_run(c->place, p, TRIAL_REFERENCE);
    int result = -1, tries = strncmp(c->way, "-w 1", 4) == 0 ? 1 : TRIES;
    if (right.status == -1 || WIFSIGNALED(right.status))
        result = RESULTS;
    for (int i = 0; i < tries && result < 0; i++) {
        struct trial t = trial_run(c->place, p, c->way);
        result = trial_differs(&right, &t);
        trial_free(&t);
    }
    trial_free(&right);
    return result;
}

/* Takes the smaller program if the same result differs in it. */
static bool take(struct finding *c, struct program *smaller)
{
    bool good = difference(c, smaller) == c->result;
    program_free(good ? c->p : smaller);
    if (good)
        c->p = smaller;
    return good;
}

static bool drop_ops(struct finding *c, int node, size_t from, size_t count)
{
    struct program *smaller = program_copy(c->p);
    struct script *s = &smaller->script[node];
    memmove(&s->ops[from], &s->ops[from + count], (s->count - from - count) * sizeof *s->ops);
    s->count -= count;
    return take(c, smaller);
}

static bool fewer_ops(struct finding *c)
{
    bool any = false;
    for (int node = 0; node < SCRIPTS; node++)
        for (size_t part = c->p->script[node].count; part > 0; part /= 2)
            for (size_t from = 0; from < c->p->script[node].count;) {
                size_t left = c->p->script[node].count - from, count = part < left ? part : left;
                if (drop_ops(c, node, from, count))
                    any = true;
                else
                    from += count;
            }
    return any;
}

static bool fewer_nodes(struct finding *c)
{
    bool any = false;
    for (uint32_t n = 1; n < c->p->nodes; n = n < 4 ? n + 1 : n * 2) {
        struct program *smaller = program_copy(c->p);
        smaller->nodes = n;
        for (uint32_t i = n; i < MOST_NODES; i++)
            smaller->script[i].count = 0;
        if (take(c, smaller))
            any = true;
    }
    return any;
}

static bool fewer_settings(struct finding *c)
{
    bool any = false;
    for (int i = 0; i < c->p->set_count;) {
        struct program *smaller = program_copy(c->p);
        memmove(smaller->set[i], smaller->set[i + 1], (size_t)(MOST_SET - i - 1) * sizeof smaller->set[0]);
        smaller->set_count--;
        if (take(c, smaller))
            any = true;
        else
            i++;
    }
    if (c->p->profile) {
        struct program *smaller = program_copy(c->p);
        smaller->profile = false;
        any |= take(c, smaller);
    }
    if (*c->p->timing) {
        struct program *smaller = program_copy(c->p);
        *smaller->timing = '\0';
        any |= take(c, smaller);
    }
    if (c->p->flushes) {
        struct program *smaller = program_copy(c->p);
        smaller->flushes = false;
        any |= take(c, smaller);
    }
    return any;
}

static bool smaller_numbers(struct finding *c)
{
    bool any = false;
    for (int node = 0; node < SCRIPTS; node++)
        for (size_t i = 0; i < c->p->script[node].count; i++)
            for (int k = 0; k < VALUES; k++) {
                long values[2];
                int count = program_smaller(&c->p->script[node].ops[i], k, values);
                for (int v = 0; v < count; v++) {
                    struct program *smaller = program_copy(c->p);
                    smaller->script[node].ops[i].value[k] = values[v];
                    if (take(c, smaller)) {
                        any = true;
                        break;
                    }
                }
            }
    return any;
}

void shrink(const struct place *place, struct program **p, const char *way)
{
    struct finding c = {place, *p, way, 0};
    bool again = (c.result = difference(&c, c.p)) >= 0;
    for (int i = 0; i < MOST_ROUNDS && again; i++) {
        again = fewer_nodes(&c);
        again |= fewer_settings(&c);
        again |= fewer_ops(&c);
        again |= smaller_numbers(&c);
    }
    *p = c.p;
}
