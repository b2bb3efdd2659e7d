/* counted.c - what the exact tests count; see counted.h. Compiled by nxcc -O2 with digits.cfg. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "counted.h"

int c_nothing(void)
{
    return 1;
}

int c_two_adds(int a, int b, int c)
{
    return a + b + c;
}

void c_add_to(double *y, const double *x)
{
    *y += *x;
}

double c_sum(const double *x, long n)
{
    double sum = 0;
    for (long i = 0; i < n; i++)
        sum += x[i];
    return sum;
}

int c_bits(unsigned long x)
{
    int n = 0;
    for (; x; n++)
        x &= x - 1;
    return n;
}

double c_divide(double a, double b)
{
    return a / b;
}

int c_multiply(int a, int b)
{
    return a * b;
}

int c_divide_by_8(int a)
{
    return a / 8;
}

static inline long twice_and_one(long n)
{
    return (n ^ 5) + (n & 3); /* three integer operations */
}

long c_inlined(long n)
{
    return twice_and_one(n);
}

long c_inlined_in_loop(long n)
{
    long sum = 0;
    for (long i = 0; i < n; i++)
        sum ^= twice_and_one(i);
    return sum;
}

/* The same on every way: its callers pay for it. */
__attribute__((noinline, noclone)) static long small(long n)
{
    return n * n + 1;
}

long c_calls_small(long n)
{
    return small(n) - small(n + 1);
}

double c_sqrt(double x)
{
    return sqrt(x);
}

__attribute__((optimize("no-trapping-math"))) double c_fast_floor(double x)
{
    return floor(x);
}

int c_divide_and_remainder(int a, int b)
{
    return a / b ^ a % b;
}

int c_order(double a, double b)
{
    if (a != b)
        return a < b ? -1 : 1;
    return 0;
}

double c_exp(double x)
{
    return exp(x);
}

double c_from_int(int i)
{
    return i;
}

int c_switch(int i)
{
    switch (i) {
    case 0:
        return c_nothing();
    case 1:
        return c_two_adds(i, 2, 3);
    case 2:
        return c_divide_by_8(100);
    case 3:
        return c_multiply(i, i);
    case 4:
        return c_switch(0);
    case 5:
        return c_switch(1);
    }
    return 7;
}

__attribute__((noinline)) long c_fibonacci(long n)
{
    return n < 2 ? n : c_fibonacci(n - 1) + c_fibonacci(n - 2);
}

int c_call_through(int (*f)(void))
{
    return f() + 1;
}

int c_tail_call(int (*f)(void))
{
    return f();
}

/* GCC finds this pure, even const; it costs something all the same. */
__attribute__((noinline)) static int pure(int x)
{
    int steps = 0;
    for (; x > 1; x -= x / 4 + 1)
        steps++;
    return steps;
}

int c_pure_calls(int n)
{
    int sum = 0;
    for (int i = 0; i < n; i++)
        sum += pure(20 + (i & 1));
    return sum;
}

void c_copy_all(void *to, const void *from)
{
    memcpy(to, from, MUCH);
}

void c_copy(void *to, const void *from, size_t n)
{
    memcpy(to, from, n);
}

size_t c_length(const char *s)
{
    return strlen(s);
}

int c_print(char *to, int number)
{
    return snprintf(to, 20, "%d", number);
}

int c_compare(const void *a, const void *b)
{
    int x = *(const int *)a, y = *(const int *)b;
    return (x > y) - (x < y);
}

void c_sort(int *a, size_t n)
{
    qsort(a, n, sizeof *a, c_compare);
}

/* 0 ends, 1 adds, 2 doubles: an interpreter by computed goto. */
long c_goto(const unsigned char *code)
{
    static void *const label[] = {&&end, &&add, &&twice};
    long a = 1;
    goto *label[*code++];
add:
    a += 1;
    goto *label[*code++];
twice:
    a *= 2;
    goto *label[*code++];
end:
    return a;
}

static jmp_buf back;

__attribute__((noinline)) static void leap(int value)
{
    longjmp(back, value);
}

int c_jump_back(int times)
{
    volatile int n = 0;
    int value = setjmp(back);
    n++;
    if (value < times)
        leap(value + 1);
    return n;
}

__attribute__((noinline)) static int deeper(int depth)
{
    volatile int here = depth; /* keeps it a recursion */
    if (here == 0)
        longjmp(back, 1);
    return deeper(depth - 1) + here;
}

int c_jump_out(int depth)
{
    if (setjmp(back))
        return -1;
    return deeper(depth);
}

__attribute__((noinline)) long c_count_down(long n)
{
    volatile long here = n; /* keeps it a recursion */
    return n > 0 ? c_count_down(n - 1) + here : 0;
}

long c_nested(long n)
{
    long sum = 0;
    auto void add(long i);
    void (*volatile through)(long) = add; /* with a trampoline */
    void add(long i)
    {
        sum += i;
    }
    for (long i = 0; i < n; i++)
        through(i);
    return sum;
}

int c_asm_goto(int x)
{
    __asm__ goto("testl %0, %0\n\tjne %l[other]" : : "r"(x) : "cc" : other);
    return x + 1;
other:
    return x + 2;
}

__attribute__((noreturn, noinline)) static void away(int x)
{
    longjmp(back, x + 1);
}

int c_never_returns(int x)
{
    if (setjmp(back))
        return 5;
    away(x);
}

long c_while_others(long n, void (*f)(void))
{
    long sum = 0;
    for (long i = 0; i < n; i++) {
        f();
        sum += i;
    }
    return sum;
}

/* Enough values alive at once that a poll that lost a register would be noticed. */
double c_many_registers(const double *x, long n)
{
    double a = 1, b = 2, c = 3, d = 4, e = 5, f = 6, g = 7, h = 8, p = 9, q = 10;
    long s = 0, t = 1, u = 2, v = 3, w = 4, z = 5;
    for (long i = 0; i < n; i++) {
        a += x[i], b -= a, c += b * x[i], d -= c, e += d, f -= e * 0.5, g += f, h -= g, p += h * 0.25, q -= p;
        s += i, t ^= s, u += t, v -= u, w ^= v, z += w;
    }
    return a + b + c + d + e + f + g + h + p + q + (double)(s ^ t ^ u ^ v ^ w ^ z);
}

/* A loop with two entries. */
long c_irreducible(long n, int into)
{
    volatile long steps = 0;
    if (into)
        goto middle;
top:
    steps += 1;
middle:
    steps += 2;
    if (steps < n)
        goto top;
    return steps;
}

struct big c_struct(struct big b)
{
    for (int i = 0; i < 16; i++)
        b.v[i] += i;
    return b;
}

long c_varargs(int n, ...)
{
    va_list list;
    long sum = 0;
    va_start(list, n);
    for (int i = 0; i < n; i++)
        sum += va_arg(list, long);
    va_end(list);
    return sum;
}
