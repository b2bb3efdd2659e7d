/* paper_notes.h - reads paper.cfg's notes on rows, each named TABLE:NODES, and on the program's messages;
 * called by paper.c. */
#ifndef LAB_TABLES_PAPER_NOTES_H
#define LAB_TABLES_PAPER_NOTES_H
#include "config/reader.h"
#include "lab/tables/paper.h"

/* Reads the notes, all of which are optional. Call after the tables have been read. */
bool paper_read_notes(struct cfg_reader *r, struct paper *p);
#endif
