/* call_filter.c - see call_filter.h. */
#include "machine/call_filter.h"
#include <errno.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>
#include "guest/span.h"

#define LOAD(member) BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, member))
/* if the loaded word COMPARES to the value: skip so many instructions, else so many */
#define SKIP_IF(compares, value, then, otherwise) BPF_JUMP(BPF_JMP | compares | BPF_K, value, then, otherwise)
#define ANSWER(action) BPF_STMT(BPF_RET | BPF_K, action)

enum { OTHER_INTERFACE = 0x40000000 }; /* x32's calls have this bit */

/* Of the page of vsyscalls, which the kernel has at the same address in every process: a call there would
 * tell the time of this computer. The kernel asks the filter as for a system call. */
#define VSYSCALLS UINT32_C(0xffffffff)

/* The upper half of an address; ranges of programs begin and end with whole halves. */
static uint32_t upper(uint64_t address)
{
    return (uint32_t)(address >> 32);
}

bool call_filter_install(void)
{
    const struct span_range *usual = &SPAN_RANGES[SPAN_USUAL], *low = &SPAN_RANGES[SPAN_LOW];
    uintptr_t library = (uintptr_t)prctl;
    if (library >= usual->from && library < usual->to) { /* the kernel's legacy layout, as by setarch -L */
        errno = EADDRINUSE;
        return false;
    }
    bool simulator_is_low = (uintptr_t)call_filter_install < low->to; /* not a position-independent program */
    struct sock_filter program[] = {
        LOAD(arch),
        SKIP_IF(BPF_JEQ, AUDIT_ARCH_X86_64, 0, 10),
        LOAD(nr),
        SKIP_IF(BPF_JEQ, __NR_execve, 8, 0),
        SKIP_IF(BPF_JEQ, __NR_execveat, 7, 0),
        SKIP_IF(BPF_JGE, OTHER_INTERFACE, 6, 0),
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, instruction_pointer) + 4),
        SKIP_IF(BPF_JGE, upper(usual->from), 0, 1),
        SKIP_IF(BPF_JGE, upper(usual->to), 0, 3),
        SKIP_IF(BPF_JGE, VSYSCALLS, 2, 0),
        SKIP_IF(BPF_JGE, simulator_is_low ? 0 : upper(low->to), 0, 1),
        ANSWER(SECCOMP_RET_ALLOW),
        ANSWER(SECCOMP_RET_TRAP),
    };
    struct sock_fprog filter = {sizeof program / sizeof *program, program};
    return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_SPEC_ALLOW, &filter) == 0;
}
