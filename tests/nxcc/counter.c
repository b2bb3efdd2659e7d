/* counter.c - see counter.h. A preemption changes every register that a call may change, to prove that
 * programs rely on none. */
#include "counter.h"
#include <string.h>

struct counter counter;

static void spoil_registers(void)
{
    __asm__ volatile(
        "movq $-1, %%rax\n\tmovq %%rax, %%rcx\n\tmovq %%rax, %%rdx\n\tmovq %%rax, %%rsi\n\t"
        "movq %%rax, %%rdi\n\tmovq %%rax, %%r8\n\tmovq %%rax, %%r9\n\tmovq %%rax, %%r10\n\t"
        "movq %%rax, %%r11\n\tmovq %%rax, %%xmm0\n\tmovq %%rax, %%xmm1\n\tmovq %%rax, %%xmm2\n\t"
        "movq %%rax, %%xmm3\n\tmovq %%rax, %%xmm4\n\tmovq %%rax, %%xmm5\n\tmovq %%rax, %%xmm6\n\t"
        "movq %%rax, %%xmm7\n\tmovq %%rax, %%xmm8\n\tmovq %%rax, %%xmm9\n\tmovq %%rax, %%xmm10\n\t"
        "movq %%rax, %%xmm11\n\tmovq %%rax, %%xmm12\n\tmovq %%rax, %%xmm13\n\tmovq %%rax, %%xmm14\n\t"
        "movq %%rax, %%xmm15" ::
            : "rax", "rcx", "rdx", "rsi", "rdi", "r8", "r9", "r10", "r11", "xmm0", "xmm1", "xmm2", "xmm3",
              "xmm4", "xmm5", "xmm6", "xmm7", "xmm8", "xmm9", "xmm10", "xmm11", "xmm12", "xmm13", "xmm14",
              "xmm15", "cc");
}

void nxc_preempt(void)
{
    int64_t left = *nxc_image.left;
    counter.spent += counter.budget - left;
    if (*nxc_image.lookahead < left && counter.spent + left - *nxc_image.lookahead > counter.lookahead)
        counter.lookahead = counter.spent + left - *nxc_image.lookahead;
    counter.overshoot = -left > counter.overshoot ? -left : counter.overshoot;
    counter.preemptions++;
    counter.times = (counter.times ^ (uint64_t)counter.spent) * 1099511628211u; /* FNV-1 */
    *nxc_image.left = counter.budget;
    *nxc_image.lookahead = NXC_NO_LOOKAHEAD;
    if (counter.handler)
        counter.handler();
    spoil_registers();
}

void counter_start(int64_t budget)
{
    counter = (struct counter){.budget = budget};
    *nxc_image.left = budget;
    *nxc_image.lookahead = NXC_NO_LOOKAHEAD;
    for (struct nxc_cell *c = nxc_image.cells_begin; c < nxc_image.cells_end; c++)
        c->units = 0;
}

int64_t counter_spent(void)
{
    return counter.spent + counter.budget - *nxc_image.left;
}

void served(void)
{
    counter.broken += counter_spent() < counter.lookahead;
}

int64_t counter_profiled(void)
{
    int64_t sum = 0;
    for (const struct nxc_cell *c = nxc_image.cells_begin; c < nxc_image.cells_end; c++)
        sum += c->body ? 0 : c->units;
    return sum;
}

static int names(const struct nxc_cell *c, const char *function, const char *called)
{
    return !strcmp(c->function, function) && !strcmp(c->called ? c->called : "", called ? called : "");
}

int64_t counter_of(const char *function, const char *called)
{
    int64_t sum = 0;
    for (const struct nxc_cell *c = nxc_image.cells_begin; c < nxc_image.cells_end; c++) {
        sum += names(c, function, called) ? c->units : 0;
        sum -= c->body && names(c->body, function, called) ? c->units : 0;
    }
    return sum;
}
