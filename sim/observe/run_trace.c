/* run_trace.c - see run_trace.h. */
#include "observe/run_trace.h"
#include <stdlib.h>
#include <unistd.h>
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "observe/json_file.h"
#include "trace/recorder.h"

/* The shape of the network, as topo.h has it: readers make the same, and find the same routes. */
static json_t *network(const struct topo *t)
{
    return xchecked(json_pack("{s:s, s:i, s:i, s:i, s:i, s:i, s:i, s:b, s:i}", "shape",
                              t->columns ? "mesh" : "hypercube", "nodes", t->nodes, "dimension", t->dimension,
                              "rows", t->rows, "columns", t->columns, "positions", t->positions, "services",
                              t->services, "host", t->host, "addresses", t->addresses));
}

static json_t *head(const struct machine *m, const struct run_trace_options *o)
{
    char *folder = getcwd(NULL, 0);
    json_t *traced = json_array(), *root = json_object();
    for (uint32_t i = 0; o->nodes && i < machine_nodes(m); i++)
        if (i < o->node_count && o->nodes[i])
            json_array_append_new(traced, json_integer(i));
    json_set(root, "version", json_text(o->version));
    json_set(root, "command", json_texts(o->command));
    json_set(root, "folder", json_text(folder ? folder : ""));
    json_set(root, "program", json_text(m->options.programs[0].argv[0]));
    json_set(root, "machine", json_text(m->sys.cfg->name));
    json_set(root, "settings", json_texts(m->sys.cfg->set));
    json_set(root, "nodes", json_integer(machine_nodes(m)));
    json_set(root, "network", network(&m->sys.topo));
    if (m->options.layer)
        json_set(root, "layer", json_texts(m->options.layer));
    if (o->nodes)
        json_set(root, "traced", traced);
    else
        json_decref(traced);
    json_set(root, "from", json_integer((json_int_t)o->from));
    if (o->to)
        json_set(root, "to", json_integer((json_int_t)o->to));
    free(folder);
    return root;
}

bool run_trace_begin(struct run_trace *t, struct machine *m, const struct run_trace_options *o, char **error)
{
    atomic_file_remove_left(o->path);
    if (!atomic_file_begin(&t->file, o->path, error))
        return false;
    const struct recorder_options wanted = {.out = t->file.out,
                                            .from = o->from,
                                            .to = o->to ? o->to : VT_NEVER,
                                            .nodes = o->nodes,
                                            .node_count = o->node_count,
                                            .addresses = m->sys.topo.addresses};
    json_t *first = head(m, o);
    t->recorder = recorder_new(&wanted, first);
    json_decref(first);
    machine_record(m, t->recorder);
    return true;
}

bool run_trace_end(struct run_trace *t, const struct machine *m, char **error)
{
    recorder_end(t->recorder, m->end, m->sys.digest);
    t->recorder = NULL;
    return atomic_file_end(&t->file, error);
}
