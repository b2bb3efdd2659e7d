/* opaque.h - functions of which the compiler may use nothing but their declaration: it neither looks into
 * them when it compiles a call, nor changes their arguments. */
#ifndef KERNEL_OPAQUE_H
#define KERNEL_OPAQUE_H

#ifdef __clang__
#define OPAQUE __attribute__((noinline, optnone))
#else
#define OPAQUE __attribute__((noipa))
#endif
#endif
