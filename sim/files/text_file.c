/* text_file.c - see text_file.h. */
#include "files/text_file.h"
#include "kernel/xalloc.h"
#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { FIRST_ROOM = 4096 };

size_t text_character(const char *text)
{
    const unsigned char *s = (const unsigned char *)text;
    if (*s < 0x80)
        return *s ? 1 : 0;
    size_t length = *s >= 0xc2 && *s < 0xe0 ? 2 : (*s & 0xf0) == 0xe0 ? 3 : *s >= 0xf0 && *s < 0xf5 ? 4 : 0;
    for (size_t i = 1; i < length; i++)
        if ((s[i] & 0xc0) != 0x80)
            return 0;
    bool too_long = (*s == 0xe0 && s[1] < 0xa0) || (*s == 0xf0 && s[1] < 0x90);
    bool beyond = (*s == 0xed && s[1] >= 0xa0) || (*s == 0xf4 && s[1] >= 0x90);
    return too_long || beyond ? 0 : length;
}

/* The line of the first byte that is not UTF-8 text; 0 if there is none. */
static int line_without_text(const char *text, size_t bytes)
{
    int line = 1;
    for (const char *s = text, *end = text + bytes; s < end;) {
        size_t n = text_character(s);
        if (!n)
            return line;
        line += *s == '\n';
        s += n;
    }
    return 0;
}

/* Reads on to the file's end, or until there are more bytes than `most`. Returns how many; -1 with
 * errno. *text grows with them, and has room for one more. */
static ssize_t read_up_to(int fd, char **text, size_t most)
{
    size_t done = 0, room = 0;
    for (;;) {
        if (done + 1 >= room)
            *text = xrealloc(*text, room = room ? 2 * room : FIRST_ROOM);
        ssize_t n = read(fd, *text + done, room - 1 - done);
        if (n < 0 && errno == EINTR)
            continue;
        if (n < 0)
            return -1;
        done += (size_t)n;
        if (n == 0 || done > most)
            return (ssize_t)done;
    }
}

static void drop_mark(char *text)
{
    enum { MARK = sizeof TEXT_BYTE_ORDER_MARK - 1 };
    if (strncmp(text, TEXT_BYTE_ORDER_MARK, MARK) == 0)
        memmove(text, text + MARK, strlen(text + MARK) + 1);
}

static char *read_text(int fd, size_t most, const char **why, int *line)
{
    char *text = NULL;
    ssize_t bytes = read_up_to(fd, &text, most);
    *why = bytes < 0 ? strerror(errno) : (size_t)bytes > most ? "it is larger than such files are" : NULL;
    if (!*why) {
        text[bytes] = 0;
        *line = line_without_text(text, (size_t)bytes);
        *why = *line ? "a byte that is not UTF-8 text" : NULL;
    }
    if (!*why) {
        drop_mark(text);
        return text;
    }
    free(text);
    return NULL;
}

char *text_file_read(const char *path, size_t most, const char **why, int *line)
{
    struct stat st;
    *line = 0;
    int fd = open(path, O_RDONLY | O_CLOEXEC);
    if (fd < 0 || fstat(fd, &st)) {
        *why = strerror(errno);
        return NULL;
    }
    char *text = NULL;
    if (S_ISDIR(st.st_mode))
        *why = "it is a folder";
    else
        text = read_text(fd, most, why, line);
    close(fd);
    return text;
}

size_t text_cut(const char *text, size_t most)
{
    size_t length = strnlen(text, most);
    while (length && (text[length] & 0xc0) == 0x80)
        length--;
    return length;
}
