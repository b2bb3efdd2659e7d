/* addr2line.c - see addr2line.h. */
#include "nx_api/mpi/addr2line.h"
#include <fcntl.h>
#include <limits.h>
#include <stdbool.h>
#include <string.h>
#include <sys/syscall.h>
#include <unistd.h>

static bool name_program(char program[PATH_MAX])
{
    ssize_t n = readlink("/proc/self/exe", program, PATH_MAX - 1);
    program[n > 0 ? n : 0] = '\0';
    return n > 0;
}

static _Noreturn void become(const char **argv, int out)
{
    int nowhere = openat(AT_FDCWD, "/dev/null", O_WRONLY);
    dup2(out, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    execvp(argv[0], (char *const *)(uintptr_t)argv);
    syscall(SYS_exit_group, 1);
    __builtin_unreachable();
}

int addr2line_start(const char **argv, pid_t *child)
{
    static char program[PATH_MAX];
    int ends[2];
    if (!name_program(program) || pipe2(ends, O_CLOEXEC) != 0)
        return -1;
    argv[0] = "addr2line", argv[1] = "-f", argv[2] = "-e", argv[3] = program;
    *child = _Fork();
    if (*child == 0)
        become(argv, ends[1]);
    syscall(SYS_close, ends[1]);
    if (*child > 0)
        return ends[0];
    syscall(SYS_close, ends[0]);
    return -1;
}

void addr2line_digits(char digits[ADDR2LINE_DIGITS], uint64_t address)
{
    char *p = digits + ADDR2LINE_DIGITS - 1;
    *p = '\0';
    do
        *--p = "0123456789abcdef"[address % 16];
    while ((address /= 16) > 0);
    memmove(digits, p, strlen(p) + 1);
}

/* "/home/x/ring.c:17 (discriminator 2)" -> "ring.c:17" */
char *addr2line_place(char *line)
{
    line[strcspn(line, " \n")] = '\0';
    char *slash = strrchr(line, '/'), *name = slash ? slash + 1 : line, *colon = strrchr(name, ':');
    bool known = colon && name[0] != '?' && colon[1] >= '1' && colon[1] <= '9';
    return known ? name : NULL;
}

/* "ring.f90:17", "ring.F:17" */
static bool is_fortran(const char *place)
{
    const char *dot = place ? strrchr(place, '.') : NULL;
    return dot && (dot[1] == 'f' || dot[1] == 'F');
}

/* Without what compilers append to the names of a function's parts and copies (work.part.0), and as Fortran's
 * source has it: step, of step_ and __heat_MOD_step. */
char *addr2line_function(char *line, const char *place)
{
    line[strcspn(line, ".\n")] = '\0';
    if (!*line || strcmp(line, "??") == 0)
        return NULL;
    if (!is_fortran(place) || strcmp(line, "MAIN__") == 0)
        return line;
    char *module = strstr(line, "_MOD_"), *name = module ? module + 5 : line;
    for (char *end = name + strlen(name); !module && end > name && end[-1] == '_';)
        *--end = '\0';
    return name;
}
