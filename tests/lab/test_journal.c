/* test_journal.c - journals, whose torn and damaged lines lose no other line; the result cache; point
 * locks. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "lab/jobs/point_locks.h"
#include "files/scratch.h"
#include "lab/jobs/journal.h"
#include "lab/jobs/result_cache.h"

static struct digest key_of(int i)
{
    return digest_of(&i, sizeof i);
}

static struct journal *open_here(FILE *notes)
{
    char *error = NULL;
    struct journal *j = journal_open(".", notes, &error);
    if (!j)
        fail_msg("%s", error);
    return j;
}

static void add(struct journal *j, int i, enum journal_line_state state, int value)
{
    char *error = NULL;
    json_t *record = json_pack("{s:i}", "value", value);
    assert_true(journal_add(j, key_of(i), state, record, true, &error));
    json_decref(record);
}

/* -1 if there is none */
static int value_of(struct journal *j, int i)
{
    json_t *record = journal_record(j, key_of(i));
    int value = record ? (int)json_integer_value(json_object_get(record, "value")) : -1;
    json_decref(record);
    return value;
}

static size_t size_of_file(void)
{
    struct stat st;
    assert_int_equal(stat("journal", &st), 0);
    return (size_t)st.st_size;
}

static void what_was_added_is_there_again(void **state)
{
    enum journal_line_state how;
    (void)state;
    struct journal *j = open_here(stderr);
    add(j, 1, LINE_DONE, 10);
    add(j, 2, LINE_FAILED, 20);
    assert_int_equal(value_of(j, 1), 10);
    journal_close(j);
    j = open_here(stderr);
    assert_int_equal(value_of(j, 1), 10);
    assert_int_equal(value_of(j, 2), 20);
    assert_int_equal(value_of(j, 3), -1);
    assert_true(journal_find(j, key_of(2), &how));
    assert_int_equal(how, LINE_FAILED);
    add(j, 2, LINE_DONE, 21); /* the last line counts */
    assert_int_equal(value_of(j, 2), 21);
    journal_close(j);
}

/* At whatever byte a writer died, the lines before are intact, and the next line is added after them. */
static void a_torn_line_is_cut_off(void **state)
{
    (void)state;
    struct journal *j = open_here(stderr);
    add(j, 1, LINE_DONE, 1);
    size_t whole = size_of_file();
    add(j, 2, LINE_DONE, 2);
    size_t all = size_of_file();
    journal_close(j);
    for (size_t size = all - 1; size >= whole; size--) {
        assert_int_equal(truncate("journal", (off_t)size), 0);
        j = open_here(stderr);
        assert_int_equal(value_of(j, 1), 1);
        assert_int_equal(value_of(j, 2), -1);
        add(j, 2, LINE_DONE, 3);
        assert_int_equal(size_of_file(), all);
        journal_close(j);
        j = open_here(stderr);
        assert_int_equal(value_of(j, 2), 3);
        journal_close(j);
    }
}

static void flip(size_t at)
{
    char byte;
    int fd = open("journal", O_RDWR);
    assert_int_equal(pread(fd, &byte, 1, (off_t)at), 1);
    byte ^= 1;
    assert_int_equal(pwrite(fd, &byte, 1, (off_t)at), 1);
    close(fd);
}

/* Whichever byte of a line is changed, the line is named, and the other lines are intact. */
static void damage_is_named_and_costs_its_line(void **state)
{
    (void)state;
    struct journal *j = open_here(stderr);
    add(j, 1, LINE_DONE, 1);
    size_t from = size_of_file();
    add(j, 2, LINE_DONE, 2);
    size_t to = size_of_file();
    add(j, 3, LINE_DONE, 3);
    journal_close(j);
    for (size_t at = from; at < to - 1; at++) {
        char said[4096] = "";
        FILE *notes = fmemopen(said, sizeof said, "w");
        flip(at);
        j = open_here(notes);
        fclose(notes);
        assert_string_equal(said, "./journal:3: this line is damaged: its point counts as not run\n");
        assert_int_equal(value_of(j, 1), 1);
        assert_int_equal(value_of(j, 2), -1);
        assert_int_equal(value_of(j, 3), 3);
        journal_close(j);
        flip(at);
    }
}

static void what_is_no_journal_is_refused(void **state)
{
    static const char *const OTHERS[] = {"something else\n", "something else"};
    (void)state;
    for (int i = 0; i < 2; i++) {
        char *error = NULL, kept[32] = "";
        FILE *f = fopen("journal", "w+");
        fputs(OTHERS[i], f);
        fflush(f);
        assert_null(journal_open(".", stderr, &error));
        assert_string_equal(error,
                            "./journal:1: this is no journal of a study; remove it, or give another folder");
        free(error);
        rewind(f);
        assert_int_equal(fread(kept, 1, sizeof kept - 1, f), strlen(OTHERS[i]));
        assert_string_equal(kept, OTHERS[i]);
        fclose(f);
    }
}

static void many_results_are_found(void **state)
{
    enum { MANY = 5000 };
    char *error = NULL;
    (void)state;
    struct journal *j = open_here(stderr);
    for (int i = 0; i < MANY; i++) {
        json_t *record = json_pack("{s:i}", "value", i);
        assert_true(journal_add(j, key_of(i), LINE_DONE, record, false, &error));
        json_decref(record);
    }
    journal_close(j);
    j = open_here(stderr);
    for (int i = 0; i < MANY; i++)
        assert_int_equal(value_of(j, i), i);
    journal_close(j);
}

/* Each of two writers finds the other's lines, and no line is lost. */
/* Processes that mpirun starts together find no journal: one of them makes it. */
static void a_journal_is_begun_once(void **state)
{
    enum { PROCESSES = 8, TIMES = 50 };
    size_t alone = 0;
    (void)state;
    for (int time = 0; time <= TIMES; time++) {
        int start[2];
        char *error = NULL;
        unlink("journal");
        assert_int_equal(pipe(start), 0);
        for (int i = 0; i < (time ? PROCESSES : 1); i++)
            if (fork() == 0) {
                close(start[1]);
                while (read(start[0], &(char){0}, 1) > 0) /* ends when the parent closes it: all at once */
                    ;
                _exit(journal_open(".", stderr, &error) ? 0 : 1);
            }
        close(start[0]);
        close(start[1]);
        for (int status; wait(&status) > 0;)
            assert_int_equal(status, 0);
        alone = time ? alone : size_of_file();
        assert_int_equal(size_of_file(), alone);
    }
}

static void writers_take_turns(void **state)
{
    enum { EACH = 50 };
    (void)state;
    struct journal *j = open_here(stderr);
    pid_t child = fork();
    if (child == 0) {
        struct journal *mine = open_here(stderr);
        for (int i = 0; i < EACH; i++)
            add(mine, i, LINE_DONE, i);
        _exit(0);
    }
    int status;
    for (int i = EACH; i < 2 * EACH; i++)
        add(j, i, LINE_DONE, i);
    assert_int_equal(waitpid(child, &status, 0), child);
    journal_refresh(j);
    for (int i = 0; i < 2 * EACH; i++)
        assert_int_equal(value_of(j, i), i);
    journal_close(j);
}

static void failures_can_be_forgotten(void **state)
{
    enum journal_line_state how;
    (void)state;
    struct journal *j = open_here(stderr);
    add(j, 1, LINE_FAILED, 1);
    add(j, 2, LINE_DONE, 2);
    journal_forget_failed(j);
    assert_false(journal_find(j, key_of(1), &how));
    assert_true(journal_find(j, key_of(2), &how));
    add(j, 1, LINE_DONE, 3);
    assert_int_equal(value_of(j, 1), 3);
    journal_close(j);
}

/* --- the result cache --- */

static void the_cache_gives_only_what_it_was_given(void **state)
{
    (void)state;
    json_t *inputs = json_pack("{s:i}", "nodes", 4), *others = json_pack("{s:i}", "nodes", 5);
    json_t *record = json_pack("{s:f}", "total_s", 1.5);
    assert_null(result_cache_find("cache", key_of(1), inputs, stderr));
    assert_true(result_cache_add("cache", key_of(1), inputs, record, stderr));
    json_t *found = result_cache_find("cache", key_of(1), inputs, stderr);
    assert_true(json_equal(found, record));
    json_decref(found);
    assert_null(result_cache_find("cache", key_of(2), inputs, stderr));
    assert_null(
        result_cache_find("cache", key_of(1), others, stderr)); /* an equal digest alone is not enough */
    json_decref(inputs);
    json_decref(others);
    json_decref(record);
}

/* --- point locks --- */

/* A child process enters the session and locks point 1: 1 if it could, 0 if not, 2 if the session refused
 * it. */
static int child_claims(const char *session)
{
    int status;
    pid_t child = fork();
    if (child == 0) {
        char *error = NULL;
        struct point_locks *c = point_locks_enter(".", session, &error);
        _exit(c ? point_locks_take(c, key_of(1)) : 2);
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    return WEXITSTATUS(status);
}

static void a_folder_has_one_session(void **state)
{
    char *error = NULL;
    (void)state;
    struct point_locks *c = point_locks_enter(".", "", &error);
    assert_non_null(c);
    assert_int_equal(child_claims(""), 2);
    point_locks_leave(c);
    assert_int_equal(child_claims(""), 1);
    c = point_locks_enter(".", "job 7", &error);
    assert_non_null(c);
    assert_int_equal(child_claims("job 7"), 1);
    assert_int_equal(child_claims("job 8"), 2);
    point_locks_leave(c);
}

/* The child above died without releasing its lock; the system released it. */
static void a_point_is_claimed_once(void **state)
{
    char *error = NULL;
    (void)state;
    struct point_locks *c = point_locks_enter(".", "job 7", &error);
    assert_true(point_locks_take(c, key_of(1)));
    assert_false(point_locks_take(c, key_of(1)));
    assert_int_equal(child_claims("job 7"), 0);
    point_locks_release(c, key_of(1));
    assert_int_equal(child_claims("job 7"), 1);
    assert_true(point_locks_take(c, key_of(1)));
    point_locks_leave(c);
}

/* Each test runs in a folder of its own. */
static int enter(void **state)
{
    struct scratch *s = malloc(sizeof *s);
    *s = scratch_new("test-journal");
    *state = s;
    return s->path && chdir(s->path) == 0 ? 0 : -1;
}

static int leave(void **state)
{
    scratch_remove(*state);
    free(*state);
    return chdir("/");
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, enter, leave)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(what_was_added_is_there_again),
        TEST(a_torn_line_is_cut_off),
        TEST(damage_is_named_and_costs_its_line),
        TEST(what_is_no_journal_is_refused),
        TEST(many_results_are_found),
        TEST(a_journal_is_begun_once),
        TEST(writers_take_turns),
        TEST(failures_can_be_forgotten),
        TEST(the_cache_gives_only_what_it_was_given),
        TEST(a_folder_has_one_session),
        TEST(a_point_is_claimed_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
