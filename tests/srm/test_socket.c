/* Where the service listens: the path, who may reach it, what is in the way, what a dead service has left. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cmocka.h>
#include "files/scratch.h"
#include "srm/socket.h"

static int enter(void **state)
{
    struct scratch *s = malloc(sizeof *s);
    *s = scratch_new("test-socket");
    *state = s;
    unsetenv("TOUCHSTONE_SRM");
    unsetenv("XDG_RUNTIME_DIR");
    return s->path && chdir(s->path) == 0 ? 0 : -1;
}

static int leave(void **state)
{
    struct scratch *s = *state;
    int r = chdir("/");
    scratch_remove(s);
    free(s);
    return r;
}

/* Of what is wrong; frees it. */
static void says(char *error, const char *text)
{
    assert_non_null(error);
    if (!strstr(error, text))
        fail_msg("'%s' does not say '%s'", error, text);
    free(error);
}

static void is_at(const char *given, const char *expected)
{
    char path[SOCKET_PATH];
    assert_null(socket_path(given, true, path));
    assert_string_equal(path, expected);
}

static void the_path_is_what_is_given_or_the_environment_s(void **state)
{
    (void)state;
    setenv("XDG_RUNTIME_DIR", "/run/user/7", 1);
    is_at(NULL, "/run/user/7/touchstone-srm");
    setenv("TOUCHSTONE_SRM", "", 1);
    is_at(NULL, "/run/user/7/touchstone-srm");
    setenv("TOUCHSTONE_SRM", "/else/where", 1);
    is_at(NULL, "/else/where");
    is_at("given", "given");
}

static void the_path_has_to_fit_an_address(void **state)
{
    char path[SOCKET_PATH], text[SOCKET_PATH + 1];
    (void)state;
    memset(text, 'a', sizeof text);
    text[SOCKET_PATH] = 0;
    says(socket_path(text, false, path), "1 to 107 characters");
    says(socket_path("", false, path), "1 to 107 characters");
    text[SOCKET_PATH - 1] = 0;
    is_at(text, text);
}

/* Anybody could have made the folder in /tmp. (One that is there may be in use, and is left as it is.) */
static void a_folder_in_tmp_is_the_user_s_alone(void **state)
{
    char folder[64], expected[80], path[SOCKET_PATH];
    struct stat st;
    (void)state;
    snprintf(folder, sizeof folder, "/tmp/touchstone-%u", (unsigned)getuid());
    snprintf(expected, sizeof expected, "%s/srm", folder);
    if (lstat(folder, &st) == 0)
        skip();
    assert_null(socket_path(NULL, false, path)); /* a client leaves no folder */
    assert_int_equal(lstat(folder, &st), -1);
    is_at(NULL, expected);
    assert_int_equal(lstat(folder, &st), 0);
    assert_int_equal(st.st_mode & 0777, 0700);
    is_at(NULL, expected);
    chmod(folder, 0710);
    says(socket_path(NULL, true, path), "is not a folder of yours that is closed to others");
    rmdir(folder);
    assert_int_equal(symlink(".", folder), 0);
    says(socket_path(NULL, false, path), "is not a folder of yours that is closed to others");
    unlink(folder);
}

static void only_its_user_reaches_it_whatever_the_umask(void **state)
{
    int fd, lock, client;
    struct stat st;
    (void)state;
    mode_t before = umask(0);
    assert_null(socket_listen("srm", &fd, &lock));
    assert_int_equal(umask(before), 0); /* as it was */
    assert_int_equal(stat("srm", &st), 0);
    assert_int_equal(st.st_mode & 0777, 0600);
    assert_null(socket_connect("srm", &client));
    close(client), close(fd), close(lock);
}

static void one_service_runs_at_a_time(void **state)
{
    char expected[60];
    int fd, lock, other_fd, other_lock;
    (void)state;
    assert_null(socket_listen("srm", &fd, &lock));
    socket_owner(lock);
    snprintf(expected, sizeof expected, "at srm already, process %d: stop it", (int)getpid());
    says(socket_listen("srm", &other_fd, &other_lock), expected);
    assert_null(socket_listen("other", &other_fd, &other_lock));
    close(fd), close(lock), close(other_fd), close(other_lock);
}

/* The lock of a process that has died is free; its socket is there, and nobody answers. */
static void what_a_dead_service_has_left_is_replaced(void **state)
{
    int fd, lock, client;
    (void)state;
    assert_null(socket_listen("srm", &fd, &lock));
    socket_owner(lock);
    close(fd), close(lock);
    says(socket_connect("srm", &client), "no service answers at srm (Connection refused): touchstone srm");
    assert_null(socket_listen("srm", &fd, &lock));
    assert_null(socket_connect("srm", &client));
    close(client), close(fd), close(lock);
    socket_remove("srm");
    assert_int_equal(access("srm", F_OK), -1);
    assert_int_equal(access("srm.lock", F_OK), -1);
    says(socket_connect("srm", &client), "no service answers at srm (No such file or directory)");
}

static void a_file_in_the_way_is_kept(void **state)
{
    int fd, lock;
    (void)state;
    FILE *f = fopen("srm", "w");
    fclose(f);
    says(socket_listen("srm", &fd, &lock), "srm is there, and is no socket: give another --socket");
    assert_int_equal(unlink("srm"), 0);
    assert_null(socket_listen("srm", &fd, &lock)); /* the lock was given back */
    close(fd), close(lock);
}

static void a_folder_that_is_not_there_is_said(void **state)
{
    int fd, lock;
    (void)state;
    says(socket_listen("none/srm", &fd, &lock), "none/srm.lock cannot be opened: No such file or directory");
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, enter, leave)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(the_path_is_what_is_given_or_the_environment_s),
        TEST(the_path_has_to_fit_an_address),
        TEST(a_folder_in_tmp_is_the_user_s_alone),
        TEST(only_its_user_reaches_it_whatever_the_umask),
        TEST(one_service_runs_at_a_time),
        TEST(what_a_dead_service_has_left_is_replaced),
        TEST(a_file_in_the_way_is_kept),
        TEST(a_folder_that_is_not_there_is_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
