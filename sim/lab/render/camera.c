/* camera.c - see camera.h. */
#include "lab/render/camera.h"
#include <math.h>

static const double VIEWER_RADII = 4; /* the viewer's distance, in radii of the ball: a mild perspective */
static const double MARGIN = 0.05;    /* of the picture's width and height, on each side */

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

struct camera_ball camera_ball(void)
{
    return (struct camera_ball){.low = {INFINITY, INFINITY, INFINITY},
                                .high = {-INFINITY, -INFINITY, -INFINITY}};
}

void camera_ball_box(struct camera_ball *ball, const float (*place)[3], size_t count)
{
    for (size_t v = 0; v < count; v++)
        for (int i = 0; i < 3; i++) {
            ball->low[i] = fmin(ball->low[i], (double)place[v][i]);
            ball->high[i] = fmax(ball->high[i], (double)place[v][i]);
        }
    for (int i = 0; i < 3; i++)
        ball->middle[i] = ball->low[i] <= ball->high[i] ? (ball->low[i] + ball->high[i]) / 2 : 0;
}

void camera_ball_radius(struct camera_ball *ball, const float (*place)[3], size_t count)
{
    double most = ball->radius * ball->radius;
    for (size_t v = 0; v < count; v++) {
        double d[3];
        for (int i = 0; i < 3; i++)
            d[i] = (double)place[v][i] - ball->middle[i];
        most = fmax(most, dot(d, d));
    }
    ball->radius = sqrt(most);
}

struct camera_extent camera_extent(void)
{
    return (struct camera_extent){{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
}

struct camera camera_at(const struct camera_ball *ball, double azimuth, double elevation)
{
    double a = azimuth * M_PI / 180, e = elevation * M_PI / 180;
    struct camera c = {.right = {-sin(a), cos(a), 0},
                       .up = {-sin(e) * cos(a), -sin(e) * sin(a), cos(e)},
                       .back = {cos(e) * cos(a), cos(e) * sin(a), sin(e)},
                       .distance = VIEWER_RADII * (ball->radius > 0 ? ball->radius : 1),
                       .scale = 1};
    for (int i = 0; i < 3; i++)
        c.middle[i] = ball->middle[i];
    return c;
}

struct camera_point camera_see(const struct camera *c, const float place[3])
{
    double d[3];
    for (int i = 0; i < 3; i++)
        d[i] = (double)place[i] - c->middle[i];
    double depth = c->distance - dot(d, c->back);
    return (struct camera_point){c->x + c->scale * dot(d, c->right) / depth,
                                 c->y - c->scale * dot(d, c->up) / depth, depth};
}

void camera_cover(const struct camera *c, struct camera_extent *e, const float (*place)[3], size_t count)
{
    struct camera plane = *c;
    plane.scale = 1;
    plane.x = plane.y = 0;
    for (size_t v = 0; v < count; v++) {
        struct camera_point p = camera_see(&plane, place[v]);
        e->low[0] = fmin(e->low[0], p.x);
        e->high[0] = fmax(e->high[0], p.x);
        e->low[1] = fmin(e->low[1], -p.y);
        e->high[1] = fmax(e->high[1], -p.y);
    }
}

void camera_fit(struct camera *c, const struct camera_extent *e, double width, double height, double zoom)
{
    const double size[2] = {width, height};
    double middle[2] = {0, 0};
    c->scale = INFINITY;
    for (int i = 0; i < 2; i++) {
        double covered = e->high[i] - e->low[i];
        if (covered >= 0)
            middle[i] = (e->high[i] + e->low[i]) / 2;
        if (covered > 0)
            c->scale = fmin(c->scale, size[i] * (1 - 2 * MARGIN) / covered);
    }
    c->scale = zoom * (isfinite(c->scale) ? c->scale : 1);
    c->x = width / 2 - c->scale * middle[0];
    c->y = height / 2 + c->scale * middle[1];
}

void camera_turn(const struct camera *c, const float direction[3], float turned[3])
{
    const double *const axes[3] = {c->right, c->up, c->back};
    for (int i = 0; i < 3; i++)
        turned[i] = (float)(axes[i][0] * (double)direction[0] + axes[i][1] * (double)direction[1] +
                            axes[i][2] * (double)direction[2]);
}
