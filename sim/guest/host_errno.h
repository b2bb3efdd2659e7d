/* host_errno.h - errno of the thread that runs the caller now. A program may go on on another thread after
 * node_leave() or any call that orders it, and compilers take the place of errno to be the same throughout a
 * function. */
#ifndef GUEST_HOST_ERRNO_H
#define GUEST_HOST_ERRNO_H

int node_errno(void);
void node_set_errno(int error);
#endif
