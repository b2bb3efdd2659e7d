/* Calls of UNIX that programs expect: streams of memory, waiting for files, locks, limits, a program's name.
 * simulator only: what a cluster locks and limits is its own
 * compile: -D_GNU_SOURCE
 * again: --long32
 * run: all
 */
#include <err.h>
#include <errno.h>
#include <error.h>
#include <fcntl.h>
#include <fenv.h>
#include <langinfo.h>
#include <malloc.h>
#include <limits.h>
#include <poll.h>
#define _REGEX_RE_COMP
#include <regex.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/select.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#include <utime.h>
#include "rule.h"

static int growing(void)
{
    char *text;
    size_t size;
    FILE *f = open_memstream(&text, &size);
    int good = f && fflush(f) == 0 && size == 0 && *text == 0 && fileno(f) == -1;
    for (int i = 0; i < 1000; i++)
        fprintf(f, "%03d,", i);
    good = good && fflush(f) == 0 && size == 4000 && !strncmp(text, "000,001,", 8) && text[4000] == 0;
    good = good && ftell(f) == 4000 && fseek(f, 4, SEEK_SET) == 0 && fputs("new", f) >= 0;
    good = good && fclose(f) == 0 && size == 7 && !strncmp(text, "000,new,002", 11);
    free(text); /* of the node's heap */
    return good;
}

static int in_an_array(void)
{
    char array[12] = "one two 33", word[10];
    int number;
    FILE *f = fmemopen(array, strlen(array), "r");
    int good = f && fscanf(f, "%s two %d", word, &number) == 2 && !strcmp(word, "one") && number == 33;
    good = good && getc(f) == EOF && feof(f) && fclose(f) == 0;
    f = fmemopen(array, sizeof array, "w");
    good = good && f && !*array && fputs("0123", f) >= 0 && fflush(f) == 0 && !strcmp(array, "0123");
    good = good && fputs("0123456789", f) >= 0 && fflush(f) == EOF && (fclose(f), 1);
    good = good && !strncmp(array, "012301234567", 12);
    strcpy(array, "ab");
    f = fmemopen(array, sizeof array, "a");
    good = good && f && fputs("cd", f) >= 0 && fclose(f) == 0 && !strcmp(array, "abcd");
    f = fmemopen(NULL, 100, "w+");
    good = good && f && fputs("seven 7", f) >= 0 && (rewind(f), fscanf(f, "%s %d", word, &number)) == 2;
    return good && number == 7 && fclose(f) == 0;
}

static int lines_and_parts(void)
{
    char array[] = "first\nlonger one;rest", *line = NULL, *fields = array, *made;
    size_t room = 0;
    FILE *f = fmemopen(array, strlen(array), "r");
    int good = getline(&line, &room, f) == 6 && getdelim(&line, &room, ';', f) == 11 &&
               !strcmp(line, "longer one;") && getline(&line, &room, f) == 4 && getline(&line, &room, f) < 0;
    fclose(f);
    free(line);
    good = good && !strcmp(strsep(&fields, "\n"), "first") && asprintf(&made, "%d-%s", 5, fields) == 17;
    good = good && !strcmp(made, "5-longer one;rest") && strcasestr(made, "ONE;") == made + 9;
    good = good && memmem(made, 17, "e;r", 3) == made + 11 && strverscmp("a9", "a10") < 0;
    free(made);
    return good && !strcmp(strsignal(SIGSEGV), "Segmentation fault");
}

static int ready(void)
{
    fd_set in, out, other;
    struct timeval none = {0}, some = {0, 20000};
    double before;
    FD_ZERO(&in);
    FD_ZERO(&out);
    FD_ZERO(&other);
    FD_SET(0, &in);
    FD_SET(1, &out);
    FD_SET(0, &other);
    int good = select(2, &in, &out, &other, &none) == 2 && FD_ISSET(0, &in) && FD_ISSET(1, &out);
    good = good && !FD_ISSET(0, &other);
    FD_SET(40, &in);
    good = good && select(41, &in, NULL, NULL, &none) == -1 && errno == EBADF;
    FD_ZERO(&in);
    good = good && select(INT_MAX, &in, NULL, NULL, &none) == 0; /* a set has not so many */
    good = good && select(-1, &in, NULL, NULL, &none) == -1 && errno == EINVAL;
    const struct timespec wrong = {.tv_sec = -1};
    errno = 0;
    good = good && pselect(0, NULL, NULL, NULL, &wrong, NULL) == -1 && errno == EINVAL;
    before = dclock();
    good = good && select(0, NULL, NULL, NULL, &some) == 0 && dclock() - before >= 0.02;
    before = dclock();
    good = good && poll(NULL, 0, 30) == 0 && dclock() - before >= 0.03 && dclock() - before < 0.04;
    struct pollfd files[] = {{0, POLLIN, 7}, {1, POLLOUT, 0}, {50, POLLIN, 0}, {-1, POLLIN, 7}};
    good = good && poll(files, 4, -1) == 3 && files[0].revents == POLLIN && files[1].revents == POLLOUT;
    return good && files[2].revents == POLLNVAL && files[3].revents == 0;
}

/* Each node gets every lock, and at once. */
static int locks(void)
{
    struct flock l = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    int fd = open("/cfs/unix_calls.lock", O_RDWR | O_CREAT, 0600), good = fd >= 0;
    gsync();
    good = good && flock(fd, LOCK_EX) == 0 && fcntl(fd, F_SETLKW, &l) == 0 && lockf(fd, F_LOCK, 0) == 0;
    gsync();
    good = good && fcntl(fd, F_GETLK, &l) == 0 && l.l_type == F_UNLCK && lockf(fd, F_TEST, 10) == 0;
    good = good && lockf(fd, F_ULOCK, 0) == 0 && flock(fd, LOCK_UN | LOCK_NB) == 0 && close(fd) == 0;
    return good && flock(fd, LOCK_SH) == -1 && errno == EBADF && flock(1, 99) == -1 && errno == EINVAL;
}

static int limits(void)
{
    struct rlimit l, less;
    int good = getrlimit(RLIMIT_NOFILE, &l) == 0 && l.rlim_cur == 64 && l.rlim_max == 64;
    less = (struct rlimit){32, 64};
    good = good && setrlimit(RLIMIT_NOFILE, &less) == 0 && getrlimit(RLIMIT_NOFILE, &l) == 0;
    good = good && l.rlim_cur == 32 && getrlimit(RLIMIT_AS, &l) == 0 && l.rlim_cur > 1 << 20;
    good = good && getrlimit(RLIMIT_STACK, &l) == 0 && l.rlim_cur >= 1 << 16 && l.rlim_cur < 1 << 24;
    less = (struct rlimit){1 << 30, RLIM_INFINITY};
    errno = 0;
    return good && setrlimit(RLIMIT_STACK, &less) == -1 && errno == EPERM && getrlimit(99, &l) == -1;
}

/* What warn() and its kin write to stderr. */
static int warnings(void)
{
    char name[40], text[200] = "", expected[200];
    snprintf(name, sizeof name, "unix_calls.tmp%ld", mynode());
    int file = open(name, O_RDWR | O_CREAT | O_TRUNC, 0600), before = dup(2), good = dup2(file, 2) == 2;
    errno = ENOENT;
    warn("file %d", 3);
    warnx("no %s", "reason");
    errno = EINVAL;
    warn(NULL);
    error(0, EACCES, "level %d", 1);
    error(0, 0, "plain");
    error_at_line(0, 0, "in.txt", 7, "odd");
    good = good && dup2(before, 2) == 2 && lseek(file, 0, SEEK_SET) == 0 && read(file, text, 199) > 0;
    const char *name_is = program_invocation_short_name, *whole = program_invocation_name;
    snprintf(expected, sizeof expected,
             "%s: file 3: No such file or directory\n%s: no reason\n%s: Invalid argument\n"
             "%s: level 1: Permission denied\n%s: plain\n%s:in.txt:7: odd\n",
             name_is, name_is, name_is, whole, whole, whole);
    good = good && !strcmp(text, expected) && error_message_count == 3;
    return good && close(file) == 0 && close(before) == 0 && unlink(name) == 0;
}

static int kin(void)
{
    char name[60], folder[60], *options = name, *value, state[64];
    char *const known[] = {"ro", "size", NULL};
    struct stat st;
    struct tm tm = {0};
    struct random_data random = {0};
    volatile size_t many = (size_t)-1;
    int32_t a, b;
    snprintf(name, sizeof name, "unix_calls.kin%ld", mynode());
    int good = close(creat(name, 0600)) == 0 && chmod(name, 0640) == 0 && stat(name, &st) == 0;
    good = good && (st.st_mode & 07777) == 0640 && truncate(name, 77) == 0;
    good = good && utime(name, &(struct utimbuf){1000, 2000}) == 0 && stat(name, &st) == 0;
    good = good && st.st_mtime == 2000 && st.st_size == 77 && unlink(name) == 0 && chmod(name, 0600) == -1;
    snprintf(folder, sizeof folder, "unix_calls.%ld.XXXXXX", mynode());
    good = good && mkdtemp(folder) == folder && rmdir(folder) == 0 && wait(NULL) == -1 && errno == ECHILD;
    strcpy(name, "size=7,ro");
    good = good && getsubopt(&options, known, &value) == 1 && !strcmp(value, "7");
    good = good && strptime("1993-03-02", "%Y-%m-%d", &tm) && tm.tm_yday == 60 && !strptime("5", "%s", &tm);
    good = good && !strcmp(nl_langinfo(RADIXCHAR), ".") && !strcmp(basename("a/b"), "b");
    initstate_r(5, state, sizeof state, &random);
    random_r(&random, &a);
    srandom_r(5, &random);
    random_r(&random, &b);
    return good && a == b && fegetexcept() == 0 && reallocarray(NULL, many, 3) == NULL;
}

/* A copy of the file, in memory of the node's own. */
static int mappings(void)
{
    char name[40], byte, *p, *q;
    struct mallinfo before = mallinfo();
    snprintf(name, sizeof name, "unix_calls.map%ld", mynode());
    int fd = open(name, O_RDWR | O_CREAT | O_TRUNC, 0600), good = ftruncate(fd, 5000) == 0;
    good = good && pwrite(fd, "first", 5, 0) == 5 && pwrite(fd, "second", 6, 4096) == 6;
    p = mmap(NULL, 5000, PROT_READ | PROT_WRITE, MAP_PRIVATE, fd, 0);
    q = mmap(NULL, 100, PROT_READ, MAP_SHARED, fd, 4096);
    good = good && p != MAP_FAILED && !strcmp(p, "first") && !strcmp(q, "second") && p[5001] == 0;
    p[0] = 'F';
    good = good && (long)p % 4096 == 0 && pread(fd, &byte, 1, 0) == 1 && byte == 'f';
    good =
        good && munmap(p, 4096) == -1 && munmap(p, 5000) == 0 && munmap(q, 100) == 0 && munmap(q, 100) == -1;
    p = mmap(NULL, 100, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    good = good && p != MAP_FAILED && p[0] == 0 && p[99] == 0 && munmap(p, 100) == 0;
    if (sizeof(off_t) == 8) {
        good = good && pwrite64(fd, "far", 3, 0x100000000) == 3;
        q = mmap64(NULL, 100, PROT_READ, MAP_PRIVATE, fd, 0x100000000);
        good = good && !strcmp(q, "far") && munmap(q, 100) == 0;
    }
    errno = 0;
    good = good && mmap(NULL, 9, PROT_WRITE, MAP_SHARED, fd, 0) == MAP_FAILED && errno == ENODEV;
    good = good && mmap(NULL, 9, PROT_READ, MAP_PRIVATE, 60, 0) == MAP_FAILED && errno == EBADF;
    good = good && mmap(NULL, -9, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) == MAP_FAILED &&
           errno == ENOMEM;
    return good && close(fd) == 0 && unlink(name) == 0 && mallinfo().uordblks == before.uordblks;
}

static int users(void)
{
    gid_t group;
    errno = 0;
    return setuid(getuid()) == 0 && setuid(0) == -1 && errno == EPERM && setgid(getgid()) == 0 &&
           getgroups(1, &group) == 1 && group == getgid() && setsid() == getpid() && getpgid(0) == getpid();
}

static int one_expression(void)
{
    char *wrong = re_comp("a\\(");
    return wrong && !strcmp(wrong, "Unmatched ( or \\(") && !re_exec("a") && !re_comp("^[ab]*$") &&
           re_exec("abba") && !re_exec("abc") && !re_comp("") && re_exec("");
}

int main(int argc, char **argv)
{
    const char *slash = strrchr(argv[0], '/');
    rule("open_memstream", growing());
    rule("fmemopen", in_an_array());
    rule("lines and parts of texts", lines_and_parts());
    rule("select, poll", ready());
    rule("locks", locks());
    rule("limits", limits());
    rule("warn, warnx, error", warnings());
    rule("mmap", mappings());
    rule("users", users());
    rule("re_comp", one_expression());
    rule("others", kin());
    rule("the program's name", !strcmp(program_invocation_name, argv[0]) &&
                                   !strcmp(program_invocation_short_name, slash ? slash + 1 : argv[0]) &&
                                   argc == 1);
    return 0;
}
