/* mpi_long32.c - see mpi_long32.h. Only libnx_long32.a has this
 * file, and long32_formats.c and long32_calls.c. */
#include "nx_api/mpi/mpi_long32.h"
#include <dlfcn.h>
#include <malloc.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <time.h>
#include "nx_api/mpi/mpi_node.h"

int mpi_long_bytes = 4;
/* Files compiled with --long32 refer to it (nxcc/language/long32.cc), so that they are linked with it. */
__attribute__((visibility("default"))) const char compiled_with_long32_so_link_with_long32;

FILE *nx_output(void)
{
    return stdout;
}

FILE *nx_input(void)
{
    return stdin;
}

/* The host's function of a name that this program defines, too. */
static void *next(const char *name)
{
    void *f = dlsym(RTLD_NEXT, name);
    if (!f)
        abort();
    return f;
}

int nx_scan_file(FILE *f, const char *format, va_list ap)
{
    int (*scan)(FILE *, const char *, va_list) = next("__isoc99_vfscanf");
    return scan(f, format, ap);
}

int nx_scan_text(const char *s, const char *format, va_list ap)
{
    int (*scan)(const char *, const char *, va_list) = next("__isoc99_vsscanf");
    return scan(s, format, ap);
}

/* Such a program's time_t has 32 bits. */
int node_long32_time(int *t) NX_EXPORT("time");
int node_long32_time(int *t)
{
    struct timespec now;
    clock_gettime(CLOCK_REALTIME, &now);
    if (t)
        *t = (int)now.tv_sec;
    return (int)now.tv_sec;
}

/* --- addresses that programs keep in ints ---
 *
 * nxcc links such a program with -no-pie, so that its code, its static data and, behind them, the heap lie
 * below 2 GB. malloc is to take nothing from elsewhere. The program has a stack just below 2 GB. */

enum { STACK_END = 0x7fff0000, STACK_MOST = 256 << 20 };

/* The lowest byte of a stack that ends at STACK_END; NULL: this computer has something else there. */
static char *low_stack(void)
{
    struct rlimit usual;
    size_t bytes = STACK_MOST;
    if (getrlimit(RLIMIT_STACK, &usual) == 0 && usual.rlim_cur < bytes)
        bytes = usual.rlim_cur & ~(size_t)4095;
    void *stack = mmap((void *)(uintptr_t)(STACK_END - bytes), bytes, PROT_READ | PROT_WRITE,
                       MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_FIXED_NOREPLACE, -1, 0);
    return stack == MAP_FAILED ? NULL : stack;
}

int mpi_call_on_stack(int argc, char **argv, char **envp, main_function *program, uintptr_t end);
/* The frame pointer leads from one stack to the other, for backtraces. */
__asm__(".text\n"
        ".hidden mpi_call_on_stack\n.globl mpi_call_on_stack\n.type mpi_call_on_stack, @function\n"
        "mpi_call_on_stack:\n"
        "    .cfi_startproc\n"
        "    pushq %rbp\n"
        "    .cfi_def_cfa_offset 16\n"
        "    .cfi_offset %rbp, -16\n"
        "    movq %rsp, %rbp\n"
        "    .cfi_def_cfa_register %rbp\n"
        "    movq %r8, %rsp\n"
        "    call *%rcx\n"
        "    leave\n"
        "    .cfi_def_cfa %rsp, 8\n"
        "    ret\n"
        "    .cfi_endproc\n"
        ".size mpi_call_on_stack, .-mpi_call_on_stack\n");

int mpi_call_main(main_function *program, int argc, char **argv, char **envp)
{
    mallopt(M_MMAP_MAX, 0);
    return low_stack() ? mpi_call_on_stack(argc, argv, envp, program, STACK_END) : program(argc, argv, envp);
}
