/* folder_names.h - the names in a folder, for programs: in an order that does not depend on this computer. */
#ifndef GUEST_LIBC_FOLDER_NAMES_H
#define GUEST_LIBC_FOLDER_NAMES_H

/* Reads the folder that is open as fd, and closes fd. Returns a text for free(): of each file a byte, 1 more
 * than its DT_... of <dirent.h>, then its name and a 0; the list ends with another 0. "." and ".." are in it,
 * and it is sorted as by strcmp(). NULL with errno if the folder cannot be read, also if fd is negative. */
char *folder_names(int fd);
#endif
