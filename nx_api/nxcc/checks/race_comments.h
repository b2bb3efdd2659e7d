/* race_comments.h - the comments of a source file that say that an access is no race: "nxcc: race-ok". */
#ifndef NXCC_RACE_COMMENTS_H
#define NXCC_RACE_COMMENTS_H

/* Has the line of a file such a comment, or is the line before it nothing but one? False if the file cannot
 * be read. */
bool race_comments_say_ok(const char *file, int line);
#endif
