/* stack.c - see stack.h. */
#include "nx_api/mpi/stack.h"
#include <execinfo.h>
#include <link.h>
#include "nx_api/mpi/tick.h"

/* The linker's: the bounds of the program's code. */
extern const char __executable_start[], etext[];

/* The first object is the executable. */
static int note_bias(struct dl_phdr_info *info, size_t size, void *bias)
{
    (void)size;
    *(uintptr_t *)bias = info->dlpi_addr;
    return 1;
}

uint64_t stack_in_file(uintptr_t address)
{
    uintptr_t bias = 0;
    if (address < (uintptr_t)__executable_start || address >= (uintptr_t)etext)
        return 0;
    dl_iterate_phdr(note_bias, &bias);
    return address - bias;
}

static bool in_poll(uintptr_t address)
{
    return address >= (uintptr_t)nxc_enter && address < (uintptr_t)nxc_enter_end;
}

/* A poll moves the stack pointer, which the program's tables for unwinding do not know: behind the place
 * of a poll the frames cannot be found. */
size_t stack_walk(uint64_t *returns, size_t most)
{
    enum { MOST = 200 };
    void *all[MOST];
    size_t count = 0;
    int depth = backtrace(all, MOST);
    bool polled = false;
    for (int i = 0; i < depth && count < most; i++) {
        uintptr_t address = (uintptr_t)all[i];
        uint64_t at = stack_in_library(address) ? 0 : stack_in_file(address);
        if (at)
            returns[count++] = at;
        if (at && polled)
            break;
        polled = in_poll(address);
    }
    return count;
}
