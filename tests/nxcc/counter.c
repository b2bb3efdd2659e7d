/* counter.c - see counter.h. A preemption changes every register that a call may change, to prove that
 * programs rely on none. */
#include "counter.h"
#include <stdlib.h>
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

/* --- the profile --- */

static struct nxc_path *made;

struct nxc_path *nxc_new_path(int64_t counts)
{
    struct nxc_path *p = calloc(1, sizeof *p + (size_t)counts * sizeof p->counts[0]);
    p->older = made;
    return made = p;
}

static void forget_counts(void)
{
    for (struct nxc_path *p = made; p; p = p->older)
        memset(p->counts, 0, (size_t)p->body->slots * sizeof p->counts[0]);
}

void counter_start(int64_t budget)
{
    counter = (struct counter){.budget = budget};
    *nxc_image.left = budget;
    *nxc_image.lookahead = NXC_NO_LOOKAHEAD;
    forget_counts();
}

int64_t counter_spent(void)
{
    return counter.spent + counter.budget - *nxc_image.left;
}

void served(void)
{
    counter.broken += counter_spent() < counter.lookahead;
}

static const struct nxc_cell *cells_of(const struct nxc_path *p)
{
    return (const struct nxc_cell *)((const char *)p->body + p->body->cells);
}

static int is_text(const struct nxc_path *p, int32_t text, const char *what)
{
    return !strcmp(text ? (const char *)cells_of(p) + text : "", what ? what : "");
}

/* The units of the path's cells that count. */
static int64_t sum(const struct nxc_path *p,
                   int (*counts)(const struct nxc_path *, const struct nxc_cell *, const void *),
                   const void *what)
{
    const struct nxc_weight *w = (const struct nxc_weight *)((const char *)p->body + p->body->weights);
    int64_t units = 0;
    for (int32_t i = 0; i < p->body->weight_count; i++)
        if (counts(p, &cells_of(p)[w[i].cell], what))
            units += w[i].units * p->counts[w[i].slot];
    return units;
}

static int all(const struct nxc_path *p, const struct nxc_cell *c, const void *what)
{
    (void)p, (void)c, (void)what;
    return 1;
}

int64_t counter_profiled(void)
{
    int64_t units = 0;
    for (const struct nxc_path *p = made; p; p = p->older)
        units += sum(p, all, NULL);
    return units;
}

struct name {
    const char *function, *called;
    int line;
};

static int has_name(const struct nxc_path *p, const struct nxc_cell *c, const void *what)
{
    const struct name *name = what;
    return is_text(p, cells_of(p)[c->parent].function, name->function) &&
           is_text(p, c->called, name->called) && (!name->line || c->line == name->line);
}

int64_t counter_of(const char *function, const char *called)
{
    struct name name = {function, called, 0};
    int64_t units = 0;
    for (const struct nxc_path *p = made; p; p = p->older)
        units += sum(p, has_name, &name);
    return units;
}

int64_t counter_of_line(const char *function, int line)
{
    struct name name = {function, NULL, line};
    int64_t units = 0;
    for (const struct nxc_path *p = made; p; p = p->older)
        units += sum(p, has_name, &name);
    return units;
}

/* Appends the path's functions to text, the outermost first. */
static void append(const struct nxc_path *p, char *text)
{
    if (p->parent && p->parent->body)
        append(p->parent, text), strcat(text, ";");
    strcat(text, (const char *)cells_of(p) + cells_of(p)[p->body->cell].function);
}

int64_t counter_of_path(const char *path)
{
    int64_t units = 0;
    for (const struct nxc_path *p = made; p; p = p->older) {
        char text[20000] = "";
        append(p, text);
        if (!strcmp(text, path))
            units += sum(p, all, NULL);
    }
    return units;
}

int counter_at_root(void)
{
    return *nxc_image.path == nxc_image.root;
}
