/* page_item.h - one thing that a page shows, as it was read. */
#ifndef LAB_PAGE_PAGE_ITEM_H
#define LAB_PAGE_PAGE_ITEM_H
#include <jansson.h>
#include <stdbool.h>
#include "lab/render/mesh.h"
#include "lab/trace/trace_model.h"

/* Recognised by what the file holds, never by its name. */
enum page_kind {
    PAGE_TABLES,   /* the paper's tables: tables.json of touchstone tables */
    PAGE_STUDY,    /* results.json of touchstone study */
    PAGE_RUN,      /* touchstone run --json */
    PAGE_PROFILE,  /* touchstone run --profile */
    PAGE_TRACE,    /* touchstone run --trace */
    PAGE_DEADLOCK, /* touchstone run --deadlock */
    PAGE_PATH,     /* touchstone trace why --json */
    PAGE_STACKS,   /* folded stacks: "main;relax;csend 1234" */
    PAGE_SURFACE,  /* PLY */
    PAGE_KINDS
};

struct page_item {
    enum page_kind kind;
    char *name;       /* the path, as given */
    json_t *json;     /* the first five, and PAGE_PATH */
    json_t *deadlock; /* of a PAGE_RUN that ended in one: page_deadlock.h; NULL: it did not */
    char *text;       /* PAGE_STACKS */
    const struct trace *trace;
    struct trace *own_trace; /* the same, if the item frees it */
    struct mesh mesh;        /* PAGE_SURFACE */
};

/* Reads what is at the path. False with *error malloc'd. */
bool page_item_read(struct page_item *item, const char *path, const struct trace_selection *selection,
                    char **error);
/* A browser's numbers hold 53 bits: a larger integer becomes a text of its digits. Takes over j. */
json_t *page_json_within_53_bits(json_t *j);
/* What it is about, in a few words, malloc'd: "ring on 4 nodes of delta", or a study's title. NULL: it does
 * not say. */
char *page_item_about(const struct page_item *item);
/* What a page is called that shows nothing else: "Deadlock of ring", or the item's path; malloc'd. */
char *page_item_title(const struct page_item *item);
void page_item_free(struct page_item *item);
#endif
