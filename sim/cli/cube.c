/* cube.c - getcube, cubeinfo, attachcube, load, waitcube, killcube and relcube: the shell commands of the host, which ask
 * the service that touchstone srm starts. */
#include <errno.h>
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "cli/cli.h"
#include "srm/client.h"
#include "srm/socket.h"

const char *const CLI_CUBE_COMMANDS[] = {"getcube",  "cubeinfo", "attachcube", "load",
                                         "waitcube", "killcube", "relcube",    NULL};

static const char HELP[] =
    "usage: getcube [-t TYPE] [-c NAME]     get nodes: TYPE 16 (nodes), d4 (2^4), 4m16 (16 MB each), 4x8 (mesh); else all\n"
    "       load [-c NAME] [-r WORD]... [--host HOST] PROGRAM [ARGS...]\n"
    "                                       start PROGRAM, built by nxcc, on the cube's nodes; returns at once. -r: one\n"
    "                                       word for touchstone run, such as -r --cfs=data\n"
    "       waitcube [-c NAME]              show what it says, and wait until it has ended; its exit status\n"
    "       killcube [-c NAME]              end it; the cube stays\n"
    "       relcube [-c NAME]               give the nodes back, ending what runs there\n"
    "       cubeinfo                        who has which nodes, and what runs there\n"
    "       attachcube -c NAME              work with this cube from now on, in this terminal\n"
    "\n"
    "Each is also a subcommand: touchstone getcube -t 16. touchstone srm starts the service that they ask, and --links DIR\n"
    "makes links by these names. Without -c, a command means the cube that this terminal got last or is attached to.\n"
    "All take --socket PATH, where the service listens (else $TOUCHSTONE_SRM, else its usual place).\n"
    "\n"
    "Exit status: 0; 1 refused, with the reason; 64 wrong arguments; 69 no service; waitcube: the program's.\n"
    "\n"
    "example: getcube -t 16 && load ring && waitcube; relcube\n";

enum { EXIT_USAGE = 64, EXIT_NO_SERVICE = 69 };

struct arguments {
    const char *socket, *cube, *type;
    char **words; /* load: for touchstone run, then the program and its arguments */
    int word_count;
    bool help;
};

bool cli_is_cube_command(const char *name)
{
    for (const char *const *c = CLI_CUBE_COMMANDS; *c; c++)
        if (!strcmp(*c, name))
            return true;
    return false;
}

static int parse(int argc, char **argv, struct arguments *a)
{
    enum { SOCKET = 256, HOST };
    static const struct option LONG[] = {{"socket", required_argument, NULL, SOCKET},
                                         {"host", required_argument, NULL, HOST},
                                         {"help", no_argument, NULL, 'h'},
                                         {0}};
    const char *command = argv[0];
    bool loads = !strcmp(command, "load"), gets = !strcmp(command, "getcube"), has_host = false;
    *a = (struct arguments){.cube = "", .type = "", .words = calloc((size_t)argc + 2, sizeof *a->words)};
    if (!a->words)
        abort();
    optind = 0;
    opterr = 0;
    for (int c; (c = getopt_long(argc, argv,
                                 loads  ? "+:c:r:h"
                                 : gets ? "+:c:t:h"
                                        : "+:c:h",
                                 LONG, NULL)) != -1;) {
        switch (c) {
        case 'c':
            a->cube = optarg;
            break;
        case 't':
            a->type = optarg;
            break;
        case 'r':
            a->words[a->word_count++] = optarg;
            break;
        case HOST:
            if (!loads)
                return cli_usage(command, "there is no option --host");
            has_host = true;
            a->words[a->word_count++] = (char *)"--host";
            a->words[a->word_count++] = optarg;
            break;
        case SOCKET:
            a->socket = optarg;
            break;
        case 'h':
            a->help = true;
            return 0;
        case ':':
            return cli_usage(command, "%s needs a value", argv[optind - 1]);
        default:
            return cli_usage(command, "there is no option %s", argv[optind - 1]);
        }
    }
    if (loads && optind == argc && !has_host)
        return cli_usage(command, "which program? (built by nxcc)");
    if (loads && optind < argc && access(argv[optind], R_OK))
        return cli_usage(command, "%s: %s", argv[optind], strerror(errno));
    if (!loads && optind < argc)
        return cli_usage(command, "it takes no '%s'", argv[optind]);
    while (optind < argc)
        a->words[a->word_count++] = argv[optind++];
    return 0;
}

static int ask(const char *command, const struct arguments *a)
{
    char path[SOCKET_PATH], folder[4096], session[16];
    char *error = socket_path(a->socket, path);
    int status = -1;
    snprintf(session, sizeof session, "%d", (int)getsid(0));
    const struct request r = {command, folder, session, a->cube, a->type, a->word_count, a->words};
    if (!error && !getcwd(folder, sizeof folder) && asprintf(&error, "the current folder: %m") < 0)
        abort();
    if (!error)
        status = client_ask(path, &r, &error);
    if (status >= 0)
        return status;
    fprintf(stderr, "%s: %s\n", command, error);
    free(error);
    return EXIT_NO_SERVICE;
}

int cli_cube(int argc, char **argv)
{
    struct arguments a;
    int status = parse(argc, argv, &a);
    if (!status && a.help)
        fputs(HELP, stdout);
    else if (!status)
        status = ask(argv[0], &a);
    free(a.words);
    return status;
}
