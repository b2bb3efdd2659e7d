/* rerun_changes.c - see rerun_changes.h. */
#include "lab/why/rerun_changes.h"
#include "files/folder_make.h"
#include "kernel/xalloc.h"
#include "files/words.h"

enum { MOST_KEYS = 12, MOST_CHANGES = 12 };
static const double FASTEST_MHZ = 100000; /* the most that a machine file may say */

/* A change that needs no number of the machine. */
struct change {
    const char *key, *what;
    const char *set[MOST_KEYS + 1];
};

static const struct change INTERRUPTS = {
    "interrupts", "if entering and leaving handlers took no time", {"system.interrupt_us=0"}};
static const struct change ALWAYS[] = {
    {"messages",
     "if the system handled messages in no time",
     {"system.short_send_us=0", "system.short_receive_us=0", "system.forced_send_us=0",
      "system.forced_receive_us=0", "system.ask_send_us=0", "system.ask_receive_us=0",
      "system.grant_receive_us=0", "system.long_receive_us=0", "system.send_us_per_byte=0",
      "system.receive_us_per_byte=0", "system.copy_us_per_byte=0"}},
    {"calls", "if all other calls took no time", {"system.call_us=0", "system.clock_call_us=0"}},
    {"network",
     "if the network took no time",
     {"net.short_hop_us=0", "net.long_hop_us=0", "net.short_us_per_byte=0", "net.long_us_per_byte=0"}},
    {"contention",
     "if channels between nodes were so fast that no message waited for them",
     {"net.channel_ns_per_byte=0.001"}},
};
static const struct change DISKS = {"disks",
                                    "if disks and I/O nodes took no time",
                                    {"cfs.request_us=0", "cfs.copy_us_per_byte=0", "cfs.seek_track_ms=0",
                                     "cfs.seek_ms=0", "cfs.rotation_ms=0", "cfs.disk_mb_per_s=10000",
                                     "cfs.open_ms=0", "cfs.pointer_ms=0"}};

static void add_change(struct reruns *r, const struct change *c)
{
    words_add_each(&reruns_add(r, c->key, xstrdup(c->what))->set, NULL, c->set);
}

/* All processors so many times faster, or as fast as can be. */
static void add_clock(struct reruns *r, const struct cfg_machine *cfg, const char *key, double times)
{
    double mhz = (double)cfg->clock_hz / 1e6, fast_mhz = (double)cfg->fast_clock_hz / 1e6;
    double most = FASTEST_MHZ / (cfg->fast_every && fast_mhz > mhz ? fast_mhz : mhz);
    times = times > 0 && times < most ? times : most;
    struct rerun *x = reruns_add(r, key, xasprintf("if the processors computed %.6g times faster", times));
    words_add(&x->set, xasprintf("node.clock_mhz=%.17g", mhz * times));
    if (cfg->fast_every)
        words_add(&x->set, xasprintf("node.fast_clock_mhz=%.17g", fast_mhz * times));
}

static void add_own(struct reruns *r, const char *const *own)
{
    char *what = xstrdup("with");
    for (const char *const *s = own; *s; s++)
        words_append(&what, "%s %s", s == own ? "" : ",", *s);
    words_add_each(&reruns_add(r, "set", what)->set, NULL, own);
}

static bool has_files(const struct trace *t)
{
    for (int32_t i = 0; i < t->name_count; i++)
        if (t->classes[i] == TRACE_FILES)
            return true;
    return false;
}

/* The first is the command as it was, without settings. */
static struct reruns changes(const struct trace *t, const struct rerun_options *o)
{
    struct reruns r = {0};
    const struct cfg_machine *cfg = o->cfg;
    reruns_add(&r, "same", xstrdup("as it was"));
    if (o->set && *o->set)
        add_own(&r, o->set);
    if (o->cpu > 0)
        add_clock(&r, cfg, "cpu", o->cpu);
    if ((o->set && *o->set) || o->cpu > 0)
        return r; /* the user knows what to ask */
    if (t->handler_count)
        add_change(&r, &INTERRUPTS);
    for (size_t i = 0; i < sizeof ALWAYS / sizeof *ALWAYS && t->message_count; i++)
        add_change(&r, &ALWAYS[i]);
    if (cfg->cfs.io_nodes && has_files(t))
        add_change(&r, &DISKS);
    add_clock(&r, cfg, "computing", 0);
    return r;
}

/* Is the run still that of the trace? */
static bool is_same(const struct trace *t, const struct rerun *x, char **error)
{
    if (!x->done)
        *error = xasprintf("the command of the trace cannot be run again: %s", x->error);
    else if (x->end != t->end)
        *error = xasprintf(
            "the command of the trace takes %.12f s now, not %.12f s: the program, its input or the "
            "machine file has changed since; make the trace anew",
            vt_seconds(x->end), vt_seconds(t->end));
    return !*error;
}

bool rerun_all(const struct trace *t, const struct rerun_options *o, struct reruns *r, char **error)
{
    *error = NULL;
    *r = changes(t, o);
    struct scratch scratch = folder_scratch("touchstone-why", error);
    struct rerun_place p = {o->command, scratch.path, o->at_once, o->progress, NULL};
    bool ok = scratch.path && rerun_copy_cfs(&p, r, error) && rerun_some(&p, r, 0, 1, error) &&
              is_same(t, &r->list[0], error) && rerun_some(&p, r, 1, r->count - 1, error);
    scratch_remove(&scratch);
    return ok;
}
