/* hostclock.h - time of the host: how long the simulator itself takes. Nothing that is simulated may depend
 * on it (virtual time: vtime.h). */
#ifndef KERNEL_HOSTCLOCK_H
#define KERNEL_HOSTCLOCK_H

/* Seconds since some moment before the process began; never goes back, whatever is done to the host's date.
 */
double hostclock_s(void);
#endif
