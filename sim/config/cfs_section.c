/* cfs_section.c - see cfs_section.h. Disks have the units of their makers: milliseconds, megabytes (10^6) a
 * second. */
#include "config/cfs_section.h"
#include <math.h>
#include <stdio.h>

enum { KB = 1024, MOST_IO_NODES = 1024, MOST_DISKS = 4096, MOST_BLOCKS = 1 << 20 };

static bool read_ms(struct cfg_reader *r, config_setting_t *g, const char *key, uint64_t *ps)
{
    double ms;
    if (!cfg_number(r, g, key, 0, 1e6, &ms))
        return false;
    *ps = (uint64_t)llround(ms * 1e9);
    return true;
}

/* Each I/O node has a disk at least. */
static bool read_disks(struct cfg_reader *r, config_setting_t *g, struct cfg_cfs *c)
{
    if (!cfg_whole(r, g, "io_nodes", 1, MOST_IO_NODES, &c->io_nodes) ||
        !cfg_whole(r, g, "disks", 1, MOST_DISKS, &c->disks))
        return false;
    return c->disks >= c->io_nodes ||
           cfg_fail(r, config_setting_get_member(g, "disks"), "disks",
                    "%lu is too few for io_nodes = %lu: each I/O node has a disk at least", c->disks,
                    c->io_nodes);
}

static bool read_sizes(struct cfg_reader *r, config_setting_t *g, struct cfg_cfs *c)
{
    uint64_t block_kb;
    if (!read_disks(r, g, c) || !cfg_whole(r, g, "block_kb", 1, KB, &block_kb) ||
        !cfg_whole(r, g, "window_blocks", 1, MOST_BLOCKS, &c->window_blocks) ||
        !cfg_whole(r, g, "cache_blocks", 1, MOST_BLOCKS, &c->cache_blocks) ||
        !cfg_whole(r, g, "read_ahead_blocks", 1, c->cache_blocks, &c->read_ahead_blocks) ||
        !cfg_whole(r, g, "write_cluster_blocks", 1, c->cache_blocks, &c->write_cluster_blocks) ||
        !cfg_whole(r, g, "cylinders", 1, MOST_BLOCKS, &c->cylinders) ||
        !cfg_whole(r, g, "cylinder_blocks", 1, MOST_BLOCKS, &c->cylinder_blocks))
        return false;
    c->block_bytes = block_kb * KB;
    return true;
}

/* A time that is 0 where the file does not give it. */
static bool read_time_or_none(struct cfg_reader *r, config_setting_t *g, const char *key, const char *tail,
                              uint64_t *ps)
{
    char us[32], ns[32];
    snprintf(us, sizeof us, "%s_us%s", key, tail), snprintf(ns, sizeof ns, "%s_ns%s", key, tail);
    if (!config_setting_get_member(g, us) && !config_setting_get_member(g, ns))
        return true;
    return cfg_time(r, g, key, tail, ps);
}

bool cfg_read_cfs(struct cfg_reader *r, struct cfg_cfs *c)
{
    static const char *const KEYS[] = {"io_nodes",
                                       "disks",
                                       "block_kb",
                                       "window_blocks",
                                       "cache_blocks",
                                       "read_ahead_blocks",
                                       "write_cluster_blocks",
                                       "cylinder_blocks",
                                       "cylinders",
                                       "seek_track_ms",
                                       "request_us",
                                       "request_ns",
                                       "copy_us_per_byte",
                                       "copy_ns_per_byte",
                                       "client_us",
                                       "client_ns",
                                       "client_us_per_byte",
                                       "client_ns_per_byte",
                                       "seek_ms",
                                       "rotation_ms",
                                       "disk_mb_per_s",
                                       "open_ms",
                                       "pointer_ms",
                                       NULL};
    config_setting_t *g;
    double mb_per_s;
    *c = (struct cfg_cfs){0};
    if (!config_setting_get_member(r->root, "cfs"))
        return true;
    if (!cfg_group(r, r->root, "cfs", &g) || !cfg_only(r, g, KEYS) || !read_sizes(r, g, c) ||
        !cfg_time(r, g, "request", "", &c->request_ps) ||
        !cfg_time(r, g, "copy", "_per_byte", &c->copy_ps_per_byte) ||
        !read_time_or_none(r, g, "client", "", &c->client_ps) ||
        !read_time_or_none(r, g, "client", "_per_byte", &c->client_ps_per_byte) ||
        !read_ms(r, g, "seek_track_ms", &c->seek_track_ps) || !read_ms(r, g, "seek_ms", &c->seek_ps) ||
        !read_ms(r, g, "rotation_ms", &c->rotation_ps) ||
        !cfg_number(r, g, "disk_mb_per_s", 1e-3, 1e4, &mb_per_s) || !read_ms(r, g, "open_ms", &c->open_ps) ||
        !read_ms(r, g, "pointer_ms", &c->pointer_ps))
        return false;
    if (c->seek_track_ps > c->seek_ps)
        return cfg_fail(r, g, "seek_track_ms", "is more than seek_ms, the average");
    c->disk_ps_per_byte = (uint64_t)llround(1e6 / mb_per_s);
    return true;
}
