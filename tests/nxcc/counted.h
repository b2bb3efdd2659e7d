/* counted.h - functions compiled by nxcc whose cost test_count.c knows. */
#ifndef COUNTED_H
#define COUNTED_H
#include <stddef.h>
#include <stdint.h>

int c_nothing(void);
int c_two_adds(int a, int b, int c);
void c_add_to(double *y, const double *x);
double c_sum(const double *x, long n);
int c_bits(unsigned long x);
double c_divide(double a, double b);
int c_multiply(int a, int b);
int c_divide_by_8(int a);
long c_inlined(long n);
long c_inlined_in_loop(long n);
long c_calls_small(long n); /* twice small(), which multiplies and adds */
double c_sqrt(double x);
double c_fast_floor(double x);
int c_divide_and_remainder(int a, int b);
int c_order(double a, double b);
double c_exp(double x);
double c_from_int(int i);
int c_switch(int i);
long c_fibonacci(long n);
int c_call_through(int (*f)(void));
int c_tail_call(int (*f)(void));
int c_pure_calls(int n);
void c_copy(void *to, const void *from, size_t n);
enum { MUCH = 1000000 };
void c_copy_all(void *to, const void *from); /* so many bytes */
size_t c_length(const char *s);
int c_print(char *to, int number);
void c_sort(int *a, size_t n);
int c_compare(const void *a, const void *b);
long c_goto(const unsigned char *code);
int c_jump_back(int times);
int c_jump_out(int depth);
long c_count_down(long n);
long c_nested(long n);
int c_asm_goto(int x);
int c_never_returns(int x);
long c_while_others(long n, void (*f)(void));
double c_many_registers(const double *x, long n);
long c_irreducible(long n, int into);
struct big {
    long v[16];
};
struct big c_struct(struct big b);
long c_varargs(int n, ...);
#endif
