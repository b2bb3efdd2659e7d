/* test_speed.c - programs on the simulated i860 XR are as fast as they were on real ones.
 *
 * LINPACK of order 100 in Fortran ran at about 4.5 to 6.5 MFLOPS on a node of the iPSC/860 (Dongarra,
 * Performance of Various Computers Using Standard Linear Equations Software, CS-89-85).
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "counter.h"
#include "linpack.h"

static const double clock_hz = 40e6;

static double mflops(double operations)
{
    double seconds = (double)counter_spent() / NXC_UNITS_PER_CLOCK / clock_hz;
    return operations / seconds * 1e-6;
}

static void linpack(void **state)
{
    static double a[ORDER][ORDER], b[ORDER];
    int pivot[ORDER];
    const double n = ORDER;
    (void)state;
    linpack_matrix(a, b);
    counter_start(INT64_MAX / 2);
    linpack_factor(a, pivot);
    linpack_solve(a, pivot, b);
    double speed = mflops(2.0 / 3.0 * n * n * n + 2 * n * n);
    for (int i = 0; i < ORDER; i++)
        assert_true(fabs(b[i] - 1) < 1e-9);
    print_message("# LINPACK, order 100: %.2f MFLOPS\n", speed);
    assert_true(speed > 4.5 && speed < 6.5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(linpack),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
