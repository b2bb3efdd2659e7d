/* host_section.c - see host_section.h. */
#include "config/host_section.h"
#include <math.h>

enum { MB = 1024 * 1024, MOST_MB = 512 };

static bool read_numbers(struct cfg_reader *r, config_setting_t *g, struct cfg_host *h)
{
    double clock_mhz, cpu_factor, system_factor, load_ms, cube_ms;
    uint64_t memory_mb;
    if (!cfg_number(r, g, "clock_mhz", 0.001, 100000, &clock_mhz) ||
        !cfg_number(r, g, "cpu_factor", 0.001, 1000, &cpu_factor) ||
        !cfg_whole(r, g, "memory_mb", 1, MOST_MB, &memory_mb) ||
        !cfg_number(r, g, "system_factor", 1, 1000, &system_factor) ||
        !cfg_number(r, g, "load_ms", 0, 1e6, &load_ms) || !cfg_number(r, g, "cube_ms", 0, 1e6, &cube_ms))
        return false;
    h->clock_hz = (uint64_t)llround(clock_mhz * 1e6 / cpu_factor);
    h->memory_bytes = memory_mb * MB;
    h->system_milli = (uint64_t)llround(system_factor * 1000);
    h->load_ps = (uint64_t)llround(load_ms * 1e9);
    h->cube_ps = (uint64_t)llround(cube_ms * 1e9);
    return true;
}

bool cfg_read_host(struct cfg_reader *r, struct cfg_machine *m)
{
    static const char *const KEYS[] = {"clock_mhz",        "cpu_factor",       "memory_mb", "system_factor",
                                       "link_us",          "link_ns",          "load_ms",   "cube_ms",
                                       "link_us_per_byte", "link_ns_per_byte", NULL};
    config_setting_t *g;
    struct cfg_host *h = &m->host;
    *h = (struct cfg_host){0};
    if (!config_setting_get_member(r->root, "host"))
        return true;
    if (!cfg_group(r, r->root, "host", &g) || !cfg_only(r, g, KEYS) || !read_numbers(r, g, h) ||
        !cfg_time(r, g, "link", "", &h->link_ps) ||
        !cfg_time(r, g, "link", "_per_byte", &h->link_ps_per_byte))
        return false;
    if (m->topology != CFG_HYPERCUBE)
        return cfg_fail(r, g, NULL, "a host is attached to node 0 of a hypercube; this machine is a mesh");
    if (h->link_ps_per_byte < m->short_ps_per_byte || h->link_ps_per_byte < m->long_ps_per_byte)
        return cfg_fail(r, g, "link_us_per_byte", "the link is faster than the channels between nodes");
    return true;
}
