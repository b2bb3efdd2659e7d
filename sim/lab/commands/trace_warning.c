/* trace_warning.c - see trace_warning.h. */
#include "lab/commands/trace_warning.h"
#include "cli/say.h"

void cli_trace_warn(const char *command, const struct trace *t, const char *path)
{
    const char *missing = trace_missing_program(t), *program = trace_younger_program(t, path);
    if (missing)
        cli_say_warning(command, "%s cannot be read: no function or line of it is named", missing);
    if (program)
        cli_say_warning(command,
                        "%s is younger than %s: functions and lines are those of the trace only if the "
                        "program was not changed",
                        program, path);
}
