/* test_files.c - atomic files, scratch folders, files that people write, numbers, JSON. */
#include <fcntl.h>
#include <math.h>
#include <setjmp.h>
#include <signal.h>
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
#include "files/json_set.h"
#include "files/number.h"
#include "files/scratch.h"
#include "files/text_file.h"
#include "files/virtual_time.h"

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

static void check_impossible(const char *path, const char *why)
{
    char *error = NULL;
    assert_false(atomic_file_possible(path, &error));
    assert_string_equal(error, why);
    free(error);
}

static void a_result_that_has_no_place_is_known_before_the_work(void **state)
{
    char *error = NULL;
    (void)state;
    put("old", "old");
    assert_int_equal(mkdir("folder", 0777), 0);
    assert_int_equal(symlink("missing/x", "link"), 0);
    for (size_t i = 0; i < 6; i++)
        assert_true(atomic_file_possible(
            (const char *[]){"-", "new", "old", "folder/new", "/dev/null", "link"}[i], &error));
    check_impossible("missing/new", "missing/new cannot be written: No such file or directory");
    check_impossible("old/new", "old/new cannot be written: Not a directory");
    check_impossible("folder", "folder cannot be written: Is a directory");
    check_text("old", "old");
    assert_int_equal(system("test $(ls | wc -l) = 3"), 0);
}

/* Of a file that a killed process was writing something is left; of one that is being written, too. */
static void only_what_nobody_writes_is_left_over(void **state)
{
    struct atomic_file f;
    char *error = NULL;
    int status;
    (void)state;
    pid_t child = fork();
    if (child == 0) {
        atomic_file_begin(&f, "r", &error);
        raise(SIGKILL);
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_int_equal(system("ls | grep -q '^r\\.unfinished-......$'"), 0);
    put("r.backup", "own");
    put("r.unfinished-reading", "own");
    put("other.unfinished-abcdef", "own");
    assert_true(atomic_file_begin(&f, "r", &error));
    atomic_file_remove_left("r");
    assert_int_equal(system("test $(ls | wc -l) = 4"), 0); /* the one being written, and three of others */
    fputs("new", f.out);
    assert_true(atomic_file_end(&f, &error));
    check_text("r", "new");
    assert_int_equal(system("test $(ls | wc -l) = 4"), 0);
}

static void at_a_signal_the_file_being_written_is_removed(void **state)
{
    (void)state;
    for (int i = 0; i < 2; i++) {
        struct atomic_file f;
        char *error = NULL;
        int status, signal = i ? SIGTERM : SIGINT;
        pid_t child = fork();
        if (child == 0) {
            atomic_file_drop_at_signals();
            atomic_file_begin(&f, "r", &error);
            raise(signal);
        }
        assert_int_equal(waitpid(child, &status, 0), child);
        assert_true(WIFSIGNALED(status) && WTERMSIG(status) == signal);
        assert_int_equal(system("test $(ls | wc -l) = 0"), 0);
    }
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

static char *left_by_a_killed_one(const char *name)
{
    int to_parent[2];
    char *theirs = calloc(1, 200);
    assert_int_equal(pipe(to_parent), 0);
    pid_t child = fork();
    if (child == 0) {
        struct scratch s = scratch_new(name);
        assert_true(write(to_parent[1], s.path, strlen(s.path)) > 0);
        _exit(0); /* as if the process had been killed */
    }
    waitpid(child, NULL, 0);
    assert_true(read(to_parent[0], theirs, 199) > 0);
    close(to_parent[0]);
    close(to_parent[1]);
    assert_int_equal(access(theirs, F_OK), 0);
    return theirs;
}

static void a_scratch_folder_goes_with_its_process(void **state)
{
    (void)state;
    struct scratch mine = scratch_new("touchstone-study");
    put("inside", "");
    char *theirs = left_by_a_killed_one("touchstone-study");
    assert_int_equal(mkdir("touchstone-study-123456x", 0700), 0); /* other names: must stay */
    assert_int_equal(mkdir("touchstone-notes-123456", 0700), 0);
    struct scratch another = scratch_new("touchstone-cfs"); /* of another kind: removes it all the same */
    assert_int_not_equal(access(theirs, F_OK), 0);
    struct scratch third = scratch_new("touchstone-study");
    assert_int_equal(access(mine.path, F_OK), 0);
    assert_int_equal(access(another.path, F_OK), 0);
    assert_int_equal(access("touchstone-study-123456x", F_OK), 0);
    assert_int_equal(access("touchstone-notes-123456", F_OK), 0);
    scratch_remove(&mine);
    scratch_remove(&another);
    scratch_remove(&third);
    free(theirs);
}

/* Processes that all make folders at once must not take a folder that is not locked yet for a dead one's. */
static void scratch_folders_of_the_living_stay(void **state)
{
    (void)state;
    enum { PROCESSES = 4, ROUNDS = 100 };
    for (int i = 0; i < PROCESSES; i++)
        if (fork() == 0) {
            for (int k = 0; k < ROUNDS; k++) {
                struct scratch s = scratch_new("touchstone-why");
                if (!s.path || access(s.path, F_OK) != 0)
                    _exit(1);
                scratch_remove(&s);
            }
            _exit(0);
        }
    for (int i = 0, status; i < PROCESSES; i++) {
        assert_true(wait(&status) > 0);
        assert_int_equal(status, 0);
    }
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
    put("marked", TEXT_BYTE_ORDER_MARK "text " TEXT_BYTE_ORDER_MARK);
    text = text_file_read("marked", 1000, &why, &line);
    assert_string_equal(text, "text " TEXT_BYTE_ORDER_MARK);
    free(text);
    put("latin1", "a\nb\xfc\n");
    check_refused("latin1", "a byte that is not UTF-8 text", 2);
    put("overlong", "\xc0\xaf");
    check_refused("overlong", "a byte that is not UTF-8 text", 1);
    put("surrogate", "\n\n\xed\xa0\x80");
    check_refused("surrogate", "a byte that is not UTF-8 text", 3);
    put("cut", "abc\xe2\x82");
    check_refused("cut", "a byte that is not UTF-8 text", 1);
    check_refused("/dev/zero", "it is larger than such files are", 0);
    check_refused(".", "it is a folder", 0);
    check_refused("missing", "No such file or directory", 0);
}

static void a_number_is_as_exact_as_its_last_digit(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        double value, unit;
    } right[] = {{"90.7", 90.7, 0.1},
                 {"1110", 1110, 1},
                 {"-0.0150", -0.015, 0.0001},
                 {"1.2e3", 1200, 100},
                 {"7", 7, 1}};
    static const char *const wrong[] = {"", "x", "1 s", "0x10", "nan", "inf", "1,5"};
    double value, unit;
    for (size_t i = 0; i < sizeof right / sizeof *right; i++) {
        assert_true(number_read(right[i].text, &value, &unit));
        assert_true(value == right[i].value && fabs(unit - right[i].unit) < 1e-12);
    }
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        assert_false(number_read(wrong[i], &value, &unit));
}

/* Runs set in a child process with its standard error in the file "err". Returns the child's exit status. */
static int status_of(void (*set)(void))
{
    pid_t pid = fork();
    if (pid == 0) {
        dup2(open("err", O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
        set();
        _exit(0);
    }
    int status = -1;
    assert_int_equal(waitpid(pid, &status, 0), pid);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

static void set_latin1(void)
{
    json_set(json_object(), "name", json_string("gr\xfc\xdf"));
}

static void append_latin1(void)
{
    json_append(json_array(), json_string("\xfc"));
}

static void text_that_json_cannot_hold_ends_the_process_with_a_message(void **state)
{
    (void)state;
    assert_int_equal(status_of(set_latin1), 1);
    check_text("err", "touchstone: name cannot be set: its text is not UTF-8, or memory is exhausted\n");
    assert_int_equal(status_of(append_latin1), 1);
    json_t *object = json_object(), *list = json_array();
    json_append(list, json_integer(7));
    json_set(object, "list", list);
    assert_int_equal(json_integer_value(json_array_get(json_object_get(object, "list"), 0)), 7);
    json_decref(object);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, enter, leave)

/* --- times for people --- */

static void counts_have_a_comma_between_each_three_digits(void **state)
{
    (void)state;
    assert_string_equal("0", number_grouped(0).text);
    assert_string_equal("999", number_grouped(999).text);
    assert_string_equal("1,200,034", number_grouped(1200034).text);
    assert_string_equal("18,446,744,073,709,551,615", number_grouped(UINT64_MAX).text);
}

static void moments_keep_each_nanosecond(void **state)
{
    (void)state;
    assert_string_equal(virtual_time_moment(0).text, "0 s");
    assert_string_equal(virtual_time_moment(25000).text, "25 ns");
    assert_string_equal(virtual_time_moment(12500).text, "12.5 ns");
    assert_string_equal(virtual_time_moment(5025000).text, "5.025 us");
    assert_string_equal(virtual_time_moment(1967300000).text, "1.9673 ms");
    assert_string_equal(virtual_time_moment(100 * VT_MILLISECOND).text, "100 ms");
    assert_string_equal(virtual_time_moment(107 * VT_SECOND + 224000001000).text, "107.224000001 s");
    assert_string_equal(virtual_time_moment(3600 * VT_SECOND).text, "3600 s");
}

static void durations_have_four_digits(void **state)
{
    (void)state;
    assert_string_equal(duration_text(0).text, "0 s");
    assert_string_equal(duration_text(6612.719e-6).text, "6.613 ms");
    assert_string_equal(duration_text(-0.0301).text, "-30.10 ms");
    assert_string_equal(duration_text(0.99996).text, "1.000 s");
    assert_string_equal(duration_text(0.9999).text, "999.9 ms");
    assert_string_equal(duration_text(124.2e-6).text, "124.2 us");
    assert_string_equal(duration_text(107.224).text, "107.2 s");
    assert_string_equal(duration_text(73.1).text, "73.10 s"); /* beside 91.19 s, in a column */
    assert_string_equal(duration_text(9.99949).text, "9.999 s");
    assert_string_equal(duration_text(9.9995).text, "10.00 s");
    assert_string_equal(duration_text(999.96).text, "1000 s");
    assert_string_equal(duration_text(12345.6).text, "12346 s");
    assert_string_equal(duration_text(1e6).text, "1000000 s");
    assert_string_equal(limit_text(30).text, "30 s");
    assert_string_equal(limit_text(0.0015).text, "1.5 ms");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_result_is_there_whole_or_not_at_all),
        TEST(a_result_that_has_no_place_is_known_before_the_work),
        TEST(only_what_nobody_writes_is_left_over),
        TEST(at_a_signal_the_file_being_written_is_removed),
        TEST(a_link_stays_and_its_target_is_written),
        TEST(a_pipe_gets_what_is_written),
        TEST(what_could_not_be_written_is_an_error),
        TEST(a_scratch_folder_goes_with_its_process),
        TEST(scratch_folders_of_the_living_stay),
        TEST(text_is_read_if_it_is_text),
        TEST(a_number_is_as_exact_as_its_last_digit),
        TEST(text_that_json_cannot_hold_ends_the_process_with_a_message),
        TEST(counts_have_a_comma_between_each_three_digits),
        TEST(moments_keep_each_nanosecond),
        TEST(durations_have_four_digits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
