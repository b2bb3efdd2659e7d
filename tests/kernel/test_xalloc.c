/* Memory of the host: what is asked for is there; without memory the process ends with a message and status
 * 1. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cmocka.h>
#include "kernel/hostclock.h"
#include "kernel/xalloc.h"

static void a_block_of_0_bytes_is_a_block(void **state)
{
    (void)state;
    void *block = xrealloc(xmalloc(0), 0); /* realloc() alone would return NULL here */
    assert_non_null(block);
    free(block);
}

static void text_is_copied_and_formatted(void **state)
{
    (void)state;
    char *copy = xstrdup("crecv"), *part = xstrndup("csend", 2), *text = xasprintf("%s %d", "node", 7);
    assert_string_equal(copy, "crecv");
    assert_string_equal(part, "cs");
    assert_string_equal(text, "node 7");
    free(copy), free(part), free(text);
}

static void too_large(void)
{
    free(xreallocarray(NULL, SIZE_MAX / 4, 8));
}

static void nothing_made(void)
{
    xchecked(NULL);
}

/* Runs f in a child; reads what f says. Returns the child's exit status, -1 if a signal ended it. */
static int status_of(void (*f)(void), char *said, size_t room)
{
    int ends[2], status;
    assert_int_equal(pipe(ends), 0);
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        dup2(ends[1], STDERR_FILENO);
        f();
        _exit(0);
    }
    close(ends[1]);
    ssize_t length = read(ends[0], said, room - 1);
    said[length > 0 ? length : 0] = 0;
    close(ends[0]);
    assert_int_equal(waitpid(child, &status, 0), child);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

static void without_memory_the_process_says_so_and_ends(void **state)
{
    (void)state;
    char said[200];
    assert_int_equal(status_of(too_large, said, sizeof said), 1);
    assert_non_null(strstr(said, "the host's memory is exhausted"));
    assert_int_equal(status_of(nothing_made, said, sizeof said), 1);
    assert_non_null(strstr(said, "the host's memory is exhausted"));
}

static void the_host_s_clock_counts_seconds(void **state)
{
    (void)state;
    double begin = hostclock_s();
    usleep(20000);
    double passed = hostclock_s() - begin;
    assert_true(passed >= 0.02 && passed < 20);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_block_of_0_bytes_is_a_block),
        cmocka_unit_test(text_is_copied_and_formatted),
        cmocka_unit_test(without_memory_the_process_says_so_and_ends),
        cmocka_unit_test(the_host_s_clock_counts_seconds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
