/* serve_command.c - touchstone serve: results in a browser, live. */
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include "lab/commands/lab_commands.h"
#include "cli/host_files.h"
#include "cli/installation.h"
#include "cli/options.h"
#include "cli/say.h"
#include "kernel/xalloc.h"
#include "lab/serve/listening.h"
#include "lab/serve/serve.h"

enum { PORT = CLI_KEY, MOST_PORT = 65535 };

struct arguments {
    const char *address;
    const char **inputs; /* ended by NULL */
    size_t count;
    uint32_t port;
    unsigned jobs;
};

static const struct argp_option OPTIONS[] = {
    {"port", PORT, "PORT", 0, "Listen at that port; default any that is free", 1},
    {"address", CLI_TEXT(arguments, address), "ADDRESS", 0,
     "Listen at that address of this computer, such as 192.168.1.5; default 127.0.0.1, which only this "
     "computer reaches",
     1},
    {0}};

static const char DOC[] =
    "Shows the page of touchstone page in a browser, live: a study's points appear as they are computed, "
    "whoever runs the study; a form runs one more point, of any number of nodes, any value on the study's "
    "axes, and any number of the machine file, and the point joins the curves. Prints the address to open, "
    "and serves until Ctrl-C.\v"
    "DIR is the folder of a study, which may be running or yet to begin again: points that the form added "
    "are in DIR/added, and stay when the study is run again. Anything else that touchstone page shows may "
    "be given, too; it is read once, at the start.\n\n"
    "The address has a token; a request without it gets nothing, even from this computer. With --address, "
    "other computers can reach the server, but nothing is encrypted, and whoever learns the token can run "
    "the study's program with other numbers. It is safer to keep the default address, and to reach the "
    "server from another computer by ssh -L 8860:127.0.0.1:8860 THIS-COMPUTER.\n\n"
    "Exit status:\n"
    "  0   ended by Ctrl-C (SIGINT), SIGTERM or SIGHUP; runs under way were stopped\n"
    "  64  wrong arguments\n"
    "  65  an input cannot be used, or the port is taken\n\n"
    "Example:\n"
    "  touchstone study groups.cfg -o out/groups &\n"
    "  touchstone serve --port 8860 out/groups";

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct arguments *a = state->input;
    if (key == ARGP_KEY_INIT)
        state->child_inputs[0] = &a->jobs;
    else if (key == PORT)
        a->port = cli_whole(state, "--port", "a number of a port", MOST_PORT, arg);
    else if (key == ARGP_KEY_ARG)
        a->inputs[a->count++] = arg;
    else if (key == ARGP_KEY_NO_ARGS)
        argp_error(state, "the results of which study? (touchstone serve DIR...)");
    else
        return cli_store(key, arg, state);
    return 0;
}

static void warn(const char *address)
{
    char name[HOST_NAME_MAX + 1] = "its name", how[HOST_NAME_MAX + 80] = "";
    if (listening_is_local(address))
        return;
    if (listening_is_everywhere(address)) {
        gethostname(name, sizeof name);
        snprintf(how, sizeof how, ": for localhost they write %s, or this computer's IP address", name);
    }
    cli_say_warning("serve",
                    "warning: other computers can reach %s%s; nothing is encrypted, and whoever learns the "
                    "token can run the study's program",
                    address, how);
}

int cli_serve(int argc, char **argv)
{
    static const struct argp_child CHILDREN[] = {
        {&CLI_JOBS, 0, NULL, 0}, {&CLI_RUNS_HOST_FILES, 0, NULL, 0}, {0}};
    static const struct argp ARGP = {OPTIONS, parse, "DIR...", DOC, CHILDREN, NULL, NULL};
    struct arguments a = {.address = "127.0.0.1", .inputs = xcalloc((size_t)argc + 1, sizeof(char *))};
    struct cli_installation places;
    char *error = NULL;
    cli_parse(&ARGP, "touchstone serve", 0, argc, argv, &a);
    if (!cli_find_installation(&places, "serve"))
        return CLI_EXIT_INPUT;
    struct serve_options options = {.address = a.address,
                                    .port = a.port,
                                    .inputs = a.inputs,
                                    .at_once = cli_jobs(a.jobs),
                                    .places = {places.runner, places.machines, stderr},
                                    .out = stdout};
    warn(a.address);
    bool ok = serve(&options, &error);
    if (!ok)
        cli_say_error("serve", "%s", error);
    free(error);
    free(a.inputs);
    return ok ? 0 : CLI_EXIT_INPUT;
}
