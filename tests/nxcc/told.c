/* told.c - the simulator's side of nxcc --races, for tests that link a compiled object into an ordinary
 * program: calls run(), of C or Fortran, and prints what it tells, a line for each access: VARIABLE BYTES and
 * flags. Behind them: what it returns and has spent. Its arguments:
 *
 *     off       nothing is to be told
 *     UNITS     preempted when so many units have been spent; prints the accesses' addresses, too
 *
 * Each telling changes all registers that a call may change, to prove that programs rely on none. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include "nx_api/contract/program_image.h"
#include "nx_api/contract/races.h"

extern struct nxc_image nxc_image;
int run(void) __attribute__((weak));
int run_(void) __attribute__((weak));

static int64_t budget = INT64_MAX / 2, spent;
static int with_addresses;

static void spoil_registers(void)
{
    __asm__ volatile(
        "movq $-1, %%rax\n\tmovq %%rax, %%rcx\n\tmovq %%rax, %%rdx\n\tmovq %%rax, %%rsi\n\t"
        "movq %%rax, %%rdi\n\tmovq %%rax, %%r8\n\tmovq %%rax, %%r9\n\tmovq %%rax, %%r10\n\t"
        "movq %%rax, %%r11\n\tmovq %%rax, %%xmm0\n\tmovq %%rax, %%xmm1\n\tmovq %%rax, %%xmm2\n\t"
        "movq %%rax, %%xmm3\n\tmovq %%rax, %%xmm7\n\tmovq %%rax, %%xmm8\n\tmovq %%rax, %%xmm15" ::
            : "rax", "rcx", "rdx", "rsi", "rdi", "r8", "r9", "r10", "r11", "xmm0", "xmm1", "xmm2", "xmm3",
              "xmm7", "xmm8", "xmm15", "cc");
}

void nxc_race_range(const void *address, size_t bytes, const struct nxc_race_site *site)
{
    if (!address || site < nxc_image.races->sites_begin || site >= nxc_image.races->sites_end)
        abort();
    static const char *const flags[] = {"", " volatile", " spin", " volatile spin", " ok"};
    const char *variable = nxc_race_text(site, site->variable);
    printf("%s:%d %s %s %zu %s%s", nxc_race_text(site, site->file), site->line,
           nxc_race_text(site, site->function), *variable ? variable : "?", bytes,
           site->flags & NXC_RACE_WRITE ? "write" : "read", flags[site->flags / NXC_RACE_VOLATILE]);
    if (with_addresses)
        printf(" at %" PRIuPTR, (uintptr_t)address);
    putchar('\n');
    spoil_registers();
}

void nxc_race_access(const void *address, const struct nxc_race_site *site)
{
    if (!site->bytes)
        abort();
    nxc_race_range(address, site->bytes, site);
}

void nxc_preempt(void)
{
    spent += budget - *nxc_image.left;
    *nxc_image.left = budget;
    puts("preempted");
    spoil_registers();
}

struct nxc_path *nxc_new_path(int64_t counts)
{
    return calloc(1, sizeof(struct nxc_path) + (size_t)counts * sizeof(int64_t));
}

int main(int argc, char **argv)
{
    with_addresses = argc > 1 && atoll(argv[1]) > 0;
    if (with_addresses)
        budget = atoll(argv[1]);
    *nxc_image.left = budget;
    if (nxc_image.races)
        *nxc_image.races->on = argc < 2 || with_addresses;
    int result = run ? run() : run_();
    printf("result %d units %" PRId64 "\n", result, spent + budget - *nxc_image.left);
    return 0;
}
