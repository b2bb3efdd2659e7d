/* execinfo.c - GNU's names of calls under way, as PROGRAM(FUNCTION+OFFSET) [ADDRESS], in one block of memory
 * or in a file. backtrace itself is the system's. */
#define _GNU_SOURCE
#include <errno.h>
#include <execinfo.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

int nx_function_at(const void *address, char *to, int size); /* sim/guest/libc/libc_calls.c */

enum { LONGEST = 1000 };

/* Returns the text's length without the final 0. */
static size_t tell(const void *address, char text[LONGEST])
{
    char function[LONGEST / 2];
    int bytes = nx_function_at(address, function, sizeof function)
                    ? snprintf(text, LONGEST, "%s(%s) [%p]", program_invocation_name, function, address)
                    : snprintf(text, LONGEST, "[%p]", address);
    return bytes < LONGEST ? (size_t)bytes : LONGEST - 1;
}

char **backtrace_symbols(void *const *addresses, int count)
{
    char text[LONGEST];
    size_t bytes = (size_t)count * sizeof(char *);
    for (int i = 0; i < count; i++)
        bytes += tell(addresses[i], text) + 1;
    char **names = malloc(bytes);
    char *to = (char *)(names + count);
    for (int i = 0; names && i < count; i++) {
        names[i] = to;
        to = (char *)memcpy(to, text, tell(addresses[i], text) + 1) + strlen(to) + 1;
    }
    return names;
}

void backtrace_symbols_fd(void *const *addresses, int count, int fd)
{
    char text[LONGEST + 1];
    for (int i = 0; i < count; i++) {
        size_t bytes = tell(addresses[i], text);
        text[bytes] = '\n';
        if (write(fd, text, bytes + 1) < 0)
            return;
    }
}
