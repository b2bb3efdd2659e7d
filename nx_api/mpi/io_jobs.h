/* io_jobs.h - reads and writes that go on while the program computes (iread, iwrite). Each file that has
 * any gets a thread, which does the file's jobs one after the other; so one that waits for its input holds
 * up no other file. Such a thread calls the system and nothing else: no MPI, no handler.
 *
 * A job may be at the file's pointer, and the pointer is where it should be only when all jobs are done. So
 * all else that is done with the file waits for its jobs first (io_settle): the results are those of jobs
 * that are done at once. */
#ifndef MPI_IO_JOBS_H
#define MPI_IO_JOBS_H
#include <stdbool.h>
#include <stdint.h>
#include <sys/uio.h>

/* Moves bytes at an offset, or if it is negative at the file's own pointer. The bytes moved; -1 and errno if
 * none could be, or not all could be written: few programs look whether a write was complete, and a full
 * disk must not cost them their results. */
long io_move(bool write, int fd, int64_t offset, const struct iovec *parts, int count);

struct io_job;

/* Begins to do the same. Bytes to be written are copied. NULL and errno: there is no room. */
struct io_job *io_begin(bool write, int fd, int64_t offset, const struct iovec *parts, int count);
bool io_is_done(const struct io_job *job);
/* What io_move would have returned, and errno. Frees the job, which is done. */
long io_end(struct io_job *job);

/* Waits till all jobs of a file are done. */
void io_settle(int fd);
/* For the program's end: till all is written. */
void io_settle_all(void);
#endif
