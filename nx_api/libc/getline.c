/* getline.c - lines of any length, in memory that grows. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>

/* What the header's getline calls, too. */
ssize_t __getdelim(char **line, size_t *size, int end, FILE *file)
{
    ssize_t length = 0;
    int c;
    if (!line || !size) {
        errno = EINVAL;
        return -1;
    }
    do {
        if (!*line || (size_t)length + 2 > *size) {
            size_t more = *line && *size >= 60 ? 2 * *size : 120;
            char *longer = realloc(*line, more);
            if (!longer)
                return -1;
            *line = longer;
            *size = more;
        }
        c = getc(file);
        if (c != EOF)
            (*line)[length++] = (char)c;
    } while (c != EOF && c != end);
    (*line)[length] = 0;
    return length ? length : -1;
}

ssize_t getdelim(char **line, size_t *size, int end, FILE *file)
{
    return __getdelim(line, size, end, file);
}

ssize_t getline(char **line, size_t *size, FILE *file)
{
    return __getdelim(line, size, '\n', file);
}
