/* bells.c - see bells.h. The nodes of a computer share a file of memory, of a page for each. A node maps
 * its own over the page of its program that has nxc_due and nothing else. */
#include "nx_api/mpi/bells.h"
#include <fcntl.h>
#include <linux/futex.h>
#include <mpi.h>
#include <pthread.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

enum { PAGE = 4096, NAME = 64 };

static _Alignas(PAGE) union {
    struct bell bell;
    char page[PAGE];
} own;
/* Programs are linked with it by this name. */
__asm__(".globl nxc_due\n.set nxc_due, own");
struct bell **bells;

/* A child of fork is no node: its polls do not look at its parent's page. */
static void leave_in_child(void)
{
    mmap(&own, PAGE, PROT_READ | PROT_WRITE, MAP_FIXED | MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
}

/* The file, which the first node makes; -1: some node cannot have it. */
static int open_together(MPI_Comm here, int rank, int count)
{
    char name[NAME];
    int fd = -1, least;
    snprintf(name, sizeof name, "/nx-%ld", (long)getpid());
    if (rank == 0) {
        fd = shm_open(name, O_RDWR | O_CREAT | O_EXCL, 0600);
        if (fd >= 0 && ftruncate(fd, (off_t)count * PAGE) != 0) {
            close(fd);
            fd = -1;
        }
    }
    MPI_Bcast(name, sizeof name, MPI_BYTE, 0, here);
    if (rank != 0)
        fd = shm_open(name, O_RDWR, 0);
    MPI_Allreduce(&fd, &least, 1, MPI_INT, MPI_MIN, here);
    if (rank == 0 && fd >= 0)
        shm_unlink(name);
    if (least < 0 && fd >= 0)
        close(fd);
    return least < 0 ? -1 : fd;
}

/* Maps the file, and the own page once more. NULL: it cannot be mapped. */
static char *map(int fd, int rank, int count)
{
    char *all = mmap(NULL, (size_t)count * PAGE, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
    if (all == MAP_FAILED)
        return NULL;
    if (mmap(&own, PAGE, PROT_READ | PROT_WRITE, MAP_FIXED | MAP_SHARED, fd, (off_t)rank * PAGE) ==
        MAP_FAILED)
        return NULL;
    pthread_atfork(NULL, NULL, leave_in_child);
    return all;
}

/* Notes the pages of the nodes of this computer. */
static void note_pages(const struct node *n, MPI_Comm here, int count, char *all)
{
    int *ids = calloc((size_t)count, sizeof *ids), id = (int)n->id;
    if (!ids)
        node_fail(node_self(), "out of memory");
    MPI_Allgather(&id, 1, MPI_INT, ids, 1, MPI_INT, here);
    for (int i = 0; i < count; i++)
        bells[ids[i]] = (struct bell *)(all + (size_t)i * PAGE);
    free(ids);
}

bool bells_begin(const struct node *n)
{
    MPI_Comm here;
    int rank, count, fd;
    bells = calloc(n->sys->count, sizeof(struct bell *));
    if (!bells)
        node_fail(node_self(), "out of memory");
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
    MPI_Comm_rank(here, &rank);
    MPI_Comm_size(here, &count);
    fd = open_together(here, rank, count);
    char *all = fd < 0 ? NULL : map(fd, rank, count);
    int can = all != NULL, all_can;
    MPI_Allreduce(&can, &all_can, 1, MPI_INT, MPI_MIN, here);
    if (all_can)
        note_pages(n, here, count, all);
    if (fd >= 0)
        close(fd);
    MPI_Comm_free(&here);
    return all_can && (uint32_t)count == n->sys->count;
}

void bell_want(void)
{
    atomic_fetch_or(&own.bell.wanted, BELL_RINGS);
}

bool bell_take(void)
{
    return atomic_exchange(&own.bell.due, 0);
}

void bell_sleep(long ns)
{
    if (bell_take())
        return;
    atomic_fetch_or(&own.bell.wanted, BELL_WAKES);
    syscall(SYS_futex, &own.bell.due, FUTEX_WAIT, 0, &(struct timespec){.tv_nsec = ns}, NULL, 0);
    atomic_fetch_and(&own.bell.wanted, ~BELL_WAKES);
}

void bell_ring_now(struct bell *b, int wanted)
{
    atomic_store_explicit(&b->due, 1, memory_order_release);
    if (wanted & BELL_WAKES)
        syscall(SYS_futex, &b->due, FUTEX_WAKE, 1, NULL, NULL, 0);
}

void bell_ring_here(void)
{
    bell_ring_now(&own.bell, BELL_WAKES);
}
