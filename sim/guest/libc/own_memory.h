/* own_memory.h - what a program gets from the system by pointer, in the node's own memory, where each node
 * may write as it likes: its arguments, the environment, and the answers of the C library.
 *
 * errno (kernel/crossing.h) and the arguments lie above the stack, on a page that every node uses. All else
 * lies at the end of the heap's addresses, where malloc never gets to, since the node's memory holds program
 * and stack, too: addresses that malloc gives do not depend on it, and a node that asks for nothing of the
 * kind has no page there. */
#ifndef GUEST_LIBC_OWN_MEMORY_H
#define GUEST_LIBC_OWN_MEMORY_H
#include <stddef.h>

struct node;

struct own_memory {
    char *next, *end; /* free; NULL: nobody has asked */
    char **texts;     /* the node's copies */
    size_t text_count;
};

/* Bytes that errno and the arguments take above the stack. */
size_t own_arguments_bytes(int argc, char *const *argv);
/* Copies the arguments to above n's stack, where span_take() has left room: sets argc and argv. The list ends
 * with two NULL. */
void own_put_arguments(struct node *n, int argc, char *const *argv);

/* Bytes at the end of a heap's addresses that are not malloc's. */
size_t own_memory_bytes(const struct node *n);
/* Zeroed, aligned to 16; NULL: there is no room left. Lasts until the node's end. */
void *own_memory_take(struct node *n, size_t bytes);
/* As own_memory_take(), but ends the program if there is no room. */
void *own_memory_need(struct node *n, size_t bytes);
/* The node's copy of a text, the same for equal texts. Ends the program if there is no room. */
char *own_memory_text(struct node *n, const char *text);
void own_memory_forget(struct own_memory *own);
#endif
