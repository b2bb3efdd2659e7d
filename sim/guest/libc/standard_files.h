/* standard_files.h - what a node's descriptors 0, 1 and 2 are when its program begins: the run's input and
 * output. A program takes each for a terminal, whatever the simulator's own is: what the program prints, and
 * when, must not depend on how the simulator is run. */
#ifndef GUEST_LIBC_STANDARD_FILES_H
#define GUEST_LIBC_STANDARD_FILES_H
#include "guest/libc/file.h"

struct standard_file {
    struct node_file base;
    int fd; /* output: 1 or 2. Input: the host's descriptor; -1: the node has none */
};

/* The simulator's standard input is node 0's, and the host program's if there is one. */
void standard_input(struct standard_file *f, struct node *n);
/* fd: 1 or 2. What is written to 2 comes behind all that has been written to 1. */
void standard_output(struct standard_file *f, struct node *n, int fd);
#endif
