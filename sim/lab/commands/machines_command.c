/* machines_command.c - touchstone machines: which machines there are, their numbers, and what differs. */
#include <inttypes.h>
#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "cli/installation.h"
#include "cli/nearest.h"
#include "cli/options.h"
#include "cli/say.h"
#include "config/machine_numbers.h"
#include "files/json_set.h"
#include "kernel/xalloc.h"
#include "lab/commands/lab_commands.h"
#include "observe/json_file.h"

struct arguments {
    const char *json, *what, *names[2]; /* json: NULL: text. what: NULL: list */
    int count;                          /* of names */
};

static const struct argp_option OPTIONS[] = {
    {NULL, 0, NULL, 0, "What to do:", 1},
    {"list", 0, NULL, OPTION_DOC, "Show name, nodes and description of each machine (the default)", 0},
    {"show", 0, NULL, OPTION_DOC, "Show the numbers of MACHINE, each with its standing and source", 0},
    {"diff", 0, NULL, OPTION_DOC, "Show the numbers in which two machines differ", 0},
    {NULL, 0, NULL, 0, "Options:", 2},
    {"json", CLI_TEXT(arguments, json), "FILE", 0, "Write JSON instead; '-' is standard output", 0},
    {0}};

static const char DOC[] =
    "Shows the machines that touchstone run -m takes, and their numbers. MACHINE is the NAME of "
    "machines/NAME.cfg, or the path of a machine file.\v"
    "The standing of a number says where it comes from: read (in the source named), known (widely quoted "
    "from it), derived (arithmetic on others), fitted, or open (a choice). Each key is one that --set of "
    "touchstone run takes; but those that begin with 'cpu.' are of the file that node.cpu names, which nxcc "
    "--costs reads.\n\n"
    "Exit status:\n"
    "  0   done\n"
    "  64  wrong arguments\n"
    "  65  a machine cannot be used, or FILE cannot be written\n\n"
    "Example:\n"
    "  touchstone machines show delta\n"
    "  touchstone machines diff paragon paragon95";

/* How many machines a command is about; -1: it is none. */
static int takes(const char *what)
{
    return !strcmp(what, "list") ? 0 : !strcmp(what, "show") ? 1 : !strcmp(what, "diff") ? 2 : -1;
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct arguments *a = state->input;
    if (key == ARGP_KEY_ARG && !a->what && takes(arg) < 0)
        cli_no_such_command(state, "machines ", arg);
    else if (key == ARGP_KEY_ARG && !a->what)
        a->what = arg;
    else if (key == ARGP_KEY_ARG && a->count < takes(a->what))
        a->names[a->count++] = arg;
    else if (key == ARGP_KEY_END && a->what && a->count < takes(a->what))
        argp_error(state, "which %s? (touchstone machines lists them)",
                   takes(a->what) == 2 ? "two machines" : "machine");
    else
        return cli_store(key, arg, state);
    return 0;
}

static uint64_t most_nodes(const struct cfg_machine *m)
{
    return m->topology == CFG_HYPERCUBE ? 1u << m->dimension : m->rows * m->columns;
}

/* --- text ----------------------------------------------------------------------------------------------- */

/* A machine of those asked for. */
struct machine {
    struct cfg_machine *cfg;
    struct cfg_numbers *numbers;
};

static int widest(const struct cfg_numbers *n)
{
    int most = 0;
    for (size_t i = 0; i < n->count; i++)
        most = (int)strlen(n->list[i].key) > most ? (int)strlen(n->list[i].key) : most;
    return most;
}

static void print_list(const struct machine *list, int count, FILE *f)
{
    for (int i = 0; i < count; i++)
        fprintf(f, "%-12s %5" PRIu64 " nodes  %s\n", list[i].cfg->name, most_nodes(list[i].cfg),
                list[i].cfg->description);
}

static void print_numbers(const struct machine *m, FILE *f)
{
    fprintf(f, "%s: %s\n%s\n\n", m->cfg->name, m->cfg->description, m->cfg->path);
    for (size_t i = 0; i < m->numbers->count; i++) {
        const struct cfg_number *n = &m->numbers->list[i];
        fprintf(f, "%-*s  ", widest(m->numbers), n->key);
        if (*n->source)
            fprintf(f, "%-9s  %-7s  %s\n", n->value, n->standing, n->source);
        else if (*n->standing)
            fprintf(f, "%-9s  %s\n", n->value, n->standing);
        else
            fprintf(f, "%s\n", n->value);
    }
}

typedef void difference(void *to, const char *key, const char *values[2]);

/* Calls tell for each key whose value differs; a value is NULL where a machine has not that key. */
static void each_difference(const struct machine pair[2], difference *tell, void *to)
{
    for (int side = 0; side < 2; side++)
        for (size_t i = 0; i < pair[side].numbers->count; i++) {
            const struct cfg_number *n = &pair[side].numbers->list[i],
                                    *other = cfg_numbers_find(pair[!side].numbers, n->key);
            const char *values[2];
            values[side] = n->value, values[!side] = other ? other->value : NULL;
            if (!other || (side == 0 && strcmp(n->value, other->value) != 0))
                tell(to, n->key, values);
        }
}

struct columns {
    FILE *f;
    const struct machine *pair;
    int key, value;
    bool any; /* a line has been written, and so the head, too */
};

static void print_row(const struct columns *c, const char *key, const char *left, const char *right)
{
    fprintf(c->f, "%-*s  %-*s  %s\n", c->key, key, c->value, left, right);
}

static void print_difference(void *to, const char *key, const char *values[2])
{
    struct columns *c = to;
    if (!c->any)
        print_row(c, "", c->pair[0].cfg->name, c->pair[1].cfg->name);
    c->any = true;
    print_row(c, key, values[0] ? values[0] : "-", values[1] ? values[1] : "-");
}

static void print_differences(const struct machine pair[2], FILE *f)
{
    int a = widest(pair[0].numbers), b = widest(pair[1].numbers);
    struct columns c = {f, pair, a > b ? a : b, 16, false};
    each_difference(pair, print_difference, &c);
    if (!c.any)
        fprintf(f, "%s and %s have the same numbers\n", pair[0].cfg->name, pair[1].cfg->name);
}

static void print(const struct arguments *a, const struct machine *list, int count)
{
    if (a->count == 2)
        print_differences(list, stdout);
    else if (a->count == 1)
        print_numbers(list, stdout);
    else
        print_list(list, count, stdout);
}

/* --- JSON ----------------------------------------------------------------------------------------------- */

static json_t *machine_json(const struct machine *m)
{
    json_t *numbers = xchecked(json_array());
    for (size_t i = 0; m->numbers && i < m->numbers->count; i++) {
        const struct cfg_number *n = &m->numbers->list[i];
        json_append(numbers, xchecked(json_pack("{s:s, s:s, s:s, s:s}", "key", n->key, "value", n->value,
                                                "standing", n->standing, "source", n->source)));
    }
    json_t *o =
        xchecked(json_pack("{s:s, s:s, s:s, s:I}", "name", m->cfg->name, "description", m->cfg->description,
                           "path", m->cfg->path, "nodes", (json_int_t)most_nodes(m->cfg)));
    if (m->numbers)
        json_set(o, "numbers", numbers);
    else
        json_decref(numbers);
    return o;
}

static void add_difference(void *to, const char *key, const char *values[2])
{
    json_append(to, xchecked(json_pack("{s:s, s:[o, o]}", "key", key, "values",
                                       json_string_or_null(values[0]), json_string_or_null(values[1]))));
}

/* NULL, or an error. */
static char *write_json(const struct arguments *a, const struct machine *list, int count)
{
    json_t *all = xchecked(json_pack("{s:s}", "format", "touchstone machines 1"));
    json_t *machines = xchecked(json_array()), *differences = xchecked(json_array());
    for (int i = 0; i < count; i++)
        json_append(machines, machine_json(&list[i]));
    json_set(all, "machines", machines);
    if (a->count == 2)
        each_difference(list, add_difference, differences);
    json_set(all, "differences", differences);
    return json_file_write(all, a->json);
}

/* --- the command ---------------------------------------------------------------------------------------- */

static bool load(struct machine *m, const char *name, const char *dir, bool with_numbers, char **error)
{
    return (m->cfg = cfg_load(name, dir, error)) &&
           (!with_numbers || (m->numbers = cfg_numbers_read(m->cfg, error)));
}

/* The names of all machines, malloc'd, a line each. */
static char *all_names(const char *dir)
{
    char *names = NULL;
    size_t size;
    FILE *f = xchecked(open_memstream(&names, &size));
    cfg_list_machines(dir, "\n", f);
    fclose(f);
    return names;
}

static bool run(const struct arguments *a, const char *dir, char **error)
{
    char *names = a->count ? NULL : all_names(dir), *rest = names;
    struct machine *list = NULL;
    int count = 0;
    bool good = true;
    const char *name;
    while (good && (name = a->count ? (count < a->count ? a->names[count] : NULL) : strsep(&rest, "\n"))) {
        list = xreallocarray(list, (size_t)count + 1, sizeof *list);
        list[count] = (struct machine){0};
        good = load(&list[count++], name, dir, a->count, error);
    }
    if (good && a->json)
        good = !(*error = write_json(a, list, count));
    else if (good)
        print(a, list, count);
    for (int i = 0; i < count; i++) {
        if (list[i].numbers)
            cfg_numbers_free(list[i].numbers);
        cfg_free(list[i].cfg);
    }
    free(list);
    free(names);
    return good;
}

int cli_machines(int argc, char **argv)
{
    static const struct argp ARGP = {OPTIONS, parse, "[list]\nshow MACHINE\ndiff MACHINE MACHINE", DOC, NULL,
                                     NULL,    NULL};
    struct arguments a = {0};
    struct cli_installation places;
    char *error = NULL;
    cli_parse(&ARGP, "touchstone machines", 0, argc, argv, &a);
    if (!cli_find_installation(&places, "machines"))
        return CLI_EXIT_INPUT;
    return run(&a, places.machines, &error) ? 0 : cli_failed("machines", error, CLI_EXIT_INPUT);
}
