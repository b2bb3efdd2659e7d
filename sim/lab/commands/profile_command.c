/* profile_command.c - touchstone profile: where the time of a run went, by path of calls and by line. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "lab/commands/lab_commands.h"
#include "cli/say.h"
#include "cli/trace_options.h"
#include "files/atomic_file.h"
#include "lab/flame/flame.h"

enum { NODES = CLI_KEY };

typedef void writer(const struct flame *f, FILE *out);

static const struct format {
    const char *name;
    writer *frames, *lines; /* lines NULL: not in this format */
} FORMATS[] = {{"text", flame_write_text, flame_write_lines},
               {"folded", flame_write_folded, NULL},
               {"svg", flame_write_svg, NULL},
               {"json", flame_write_json, flame_write_lines_json}};
enum { FORMAT_COUNT = sizeof FORMATS / sizeof *FORMATS };

struct arguments {
    const char *path, *before, *out, *json;
    const struct format *format;
    bool lines;
    bool *nodes;
    uint32_t node_count;
};

static const struct argp_option OPTIONS[] = {
    {"format", 'f', "text|folded|svg|json", 0,
     "text: a tree as a table (the default); folded: stacks as flamegraph.pl reads them, in picoseconds; "
     "svg: a flame graph for browsers, to hover, zoom and search; json: nested, as d3-flame-graph reads it",
     0},
    {"output", 'o', "OUT", 0,
     "Write to the file OUT; the end of its name is the format, unless -f says another", 0},
    {"json", CLI_TEXT(arguments, json), "FILE", 0, "The same as -f json -o FILE; '-' is standard output", 0},
    {"lines", CLI_FLAG(arguments, lines), NULL, 0,
     "Lines of source instead of paths of calls; with -f text or json", 0},
    {"diff", CLI_TEXT(arguments, before), "OTHER", 0,
     "What has changed since the profile OTHER: red has grown, blue has shrunk", 0},
    {"nodes", NODES, "LIST", 0, "Only nodes such as 0-7,12", 0},
    {0}};

static const struct format *find_format(const char *name)
{
    for (int i = 0; i < FORMAT_COUNT; i++)
        if (!strcmp(FORMATS[i].name, name))
            return &FORMATS[i];
    return NULL;
}

/* The format that the name of the output file tells. */
static const struct format *format_of_output(const char *out)
{
    const char *end = out ? strrchr(out, '.') : NULL;
    const struct format *f = end ? find_format(end + 1) : NULL;
    return f ? f : &FORMATS[0];
}

static void check(struct argp_state *state, struct arguments *a)
{
    if (a->json && (a->format || a->out))
        argp_error(state, "--json FILE is the same as -f json -o FILE, and leaves no other -f or -o");
    if (a->json)
        a->format = find_format("json"), a->out = a->json;
    if (!a->format)
        a->format = format_of_output(a->out);
    if (a->lines && !a->format->lines)
        argp_error(state, "--lines is with -f text or json, not with %s", a->format->name);
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct arguments *a = state->input;
    if (key == 'f' && !(a->format = find_format(arg)))
        argp_error(state, "-f takes text, folded, svg or json, not '%s'", arg);
    else if (key == 'o')
        a->out = arg;
    else if (key == NODES)
        cli_node_list(state, "--nodes", arg, &a->nodes, &a->node_count, NULL);
    else if (key == ARGP_KEY_ARG)
        return cli_store_only(&a->path, arg);
    else if (key == ARGP_KEY_NO_ARGS)
        argp_error(state, "which profile? (written by touchstone run --profile FILE)");
    else if (key == ARGP_KEY_END)
        check(state, a);
    else if (key != 'f')
        return cli_store(key, arg, state);
    return 0;
}

static int fail(char *error, int status)
{
    return cli_failed("profile", error, status);
}

static int write_out(const struct flame *f, const struct arguments *a)
{
    struct atomic_file file;
    char *error = NULL;
    if (!atomic_file_begin(&file, a->out ? a->out : "-", &error))
        return fail(error, CLI_EXIT_OUTPUT);
    (a->lines ? a->format->lines : a->format->frames)(f, file.out);
    return atomic_file_end(&file, &error) ? 0 : fail(error, CLI_EXIT_OUTPUT);
}

int cli_profile(int argc, char **argv)
{
    static const struct argp ARGP = {
        OPTIONS,
        parse,
        "PROFILE",
        "Shows where the virtual time of a run went: by path of calls, or by line of source. "
        "Nothing is sampled: to the picosecond, the frames add up to the time in which the nodes computed, "
        "waited, or ran the system.\v"
        "PROFILE is what touchstone run --profile FILE writes, for a program built with nxcc --profile; - is "
        "standard input. What is shown goes to standard output, or with -o to a file.\n\n"
        "Exit status:\n"
        "  0   done\n"
        "  64  wrong arguments\n"
        "  65  a profile cannot be used\n"
        "  74  the result cannot be written\n\n"
        "Example:\n"
        "  nxcc -O2 --profile -o relax relax.c\n"
        "  touchstone run -n 16 --profile relax.json relax\n"
        "  touchstone profile relax.json\n"
        "  touchstone profile -o relax.svg relax.json\n"
        "  touchstone profile --lines relax.json\n"
        "  touchstone profile --diff before.json -o changed.svg relax.json\n"
        "  touchstone profile -f folded relax.json |\n"
        "      flamegraph.pl --countname ps >relax.svg",
        NULL,
        NULL,
        NULL};
    struct arguments a = {0};
    char *error = NULL;
    cli_parse(&ARGP, "touchstone profile", 0, argc, argv, &a);
    atomic_file_drop_at_signals();
    struct flame_selection select = {a.nodes, a.node_count};
    struct flame *f = flame_load(a.path, a.before, &select, &error);
    int status = f ? write_out(f, &a) : fail(error, CLI_EXIT_INPUT);
    if (f)
        flame_free(f);
    free(a.nodes);
    return status;
}
