/* palette.c - see palette.h. */
#include "lab/draw/palette.h"

struct colour palette_activity(enum activity a)
{
    static const uint32_t COLOURS[] = {
        [ACTIVITY_COMPUTING] = 0x004488, [ACTIVITY_HANDLER] = 0x6fa8dc, [ACTIVITY_SYSTEM] = 0xbb5566,
        [ACTIVITY_CALL] = 0xe6b93d,      [ACTIVITY_WAITING] = 0xe9e9e9, [ACTIVITIES] = 0xffffff};
    return COLOUR(COLOURS[a]);
}

struct colour palette_level(int level)
{
    static const uint32_t STOPS[] = {0xeff9bd, 0xdaf1b3, 0xc7e9b4, 0x7fcdbb, 0x41b6c4,
                                     0x1d91c0, 0x225ea8, 0x253494, 0x081d58};
    enum { LAST = sizeof STOPS / sizeof *STOPS - 1 };
    double at = (double)level / (PALETTE_LEVELS - 1) * LAST;
    int i = at >= LAST ? LAST - 1 : (int)at;
    struct colour a = COLOUR(STOPS[i]), b = COLOUR(STOPS[i + 1]);
    double part = at - i;
    return (struct colour){a.r + (b.r - a.r) * part, a.g + (b.g - a.g) * part, a.b + (b.b - a.b) * part};
}

bool palette_is_dark(int level)
{
    return level > PALETTE_LEVELS * 5 / 8;
}
