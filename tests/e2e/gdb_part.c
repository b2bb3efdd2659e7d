/* gdb_part.c - the part of gdb.c in another file: each node has its own of this. */
long rounds_done;
