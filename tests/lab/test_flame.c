/* test_flame.c - profiles as trees of frames: read, selected by node, compared, and written. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <cmocka.h>
#include "lab/flame/flame.h"

#define HEAD(nodes)                                                                                          \
    "{\"program\": \"p<&>\", \"nodes\": " #nodes                                                             \
    ", \"functions\": [], \"end_ps\": 5000, \"tree\": {\"spots\": ["
static const char ONE[] =
    HEAD(4) "\"0 r 0 \\t\", \"0 f 3 main\\ta.c\", \"1 f 9 f;g\\ta.c\", \"2 c 0 crecv\\t\","
            "\"3 w 0 (waiting)\\t\", \"1 l 0 sqrt\\t\"], \"shares\": ["
            "\"1 4 a.c\\t0-3:10 \", \"2 10 a.c\\t0:1 2-3:100 \", \"4 0 \\t1:7000 \", \"5 4 a.c\\t3:5 \"]}}";
/* The same function, begun in another line, takes more; another is gone. */
static const char TWO[] = HEAD(4) "\"0 r 0 \\t\", \"0 f 3 main\\ta.c\", \"1 f 12 f;g\\ta.c\"], \"shares\": ["
                                  "\"1 4 a.c\\t0-3:10 \", \"2 13 a.c\\t0-3:1000 \"]}}";

static const char *put(const char *name, const char *text)
{
    FILE *f = fopen(name, "w");
    assert_non_null(f);
    fputs(text, f);
    fclose(f);
    return name;
}

static const struct flame_frame *find(const struct flame_frame *f, const char *name)
{
    const struct flame_frame *c = f->children;
    while (c && strcmp(c->name, name))
        c = c->next;
    assert_non_null(c);
    return c;
}

/* (Inlined, GCC takes the text for its own variable's address.) */
__attribute__((noinline)) static char *written(const struct flame *f,
                                               void (*write)(const struct flame *, FILE *))
{
    char *text;
    size_t length;
    FILE *out = open_memstream(&text, &length);
    write(f, out);
    fclose(out);
    return text;
}

static struct flame *load(const char *one, const char *two, const struct flame_selection *s)
{
    static const struct flame_selection ALL;
    char *error = NULL;
    struct flame *f =
        flame_load(put("one.json", one), two ? put("two.json", two) : NULL, s ? s : &ALL, &error);
    assert_non_null(f);
    return f;
}

static void totals_are_sums(void **state)
{
    struct flame *f = load(ONE, NULL, NULL);
    const struct flame_frame *main_ = find(f->root, "main"), *g = find(main_, "f;g");
    (void)state;
    assert_int_equal(f->root->total[0], 40 + 201 + 7000 + 5);
    assert_int_equal(main_->self[0], 40);
    assert_int_equal(g->total[0], 201 + 7000);
    assert_int_equal(find(find(g, "crecv"), "(waiting)")->self[0], 7000);
    assert_int_equal(find(g, "crecv")->self[0], 0);
    flame_free(f);
}

static void nodes_are_selected(void **state)
{
    static const bool SECOND_AND_LAST[] = {false, true, false, true};
    struct flame_selection s = {SECOND_AND_LAST, 4};
    struct flame *f = load(ONE, NULL, &s);
    (void)state;
    assert_int_equal(f->nodes[0], 2);
    assert_int_equal(f->root->total[0], 20 + 100 + 7000 + 5);
    flame_free(f);
}

static void lines_of_all_paths_are_one(void **state)
{
    struct flame *f = load(ONE, NULL, NULL);
    (void)state;
    assert_int_equal(f->line_count, 2);
    assert_int_equal(f->lines[0].line, 10);
    assert_int_equal(f->lines[0].time[0], 201);
    assert_int_equal(f->lines[1].time[0], 45); /* with the library's */
    assert_string_equal(f->lines[1].function, "main");
    flame_free(f);
}

static void lines_of_nothing_are_counted_only(void **state)
{
    struct flame *f = load(HEAD(1) "\"0 r 0 \\t\", \"0 f 3 main\\ta.c\"], \"shares\": ["
                                   "\"1 4 a.c\\t0:100000 \", \"1 5 a.c\\t0:4 \"]}}",
                           NULL, NULL);
    char *text = written(f, flame_write_lines);
    (void)state;
    assert_non_null(strstr(text, "a.c:4"));
    assert_null(strstr(text, "a.c:5"));
    assert_non_null(strstr(text, " in 1 more line "));
    free(text);
    flame_free(f);
}

static void stacks_are_folded(void **state)
{
    struct flame *f = load(ONE, NULL, NULL);
    char *text = written(f, flame_write_folded);
    (void)state;
    assert_string_equal(text, "main 40\nmain;f:g 201\nmain;f:g;crecv;(waiting) 7000\nmain;sqrt 5\n");
    free(text);
    flame_free(f);
}

static void two_profiles_are_one_tree(void **state)
{
    struct flame *f = load(TWO, ONE, NULL);
    char *text = written(f, flame_write_folded);
    (void)state;
    assert_string_equal(text,
                        "main 40 40\nmain;f:g 201 4000\nmain;f:g;crecv;(waiting) 7000 0\nmain;sqrt 5 0\n");
    free(text);
    text = written(f, flame_write_text);
    const char *wait = strstr(text, "main;f:g;crecv;(waiting)");
    assert_non_null(wait);
    assert_non_null(strstr(wait, "main;f:g\n")); /* behind it: the largest change comes first */
    free(text);
    flame_free(f);
}

static void a_picture_is_xml_whatever_the_names(void **state)
{
    struct flame *f =
        load("" HEAD(1) "\"0 r 0 \\t\", \"0 f 1 a<b>&'\\\"c\\tx.c\"], \"shares\": [\"1 1 x.c\\t0:5 \"]}}",
             NULL, NULL);
    char *text = written(f, flame_write_svg);
    (void)state;
    put("picture.svg", text);
    assert_non_null(strstr(text, "a&lt;b&gt;&amp;'&quot;c: 100.00 %"));
    assert_non_null(strstr(text, "data-n='a&lt;b&gt;&amp;&#39;&quot;c'"));
    assert_int_equal(system("xmllint --noout picture.svg"), 0);
    free(text);
    flame_free(f);
}

static void a_name_is_cut_between_characters(void **state)
{
    struct flame *f = load("" HEAD(1) "\"0 r 0 \\t\", \"0 f 1 gr\u00f6\u00dfer\\tx.c\", \"0 f 1 b\\tx.c\"], "
                                      "\"shares\": [\"1 1 x.c\\t0:30 \", \"2 1 x.c\\t0:970 \"]}}",
                           NULL, NULL);
    char *text = written(f, flame_write_svg);
    (void)state;
    put("picture.svg", text);
    assert_non_null(strstr(text, ">gr\u2026</text>"));
    assert_int_equal(system("xmllint --noout picture.svg"), 0);
    free(text);
    flame_free(f);
}

static void a_program_that_did_nothing(void **state)
{
    struct flame *f = load(HEAD(1) "\"0 r 0 \\t\"], \"shares\": []}}", NULL, NULL);
    (void)state;
    free(written(f, flame_write_text));
    free(written(f, flame_write_lines));
    char *text = written(f, flame_write_svg);
    assert_null(strstr(text, "nan"));
    free(text);
    flame_free(f);
}

static void fails(const char *text, const char *why)
{
    static const struct flame_selection ALL;
    char *error = NULL;
    assert_null(flame_load(put("bad.json", text), NULL, &ALL, &error));
    assert_non_null(error);
    if (strncmp(error, "bad.json", 8) || !strstr(error, why))
        fail_msg("%s", error);
    free(error);
}

static void damaged_files_are_said(void **state)
{
    (void)state;
    fails("", "is no profile");
    fails("{\"nodes\": 4}", "is no profile");
    fails("{\"functions\": []}", "has no paths of calls");
    fails(HEAD(0) "], \"shares\": []}}", "its number of nodes is none");
    fails(HEAD(4294967295) "], \"shares\": []}}", "its number of nodes is none");
    fails(HEAD(1) "\"0 r 0 \\t\", \"2 f 1 f\\ta.c\"], \"shares\": []}}", "its spot 1");
    fails(HEAD(1) "\"0 r 0 \\t\", \"0 z 1 f\\ta.c\"], \"shares\": []}}", "its spot 1");
    fails(HEAD(1) "\"0 r 0 \\t\", 7], \"shares\": []}}", "its spot 1");
    fails(HEAD(1) "\"0 r 0 \\t\"], \"shares\": [\"1 1 a.c\\t0:5 \"]}}", "its share 0");
    fails(HEAD(1) "\"0 r 0 \\t\"], \"shares\": [\"0 1 a.c\\t1:5 \"]}}", "its share 0");
    fails(HEAD(1) "\"0 r 0 \\t\"], \"shares\": [\"0 1 a.c\\t0-0:x \"]}}", "its share 0");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(totals_are_sums),
        cmocka_unit_test(nodes_are_selected),
        cmocka_unit_test(lines_of_all_paths_are_one),
        cmocka_unit_test(lines_of_nothing_are_counted_only),
        cmocka_unit_test(stacks_are_folded),
        cmocka_unit_test(two_profiles_are_one_tree),
        cmocka_unit_test(a_picture_is_xml_whatever_the_names),
        cmocka_unit_test(a_name_is_cut_between_characters),
        cmocka_unit_test(a_program_that_did_nothing),
        cmocka_unit_test(damaged_files_are_said),
    };
    char folder[] = "/tmp/test_flame.XXXXXX";
    if (!mkdtemp(folder) || chdir(folder))
        return 1;
    int failed = cmocka_run_group_tests(tests, NULL, NULL);
    char *remove_ = NULL;
    if (asprintf(&remove_, "rm -r %s", folder) > 0 && system(remove_))
        failed++;
    free(remove_);
    return failed;
}
