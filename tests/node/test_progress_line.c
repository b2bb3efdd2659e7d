/* A progress line is taken away before other output, and never shown behind an unfinished line. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "guest/libc/progress_line.h"

enum { COLUMNS = 100 };

/* What a terminal's last line shows after these bytes. */
static void look(const char *bytes, char line[COLUMNS + 1])
{
    size_t at = 0;
    memset(line, ' ', COLUMNS);
    for (; *bytes; bytes++) {
        if (*bytes == '\r')
            at = 0;
        else
            line[at++] = *bytes;
        assert_true(at < COLUMNS);
    }
    for (at = COLUMNS; at > 0 && line[at - 1] == ' ';)
        at--;
    line[at] = '\0';
}

static void shown_changed_and_taken_away(void **state)
{
    char *bytes, line[COLUMNS + 1];
    size_t size;
    struct progress_line p = {.f = open_memstream(&bytes, &size)};
    (void)state;
    progress_line_show(&p, "12 messages");
    look(bytes, line);
    assert_string_equal(line, "12 messages");
    progress_line_show(&p, "a");
    look(bytes, line);
    assert_string_equal(line, "a");
    progress_line_clear(&p);
    look(bytes, line);
    assert_string_equal(line, "");
    fclose(p.f);
    free(bytes);
}

static void it_makes_way(void **state)
{
    char *bytes, line[COLUMNS + 1];
    size_t size;
    struct progress_line p = {.f = open_memstream(&bytes, &size)};
    (void)state;
    progress_line_show(&p, "12 messages");
    progress_line_make_way(&p, "half a", 6);
    look(bytes, line);
    assert_string_equal(line, "");
    size_t before = size;
    progress_line_show(&p, "13 messages"); /* the half line stays as it is */
    assert_int_equal(size, before);
    progress_line_make_way(&p, " line\n", 6);
    progress_line_show(&p, "14 messages");
    look(bytes + before, line);
    assert_string_equal(line, "14 messages");
    fclose(p.f);
    free(bytes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(shown_changed_and_taken_away),
                                       cmocka_unit_test(it_makes_way)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
