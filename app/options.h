/* options.h - the options of the command line. */
#ifndef OPTIONS_H
#define OPTIONS_H
#include "grid.h"
#include "subcube.h"

enum flush { FLUSH_WAIT, FLUSH_CHUNK, FLUSH_FULL };
enum weights { WEIGHTS_SLICES, WEIGHTS_EXACT };
enum shares { SHARES_SLICES, SHARES_LAYERS };
enum prepare { PREPARE_CHUNK, PREPARE_SUBCUBE, PREPARE_ONCE };

/* How work is divided among groups and nodes. */
struct policy {
    int group;    /* nodes in a group; 0: all in one */
    int overlap;  /* read the slice above a group's last, which C0 data do not need */
    int reassign; /* deal the nodes of a finished group to the others */
    int preload;  /* read the first slices before the clock starts */
    int keep;     /* subcubes of a layer that the host leaves to its slaves */
    int gran;     /* subcubes that the host takes at a time when it helps */
    int lead;     /* a slave asks for its next chunk when so many subcubes are left */
    int min_rows; /* least rows in a chunk */
    int buffer;   /* bytes of polygons of one surface that a slave collects before it sends them */
    int buffers;  /* chunks that the host may have under way at a time */
    double k;     /* the first chunk of a layer is 1 / (k nodes) of it */
    double half;  /* a group with so many layers unfinished takes no new nodes */
    int empty;    /* a flush sends a message for a surface without polygons, too */
    enum shares shares;
    enum prepare prepare; /* how often the fit's system of equations is set up and factored */
    enum flush flush;
    enum weights weights;
};

/* EACH_HASHED: a hash of all polygons is printed. EACH_MARKED: files tell which node made a polygon. */
enum { EACH_HASHED = 1, EACH_MARKED = 2 };

struct options {
    struct grid grid;
    struct isovalues iso;
    double asked[ISOVALUES_MAX]; /* the isovalues before they were moved off the lattice */
    struct policy policy;
    const char *volume; /* file name, or NULL: the sphere */
    int bits;           /* of a pixel in the file: 8 or 16 */
    int lattice;        /* the cubic is polygonised on lattice^3 small cubes */
    int search;         /* parts of a small cube's edge that are searched for a root of the cubic */
    double outermost;   /* radius of the sphere's largest default surface, part of the shorter half side */
    const char *ply;    /* prefix of output files, or NULL */
    int parts_only;     /* leave the hosts' part files as they are */
    int each;           /* what is done with each polygon: EACH_HASHED, EACH_MARKED or both */
    int times;          /* measure and print where the time goes */
};

/* Read the command line. 0: *o is set; 1: the user asks for help; -1: an error, described in error[size]. */
int options_read(struct options *o, int argc, char **argv, char *error, int size);

extern const char options_help[];

#endif
