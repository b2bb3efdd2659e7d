/* client.h - the end of the service's socket at which a user's command is. */
#ifndef SRM_CLIENT_H
#define SRM_CLIENT_H
#include <stdio.h>
#include "srm/frame.h"

/* Makes a request of the service at path, and writes the answer to out and to error output. Returns the
 * status of the answer; -1 with *error set (malloc'd) if there is no answer. */
int client_ask(const char *path, const struct request *r, FILE *out, char **error);
#endif
