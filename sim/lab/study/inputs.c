/* inputs.c - see inputs.h. */
#include "lab/study/inputs.h"
#include "config/config.h"
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "files/words.h"
#include "net/topo.h"

#include <gnu/libc-version.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A machine file with settings that has been checked. Points have few different machines: the latest are
 * remembered. */
struct checked {
    char *name; /* machine file and settings, a line each; NULL: this slot is free */
    struct digest digest;
    char *machine;
    bool cube;
    uint32_t dimension, rows, columns;
};
enum { MACHINES = 64 };

struct inputs {
    const struct spec *spec;
    struct inputs_paths paths;
    json_t *shared; /* the inputs that all points share */
    struct checked machines[MACHINES];
    char *latest_path; /* the machine file whose digest was taken last */
    struct digest latest;
};

/* --- what all points share ------------------------------------------------------------------------------ */

/* The path of name relative to dir; malloc'd. */
static char *from(const char *dir, const char *name)
{
    return *name == '/' ? xstrdup(name) : xasprintf("%s/%s", dir, name);
}

static bool read_shared(struct inputs *in, char **error)
{
    json_t *files = json_object();
    bool ok = true;
    for (const char **name = in->spec->inputs; ok && *name; name++) {
        char *path = from(in->paths.dir, *name), *why = NULL;
        ok = digest_set_file(files, *name, path, &why);
        if (!ok)
            *error = xasprintf("%s: inputs: %s", in->spec->path, why);
        free(path);
        free(why);
    }
    json_set(in->shared, "inputs", files);
    json_set(in->shared, "libc", json_string(gnu_get_libc_version()));
    json_set(in->shared, "profile", json_boolean(in->spec->profile));
    return ok && digest_set_file(in->shared, "touchstone", in->paths.runner, error) &&
           digest_set_file(in->shared, "program", in->paths.program, error);
}

struct inputs *inputs_open(const struct spec *s, const struct inputs_paths *paths, char **error)
{
    struct inputs *in = xcalloc(1, sizeof *in);
    *in = (struct inputs){.spec = s, .paths = *paths, .shared = json_object()};
    if (read_shared(in, error))
        return in;
    inputs_close(in);
    return NULL;
}

static void forget(struct checked *c)
{
    free(c->name);
    free(c->machine);
    *c = (struct checked){0};
}

void inputs_close(struct inputs *in)
{
    if (!in)
        return;
    for (int i = 0; i < MACHINES; i++)
        forget(&in->machines[i]);
    json_decref(in->shared);
    free(in->latest_path);
    free(in);
}

/* --- the machine ---------------------------------------------------------------------------------------- */

char **inputs_settings(const struct inputs *in, const struct point *p)
{
    char **list = point_settings(in->spec, p);
    words_add_each(&list, NULL, in->paths.set);
    return list;
}

char **inputs_arguments(const struct inputs *in, const struct point *p)
{
    char **list = point_arguments(in->spec, p);
    words_add_each(&list, NULL, in->paths.arguments);
    return list;
}

/* The machine's name as touchstone run takes it: a path is relative to the study's folder. */
static char *machine_name(const struct inputs *in, const char *name)
{
    return cfg_is_path(name) ? from(in->paths.dir, name) : xstrdup(name);
}

/* Turns an error about the machine or a setting into one that names their line in the study file. */
static char *located(const struct inputs *in, const struct point *p, char **settings, char *error)
{
    const struct spec_axis *axis = spec_axis(in->spec, "machine");
    config_setting_t *at = axis ? axis->at : config_setting_get_member(in->spec->reader.root, "machine");
    const char *said = error;
    for (size_t i = 0; settings && settings[i]; i++) {
        const char *found = strstr(error, settings[i]);
        if (found && found[strlen(settings[i])] == ':') {
            at = point_setting_at(in->spec, p, i);
            said = found;
            break;
        }
    }
    char *file = cfg_path_at(&in->spec->reader, at);
    char *text =
        at ? xasprintf("%s:%u: %s", file, (unsigned)config_setting_source_line(at), said) : xstrdup(said);
    free(file);
    free(error);
    return text;
}

bool inputs_machine_file(const char *path, struct digest *d)
{
    struct cfg_reader r;
    char *text = NULL;
    size_t size = 0;
    FILE *out = cfg_open(&r, path) ? xchecked(open_memstream(&text, &size)) : NULL;
    bool good = out;
    if (out) {
        config_write(&r.lib, out);
        fclose(out);
        *d = digest_of(text, size);
    }
    free(text);
    free(r.error);
    cfg_close(&r);
    return good;
}

/* The digest of a machine file; the latest one is remembered. */
static bool take_digest(struct inputs *in, const char *path, struct digest *d)
{
    if (!in->latest_path || strcmp(in->latest_path, path) != 0) {
        if (!inputs_machine_file(path, &in->latest))
            return false;
        free(in->latest_path);
        in->latest_path = xstrdup(path);
    }
    *d = in->latest;
    return true;
}

static bool check(struct inputs *in, const struct point *p, const char *machine, char **settings,
                  struct checked *c, char **error)
{
    char *name = machine_name(in, machine);
    struct cfg_machine *m = cfg_load_with(name, in->paths.machines, (const char *const *)settings, error);
    free(name);
    if (!m || !take_digest(in, m->path, &c->digest)) {
        *error = m ? xasprintf("%s cannot be read", m->path) : located(in, p, settings, *error);
        cfg_free(m);
        return false;
    }
    c->machine = xstrdup(m->name);
    c->cube = m->topology == CFG_HYPERCUBE;
    c->dimension = m->dimension;
    c->rows = m->rows;
    c->columns = m->columns;
    cfg_free(m);
    return true;
}

/* Has the machine enough nodes? */
static bool fits(const struct inputs *in, const struct point *p, const struct checked *c, char **error)
{
    struct topo t;
    uint32_t nodes = (uint32_t)point_nodes(in->spec, p);
    if (c->cube ? topo_hypercube(&t, nodes, c->dimension) : topo_mesh(&t, nodes, c->rows, c->columns))
        return true;
    const struct spec_axis *axis = spec_axis(in->spec, "nodes");
    config_setting_t *at = axis ? axis->at : config_setting_get_member(in->spec->reader.root, "nodes");
    *error = c->cube ? xasprintf("%s:%u: nodes: %s has no %u nodes: it is a hypercube of at most %u",
                                 in->spec->path, (unsigned)config_setting_source_line(at), c->machine, nodes,
                                 1u << c->dimension)
                     : xasprintf("%s:%u: nodes: %s has no rectangle of %u nodes: it is a mesh of %u x %u",
                                 in->spec->path, (unsigned)config_setting_source_line(at), c->machine, nodes,
                                 c->rows, c->columns);
    return false;
}

/* The machine and its settings, a line each; malloc'd. */
static char *lines_of(const char *machine, char **settings)
{
    char *all = xstrdup(machine);
    for (char **one = settings; one && *one; one++)
        words_append(&all, "\n%s", *one);
    return all;
}

/* The point's machine, remembered or checked now. NULL with *error. */
static struct checked *machine_of(struct inputs *in, const struct point *p, char **settings, char **error)
{
    const char *machine = point_machine(in->spec, p);
    char *name = lines_of(machine, settings);
    size_t hash = 0;
    for (const char *c = name; *c; c++)
        hash = hash * 31 + (unsigned char)*c;
    struct checked *known = &in->machines[hash % MACHINES];
    bool ok = known->name && strcmp(known->name, name) == 0;
    if (!ok) {
        forget(known);
        if ((ok = check(in, p, machine, settings, known, error)))
            known->name = xstrdup(name);
    }
    free(name);
    return ok && fits(in, p, known, error) ? known : NULL;
}

/* The words as a JSON list. Frees the words. */
static json_t *words_json(char **words)
{
    json_t *list = json_texts(words);
    words_free(words);
    return list;
}

bool inputs_of(struct inputs *in, const struct point *p, struct digest *key, json_t **all, char **error)
{
    char **settings = inputs_settings(in, p);
    const struct checked *machine = machine_of(in, p, settings, error);
    if (!machine) {
        words_free(settings);
        return false;
    }
    json_t *own = json_copy(in->shared);
    json_set(own, "nodes", json_integer((json_int_t)point_nodes(in->spec, p)));
    json_set(own, "machine", digest_json(machine->digest));
    json_set(own, "settings", words_json(settings));
    json_set(own, "arguments", words_json(inputs_arguments(in, p)));
    *key = digest_of_json(own);
    if (all)
        *all = own;
    else
        json_decref(own);
    return true;
}
