/* A node's part of the C library: sim/guest/libc/libc.h, streams.h. Each test runs a small program on one or
 * two nodes. */
#include "program.h"

/* Runs the body of a main() on n nodes; argv[1] is a directory for files. */
static void run(struct nodes *x, struct workshop *w, uint32_t n, const char *body)
{
    static const char before[] =
        "#include <errno.h>\n#include <assert.h>\n#include <stdio.h>\n#include <stdlib.h>\n"
        "#include <string.h>\n#include <sys/time.h>\n#include <time.h>\n#include <unistd.h>\n"
        "long mynode(void);\n";
    static char *env[] = {"HOME=/home/node", "EMPTY=", NULL};
    char *argv[] = {"prog", w->dir, NULL};
    char *source;
    assert_true(asprintf(&source, "%s%s", before, body) > 0);
    const char *path = build_as_nxcc(w, source);
    free(source);
    nodes_load(x, n, path, 2, argv, env);
    nodes_run(x);
}

static void expect(struct workshop *w, uint32_t n, const char *body, const char *output)
{
    struct nodes x;
    run(&x, w, n, body);
    if (x.sys.failure != NULL)
        fail_msg("%s", x.sys.failure);
    assert_string_equal(x.text[0], output);
    nodes_free(&x);
}

static void expect_failure(struct workshop *w, const char *body, const char *text)
{
    struct nodes x;
    run(&x, w, 1, body);
    assert_non_null(x.sys.failure);
    if (strstr(x.sys.failure, text) == NULL)
        fail_msg("'%s' does not say '%s'", x.sys.failure, text);
    nodes_free(&x);
}

/* --- output and input --- */

static void output_comes_in_the_order_of_virtual_time(void **state)
{
    expect(*state, 2,
           "int main() { sleep(mynode() ? 1 : 2); printf(\"%ld a\\n\", mynode()); sleep(2);\n"
           "fprintf(stdout, \"%ld \", mynode()); putchar('b'); puts(\"!\"); return 0; }",
           "1 a\n0 a\n1 b!\n0 b!\n");
}

static void unfinished_lines_come_out_at_the_end(void **state)
{
    expect(*state, 2, "int main() { printf(\"node %ld;\", mynode()); sleep(1 - mynode()); return 0; }",
           "node 1;node 0;");
    expect(*state, 1, "int main() { printf(\"exit\"); exit(0); }", "exit");
    expect(*state, 1, "int main() { printf(\"lost\"); _exit(0); }", "");
}

static void errors_go_to_the_error_output(void **state)
{
    struct nodes x;
    run(&x, *state, 1,
        "int main() { fprintf(stderr, \"%d\", 1); errno = ENOENT; perror(\"me\"); return 0; }");
    assert_string_equal(x.text[0], "");
    assert_string_equal(x.text[1], "1me: No such file or directory\n");
    nodes_free(&x);
}

static void only_node_0_has_an_input(void **state)
{
    struct workshop *w = *state;
    write_file(at(w, "in"), "12 x\nline\nlast", 14);
    int old = dup(0);
    assert_non_null(freopen(at(w, "in"), "r", stdin));
    expect(w, 2,
           "int main() { int i = -1, r = scanf(\"%d\", &i), c = getchar(), d = getchar(), e = getchar(); "
           "char s[9];\n"
           "sleep(mynode()); printf(\"%d %d %d %d %d %s\\n\", r, i, c, d, e, fgets(s, 9, stdin) ? s : "
           "\"end\");\n"
           "return 0; }",
           "1 12 32 120 10 line\n\n-1 -1 -1 -1 -1 end\n");
    dup2(old, 0);
    close(old);
}

/* --- files --- */

static void files_are_read_and_written(void **state)
{
    expect(*state, 1,
           "int main(int argc, char **argv) { char s[99]; FILE *f; sprintf(s, \"%s/f\", argv[1]);\n"
           "f = fopen(s, \"w\"); fputs(\"one\\ntwo\\n\", f); fclose(f);\n"
           "f = fopen(s, \"a\"); printf(\"%ld\\n\", ftell(f)); fputs(\"three\\n\", f); fclose(f);\n"
           "f = fopen(s, \"r+\"); fseek(f, 4, SEEK_SET); fputs(\"TWO\", f); rewind(f);\n"
           "while (fgets(s, 99, f)) printf(\"%s\", s); printf(\"%ld %d\\n\", ftell(f), feof(f)); return "
           "fclose(f); }",
           "8\none\nTWO\nthree\n14 1\n");
}

static void one_node_reads_what_another_wrote_before(void **state)
{
    expect(
        *state, 2,
        "int main(int argc, char **argv) { char s[99]; FILE *f; sprintf(s, \"%s/f\", argv[1]);\n"
        "if (mynode() == 1) { f = fopen(s, \"w\"); fputs(\"early\", f); sleep(2); fputs(\" late\", f); "
        "fclose(f); }\n"
        "else { sleep(1); f = fopen(s, \"r\"); printf(\"[%s]\\n\", fgets(s, 99, f) ? s : \"\"); sleep(2);\n"
        "clearerr(f); printf(\"[%s]\\n\", fgets(s, 99, f) ? s : \"\"); } return 0; }",
        "[]\n[early late]\n");
}

static void output_may_be_redirected(void **state)
{
    struct workshop *w = *state;
    char text[20] = "";
    expect(w, 1,
           "int main(int argc, char **argv) { char s[99]; sprintf(s, \"%s/f\", argv[1]); puts(\"before\");\n"
           "printf(\"%d\", freopen(s, \"w\", stdout) == stdout); puts(\"after\"); return 0; }",
           "before\n");
    FILE *f = fopen(at(w, "f"), "r");
    assert_non_null(fgets(text, sizeof text, f));
    assert_string_equal(text, "1after\n");
    fclose(f);
}

static void failing_calls_say_why(void **state)
{
    expect(*state, 1,
           "int main() { FILE *f = fopen(\"/missing/x\", \"r\"); printf(\"%p %d\\n\", f, errno == ENOENT);\n"
           "f = fopen(\"/tmp/x\", \"q\"); printf(\"%p %d\\n\", f, errno == EINVAL);\n"
           "printf(\"%d %d\\n\", remove(\"/missing/x\"), unlink(\"/missing/x\")); return 0; }",
           "(nil) 1\n(nil) 1\n-1 -1\n");
}

static void temporary_files_leave_no_trace(void **state)
{
    expect(*state, 1,
           "int main() { FILE *f = tmpfile(); int c; fputs(\"abc\", f); rewind(f); c = getc(f); "
           "printf(\"%c\\n\", c);\n"
           "return fclose(f); }",
           "a\n");
}

static void what_a_node_leaves_open_is_closed(void **state)
{
    struct workshop *w = *state;
    int before = dup(0), after;
    close(before);
    expect(w, 1,
           "int main(int argc, char **argv) { char s[99]; sprintf(s, \"%s/f\", argv[1]);\n"
           "for (int i = 0; i < 20; i++) fputs(\"written at the end\", fopen(s, \"a\")); return 0; }",
           "");
    assert_int_equal(after = dup(0), before); /* the least free descriptor */
    close(after);
    FILE *f = fopen(at(w, "f"), "r");
    fseek(f, 0, SEEK_END);
    assert_int_equal(ftell(f), 20 * 18);
    fclose(f);
}

static void flushing_all_flushes_the_node_s_own(void **state)
{
    expect(*state, 2,
           "int main() { printf(\"%ld\", mynode()); if (mynode() == 1) { sleep(1); fflush(NULL); } else "
           "sleep(2);\n"
           "return 0; }",
           "10");
}

/* --- memory --- */

static void memory_is_the_node_s_and_ends(void **state)
{
    struct nodes x;
    run(&x, *state, 1,
        "int main() { char *p = malloc(1000000), *q = calloc(1000, 1000), *r = realloc(p, 2000000); int i, n "
        "= 0;\n"
        "for (i = 0; i < 1000000; i++) n += q[i]; free(q); printf(\"%d %d\\n\", n, r != 0);\n"
        "errno = 0; p = malloc(14000000); printf(\"%p %d\\n\", p, errno == ENOMEM);\n"
        "p = strdup(\"copy\"); printf(\"%s %s\\n\", p, strndup(p, 2)); return 0; }");
    assert_string_equal(x.text[0], "0 1\n(nil) 1\ncopy co\n");
    assert_int_equal(x.node[0]->cold->refusal.bytes, 14000000);
    assert_in_range(x.node[0]->stats.memory_peak, 4000000, 5000000);
    nodes_free(&x);
}

static void a_wrong_free_is_an_error_of_the_program(void **state)
{
    expect_failure(*state, "int main() { char *p = malloc(9), *volatile q = p + 1; free(q); return 0; }",
                   "node 0, at 0 s: free: 0x");
    expect_failure(*state, "int main() { char *volatile p = malloc(9); free(p); free(p); return 0; }",
                   "freed already");
    expect_failure(*state, "int main() { char *volatile p = \"x\"; p = realloc(p, 10); return 0; }",
                   "realloc: 0x");
}

/* --- ending --- */

static void exit_ends_one_node_with_its_status(void **state)
{
    struct nodes x;
    run(&x, *state, 2, "int main() { if (mynode() == 0) exit(3); sleep(1); printf(\"on\\n\"); return 4; }");
    assert_string_equal(x.text[0], "on\n");
    assert_int_equal(x.node[0]->end.how, NODE_EXITED);
    assert_int_equal(x.node[0]->end.exit_code, 3);
    assert_int_equal(x.node[1]->end.how, NODE_RETURNED);
    assert_int_equal(x.node[1]->end.exit_code, 4);
    nodes_free(&x);
}

static void atexit_functions_run_latest_first(void **state)
{
    const char *ways[] = {"return 0;", "exit(0);"};
    for (int i = 0; i < 2; i++) {
        char body[300];
        snprintf(body, sizeof body,
                 "void c() { puts(\"c\"); } void b() { atexit(c); puts(\"b\"); } void a() { puts(\"a\"); "
                 "exit(1); }\n"
                 "int main() { atexit(a); atexit(b); %s }",
                 ways[i]);
        expect(*state, 1, body, "b\nc\na\n");
    }
}

static void failing_programs_say_where(void **state)
{
    expect_failure(*state, "int main() { assert(mynode() == 1); return 0; }",
                   "assertion 'mynode() == 1' failed");
    expect_failure(*state, "int main() { sleep(1); abort(); }", "node 0, at 1 s: abort\n  called from main+");
}

/* --- time, random numbers and the rest --- */

static void clocks_show_virtual_time(void **state)
{
    expect(
        *state, 1,
        "int main() { time_t t = time(0), u; struct timeval v; sleep(3); usleep(250); gettimeofday(&v, 0);\n"
        "printf(\"%ld %ld.%06ld %ld\\n\", (long)t, v.tv_sec - t, (long)v.tv_usec, (long)clock());\n"
        "printf(\"%d\", time(&u) == u); return 0; }",
        "725846400 3.000252 3\n1"); /* clock calls take 0.75 + 0.25 us; sleeping is no processor time */
}

/* Its answers take 0.25 us each, beside 1 us of the second clock call. */
static void unix_answers_names_and_numbers(void **state)
{
    expect(*state, 1,
           "int main() { struct timeval a, b; char name[64]; gettimeofday(&a, 0);\n"
           "for (int i = 0; i < 4; i++) getpid(), getuid(), gethostname(name, sizeof name);\n"
           "gettimeofday(&b, 0); printf(\"%ld\", (b.tv_sec - a.tv_sec) * 1000000 + b.tv_usec - a.tv_usec); "
           "return 0; }",
           "4");
}

static void random_numbers_are_glibc_s_and_each_node_s_own(void **state)
{
    char expected[200], one[100];
    srand(1);
    int a = rand(), b = rand();
    srand(7);
    srand48(7);
    snprintf(one, sizeof one, "%d %d %d %.17g\n", a, b, rand(), drand48());
    snprintf(expected, sizeof expected, "%s%s", one, one);
    expect(*state, 2,
           "int main() { int a = rand(), b = random(), c; srand(7); srand48(7); c = rand();\n"
           "printf(\"%d %d %d %.17g\\n\", a, b, c, drand48()); return 0; }",
           expected);
}

static void strtok_and_getenv_are_the_node_s(void **state)
{
    expect(*state, 2,
           "int main() { char s[] = \"a b\"; strtok(s, \" \"); sleep(1 + mynode()); \n"
           "printf(\"%s %s %p [%s]\\n\", strtok(0, \" \"), getenv(\"HOME\"), getenv(\"HOM\"), "
           "getenv(\"EMPTY\"));\n"
           "return 0; }",
           "b /home/node (nil) []\nb /home/node (nil) []\n");
}

int main(void)
{
#define TEST(f) cmocka_unit_test_setup_teardown(f, workshop_open, workshop_close)
    const struct CMUnitTest tests[] = {
        TEST(output_comes_in_the_order_of_virtual_time),
        TEST(unfinished_lines_come_out_at_the_end),
        TEST(errors_go_to_the_error_output),
        TEST(only_node_0_has_an_input),
        TEST(files_are_read_and_written),
        TEST(one_node_reads_what_another_wrote_before),
        TEST(output_may_be_redirected),
        TEST(failing_calls_say_why),
        TEST(temporary_files_leave_no_trace),
        TEST(what_a_node_leaves_open_is_closed),
        TEST(flushing_all_flushes_the_node_s_own),
        TEST(memory_is_the_node_s_and_ends),
        TEST(a_wrong_free_is_an_error_of_the_program),
        TEST(exit_ends_one_node_with_its_status),
        TEST(atexit_functions_run_latest_first),
        TEST(failing_programs_say_where),
        TEST(clocks_show_virtual_time),
        TEST(unix_answers_names_and_numbers),
        TEST(random_numbers_are_glibc_s_and_each_node_s_own),
        TEST(strtok_and_getenv_are_the_node_s),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
