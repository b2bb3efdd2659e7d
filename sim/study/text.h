/* text.h - malloc'd text from a format; never NULL: without memory for a line of text there is nothing to go on with. */
#ifndef STUDY_TEXT_H
#define STUDY_TEXT_H

char *text_of(const char *format, ...) __attribute__((format(printf, 1, 2)));
#endif
