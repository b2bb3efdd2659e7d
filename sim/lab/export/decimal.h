/* decimal.h - virtual times as decimal numbers that keep each picosecond. */
#ifndef LAB_EXPORT_DECIMAL_H
#define LAB_EXPORT_DECIMAL_H
#include <inttypes.h>
#include "kernel/vtime.h"

/* For printf: "%" PRI_SECONDS with the arguments SECONDS(t), "1.000000000001". */
#define PRI_SECONDS PRIu64 ".%012" PRIu64
#define SECONDS(t) (t) / VT_SECOND, (t) % VT_SECOND
/* Microseconds: "1000000.000001". */
#define PRI_MICROSECONDS PRIu64 ".%06" PRIu64
#define MICROSECONDS(t) (t) / VT_MICROSECOND, (t) % VT_MICROSECOND
#endif
