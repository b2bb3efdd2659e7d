/* stack.h - the stack of a program: addresses of its code, without those of libnx.a.
 *
 * The code of libnx.a is in a section of its own, nx_text (mpi.mk), and keeps frame pointers. So the
 * first return address outside of that section can be found from any of its functions in a few steps,
 * whatever the program was compiled with. */
#ifndef MPI_STACK_H
#define MPI_STACK_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The linker's. */
extern const char __start_nx_text[] __attribute__((visibility("hidden")));
extern const char __stop_nx_text[] __attribute__((visibility("hidden")));

static inline bool stack_in_library(uintptr_t address)
{
    return address - (uintptr_t)__start_nx_text < (uintptr_t)(__stop_nx_text - __start_nx_text);
}

/* The address behind the program's call of the library, found from a frame of the library. */
static inline uintptr_t stack_caller(const void *frame)
{
    const uintptr_t *f = frame;
    while (stack_in_library(f[1]))
        f = (const uintptr_t *)f[0];
    return f[1];
}

/* Writes the return addresses of the program's calls under way, the innermost first, at most `most`;
 * returns how many. main's is the last; those of libnx.a and of shared libraries are left out. */
size_t stack_walk(uint64_t *returns, size_t most);
/* Is an address in what polls call? Then the next frame is that of a poll, whose code is out of line: its
 * place in the program is another than the return address says. */
bool stack_in_poll(uintptr_t address);
uintptr_t stack_poll_place(uintptr_t behind);
/* An address as the executable file has it, the same in all processes; 0 for one outside of the program. */
uint64_t stack_in_file(uintptr_t address);
#endif
