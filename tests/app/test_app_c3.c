/* test_app_c3.c - the grid and the finite differences. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include "c3.h"
#include "near.h"
#include "volume_mesh.h"

/* Lines four pixels apart are one of two readings of the paper's "4x4 pixels", and our choice. */
static void the_papers_grids_have_whole_numbers_of_subcubes(void **state)
{
    (void)state;
    struct grid g;
    grid_set(&g, 512, 512, 65, 4, 1, 1);
    assert_int_equal(g.nx, 128);
    assert_int_equal(g.ny, 128);
    grid_set(&g, 192, 128, 65, 4, 8, 1);
    assert_int_equal(g.nx, 48);
    assert_int_equal(g.ny, 32);
}

static void grid_lines_reach_from_the_first_to_the_last_pixel(void **state)
{
    (void)state;
    for (int pixels = 2; pixels < 30; pixels++)
        for (int step = 1; step < 8; step++) {
            struct grid g;
            grid_set(&g, pixels, pixels, 2, step, 1, 1);
            assert_int_equal(grid_line(0, pixels, step), 0);
            assert_int_equal(grid_line(g.nx, pixels, step), pixels - 1);
            for (int i = 0; i < g.nx; i++)
                assert_true(grid_line(i, pixels, step) < grid_line(i + 1, pixels, step));
        }
}

/* Data of the middle slice of three that hold f(x, y, z), at the middle grid point. */
static double middle(double (*f)(double, double, double), int data)
{
    struct grid g;
    pixel image[3][9 * 9];
    double out[3 * 3 * C3_COMPS];
    grid_set(&g, 9, 9, 3, 4, C3_COMPS, 2.0);
    for (int k = 0; k < 3; k++)
        for (int y = 0; y < 9; y++)
            for (int x = 0; x < 9; x++)
                image[k][9 * y + x] = (pixel)f(x, y, 2.0 * k);
    c3_slice(&g, image[0], image[1], image[2], out);
    return out[4 * C3_COMPS + data];
}

static double quadratic(double x, double y, double z)
{
    return 5 + x + 2 * x * x + y * y * (3 + x) + z * x * y + z * z * y * 2;
}

static double product(double x, double y, double z)
{
    return x * x * y * y * z * z;
}

static void differences_inside_are_exact_for_quadratics(void **state)
{
    (void)state;
    double x = 4, y = 4, z = 2;
    assert_near(middle(quadratic, F), quadratic(x, y, z), 1e-9);
    assert_near(middle(quadratic, F_X), 1 + 4 * x + y * y + z * y, 1e-9);
    assert_near(middle(quadratic, F_Y), 2 * y * (3 + x) + z * x + 2 * z * z, 1e-9);
    assert_near(middle(quadratic, F_Z), x * y + 4 * z * y, 1e-9);
    assert_near(middle(quadratic, F_XY), 2 * y + z, 1e-9);
    assert_near(middle(quadratic, F_YZ), x + 4 * z, 1e-9);
    assert_near(middle(quadratic, F_XZ), y, 1e-9);
    assert_near(middle(quadratic, F_XYZ), 1, 1e-9);
    assert_near(middle(product, F_XYZ), 8 * x * y * z, 1e-9);
}

static void the_slice_itself_stands_for_a_missing_neighbour(void **state)
{
    (void)state;
    struct grid g;
    pixel low[4], high[4];
    double out[4 * C3_COMPS];
    grid_set(&g, 2, 2, 2, 1, C3_COMPS, 4.0);
    for (int i = 0; i < 4; i++) {
        low[i] = (pixel)(10 + i);      /* 10 + x + 2 y */
        high[i] = (pixel)(30 + 5 * i); /* 30 + 5 x + 10 y */
    }
    c3_slice(&g, NULL, low, high, out);
    assert_near(out[F_X], 1, 1e-12);
    assert_near(out[F_Y], 2, 1e-12);
    assert_near(out[F_Z], 20 / 4.0, 1e-12);
    assert_near(out[F_XZ], (5 - 1) / 4.0, 1e-12);
    c3_slice(&g, low, high, NULL, out);
    assert_near(out[F_Z], 20 / 4.0, 1e-12);
    assert_near(out[F_YZ], (10 - 2) / 4.0, 1e-12);
}

static void the_spheres_level_rises_with_the_radius(void **state)
{
    (void)state;
    struct options o = options_of("-sphere 33 33 33");
    pixel *p = volume_sphere(&o.grid);
    size_t centre = (size_t)(16 * 33 + 16) * 33 + 16;
    assert_int_equal(p[centre], 0);
    assert_int_equal(p[0], 65535);
    assert_true(fabs(p[centre + 10] - slice_level(&o.grid, 10)) <= 0.5);
    for (size_t i = 0; i < 16; i++)
        assert_true(p[centre + i] < p[centre + i + 1]);
    free(p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_papers_grids_have_whole_numbers_of_subcubes),
        cmocka_unit_test(grid_lines_reach_from_the_first_to_the_last_pixel),
        cmocka_unit_test(differences_inside_are_exact_for_quadratics),
        cmocka_unit_test(the_slice_itself_stands_for_a_missing_neighbour),
        cmocka_unit_test(the_spheres_level_rises_with_the_radius),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
