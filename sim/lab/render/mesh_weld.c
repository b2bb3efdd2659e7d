/* mesh_weld.c - see mesh_weld.h. */
#include "lab/render/mesh_weld.h"
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include "kernel/xalloc.h"

enum { FREE_SLOT = UINT32_MAX };

static uint64_t hash(const float place[3])
{
    uint64_t h = 0;
    for (int i = 0; i < 3; i++) {
        float value = place[i] + 0.0f; /* -0 becomes 0 */
        uint32_t bits;
        memcpy(&bits, &value, sizeof bits);
        h = (h ^ bits) * 0x9e3779b97f4a7c15u;
        h ^= h >> 32;
    }
    return h;
}

static bool is_same(const float a[3], const float b[3])
{
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

uint32_t *mesh_weld_numbers(const struct mesh *m, uint32_t *places)
{
    size_t slots = 16;
    while (slots < 2 * (size_t)m->vertex_count)
        slots *= 2;
    uint32_t *first_there = xmalloc(slots * sizeof *first_there); /* the first vertex at the slot's place */
    uint32_t *number = xmalloc(m->vertex_count * sizeof *number), next = 0;
    for (size_t i = 0; i < slots; i++)
        first_there[i] = FREE_SLOT;
    for (uint32_t v = 0; v < m->vertex_count; v++) {
        size_t i = hash(m->place[v]) & (slots - 1);
        while (first_there[i] != FREE_SLOT && !is_same(m->place[first_there[i]], m->place[v]))
            i = (i + 1) & (slots - 1);
        if (first_there[i] == FREE_SLOT) {
            first_there[i] = v;
            number[v] = next++;
        } else {
            number[v] = number[first_there[i]];
        }
    }
    free(first_there);
    *places = next;
    return number;
}

static void normalise(float v[3])
{
    float length = sqrtf(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int i = 0; i < 3 && length > 0; i++)
        v[i] /= length;
}

/* Moves the first vertex of each number there. A number is at most its vertices', so nothing is lost. */
static void move_vertices(struct mesh *m, const uint32_t *number)
{
    uint32_t next = 0;
    for (uint32_t v = 0; v < m->vertex_count; v++) {
        uint32_t to = number[v];
        bool is_new = to == next;
        next += is_new;
        if (is_new)
            memmove(m->place[to], m->place[v], sizeof *m->place);
        if (is_new && m->colour)
            memmove(m->colour[to], m->colour[v], sizeof *m->colour);
        for (int i = 0; i < 3 && m->normal; i++)
            m->normal[to][i] = m->normal[v][i] + (is_new ? 0 : m->normal[to][i]);
    }
    m->vertex_count = next;
    for (uint32_t v = 0; v < next && m->normal; v++)
        normalise(m->normal[v]);
}

void mesh_weld(struct mesh *m)
{
    uint32_t places, *number = mesh_weld_numbers(m, &places);
    move_vertices(m, number);
    for (uint32_t i = 0; i < m->first[m->face_count]; i++)
        m->corner[i] = number[m->corner[i]];
    for (uint32_t t = 0; t < m->triangle_count; t++)
        for (int i = 0; i < 3; i++)
            m->triangle[t][i] = number[m->triangle[t][i]];
    free(number);
}
