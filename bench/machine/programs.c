/* Parts of programs of 1994-96 that nothing was fitted to: a sort through pointers, the bookkeeping of a
 * one-sided library, a mode of a random spectrum, vectors out of cache. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "bench.h"

enum { RECORDS = 19531, PUTS = 1000, MODES = 2000, SIDE = 100, VECTOR = 1503, TIMES = 100 };

static volatile double sink;

/* --- a quicksort of records by a comparison function; keys of two words. C libraries of 1990 swapped bytes,
 * as 4.3BSD's qsort does; later ones words, where records lie so. --- */

struct record {
    unsigned key[2];
    double data[7];
};
static struct record records[RECORDS];

typedef int compare_fn(const void *, const void *);

static int by_key(const void *a, const void *b)
{
    const struct record *x = a, *y = b;
    if (x->key[0] != y->key[0])
        return x->key[0] < y->key[0] ? -1 : 1;
    return x->key[1] < y->key[1] ? -1 : x->key[1] > y->key[1];
}

static void swap_bytes(char *a, char *b, int size)
{
    for (; size > 0; size--) {
        char byte = *a;
        *a++ = *b, *b++ = byte;
    }
}

static void swap_words(char *a, char *b, int size)
{
    int *x = (void *)a, *y = (void *)b;
    for (int words = size / 4; words > 0; words--) {
        int word = *x;
        *x++ = *y, *y++ = word;
    }
}

static void (*swap)(char *, char *, int);

/* Moves the middle one of three to the front, and what is less than it before what is greater. Answers where
 * it is then. */
static char *part(char *first, int n, int size, compare_fn *compare)
{
    char *last = first + (long)(n - 1) * size, *middle = first + (long)(n / 2) * size, *low = first, *high;
    if (compare(middle, last) > 0)
        swap(middle, last, size);
    if (compare(first, middle) < 0)
        swap(first, middle, size);
    if (compare(first, last) > 0)
        swap(first, last, size);
    high = last + size;
    for (;;) {
        do
            low += size;
        while (low < last && compare(low, first) < 0);
        do
            high -= size;
        while (compare(first, high) < 0);
        if (low >= high)
            break;
        swap(low, high, size);
    }
    swap(first, high, size);
    return high;
}

static void sort(char *first, int n, int size, compare_fn *compare)
{
    while (n > 1) {
        char *middle = part(first, n, size, compare);
        int less = (int)((middle - first) / size);
        sort(first, less, size, compare);
        first = middle + size, n -= less + 1;
    }
}

static void make_records(void)
{
    unsigned random = 12345;
    for (int i = 0; i < RECORDS; i++)
        for (int word = 0; word < 2; word++)
            records[i].key[word] = (random = random * 1103515245 + 12345) >> 8;
}

/* --- a put of 8 bytes into a local part of a distributed array --- */

struct array {
    int active, dims[2], blocks[2], leading, low[2];
    int *map; /* where blocks begin: of rows, then of columns */
    double *data;
};
static double cells[SIDE * SIDE];
static int map[] = {1, 1};
static struct array arrays[4];
static struct patch {
    int owner, low[2], high[2];
} patches[16];
static int errors, me;
static long bytes_put;

static int locate(const int *begins, int n, int x)
{
    for (int i = 0; i + 1 < n; i++)
        if (x < begins[i + 1])
            return i;
    return n - 1;
}

static int larger(int a, int b)
{
    return a > b ? a : b;
}

/* The patches of which owners make up a region; how many. */
static int owners(const struct array *a, const int low[2], const int high[2])
{
    int n = 0, *columns = a->map + a->blocks[0];
    int first = locate(a->map, a->blocks[0], low[0]), last = locate(a->map, a->blocks[0], high[0]);
    int left = locate(columns, a->blocks[1], low[1]), right = locate(columns, a->blocks[1], high[1]);
    for (int j = left; j <= right; j++)
        for (int i = first; i <= last; i++, n++)
            patches[n] = (struct patch){j * a->blocks[0] + i,
                                        {larger(a->map[i], low[0]), larger(columns[j], low[1])},
                                        {high[0], high[1]}};
    return n;
}

static char *address(const struct array *a, const int at[2])
{
    return (char *)(a->data + (long)(at[1] - a->low[1]) * a->leading + at[0] - a->low[0]);
}

static void copy(const char *from, long from_row, char *to, long to_row, long bytes, int rows)
{
    for (int j = 0; j < rows; j++)
        memcpy(to + j * to_row, from + j * from_row, (size_t)bytes);
}

static void put(int handle, const int low[2], const int high[2], const double *from, int leading)
{
    struct array *a = &arrays[handle];
    if (!a->active || low[0] < 1 || high[0] > a->dims[0] || low[1] < 1 || high[1] > a->dims[1])
        errors++;
    int n = owners(a, low, high);
    for (int k = 0; k < n; k++) {
        struct patch *p = &patches[k];
        const double *at = from + (long)(p->low[1] - low[1]) * leading + p->low[0] - low[0];
        long bytes = 8 * (p->high[0] - p->low[0] + 1);
        int rows = p->high[1] - p->low[1] + 1;
        if (p->owner != me)
            errors++;
        copy((const char *)at, 8L * leading, address(a, p->low), 8L * a->leading, bytes, rows);
        bytes_put += bytes * rows;
    }
}

static void puts_of_8_bytes(void)
{
    double x = 1;
    me = (int)mynode();
    arrays[2] = (struct array){1, {SIDE, SIDE}, {1, 1}, SIDE, {1, 1}, map, cells};
    for (int i = 0; i < PUTS; i++) {
        int at[2] = {1 + i % SIDE, 7};
        put(2, at, at, &x, 1);
    }
}

/* --- a mode of a random spectrum: normal deviates by uniform ones, two generators of a division each --- */

static double uniform(void)
{
    static int a = 12345, b = 67890;
    int k = a / 53668, sum;
    a = 40014 * (a - k * 53668) - k * 12211;
    a += a < 0 ? 2147483563 : 0;
    k = b / 52774;
    b = 40692 * (b - k * 52774) - k * 3791;
    b += b < 0 ? 2147483399 : 0;
    sum = a - b;
    return (sum < 1 ? sum + 2147483562 : sum) * 4.656613e-10;
}

static double normal(void)
{
    static double kept;
    static int have;
    double x, y, r, f;
    if ((have = !have) == 0)
        return kept;
    do {
        x = 2 * uniform() - 1, y = 2 * uniform() - 1;
        r = x * x + y * y;
    } while (r >= 1 || r == 0);
    f = sqrt(-2 * log(r) / r);
    kept = x * f;
    return y * f;
}

static void spectrum(void)
{
    for (int i = 0; i < MODES; i++) {
        double k = sqrt(0.3 + 0.01 * i);
        sink = sqrt(pow(k, 0.96) / pow(1 + 2.7 * k, 1.13)) * normal();
    }
}

/* --- */

static double x[VECTOR], y[VECTOR];

/* BLAS, -lkmath. */
void dscal_(const int *n, const double *a, double *x, const int *step);
void daxpy_(const int *n, const double *a, const double *x, const int *x_step, double *y, const int *y_step);
void dcopy_(const int *n, const double *x, const int *x_step, double *y, const int *y_step);

/* Clocks an element of what took the time since begin. */
static double clocks(double begin)
{
    return (now_us() - begin) * 50 / VECTOR / TIMES;
}

static double sort_s(void (*swapping)(char *, char *, int))
{
    make_records();
    swap = swapping;
    double begin = now_us();
    sort((char *)records, RECORDS, sizeof records[0], by_key);
    return (now_us() - begin) / 1e6;
}

/* A vector that has just been read, and pairs that are more than the cache. */
static void blas(void)
{
    const int n = VECTOR, one = 1;
    const double a = 0.5;
    double begin = now_us();
    for (int i = 0; i < TIMES; i++)
        dscal_(&n, &a, x, &one);
    figure("dscal_clocks", clocks(begin));
    begin = now_us();
    for (int i = 0; i < TIMES; i++)
        daxpy_(&n, &a, x, &one, y, &one);
    figure("daxpy_clocks", clocks(begin));
    begin = now_us();
    for (int i = 0; i < TIMES; i++)
        dcopy_(&n, x, &one, y, &one);
    figure("dcopy_clocks", clocks(begin));
}

int main(void)
{
    figure("sort_bytes_s", sort_s(swap_bytes));
    figure("sort_words_s", sort_s(swap_words));
    double begin = now_us();
    puts_of_8_bytes();
    figure("put_us", (now_us() - begin) / PUTS);
    begin = now_us();
    spectrum();
    figure("mode_us", (now_us() - begin) / MODES);
    begin = now_us();
    for (int i = 0; i < TIMES; i++)
        memcpy(y, x, sizeof x);
    figure("copy_clocks", clocks(begin));
    begin = now_us();
    for (int i = 0; i < TIMES; i++)
        memset(y, 0, sizeof y);
    figure("zero_clocks", clocks(begin));
    blas();
    for (int i = 1; i < RECORDS; i++)
        errors += by_key(&records[i - 1], &records[i]) > 0;
    return errors != 0;
}
