/* own_names.c - functions by names that the library or MPI calls in the C library, by names of MPI's own inside, and of its
 * calls: neither NX nor MPI calls these. (Without headers, which would say what they are.) */
long mynode(void);
int gisum(long *x, long n, long *work);
int printf(const char *format, ...);

#define NAME(name)                                                                                           \
    long name(void);                                                                                         \
    long name(void)                                                                                          \
    {                                                                                                        \
        printf("the program's own " #name "\n");                                                             \
        return -1;                                                                                           \
    }

/* the C library's */
NAME(aligned_alloc)
NAME(backtrace)
NAME(clock_gettime)
NAME(connect)
NAME(dl_iterate_phdr)
NAME(fdopen)
NAME(fflush)
NAME(getenv)
NAME(getpid)
NAME(lseek)
NAME(memmove)
NAME(nanosleep)
NAME(on_exit)
NAME(open_memstream)
NAME(poll)
NAME(pthread_create)
NAME(pthread_mutex_lock)
NAME(pthread_sigmask)
NAME(pwrite)
NAME(recv)
NAME(sched_yield)
NAME(send)
NAME(sigaction)
NAME(socket)
NAME(strtod)
NAME(syscall)
NAME(writev)

/* MPI's */
NAME(MPID_Send)
NAME(MPIR_Init)
NAME(MPI_Init_thread)
NAME(MPI_Send)
NAME(PMPI_Sendrecv)
NAME(ompi_mpi_init)
NAME(opal_init)
NAME(opal_progress)
NAME(orte_init)

/* libnx.a's */
NAME(nap)
NAME(progress)
NAME(wire_send)
NAME(node_wait)

/* An allocator of its own, whose blocks the C library must never see. */
void *malloc(unsigned long bytes)
{
    static char all[1 << 20] __attribute__((aligned(16)));
    static unsigned long used;
    void *block = all + used;
    used += (bytes + 15) & ~15ul;
    return used <= sizeof all ? block : 0;
}

void *calloc(unsigned long count, unsigned long bytes)
{
    return malloc(count * bytes);
}

void *realloc(void *old, unsigned long bytes)
{
    (void)old;
    return malloc(bytes);
}

void free(void *block)
{
    (void)block;
}

int main(void)
{
    long sum = mynode(), work;
    char *text = malloc(10);
    gisum(&sum, 1, &work);
    free(text);
    if (mynode() == 0)
        printf("sum %ld\n", sum);
    return 0;
}
