/* Files that runs leave, folders that they do not leave, and files that people write. */
#include <fcntl.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#include <cmocka.h>
#include "files/atomic_file.h"
#include "files/scratch.h"
#include "files/text_file.h"

static int enter(void **state)
{
    struct scratch *s = malloc(sizeof *s);
    *s = scratch_new("test-files");
    *state = s;
    return s->path && chdir(s->path) == 0 && setenv("TMPDIR", s->path, 1) == 0 ? 0 : -1;
}

static int leave(void **state)
{
    struct scratch *s = *state;
    unsetenv("TMPDIR");
    int r = chdir("/");
    scratch_remove(s);
    free(s);
    return r;
}

static void put(const char *path, const char *text)
{
    FILE *f = fopen(path, "w");
    assert_non_null(f);
    fputs(text, f);
    fclose(f);
}

static void check_text(const char *path, const char *text)
{
    char got[100] = "";
    FILE *f = fopen(path, "r");
    assert_non_null(f);
    assert_true(fread(got, 1, sizeof got - 1, f) < sizeof got);
    fclose(f);
    assert_string_equal(got, text);
}

static void write_result(const char *path, const char *text)
{
    struct atomic_file f;
    char *error = NULL;
    assert_true(atomic_file_begin(&f, path, &error));
    fputs(text, f.out);
    assert_true(atomic_file_end(&f, &error));
}

static void a_result_is_there_whole_or_not_at_all(void **state)
{
    struct atomic_file f;
    char *error = NULL;
    (void)state;
    put("r", "old");
    assert_true(atomic_file_begin(&f, "r", &error));
    fputs("new", f.out);
    fflush(f.out);
    check_text("r", "old");
    assert_true(atomic_file_end(&f, &error));
    check_text("r", "new");
    assert_true(atomic_file_begin(&f, "r", &error));
    fputs("newer", f.out);
    atomic_file_drop(&f);
    check_text("r", "new");
    assert_int_equal(system("test $(ls | wc -l) = 1"), 0);
}

static void a_link_stays_and_its_target_is_written(void **state)
{
    struct stat st;
    (void)state;
    put("target", "old");
    assert_int_equal(symlink("target", "link"), 0);
    write_result("link", "new");
    assert_int_equal(lstat("link", &st), 0);
    assert_true(S_ISLNK(st.st_mode));
    check_text("target", "new");
}

static void a_pipe_gets_what_is_written(void **state)
{
    struct stat st;
    char got[10] = "";
    (void)state;
    assert_int_equal(mkfifo("pipe", 0600), 0);
    int reader = open("pipe", O_RDONLY | O_NONBLOCK);
    write_result("pipe", "through");
    assert_int_equal(read(reader, got, sizeof got), 7);
    assert_string_equal(got, "through");
    assert_int_equal(lstat("pipe", &st), 0);
    assert_true(S_ISFIFO(st.st_mode));
    close(reader);
}

static void what_could_not_be_written_is_an_error(void **state)
{
    struct atomic_file f;
    char *error = NULL;
    (void)state;
    assert_true(atomic_file_begin(&f, "/dev/full", &error));
    fputs("much", f.out);
    assert_false(atomic_file_end(&f, &error));
    assert_string_equal(error, "/dev/full cannot be written: No space left on device");
    free(error);
    assert_false(atomic_file_begin(&f, "missing/r", &error));
    assert_string_equal(error, "missing/r cannot be written: No such file or directory");
    free(error);
}

/* --- scratch --- */

static void make_old(const char *path)
{
    struct timespec t[2] = {{.tv_sec = time(NULL) - 1000}, {.tv_sec = time(NULL) - 1000}};
    assert_int_equal(utimensat(AT_FDCWD, path, t, 0), 0);
}

static void a_scratch_folder_goes_with_its_process(void **state)
{
    (void)state;
    struct scratch mine = scratch_new("test");
    put("inside", "");
    int to_parent[2];
    char theirs[200] = "";
    assert_int_equal(pipe(to_parent), 0);
    pid_t child = fork();
    if (child == 0) {
        struct scratch s = scratch_new("test");
        assert_true(write(to_parent[1], s.path, strlen(s.path)) > 0);
        _exit(0); /* as if it had been killed */
    }
    waitpid(child, NULL, 0);
    assert_true(read(to_parent[0], theirs, sizeof theirs - 1) > 0);
    assert_int_equal(access(theirs, F_OK), 0);
    struct scratch another = scratch_new("test");
    assert_int_equal(access(theirs, F_OK), 0); /* it may just be about to be locked */
    make_old(theirs);
    make_old(mine.path);
    make_old(another.path);
    assert_int_equal(mkdir("test-123456x", 0700), 0); /* not of ours */
    make_old("test-123456x");
    struct scratch third = scratch_new("test");
    assert_int_not_equal(access(theirs, F_OK), 0);
    assert_int_equal(access(mine.path, F_OK), 0);
    assert_int_equal(access(another.path, F_OK), 0);
    assert_int_equal(access("test-123456x", F_OK), 0);
    scratch_remove(&mine);
    scratch_remove(&another);
    scratch_remove(&third);
}

/* --- what people write --- */

static void check_refused(const char *path, const char *why, int line)
{
    const char *got = NULL;
    int at;
    assert_null(text_file_read(path, 1000, &got, &at));
    assert_string_equal(got, why);
    assert_int_equal(at, line);
}

static void text_is_read_if_it_is_text(void **state)
{
    const char *why;
    int line;
    (void)state;
    put("good", "gr\xc3\xbc\xc3\x9f\x65 \xe2\x82\xac \xf0\x9f\x98\x80\n");
    char *text = text_file_read("good", 1000, &why, &line);
    assert_string_equal(text, "gr\xc3\xbc\xc3\x9f\x65 \xe2\x82\xac \xf0\x9f\x98\x80\n");
    free(text);
    put("latin1", "a\nb\xfc\n");
    check_refused("latin1", "a byte that is no text (UTF-8)", 2);
    put("overlong", "\xc0\xaf");
    check_refused("overlong", "a byte that is no text (UTF-8)", 1);
    put("surrogate", "\n\n\xed\xa0\x80");
    check_refused("surrogate", "a byte that is no text (UTF-8)", 3);
    put("cut", "abc\xe2\x82");
    check_refused("cut", "a byte that is no text (UTF-8)", 1);
    check_refused("/dev/zero", "it is larger than such files are", 0);
    check_refused(".", "it is a folder", 0);
    check_refused("missing", "No such file or directory", 0);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, enter, leave)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_result_is_there_whole_or_not_at_all),
        TEST(a_link_stays_and_its_target_is_written),
        TEST(a_pipe_gets_what_is_written),
        TEST(what_could_not_be_written_is_an_error),
        TEST(a_scratch_folder_goes_with_its_process),
        TEST(text_is_read_if_it_is_text),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
