/* socket.h - where the service listens: a unix socket that only its user may reach, and a lock beside it that tells a
 * service that runs from one that has died.
 *
 *     PATH         the socket, mode 0600
 *     PATH.lock    held locked as long as the service lives; has its process number in it
 */
#ifndef SRM_SOCKET_H
#define SRM_SOCKET_H
#include <stdbool.h>

enum { SOCKET_PATH = 108 }; /* as long as an address may be */

/* given, else $TOUCHSTONE_SRM, else $XDG_RUNTIME_DIR/touchstone-srm, else /tmp/touchstone-UID/srm. NULL, or what is
 * wrong, malloc'd. */
char *socket_path(const char *given, char path[SOCKET_PATH]);

/* Listens: the descriptors of socket and lock. What a dead service has left is replaced. NULL, or what is wrong. */
char *socket_listen(const char *path, int *fd, int *lock);
/* Writes the caller's process number into the lock: it is the one that serves. */
void socket_owner(int lock);
void socket_remove(const char *path);
/* NULL, or what is wrong. */
char *socket_connect(const char *path, int *fd);
#endif
