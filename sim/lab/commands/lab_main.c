/* lab_main.c - touchstone-lab: runs the command that touchstone hands on. argv[0] is the path of the
 * touchstone that does so, which simulates for the command: cli/installation.h. */
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include "cli/installation.h"
#include "cli/say.h"
#include "lab/commands/lab_commands.h"

static const struct {
    const char *name;
    int (*run)(int argc, char **argv);
} COMMANDS[] = {{"study", cli_study},       {"explore", cli_explore}, {"plot", cli_plot},
                {"render", cli_render},     {"page", cli_page},       {"serve", cli_serve},
                {"deadlock", cli_deadlock}, {"check", cli_check},     {"fit", cli_fit},
                {"tables", cli_tables},     {"trace", cli_trace},     {"profile", cli_profile},
                {"machines", cli_machines}, {"run", cli_sensitivity} /* as touchstone does, else */};

int main(int argc, char **argv)
{
    signal(SIGXFSZ, SIG_IGN); /* as in cli/main.c */
    cli_watch_output(argc > 1 ? argv[1] : "-lab");
    for (size_t i = 0; i < sizeof COMMANDS / sizeof *COMMANDS && argc > 1 && !cli_is_lab(argv[0]); i++)
        if (!strcmp(argv[1], COMMANDS[i].name))
            return COMMANDS[i].run(argc - 1, argv + 1);
    fprintf(stderr, "touchstone-lab is a part of touchstone, which starts it: call touchstone COMMAND\n");
    return 64;
}
