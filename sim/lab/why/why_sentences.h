/* why_sentences.h - the analysis of why a run took its time, in sentences that can be read aloud. */
#ifndef LAB_WHY_SENTENCES_H
#define LAB_WHY_SENTENCES_H
#include "lab/why/why.h"
#include "lab/why/why_unit.h"

/* The sentences, in paragraphs: malloc'd texts without line breaks, ended by NULL; why_sentences_free() frees
 * them. */
char **why_sentences(struct why *w);
void why_sentences_free(char **paragraphs);
#endif
