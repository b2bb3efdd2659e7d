/* allocsys.h - the header in which the Paragon declares partitions: nx.h has them. */
#include <nx.h>
