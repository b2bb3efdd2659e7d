/* paper_notes.h - reads what paper.cfg says about single rows and messages. Internal to the reading of paper.cfg (paper.c). */
#ifndef LAB_TABLES_PAPER_NOTES_H
#define LAB_TABLES_PAPER_NOTES_H
#include "config/reader.h"
#include "lab/tables/paper.h"

/* After the tables. */
bool paper_read_notes(struct cfg_reader *r, struct paper *p);
#endif
