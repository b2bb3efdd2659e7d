/* socket.h - the socket at which the service listens: a unix socket that only its user may reach, and a
 * lock file by which a service that runs is told from one that has died.
 *
 *     PATH         the socket, mode 0600
 *     PATH.lock    held locked as long as the service lives; contains its process number
 */
#ifndef SRM_SOCKET_H
#define SRM_SOCKET_H
#include <stdbool.h>

enum { SOCKET_PATH = 108 }; /* as long as an address may be */

/* Writes the socket's path: given, else $TOUCHSTONE_SRM, else $XDG_RUNTIME_DIR/touchstone-srm, else
 * /tmp/touchstone-UID/srm, whose folder is made if a service is to listen there. Returns NULL, or what is
 * wrong (malloc'd). */
char *socket_path(const char *given, bool to_listen, char path[SOCKET_PATH]);

/* Listens, and sets the descriptors of socket and lock. Replaces what a dead service has left. Returns NULL,
 * or what is wrong (malloc'd). */
char *socket_listen(const char *path, int *fd, int *lock);
/* Writes the process number of the caller, which is the service, into the lock. */
void socket_owner(int lock);
/* Removes them, and the folder that was made for them. */
void socket_remove(const char *path);
/* Returns NULL, or what is wrong (malloc'd). */
char *socket_connect(const char *path, int *fd);
#endif
