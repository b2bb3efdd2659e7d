/* mesh.h - the name under which programs for the Delta include the NX calls. */
#include <nx.h>
