/* config.c - a machine file's keys, their fields in struct cfg_machine, and their ranges. */
#include "config/config.h"
#include "config/cfs_section.h"
#include "config/host_section.h"
#include "config/reader.h"
#include "config/setting.h"
#include "kernel/xalloc.h"

#include <dirent.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MAX_DIMENSION = 20, MAX_SIDE = 4096, MAX_NODES = 1 << MAX_DIMENSION, KB = 1024, MB = 1024 * 1024 };

/* A time in the file: its key without the unit, and its field. */
struct time_key {
    const char *name;
    const char *tail;                         /* what follows the unit: "" or "_per_byte" */
    size_t offset;                            /* of a uint64_t of picoseconds in struct cfg_machine */
    enum { NEEDED, ZERO, AS_ANOTHER } absent; /* its value where the file does not give it */
    size_t another;                           /* AS_ANOTHER: the offset of that field, which is read before */
};
#define FIELD(member) offsetof(struct cfg_machine, member)
#define TIME(name, member)                                                                                   \
    {                                                                                                        \
        name, "", FIELD(member), NEEDED, 0                                                                   \
    }
#define TIME_OR_NONE(name, member)                                                                           \
    {                                                                                                        \
        name, "", FIELD(member), ZERO, 0                                                                     \
    }
#define TIME_OR_AS(name, member, other)                                                                      \
    {                                                                                                        \
        name, "", FIELD(member), AS_ANOTHER, FIELD(other)                                                    \
    }
#define RATE(name, member)                                                                                   \
    {                                                                                                        \
        name, "_per_byte", FIELD(member), NEEDED, 0                                                          \
    }
#define RATE_OR_NONE(name, member)                                                                           \
    {                                                                                                        \
        name, "_per_byte", FIELD(member), ZERO, 0                                                            \
    }

static const struct time_key net_times[] = {
    TIME("short_hop", short_hop_ps),
    TIME("long_hop", long_hop_ps),
    RATE("short", short_ps_per_byte),
    RATE("long", long_ps_per_byte),
    RATE_OR_NONE("channel", channel_ps_per_byte),
};
static const struct time_key system_times[] = {
    TIME("call", call_ps),
    TIME("clock_call", clock_call_ps),
    TIME_OR_NONE("kernel", kernel_ps),
    TIME_OR_NONE("entry", entry_ps),
    TIME_OR_NONE("unix_call", unix_call_ps),
    TIME("short_send", short_send_ps),
    TIME("short_receive", short_receive_ps),
    TIME_OR_AS("forced_send", forced_send_ps, short_send_ps),
    TIME_OR_AS("forced_receive", forced_receive_ps, short_receive_ps),
    TIME("ask_send", ask_send_ps),
    TIME("ask_receive", ask_receive_ps),
    TIME("grant_receive", grant_receive_ps),
    TIME("long_receive", long_receive_ps),
    TIME("interrupt", interrupt_ps),
    RATE("send", send_ps_per_byte),
    RATE("receive", receive_ps_per_byte),
    RATE("copy", copy_ps_per_byte),
};
#define COUNT(array) (sizeof(array) / sizeof *(array))

static uint64_t *field(struct cfg_machine *m, size_t offset)
{
    return (uint64_t *)(void *)((char *)m + offset);
}

/* Reads a group that holds times and one whole number besides: nothing else is allowed in it but the key
 * `more`, if it is not NULL. */
static bool read_times(struct cfg_reader *r, config_setting_t *group, const struct time_key *keys,
                       size_t count, const char *whole, uint64_t min, uint64_t max, uint64_t *value,
                       const char *more, struct cfg_machine *m)
{
    char names[2 * COUNT(system_times)][40];
    const char *known[2 * COUNT(system_times) + 3] = {0};
    size_t used = 0;
    for (size_t i = 0; i < count; i++)
        for (int ns = 0; ns < 2; ns++, used++) {
            snprintf(names[used], sizeof names[used], "%s_%s%s", keys[i].name, ns ? "ns" : "us",
                     keys[i].tail);
            known[used] = names[used];
        }
    known[used] = whole, known[used + 1] = more;

    bool ok = cfg_only(r, group, known) && cfg_whole(r, group, whole, min, max, value);
    for (size_t i = 0; ok && i < count; i++) {
        bool given = config_setting_get_member(group, names[2 * i]) ||
                     config_setting_get_member(group, names[2 * i + 1]);
        if (given || keys[i].absent == NEEDED)
            ok = cfg_time(r, group, keys[i].name, keys[i].tail, field(m, keys[i].offset));
        else if (keys[i].absent == AS_ANOTHER)
            *field(m, keys[i].offset) = *field(m, keys[i].another);
    }
    return ok;
}

static bool read_topology(struct cfg_reader *r, struct cfg_machine *m)
{
    static const char *const cube_keys[] = {"kind", "dimension", NULL};
    static const char *const mesh_keys[] = {"kind", "rows", "columns", NULL};
    config_setting_t *g;
    const char *kind;
    if (!cfg_group(r, r->root, "topology", &g) || !cfg_text(r, g, "kind", &kind))
        return false;

    uint64_t dimension = 0, rows = 0, columns = 0;
    if (strcmp(kind, "hypercube") == 0) {
        m->topology = CFG_HYPERCUBE;
        if (!cfg_only(r, g, cube_keys) || !cfg_whole(r, g, "dimension", 0, MAX_DIMENSION, &dimension))
            return false;
    } else if (strcmp(kind, "mesh") == 0) {
        m->topology = CFG_MESH;
        if (!cfg_only(r, g, mesh_keys) || !cfg_whole(r, g, "rows", 1, MAX_SIDE, &rows) ||
            !cfg_whole(r, g, "columns", 1, MAX_SIDE, &columns))
            return false;
        if (rows * columns > MAX_NODES)
            return cfg_fail(r, g, "topology", "%lu x %lu nodes; at most %d are allowed", rows, columns,
                            MAX_NODES);
    } else {
        return cfg_fail(r, config_setting_get_member(g, "kind"), "kind",
                        "\"%s\" is unknown; \"hypercube\" and \"mesh\" are allowed", kind);
    }
    m->dimension = (uint32_t)dimension;
    m->rows = (uint32_t)rows;
    m->columns = (uint32_t)columns;
    return true;
}

/* The cpu file is named relative to the machine file, so that a copy of both works anywhere. */
static bool read_cpu(struct cfg_reader *r, config_setting_t *node, struct cfg_machine *m)
{
    const char *cpu, *slash = strrchr(r->path, '/');
    if (!cfg_text(r, node, "cpu", &cpu))
        return false;
    int dir = slash && cpu[0] != '/' ? (int)(slash - r->path) + 1 : 0;
    m->cpu = xasprintf("%.*s%s", dir, r->path, cpu);
    return access(m->cpu, R_OK) == 0 ||
           cfg_fail(r, config_setting_get_member(node, "cpu"), "cpu", "%s cannot be read: %m%s", m->cpu,
                    cpu[0] == '/' ? "" : " (a path from the machine file's folder)");
}

/* Reads the clock of the fast nodes: both keys, or none. */
static bool read_fast_nodes(struct cfg_reader *r, config_setting_t *g, struct cfg_machine *m)
{
    double clock_mhz;
    uint64_t every;
    if (!config_setting_get_member(g, "fast_every") && !config_setting_get_member(g, "fast_clock_mhz"))
        return true;
    if (!cfg_whole(r, g, "fast_every", 1, UINT32_MAX, &every) ||
        !cfg_number(r, g, "fast_clock_mhz", 0.001, 100000, &clock_mhz))
        return false;
    m->fast_every = (uint32_t)every;
    m->fast_clock_hz = (uint64_t)llround(clock_mhz * 1e6);
    return true;
}

/* The system's time on fast nodes is reckoned in thousandths of that on others. */
static bool check_fast_clock(struct cfg_reader *r, config_setting_t *g, const struct cfg_machine *m)
{
    enum { MOST = 1000 };
    return !m->fast_every ||
           (m->fast_clock_hz <= MOST * m->clock_hz && m->clock_hz <= MOST * m->fast_clock_hz) ||
           cfg_fail(r, config_setting_get_member(g, "fast_clock_mhz"), "fast_clock_mhz",
                    "must be a thousandth of clock_mhz at least, and a thousand times as much at most");
}

static bool read_share(struct cfg_reader *r, config_setting_t *g, struct cfg_machine *m)
{
    double share = 0.05;
    if (config_setting_get_member(g, "program_share") && !cfg_number(r, g, "program_share", 0, 0.999, &share))
        return false;
    m->program_milli = (uint64_t)llround(share * 1000);
    return true;
}

static bool read_node(struct cfg_reader *r, struct cfg_machine *m)
{
    static const char *const keys[] = {"cpu",           "clock_mhz", "hwclock_mhz", "memory_mb",
                                       "system_kb",     "stack_kb",  "fast_every",  "fast_clock_mhz",
                                       "program_share", "cache_kb",  NULL};
    config_setting_t *g;
    double clock_mhz, hwclock_mhz = 10;
    uint64_t memory, system, stack, cache = 8;
    if (!cfg_group(r, r->root, "node", &g) || !cfg_only(r, g, keys) || !read_cpu(r, g, m) ||
        !cfg_number(r, g, "clock_mhz", 0.001, 100000, &clock_mhz) ||
        (config_setting_get_member(g, "hwclock_mhz") &&
         !cfg_number(r, g, "hwclock_mhz", 0.001, 100000, &hwclock_mhz)) ||
        (config_setting_get_member(g, "cache_kb") && !cfg_whole(r, g, "cache_kb", 1, 65536, &cache)) ||
        !cfg_whole(r, g, "memory_mb", 1, 65536, &memory) ||
        !cfg_whole(r, g, "system_kb", 0, memory * KB, &system) ||
        !cfg_whole(r, g, "stack_kb", 16, memory * KB, &stack) || !read_fast_nodes(r, g, m) ||
        !read_share(r, g, m))
        return false;
    if (system + stack >= memory * KB)
        return cfg_fail(r, g, "memory_mb", "system_kb and stack_kb leave nothing of it to the program");
    m->clock_hz = (uint64_t)llround(clock_mhz * 1e6);
    if (!check_fast_clock(r, g, m))
        return false;
    m->hwclock_hz = (uint64_t)llround(hwclock_mhz * 1e6);
    m->cache_bytes = cache * KB;
    m->memory_bytes = memory * MB;
    m->system_bytes = system * KB;
    m->stack_bytes = stack * KB;
    return true;
}

/* A key of MPI's, which machines of NX do not give. */
static bool read_if_given(struct cfg_reader *r, const char *key, uint64_t low, uint64_t high, uint64_t *value)
{
    return !config_setting_get_member(r->root, key) || cfg_whole(r, r->root, key, low, high, value);
}

static bool read_mpi(struct cfg_reader *r, struct cfg_machine *m)
{
    m->mpi_eager_limit = 128000; /* known: MPICH 1's for its devices of messages, from 1996 on */
    m->mpi_collectives = 2005;   /* read: Thakur, Rabenseifner, Gropp, which MPICH follows to this day */
    if (!read_if_given(r, "mpi_eager_limit", 0, INT32_MAX, &m->mpi_eager_limit) ||
        !read_if_given(r, "mpi_collectives", 1995, 2005, &m->mpi_collectives))
        return false;
    return m->mpi_collectives == 1995 || m->mpi_collectives == 2005 ||
           cfg_fail(r, config_setting_get_member(r->root, "mpi_collectives"), "mpi_collectives",
                    "must be 1995 or 2005: how MPICH made them in that year");
}

static bool read_system(struct cfg_reader *r, config_setting_t *g, struct cfg_machine *m)
{
    static const char *const at_once = "moves_at_once";
    return read_times(r, g, system_times, COUNT(system_times), "message_ids", 1, 1000000, &m->message_ids,
                      at_once, m) &&
           (!config_setting_get_member(g, at_once) || cfg_whole(r, g, at_once, 0, 1000, &m->moves_at_once));
}

static bool read_machine(struct cfg_reader *r, struct cfg_machine *m)
{
    static const char *const keys[] = {
        "name", "description",     "topology",        "node", "net", "system", "cfs",
        "host", "mpi_eager_limit", "mpi_collectives", NULL};
    const char *name, *description;
    config_setting_t *net, *system;
    if (!cfg_only(r, r->root, keys) || !cfg_text(r, r->root, "name", &name) ||
        !cfg_text(r, r->root, "description", &description))
        return false;
    m->name = xstrdup(name);
    m->description = xstrdup(description);
    return read_topology(r, m) && read_node(r, m) && cfg_group(r, r->root, "net", &net) &&
           read_times(r, net, net_times, COUNT(net_times), "short_limit", 0, MB, &m->short_limit, NULL, m) &&
           cfg_group(r, r->root, "system", &system) && read_system(r, system, m) && read_mpi(r, m) &&
           cfg_read_cfs(r, &m->cfs) && cfg_read_host(r, m);
}

static int is_machine(const struct dirent *e)
{
    size_t n = strlen(e->d_name);
    return n > 4 && strcmp(e->d_name + n - 4, ".cfg") == 0;
}

/* By the names without ".cfg": ipsc860 comes before ipsc860-8mb. */
static int by_name(const struct dirent **a, const struct dirent **b)
{
    size_t m = strlen((*a)->d_name) - 4, n = strlen((*b)->d_name) - 4;
    int order = memcmp((*a)->d_name, (*b)->d_name, m < n ? m : n);
    return order ? order : (m > n) - (m < n);
}

int cfg_list_machines(const char *dir, const char *between, FILE *f)
{
    struct dirent **found = NULL;
    int count = scandir(dir, &found, is_machine, by_name);
    for (int i = 0; i < count; i++) {
        fprintf(f, "%s%.*s", i ? between : "", (int)strlen(found[i]->d_name) - 4, found[i]->d_name);
        free(found[i]);
    }
    free(found);
    return count;
}

/* The folder's machine whose name is most like this one; NULL: none is alike. The caller frees it. */
static char *machine_meant(const char *name, const char *dir)
{
    struct dirent **found = NULL;
    int count = scandir(dir, &found, is_machine, by_name);
    const char **names = xcalloc((size_t)(count > 0 ? count : 0) + 1, sizeof *names);
    for (int i = 0; i < count; i++) {
        found[i]->d_name[strlen(found[i]->d_name) - 4] = '\0';
        names[i] = found[i]->d_name;
    }
    const char *best = cfg_meant(name, names);
    char *meant = best ? xstrdup(best) : NULL;
    for (int i = 0; i < count; i++)
        free(found[i]);
    free(found);
    free(names);
    return meant;
}

/* The path of the machine file of that name in the current folder; NULL: there is none. The caller frees. */
static char *machine_here(const char *name)
{
    char *path = xasprintf("./%s.cfg", name);
    if (access(path, F_OK) == 0)
        return path;
    free(path);
    return NULL;
}

/* "no machine "x" ...; did you mean ipsc860? There are: delta, ipsc860" */
static char *no_such_machine(const char *name, const char *dir)
{
    char *here = machine_here(name), *meant = here ? here : machine_meant(name, dir);
    char *list = NULL;
    size_t size;
    FILE *out = xchecked(open_memstream(&list, &size));
    bool some = cfg_list_machines(dir, ", ", out) > 0;
    fclose(out);
    char *text =
        xasprintf("no machine \"%s\" in %s; %s%s%shere %s%s (or give the path of a file that ends in .cfg)",
                  name, dir, meant ? "did you mean " : "", meant ? meant : "", meant ? "? T" : "t",
                  some ? "are: " : "are none", list);
    free(list);
    free(meant);
    return text;
}

/* Applies the settings to what was read, and keeps their texts, which error messages refer to. */
static bool apply(struct cfg_reader *r, const char *const set[], struct cfg_machine *m)
{
    size_t count = 0;
    while (set && set[count])
        count++;
    m->set = xcalloc(count + 1, sizeof *m->set);
    for (size_t i = 0; i < count; i++) {
        m->set[i] = xstrdup(set[i]);
        if (!cfg_set(r, m->set[i]))
            return false;
    }
    return true;
}

bool cfg_is_path(const char *name)
{
    size_t n = strlen(name);
    return strchr(name, '/') || (n >= 4 && strcmp(name + n - 4, ".cfg") == 0);
}

struct cfg_machine *cfg_load(const char *name, const char *dir, char **error)
{
    return cfg_load_with(name, dir, NULL, error);
}

struct cfg_machine *cfg_load_with(const char *name, const char *dir, const char *const set[], char **error)
{
    bool is_path = cfg_is_path(name);
    struct cfg_machine *m = xcalloc(1, sizeof *m);
    m->path = is_path ? xstrdup(name) : xasprintf("%s/%s.cfg", dir, name);
    if (!is_path && access(m->path, F_OK) != 0) {
        *error = no_such_machine(name, dir);
        cfg_free(m);
        return NULL;
    }

    struct cfg_reader r;
    bool ok = cfg_open(&r, m->path) && apply(&r, set, m) && read_machine(&r, m);
    cfg_close(&r);
    if (ok)
        return m;
    *error = r.error;
    cfg_free(m);
    return NULL;
}

uint64_t cfg_fast_system_milli(const struct cfg_machine *m)
{
    return (1000 * m->clock_hz + m->fast_clock_hz / 2) / m->fast_clock_hz;
}

void cfg_free(struct cfg_machine *m)
{
    if (!m)
        return;
    free(m->name);
    free(m->description);
    free(m->path);
    for (size_t i = 0; m->set && m->set[i]; i++)
        free(m->set[i]);
    free(m->set);
    free(m->cpu);
    free(m);
}
