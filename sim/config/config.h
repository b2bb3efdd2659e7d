/* config.h - machine files (libconfig) read into plain structs.
 *
 * cfg_load() reads machines/NAME.cfg (or a path), checks every value, and says file:line: key: what is wrong
 * and what is allowed. Unknown keys are errors. Times are given in microseconds or nanoseconds in the file
 * and held here in picoseconds. Every number in a machine file carries its standing (read, known, derived,
 * fitted, open) as a comment.
 */
#ifndef CONFIG_CONFIG_H
#define CONFIG_CONFIG_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include "config/touchstone_home.h"

/* The format of machine files, which touchstone --version tells. It changes when files of the old format are
 * no longer read, or mean something else. */
#define CFG_FORMAT 1

/* The machine of a run that names none; of a run with a host program. */
#define CFG_USUAL_MACHINE "delta"
#define CFG_USUAL_HOST_MACHINE "ipsc860"

enum cfg_topology { CFG_HYPERCUBE, CFG_MESH };

/* cfs = { ... }: the Concurrent File System. io_nodes 0: the machine has none. */
struct cfg_cfs {
    uint64_t io_nodes;
    uint64_t disks;         /* disk d is at I/O node d % io_nodes */
    uint64_t block_bytes;   /* a file's block b is on its disk b % disks */
    uint64_t window_blocks; /* at most so many blocks per disk of one call are under way */

    /* the program's node, in a call that reads or writes, besides that of its messages */
    uint64_t client_ps;          /* 0: none */
    uint64_t client_ps_per_byte; /* between the program's memory and the system's; 0: none */

    /* an I/O node */
    uint64_t cache_blocks;
    uint64_t
        read_ahead_blocks; /* a sequential read from disk brings the missing blocks of a group of so many */
    uint64_t write_cluster_blocks; /* a write to disk takes up to so many adjacent blocks */
    uint64_t request_ps;           /* processor time of a request, besides that of its messages */
    uint64_t copy_ps_per_byte;     /* between cache and message */

    /* a disk */
    uint64_t cylinders, cylinder_blocks;
    uint64_t seek_track_ps; /* to the next cylinder */
    uint64_t seek_ps;       /* on average */
    uint64_t rotation_ps;   /* half a turn, before every access */
    uint64_t disk_ps_per_byte;

    /* the directory process */
    uint64_t open_ps;    /* open, create, remove, rename */
    uint64_t pointer_ps; /* shared file pointers, sizes */
};

/* host = { ... }: the System Resource Manager, which runs host programs. clock_hz 0: the machine has none. */
struct cfg_host {
    /* So many clocks of a node's processor are worth a second of the host's own: clock_mhz / cpu_factor. */
    uint64_t clock_hz;
    uint64_t memory_bytes; /* for a program, its stack included */
    uint64_t system_milli; /* its system takes so many thousandths of the time that a node's takes; >= 1000 */
    uint64_t link_ps;      /* the link to node 0: each trip, besides the hops */
    uint64_t link_ps_per_byte; /* never less than between nodes */
    uint64_t load_ps;          /* load(): besides the program's bytes on the link */
    uint64_t cube_ps;          /* getcube, relcube, killcube and similar calls */
};

struct cfg_machine {
    char *name;        /* "delta" */
    char *description; /* one line for people */
    char *path;        /* the file it was read from */
    char **set;        /* settings that replaced the file's values, KEY=VALUE, ended by NULL */

    /* topology = { kind = "hypercube"; dimension = 7; } or { kind = "mesh"; rows = 16; columns = 33; } */
    enum cfg_topology topology;
    uint32_t dimension;     /* hypercube: at most 2^dimension nodes */
    uint32_t rows, columns; /* mesh: the whole machine; a user gets a rectangle of it */

    /* node = { cpu = "cpu/i860.cfg"; clock_mhz = 40.0; memory_mb = 16; system_kb = 1536; stack_kb = 512;
     *          hwclock_mhz = 10.0; cache_kb = 8; } */
    char *cpu; /* class costs the node programs are to be built with, as a path */
    uint64_t clock_hz;
    /* fast_every = 8; fast_clock_mhz = 80.0: nodes 0, 8, 16 ... have a faster (or slower) processor, for
     * programs and system alike: what if hosts were faster than their slaves? fast_every 0: none. */
    uint32_t fast_every;
    uint64_t fast_clock_hz;
    /* A program that handlers interrupt one after the other gets at least so many thousandths of its node's
     * processor; 50 where the file does not say (program_share = 0.05). 0: handlers may starve the program
     * for ever. */
    uint64_t program_milli;
    uint64_t hwclock_hz;   /* of the count that hwclock() gives; 10 MHz where the file does not say */
    uint64_t cache_bytes;  /* of the processor's data cache; 8 KB where the file does not say */
    uint64_t memory_bytes; /* all of a node's memory */
    uint64_t system_bytes; /* of which the operating system takes this much */
    uint64_t stack_bytes;  /* and the program's stack this much */

    /* net = { ... }: the channels (net/channel.h) */
    uint64_t short_hop_ps; /* a hop of a short message */
    uint64_t long_hop_ps;  /* a hop of each of the three trips of a long one */
    uint64_t short_ps_per_byte;
    uint64_t long_ps_per_byte;
    uint64_t channel_ps_per_byte; /* of a channel that is faster than the nodes; 0: not given */
    uint64_t short_limit;         /* length of the longest eager message, in bytes */

    /* system = { ... }: the processor time that NX takes */
    uint64_t call_ps;       /* any call that reads or changes the state of messages */
    uint64_t clock_call_ps; /* dclock, mclock, mynode and the like */
    uint64_t kernel_ps;     /* besides these, for a call that enters a kernel below NX; 0: NX is the kernel */
    uint64_t entry_ps;      /* and for a message that comes while the program computes; 0: likewise */
    uint64_t unix_call_ps;  /* besides these, for a call that UNIX answers; 0: NX does so itself */
    uint64_t short_send_ps; /* sender, short message */
    uint64_t short_receive_ps; /* receiver, short message */
    /* a message of a forced type that is longer than a short one; where the file does not say: as a short
     * one's */
    uint64_t forced_send_ps, forced_receive_ps;
    /* a long message: ask is the request to send, grant the clear to send (net/protocol.h) */
    uint64_t ask_send_ps;         /* sender: until the request leaves */
    uint64_t ask_receive_ps;      /* receiver: until the clear to send leaves */
    uint64_t grant_receive_ps;    /* sender: until the data leave */
    uint64_t long_receive_ps;     /* receiver: until the message is complete */
    uint64_t send_ps_per_byte;    /* sender's programmed I/O, messages that are not short */
    uint64_t receive_ps_per_byte; /* receiver's programmed I/O */
    uint64_t moves_at_once;       /* messages that a processor moves at once by it; 0: any number */
    uint64_t copy_ps_per_byte;    /* from a system buffer to the program's, if no receive was posted */
    uint64_t interrupt_ps;        /* entry to and exit from a handler, together */
    uint64_t message_ids;         /* ids one process may hold */
    /* A standard send of MPI of more bytes waits for its receive; 0: each does. */
    uint64_t mpi_eager_limit;
    uint64_t mpi_collectives; /* MPI's are made as MPICH made them in this year: 1995, or 2005 */

    struct cfg_cfs cfs;
    struct cfg_host host;
};

/* Writes the names of the machines in the folder of machine files, with `between` between them. Returns their
 * number. */
int cfg_list_machines(const char *dir, const char *between, FILE *f);
/* Is what names a machine the path of its file? It is if it contains '/' or ends in .cfg. */
bool cfg_is_path(const char *name);
/* Reads a machine file. name: a path, or else NAME of NAME.cfg, which is looked for in dir.
 * Returns NULL with *error set to a malloc'd message for the user. */
struct cfg_machine *cfg_load(const char *name, const char *dir, char **error);
/* Loads a machine as cfg_load() does, with settings KEY=VALUE applied in this order (setting.h); set is ended
 * by NULL, or is NULL. */
struct cfg_machine *cfg_load_with(const char *name, const char *dir, const char *const set[], char **error);
/* Work that takes an ordinary node's system a millisecond takes a fast node's system so many microseconds. */
uint64_t cfg_fast_system_milli(const struct cfg_machine *m);
void cfg_free(struct cfg_machine *m);
#endif
