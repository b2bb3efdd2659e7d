/* surfaces.c - the files of the surfaces, and why a surface is empty; see surfaces.h. */
#include <stdio.h>
#include <nx.h>
#include "fail.h"
#include "host.h"
#include "part_file.h"
#include "ply.h"
#include "slices.h"
#include "surfaces.h"
#include "unreached.h"

/* The longest that a host wrote part files: time of the run, which the paper's figures do not have. */
static void print_part_seconds(int is_host)
{
    double written_s = is_host ? host.found->written_s : 0, work;

    gdhigh(&written_s, 1, &work);
    masktrap(1);
    if (mynode() == 0)
        printf("part_files_s %.6f\n", written_s);
    masktrap(0);
}

static void print_parts(const struct options *o, int surface, int group_size)
{
    char first[PART_NAME_SIZE], last[PART_NAME_SIZE];
    int hosts = (int)(numnodes() - 1) / group_size + 1;

    part_name(first, o->ply, surface, 0);
    part_name(last, o->ply, surface, (hosts - 1) * group_size);
    printf("surface_%d %s", surface, first);
    if (hosts > 1)
        printf(" to %s, %d files", last, hosts);
    printf("\n");
}

static void say_what_is_loose(const struct ply_file *f)
{
    fprintf(
        stderr,
        "model: %s: %ld of %ld vertices are not welded: node 0 has memory for %ld vertices of two layers "
        "at a time. To weld them, merge vertices at equal positions in a mesh tool, or give the nodes more "
        "memory\n",
        f->name, f->loose, f->vertices, f->room);
}

static void join(const struct options *o, int surface, int group_size)
{
    struct ply_file f = ply_join(o, surface, (int)numnodes(), group_size);

    printf("surface_%d %s, %ld polygons, %ld vertices\n", surface, f.name, f.polygons, f.vertices);
    if (f.loose > 0)
        say_what_is_loose(&f);
}

static void write_files(const struct options *o, int group_size)
{
    double start = dclock();
    int i;

    for (i = 0; i < o->iso.n; i++)
        if (o->parts_only)
            print_parts(o, i, group_size);
        else
            join(o, i, group_size);
    if (!o->parts_only)
        printf("join_s %.6f\n", dclock() - start);
}

void surfaces_end(const struct options *o, int is_host, int group_size)
{
    if (o->ply)
        print_part_seconds(is_host);
    if (mynode() != 0)
        return;
    masktrap(1);
    slices_end(); /* their memory is wanted now */
    unreached_say(o, registered.polygons);
    if (o->ply)
        write_files(o, group_size);
    masktrap(0);
}
