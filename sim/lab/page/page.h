/* page.h - what touchstone found, as one HTML file for a browser: tables, curves, timelines, surfaces. The
 * file holds all that it shows and needs, and says so to the browser: it may fetch nothing (its
 * Content-Security-Policy). doc/page.md tells users of it.
 *
 *     struct page *p = page_new();
 *     page_add(p, "out/groups", NULL, &error);        what it shows
 *     page_write(p, "Groups", stdout);                to any stream
 *     page_free(p);
 *
 * The data are written as base64 of deflated bytes, one script element of type text/plain an item
 * (data_blob.h); the scripts in web/ read them and make the sections. Figures are whole: times are
 * integers of picoseconds. */
#ifndef LAB_PAGE_PAGE_H
#define LAB_PAGE_PAGE_H
#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>
#include "lab/trace/trace_model.h"

struct page;

struct page *page_new(void);
void page_free(struct page *p);

/* Adds what is at the path, recognised by its content: results of a run (run --json), a profile (run
 * --profile), results of a study or of the tables (their files, or their folders), a trace (run --trace;
 * selection: what of it, NULL: all), a critical path (trace why --json), folded stacks, a surface (PLY).
 * False with *error, a malloc'd text that names the path. */
bool page_add(struct page *p, const char *path, const struct trace_selection *selection, char **error);
/* Adds results of a study in memory (results.json's form), which it takes over. name: as people shall read
 * it. */
void page_add_study(struct page *p, const char *name, json_t *results);
/* Adds a trace in memory, which must outlive the page. name: as people shall read it. */
void page_add_trace(struct page *p, const char *name, const struct trace *t);
/* Is a trace among what was added? */
bool page_has_trace(const struct page *p);

/* From now on the page is a live one: its scripts may ask where the page came from, and only there, for
 * what is new (web/live.js); see lab/serve/serve.h. */
void page_set_live(struct page *p);

/* Writes the page. title: NULL: made from what it shows. False if the stream has an error (errno may say
 * which). May be called several times. */
bool page_write(const struct page *p, const char *title, FILE *out);
#endif
