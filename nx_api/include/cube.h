/* cube.h - the name under which iPSC programs include the NX calls. */
#include <nx.h>
