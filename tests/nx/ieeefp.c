/* ieeefp.h: rounding, exceptions, classes of numbers; each node has its own.
 * run: all
 */
#include <ieeefp.h>
#include <math.h>
#include "rule.h"

static volatile double one = 1, three = 3, zero, huge = 1e308, tiny = 1e-310;

static int rounds(void)
{
    volatile double nearest = one / three, up, down; /* computed where they stand */
    fp_rnd was = fpsetround(FP_RP), to;
    up = one / three;
    to = fpsetround(FP_RM);
    down = one / three;
    fpsetround(was);
    return was == FP_RN && to == FP_RP && down < up && (nearest == up || nearest == down) &&
           one / three == nearest;
}

int main(void)
{
    volatile double x;
    rule("rounding", rounds());
    fpsetsticky(0);
    x = one / zero;
    rule("division by zero is noted", (fpgetsticky() & FP_X_DZ) != 0 && !finite(x));
    rule("a set that is cleared was set", (fpsetsticky(0) & FP_X_DZ) != 0 && (fpgetsticky() & FP_X_DZ) == 0);
    rule("nothing traps at first", fpgetmask() == 0);
    rule("a mask is kept", fpsetmask(FP_X_DZ) == 0 && fpgetmask() == FP_X_DZ && fpsetmask(0) == FP_X_DZ);
    if (mynode() % 2)
        fpsetround(FP_RZ);
    gsync();
    rule("another node's rounding is its own", fpgetround() == (mynode() % 2 ? FP_RZ : FP_RN));
    fpsetround(FP_RN);
    rule("classes", fpclass(x) == FP_PINF && fpclass(-x) == FP_NINF && fpclass(x - x) == FP_QNAN &&
                        fpclass(zero) == FP_PZERO && fpclass(-one) == FP_NNORM &&
                        fpclass(tiny) == FP_PDENORM && isnand(x - x) && !isnand(huge));
    return 0;
}
