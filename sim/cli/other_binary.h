/* other_binary.h - the several binaries of which touchstone consists: touchstone simulates,
 * touchstone-reference does so with the reference engine (lp/engine.h), and touchstone-lab has the commands
 * that read results and draw, with the libraries that these need. In a build all are in one folder;
 * installed, those but touchstone are in lib/touchstone. */
#ifndef CLI_OTHER_BINARY_H
#define CLI_OTHER_BINARY_H
#include <stdbool.h>
#include <stddef.h>

/* Writes the path of the calling binary; false, and says so, if it cannot be found. */
bool cli_own_path(char *path, size_t size);
/* Executes another of touchstone's binaries, by its name. Returns an exit status if it cannot be executed. */
int cli_execute(const char *binary, char **argv);
/* Has touchstone-lab run the command argv[1], and tells it by argv[0] which binary simulates. */
int cli_hand_to_lab(char **argv);

bool cli_is_engine(const char *engine); /* fast or reference */
/* Is engine (lp/engine.h) one that this binary does not have? Executes the binary that has it, with main's
 * argv; returns as cli_execute(). */
bool cli_is_other_engine(const char *engine);
int cli_change_engine(const char *engine, char **argv);
#endif
