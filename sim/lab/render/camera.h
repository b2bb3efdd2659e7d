/* camera.h - the camera of a picture: where it stands, and where each point comes to be in the picture.
 *
 * The z axis points up, x and y along the ground; the axes are right-handed. The viewer looks at the middle
 * of what is seen, in perspective:
 *
 *             z |   . viewer        azimuth: the viewer's direction, in degrees from x towards y
 *               |  /                elevation: degrees above the ground
 *               | / elevation
 *               |/________ y
 *              / \
 *           x /   azimuth
 */
#ifndef LAB_RENDER_CAMERA_H
#define LAB_RENDER_CAMERA_H
#include <stddef.h>
#include <stdint.h>

struct camera {
    double right[3], up[3], back[3]; /* of length 1; back: from the middle to the viewer */
    double middle[3], distance;      /* of the viewer from the middle */
    double scale, x, y;              /* picture's x = x + scale * right / depth, y likewise, downwards */
};

/* What the camera must show: the smallest ball around the middle of a box around all points. */
struct camera_ball {
    double low[3], high[3]; /* the box; low > high: empty */
    double middle[3], radius;
};

/* camera_ball_box() is called with all points of a scene, then camera_ball_radius() with all. */
struct camera_ball camera_ball(void);
void camera_ball_box(struct camera_ball *ball, const float (*place)[3], size_t count);
void camera_ball_radius(struct camera_ball *ball, const float (*place)[3], size_t count);

/* The part of the plane of view that points cover, as right / depth and up / depth. */
struct camera_extent {
    double low[2], high[2];
};
struct camera_extent camera_extent(void);

/* A camera in that direction; it does not know yet how large the picture is. Degrees. */
struct camera camera_at(const struct camera_ball *ball, double azimuth, double elevation);
/* Widens the extent by points as the camera sees them. */
void camera_cover(const struct camera *c, struct camera_extent *e, const float (*place)[3], size_t count);
/* Sets scale, x and y: the extent fills the picture of width by height pixels but for a margin, and zoom
 * enlarges it around the middle. */
void camera_fit(struct camera *c, const struct camera_extent *e, double width, double height, double zoom);

/* A point as the camera sees it: x to the right and y down in pixels, and its depth, which is more than 0. */
struct camera_point {
    double x, y, depth;
};
struct camera_point camera_see(const struct camera *c, const float place[3]);

/* A direction in the camera's axes: right, up, back. */
void camera_turn(const struct camera *c, const float direction[3], float turned[3]);
#endif
