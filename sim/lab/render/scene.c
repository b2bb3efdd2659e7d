/* scene.c - see scene.h. */
#include "lab/render/scene.h"
#include <stdlib.h>
#include "kernel/xalloc.h"
#include "lab/render/colours.h"
#include "lab/render/mesh_normals.h"

struct scene *scene_new(void)
{
    struct scene *scene = xcalloc(1, sizeof *scene);
    scene->has_background = true;
    colours_read("fbfbfa", scene->background_top);
    colours_read("d5d8dc", scene->background_bottom);
    for (uint32_t node = 0; node < SCENE_NODE_COLOURS; node++)
        colours_of_node(node, scene->node_colour[node]);
    for (int i = 0; i < 256; i++)
        scene->linear[i] = colours_linear((uint8_t)i);
    return scene;
}

struct scene_surface *scene_add(struct scene *scene, struct mesh *mesh)
{
    scene->surface = xreallocarray(scene->surface, scene->count + 1, sizeof *scene->surface);
    struct scene_surface *s = &scene->surface[scene->count];
    *s = (struct scene_surface){.mesh = *mesh, .opacity = 1};
    colours_of_surface((unsigned)scene->count++, s->colour);
    *mesh = (struct mesh){0};
    mesh_normals(&s->mesh);
    return s;
}

void scene_free(struct scene *scene)
{
    for (size_t s = 0; scene && s < scene->count; s++)
        mesh_free(&scene->surface[s].mesh);
    if (scene)
        free(scene->surface);
    free(scene);
}

static const float (*places(const struct mesh *m))[3]
{
    return (const float(*)[3])m->place;
}

struct camera_ball scene_ball(const struct scene *scene)
{
    struct camera_ball ball = camera_ball();
    for (size_t s = 0; s < scene->count; s++)
        camera_ball_box(&ball, places(&scene->surface[s].mesh), scene->surface[s].mesh.vertex_count);
    for (size_t s = 0; s < scene->count; s++)
        camera_ball_radius(&ball, places(&scene->surface[s].mesh), scene->surface[s].mesh.vertex_count);
    return ball;
}

void scene_cameras(const struct scene *scene, double azimuth, double elevation, double zoom, double width,
                   double height, struct camera *camera, unsigned frames)
{
    struct camera_ball ball = scene_ball(scene);
    struct camera_extent extent = camera_extent();
    for (unsigned f = 0; f < frames; f++) {
        camera[f] = camera_at(&ball, azimuth + 360.0 * f / frames, elevation);
        for (size_t s = 0; s < scene->count; s++)
            camera_cover(&camera[f], &extent, places(&scene->surface[s].mesh),
                         scene->surface[s].mesh.vertex_count);
    }
    for (unsigned f = 0; f < frames; f++)
        camera_fit(&camera[f], &extent, width, height, zoom);
}
