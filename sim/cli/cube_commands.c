/* cube_commands.c - the commands of the host's shell: getcube, load and the others ask the service that
 * touchstone srm starts. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "cli/commands.h"
#include "cli/options.h"
#include "files/atomic_file.h"
#include "files/program_file.h"
#include "kernel/xalloc.h"
#include "srm/client.h"
#include "srm/socket.h"

enum { EXIT_NO_SERVICE = 69 };

enum { HOST = CLI_KEY };

struct arguments {
    const char *socket, *cube, *type, *json;
    char **words; /* load: options of touchstone run, then the program and its arguments */
    int word_count;
    bool has_host;
};

/* --- options of all of them --- */

static const struct argp_option OPTIONS[] = {
    {NULL, 'c', "NAME", 0,
     "Name of the cube; getcube takes 'default' by default, the others the cube that this terminal got last "
     "or is attached to",
     1},
    {"socket", CLI_TEXT(arguments, socket), "PATH", 0,
     "Where the service listens; default $TOUCHSTONE_SRM, else its usual place", 1},
    {0}};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    if (key != 'c')
        return cli_store(key, arg, state);
    ((struct arguments *)state->input)->cube = arg;
    return 0;
}

static const struct argp CUBE = {OPTIONS, parse, NULL, NULL, NULL, NULL, NULL};
static const struct argp_child CHILDREN[] = {{&CUBE, 0, NULL, 0}, {0}};

/* --- options of one command --- */

static const struct argp_option GET_OPTIONS[] = {
    {NULL, 't', "TYPE", 0, "16 (nodes), d4 (2^4), 4m16 (16 MB each), 4x8 (a mesh); default all", 1}, {0}};

static const struct argp_option LOAD_OPTIONS[] = {
    {NULL, 'r', "WORD", 0, "One word for touchstone run, such as -r --cfs=data; may be repeated", 1},
    {"host", HOST, "HOST", 0, "Run HOST as touchstone run --host does", 1},
    {0}};

static const struct argp_option INFO_OPTIONS[] = {
    {"json", CLI_TEXT(arguments, json), "FILE", 0, "Write JSON instead; '-' is standard output", 1}, {0}};

static void add_word(struct arguments *a, const char *word)
{
    a->words[a->word_count++] = (char *)(uintptr_t)word;
}

/* A word for touchstone run. The cube says on which nodes of which machine it runs. */
static void add_run_word(struct argp_state *state, struct arguments *a, const char *word)
{
    static const char *const cubes[] = {"-n", "-m", "--nodes", "--machine"};
    for (size_t i = 0; i < sizeof cubes / sizeof *cubes; i++)
        if (strncmp(word, cubes[i], strlen(cubes[i])) == 0)
            argp_error(state, "-r %s: the cube says which nodes and which machine; getcube gets another one",
                       word);
    add_word(a, word);
}

static void load_program(struct argp_state *state, struct arguments *a)
{
    if (access(state->argv[state->next], R_OK))
        argp_error(state, "%s: %s", state->argv[state->next], strerror(errno));
    if (named_program_words(state->argv + state->next, state->argc - state->next) < state->argc - state->next)
        argp_error(state, "a cube has one program, on all of its nodes: no ': -n NODES PROGRAM'");
    for (int i = state->next; i < state->argc; i++)
        add_word(a, state->argv[i]);
}

static error_t parse_one(int key, char *arg, struct argp_state *state)
{
    struct arguments *a = state->input;
    if (key == ARGP_KEY_INIT) {
        a->words = xcalloc(2 * (size_t)state->argc, sizeof *a->words); /* --host=HOST becomes two */
        state->child_inputs[0] = a;
    } else if (key == 't') {
        a->type = arg;
    } else if (key == 'r') {
        add_run_word(state, a, arg);
    } else if (key == HOST) {
        a->has_host = true;
        add_word(a, "--host");
        add_word(a, arg);
    } else {
        return ARGP_ERR_UNKNOWN;
    }
    return 0;
}

static error_t parse_info(int key, char *arg, struct argp_state *state)
{
    struct arguments *a = state->input;
    error_t error = parse_one(key, arg, state);
    if (error != ARGP_ERR_UNKNOWN)
        return error;
    if (key == ARGP_KEY_END && a->json)
        add_word(a, "json");
    return cli_store(key, arg, state);
}

static error_t parse_load(int key, char *arg, struct argp_state *state)
{
    struct arguments *a = state->input;
    if (key == ARGP_KEY_ARGS)
        load_program(state, a);
    else if (key == ARGP_KEY_NO_ARGS && !a->has_host)
        argp_error(state, "which program? (built by nxcc)");
    else
        return parse_one(key, arg, state);
    return 0;
}

/* --- the commands --- */

const struct cli_cube_command CLI_CUBE_COMMANDS[] = {
    {"getcube", "Get nodes of the machine as a cube", GET_OPTIONS, parse_one, NULL},
    {"load", "Start a program on a cube's nodes", LOAD_OPTIONS, parse_load,
     "PROGRAM [ARGS...]\n--host=HOST [PROGRAM [ARGS...]]"},
    {"waitcube", "Wait for a program, and show its output", NULL, parse_one, NULL},
    {"killcube", "End a cube's program", NULL, parse_one, NULL},
    {"relcube", "Give a cube's nodes back", NULL, parse_one, NULL},
    {"cubeinfo", "Show who has which nodes, and what runs", INFO_OPTIONS, parse_info, NULL},
    {"attachcube", "Make a cube the default of this terminal", NULL, parse_one, NULL},
    {0}};

static const char DOC[] =
    "touchstone srm starts the service that these commands ask: getcube, load, waitcube, killcube, "
    "relcube, cubeinfo, attachcube. touchstone srm --links DIR makes links by these names.\n\n"
    "load returns at once. waitcube shows the output from the program's start. A cube stays when its "
    "program ends; relcube ends the program.\n\n"
    "Exit status:\n"
    "  0   done; waitcube: the status is the program's\n"
    "  1   refused, with the reason; or FILE cannot be written\n"
    "  64  wrong arguments\n"
    "  69  no service answers\n\n"
    "Example:\n"
    "  getcube -t 16 && load ring && waitcube; relcube";

const struct cli_cube_command *cli_cube_command(const char *name)
{
    for (const struct cli_cube_command *c = CLI_CUBE_COMMANDS; c->name; c++)
        if (!strcmp(c->name, name))
            return c;
    return NULL;
}

static int failed(const char *command, char *error, int status)
{
    fprintf(stderr, "%s: %s\n", command, error);
    free(error);
    return status;
}

static int ask(const char *command, const struct arguments *a, FILE *out)
{
    char path[SOCKET_PATH], folder[4096], session[16];
    char *error = socket_path(a->socket, false, path);
    int status = -1;
    snprintf(session, sizeof session, "%d", (int)getsid(0));
    const struct request r = {command, folder, session, a->cube, a->type, a->word_count, a->words};
    if (!error && !getcwd(folder, sizeof folder))
        error = xasprintf("the current folder: %m");
    if (!error)
        status = client_ask(path, &r, out, &error);
    return status >= 0 ? status : failed(command, error, EXIT_NO_SERVICE);
}

/* Asks for what is to be a file. */
static int ask_for_file(const char *command, const struct arguments *a)
{
    struct atomic_file f;
    char *error = NULL;
    int status = 1;
    if (atomic_file_begin(&f, a->json, &error)) {
        status = ask(command, a, f.out);
        if (status)
            atomic_file_drop(&f);
        else
            atomic_file_end(&f, &error);
    }
    return error ? failed(command, error, 1) : status;
}

int cli_cube(int argc, char **argv)
{
    const struct cli_cube_command *c = cli_cube_command(argv[0]);
    struct arguments a = {.cube = "", .type = ""};
    char *name = xasprintf("touchstone %s", c->name), *doc = xasprintf("%s.\v%s", c->what, DOC);
    const struct argp argp = {c->options, c->parse, c->arguments, doc, CHILDREN, NULL, NULL};
    cli_parse(&argp, name, ARGP_IN_ORDER, argc, argv, &a);
    int status = a.json ? ask_for_file(c->name, &a) : ask(c->name, &a, stdout);
    free(name);
    free(doc);
    free(a.words);
    return status;
}
