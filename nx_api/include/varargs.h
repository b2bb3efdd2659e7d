/* varargs.h - functions of any number of arguments, as C had them before 1989:
 *
 *     say(va_alist)
 *         va_dcl
 *     {
 *         va_list ap;
 *         va_start(ap);
 *         ... va_arg(ap, int) ...
 *         va_end(ap);
 *     }
 *
 * Works with GCC on x86-64 in a function that has va_alist as its only argument, which is how it was used. Of
 * __builtin_apply_args GCC's manual promises only that __builtin_apply understands it; what is read here is
 * the block that GCC makes on x86-64: where the arguments on the stack begin, then the registers in GCC's
 * order.
 */
#ifndef NX_VARARGS_H
#define NX_VARARGS_H
#ifndef __x86_64__
#error "varargs.h: for x86-64 only: use stdarg.h"
#endif
#include <stdarg.h>
#undef va_start
#define va_alist nx_va_first
#define va_dcl int nx_va_first;

/* What va_list is on x86-64, by its ABI. */
struct nx_va_list {
    unsigned int integers, floats; /* offsets of the next in saved */
    void *on_stack, *saved;
};
enum { NX_VA_INTEGERS = 6, NX_VA_SAVED = 48 + 8 * 16 };

/* block: of __builtin_apply_args; saved: room for NX_VA_SAVED bytes. */
static __inline__ void nx_va_begin(void *list, void *block, void *saved)
{
    struct nx_va_list *l = (struct nx_va_list *)list;
    long long *words = (long long *)block, *to = (long long *)saved;
    static const int at[NX_VA_INTEGERS] = {5, 4, 2, 3, 22, 23}; /* rdi, rsi, rdx, rcx, r8, r9 */
    int i;
    for (i = 0; i < NX_VA_INTEGERS; i++)
        to[i] = words[at[i]];
    __builtin_memcpy(to + NX_VA_INTEGERS, words + 6, 8 * 16); /* xmm0 to xmm7 */
    l->integers = 0;
    l->floats = 48;
    l->on_stack = (void *)(__SIZE_TYPE__)words[0];
    l->saved = saved;
}
#define va_start(list) nx_va_begin((list), __builtin_apply_args(), __builtin_alloca(NX_VA_SAVED))
#endif
