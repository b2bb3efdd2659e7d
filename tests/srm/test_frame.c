/* Frames: whole, in pieces, wrong; requests as they were made. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "srm/frame.h"

static void a_frame_comes_whole_or_not_yet(void **state)
{
    struct evbuffer *sent = evbuffer_new(), *got = evbuffer_new();
    enum frame_kind kind;
    char *bytes, byte;
    uint32_t length;
    (void)state;
    frame_put(sent, FRAME_OUT, "a\0b", 3);
    frame_put(sent, FRAME_END, "\7", 1);
    for (int i = 0; i < FRAME_HEAD + 3; i++) {
        assert_int_equal(frame_take(got, &kind, &bytes, &length), 0);
        evbuffer_remove(sent, &byte, 1);
        evbuffer_add(got, &byte, 1);
    }
    assert_int_equal(frame_take(got, &kind, &bytes, &length), 1);
    assert_true(kind == FRAME_OUT && length == 3 && !memcmp(bytes, "a\0b", 4));
    free(bytes);
    evbuffer_add_buffer(got, sent);
    assert_int_equal(frame_take(got, &kind, &bytes, &length), 1);
    assert_true(kind == FRAME_END && length == 1 && bytes[0] == 7);
    free(bytes);
    evbuffer_free(sent);
    evbuffer_free(got);
}

static void what_is_no_frame_is_refused(void **state)
{
    static const char *const WRONG[] = {"GET / HTTP/1.0", "R\xff\xff\xff\xff", "\0\0\0\0\0"};
    enum frame_kind kind;
    char *bytes;
    uint32_t length;
    (void)state;
    for (size_t i = 0; i < 3; i++) {
        struct evbuffer *b = evbuffer_new();
        evbuffer_add(b, WRONG[i], 5);
        assert_int_equal(frame_take(b, &kind, &bytes, &length), -1);
        evbuffer_free(b);
    }
}

static void a_request_is_read_as_it_was_made(void **state)
{
    char *words[] = {"ring", "", "two words"};
    const struct request r = {"load", "/home/a b", "12", "", "", 3, words};
    struct evbuffer *b = evbuffer_new();
    enum frame_kind kind;
    char *bytes;
    uint32_t length;
    struct request got;
    (void)state;
    request_put(b, &r);
    assert_int_equal(frame_take(b, &kind, &bytes, &length), 1);
    assert_true(request_read(&got, bytes, length));
    assert_string_equal(got.command, "load");
    assert_string_equal(got.folder, "/home/a b");
    assert_string_equal(got.session, "12");
    assert_string_equal(got.cube, "");
    assert_int_equal(got.argc, 3);
    for (int i = 0; i < 3; i++)
        assert_string_equal(got.argv[i], words[i]);
    assert_null(got.argv[3]);
    free(got.argv);
    assert_false(request_read(&got, bytes, 10));         /* too few strings */
    assert_false(request_read(&got, bytes, length - 1)); /* not ended */
    assert_false(request_read(&got, bytes, 0));
    free(bytes);
    evbuffer_free(b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_frame_comes_whole_or_not_yet),
        cmocka_unit_test(what_is_no_frame_is_refused),
        cmocka_unit_test(a_request_is_read_as_it_was_made),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
