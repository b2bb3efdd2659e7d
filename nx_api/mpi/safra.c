/* safra.c - see safra.h. */
#include "nx_api/mpi/safra.h"
#include <assert.h>

void safra_begin(struct safra *s, uint32_t me, uint32_t count)
{
    *s = (struct safra){.me = me, .count = count, .black = true, .has_token = me == 0, .token = {0, 1}};
}

void safra_sent(struct safra *s)
{
    s->balance++;
}

void safra_received(struct safra *s)
{
    s->balance--;
    s->black = true;
}

void safra_take(struct safra *s, struct safra_token token)
{
    assert(!s->has_token);
    s->has_token = true;
    s->token = token;
}

bool safra_judge(const struct safra *s)
{
    assert(s->has_token && s->me == 0);
    return !s->black && !s->token.black && s->token.sum + s->balance == 0;
}

struct safra_token safra_pass(struct safra *s)
{
    assert(s->has_token);
    struct safra_token t = {0, 0};
    if (s->me != 0)
        t = (struct safra_token){s->token.sum + s->balance, s->token.black | s->black};
    s->black = false;
    s->has_token = false;
    return t;
}
