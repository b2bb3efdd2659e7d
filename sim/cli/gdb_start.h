/* gdb_start.h - starts gdb on a run: touchstone run --gdb. */
#ifndef CLI_GDB_START_H
#define CLI_GDB_START_H

/* Becomes gdb, which runs this program with the same arguments, argv ("touchstone", "run", ...), up to the
 * place where the run stops for it (machine/debug_stop.h). Returns an exit status, after a message, if that
 * is not possible. */
int cli_start_gdb(char **argv);
#endif
