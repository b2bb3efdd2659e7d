/* Pictures of surfaces: shape, light, transparency, colours by node. Surfaces are exact balls and sheets. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "lab/render/colours.h"
#include "lab/render/mesh_weld.h"
#include "lab/render/raster.h"
#include "lab/render/render.h"
#include "tests/lab/ball_mesh.h"

enum { SIZE = 300 };

static const float RED[3] = {0.5f, 0, 0}, GREEN[3] = {0, 0.5f, 0}, WHITE[3] = {0.5f, 0.5f, 0.5f};

/* A scene on nothing: where there is no surface, the picture is transparent. */
static struct scene *empty(void)
{
    struct scene *scene = scene_new();
    scene->has_background = false;
    return scene;
}

static void add(struct scene *scene, struct mesh mesh, const float colour[3], float opacity)
{
    struct scene_surface *s = scene_add(scene, &mesh);
    memcpy(s->colour, colour, sizeof s->colour);
    s->opacity = opacity;
}

static struct image draw(const struct scene *scene, double azimuth, double elevation)
{
    struct camera camera;
    struct image image = image_new(SIZE, SIZE);
    scene_cameras(scene, azimuth, elevation, 1, SIZE, SIZE, &camera, 1);
    render(scene, &camera, &image);
    return image;
}

static const uint8_t *pixel(const struct image *image, int x, int y)
{
    return image->rgba + 4 * (y * SIZE + x);
}

static double area(const struct image *image)
{
    double sum = 0;
    for (int i = 0; i < SIZE * SIZE; i++)
        sum += image->rgba[4 * i + 3] / 255.0;
    return sum;
}

static void assert_near(double a, double b, double tolerance)
{
    if (fabs(a - b) > tolerance)
        fail_msg("%g is not %g (to %g)", a, b, tolerance);
}

/* The ball fills the picture but for a margin of 5 % on each side. */
static void a_ball_covers_a_disc(void **state)
{
    (void)state;
    struct scene *scene = empty();
    add(scene, ball_mesh(3, -2, 5, 7, 48, true), WHITE, 1);
    struct image image = draw(scene, 31, 17);
    double disc = M_PI * pow(0.45 * SIZE, 2);
    assert_near(area(&image), disc, 0.003 * disc);
    assert_int_equal(pixel(&image, SIZE / 2, 14)[3], 0);
    assert_int_equal(pixel(&image, SIZE / 2, 16)[3], 255);
    image_free(&image);
    scene_free(scene);
}

static void light_comes_from_above_on_the_left(void **state)
{
    (void)state;
    struct scene *scene = empty();
    add(scene, ball_mesh(0, 0, 0, 1, 32, true), RED, 1);
    struct image image = draw(scene, 200, -10);
    const uint8_t *middle = pixel(&image, SIZE / 2, SIZE / 2);
    assert_true(middle[0] > 120 && middle[0] > 2 * middle[1] && middle[0] > 2 * middle[2]);
    assert_true(pixel(&image, 100, 100)[0] > middle[0]);
    assert_true(pixel(&image, 200, 200)[0] < middle[0]);
    image_free(&image);
    scene_free(scene);
}

/* From the front (-y) x is on the right and z up; from x, y is on the right: the axes are right-handed. */
static void axes_are_right_handed_and_z_is_up(void **state)
{
    (void)state;
    struct camera_ball ball = {.radius = 1};
    const float place[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    struct camera front = camera_at(&ball, -90, 0), side = camera_at(&ball, 0, 0),
                  above = camera_at(&ball, -90, 90);
    assert_true(camera_see(&front, place[0]).x > 0.1 && camera_see(&front, place[2]).y < -0.1);
    assert_true(camera_see(&front, place[1]).depth > front.distance);
    assert_true(camera_see(&side, place[1]).x > 0.1 && camera_see(&side, place[0]).depth < side.distance);
    assert_true(camera_see(&above, place[0]).x > 0.1 && camera_see(&above, place[1]).y < -0.1);
}

/* --- transparency --- */

/* Linear light of a pixel's channel. */
static double light(const struct image *image, int x, int y, int channel)
{
    return (double)colours_linear(pixel(image, x, y)[channel]);
}

/* The light at the middle of one opaque ball of that radius, in a picture of a ball of radius 1. */
static double alone(const float colour[3], float radius, int channel)
{
    struct scene *scene = empty();
    add(scene, ball_mesh(0, 0, 0, 1, 32, true), WHITE, 0); /* takes the room, and cannot be seen */
    add(scene, ball_mesh(0, 0, 0, radius, 32, true), colour, 1);
    struct image image = draw(scene, 0, 0);
    double found = light(&image, SIZE / 2, SIZE / 2, channel);
    image_free(&image);
    scene_free(scene);
    return found;
}

static void a_ball_is_seen_through_another(void **state)
{
    (void)state;
    double red = alone(RED, 1, 0), green = alone(GREEN, 0.5f, 1);
    for (int inner_first = 0; inner_first < 2; inner_first++) {
        struct scene *scene = empty();
        if (inner_first)
            add(scene, ball_mesh(0, 0, 0, 0.5f, 32, true), GREEN, 1);
        add(scene, ball_mesh(0, 0, 0, 1, 32, true), RED, 0.25f);
        if (!inner_first)
            add(scene, ball_mesh(0, 0, 0, 0.5f, 32, true), GREEN, 1);
        struct image image = draw(scene, 0, 0);
        const uint8_t *middle = pixel(&image, SIZE / 2, SIZE / 2);
        assert_int_equal(middle[3], 255);
        assert_near(light(&image, SIZE / 2, SIZE / 2, 0), 0.25 * red + 0.75 * alone(GREEN, 0.5f, 0), 0.02);
        assert_near(light(&image, SIZE / 2, SIZE / 2, 1), 0.75 * green + 0.25 * alone(RED, 1, 1), 0.02);
        image_free(&image);
        scene_free(scene);
    }
}

/* Two balls that cut each other: what is in front changes within the picture. */
static void order_of_surfaces_does_not_matter(void **state)
{
    (void)state;
    struct image image[2];
    for (int swapped = 0; swapped < 2; swapped++) {
        struct scene *scene = empty();
        for (int k = 0; k < 2; k++)
            if (k != swapped)
                add(scene, ball_mesh(0.4f, 0, 0, 1, 24, true), RED, 0.4f);
            else
                add(scene, ball_mesh(-0.4f, 0.1f, 0, 1, 24, true), GREEN, 0.6f);
        image[swapped] = draw(scene, 50, 20);
        scene_free(scene);
    }
    assert_memory_equal(image[0].rgba, image[1].rgba, 4 * SIZE * SIZE);
    image_free(&image[0]);
    image_free(&image[1]);
}

/* Two layers, the front and the back of a ball, of which each lets 60 % through. */
static void each_layer_counts(void **state)
{
    (void)state;
    struct scene *scene = empty();
    add(scene, ball_mesh(0, 0, 0, 1, 64, true), WHITE, 0.4f);
    struct image image = draw(scene, 0, 0);
    assert_near(pixel(&image, SIZE / 2, SIZE / 2)[3], 255 * (1 - 0.6 * 0.6), 1);
    assert_true(pixel(&image, 20, SIZE / 2)[3] > 220); /* aslant a layer is longer */
    image_free(&image);
    scene_free(scene);
}

/* Along the edges of a sheet's triangles nothing is missing, and nothing is drawn twice: each pixel is as its
 * neighbours are. (Towards the corners the sheet is seen aslant and is less transparent.) */
static void triangles_meet_without_seams(void **state)
{
    (void)state;
    struct scene *scene = empty();
    add(scene, sheet_mesh(40), WHITE, 0.5f);
    struct image image = draw(scene, -90, 0);
    unsigned wrong = 0;
    for (int y = 20; y < SIZE - 20; y++)
        for (int x = 20; x < SIZE - 20; x++) {
            int here = pixel(&image, x, y)[3];
            wrong += abs(here - pixel(&image, x + 1, y)[3]) > 1 || abs(here - pixel(&image, x, y + 1)[3]) > 1;
        }
    assert_int_equal(wrong, 0);
    assert_near(pixel(&image, SIZE / 2, SIZE / 2)[3], 127.5, 1);
    image_free(&image);
    scene_free(scene);
}

static void count_hit(void *to, int32_t x, int32_t y, float near)
{
    unsigned char(*hits)[64] = to;
    assert_true(near > 0.9f && near < 2.1f);
    hits[y][x]++;
}

/* Corners are on samples, so that many samples are exactly on edges and corners of a fan around each of them:
 * each sample belongs to one triangle. */
static void a_sample_on_an_edge_belongs_to_one_triangle(void **state)
{
    (void)state;
    const struct raster_window window = {0, 0, 64, 64};
    unsigned seed = 1;
    for (int round = 0; round < 200; round++) {
        unsigned char hits[64][64] = {{0}};
        seed = seed * 1103515245 + 12345;
        int32_t x = 8 + (int32_t)(seed >> 16) % 48, y = 8 + (int32_t)(seed >> 24) % 48;
        const int32_t around[][2] = {{0, 0},   {20, 0},  {64, 0}, {64, 32},
                                     {64, 64}, {11, 64}, {0, 64}, {0, 40}};
        for (int k = 0; k < 8; k++) {
            const int32_t *a = around[k], *b = around[(k + 1) % 8], h = RASTER_ONE / 2, one = RASTER_ONE;
            struct raster_corner fan[3] = {{a[0] * one - h, a[1] * one - h, 1},
                                           {b[0] * one - h, b[1] * one - h, 1},
                                           {x * one + h, y * one + h, 2}};
            struct raster_corner swapped = fan[k % 2];
            fan[k % 2] = fan[2];
            fan[2] = swapped;
            raster_triangle(fan, window, count_hit, hits);
        }
        for (int j = 0; j < 63; j++) /* the last row and column are on the outer edge */
            for (int i = 0; i < 63; i++)
                assert_int_equal(hits[j][i], 1);
    }
}

/* A red ball before a green one: its two layers hold back most of the green. */
static void the_nearer_layer_is_in_front(void **state)
{
    (void)state;
    for (int swapped = 0; swapped < 2; swapped++) {
        struct scene *scene = empty();
        add(scene, ball_mesh(swapped ? -2 : 2, 0, 0, 1, 24, true), swapped ? GREEN : RED, 0.5f);
        add(scene, ball_mesh(swapped ? 2 : -2, 0, 0, 1, 24, true), swapped ? RED : GREEN, 0.5f);
        struct image image = draw(scene, 0, 0);
        assert_true(light(&image, SIZE / 2, SIZE / 2, 0) > 2.5 * light(&image, SIZE / 2, SIZE / 2, 1));
        image_free(&image);
        scene_free(scene);
    }
}

/* --- normals, corners, colours --- */

/* How far two pictures are apart: the mean difference of a channel. */
static double difference(const struct image *a, const struct image *b)
{
    double sum = 0;
    for (int i = 0; i < 4 * SIZE * SIZE; i++)
        sum += abs(a->rgba[i] - b->rgba[i]);
    return sum / (4 * SIZE * SIZE);
}

static struct image ball_image(struct mesh mesh)
{
    struct scene *scene = empty();
    add(scene, mesh, WHITE, 1);
    struct image image = draw(scene, 40, 20);
    scene_free(scene);
    return image;
}

/* The same surface with a vertex of its own for each corner. */
static struct mesh apart(struct mesh m)
{
    struct mesh own = mesh_room(3 * m.triangle_count, m.triangle_count);
    own.vertex_count = 3 * m.triangle_count;
    for (uint32_t t = 0; t < m.triangle_count; t++) {
        for (uint32_t i = 0; i < 3; i++)
            memcpy(own.place[3 * t + i], m.place[m.triangle[t][i]], sizeof *own.place);
        mesh_add(&own, 3 * t, 3 * t + 1, 3 * t + 2);
    }
    mesh_triangulate(&own);
    mesh_free(&m);
    return own;
}

static void a_surface_without_normals_is_smooth(void **state)
{
    (void)state;
    struct image with = ball_image(ball_mesh(0, 0, 0, 1, 40, true));
    struct image without = ball_image(apart(ball_mesh(0, 0, 0, 1, 40, false)));
    assert_true(difference(&with, &without) < 0.15);
    image_free(&with);
    image_free(&without);
}

/* Few triangles with normals are lit as many are. */
static void light_changes_within_triangles(void **state)
{
    (void)state;
    struct image few = ball_image(ball_mesh(0, 0, 0, 1, 10, true)),
                 many = ball_image(ball_mesh(0, 0, 0, 1, 60, true));
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++)
            if (hypot(x - SIZE / 2, y - SIZE / 2) < 0.3 * SIZE)
                assert_near(pixel(&few, x, y)[0], pixel(&many, x, y)[0], 7);
    image_free(&few);
    image_free(&many);
}

/* Normals that all point inwards, or corners in the other order: the surface looks the same. */
static void inside_out_looks_the_same(void **state)
{
    (void)state;
    struct mesh inward = ball_mesh(0, 0, 0, 1, 40, true), swapped = ball_mesh(0, 0, 0, 1, 40, true);
    for (uint32_t v = 0; v < inward.vertex_count; v++)
        for (int i = 0; i < 3; i++)
            inward.normal[v][i] *= -1;
    for (uint32_t t = 0; t < swapped.triangle_count; t++) {
        uint32_t first = swapped.triangle[t][0];
        swapped.triangle[t][0] = swapped.triangle[t][1];
        swapped.triangle[t][1] = first;
    }
    struct image right = ball_image(ball_mesh(0, 0, 0, 1, 40, true)), a = ball_image(inward),
                 b = ball_image(swapped);
    assert_true(difference(&right, &a) < 0.02);
    assert_true(difference(&right, &b) < 0.02);
    image_free(&right);
    image_free(&a);
    image_free(&b);
}

static void welding_joins_the_corners(void **state)
{
    (void)state;
    struct mesh m = apart(ball_mesh(1, 2, 3, 4, 20, false));
    m.normal = xcalloc(m.vertex_count, sizeof *m.normal);
    for (uint32_t v = 0; v < m.vertex_count; v++) { /* of the face, not of the place */
        const uint32_t first = v - v % 3;
        for (int i = 0; i < 3; i++)
            m.normal[v][i] =
                (m.place[first][i] + m.place[first + 1][i] + m.place[first + 2][i]) / 3 - (float)(i + 1);
    }
    mesh_weld(&m);
    /* the poles' vertices of ball_mesh() differ in the last digits: each pole is 40 places at the most */
    assert_in_range(m.vertex_count, 2 + 19 * 40, 2 * 40 + 19 * 40);
    for (uint32_t v = 0; v < m.vertex_count; v++) {
        const float middle[3] = {1, 2, 3};
        double out = 0;
        for (int i = 0; i < 3; i++)
            out += (double)(m.normal[v][i] * (m.place[v][i] - middle[i]) / 4);
        assert_near(out, 1, 0.004);
    }
    mesh_free(&m);
}

/* Half a ball rises from a sheet: beside it the sheet sees less of the sky. */
static void folds_are_darker(void **state)
{
    (void)state;
    struct scene *scene = empty();
    add(scene, sheet_mesh(40), WHITE, 1);
    add(scene, ball_mesh(0, 0, 0, 0.3f, 24, true), RED, 1);
    struct image image = draw(scene, -90, 0);
    int away = pixel(&image, SIZE - 40, SIZE / 2)[1], beside = away;
    for (int x = SIZE / 2; x < SIZE - 40; x++) {
        const uint8_t *here = pixel(&image, x, SIZE / 2);
        if (abs(here[0] - here[1]) < 3 && here[1] < beside) /* gray: the sheet, not the ball */
            beside = here[1];
    }
    assert_true(away > 100 && beside < away - 5);
    image_free(&image);
    scene_free(scene);
}

static void nodes_have_colours(void **state)
{
    (void)state;
    struct mesh ball = ball_mesh(0, 0, 0, 1, 40, true);
    ball.node = xcalloc(ball.face_count, sizeof *ball.node);
    for (uint32_t f = 0; f < ball.face_count; f++)
        ball.node[f] = ball.place[ball.corner[ball.first[f]]][2] > 0 ? 5 : 4;
    struct scene *scene = empty();
    add(scene, ball, WHITE, 1);
    scene->surface[0].colouring = SCENE_BY_NODE;
    struct image image = draw(scene, 0, 0);
    const uint8_t *above = pixel(&image, SIZE / 2, SIZE / 3), *below = pixel(&image, SIZE / 2, 2 * SIZE / 3);
    float upper[3], lower[3];
    colours_of_node(5, upper);
    colours_of_node(4, lower);
    for (int i = 0; i < 3; i++) /* the order of the channels is that of the nodes' colours */
        for (int k = 0; k < i; k++) {
            if (fabsf(upper[i] - upper[k]) > 0.1f)
                assert_int_equal(above[i] > above[k], upper[i] > upper[k]);
            if (fabsf(lower[i] - lower[k]) > 0.1f)
                assert_int_equal(below[i] > below[k], lower[i] > lower[k]);
        }
    image_free(&image);
    scene_free(scene);
}

static void colours_of_neighbouring_nodes_differ(void **state)
{
    (void)state;
    for (uint32_t node = 0; node < 128; node++)
        for (uint32_t other = node + 1; other < node + 4; other++) {
            float a[3], b[3], apart_by = 0;
            colours_of_node(node, a);
            colours_of_node(other, b);
            for (int i = 0; i < 3; i++)
                apart_by = fmaxf(apart_by, fabsf(a[i] - b[i]));
            assert_true(apart_by > 0.15f);
        }
}

/* A picture is larger than the memory kept for one band; the far parts of its surfaces are off its edges. */
static void zoomed_pictures_fill_the_frame(void **state)
{
    (void)state;
    struct scene *scene = empty();
    struct camera camera;
    struct image image = image_new(700, SIZE);
    add(scene, ball_mesh(0, 0, 0, 1, 32, true), WHITE, 1);
    scene_cameras(scene, 0, 0, RENDER_MOST_ZOOM, 700, SIZE, &camera, 1);
    render(scene, &camera, &image);
    for (int i = 0; i < 700 * SIZE; i++)
        assert_int_equal(image.rgba[4 * i + 3], 255);
    image_free(&image);
    scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_ball_covers_a_disc),
        cmocka_unit_test(light_comes_from_above_on_the_left),
        cmocka_unit_test(axes_are_right_handed_and_z_is_up),
        cmocka_unit_test(a_ball_is_seen_through_another),
        cmocka_unit_test(order_of_surfaces_does_not_matter),
        cmocka_unit_test(each_layer_counts),
        cmocka_unit_test(triangles_meet_without_seams),
        cmocka_unit_test(a_sample_on_an_edge_belongs_to_one_triangle),
        cmocka_unit_test(the_nearer_layer_is_in_front),
        cmocka_unit_test(light_changes_within_triangles),
        cmocka_unit_test(a_surface_without_normals_is_smooth),
        cmocka_unit_test(inside_out_looks_the_same),
        cmocka_unit_test(welding_joins_the_corners),
        cmocka_unit_test(folds_are_darker),
        cmocka_unit_test(nodes_have_colours),
        cmocka_unit_test(colours_of_neighbouring_nodes_differ),
        cmocka_unit_test(zoomed_pictures_fill_the_frame),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
