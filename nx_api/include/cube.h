/* cube.h - the name under which iPSC programs include the NX calls. */
#include <nx.h>

#define FORCE_TYPE 0x40000000 /* added to a type, makes a force type of it */
