/* search.h - the search for timings that show a fault, in rounds.
 *
 *     round 0      the usual timing: the base, which all others are compared with
 *     round 1      4 seeds: delays drawn at random, and in the manner of PCT (timing/draw.h), in turn; PCT
 *                  with depth 1, 2, ...
 *     from 2 on    16 runs, and later up to 256: half of them directed (flips.h), as far as there are flips
 *                  that no run has had; the rest seeds
 *
 * A round follows from the results of the rounds before it, and from nothing else: the same runs are made
 * with one process or many, and after an interruption. Of two runs of one order only the first is looked at.
 * Flips of places in the program that have been tried less often come first. */
#ifndef LAB_EXPLORE_SEARCH_H
#define LAB_EXPLORE_SEARCH_H
#include "lab/explore/batch.h"
#include "lab/explore/digest_set.h"
#include "lab/explore/flips.h"
#include "timing/draw.h"

/* A run that has a result. */
struct explored {
    char *name, *timing, *schedule; /* as in struct planned_run */
    struct digest key;
    size_t outcome; /* into search.outcomes */
    size_t delays;  /* how many its recording has */
    bool recorded;
};

/* Runs that count as the same. The base's is the first. */
struct outcome_group {
    char group[DIGEST_DIGITS + 1];
    json_t *record; /* of its first run */
    size_t first;   /* into search.runs */
    size_t least;   /* the run whose recording has the fewest delays */
    size_t runs;
    size_t reordered; /* of these runs: how many printed their lines in another order than the first */
    bool same_order;  /* each of its runs has an order that runs of other outcomes had before */
};

struct flip_of_run {
    struct flip flip;
    size_t run;
    unsigned tries;
};

struct search {
    const struct batch_place *place;
    struct draw draw; /* the bounds; depth: the most of PCT */
    size_t most;      /* runs in all */
    size_t round, seeds, planned;
    uint32_t base_nodes; /* of the base's recording */
    uint32_t programs;   /* of the first recording */

    struct explored *runs;
    size_t run_count;
    struct outcome_group *outcomes;
    size_t outcome_count;
    size_t failed;        /* runs without an end, or without an order */
    size_t directed;      /* runs that were directed */
    size_t pruned;        /* flips that were not tried since a run had their order */
    size_t out_of_bounds; /* flips that the bounds do not allow */
    bool times_differ;    /* runs of one order have had different outputs */

    struct digest_set orders, events, tried, keys;
    struct flip_of_run *flips;
    size_t flip_count;
    struct place_count *places; /* how often each place was tried */
    size_t place_count;
};

/* Plans the next round: *runs, malloc'd, is the caller's to free with what they hold. Returns how many there
 * are; 0: all have been made. */
size_t search_round(struct search *s, struct planned_run **runs);
/* Takes the results of the round, in the order of the plan. */
void search_take(struct search *s, const struct planned_run *runs, size_t count);
void search_free(struct search *s);

/* The bounds as flips need them. */
struct delay_bounds search_bounds(const struct search *s);
#endif
