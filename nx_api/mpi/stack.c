/* stack.c - see stack.h. */
#include "nx_api/mpi/stack.h"
#include <execinfo.h>
#include <link.h>
#include <string.h>
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

bool stack_in_poll(uintptr_t address)
{
    return address >= (uintptr_t)nxc_enter && address < (uintptr_t)nxc_enter_end;
}

/* lea 128(%rsp), %rsp; jmp back (nxcc/counting/poll.cc) */
uintptr_t stack_poll_place(uintptr_t behind)
{
    static const uint8_t lea[] = {0x48, 0x8d, 0xa4, 0x24, 0x80, 0, 0, 0};
    enum { JUMP = 0xe9, SHORT_JUMP = 0xeb };
    const uint8_t *code = (const uint8_t *)behind;
    int32_t distance;
    if (memcmp(code, lea, sizeof lea) != 0)
        return behind;
    code += sizeof lea;
    memcpy(&distance, code + 1, sizeof distance);
    return *code == JUMP         ? (uintptr_t)code + 5 + (uintptr_t)(intptr_t)distance
           : *code == SHORT_JUMP ? (uintptr_t)code + 2 + (uintptr_t)(intptr_t)(int8_t)code[1]
                                 : behind;
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
        if (at && polled)
            at = stack_in_file(stack_poll_place(address));
        if (at)
            returns[count++] = at;
        if (at && polled)
            break;
        polled = stack_in_poll(address);
    }
    return count;
}
