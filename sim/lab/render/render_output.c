/* render_output.c - see render_output.h. */
#include "lab/render/render_output.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include "files/atomic_file.h"
#include "kernel/xalloc.h"
#include "lab/render/colours.h"
#include "lab/render/image_write.h"
#include "lab/render/mesh_weld.h"
#include "lab/render/mesh_write.h"
#include "lab/render/ply_file.h"
#include "lab/render/render.h"

enum { TURN_MS = 8000 }; /* once around */

bool output_kind_of(const char *path, unsigned frames, enum output_kind *kind)
{
    const char *ending = strrchr(path, '.');
    *kind = frames ? OUTPUT_WEBP : OUTPUT_PNG;
    if (!strcmp(path, "-"))
        return true;
    *kind = OUTPUT_MESH;
    if (mesh_writer(path))
        return frames == 0;
    *kind = ending && !strcasecmp(ending, ".webp") ? OUTPUT_WEBP : OUTPUT_PNG;
    return *kind == OUTPUT_WEBP || (ending && !strcasecmp(ending, ".png") && frames == 0);
}

/* --- the scene --- */

static bool read_mesh(const struct output_request *r, size_t i, struct mesh *mesh, char **error)
{
    if (!ply_file_read(r->file[i], mesh, error))
        return false;
    if (r->by_node && !mesh->node) {
        *error =
            xasprintf("%s: its faces have no property node for --by node: the model writes it with -bynode",
                      r->file[i]);
        mesh_free(mesh);
        return false;
    }
    if (r->weld)
        mesh_weld(mesh);
    return true;
}

static bool encloses(const struct camera_ball *a, const struct camera_ball *b)
{
    bool larger = false;
    for (int i = 0; i < 3; i++) {
        if (a->low[i] > b->low[i] || a->high[i] < b->high[i])
            return false;
        larger = larger || a->low[i] < b->low[i] || a->high[i] > b->high[i];
    }
    return larger;
}

/* Is another surface within this one's box? Then this one should be transparent. */
static bool is_outer(const struct camera_ball *box, size_t i, size_t count)
{
    for (size_t k = 0; k < count; k++)
        if (k != i && box[k].low[0] <= box[k].high[0] && encloses(&box[i], &box[k]))
            return true;
    return false;
}

/* Surfaces around others become transparent; the more of them, the more transparent. */
static void choose_opacities(struct scene *scene)
{
    struct camera_ball box[OUTPUT_MOST_FILES];
    unsigned outer = 0;
    for (size_t i = 0; i < scene->count; i++) {
        box[i] = camera_ball();
        camera_ball_box(&box[i], (const float(*)[3])scene->surface[i].mesh.place,
                        scene->surface[i].mesh.vertex_count);
    }
    for (size_t i = 0; i < scene->count; i++)
        outer += is_outer(box, i, scene->count);
    for (size_t i = 0; i < scene->count; i++)
        if (is_outer(box, i, scene->count))
            scene->surface[i].opacity = fminf(0.35f, 1 - powf(0.25f, 1 / (float)outer));
}

/* What the request says of the surface's colour, and of its opacity. */
static void dress(const struct output_request *r, size_t i, struct scene_surface *s)
{
    if (r->by_node)
        s->colouring = SCENE_BY_NODE;
    else if (s->mesh.colour && !r->has_colour[i])
        s->colouring = SCENE_BY_VERTEX;
    if (r->has_colour[i])
        memcpy(s->colour, r->colour[i], sizeof s->colour);
    if (r->has_opacity[i])
        s->opacity = r->opacity[i];
}

static void set_background(const struct output_request *r, struct scene *scene)
{
    scene->has_background = !r->is_transparent;
    if (!r->has_background)
        return;
    memcpy(scene->background_top, r->background, sizeof r->background);
    memcpy(scene->background_bottom, r->background, sizeof r->background);
}

static void tell(const struct mesh *m, struct output_file *file)
{
    *file = (struct output_file){.vertices = m->vertex_count, .polygons = m->face_count};
}

static int by_number(const void *a, const void *b)
{
    const uint32_t *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

static void tell_nodes(const struct mesh *m, struct output_file *file)
{
    file->node = xcalloc((size_t)m->face_count + 1, sizeof *file->node);
    memcpy(file->node, m->node, m->face_count * sizeof *m->node);
    qsort(file->node, m->face_count, sizeof *file->node, by_number);
    for (uint32_t f = 0; f < m->face_count; f++)
        if (!f || file->node[f] != file->node[file->node_count - 1])
            file->node[file->node_count++] = file->node[f];
}

/* What is told of a surface after it has its colour. */
static void tell_colour(const struct scene_surface *s, struct output_file *file)
{
    if (s->colouring == SCENE_BY_NODE)
        tell_nodes(&s->mesh, file);
    file->has_colour = s->colouring == SCENE_BY_SURFACE;
    file->opacity = (double)s->opacity;
    for (int i = 0; i < 3; i++)
        file->colour[i] = colours_srgb(s->colour[i]);
}

/* NULL with *error: a file cannot be used. */
static struct scene *read_scene(const struct output_request *r, struct output_file *file, char **error)
{
    struct scene *scene = scene_new();
    uint64_t triangles = 0, vertices = 0;
    for (size_t i = 0; i < r->count; i++) {
        struct mesh mesh;
        if (!read_mesh(r, i, &mesh, error)) {
            scene_free(scene);
            return NULL;
        }
        vertices += mesh.vertex_count;
        triangles += mesh.triangle_count;
        tell(&mesh, &file[i]);
        scene_add(scene, &mesh);
    }
    if (triangles > UINT32_MAX - 1 || vertices > UINT32_MAX - 1) {
        *error = xasprintf("%ju triangles and %ju vertices are more than a picture can have: 4294967294",
                           (uintmax_t)triangles, (uintmax_t)vertices);
        scene_free(scene);
        return NULL;
    }
    choose_opacities(scene);
    for (size_t i = 0; i < r->count; i++) {
        dress(r, i, &scene->surface[i]);
        tell_colour(&scene->surface[i], &file[i]);
    }
    set_background(r, scene);
    return scene;
}

/* --- pictures --- */

static bool write_still(const struct output_request *r, const struct scene *scene, enum output_kind kind,
                        FILE *out, char **error)
{
    struct camera camera;
    struct image image = image_new(r->width, r->height);
    scene_cameras(scene, r->azimuth, r->elevation, r->zoom, r->width, r->height, &camera, 1);
    render(scene, &camera, &image);
    bool ok = kind == OUTPUT_PNG ? image_write_png(&image, out, error) : image_write_webp(&image, out, error);
    image_free(&image);
    return ok;
}

/* How long a frame is shown: the frames' times add up to TURN_MS exactly. */
static int frame_ms(unsigned frame, unsigned frames)
{
    return (int)(TURN_MS * (frame + 1) / frames - TURN_MS * frame / frames);
}

static bool add_frames(const struct output_request *r, const struct scene *scene, struct film *film,
                       char **error)
{
    struct camera camera[OUTPUT_MOST_FRAMES];
    struct image image = image_new(r->width, r->height);
    bool ok = true;
    scene_cameras(scene, r->azimuth, r->elevation, r->zoom, r->width, r->height, camera, r->frames);
    for (unsigned f = 0; f < r->frames && ok; f++) {
        render(scene, &camera[f], &image);
        ok = film_add(film, &image, frame_ms(f, r->frames), error);
        if (r->progress)
            r->progress(f + 1, r->frames);
    }
    image_free(&image);
    return ok;
}

static bool write_turntable(const struct output_request *r, const struct scene *scene, FILE *out,
                            char **error)
{
    struct film *film = film_new(r->width, r->height);
    bool ok = add_frames(r, scene, film, error) && film_write(film, out, error);
    film_free(film);
    return ok;
}

/* After an error: names the file in it. */
static void give_up(const struct output_request *r, struct atomic_file *result, char **error)
{
    char *why = *error;
    *error = xasprintf("%s cannot be written: %s", r->path, why);
    free(why);
    atomic_file_drop(result);
}

static enum output_status picture(const struct output_request *r, enum output_kind kind,
                                  struct output_file *file, char **error)
{
    struct atomic_file result;
    struct scene *scene = read_scene(r, file, error);
    if (!scene)
        return OUTPUT_BAD_INPUT;
    bool ok = atomic_file_begin(&result, r->path, error);
    if (ok) {
        ok = r->frames ? write_turntable(r, scene, result.out, error)
                       : write_still(r, scene, kind, result.out, error);
        if (ok)
            ok = atomic_file_end(&result, error);
        else
            give_up(r, &result, error);
    }
    scene_free(scene);
    return ok ? OUTPUT_DONE : OUTPUT_NOT_WRITTEN;
}

/* --- other formats --- */

static enum output_status write_meshes(const struct output_request *r, const struct mesh *meshes,
                                       char **error)
{
    const struct mesh *mesh[OUTPUT_MOST_FILES];
    const char *name[OUTPUT_MOST_FILES];
    struct atomic_file file;
    for (size_t i = 0; i < r->count; i++) {
        mesh[i] = &meshes[i];
        name[i] = basename(r->file[i]);
    }
    if (!atomic_file_begin(&file, r->path, error))
        return OUTPUT_NOT_WRITTEN;
    if (!mesh_write(mesh_writer(r->path), mesh, name, r->count, file.out, error)) {
        atomic_file_drop(&file);
        return OUTPUT_BAD_INPUT;
    }
    return atomic_file_end(&file, error) ? OUTPUT_DONE : OUTPUT_NOT_WRITTEN;
}

static enum output_status convert(const struct output_request *r, struct output_file *file, char **error)
{
    struct mesh *mesh = xcalloc(r->count, sizeof *mesh);
    enum output_status status = OUTPUT_DONE;
    for (size_t i = 0; i < r->count && status == OUTPUT_DONE; i++) {
        if (!read_mesh(r, i, &mesh[i], error))
            status = OUTPUT_BAD_INPUT;
        tell(&mesh[i], &file[i]);
    }
    if (status == OUTPUT_DONE)
        status = write_meshes(r, mesh, error);
    for (size_t i = 0; i < r->count; i++)
        mesh_free(&mesh[i]);
    free(mesh);
    return status;
}

enum output_status output_make(const struct output_request *r, struct output_file *file, char **error)
{
    enum output_kind kind;
    if (!output_kind_of(r->path, r->frames, &kind)) {
        *error = xasprintf(
            "%s: pictures are .png or .webp, turntables .webp, surfaces .ply, .obj, .stl or .vtk", r->path);
        return OUTPUT_NOT_WRITTEN;
    }
    return kind == OUTPUT_MESH ? convert(r, file, error) : picture(r, kind, file, error);
}
