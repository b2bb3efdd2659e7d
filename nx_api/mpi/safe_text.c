/* safe_text.c - see safe_text.h. */
#include "nx_api/mpi/safe_text.h"
#include <sys/syscall.h>
#include <unistd.h>

void safe_append(struct safe_text *t, const char *s)
{
    while (*s && t->count < sizeof t->bytes)
        t->bytes[t->count++] = *s++;
}

void safe_append_number(struct safe_text *t, long number)
{
    char digits[24], *p = digits + sizeof digits - 1;
    unsigned long rest = number < 0 ? -(unsigned long)number : (unsigned long)number;
    *p = '\0';
    do
        *--p = (char)('0' + rest % 10);
    while ((rest /= 10) > 0);
    if (number < 0)
        *--p = '-';
    safe_append(t, p);
}

void safe_write(struct safe_text *t)
{
    syscall(SYS_write, STDERR_FILENO, t->bytes, t->count);
    t->count = 0;
}
