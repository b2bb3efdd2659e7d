/* test_app_surface.c - the polygons of whole volumes: watertight, in the right place, as many as published.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "near.h"
#include "volume_mesh.h"

static const char *const APPROXIMATIONS[] = {"-approx 111 ", "-approx 333 ", "-approx 333 -lattice 1 ",
                                             "-approx 333 -lattice 3 ", "-approx 333 -lattice 4 "};

#define ALL (sizeof APPROXIMATIONS / sizeof *APPROXIMATIONS)

static struct options options_with(size_t approximation, const char *rest)
{
    char line[256];
    snprintf(line, sizeof line, "%s%s", APPROXIMATIONS[approximation], rest);
    return options_of(line);
}

static void a_spheres_surfaces_are_closed(void **state)
{
    (void)state;
    for (size_t a = 0; a < ALL; a++) {
        struct options o = options_with(a, "-sphere 38 38 20");
        pixel *p = volume_sphere(&o.grid);
        for (int iso = 0; iso < o.iso.n; iso++) {
            struct mesh_edges m = volume_mesh(&o, p, iso);
            assert_true(m.polygons > 0);
            assert_int_equal(m.open, 0);
            assert_int_equal(m.borders, 0);
            /* Euler: one closed surface without handles */
            assert_int_equal((long)m.vertices - (long)m.edges + (long)m.polygons, 2);
        }
        free(p);
    }
}

static void noise_has_watertight_surfaces(void **state)
{
    (void)state;
    for (size_t a = 0; a < ALL; a++)
        for (unsigned seed = 1; seed <= 2; seed++) {
            struct options o =
                options_with(a, "-sphere 23 18 9 -zspace 1.5 -grid 2 -isovalues 60,128.25,200");
            pixel *p = volume_noise(&o.grid, seed, 256);
            for (int iso = 0; iso < o.iso.n; iso++) {
                struct mesh_edges m = volume_mesh(&o, p, iso);
                assert_true(m.polygons > 100);
                assert_int_equal(m.open, 0);
            }
            free(p);
        }
}

/* Where slices are nearly in one place, where the fit's numbers are large, and where subcubes of other sides
 * are at the volume's upper end. */
static void flat_and_steep_subcubes_are_no_exception(void **state)
{
    (void)state;
    static const char *const lines[] = {"-sphere 23 18 9 -zspace 0.001 -grid 2 -isovalues 20000,33000",
                                        "-sphere 40 33 5 -zspace 700 -grid 16 -isovalues 20000,33000",
                                        "-sphere 141 99 4 -zspace 0.3 -grid 64 -isovalues 20000,33000"};
    for (size_t a = 0; a < ALL; a++)
        for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
            struct options o = options_with(a, lines[i]);
            pixel *p = volume_noise(&o.grid, 11, 65536);
            for (int iso = 0; iso < o.iso.n; iso++) {
                struct mesh_edges m = volume_mesh(&o, p, iso);
                assert_true(m.polygons > 10);
                assert_int_equal(m.open, 0);
            }
            free(p);
        }
}

/* F is 125 level / 2^15 at one point of a lattice of 4 small cubes a side: 19 / 8192 above a whole number. */
static void no_lattice_point_has_the_value_of_an_isovalue(void **state)
{
    (void)state;
    struct options o = options_of("-approx 333 -lattice 4 -isovalues 0");
    double data[8][C3_COMPS] = {{0}}, b[FIT_UNKNOWNS];
    const double *corner[8], widths[3] = {4, 4, 4};
    static struct fit_system system;
    for (int v = 0; v < 8; v++)
        corner[v] = data[v];
    while ((long)data[0][F] * 125 % 32768 != 76)
        data[0][F]++;
    fit_prepare(&system, widths);
    fit_tricubic(&system, corner, b);
    double value = tricubic_value(b, 0.75, 0.75, 0.75);
    assert_near(value - floor(value), 9.5 / 4096, 1e-10);
    assert_true(fabs(value - floor(value) - o.iso.value[0]) > 1e-7);
}

static void few_levels_and_isovalues_among_them_are_no_exception(void **state)
{
    (void)state;
    for (size_t a = 0; a < ALL; a++) {
        struct options o = options_with(a, "-sphere 17 17 9 -zspace 1 -isovalues 0,1,2,3");
        pixel *p = volume_noise(&o.grid, 7, 4);
        for (int iso = 0; iso < o.iso.n; iso++)
            assert_int_equal(volume_mesh(&o, p, iso).open, 0);
        free(p);
    }
}

/* --- one subcube --- */

static vertex found[POLYGON_MAX];
static int found_vertices;

static void keep(int iso, int n, const vertex *v)
{
    (void)iso;
    memcpy(found, v, (size_t)n * sizeof *v);
    found_vertices = n;
}

/* F = 2 u + 4 v + 8 w. */
static void a_trilinear_vertex_divides_its_edge_in_the_ratio_of_the_levels(void **state)
{
    (void)state;
    static const double level[8] = {0, 2, 4, 6, 8, 10, 12, 14};
    const struct cell cell = {.x = 10, .y = 20, .layer = 3, .wx = 4, .wy = 4, .dz = 8};
    const struct isovalues iso = {1, {1.5}};
    const double *corner[8];
    double sum[3] = {0};
    for (int c = 0; c < 8; c++)
        corner[c] = &level[c];
    found_vertices = 0;
    trilinear_polygons(&cell, corner, &iso, keep);
    assert_int_equal(found_vertices, 3);
    for (int i = 0; i < 3; i++)
        for (int d = 0; d < 3; d++)
            sum[d] += found[i][d];
    assert_true(sum[0] == 3 * 10 + 4 * 0.75);
    assert_true(sum[1] == 3 * 20 + 4 * 0.375);
    assert_true(sum[2] == 3 * 24 + 8 * 0.1875);
}

/* --- each polygon of a sphere --- */

static struct options sphere;
static double worst_radius, worst_normal;

static void look_at(int iso, int n, const vertex *v)
{
    double centre[3] = {(sphere.grid.pixels_x - 1) / 2.0, (sphere.grid.pixels_y - 1) / 2.0,
                        (sphere.grid.slices - 1) / 2.0 * sphere.grid.dz};
    double radius = sphere.iso.value[iso] / slice_level(&sphere.grid, 1), area[3] = {0};
    assert_in_range(n, 3, POLYGON_MAX);
    for (int i = 0; i < n; i++) {
        const double *a = v[i], *b = v[(i + 1) % n];
        double r = 0, along = 0, length = 0;
        for (int d = 0; d < 3; d++) {
            int e = (d + 1) % 3, f = (d + 2) % 3;
            area[d] += (a[e] - v[0][e]) * (b[f] - v[0][f]) - (a[f] - v[0][f]) * (b[e] - v[0][e]);
            r += (a[d] - centre[d]) * (a[d] - centre[d]);
            along += (a[d] - centre[d]) * a[3 + d];
            length += a[3 + d] * a[3 + d];
        }
        assert_near(length, 1, 1e-12);
        worst_radius = fmax(worst_radius, fabs(sqrt(r) - radius));
        worst_normal = fmax(worst_normal, 1 - along / sqrt(r));
    }
    for (int i = 0; i < n; i++)
        assert_true(area[0] * v[i][3] + area[1] * v[i][4] + area[2] * v[i][5] > 0);
}

/* radius in pixels; normal: 1 - cosine of the angle to the true one */
static void polygons_are_near(size_t approximation, double radius, double normal)
{
    sphere = options_with(approximation, "-sphere 64 64 17 -isovalues 22000,25000,28000");
    pixel *p = volume_sphere(&sphere.grid);
    worst_radius = worst_normal = 0;
    volume_polygons(&sphere, p, look_at);
    free(p);
    assert_true(worst_radius > 0 && worst_radius < radius);
    assert_true(worst_normal < normal);
}

static void vertices_lie_on_the_sphere_and_normals_point_outwards(void **state)
{
    (void)state;
    polygons_are_near(0, 0.2, 0.06);
    polygons_are_near(1, 0.05, 0.001);
}

/* --- the published totals --- */

/* No proof: the paper gives totals but neither isovalues nor slice distance nor lattice. Those were chosen so
 * that the totals come out (bench/paper/fitted.cfg); the test keeps the choice, and fails when the polygons
 * change by 3 %. */

static double total;

static void count(int iso, int n, const vertex *v)
{
    (void)iso, (void)n, (void)v;
    total++;
}

static void the_chosen_isovalues_slices_and_lattice_still_give_the_papers_totals(void **state)
{
    (void)state;
    static const double paper[2] = {121486, 78741};
    for (size_t a = 0; a < 2; a++) {
        struct options o = options_with(a, "");
        pixel *p = volume_sphere(&o.grid);
        total = 0;
        volume_polygons(&o, p, count);
        free(p);
        assert_true(fabs(total / paper[a] - 1) < 0.03);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_spheres_surfaces_are_closed),
        cmocka_unit_test(noise_has_watertight_surfaces),
        cmocka_unit_test(flat_and_steep_subcubes_are_no_exception),
        cmocka_unit_test(no_lattice_point_has_the_value_of_an_isovalue),
        cmocka_unit_test(few_levels_and_isovalues_among_them_are_no_exception),
        cmocka_unit_test(a_trilinear_vertex_divides_its_edge_in_the_ratio_of_the_levels),
        cmocka_unit_test(vertices_lie_on_the_sphere_and_normals_point_outwards),
        cmocka_unit_test(the_chosen_isovalues_slices_and_lattice_still_give_the_papers_totals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
