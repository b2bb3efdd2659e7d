/* fuzz.h - what the harnesses share. A harness hands bytes to one parser, as a file if the parser reads
 * files, uses what comes out of it as the simulator does, and frees all. Whatever the bytes are, nothing
 * may crash, leak or hang; and a file that is refused must be named in the message.
 *
 * The same harness is linked with libFuzzer (make fuzz), which makes bytes up, and with replay.c (make
 * test), which reads the files of corpus/NAME. */
#ifndef FUZZ_H
#define FUZZ_H
#include <stddef.h>
#include <stdint.h>

/* The harness. libFuzzer gave it this name; it returns 0. */
int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

/* A folder of this process, made when first asked for and removed at its end. */
const char *fuzz_folder(void);
/* The path of a file of that name in the folder, malloc'd. */
char *fuzz_path(const char *name);
/* Writes the file of that name in the folder. */
void fuzz_file(const char *name, const void *bytes, size_t size);

/* A parser has refused a file: its message must begin with the path. Frees the message. */
void fuzz_refused(char *error, const char *path);

/* The bytes in two: up to the line "----" and behind it. Returns the size of the first; *rest is NULL if
 * there is no such line. */
size_t fuzz_cut(const uint8_t *bytes, size_t size, const uint8_t **rest, size_t *rest_size);
#endif
