/* left_over.h - files and folders that killed processes leave. A process keeps what it makes under a
 * temporary name locked (flock) for as long as it lives; what is there, unlocked, is left over. */
#ifndef FILES_LEFT_OVER_H
#define FILES_LEFT_OVER_H
#include <stdbool.h>

/* Locks a file or folder; how: flock's. Returns what to close; -1 if that cannot be, as another process has
 * the lock, or the file system has no locks. */
int left_over_lock(const char *path, int how);
/* Has what was locked still that path? Between its making and its locking another process may have taken it
 * for left over, and removed it. */
bool left_over_is_there(const char *path, int fd);

/* Removes a file, or a folder and everything in it. */
void left_over_remove(const char *path);
/* Removes this user's entries of a folder that are so named, and that no process has locked. */
void left_over_remove_all(const char *folder, bool (*is_named)(const char *entry, const void *ctx),
                          const void *ctx);
#endif
