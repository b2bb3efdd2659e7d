/* compiler.h - the compiler that has made a program.
 *
 * A program costs what the instructions cost that its compiler chose; so another version of GCC gives the
 * same source other virtual times. A baseline says by which version its programs were compiled. */
#ifndef LAB_CHECK_COMPILER_H
#define LAB_CHECK_COMPILER_H

/* Such as "GCC 12.2.0", malloc'd; NULL if the program does not say. */
char *compiler_of(const char *program);
#endif
