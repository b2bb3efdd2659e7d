/* sys/estat.h - the Paragon's name for estat.h. */
#include <estat.h>
