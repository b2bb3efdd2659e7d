/* tables_main.c - touchstone-lab with the command tables alone, which `make tables` builds: as lab_main.c. */
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include "cli/installation.h"
#include "cli/say.h"
#include "lab/commands/lab_commands.h"

int main(int argc, char **argv)
{
    signal(SIGXFSZ, SIG_IGN); /* as in cli/main.c */
    cli_watch_output("tables");
    if (argc > 1 && !cli_is_lab(argv[0]) && !strcmp(argv[1], "tables"))
        return cli_tables(argc - 1, argv + 1);
    fprintf(stderr, "this touchstone has only run and tables; `make` builds all commands into build/\n");
    return 64;
}
