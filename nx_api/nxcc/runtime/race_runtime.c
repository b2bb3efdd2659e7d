/* race_runtime.c - what nxcc --races adds to a program: the byte that turns the telling on, and the routines
 * to which an access goes then (race_code.h). Linked only into programs with a file that was compiled with
 * --races; compiled by plain gcc.
 */
#include "race_runtime.h"
#include "enter.h"
#include "../../contract/program_image.h"
#include "../../contract/races.h"
#include <string.h>

/* In the initialised data, as the counter. */
#define NXC_DATA __attribute__((visibility("hidden"), section(".data")))
NXC_DATA uint8_t nxc_races_on;
/* The registers %rax and %rcx of the code that accesses: its stack pointer must not move before it has
 * computed the address. */
NXC_DATA uint64_t nxc_race_saved[2];

/* The linker's symbols for the ends of section nxc_races. */
extern const struct nxc_race_site __start_nxc_races[] __attribute__((visibility("hidden"), weak));
extern const struct nxc_race_site __stop_nxc_races[] __attribute__((visibility("hidden"), weak));

/* Of asan_runtime.c, which is linked only if a file was compiled with --asan. */
extern const struct nxc_asan nxc_asan __attribute__((visibility("hidden"), weak));

__attribute__((visibility("hidden"))) const struct nxc_races nxc_races = {
    .on = &nxc_races_on,
    .sites_begin = __start_nxc_races,
    .sites_end = __stop_nxc_races,
    .asan = &nxc_asan,
};

static size_t string_bytes(const char *string, size_t most)
{
    size_t length = strnlen(string, most);
    return length < most ? length + 1 : most;
}

/* Called by nxc_race_tell_range. */
__attribute__((visibility("hidden"), used)) void nxc_race_tell_bytes(const void *address, int64_t bytes,
                                                                     const struct nxc_race_site *site);
void nxc_race_tell_bytes(const void *address, int64_t bytes, const struct nxc_race_site *site)
{
    if (bytes == NXC_RACE_ARRAY) {
        nx_race_array(address, site);
        return;
    }
    if (bytes == NXC_RACE_JUMPED) {
        nxc_race_range(NULL, 0, NULL);
        return;
    }
    if (bytes == NXC_RACE_STRING)
        bytes = (int64_t)strlen(address) + 1;
    else if (bytes & NXC_RACE_PART)
        bytes = (int64_t)string_bytes(address, (size_t)(bytes & ~NXC_RACE_PART));
    if (bytes > 0)
        nxc_race_range(address, (size_t)bytes, site);
}

/* The routines save all registers but those of the x87, and the stack may have any alignment. */
#define CALL(c_function)                                                                                     \
    "    subq $264, %rsp\n"                                                                                  \
    "    andq $-16, %rsp\n" NXC_SAVE_SSE "    call " c_function "\n" NXC_RESTORE_SSE

/* nxc_race_tell: the address is in %rax, the site in %rcx, and their own values in nxc_race_saved. */
__asm__(".text\n"
        ".hidden nxc_race_tell\n" NXC_BEGIN_ROUTINE(
            "nxc_race_tell") "    pushq nxc_race_saved(%rip)\n"
                             "    pushq nxc_race_saved+8(%rip)\n" NXC_PUSH_REGISTERS "    movq %rax, %rdi\n"
                             "    movq %rcx, %rsi\n" CALL("nxc_race_access@PLT")
                                 NXC_END_ROUTINE("nxc_race_tell"));

/* nxc_race_tell_range: the address, the bytes and another word have been pushed; the site is in %rcx. */
__asm__(".text\n"
        ".hidden nxc_race_tell_range\n" NXC_BEGIN_SAVING(
            "nxc_race_tell_range") "    movq 32(%rbp), %rdi\n"
                                   "    movq 24(%rbp), %rsi\n"
                                   "    movq %rcx, %rdx\n" CALL("nxc_race_tell_bytes")
                                       NXC_END_ROUTINE("nxc_race_tell_range"));
