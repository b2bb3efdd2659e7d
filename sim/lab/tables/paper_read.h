/* paper_read.h - reads the paper's tables (paper.h). */
#ifndef LAB_TABLES_PAPER_READ_H
#define LAB_TABLES_PAPER_READ_H
#include "lab/tables/paper.h"

/* Reads paper.cfg. NULL with *error malloc'd. */
struct paper *paper_read(const char *path, char **error);
#endif
