/* channel_shapes.c - see channel_shapes.h. */
#include "lab/show/channel_shapes.h"
#include "lab/show/channel_cube.h"
#include "lab/show/channel_mesh.h"

static bool is_mesh(const struct show *s)
{
    return s->trace->topo.rows > 0;
}

double channel_shapes_height(const struct show *s)
{
    return is_mesh(s) ? channel_mesh_height(s) : channel_cube_height(s);
}

void channel_shapes_draw(const struct channel_map *m, const struct canvas *c, double y, uint32_t bin)
{
    (is_mesh(m->show) ? channel_mesh_draw : channel_cube_draw)(m, c, y, bin);
}
