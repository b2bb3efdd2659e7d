/* mesh_write.c - see mesh_write.h. */
#include "lab/render/mesh_write.h"
#include <endian.h>
#include <math.h>
#include <string.h>
#include <strings.h>
#include "kernel/xalloc.h"

/* The surfaces that become one file, and what all of them have. */
struct surfaces {
    const struct mesh *const *mesh;
    const char *const *name;
    size_t count;
    uint64_t vertices, faces, corners, triangles;
    bool have_normals, have_colours, have_nodes;
};

/* --- numbers --- */

static void put_little(FILE *out, uint32_t value)
{
    value = htole32(value);
    fwrite(&value, sizeof value, 1, out);
}

static void put_big(FILE *out, uint32_t value)
{
    value = htobe32(value);
    fwrite(&value, sizeof value, 1, out);
}

static void put_floats(FILE *out, const float v[3], void (*put)(FILE *out, uint32_t value))
{
    for (int i = 0; i < 3; i++) {
        uint32_t bits;
        memcpy(&bits, &v[i], sizeof bits);
        put(out, bits);
    }
}

static uint32_t corners_of(const struct mesh *m, uint32_t face)
{
    return m->first[face + 1] - m->first[face];
}

/* --- PLY --- */

static bool has_long_faces(const struct surfaces *s)
{
    for (size_t k = 0; k < s->count; k++)
        for (uint32_t f = 0; f < s->mesh[k]->face_count; f++)
            if (corners_of(s->mesh[k], f) > UINT8_MAX)
                return true;
    return false;
}

static void put_ply_head(const struct surfaces *s, bool long_faces, FILE *out)
{
    fprintf(out, "ply\nformat binary_little_endian 1.0\nelement vertex %ju\n", (uintmax_t)s->vertices);
    fprintf(out, "property float x\nproperty float y\nproperty float z\n");
    if (s->have_normals)
        fprintf(out, "property float nx\nproperty float ny\nproperty float nz\n");
    if (s->have_colours)
        fprintf(out, "property uchar red\nproperty uchar green\nproperty uchar blue\n");
    fprintf(out, "element face %ju\nproperty list %s int vertex_indices\n", (uintmax_t)s->faces,
            long_faces ? "uint" : "uchar");
    fprintf(out, "%s%send_header\n", s->have_nodes ? "property int node\n" : "",
            s->count > 1 ? "property int surface\n" : "");
}

static void put_ply_faces(const struct surfaces *s, size_t k, uint32_t base, bool long_faces, FILE *out)
{
    const struct mesh *m = s->mesh[k];
    for (uint32_t f = 0; f < m->face_count; f++) {
        if (long_faces)
            put_little(out, corners_of(m, f));
        else
            fputc((int)corners_of(m, f), out);
        for (uint32_t i = m->first[f]; i < m->first[f + 1]; i++)
            put_little(out, base + m->corner[i]);
        if (s->have_nodes)
            put_little(out, m->node[f]);
        if (s->count > 1)
            put_little(out, (uint32_t)k);
    }
}

static void write_ply(const struct surfaces *s, FILE *out)
{
    bool long_faces = has_long_faces(s);
    put_ply_head(s, long_faces, out);
    for (size_t k = 0; k < s->count; k++)
        for (uint32_t v = 0; v < s->mesh[k]->vertex_count; v++) {
            put_floats(out, s->mesh[k]->place[v], put_little);
            if (s->have_normals)
                put_floats(out, s->mesh[k]->normal[v], put_little);
            if (s->have_colours)
                fwrite(s->mesh[k]->colour[v], sizeof *s->mesh[k]->colour, 1, out);
        }
    uint32_t base = 0;
    for (size_t k = 0; k < s->count; base += s->mesh[k++]->vertex_count)
        put_ply_faces(s, k, base, long_faces, out);
}

/* --- OBJ: numbers count from 1; 9 digits give a float exactly --- */

static void put_obj_vector(const char *what, const float v[3], FILE *out)
{
    fprintf(out, "%s %.9g %.9g %.9g\n", what, (double)v[0], (double)v[1], (double)v[2]);
}

static void put_obj_faces(const struct mesh *m, uint32_t base, bool normals, FILE *out)
{
    for (uint32_t f = 0; f < m->face_count; f++) {
        fputc('f', out);
        for (uint32_t i = m->first[f]; i < m->first[f + 1]; i++)
            if (normals)
                fprintf(out, " %u//%u", base + m->corner[i] + 1, base + m->corner[i] + 1);
            else
                fprintf(out, " %u", base + m->corner[i] + 1);
        fputc('\n', out);
    }
}

/* A name of a group is one word. */
static void put_obj_group(const char *name, FILE *out)
{
    fprintf(out, "g ");
    for (; *name; name++)
        fputc((unsigned char)*name > ' ' ? *name : '_', out);
    fputc('\n', out);
}

static void write_obj(const struct surfaces *s, FILE *out)
{
    uint32_t base = 0;
    fprintf(out, "# %ju vertices, %ju polygons\n", (uintmax_t)s->vertices, (uintmax_t)s->faces);
    for (size_t k = 0; k < s->count; base += s->mesh[k++]->vertex_count) {
        const struct mesh *m = s->mesh[k];
        put_obj_group(s->name[k], out);
        for (uint32_t v = 0; v < m->vertex_count; v++)
            put_obj_vector("v", m->place[v], out);
        for (uint32_t v = 0; v < m->vertex_count && s->have_normals; v++)
            put_obj_vector("vn", m->normal[v], out);
        put_obj_faces(m, base, s->have_normals, out);
    }
}

/* --- STL --- */

static void plane_of(const struct mesh *m, const uint32_t v[3], float n[3])
{
    double u[3], w[3], across[3], square = 0;
    for (int i = 0; i < 3; i++) {
        u[i] = (double)m->place[v[1]][i] - (double)m->place[v[0]][i];
        w[i] = (double)m->place[v[2]][i] - (double)m->place[v[0]][i];
    }
    for (int i = 0; i < 3; i++) {
        across[i] = u[(i + 1) % 3] * w[(i + 2) % 3] - u[(i + 2) % 3] * w[(i + 1) % 3];
        square += across[i] * across[i];
    }
    for (int i = 0; i < 3; i++)
        n[i] = square > 0 ? (float)(across[i] / sqrt(square)) : 0;
}

static void write_stl(const struct surfaces *s, FILE *out)
{
    fprintf(out, "%-80.80s", "binary STL, made by touchstone render");
    put_little(out, (uint32_t)s->triangles);
    for (size_t k = 0; k < s->count; k++)
        for (uint32_t t = 0; t < s->mesh[k]->triangle_count; t++) {
            const uint32_t *v = s->mesh[k]->triangle[t];
            float n[3];
            plane_of(s->mesh[k], v, n);
            put_floats(out, n, put_little);
            for (int i = 0; i < 3; i++)
                put_floats(out, s->mesh[k]->place[v[i]], put_little);
            fwrite("\0", 1, 2, out); /* "attributes": none */
        }
}

/* --- VTK: binary numbers are big-endian --- */

static void put_vtk_polygons(const struct surfaces *s, FILE *out)
{
    uint32_t base = 0;
    fprintf(out, "\nPOLYGONS %ju %ju\n", (uintmax_t)s->faces, (uintmax_t)(s->faces + s->corners));
    for (size_t k = 0; k < s->count; base += s->mesh[k++]->vertex_count)
        for (uint32_t f = 0; f < s->mesh[k]->face_count; f++) {
            put_big(out, corners_of(s->mesh[k], f));
            for (uint32_t i = s->mesh[k]->first[f]; i < s->mesh[k]->first[f + 1]; i++)
                put_big(out, base + s->mesh[k]->corner[i]);
        }
}

/* Data of the cells: the number of the surface and, if it is known, the node. */
static void put_vtk_cells(const struct surfaces *s, FILE *out)
{
    fprintf(out, "\nCELL_DATA %ju\nSCALARS surface int 1\nLOOKUP_TABLE default\n", (uintmax_t)s->faces);
    for (size_t k = 0; k < s->count; k++)
        for (uint32_t f = 0; f < s->mesh[k]->face_count; f++)
            put_big(out, (uint32_t)k);
    if (!s->have_nodes)
        return;
    fprintf(out, "\nSCALARS node int 1\nLOOKUP_TABLE default\n");
    for (size_t k = 0; k < s->count; k++)
        for (uint32_t f = 0; f < s->mesh[k]->face_count; f++)
            put_big(out, s->mesh[k]->node[f]);
}

static void put_vtk_vertices(const struct surfaces *s, FILE *out)
{
    if (s->have_normals || s->have_colours)
        fprintf(out, "\nPOINT_DATA %ju", (uintmax_t)s->vertices);
    if (s->have_normals)
        fprintf(out, "\nNORMALS normals float\n");
    for (size_t k = 0; k < s->count && s->have_normals; k++)
        for (uint32_t v = 0; v < s->mesh[k]->vertex_count; v++)
            put_floats(out, s->mesh[k]->normal[v], put_big);
    if (s->have_colours)
        fprintf(out, "\nCOLOR_SCALARS colour 3\n");
    for (size_t k = 0; k < s->count && s->have_colours; k++)
        fwrite(s->mesh[k]->colour, sizeof *s->mesh[k]->colour, s->mesh[k]->vertex_count, out);
}

static void write_vtk(const struct surfaces *s, FILE *out)
{
    fprintf(out, "# vtk DataFile Version 3.0\nmade by touchstone render\nBINARY\nDATASET POLYDATA\n");
    fprintf(out, "POINTS %ju float\n", (uintmax_t)s->vertices);
    for (size_t k = 0; k < s->count; k++)
        for (uint32_t v = 0; v < s->mesh[k]->vertex_count; v++)
            put_floats(out, s->mesh[k]->place[v], put_big);
    put_vtk_polygons(s, out);
    put_vtk_cells(s, out);
    put_vtk_vertices(s, out);
    fputc('\n', out);
}

/* --- which format --- */

struct mesh_writer {
    const char *ending;
    void (*write)(const struct surfaces *s, FILE *out);
};

const struct mesh_writer *mesh_writer(const char *path)
{
    static const struct mesh_writer WRITERS[] = {
        {".ply", write_ply}, {".obj", write_obj}, {".stl", write_stl}, {".vtk", write_vtk}};
    const char *ending = strrchr(path, '.');
    for (size_t i = 0; i < sizeof WRITERS / sizeof *WRITERS && ending; i++)
        if (!strcasecmp(ending, WRITERS[i].ending))
            return &WRITERS[i];
    return NULL;
}

bool mesh_write(const struct mesh_writer *writer, const struct mesh *const *mesh, const char *const *name,
                size_t count, FILE *out, char **error)
{
    struct surfaces s = {mesh, name, count, 0, 0, 0, 0, true, true, true};
    for (size_t k = 0; k < count; k++) {
        s.vertices += mesh[k]->vertex_count;
        s.faces += mesh[k]->face_count;
        s.corners += mesh[k]->first[mesh[k]->face_count];
        s.triangles += mesh[k]->triangle_count;
        s.have_normals = s.have_normals && mesh[k]->normal;
        s.have_colours = s.have_colours && mesh[k]->colour;
        s.have_nodes = s.have_nodes && mesh[k]->node;
    }
    if (s.vertices > INT32_MAX || s.faces + s.corners > INT32_MAX) {
        *error = xasprintf("%ju vertices and %ju corners are more than these files can count: 2147483647",
                           (uintmax_t)s.vertices, (uintmax_t)s.corners);
        return false;
    }
    writer->write(&s, out);
    return true;
}
