/* gdb_start.c - see gdb_start.h. */
#include "cli/gdb_start.h"
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>
#include "cli/options.h"
#include "cli/other_binary.h"
#include "cli/say.h"
#include "kernel/xalloc.h"

/* touchstone_stops(resume, function, in_call) has its arguments in rdi, rsi and rdx: debug_stop.h says what
 * they mean. */
static const char SCRIPT[] = "set print thread-events off\n"
                             "set breakpoint pending on\n"
                             "handle SIGUSR1 nostop noprint pass\n"
                             "tbreak *touchstone_stops\n"
                             "commands\n"
                             "silent\n"
                             "end\n"
                             "run\n"
                             "if $_thread\n"
                             "  if $pc == (long)&touchstone_stops && $rdi\n"
                             "    if $rdx\n"
                             "      echo (continue stops after the call.)\\n\n"
                             "      tbreak *$rdi\n"
                             "      if *(char *)$rsi\n"
                             "        eval \"frame function %s\", (char *)$rsi\n"
                             "      end\n"
                             "    else\n"
                             "      tbreak *$rdi\n"
                             "      continue\n"
                             "    end\n"
                             "  end\n"
                             "end\n";

/* The name of a file that has the script as long as this process lives. False: errno says why. */
static bool make_script(char *name, size_t size)
{
    int fd = memfd_create("touchstone.gdb", 0);
    if (fd < 0 || write(fd, SCRIPT, sizeof SCRIPT - 1) != sizeof SCRIPT - 1)
        return false;
    snprintf(name, size, "/proc/self/fd/%d", fd); /* gdb inherits it */
    return true;
}

static int failed(const char *what, const char *advice)
{
    cli_say_error("run", "--gdb: %s: %s%s", what, strerror(errno), advice);
    return CLI_EXIT_INPUT;
}

int cli_start_gdb(char **argv)
{
    char script[64], self[PATH_MAX];
    if (!cli_own_path(self, sizeof self))
        return CLI_EXIT_INPUT;
    if (!make_script(script, sizeof script))
        return failed("no file for gdb's commands", "");
    const char *gdb[] = {"gdb", "-q", "-x", script, "--args", self};
    enum { GDB = sizeof gdb / sizeof *gdb };
    size_t count = 0;
    while (argv[count])
        count++;
    char **all = xcalloc(GDB + count, sizeof *all);
    memcpy(all, gdb, sizeof gdb);
    memcpy(all + GDB, argv + 1, count * sizeof *all); /* with the NULL */
    execvp(all[0], all);
    return failed("gdb cannot be started",
                  errno == ENOENT ? ": install it, in Debian as root: apt install gdb" : "");
}
