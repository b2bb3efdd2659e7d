/* zlib's calls read packed files, plain ones, and ones that are damaged. The program packs by itself: in
 * blocks that are stored as they are.
 * compile: -Wl,--no-as-needed -lz
 * run: -m ipsc860 -n 2
 * run: -m paragon -n 1
 */
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <zlib.h>
#include "rule.h"

#ifndef FOLDER
#define FOLDER ""
#endif

enum { BYTES = 30000, BLOCK = 9000 }; /* more than any buffer, and no multiple of a block */

static char name[60], data[BYTES], got[2 * BYTES + 1];

static void put(FILE *f, unsigned long number, int bytes)
{
    for (; bytes > 0; bytes--, number >>= 8)
        putc((int)(number & 255), f);
}

static unsigned long check_sum(const char *p, int bytes)
{
    unsigned long sum = 0xffffffff;
    for (; bytes > 0; bytes--) {
        sum ^= (unsigned char)*p++;
        for (int bit = 0; bit < 8; bit++)
            sum = sum >> 1 ^ (sum & 1 ? 0xedb88320 : 0);
    }
    return sum ^ 0xffffffff;
}

static void put_member(FILE *f, const char *p, int bytes)
{
    put(f, 0x00088b1f, 4);
    put(f, 0, 6);
    for (int at = 0; at < bytes; at += BLOCK) {
        int part = bytes - at < BLOCK ? bytes - at : BLOCK;
        put(f, at + part == bytes, 1);
        put(f, (unsigned long)(part | (~part & 0xffff) << 16), 4);
        fwrite(p + at, 1, (size_t)part, f);
    }
    put(f, check_sum(p, bytes), 4);
    put(f, (unsigned long)bytes, 4);
}

static gzFile packed(int members, const char *behind)
{
    FILE *f = fopen(name, "wb");
    for (int i = 0; i < members; i++)
        put_member(f, data, BYTES);
    fputs(behind, f);
    fclose(f);
    return gzopen(name, "rb");
}

static gzFile plain(const char *text)
{
    FILE *f = fopen(name, "wb");
    fputs(text, f);
    fclose(f);
    return gzopen(name, "rb");
}

/* Reads pieces until there are no more; returns what the last read did. */
static int read_all(gzFile f, int piece, int *bytes)
{
    int n;
    *bytes = 0;
    while (*bytes < (int)sizeof got && (n = gzread(f, got + *bytes, (unsigned)piece)) > 0)
        *bytes += n;
    return n;
}

static int closes(gzFile f, int holds)
{
    return gzclose(f) == Z_OK && holds;
}

static int pieces(int piece)
{
    gzFile f = packed(1, "");
    int bytes, last = read_all(f, piece, &bytes);
    return closes(f, last == 0 && bytes == BYTES && memcmp(got, data, BYTES) == 0 && gzeof(f));
}

static int end_of_file(void)
{
    gzFile f = packed(1, "");
    int holds = gzread(f, got, BYTES) == BYTES && !gzeof(f);
    holds = holds && gzread(f, got, 1) == 0 && gzeof(f);
    return closes(f, holds && gzseek(f, 0, SEEK_SET) == 0 && !gzeof(f));
}

static int at_place(gzFile f, long offset, int whence, long place)
{
    return gzseek(f, offset, whence) == place && gzread(f, got, 10) == 10 &&
           memcmp(got, data + place, 10) == 0;
}

static int places(gzFile f)
{
    int holds = at_place(f, 25000, SEEK_SET, 25000) && at_place(f, -10010, SEEK_CUR, 15000) &&
                at_place(f, 90, SEEK_CUR, 15100) && at_place(f, 0, SEEK_SET, 0);
    return closes(f, holds && gzseek(f, -1, SEEK_SET) == -1 && gzseek(f, -11, SEEK_CUR) == -1 &&
                         gzseek(f, 0, SEEK_END) == -1 && gzread(f, got, 10) == 10 &&
                         memcmp(got, data + 10, 10) == 0);
}

static int beyond_the_end(void)
{
    gzFile f = packed(1, "");
    return closes(f, gzseek(f, 2 * BYTES, SEEK_SET) == 2 * BYTES && gzread(f, got, 10) == 0 && gzeof(f) &&
                         at_place(f, 5, SEEK_SET, 5));
}

static int members(const char *behind)
{
    gzFile f = packed(2, behind);
    int bytes, last = read_all(f, 4096, &bytes);
    return closes(f, last == 0 && bytes == 2 * BYTES && memcmp(got, data, BYTES) == 0 &&
                         memcmp(got + BYTES, data, BYTES) == 0);
}

/* The second member's first byte is the last of the first 8192. */
static int between_buffers(void)
{
    enum { FIRST = 8191 - 18 - 5 };
    int bytes;
    FILE *f = fopen(name, "wb");
    put_member(f, data, FIRST);
    put_member(f, data, BYTES);
    fclose(f);
    gzFile g = gzopen(name, "rb");
    return closes(g, read_all(g, 1000, &bytes) == 0 && bytes == FIRST + BYTES &&
                         memcmp(got + FIRST, data, BYTES) == 0);
}

/* The file with one byte of the data changed. */
static int damaged(void)
{
    int bytes, number;
    gzclose(packed(1, ""));
    FILE *f = fopen(name, "r+b");
    fseek(f, 20000, SEEK_SET);
    putc('!', f);
    fclose(f);
    gzFile g = gzopen(name, "rb");
    int last = read_all(g, 1000, &bytes);
    const char *text = gzerror(g, &number);
    return closes(g, last == -1 && number == Z_DATA_ERROR && *text && gzread(g, got, 1) == -1);
}

/* The first bytes of a file. What there is can be read; closing it says that there was to be more. */
static int cut(void)
{
    int bytes, number;
    gzclose(packed(1, ""));
    FILE *f = fopen(name, "rb"), *g;
    size_t n = fread(got, 1, 15000, f);
    fclose(f);
    g = fopen(name, "wb");
    fwrite(got, 1, n, g);
    fclose(g);
    gzFile z = gzopen(name, "rb");
    int last = read_all(z, 1000, &bytes);
    gzerror(z, &number);
    return last == 0 && bytes > 14000 && memcmp(got, data, (size_t)bytes) == 0 && number == Z_BUF_ERROR &&
           gzclose(z) == Z_BUF_ERROR;
}

static int as_it_is(const char *text)
{
    gzFile f = plain(text);
    int bytes, last = read_all(f, 7, &bytes), holds = last == 0 && gzeof(f);
    holds = holds && bytes == (int)strlen(text) && memcmp(got, text, (size_t)bytes) == 0;
    holds = holds && gzseek(f, 0, SEEK_SET) == 0 && gzread(f, got, 4) == (bytes < 4 ? bytes : 4);
    return closes(f, holds && memcmp(got, text, bytes < 4 ? (size_t)bytes : 4) == 0);
}

/* A thousand open files would fill the memory of a node. */
static int gives_back(void)
{
    gzclose(packed(1, ""));
    for (int i = 0; i < 1000; i++) {
        gzFile f = gzopen(name, "rb");
        if (!f || gzread(f, got, 10) != 10 || gzclose(f) != Z_OK)
            return 0;
    }
    return 1;
}

static int missing(void)
{
    unlink(name);
    return !gzopen(name, "rb") && errno == ENOENT;
}

int main(void)
{
    for (int i = 0; i < BYTES; i++)
        data[i] = (char)(i * 7 + i / 251);
    snprintf(name, sizeof name, FOLDER "gzip.tmp%ld", mynode());
    rule("large pieces", pieces(BYTES));
    rule("small pieces", pieces(77));
    rule("the end is met by reading on", end_of_file());
    rule("places", places(packed(1, "")));
    rule("beyond the end", beyond_the_end());
    rule("two members are one file", members(""));
    rule("the second one between two buffers", between_buffers());
    rule("what is behind a member is left out", members("xyz") && members("\037xyz"));
    rule("a damaged file", damaged());
    rule("a file cut short", cut());
    rule("a plain file", as_it_is("a line\nand another\n"));
    rule("a small one, and none", as_it_is("x") && as_it_is(""));
    rule("memory is given back", gives_back());
    rule("a missing file", missing());
    return 0;
}
