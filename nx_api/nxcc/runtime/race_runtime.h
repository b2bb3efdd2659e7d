/* race_runtime.h - what the code that the plugin makes for --races (race_code.h), the runtime that is linked
 * then (race_runtime.c) and GNU Fortran's library agree upon. */
#ifndef NXCC_RACE_RUNTIME_H
#define NXCC_RACE_RUNTIME_H

/* Numbers of bytes of a range that mean something else. */
#define NXC_RACE_STRING (-1)      /* the string at the address with its 0 */
#define NXC_RACE_ARRAY (-2)       /* the Fortran array whose descriptor is at the address */
#define NXC_RACE_JUMPED (-3)      /* none: a goto has left functions, with their variables */
#define NXC_RACE_PART (1ll << 62) /* added to a number: at most so many bytes of the string */

struct nxc_race_site;

/* Tells of the elements of an array, by its descriptor: nx_api/libgfortran. */
void nx_race_array(const void *descriptor, const struct nxc_race_site *site);
#endif
