/* lab_commands.h - the commands that read results and draw, or start many runs: touchstone executes
 * touchstone-lab for them. As cli/commands.h. */
#ifndef LAB_COMMANDS_LAB_COMMANDS_H
#define LAB_COMMANDS_LAB_COMMANDS_H

int cli_check(int argc, char **argv);
int cli_deadlock(int argc, char **argv);
int cli_explore(int argc, char **argv);
int cli_fit(int argc, char **argv);
int cli_machines(int argc, char **argv);
int cli_page(int argc, char **argv);
int cli_plot(int argc, char **argv);
int cli_profile(int argc, char **argv);
int cli_render(int argc, char **argv);
int cli_sensitivity(int argc, char **argv); /* touchstone run --sensitivity */
int cli_serve(int argc, char **argv);
int cli_study(int argc, char **argv);
int cli_tables(int argc, char **argv);
int cli_trace(int argc, char **argv);

/* touchstone trace's commands; argv[0] is the command's name. */
int cli_trace_info(int argc, char **argv);
int cli_trace_show(int argc, char **argv);
int cli_trace_export(int argc, char **argv);
int cli_trace_why(int argc, char **argv);
#endif
