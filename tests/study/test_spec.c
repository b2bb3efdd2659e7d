/* test_spec.c - study files: each kind of mistake is named with its line and what is allowed; conditions. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "study/condition.h"
#include "study/spec.h"

static const char good[] =
    "program = \"p\"; machine = \"delta\";\n"
    "axes = ( { name = \"nodes\"; values = ( 2, 16 ); },\n"
    "         { name = \"kind\"; cases = ( { label = \"a\"; }, { label = \"b\"; } ); } );\n";

static struct spec *read_text(const char *text, char **error)
{
    FILE *out = fopen("study.cfg", "w");
    assert_non_null(out);
    fputs(text, out);
    fclose(out);
    return spec_read("study.cfg", error);
}

static void mistakes_are_named_with_line_and_remedy(void **state)
{
    /* What stands after the good lines or instead of them, and what is said of it. */
    static const struct {
        bool after;
        const char *text, *said;
    } MISTAKES[] = {
        {false, "program = ;", "study.cfg:1: syntax error (settings are written: key = value;)"},
        {false, "machine = \"m\";\naxes = ( );", "study.cfg: program: missing"},
        {true, "porgram = \"q\";", "study.cfg:4: porgram: unknown key; known here: title, program"},
        {true, "nodes = 4;", "study.cfg:4: nodes: an axis has it: one of them only"},
        {true, "only = ( \"nodes\" );",
         "study.cfg:4: only: \"nodes\" is no condition: AXIS < VALUE is one, also <= = != >= >, with blanks between"},
        {true, "only = ( \"nods < 4\" );", "study.cfg:4: only: neither nods nor 4 is an axis"},
        {true, "only = ( \"kind < 4\" );",
         "study.cfg:4: only: kind is no number or axis of numbers: only = and != are allowed"},
        {true, "only = ( 4 );", "study.cfg:4: only: must hold texts such as \"group <= nodes\""},
        {true, "pictures = ( { file = \"f\"; x = \"group\"; y = \"s\"; } );",
         "study.cfg:4: x: there is no axis group"},
        {true, "pictures = ( { file = \"f\"; x = \"nodes\"; y = \"s\"; } );",
         "study.cfg:4: f: axis kind has no place: x, lines, panels and best are to be had"},
        {true,
         "pictures = ( { file = \"f\"; x = \"nodes\"; y = \"s\"; lines = \"nodes\"; panels = \"kind\"; } );",
         "study.cfg:4: f: axis nodes has 2 places of x, lines, panels, best; one is allowed"},
        {true, "pictures = ( { file = \"f/g\"; x = \"nodes\"; y = \"s\"; } );",
         "study.cfg:4: file: \"f/g\" is no name: letters, digits, _ - . are allowed"},
        {true, "pictures = ( { file = \"f\"; x = \"nodes\"; } );", "study.cfg:4: y: missing"},
        {true, "pictures = ( { file = \"f\"; y = \"s\"; } );", "study.cfg:4: x: missing"},
        {true, "pictures = ( { file = \"f\"; x = \"nodes\"; y = \"s\"; logarithmic = \"z\"; } );",
         "study.cfg:4: logarithmic: must be \"x\", \"y\" or \"xy\""},
        {false, "program = \"p\"; machine = \"m\";\naxes = ( );",
         "study.cfg:2: axes: 0 axes: 1 to 8 are allowed"},
        {false,
         "program = \"p\"; machine = \"m\";\naxes = ( { name = \"g\"; values = ( 1 ); arguments = \"{}\"; } );",
         "study.cfg: nodes: missing"},
        {false, "program = \"p\"; machine = \"m\";\naxes = ( { name = \"nodes\"; values = ( 1.5 ); } );",
         "study.cfg:2: nodes: 1.5 is not a number of nodes: whole, from 1 to 1048576"},
        {false, "program = \"p\"; machine = \"m\";\naxes = ( { name = \"nodes\"; values = ( 4, 4 ); } );",
         "study.cfg:2: nodes: 4 is there twice"},
        {false, "program = \"p\"; machine = \"m\";\naxes = ( { name = \"nodes\"; values = ( ); } );",
         "study.cfg:2: nodes: is empty: at least one value is needed"},
        {false, "program = \"p\"; machine = \"m\";\naxes = ( { name = \"nodes\"; } );",
         "study.cfg:2: nodes: needs either values = ( ... ) or cases = ( { ... } )"},
        {false,
         "program = \"p\"; machine = \"m\";\naxes = ( { name = \"nodes\"; values = ( { a = 1; } ); } );",
         "study.cfg:2: values: must hold numbers or texts; for more, give cases = ( { ... } );"},
        {false, "program = \"p\"; machine = \"m\";\naxes = ( { name = \"g\"; values = ( 1 ); } );",
         "study.cfg:2: g: changes nothing; give set = ( \"KEY={}\" ) or arguments = \"-option {}\""},
        {false,
         "program = \"p\"; machine = \"m\";\naxes = ( { name = \"g\"; values = ( 1 ); set = ( \"a\" ); } );",
         "study.cfg:2: set: must hold texts KEY=VALUE, such as \"cfs.io_nodes={}\""},
        {false, "program = \"p\"; machine = \"m\";\naxes = ( { name = \"g\"; cases = ( 1 ); } );",
         "study.cfg:2: cases: must hold groups: { label = \"...\"; ... }"},
        {false, "program = \"p\"; machine = \"m\";\naxes = ( 1 );",
         "study.cfg:2: axes: must hold groups: { name = \"...\"; values = ( ... ); }"},
        {false,
         "program = \"p\"; machine = \"m\";\naxes = ( { name = \"nodes\"; values = ( 1 ); },\n"
         "{ name = \"nodes\"; values = ( 2 ); } );",
         "study.cfg:3: name: there is an axis nodes already"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof MISTAKES / sizeof *MISTAKES; i++) {
        char text[2048], *error = NULL;
        snprintf(text, sizeof text, "%s%s\n", MISTAKES[i].after ? good : "", MISTAKES[i].text);
        assert_null(read_text(text, &error));
        error[strnlen(error, strlen(MISTAKES[i].said))] = '\0';
        assert_string_equal(error, MISTAKES[i].said);
        free(error);
    }
}

static void a_file_that_is_not_there(void **state)
{
    (void)state;
    char *error = NULL;
    assert_null(spec_read("none.cfg", &error));
    assert_string_equal(error, "none.cfg: cannot be read: No such file or directory");
    free(error);
}

static bool holds(const char *text, size_t nodes, size_t kind)
{
    char *error = NULL;
    struct spec *s = read_text(good, &error);
    struct condition c;
    size_t at[SPEC_MAX_AXES] = {nodes, kind};
    assert_true(condition_read(&c, text, s, &error));
    bool does = condition_holds(&c, s, at);
    condition_clear(&c);
    spec_free(s);
    return does;
}

static void conditions_compare_numbers_by_size(void **state)
{
    (void)state;
    assert_true(holds("nodes < 16", 0, 0)); /* as texts 2 is greater than 16 */
    assert_false(holds("nodes < 16", 1, 0));
    assert_true(holds("nodes <= 16", 1, 0));
    assert_true(holds("16 >= nodes", 1, 0));
    assert_true(holds("nodes > 2", 1, 0));
    assert_true(holds("nodes = 2.0", 0, 0));
    assert_false(holds("nodes != 2", 0, 0));
}

static void conditions_tell_texts_apart(void **state)
{
    (void)state;
    assert_true(holds("kind = a", 0, 0));
    assert_false(holds("kind = a", 0, 1));
    assert_true(holds("kind != a", 0, 1));
}

static int enter(void **state)
{
    static char dir[] = "/tmp/test-spec.XXXXXX";
    *state = dir;
    return mkdtemp(dir) && chdir(dir) == 0 ? 0 : -1;
}

static int leave(void **state)
{
    unlink("study.cfg");
    return chdir("/") == 0 && rmdir(*state) == 0 ? 0 : -1;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mistakes_are_named_with_line_and_remedy),
        cmocka_unit_test(a_file_that_is_not_there),
        cmocka_unit_test(conditions_compare_numbers_by_size),
        cmocka_unit_test(conditions_tell_texts_apart),
    };
    return cmocka_run_group_tests(tests, enter, leave);
}
