/* notes.h - reads what paper.cfg says about single rows and messages. Internal to the reading of paper.cfg (paper.c). */
#ifndef STUDY_NOTES_H
#define STUDY_NOTES_H
#include "config/reader.h"
#include "study/paper.h"

/* After the tables. */
bool paper_read_notes(struct cfg_reader *r, struct paper *p);
#endif
