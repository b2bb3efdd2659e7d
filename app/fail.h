/* fail.h - ends the whole program: one message, then all nodes stop. */
#ifndef FAIL_H
#define FAIL_H
#include <stddef.h>

/* Print "model: node N: ..." and end the program on all nodes. */
void fail(const char *format, ...);

/* Memory; fails if there is none. Handlers are masked meanwhile: malloc must not be entered twice. */
void *allocate(size_t bytes);

/* Memory, or NULL; handlers are masked meanwhile. */
void *allocate_if_room(size_t bytes);

#endif
