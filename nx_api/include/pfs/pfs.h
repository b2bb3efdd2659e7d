/* pfs/pfs.h - the Paragon's Parallel File System: how a file is striped, and what a file system is. nx.h
 * includes it, as the Paragon's did.
 *
 * Names of calls and members as programs use them (ROMIO, Global Arrays' ELIO); where these are silent, a
 * comment says so. The numbers are this header's own.
 */
#ifndef PFS_PFS_H
#define PFS_PFS_H
#include "../nx.h"
#ifdef __cplusplus
extern "C" {
#endif

/* fcntl(fd, F_GETSATTR, &s) and F_SETSATTR: how a file of the machine's file system is striped. F_SETSATTR
 * needs an empty file and the file system's own unit; factor and start are free (silent). EINVAL: another
 * unit, or the file is not empty, or on another file system. */
#define F_GETSATTR 0x5001
#define F_SETSATTR 0x5002
struct sattr {
    int s_sunitsize;  /* bytes that lie together on a disk */
    int s_sfactor;    /* how many disks */
    int s_start_sdir; /* the disk of the first, from 0 */
};
/* fcntl(fd, F_PFS_SVR_BUF, 1 or 0): whether I/O nodes are to buffer. It is accepted, and does nothing: I/O
 * nodes have a cache of cache_blocks (machine file) for all files, or none (silent). */
#define F_PFS_SVR_BUF 0x5003

/* statpfs and fstatpfs fill *fs with what is known of a file's file system, and *stripes, unless it is a null
 * pointer or size is too small, with what is known of the file's stripes. 0, or -1 and errno, with an
 * underscore before the name or without. The simulated file system has all disks' blocks, as if empty; any
 * other file system has 2 GB (silent). */
#define MOUNT_UFS 1
#define MOUNT_NFS 2
#define MOUNT_PFS 10
struct estatfs {
    esize_t f_blocks, f_bfree, f_bavail; /* blocks of f_fsize bytes */
    int f_type;                          /* MOUNT_PFS: the machine's; MOUNT_UFS: another */
    int f_fsize;                         /* 1024 */
    int f_bsize;                         /* the best size of a transfer */
    char f_mntonname[32];                /* "/pfs" or "/" */
};
/* The Paragon's has the stripe directories' names behind these. */
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
