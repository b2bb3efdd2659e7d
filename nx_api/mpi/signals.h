/* signals.h - reports of crashes, and of what a process is doing (SIGUSR1). */
#ifndef MPI_SIGNALS_H
#define MPI_SIGNALS_H

void signals_begin(void);
#endif
