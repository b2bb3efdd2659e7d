/* Inner loops of programs of 1994-96 that nothing was fitted to: a node's part of the FFT of 128^3 real
 * numbers on 64 nodes, copies with strides, products of a vector with several, forces between bodies, a
 * sparse matrix of blocks of 3 times a vector. */
#include <math.h>
#include "bench.h"

/* --- a Fourier transform of three dimensions: real numbers along the first, complex along the others --- */

enum { SIDE = 128, NODES = 64, HALF = SIDE / 2, TURN = 256 };
enum { REAL_ROWS = SIDE * SIDE / NODES, ROWS = (HALF + 1) * SIDE / NODES };

struct complex {
    double re, im;
};
static struct complex row[SIDE + 1], other[SIDE], roots[TURN];

static void make_roots(void)
{
    for (int i = 0; i < TURN; i++) {
        double angle = -2 * M_PI * i / TURN;
        roots[i] = (struct complex){cos(angle), sin(angle)};
    }
}

/* A pass: from x into y, `groups` groups of `each` butterflies that have one root. */
static void pass(int groups, int each, const struct complex *x, struct complex *y)
{
    int apart = groups * each;
    for (int g = 0; g < groups; g++) {
        double wr = roots[g * (HALF / groups) * 2].re, wi = roots[g * (HALF / groups) * 2].im;
        const struct complex *a = x + g * each, *b = a + apart;
        struct complex *sum = y + 2 * g * each, *difference = sum + each;
        for (int i = 0; i < each; i++) {
            double re = a[i].re - b[i].re, im = a[i].im - b[i].im;
            sum[i].re = a[i].re + b[i].re;
            sum[i].im = a[i].im + b[i].im;
            difference[i].re = wr * re - wi * im;
            difference[i].im = wr * im + wi * re;
        }
    }
}

/* Of n complex numbers, a power of two; radix 2, in order (Stockham's). */
static struct complex *transform(int n, struct complex *x, struct complex *y)
{
    for (int groups = n / 2, each = 1; groups > 0; groups /= 2, each *= 2) {
        pass(groups, each, x, y);
        struct complex *t = x;
        x = y, y = t;
    }
    return x;
}

/* Of 2 n real numbers, by n complex ones that are then taken apart. */
static void transform_real(int n, struct complex *x, struct complex *y)
{
    struct complex *z = transform(n, x, y), *to = z == x ? y : x;
    for (int i = 0; i < n; i++) {
        struct complex a = z[i], b = z[i ? n - i : 0], w = roots[i * (TURN / 2 / n)];
        double er = 0.5 * (a.re + b.re), ei = 0.5 * (a.im - b.im);
        double odd_r = 0.5 * (a.im + b.im), odd_i = 0.5 * (b.re - a.re);
        to[i].re = er + w.re * odd_r - w.im * odd_i;
        to[i].im = ei + w.re * odd_i + w.im * odd_r;
    }
}

static double fft_s(void)
{
    make_roots();
    for (int i = 0; i < SIDE; i++)
        row[i].re = i % 7, row[i].im = i % 5;
    double begin = now_us();
    for (int i = 0; i < REAL_ROWS; i++)
        transform_real(HALF, row, other);
    for (int i = 0; i < 2 * ROWS; i++)
        transform(SIDE, row, other);
    return (now_us() - begin) / 1e6;
}

/* --- three copies of a node's part of 256^3 numbers, read with strides of 512 bytes and 2 KB --- */

enum { PART = 256 * 256 * 256 / NODES };
static double from[PART], to[PART];

static void turn(int rows, int columns)
{
    for (int j = 0; j < columns; j++)
        for (int i = 0; i < rows; i++)
            to[j * rows + i] = from[i * columns + j];
}

static double copies_s(void)
{
    for (int i = 0; i < PART; i++)
        from[i] = i;
    double begin = now_us();
    turn(PART / 64, 64);
    turn(PART / 64, 64);
    turn(PART / 256, 256);
    return (now_us() - begin) / 1e6;
}

/* --- products of a vector with ten others, clocks of 50 MHz for each of their elements --- */

enum { VECTOR = 1503, VECTORS = 10 };
static double basis[VECTORS][VECTOR], vector[VECTOR], dots[VECTORS];

static double dots_clocks(void)
{
    for (int i = 0; i < VECTOR; i++)
        basis[i % VECTORS][i] = vector[i] = i;
    double begin = now_us();
    for (int k = 0; k < VECTORS; k++) {
        double sum = 0;
        for (int i = 0; i < VECTOR; i++)
            sum += basis[k][i] * vector[i];
        dots[k] = sum;
    }
    return (now_us() - begin) * 50 / VECTOR / VECTORS;
}

/* --- forces between bodies, each pair twice --- */

enum { BODIES = 128 };
static struct body {
    double x[3], mass, force[3];
} bodies[BODIES];

static double force_clocks(void)
{
    for (int i = 0; i < BODIES; i++)
        for (int d = 0; d < 3; d++)
            bodies[i].x[d] = (i * (d + 3)) % 17, bodies[i].mass = 1;
    double begin = now_us();
    for (int i = 0; i < BODIES; i++) {
        double fx = 0, fy = 0, fz = 0;
        for (int j = 0; j < BODIES; j++) {
            double x = bodies[j].x[0] - bodies[i].x[0], y = bodies[j].x[1] - bodies[i].x[1],
                   z = bodies[j].x[2] - bodies[i].x[2], square = x * x + y * y + z * z + 0.01;
            double pull = bodies[j].mass / (square * sqrt(square));
            fx += pull * x, fy += pull * y, fz += pull * z;
        }
        bodies[i].force[0] = fx, bodies[i].force[1] = fy, bodies[i].force[2] = fz;
    }
    return (now_us() - begin) * 50 / BODIES / BODIES;
}

/* --- a sparse matrix of blocks of 3 x 3 times a vector --- */

enum { BLOCK_ROWS = VECTOR / 3, IN_ROW = 7 };
static double blocks[BLOCK_ROWS * IN_ROW][9];
static int columns[BLOCK_ROWS * IN_ROW];

static double block_clocks(void)
{
    for (int k = 0; k < BLOCK_ROWS * IN_ROW; k++)
        columns[k] = (k / IN_ROW + 11 * (k % IN_ROW)) % BLOCK_ROWS, blocks[k][k % 9] = k;
    double begin = now_us();
    for (int r = 0, k = 0; r < BLOCK_ROWS; r++) {
        double y0 = 0, y1 = 0, y2 = 0;
        for (int i = 0; i < IN_ROW; i++, k++) {
            const double *a = blocks[k], *x = vector + 3 * columns[k];
            y0 += a[0] * x[0] + a[3] * x[1] + a[6] * x[2];
            y1 += a[1] * x[0] + a[4] * x[1] + a[7] * x[2];
            y2 += a[2] * x[0] + a[5] * x[1] + a[8] * x[2];
        }
        to[3 * r] = y0, to[3 * r + 1] = y1, to[3 * r + 2] = y2;
    }
    return (now_us() - begin) * 50 / BLOCK_ROWS / IN_ROW;
}

/* All results, so that the compiler leaves none out. */
static double sum_of(const double *x, int n)
{
    double sum = 0;
    for (int i = 0; i < n; i++)
        sum += x[i];
    return sum;
}

int main(void)
{
    volatile double sink;
    figure("fft_s", fft_s());
    figure("copies_s", copies_s());
    sink = sum_of(to, PART);
    figure("dots_clocks", dots_clocks());
    sink = sum_of(dots, VECTORS);
    figure("force_clocks", force_clocks());
    figure("block_clocks", block_clocks());
    sink = sum_of(to, VECTOR) + bodies[1].force[0];
    (void)sink;
    return 0;
}
