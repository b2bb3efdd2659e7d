/* of_thread.h - C++'s thread_local, which nxcc defines as an attribute: a node has one thread, and each node a
 * copy of all variables, so that such a variable is a plain one; in a function it is static. */
#ifndef NXCC_OF_THREAD_H
#define NXCC_OF_THREAD_H

void of_thread_register(const char *plugin);
#endif
