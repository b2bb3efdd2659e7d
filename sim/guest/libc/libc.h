/* libc.h - the part of the C library that each node has for itself: streams, random numbers, strtok, the
 * program's end. */
#ifndef GUEST_LIBC_H
#define GUEST_LIBC_H
#include <stdint.h>

struct node;
struct node_libc;

/* stdout is line buffered and stderr unbuffered, both write to the run's output. Node 0 and the host program
 * read the simulator's stdin; other nodes' stdin is empty. */

/* The address of the variable that exports.def names by DATA(name); NULL if there is none. */
void *node_libc_data(struct node *n, const char *name);
/* main's third argument: the environment, if the program uses the variable `environ`, as it does when main
 * has three arguments (nx_api/nxcc/language/data_names.cc); otherwise an empty list. */
char **node_libc_envp(struct node *n);
/* On the node's stack: runs the program's atexit functions, latest first, flushes its streams, and fails if
 * its heap is damaged. */
void node_libc_end(struct node *n);
/* On its stack: f runs then, before the functions that were given earlier. */
void node_libc_at_end(struct node *n, void (*f)(void));
void node_libc_flush(struct node *n); /* on the node's stack: flushes its streams */
/* Behind the end of a program that went wrong: writes what it has printed and was to be written later. */
void node_libc_rescue(struct node *n);
void node_libc_free(struct node *n); /* behind the program's end: closes open files, writes nothing */
#endif
