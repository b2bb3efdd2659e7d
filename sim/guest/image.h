/* image.h - a node program: an ELF file built by nxcc, read once and mapped into every node. Text and
 * constants are mapped from the file and shared; data are private to each node; undefined symbols are
 * resolved against exports.def and nothing else. Error messages name the file and what to do. */
#ifndef GUEST_IMAGE_H
#define GUEST_IMAGE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct node;
struct elf_file;
struct node_image;

/* Reads and checks a program. Returns NULL and sets *error (malloc'd) if nxcc has not built the file. The
 * caller closes the program behind the last node that runs it. */
struct node_image *node_image_open(const char *path, char **error);
void node_image_close(struct node_image *img);
const char *node_image_path(const struct node_image *img);
/* Bytes that loading brings to a node: text, constants and initialised data. */
size_t node_image_load_bytes(const struct node_image *img);
/* Does the program use a function of that name? */
bool node_image_uses(const struct node_image *img, const char *name);

/* The offset from the program's start at which the data begin, page rounded. The data end with the program.
 */
size_t node_image_data_at(const struct node_image *img);
/* Has the program's long 32 bits? */
bool node_image_is_long32(const struct node_image *img);
/* Does it use the variable `environ`? */
bool node_image_uses_environ(const struct node_image *img);
/* Does it know the address of errno (kernel/crossing.h)? */
bool node_image_has_errno(const struct node_image *img);
/* The name of the first costs file, other than cpu, that files of the program were compiled with; NULL: all
 * were compiled with cpu, or nothing is known. The caller frees it. */
char *node_image_other_costs(const struct node_image *img, const char *cpu);
/* Was it built with --asan? */
bool node_image_is_asan(const struct node_image *img);
/* Bytes of text, data and bss in a node, page rounded. */
size_t node_image_bytes(const struct node_image *img);

/* The address of a node's own variable that exports.def names by DATA (node_libc_data). */
typedef void *node_own_data(struct node *n, const char *name);
/* Maps or copies the program to n->guest.program, relocates it and sets image, image_bytes, file and data of
 * n->guest. Returns false with *error set (malloc'd) on failure. */
bool node_image_map(const struct node_image *img, struct node *n, node_own_data *own_data, char **error);

/* Names the program's message layer (guest/layer.h), whose patterns last as long as the image. */
void node_image_set_layer(struct node_image *img, char *const *layer);
char *const *node_image_layer(const struct node_image *img);

/* Its file. */
const struct elf_file *node_image_elf(const struct node_image *img);

/* The offset from the program's start at which the function around an offset begins; the offset itself if
 * no function is known. */
size_t node_image_function(const struct node_image *img, size_t offset);

/* Its name; NULL if no function is known. */
const char *node_image_function_name(const struct node_image *img, size_t offset);

/* Writes the name of the function at an offset from the program's start, such as "pack+0x1c", and
 * "FILE:LINE" if the program was built with -g. Writes at most size bytes; returns buf. */
const char *node_image_where(const struct node_image *img, size_t offset, char *buf, size_t size);
/* Writes "FILE:LINE" of an offset. Returns false if the line is not known, or is in NX's library. */
bool node_image_line(const struct node_image *img, size_t offset, char *buf, size_t size);
/* Is the line in MPI's library? */
bool node_image_in_mpi(const struct node_image *img, size_t offset);
/* Is it in the libraries of NX, of C or of MPI? */
bool node_image_in_library(const struct node_image *img, size_t offset);
/* Finds the line of the frame that reports name at an offset (guest/layer.h), as node_image_line() does.
 * Returns false, too, if all frames there are of the program's message layer. */
bool node_image_line_outside(const struct node_image *img, size_t offset, char *buf, size_t size);
#endif
