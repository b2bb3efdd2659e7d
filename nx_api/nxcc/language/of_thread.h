/* of_thread.h - the attribute that nxcc defines C++'s thread_local as. A node has one thread and its own copy
 * of all variables, so that such a variable is a plain one; in a function it is static. */
#ifndef NXCC_OF_THREAD_H
#define NXCC_OF_THREAD_H

void of_thread_register(const char *plugin);
#endif
