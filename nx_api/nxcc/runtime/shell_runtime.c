/* shell_runtime.c - the start of a node program by a shell: `touchstone`, if it is in PATH, runs it on one
 * simulated node, or with the options that TOUCHSTONE_RUN has. So `configure` and makefiles may run what they
 * have just made. Under mpirun, of which each process would be a machine of its own, and without
 * `touchstone`, it says how it is run.
 *
 * Nothing has been relocated, and there is no C library: the code uses only what it addresses relative to the
 * instruction pointer, and calls the host's kernel.
 */
#include <asm/unistd.h>
#include <linux/limits.h>
#include <stdbool.h>
/* The code is small, and has no call of strlen instead of a loop. */
#pragma GCC optimize("Os", "no-tree-loop-distribute-patterns")

enum { STDERR = 2, EXECUTABLE = 1 /* X_OK */, NOT_RUN = 126 /* a shell's status for what cannot be run */ };

static long host(long number, const void *a, const void *b, const void *c)
{
    long result;
    __asm__ volatile("syscall" : "=a"(result) : "0"(number), "D"(a), "S"(b), "d"(c) : "rcx", "r11", "memory");
    return result;
}

static void say(const char *text)
{
    long length = 0;
    while (text[length])
        length++;
    host(__NR_write, (void *)STDERR, text, (void *)length);
}

/* The value of `text`, if it begins with name; NULL: it does not. */
static const char *value(const char *text, const char *name)
{
    while (*name && *name == *text)
        name++, text++;
    return *name ? 0 : text;
}

static const char *variable(char **environment, const char *name)
{
    const char *found = 0;
    for (; *environment && !found; environment++)
        found = value(*environment, name);
    return found;
}

static bool by_mpirun(char **environment)
{
    return variable(environment, "OMPI_COMM_WORLD_SIZE=") || variable(environment, "PMI_SIZE=") ||
           variable(environment, "PMIX_RANK=");
}

/* The next folder of PATH, from *rest on, with /touchstone behind it. False: there is none. */
static bool next_simulator(const char **rest, char path[PATH_MAX])
{
    const char *name = "/touchstone";
    int n = 0;
    if (!**rest)
        return false;
    while (**rest && **rest != ':' && n < PATH_MAX - 16)
        path[n++] = *(*rest)++;
    while (**rest && *(*rest)++ != ':')
        ;
    while (*name)
        path[n++] = *name++;
    path[n] = 0;
    return true;
}

static bool has_slash(const char *name)
{
    while (*name && *name != '/')
        name++;
    return *name;
}

/* Appends the words of text, which it copies to room, to command[n]. The new n. */
static long append_words(const char *command[], long n, const char *text, char *room)
{
    while (*text) {
        while (*text == ' ')
            text++;
        if (*text)
            command[n++] = room;
        while (*text && *text != ' ')
            *room++ = *text++;
        *room++ = 0;
    }
    return n;
}

/* Returns only if it could not. */
static void simulate(const char *simulator, long count, char **arguments, char **environment)
{
    const char *options = variable(environment, "TOUCHSTONE_RUN="), *end = options;
    while (end && *end)
        end++;
    const char *command[count + (end - options) + 8], *program = arguments[0];
    char itself[PATH_MAX], room[end - options + 2];
    long n = 0;
    command[n++] = simulator, command[n++] = "run";
    if (options)
        n = append_words(command, n, options, room);
    else {
        say("a program for simulated nodes: it runs on one now; on more by touchstone run -n N PROGRAM\n");
        command[n++] = "-q", command[n++] = "-n", command[n++] = "1";
    }
    if (!program || !has_slash(program)) { /* a shell has found it in PATH */
        long length = host(__NR_readlink, "/proc/self/exe", itself, (void *)(PATH_MAX - 1));
        if (length < 0)
            return;
        itself[length] = 0;
        program = itself;
    }
    command[n++] = program;
    for (long i = 1; i < count; i++)
        command[n++] = arguments[i];
    command[n] = 0;
    host(__NR_execve, simulator, command, environment);
}

/* Of what the kernel has put on the stack: the number of arguments, these, and the environment behind. */
__attribute__((visibility("hidden"), noreturn)) void nxc_from_shell(long *stack);
void nxc_from_shell(long *stack)
{
    char path[PATH_MAX], **arguments = (char **)(stack + 1), **environment = arguments + *stack + 1;
    const char *rest = variable(environment, "PATH=");
    if (rest && !by_mpirun(environment))
        while (next_simulator(&rest, path))
            if (host(__NR_access, path, (void *)EXECUTABLE, 0) == 0)
                simulate(path, *stack, arguments, environment);
    say("a program for simulated nodes: run it with touchstone run PROGRAM, not from a shell or by mpirun\n");
    for (;;)
        host(__NR_exit_group, (void *)NOT_RUN, 0, 0);
}
