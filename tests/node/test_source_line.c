/* The debugging information of an ELF file says which line of source an address was compiled from. */
#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "kernel/xalloc.h"
#include "guest/source_line.h"

extern const char __executable_start[]; /* the linker's */

struct file {
    char *bytes;
    size_t size;
};

/* This test's own program. */
static struct file own_file(void)
{
    struct file f = {NULL, 0};
    FILE *in = fopen("/proc/self/exe", "rb");
    assert_non_null(in);
    for (size_t got = 1; got > 0; f.size += got) {
        f.bytes = xrealloc(f.bytes, f.size + (1 << 20));
        got = fread(f.bytes + f.size, 1, 1 << 20, in);
    }
    fclose(in);
    return f;
}

/* clang-format off */
static const int MARKED = __LINE__ + 1;
__attribute__((noinline)) static void marked(void) { __asm__ volatile("nop"); }
/* clang-format on */

static void *ask(void *arg)
{
    struct file *f = arg;
    int line = 0;
    char *path = source_line(f->bytes, f->size, (uintptr_t)marked - (uintptr_t)__executable_start, &line);
    assert_non_null(path);
    assert_string_equal(strrchr(path, '/'), "/test_source_line.c");
    assert_int_equal(line, MARKED);
    free(path);
    return NULL;
}

static void a_function_has_its_line(void **state)
{
    (void)state;
    struct file f = own_file();
    ask(&f);
    free(f.bytes);
}

static void a_small_stack_is_enough(void **state)
{
    (void)state;
    struct file f = own_file();
    pthread_attr_t small;
    pthread_t thread;
    assert_int_equal(pthread_attr_init(&small), 0);
    assert_int_equal(pthread_attr_setstacksize(&small, 64 << 10), 0);
    assert_int_equal(pthread_create(&thread, &small, ask, &f), 0);
    assert_int_equal(pthread_join(thread, NULL), 0);
    pthread_attr_destroy(&small);
    free(f.bytes);
}

static void what_no_file_says_is_unknown(void **state)
{
    (void)state;
    struct file f = own_file();
    int line;
    char none[] = "no ELF file";
    assert_null(source_line(f.bytes, f.size, UINT64_C(1) << 40, &line));
    assert_null(source_line(none, sizeof none, 0, &line));
    free(f.bytes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_function_has_its_line),
        cmocka_unit_test(a_small_stack_is_enough),
        cmocka_unit_test(what_no_file_says_is_unknown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
