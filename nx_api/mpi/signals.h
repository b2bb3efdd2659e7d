/* signals.h - what a process says when it crashes, or is asked what it is doing. */
#ifndef MPI_SIGNALS_H
#define MPI_SIGNALS_H

void signals_begin(void);
#endif
