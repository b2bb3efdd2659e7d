/* line_changes.h - the lines in which two texts differ. */
#ifndef LAB_JOBS_LINE_CHANGES_H
#define LAB_JOBS_LINE_CHANGES_H

/* The lines of one text that the other does not have, or not so often: "- line" of the old one, "+ line" of
 * the new one; malloc'd. If the texts have the same lines, says that their order differs. */
char *line_changes(const char *old, const char *new);
#endif
