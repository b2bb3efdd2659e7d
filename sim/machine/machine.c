/* machine.c - see machine.h. */
#include "machine/machine.h"
#include <assert.h>
#include <stdlib.h>
#include <string.h>
#include "cfs/cfs.h"
#include "guest/backtrace.h"
#include "guest/debugger.h"
#include "guest/elffile.h"
#include "guest/image.h"
#include "guest/libc/libc.h"
#include "guest/span_texts.h"
#include "guest/libc/streams.h"
#include "kernel/hostclock.h"
#include "kernel/xalloc.h"
#include "lp/engine.h"
#include "lp/prefetch_coming.h"
#include "machine/assemble.h"
#include "machine/cube.h"
#include "net/protocol_record.h"
#include "os/flood.h"
#include "replay/numbering.h"
#include "replay/orders.h"
#include "mpi_api/checks/mpi_checks.h"
#include "races/race_check.h"
#include "asan/asan_check.h"

/* The number of nodes asked for, or all that the machine has. */
static uint32_t nodes_of(const struct machine_options *o)
{
    const struct cfg_machine *c = o->cfg;
    if (o->nodes)
        return o->nodes;
    return c->topology == CFG_HYPERCUBE ? UINT32_C(1) << c->dimension : c->rows * c->columns;
}

static bool has_host(const struct machine *m, char **error)
{
    const struct cfg_machine *c = m->options.cfg;
    if (!m->options.host || c->host.clock_hz)
        return true;
    *error = xasprintf("%s has no host (its machine file, %s, has no group host): run the host program on "
                       "an iPSC/860, -m ipsc860",
                       c->name, c->path);
    return false;
}

/* Sets the run's timing. */
static bool make_timing(struct machine *m, char **error)
{
    const struct machine_options *o = &m->options;
    const struct plan *p = o->plan;
    if (p && p->nodes != m->sys.count) {
        *error = xasprintf("%s is the schedule of a run on %u nodes, and this one has %u (-n)", p->path,
                           p->nodes, m->sys.count);
        return false;
    }
    m->sys.timing = o->draw || p ? timing_new(o->draw, p, m->sys.count) : NULL;
    return true;
}

static const char *line_on_stack(void *lines, const struct node *n, uintptr_t frame)
{
    return backtrace_line_from(lines, n, frame);
}

/* A run that is recorded, or keeps orders, has numbers. */
static void make_numbering(struct machine *m)
{
    const struct machine_options *o = &m->options;
    const struct plan *orders = o->plan && o->plan->orders ? o->plan : NULL;
    if (!o->schedule && !orders)
        return;
    m->sys.numbering = numbering_new(m->sys.count, orders, o->schedule);
    m->sys.orders = orders ? &orders_policy : NULL;
    m->lines = backtrace_lines_new();
    m->sys.numbering->line = line_on_stack, m->sys.numbering->line_ctx = m->lines;
    protocol_number(m->sys.schedule.protocol);
}

static bool has_addresses(const struct node_system *s, char **error)
{
    const struct topo *t = &s->topo;
    if (t->addresses <= TOPO_ADDRESSES)
        return true;
    *error = xasprintf(
        "%s has %u nodes, %u I/O nodes and directories, and %s host: more than the %d addresses of a "
        "network",
        s->cfg->name, t->positions, t->services, t->host ? "a" : "no", TOPO_ADDRESSES);
    return false;
}

static bool make_shape(struct machine *m, char **error)
{
    const struct cfg_machine *c = m->options.cfg;
    uint32_t n = m->sys.count;
    bool cube = c->topology == CFG_HYPERCUBE;
    if (cube ? topo_hypercube(&m->sys.topo, n, c->dimension)
             : topo_mesh(&m->sys.topo, n, c->rows, c->columns)) {
        topo_add_services(&m->sys.topo, cfs_services(c));
        if (m->options.host)
            topo_add_host(&m->sys.topo);
        return has_addresses(&m->sys, error);
    }
    *error =
        cube ? xasprintf("%s has no %u nodes: it is a hypercube of at most %u; --set topology.dimension=N "
                         "makes it one of 2^N",
                         c->name, n, 1u << c->dimension)
             : xasprintf("%s has no rectangle of %u nodes: it is a mesh of %u x %u; --set topology.rows=N "
                         "and --set topology.columns=N make it a larger one",
                         c->name, n, c->rows, c->columns);
    return false;
}

static bool make_file_system(struct machine *m, char **error)
{
    struct node_system *s = &m->sys;
    if (!s->cfg->cfs.io_nodes && !m->options.cfs_dir)
        return true;
    if (!s->cfg->cfs.io_nodes) {
        *error = xasprintf("--cfs %s: %s has no file system of its own", m->options.cfs_dir, s->cfg->name);
        return false;
    }
    s->cfs = cfs_new(s, m->options.cfs_dir, error);
    if (s->cfs)
        s->fs = cfs_fs(s->cfs);
    return s->cfs;
}

/* Makes the host with its program, and nodes without programs. */
static bool make_host(struct machine *m, char **error)
{
    const struct machine_options *o = &m->options;
    struct node_system *s = &m->sys;
    cube_new(s, &(struct cube_options){.most = s->count,
                                       .given = o->nodes > 0,
                                       .program = o->program,
                                       .host = o->programs[0].argv[0],
                                       .envp = o->envp});
    s->host = node_new_host(s, topo_host(&s->topo), m->images[0], o->programs[0].argc, o->programs[0].argv,
                            o->envp, error);
    if (!s->host)
        return false;
    s->running = 1;
    node_start(s->host, 0);
    return true;
}

/* NULL: it has not been opened. */
static struct node_image *image_at(const struct machine *m, const char *path)
{
    size_t i = 0;
    while (i < m->image_count && strcmp(node_image_path(m->images[i]), path))
        i++;
    return i < m->image_count ? m->images[i] : NULL;
}

static bool open_image(struct machine *m, const char *path, char **error)
{
    if (image_at(m, path))
        return true;
    struct node_image *image = node_image_open(path, error);
    if (!image)
        return false;
    node_image_set_layer(image, m->options.layer);
    m->images = xreallocarray(m->images, m->image_count + 1, sizeof(struct node_image *));
    m->images[m->image_count++] = image;
    return true;
}

/* Opens all programs before the first node has one: what they call decides how nodes run. */
static bool open_images(struct machine *m, char **error)
{
    struct node_system *s = &m->sys;
    for (size_t i = 0; i < m->options.program_count; i++)
        if (!open_image(m, m->options.programs[i].argv[0], error))
            return false;
    for (size_t i = 0; i < m->image_count; i++) {
        s->flushes |= node_image_uses(m->images[i], "flushmsg") || node_image_uses(m->images[i], "_flushmsg");
        s->main_tells |= node_image_uses(m->images[i], "nxm_number");
    }
    return true;
}

static bool load_program(struct machine *m, const struct named_program *p, uint32_t program, uint32_t begin,
                         char **error)
{
    struct node_system *s = &m->sys;
    const struct node_image *image = image_at(m, p->argv[0]);
    for (uint32_t i = begin; i < begin + p->nodes; i++) {
        s->nodes[i] = node_new(s, i, image, p->argc, p->argv, m->options.envp, error);
        if (!s->nodes[i])
            return false;
        s->nodes[i]->cold->program = program;
        node_start(s->nodes[i], 0);
    }
    return true;
}

static bool make_nodes(struct machine *m, char **error)
{
    const struct machine_options *o = &m->options;
    if (o->host)
        return open_image(m, o->programs[0].argv[0], error) && make_host(m, error);
    if (!open_images(m, error))
        return false;
    m->sys.nodes = xcalloc(m->sys.count, sizeof *m->sys.nodes);
    uint32_t begin = 0;
    for (uint32_t i = 0; i < o->program_count; begin += o->programs[i++].nodes)
        if (!load_program(m, &o->programs[i], i, begin, error))
            return false;
    return true;
}

/* VT_NEVER: there is no limit, or one that no virtual time reaches. */
static vtime time_of(double seconds)
{
    return seconds > 0 && seconds < vt_seconds(VT_LAST) ? (vtime)(seconds * (double)VT_SECOND) : VT_NEVER;
}

/* The last moment that may be committed. */
static vtime limit_of(const struct machine_options *o)
{
    vtime limit = time_of(o->max_virtual_s);
    return o->until ? vt_min(limit, o->until) : limit;
}

struct machine *machine_new(const struct machine_options *options, char **error)
{
    assert(options->cfg && options->program_count > 0);
    double begin = hostclock_s();
    struct machine *m = xcalloc(1, sizeof *m);
    m->options = *options;
    struct node_system *s = &m->sys;
    s->cfg = options->cfg;
    s->count = s->running = nodes_of(options);
    s->schedule.max_time = limit_of(options);
    s->most_unreceived = flood_limit(options->max_unreceived, options->cfg->memory_bytes);
    s->schedule.longest_slice = options->slice_s > 0 ? time_of(options->slice_s) : 0;
    s->history = options->history;
    s->guards = NODE_GUARDS_ALL;
    s->isolate = options->isolate;
    s->fence = options->fence;
    s->debugger = options->debugged ? debugger_new() : NULL;
    s->races = races_new();
    s->asan = asan_new();
    s->mpi_checks = options->mpi_checks ? mpi_checks_new() : NULL;
    s->out[0] = options->out, s->out[1] = options->err;
    s->schedule.q = evq_new();
    if (!has_host(m, error) || !make_shape(m, error) || !make_timing(m, error))
        goto fail;
    s->schedule.protocol = protocol_new(s->cfg, &s->topo, s->schedule.q, s);
    s->schedule.loads_ahead = s->topo.addresses >= PREFETCH_NODES;
    make_numbering(m);
    if (!make_file_system(m, error) || !make_nodes(m, error))
        goto fail;
    m->start_s = hostclock_s() - begin;
    return m;
fail:
    machine_free(m);
    return NULL;
}

void machine_record(struct machine *m, struct recorder *r)
{
    struct node_system *s = &m->sys;
    assert(m->begin == 0);
    s->recorder = r;
    protocol_record(s->schedule.protocol, r);
    for (uint32_t i = 0; i < s->count && !s->cube; i++)
        node_record(s->nodes[i]);
    if (s->host)
        node_record(s->host);
}

void machine_free(struct machine *m)
{
    if (!m)
        return;
    if (m->sys.nodes && !m->sys.cube)
        streams_close_all(m->sys.nodes, m->sys.count);
    node_delete(m->sys.host);
    for (uint32_t i = m->sys.nodes && !m->sys.cube ? m->sys.count : 0; i-- > 0;)
        node_delete(m->sys.nodes[i]);
    cube_free(m->sys.cube);
    arena_free(&m->sys.made);
    arena_free(&m->sys.made_cold);
    span_texts_free(m->sys.texts);
    free(m->sys.nodes);
    cfs_free(m->sys.cfs);
    debugger_free(m->sys.debugger);
    protocol_free(m->sys.schedule.protocol);
    races_free(m->sys.races);
    asan_free(m->sys.asan);
    mpi_checks_free(m->sys.mpi_checks);
    evq_free(m->sys.schedule.q);
    mintree_free(&m->sys.schedule.polls);
    timing_free(m->sys.timing);
    numbering_free(m->sys.numbering);
    backtrace_lines_free(m->lines);
    for (size_t i = 0; i < m->image_count; i++)
        node_image_close(m->images[i]);
    free(m->images);
    for (size_t i = 0; i < m->sys.host_file_count; i++)
        free(m->sys.host_files[i]);
    free(m->sys.host_files);
    for (size_t i = 0; i < m->sys.absent_count; i++) {
        free(m->sys.absent[i].function);
        free(m->sys.absent[i].first);
    }
    free(m->sys.absent);
    free(m->sys.failure);
    free(m->message);
    waitfor_free(m->waits);
    free(m);
}

uint32_t machine_program_sum(const struct machine *m)
{
    uint32_t sum = 0;
    for (size_t i = 0; i < m->options.program_count; i++) {
        const struct named_program *p = &m->options.programs[i];
        sum = sum * 31 + elf_loaded_sum(node_image_elf(image_at(m, p->argv[0])));
        sum += i ? p->nodes : 0;
    }
    return sum;
}

uint32_t machine_nodes(const struct machine *m)
{
    return m->sys.cube ? cube_most(m->sys.cube) : m->sys.count;
}
