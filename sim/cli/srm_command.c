/* srm_command.c - touchstone srm: starts the service that shares out a machine's nodes. */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "cli/commands.h"
#include "cli/installation.h"
#include "cli/options.h"
#include "cli/say.h"
#include "kernel/xalloc.h"
#include "srm/cube_service.h"
#include "srm/socket.h"

struct arguments {
    const char *machine, *socket, *log, *links;
    bool background;
};

static const struct argp_option OPTIONS[] = {
    {"socket", CLI_TEXT(arguments, socket), "PATH", 0,
     "Where the service listens, for its own user only; default $TOUCHSTONE_SRM, else "
     "$XDG_RUNTIME_DIR/touchstone-srm, else /tmp/touchstone-UID/srm",
     1},
    {NULL, 'd', NULL, 0, "Go into the background once the service listens; its messages go to PATH.log", 1},
    {"log", CLI_TEXT(arguments, log), "FILE", 0, "Write the messages to FILE", 1},
    {"links", CLI_TEXT(arguments, links), "DIR", 0,
     "Make links to touchstone in DIR by the names of the commands, and end", 1},
    {0}};

static const char DOC[] =
    "Does what the System Resource Manager, the host of an iPSC, did for its users: shares out the nodes "
    "of a machine, by default ipsc860, as cubes, at most ten at once, and runs programs on them. Users ask "
    "the service by getcube, load, waitcube, killcube, relcube, cubeinfo and attachcube (see touchstone "
    "getcube --help).\v"
    "Files: the socket PATH and, with -d, PATH.log, both for as long as the service runs; --log FILE "
    "stays.\n\n"
    "SIGTERM and SIGINT end the service, and the programs on its cubes.\n\n"
    "Exit status:\n"
    "  0   the service ended, or is in the background\n"
    "  1   the service cannot listen\n"
    "  64  wrong arguments\n"
    "  65  there is no such machine\n\n"
    "Example:\n"
    "  touchstone srm -m ipsc860 -d && touchstone getcube -t 16";

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct arguments *a = state->input;
    if (key == ARGP_KEY_INIT)
        state->child_inputs[0] = &a->machine;
    else if (key == 'd')
        a->background = true;
    else
        return cli_store(key, arg, state);
    return 0;
}

static int failed(char *error, int status)
{
    return cli_failed("srm", error, status);
}

static int make_links(const char *dir, const char *self)
{
    for (const struct cli_cube_command *c = CLI_CUBE_COMMANDS; c->name; c++) {
        char link[PATH_MAX];
        struct stat st;
        snprintf(link, sizeof link, "%s/%s", dir, c->name);
        if (lstat(link, &st) == 0 && S_ISLNK(st.st_mode))
            unlink(link); /* perhaps to another touchstone, which is gone */
        if (symlink(self, link) == 0)
            continue;
        cli_say_error("srm", "%s cannot be made: %s", link, strerror(errno));
        return 1;
    }
    return 0;
}

/* Goes into the background; the caller's process ends with 0 when the lock names the new process. */
static void leave(FILE *log, int lock)
{
    int null = open("/dev/null", O_RDWR | O_CLOEXEC), named[2] = {-1, -1};
    pipe2(named, O_CLOEXEC);
    fflush(NULL);
    pid_t pid = fork();
    if (pid != 0) {
        close(named[1]);
        read(named[0], &(char){0}, 1); /* returns when the child has closed its end */
        _exit(pid < 0);
    }
    socket_owner(lock);
    close(named[0]);
    close(named[1]);
    setsid();
    for (int fd = 0; fd < 3; fd++)
        dup2(fd < 2 ? null : fileno(log), fd);
}

static int serve(const struct arguments *a, const struct cfg_machine *cfg, const char *self)
{
    char path[SOCKET_PATH], machine[PATH_MAX], log_path[SOCKET_PATH + 8];
    int fd, lock;
    if (!realpath(cfg->path, machine))
        return failed(xstrdup("the machine file has gone"), CLI_EXIT_INPUT);
    char *error = socket_path(a->socket, true, path);
    error = error ? error : socket_listen(path, &fd, &lock);
    if (error)
        return failed(error, 1);
    snprintf(log_path, sizeof log_path, "%s.log", path);
    const char *log_name = a->log ? a->log : a->background ? log_path : NULL;
    FILE *log = log_name ? fopen(log_name, "ae") : stderr;
    if (!log) {
        error = xasprintf("%s cannot be written: %m", log_name);
        socket_remove(path);
        return failed(error, 1);
    }
    if (a->background)
        leave(log, lock);
    else
        socket_owner(lock);
    service_run(&(struct service_options){cfg, machine, self, fd, log});
    if (log_name && !a->log)
        unlink(log_path);
    socket_remove(path);
    close(lock);
    if (log != stderr)
        fclose(log);
    return 0;
}

int cli_srm(int argc, char **argv)
{
    static const struct argp_child CHILDREN[] = {{&CLI_MACHINE, 0, NULL, 0}, {0}};
    static const struct argp ARGP = {OPTIONS, parse, NULL, DOC, CHILDREN, NULL, NULL};
    struct arguments a = {.machine = CFG_USUAL_HOST_MACHINE};
    struct cli_installation places;
    char *error;
    cli_parse(&ARGP, "touchstone srm", 0, argc, argv, &a);
    if (!cli_find_installation(&places, "srm"))
        return CLI_EXIT_INPUT;
    if (a.links)
        return make_links(a.links, places.runner);
    struct cfg_machine *cfg = cfg_load(a.machine, places.machines, &error);
    if (!cfg)
        return failed(error, CLI_EXIT_INPUT);
    int status = serve(&a, cfg, places.runner);
    cfg_free(cfg);
    return status;
}
