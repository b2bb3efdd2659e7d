/* client.h - the other end of the service's socket. */
#ifndef SRM_CLIENT_H
#define SRM_CLIENT_H
#include "srm/frame.h"

/* Makes a request of the service at path, and passes on what it answers to standard output and error output. Returns the
 * answer's status; -1 with *error, malloc'd, when there is none. */
int client_ask(const char *path, const struct request *r, char **error);
#endif
