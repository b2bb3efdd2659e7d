/* host_errno.h - errno of the thread that runs the caller now. After node_leave(), or any call that commits
 * in the total order, a program may resume on another thread; but a compiler assumes that errno has one
 * address throughout a function. */
#ifndef GUEST_LIBC_HOST_ERRNO_H
#define GUEST_LIBC_HOST_ERRNO_H

int node_errno(void);
void node_set_errno(int error);
#endif
