/* libc_calls.c - what a program learns of its calls under way: backtrace, and the names of functions. */
#include <stdint.h>
#include <stdio.h>
#include "guest/backtrace.h"
#include "guest/image.h"
#include "kernel/crossing.h"
#include "node/self.h"

int node_backtrace(void **returns, int most)
{
    return backtrace_program_calls(node_self(), (uintptr_t)crossing_frame(), returns, most);
}

/* What node code (nx_api/libc/execinfo.c) asks for: writes the function around an address and the way from
 * its begin, "pack+0x1c", or the way from the program's, "+0x1c" (most bytes with the final 0 are size), and
 * answers 1; 0 if the address is none of the program's. */
int node_nx_function_at(const void *address, char *to, int size)
{
    const struct node *n = node_self();
    if (!backtrace_in_program(n, (uintptr_t)address))
        return 0;
    size_t offset = (uintptr_t)address - (uintptr_t)n->guest.program;
    const char *name = node_image_function_name(n->guest.file, offset);
    size_t begin = name ? node_image_function(n->guest.file, offset) : 0;
    snprintf(to, (size_t)size, "%s+0x%zx", name ? name : "", offset - begin);
    return 1;
}
