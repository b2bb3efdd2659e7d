/* srm.c - touchstone srm: starts the service that shares out a machine's nodes. */
#include <errno.h>
#include <fcntl.h>
#include <getopt.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "cli/cli.h"
#include "srm/cube_service.h"
#include "srm/socket.h"

static const char HELP[] =
    "usage: touchstone srm [-m MACHINE] [--socket PATH] [-d] [--log FILE]\n"
    "       touchstone srm --links DIR\n"
    "\n"
    "Does what the System Resource Manager, the host of an iPSC, did for its users: shares out the machine's nodes as cubes,\n"
    "at most ten at once, and runs programs on them. Users ask it by getcube, load, waitcube, killcube, relcube, cubeinfo\n"
    "and attachcube (touchstone getcube --help).\n"
    "\n"
    "  -m MACHINE      a machine file (machines/NAME.cfg by its NAME, or a path); default ipsc860\n"
    "  --socket PATH   where it listens, for its own user only; default $TOUCHSTONE_SRM, else\n"
    "                  $XDG_RUNTIME_DIR/touchstone-srm, else /tmp/touchstone-UID/srm\n"
    "  -d              go into the background once it listens; what it would say goes to PATH.log\n"
    "  --log FILE      say it there\n"
    "  --links DIR     make links to touchstone in DIR by the names of the commands, and end\n"
    "\n"
    "SIGTERM and SIGINT end it, and what runs on its cubes.\n"
    "Exit status: 0; 1 it cannot listen; 64 wrong arguments; 65 no such machine.\n"
    "\n"
    "example: touchstone srm -m ipsc860 -d && touchstone getcube -t 16\n";

enum { EXIT_USAGE = 64, EXIT_INPUT = 65 };

struct arguments {
    const char *machine, *socket, *log, *links;
    bool background, help;
};

static int parse(int argc, char **argv, struct arguments *a)
{
    enum { SOCKET = 256, LOG, LINKS };
    static const struct option LONG[] = {
        {"machine", required_argument, NULL, 'm'}, {"socket", required_argument, NULL, SOCKET},
        {"log", required_argument, NULL, LOG},     {"links", required_argument, NULL, LINKS},
        {"help", no_argument, NULL, 'h'},          {0}};
    *a = (struct arguments){.machine = "ipsc860"};
    optind = 0;
    opterr = 0;
    for (int c; (c = getopt_long(argc, argv, "+:m:dh", LONG, NULL)) != -1;) {
        switch (c) {
        case 'm':
            a->machine = optarg;
            break;
        case SOCKET:
            a->socket = optarg;
            break;
        case LOG:
            a->log = optarg;
            break;
        case LINKS:
            a->links = optarg;
            break;
        case 'd':
            a->background = true;
            break;
        case 'h':
            a->help = true;
            return 0;
        case ':':
            return cli_usage("srm", "%s needs a value", argv[optind - 1]);
        default:
            return cli_usage("srm", "there is no option %s", argv[optind - 1]);
        }
    }
    return optind < argc ? cli_usage("srm", "it takes no '%s'", argv[optind]) : 0;
}

static int failed(char *error, int status)
{
    fprintf(stderr, "touchstone srm: %s\n", error);
    free(error);
    return status;
}

static bool find_self(char self[PATH_MAX])
{
    ssize_t n = readlink("/proc/self/exe", self, PATH_MAX - 1);
    self[n > 0 ? n : 0] = '\0';
    return n > 0;
}

static int make_links(const char *dir, const char *self)
{
    for (const char *const *c = CLI_CUBE_COMMANDS; *c; c++) {
        char link[PATH_MAX];
        snprintf(link, sizeof link, "%s/%s", dir, *c);
        if (symlink(self, link) == 0 || errno == EEXIST)
            continue;
        fprintf(stderr, "touchstone srm: %s cannot be made: %s\n", link, strerror(errno));
        return 1;
    }
    return 0;
}

/* Into the background: the caller's process ends with 0. The socket's lock goes with us. */
static void leave(FILE *log)
{
    int null = open("/dev/null", O_RDWR | O_CLOEXEC);
    fflush(NULL);
    pid_t pid = fork();
    if (pid != 0)
        _exit(pid < 0);
    setsid();
    for (int fd = 0; fd < 3; fd++)
        dup2(fd < 2 ? null : fileno(log), fd);
}

static int serve(const struct arguments *a, const struct cfg_machine *cfg, const char *self)
{
    char path[SOCKET_PATH], machine[PATH_MAX], log_path[SOCKET_PATH + 8];
    int fd, lock;
    if (!realpath(cfg->path, machine))
        return failed(strdup("the machine file has gone"), EXIT_INPUT);
    char *error = socket_path(a->socket, path);
    error = error ? error : socket_listen(path, &fd, &lock);
    if (error)
        return failed(error, 1);
    snprintf(log_path, sizeof log_path, "%s.log", path);
    const char *log_name = a->log ? a->log : a->background ? log_path : NULL;
    FILE *log = log_name ? fopen(log_name, "ae") : stderr;
    if (!log) {
        if (asprintf(&error, "%s cannot be written: %m", log_name) < 0)
            abort();
        socket_remove(path);
        return failed(error, 1);
    }
    if (a->background)
        leave(log);
    socket_owner(lock);
    service_run(&(struct service_options){cfg, machine, self, fd, log});
    socket_remove(path);
    close(lock);
    if (log != stderr)
        fclose(log);
    return 0;
}

int cli_srm(int argc, char **argv)
{
    struct arguments a;
    char home[4096], machines[4128], self[PATH_MAX], *error;
    int status = parse(argc, argv, &a);
    if (status)
        return status;
    if (a.help)
        return fputs(HELP, stdout), 0;
    if (!find_self(self) || !cfg_home(home, sizeof home))
        return failed(
            strdup("machines/ is not where this program was built or installed; set TOUCHSTONE_HOME"),
            EXIT_INPUT);
    if (a.links)
        return make_links(a.links, self);
    snprintf(machines, sizeof machines, "%s/machines", home);
    struct cfg_machine *cfg = cfg_load(a.machine, machines, &error);
    if (!cfg)
        return failed(error, EXIT_INPUT);
    status = serve(&a, cfg, self);
    cfg_free(cfg);
    return status;
}
