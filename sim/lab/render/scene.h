/* scene.h - what a picture shows: surfaces with their colours, and a background. Colours are linear light,
 * red, green and blue from 0 to 1 (colours.h makes them). */
#ifndef LAB_RENDER_SCENE_H
#define LAB_RENDER_SCENE_H
#include <stdbool.h>
#include <stddef.h>
#include "lab/render/camera.h"
#include "lab/render/mesh.h"

enum scene_colouring { SCENE_BY_SURFACE, SCENE_BY_NODE, SCENE_BY_VERTEX };

struct scene_surface {
    struct mesh mesh; /* with normals; with nodes or colours, if it is coloured by them */
    enum scene_colouring colouring;
    float colour[3];
    float opacity; /* 0 to 1, of light that falls straight through; 1: nothing is seen through it */
};

enum { SCENE_NODE_COLOURS = 1024 }; /* nodes of larger numbers repeat them */

struct scene {
    size_t count;
    struct scene_surface *surface; /* together less than 2^32 triangles, and vertices */
    bool has_background;           /* otherwise the picture is transparent where nothing is */
    float background_top[3], background_bottom[3];
    float node_colour[SCENE_NODE_COLOURS][3], linear[256]; /* tables of colours.h */
};

/* A scene without surfaces, on a light grey background. */
struct scene *scene_new(void);
/* Adds a surface, whose mesh becomes the scene's. Makes normals if the mesh has none. */
struct scene_surface *scene_add(struct scene *scene, struct mesh *mesh);
void scene_free(struct scene *scene);

/* The ball around all surfaces. */
struct camera_ball scene_ball(const struct scene *scene);

/* Cameras in that direction and `frames - 1` others, at equal steps once around the z axis: each shows all
 * surfaces, and all have one scale, so that nothing jumps. width, height: of the picture, in pixels. */
void scene_cameras(const struct scene *scene, double azimuth, double elevation, double zoom, double width,
                   double height, struct camera *camera, unsigned frames);
#endif
