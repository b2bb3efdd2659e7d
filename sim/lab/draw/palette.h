/* palette.h - the colours. Activities: after Tol's high-contrast scheme (Colour Schemes,
 * SRON/EPS/TN/09-002), told apart by colour-blind eyes and, by their lightness, in grey print. Amounts:
 * ColorBrewer's YlGnBu, the darker the more, in levels, so that neighbours of one level are one shape. */
#ifndef LAB_DRAW_PALETTE_H
#define LAB_DRAW_PALETTE_H
#include "lab/draw/canvas.h"
#include "lab/draw/state_times.h"

struct colour palette_activity(enum activity a);

enum { PALETTE_LEVELS = 24 };
struct colour palette_level(int level); /* 0 to PALETTE_LEVELS - 1 */
/* Is a dark text unreadable on it? */
bool palette_is_dark(int level);
#endif
