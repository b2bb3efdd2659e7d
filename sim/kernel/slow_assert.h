/* slow_assert.h - assertions that would cost too much in every build: the builds with sanitizers check them.
 */
#ifndef KERNEL_SLOW_ASSERT_H
#define KERNEL_SLOW_ASSERT_H
#include <assert.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define slow_assert(condition) assert(condition)
#else
#define slow_assert(condition) ((void)0)
#endif
#endif
