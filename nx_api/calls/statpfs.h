/* statpfs.h - what fcntl() asks of a file's stripes: pfs/pfs.h. */
#ifndef CALLS_STATPFS_H
#define CALLS_STATPFS_H
#include <stdbool.h>

/* Is it F_GETSATTR, F_SETSATTR or F_PFS_SVR_BUF? */
static inline bool nx_is_of_stripes(int what)
{
    return what >= 0x5001 && what <= 0x5003; /* pfs/pfs.h */
}
/* fcntl() of these. */
int nx_stripes_control(int fd, int what, void *argument);

#endif
