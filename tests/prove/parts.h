/* parts.h - functions, in C for nodes, that the operations of ops.def use. A program that `make prove` prints
 * begins with this text. */
#include <errno.h>
#include <fcntl.h>
#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>
#include "nx.h"

enum { IDS = 30, MOST = 30000, ROOMS = 8, MOST_HANDLED = 150, BLOCKS = 40 };

static char out[MOST], in[ROOMS][MOST];
static long id[IDS], ids, handled, rooms, how_of[8], info[8], msgs_left;
static unsigned long long seen = 14695981039346656037ULL;
static volatile double result = 1;
static double row[512];
static volatile int *volatile nowhere = (int *)16;
static char *block[BLOCKS];
static int blocks;

/* One number into which goes all that the program observes. */
static void note(long x)
{
    seen = (seen ^ (unsigned long long)x) * 1099511628211ULL;
}

/* --- what a program finds where it has set nothing ---
 *
 * What the system leaves there must depend on the program alone. Not so what compiled code itself leaves:
 * below a call may lie a register that holds what code counts, or the return address of one of two copies
 * of a loop, and the engine and slices determine both; a jmp_buf may hold the register, too. So after_call()
 * clears the stack, makes one call with handlers masked, and looks at every word; elsewhere a look counts
 * addresses of the computer's, which no program may find. With --profile, compiled code keeps such an
 * address in registers (nxc_path): programs built so do not look. */
enum { LEFT_OUT = 8, AFTER_CALLS = 60, CLEARED = 1000 };
#ifdef PLAYER_PROFILED
enum { LOOKS = 0 };
#else
enum { LOOKS = 1 };
#endif

/* Programs, libraries and stacks of the computer lie at 0x55... and 0x56..., 0x7e... and 0x7f... (Linux's
 * bases, randomised); texts that the operations make have no such sixth letter. No branch depends on a word,
 * so that time does not. */
__attribute__((noinline)) static void count_addresses(void)
{
    const volatile unsigned long *sp = __builtin_frame_address(0);
    long count = 0;
    __asm__("" : "+r"(sp));
    for (long i = LEFT_OUT; i < LEFT_OUT + LOOKS * AFTER_CALLS; i++)
        count += ((sp[-i] >> 40) - 0x55 < 2) | ((sp[-i] >> 40) - 0x7e < 2);
    note(count);
}

__attribute__((noinline)) static void clear_stack(void)
{
    volatile unsigned long *sp = __builtin_frame_address(0);
    __asm__("" : "+r"(sp));
    for (long i = LEFT_OUT; i < CLEARED; i++)
        sp[-i] = 0;
}

__attribute__((noinline)) static void hash_stack(void)
{
    const volatile unsigned long *sp = __builtin_frame_address(0);
    unsigned long sum = 0;
    __asm__("" : "+r"(sp));
    for (long i = LEFT_OUT; i < LEFT_OUT + LOOKS * (CLEARED - 2 * LEFT_OUT); i++)
        sum = (sum ^ sp[-i]) * 1099511628211UL;
    note((long)sum);
}

__attribute__((noinline)) static void after_call(long call, long n)
{
    static char text[100];
    static volatile double x;
    long before = masktrap(1);
    clear_stack();
    switch (call) {
    case 0:
        for (long i = 0; i < 50 * n; i++)
            x = x * 0.5 + 1;
        break;
    case 1:
        iprobe(-1);
        break;
    case 2:
        csend(112, out, n, mynode(), 0);
        break;
    case 3:
        snprintf(text, sizeof text, "%ld %g %Lf", n, 1.0 / (double)n, 1.5L);
        break;
    case 4:
        free(malloc((size_t)n));
        break;
    case 5:
        dclock();
        break;
    case 6:
        getenv("PROVE_WORDS");
        break;
    case 7:
        usleep((unsigned)n % 100);
        break;
    case 8:
        printf("%ld\n", n);
        break;
    default:
        strtod("1.25e3", NULL);
    }
    hash_stack();
    masktrap(before);
}

__attribute__((noinline)) static void never_set(long n)
{
    long x, some[40];
    char text[30];
    if (n > 2)
        x = n;
    some[n] = n;
    text[n] = 'a';
    __asm__("" : "+m"(some), "+m"(text), "+r"(x));
    for (int i = 0; i < 40; i++)
        note(some[i]);
    for (int i = 0; i < 30; i++)
        note(text[i]);
    note(x);
}

static void given_memory(long bytes)
{
    volatile unsigned char *p = malloc((size_t)bytes);
    for (long i = 0; p && i < bytes; i += 1 + bytes / 64)
        note(p[i]);
    free((void *)p);
}

static void told(void)
{
    count_addresses();
    note(infotype());
    note(infocount());
    note(infonode());
    note(infopid());
}

static char *room(void)
{
    return in[rooms++ % ROOMS];
}

/* --- computing, in loops of all kinds: with lookahead and without --- */

static unsigned long grow(unsigned n)
{
    return n < 2 ? n : grow(n - 1) + grow(n - 2);
}

static double small(double x)
{
    return x * 0.75 + 0.125;
}

static double (*volatile by_pointer)(double) = small;

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void series(long n)
{
    double x = result;
    for (long i = 0; i < n; i++)
        x = x * 1.0000001 + 1e-9 * (double)i;
    result = x > 1e6 ? 1 : x;
}

static void rows(long n)
{
    double s = 0;
    for (long y = 0; y < n; y++)
        for (int x = 0; x < 64; x++)
            s += row[x] = row[x] * 0.5 + (double)y;
    result = s > 1e6 ? 1 : s;
}

static void search(long n)
{
    unsigned long x = (unsigned long)n * 2654435761u;
    while (n-- > 0 && (x & 0xffffff))
        x ^= x << 13, x ^= x >> 7, x ^= x << 17;
    note((long)x);
}

static void compute(long kind, long clocks)
{
    switch (kind) {
    case 0:
        series(clocks / 20);
        break;
    case 1:
        rows(clocks / 640);
        break;
    case 2:
        search(clocks / 10);
        break;
    case 3:
        for (long i = 0; i < clocks / 2000; i++)
            note((long)grow(8));
        break;
    case 4:
        for (long i = 0; i < clocks / 100; i++)
            result = sqrt(result + (double)i) + sin(result);
        break;
    case 5:
        for (long i = 0; i < clocks / 30; i++)
            result = by_pointer(result);
        break;
    case 6: {
        long double x = result;
        for (long i = 0; i < clocks / 40; i++)
            x = x * 1.0000001L + 1e-9L;
        result = (double)x > 1e6 ? 1 : (double)x;
        break;
    }
    case 7:
        for (long i = 0; i < clocks / 4000; i++)
            memcpy(in[0], out, (size_t)(i * 97 % 4000));
        break;
    case 8:
        for (int i = 0; i < 100; i++)
            row[i] = (i * 37) % 101;
        for (long i = 0; i < clocks / 20000 + 1; i++)
            qsort(row, 100, sizeof *row, compare);
        break;
    default:
        for (long y = 0; y < clocks / 700; y++)
            for (long x = 0; x <= y % 60; x++)
                result = result * 0.5 + 1;
    }
}

/* --- handlers --- */

enum {
    REPOST = 1,
    COMPUTE = 2,
    ANSWER = 4,
    MASK = 8,
    WAIT = 16,
    CLOCK = 32,
    REPOST_LATE = 64,
    FORCE = 128,
    PROBE = 256,
    SEND_BEHIND = 512,
    POST = 1024,
    LONG_ANSWER = 2048,
    EXIT = 4096,
    KILL = 8192,
    CRASH = 16384
};
#define FORCED_TYPE 1073741824

static void handle(long type, long count, long node, long pid);

static void has_left(long type, long count, long node, long pid)
{
    note(type + 3 * count + 5 * node + 7 * pid);
    msgs_left++;
}

static void has_left_x(long type, long count, long node, long pid, long param)
{
    has_left(type, count, node, pid + param);
}

static long to(long node)
{
    return node < numnodes() ? node : 0;
}

static void react(long type, long count, long node, long how)
{
    told();
    if (++handled > MOST_HANDLED)
        return;
    if (how & REPOST)
        hrecv(type, room(), MOST, handle);
    if (how & COMPUTE)
        compute(count % 10, 40 + count * 7 % 3000);
    if (how & ANSWER)
        csend(112 + type % 4, out, count % 90, to(node), 0);
    if (how & LONG_ANSWER)
        csend(200 + type % 4, out, count * 3 % 9000, to(node), 0);
    if (how & FORCE)
        csend(FORCED_TYPE + 100 + type % 4, out, count % 500, to(node), 0);
    if (how & MASK) {
        long before = masktrap(0);
        compute(0, 500);
        note(masktrap(before));
    }
    if (how & SEND_BEHIND)
        hsend(112 + type % 4, out, count % 300, to(node), 0, has_left);
    if (how & POST && ids < IDS)
        id[ids++] = irecv(204 + type % 4, room(), MOST);
    if (how & WAIT)
        msgwait(isend(112 + type % 4, out, count % 200, to(node), 0));
    if (how & PROBE && iprobe(-1))
        told();
    if (how & CLOCK)
        note((long)(dclock() * 1e12));
    if (how & EXIT && handled > 3)
        exit(3);
    if (how & KILL && handled > 3)
        killproc(to(node), 0);
    if (how & CRASH && handled > 3)
        *nowhere = 1;
    if (how & REPOST_LATE)
        hrecv(type, room(), MOST, handle);
}

static void handle(long type, long count, long node, long pid)
{
    note(pid);
    react(type, count, node, how_of[type % 8]);
}

static void handle_x(long type, long count, long node, long pid, long how)
{
    note(pid);
    react(type, count, node, how & ~(long)(REPOST | REPOST_LATE));
}

static void masked(long kind, long clocks)
{
    note(masktrap(1));
    compute(kind, clocks);
    note(masktrap(0));
}

/* --- ids --- */

static void keep_id(long new)
{
    if (ids < IDS)
        id[ids++] = new;
    else
        msgwait(new);
}

/* Handlers use the list of ids, too: an id is taken off the list before it is used. */
static long take_id(long slot)
{
    long i = slot % ids, taken = id[i];
    id[i] = id[--ids];
    return taken;
}

static void wait_id(long slot)
{
    if (!ids)
        return;
    msgwait(take_id(slot));
    told();
}

static void done_id(long slot)
{
    if (!ids)
        return;
    long taken = take_id(slot);
    if (msgdone(taken))
        told();
    else if (ids < IDS)
        id[ids++] = taken;
    else
        msgcancel(taken);
}

static void merge_ids(long a, long b)
{
    if (ids < 2)
        return;
    long first = take_id(a), second = take_id(b);
    keep_id(msgmerge(first, second));
}

static void send_list(long type, long len, long node, long count)
{
    long list[4];
    for (long i = 0; i < 4; i++)
        list[i] = (node + i * i) % numnodes();
    gsendx(type, out, len, list, count % 5);
}

static void crecv_mask(long type)
{
    long mask = (int)(0x80000000u | 1u << (type + 1) | 1u << (type + 2));
    if (!iprobe(mask))
        return;
    crecv(mask, room(), MOST);
    told();
}

static void await_probe(long type, long times)
{
    for (long i = 0; i < 10 * times && !iprobe(type); i++)
        compute(0, 400);
}

/* --- global operations --- */

static void sum_doubles(long n)
{
    double x[8], work[8];
    for (long i = 0; i < 8; i++)
        x[i] = (double)(mynode() + i);
    gdsum(x, n % 8 + 1, work);
    note((long)x[0]);
}

static void highest(long x)
{
    long work;
    x += mynode();
    gihigh(&x, 1, &work);
    note(x);
}

static void collect(long len)
{
    static char all[64 * 64];
    long total;
    gcol(out, len % 60, all, sizeof all, &total);
    note(total);
}

static void shared_file(long mode, long len, long rounds)
{
    struct stat there;
    if (stat("/cfs", &there))
        return;
    int fd = gopen("/cfs/shared", O_RDWR | O_CREAT, (int)mode, 0644);
    for (long i = 0; i < rounds; i++)
        note(cwrite(fd, out,
                    (unsigned long)(mode == M_RECORD || mode == M_GLOBAL ? len : len + mynode() % 3)));
    if (mode == M_UNIX || mode == M_GLOBAL || mode == M_ASYNC)
        lseek(fd, 0, SEEK_SET);
    for (long i = 0; i < rounds; i++)
        note(cread(fd, room(), (unsigned long)len));
    note(iomode(fd));
    close(fd);
    gsync();
}

/* One call serves all nodes, which make it at different times. */
static void global_file(long len, long kind, long rounds)
{
    struct stat there;
    if (stat("/cfs", &there))
        return;
    int fd = gopen("/cfs/global", O_RDWR | O_CREAT, M_GLOBAL, 0644);
    for (long i = 0; i < rounds; i++) {
        compute(kind, 300 * (mynode() % 7));
        note(cwrite(fd, out, (unsigned long)len));
    }
    lseek(fd, 0, SEEK_SET);
    long id = iread(fd, room(), (unsigned long)len);
    compute(kind, 2000);
    note(read(fd, room(), (size_t)len / 2));
    note(iowait(id));
    close(fd);
    gsync();
}

/* --- files --- */

static int open_file(long name, int flags)
{
    char path[32];
    snprintf(path, sizeof path, "/cfs/f%ld", name);
    return open(path, flags, 0644);
}

static void cfs_write(long name, long len)
{
    int fd = open_file(name, O_RDWR | O_CREAT);
    if (fd < 0)
        return;
    note(lseek(fd, len / 2, SEEK_SET));
    note(cwrite(fd, out, (unsigned long)len));
    close(fd);
}

static void cfs_read(long name, long len)
{
    int fd = open_file(name, O_RDONLY);
    if (fd < 0)
        return;
    long n = cread(fd, room(), (unsigned long)len);
    note(n);
    note(n < len ? iseof(fd) : 0);
    close(fd);
}

static void cfs_later(long name, long len, long kind)
{
    int fd = open_file(name, O_RDWR | O_CREAT);
    if (fd < 0)
        return;
    long reading = iread(fd, room(), (unsigned long)len), writing = iwrite(fd, out, (unsigned long)len / 2);
    compute(kind, 3000);
    if (!iodone(reading))
        note(iowait(reading));
    note(iowait(writing));
    note(lsize(fd, 10, SIZE_END));
    close(fd);
}

static void cfs_at(long name, long len, long kind)
{
    esize_t place = {len * 3, 0}, end = {len * 4, 0};
    int fd = open_file(name, O_RDWR | O_CREAT);
    if (fd < 0)
        return;
    note(writeoff(fd, place, out, (unsigned long)len));
    long reading = ireadoff(fd, place, room(), (unsigned long)len);
    long writing = iwriteoff(fd, end, out, (unsigned long)len / 3);
    compute(kind, 2000);
    note(iowait(reading));
    note(readoff(fd, end, room(), (unsigned long)len));
    note(iowait(writing));
    close(fd);
}

static void cfs_stripes(long name, long factor)
{
    struct sattr stripes;
    struct estatfs fs;
    struct statpfs layout;
    int fd = open_file(name, O_RDWR | O_CREAT);
    if (fd < 0)
        return;
    note(fcntl(fd, F_GETSATTR, &stripes));
    stripes.s_sfactor = (int)factor;
    note(fcntl(fd, F_SETSATTR, &stripes));
    note(fstatpfs(fd, &fs, &layout, sizeof layout));
    note(layout.p_sfactor);
    note(statpfs("/pfs/f0", &fs, &layout, sizeof layout));
    close(fd);
}

static void cfs_stdio(long name, long len)
{
    char path[32];
    snprintf(path, sizeof path, "/cfs/s%ld", name);
    FILE *f = fopen(path, "w+");
    if (!f)
        return;
    fprintf(f, "%ld %ld\n", mynode(), len);
    rewind(f);
    long x = 0;
    note(fscanf(f, "%ld", &x));
    note(x);
    fclose(f);
}

static void cfs_names(long name)
{
    struct stat st;
    char path[32], other[32];
    snprintf(path, sizeof path, "/cfs/f%ld", name);
    snprintf(other, sizeof other, "/cfs/f%ld", name + 1);
    note(stat(path, &st) ? errno : st.st_size);
    note(rename(path, other));
    note(unlink(path));
}

/* --- memory, and ends --- */

static void take_memory(long bytes)
{
    char *p = blocks < BLOCKS ? malloc((size_t)bytes) : NULL;
    note((long)p);
    if (p)
        block[blocks++] = memset(p, 1, bytes < 100 ? (size_t)bytes : 100);
}

static void give_memory(void)
{
    if (blocks)
        free(block[--blocks]);
}

static void crash(long kind, long clocks)
{
    compute(kind, clocks);
    *nowhere = 1;
}

static long exit_kind, exit_clocks;

static void work_at_exit(void)
{
    compute(exit_kind, exit_clocks);
    csend(101, out, 20, (mynode() + 1) % numnodes(), 0);
}

static void at_exit(long kind, long clocks)
{
    exit_kind = kind, exit_clocks = clocks;
    atexit(work_at_exit);
}

/* --- what the system and the C library answer by pointer --- */

static char **arguments;
static int argument_count;

static void note_text(const char *text)
{
    for (; text && *text; text++)
        note(*text);
}

/* Reads an answer, and writes over a character of it, as each node may. */
static void change(char *answer, long at)
{
    note_text(answer);
    if (answer && at < (long)strlen(answer))
        answer[at] = (char)('a' + mynode() % 26);
}

static void split_argument(long which, long pieces)
{
    if (argument_count < 2)
        return;
    char *piece = strtok(arguments[1 + which % (argument_count - 1)], ",");
    for (; piece; piece = pieces-- > 0 ? strtok(NULL, ",") : NULL)
        note_text(piece);
}

static void all_arguments(void)
{
    for (int i = 1; i < argument_count; i++)
        note_text(arguments[i]);
}

static void set_variable(long n)
{
    char text[40];
    snprintf(text, sizeof text, "%ld of node %ld", n, mynode());
    setenv(n % 2 ? "PROVE_WORDS" : "PROVE_MORE", text, n > 1);
    note_text(getenv("PROVE_MORE"));
}

static void time_text(long seconds, long at)
{
    time_t t = seconds * 86400;
    struct tm *tm = gmtime(&t);
    note(tm->tm_yday);
    tm->tm_hour = (int)(mynode() % 24);
    change(asctime(tm), at);
}

static void change_seed(long n)
{
    unsigned short seed[3] = {(unsigned short)n, (unsigned short)mynode(), 3};
    unsigned short *before = seed48(seed);
    note(before[0]);
    before[1] = (unsigned short)n;
    note(lrand48());
}

/* The state of both floating-point units is the node's own: flags of exceptions, how they round. */
static void float_state(long what, long n)
{
    static volatile long double wide = 3;
    static volatile double narrow = 3;
    switch (what % 5) {
    case 0:
        wide = wide * 1e4900L * 1e4900L; /* x87: overflow */
        break;
    case 1:
        narrow = 1 / (narrow - narrow); /* SSE: by zero, or invalid */
        break;
    case 2:
        feclearexcept(FE_ALL_EXCEPT);
        break;
    case 3:
        fesetround(n % 2 ? FE_DOWNWARD : FE_TONEAREST);
        break;
    default:
        wide = narrow = (double)n + 3;
    }
    note(fetestexcept(FE_ALL_EXCEPT));
    note((long)(1e18L / wide) ^ (long)(1e15 / narrow));
}

/* --- in Fortran --- */

#ifdef PLAYER_FORTRAN
void f_note_(const int *x)
{
    note(*x);
}

/* A number as Fortran takes it. */
#define AT(x)                                                                                                \
    &(int)                                                                                                   \
    {                                                                                                        \
        (int)(x)                                                                                             \
    }
void f_send_(const int *type, const int *length, const int *node);
void f_receive_(const int *type);
void f_post_(const int *type, const int *kind, const int *clocks);
void f_clock_(void);
void f_compute_(const int *kind, const int *clocks);
void f_arrays_(const int *kind, const int *n);
void f_text_(const int *kind, const int *n);
void f_characters_(const int *kind, const int *n);
void f_never_set_(const int *n);
#endif

/* --- the host's --- */

#ifdef __NX_HOST__
static int any_loaded;

/* There may be no cube. */
static long some(long node)
{
    return numnodes() ? node % numnodes() : 0;
}

static void host_load(long node, long all)
{
    long r = all == 0 ? _load("player", -1, 0) : _load("player", some(node), 0);
    note(r);
    any_loaded |= r == 0;
}

static void host_getcube(long nodes)
{
    char type[16];
    snprintf(type, sizeof type, "%ld", nodes);
    note(_getcube("c", type, "", 0));
}

static void host_send(long type, long len, long node)
{
    note(_csend(type, out, len, node < 0 ? -1 : some(node), 0));
}

static void host_kill(long node)
{
    note(_killproc(some(node), 0));
}
#endif

/* Called at the end: prints what this node has observed, and its time. */
static void tell(void)
{
    note((long)(result * 1e6));
    printf("node %ld saw %016llx in %ld handlers, %ld left, by %.12f s\n", mynode(), seen, handled, msgs_left,
           dclock());
}
