/* pfs/pfs.h - the Paragon's Parallel File System: how a file is striped, and what a file system is. nx.h includes it, as the
 * Paragon's did.
 *
 * Names of calls and members as programs use them (ROMIO, Global Arrays' ELIO); where these are silent, a comment says so. The
 * numbers are this header's own.
 */
#ifndef PFS_PFS_H
#define PFS_PFS_H
#include "../nx.h"
#ifdef __cplusplus
extern "C" {
#endif

/* fcntl(fd, F_GETSATTR, &s) and F_SETSATTR: how a file of the machine's file system is striped. To be set while the file is
 * empty: factor and start as one likes, the unit only to what it is (silent). EINVAL: another, or the file is not empty or not
 * of that file system. */
#define F_GETSATTR 0x5001
#define F_SETSATTR 0x5002
struct sattr {
    int s_sunitsize;  /* bytes that lie together on a disk */
    int s_sfactor;    /* over so many disks */
    int s_start_sdir; /* the disk of the first, from 0 */
};
/* fcntl(fd, F_PFS_SVR_BUF, 1 or 0): whether I/O nodes are to buffer. Accepted, and does nothing: they have a cache of
 * cache_blocks (machine file) for all files, or none (silent). */
#define F_PFS_SVR_BUF 0x5003

/* statpfs and fstatpfs tell of the file system that a file is on; the second structure, unless it is a null pointer or size
 * less than it, of its stripes. 0, or -1 and errno, with an underscore before the name or without. */
#define MOUNT_UFS 1
#define MOUNT_NFS 2
#define MOUNT_PFS 10
struct estatfs {
    esize_t f_blocks, f_bfree,
        f_bavail;         /* of f_fsize bytes; on the simulator all disks, as if they were empty; other files
                                            are on one of 2 GB (silent) */
    int f_type;           /* MOUNT_PFS: the machine's; MOUNT_UFS: another */
    int f_fsize;          /* 1024 */
    int f_bsize;          /* the best size of a transfer */
    char f_mntonname[32]; /* "/pfs" or "/" */
};
/* The real one goes on with the stripe directories' names. */
struct statpfs {
    int p_reclen;    /* bytes of this structure */
    int p_sunitsize; /* of the file; 0: it is not striped */
    int p_sfactor;
};
long statpfs(const char *path, struct estatfs *fs, struct statpfs *stripes, unsigned size);
long fstatpfs(int fd, struct estatfs *fs, struct statpfs *stripes, unsigned size);
long _statpfs(const char *path, struct estatfs *fs, struct statpfs *stripes, unsigned size);
long _fstatpfs(int fd, struct estatfs *fs, struct statpfs *stripes, unsigned size);

#ifdef __cplusplus
}
#endif
#endif
