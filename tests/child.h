/* child.h - what a process does that must not survive: runs body(arg) in a child, and returns the child's
 * status, as waitpid() has it. The child writes nothing to standard error, and ends with 0 if body returns.
 */
#ifndef TESTS_CHILD_H
#define TESTS_CHILD_H
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cmocka.h>

static inline int child_status(void (*body)(void *arg), void *arg)
{
    int status;
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        signal(SIGABRT, SIG_DFL);
        close(STDERR_FILENO);
        body(arg);
        _exit(0);
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    return status;
}

static inline bool child_aborts(void (*body)(void *arg), void *arg)
{
    int status = child_status(body, arg);
    return WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT;
}
#endif
