/* temporary.h - folders for files that are there while nxcc runs. */
#ifndef DRIVER_TEMPORARY_H
#define DRIVER_TEMPORARY_H

/* A new folder's path. Does not return if there can be none. */
char *temporary_folder(void);
/* Removes it with all that is in it, whoever has put it there; the path is freed. */
void temporary_remove(char *folder);

#endif
