/* common_blocks.h - the check of whether the files of a program agree about the sizes of COMMON blocks. */
#ifndef DRIVER_COMMON_BLOCKS_H
#define DRIVER_COMMON_BLOCKS_H

/* Looks at a program that has just been linked. Warns of each COMMON block, or variable of C without a value,
 * that has several sizes: of each size, with the first file that has it. */
void common_blocks_check(const char *program);

#endif
