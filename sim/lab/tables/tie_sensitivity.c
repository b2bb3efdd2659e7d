/* tie_sensitivity.c - see tie_sensitivity.h. */
#include "lab/tables/tie_sensitivity.h"
#include "config/config.h"
#include "kernel/xalloc.h"
#include "files/words.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>

static const double WIDEST = 0.02;

/* The parts of a message's latency. */
static const struct part {
    const char *key; /* in the machine file, in nanoseconds */
    size_t offset;   /* of its picoseconds in struct cfg_machine */
} PARTS[] = {
    {"net.short_hop_ns", offsetof(struct cfg_machine, short_hop_ps)},
    {"net.long_hop_ns", offsetof(struct cfg_machine, long_hop_ps)},
    {"system.short_send_ns", offsetof(struct cfg_machine, short_send_ps)},
    {"system.short_receive_ns", offsetof(struct cfg_machine, short_receive_ps)},
    {"system.ask_send_ns", offsetof(struct cfg_machine, ask_send_ps)},
    {"system.ask_receive_ns", offsetof(struct cfg_machine, ask_receive_ps)},
    {"system.grant_receive_ns", offsetof(struct cfg_machine, grant_receive_ps)},
    {"system.long_receive_ns", offsetof(struct cfg_machine, long_receive_ps)},
};
enum { PART_COUNT = sizeof PARTS / sizeof *PARTS };

/* The run with the latency's k-th change. */
static struct run variant(const struct run *run, const struct cfg_machine *m, unsigned k)
{
    double by = WIDEST * (2.0 * k / (TIE_RUNS - 1) - 1);
    struct run v = {.nodes = run->nodes, .arguments = run->arguments, .weight = run->weight};
    for (size_t i = 0; i < PART_COUNT; i++) {
        uint64_t ps = *(const uint64_t *)((const char *)m + PARTS[i].offset);
        words_add(&v.settings, xasprintf("%s=%.6f", PARTS[i].key, (double)ps / 1e3 * (1 + by)));
    }
    v.name = xasprintf("%s; latency %+.1f %%", run->name, 100 * by);
    return v;
}

static void widen(struct run *run, double total_s)
{
    if (isnan(total_s))
        return;
    run->tie_least_s = fmin(run->tie_least_s, total_s);
    run->tie_most_s = fmax(run->tie_most_s, total_s);
}

static bool do_with(const struct tables_options *o, struct results *r, const struct cfg_machine *m,
                    char **error)
{
    struct run *variants = xcalloc(r->run_count * TIE_RUNS + 1, sizeof *variants);
    size_t count = 0;
    for (size_t i = 0; i < r->run_count; i++)
        for (unsigned k = 0; r->runs[i].ties && k < TIE_RUNS; k++)
            variants[count++] = variant(&r->runs[i], m, k);
    bool ok =
        table_runs_do(o, r->paper, variants, count, (struct runs_watcher){NULL}, &r->wall_time_s, error);
    for (size_t i = 0, v = 0; ok && i < r->run_count; i++) {
        struct run *run = &r->runs[i];
        if (!run->ties)
            continue;
        run->tie_least_s = run->tie_most_s = outcome_figure(&run->outcome, "total_s");
        run->tie_runs = TIE_RUNS;
        for (unsigned k = 0; k < TIE_RUNS; k++)
            widen(run, outcome_figure(&variants[v++].outcome, "total_s"));
    }
    table_runs_clear(variants, count);
    free(variants);
    return ok;
}

bool tie_sensitivity_run(const struct tables_options *o, struct results *r, char **error)
{
    char *dir = xasprintf("%s/machines", o->home);
    struct cfg_machine *m = cfg_load(r->paper->machine, dir, error);
    bool ok = m && do_with(o, r, m, error);
    cfg_free(m);
    free(dir);
    return ok;
}
