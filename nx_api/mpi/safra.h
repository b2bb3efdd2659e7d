/* safra.h - the detection that everything has come to rest: Safra's algorithm, for one process of a ring:
 * Dijkstra, EWD 998, "Shmuel Safra's version of termination detection", 1987. Knows nothing of MPI and of
 * nodes.
 *
 *     process 0 -> 1 -> 2 -> ... -> count-1 -> 0        the way of the token
 *
 * Each process counts its messages: sent less received. One that has received is black. The token, which
 * is no message, goes round and adds up; a process passes it on only while it is at rest: it waits, and
 * only a message can end its wait. It makes the token black if it is black itself, and turns white. When
 * the token has come home, white, to a white process 0 at rest, and the sum is 0, then all processes are
 * at rest and no message is under way; and so it stays.
 *
 * Why it cannot be wrong (the invariant of EWD 998). All counts together are the messages under way.
 * While the token goes round, one of these holds; "behind" are the processes that have passed this token
 * on, but not 0:
 *   (1) those behind are at rest, and the token's sum is that of their counts,
 *   (2) the token's sum and the counts of all not behind make more than 0,
 *   (3) a process that is not behind is black, or (4) the token is black.
 * (1) holds when nobody is behind, and to pass the token on keeps it. It ends only when one behind
 * receives: a message was under way then, so all counts made more than 0, and that is (2). (2) ends only
 * when one that is not behind receives, which makes it black: (3). (3) ends only when a black one passes
 * the token on: (4). When the token is home and process 0 judges as above, (2), (3) and (4) do not hold.
 * So (1) does: all are at rest, and 0 messages are under way. */
#ifndef MPI_SAFRA_H
#define MPI_SAFRA_H
#include <stdbool.h>
#include <stdint.h>

struct safra_token {
    int64_t sum;
    int64_t black; /* 0 or 1 */
};

struct safra {
    uint32_t me, count;
    int64_t balance; /* messages sent less messages received */
    bool black;
    bool has_token;
    struct safra_token token; /* if it is here */
};

/* At the beginning process 0 has the token. */
void safra_begin(struct safra *s, uint32_t me, uint32_t count);
void safra_sent(struct safra *s);
void safra_received(struct safra *s);
/* The token has come. */
void safra_take(struct safra *s, struct safra_token token);

/* The following are for a process that has the token and is at rest. */

/* Process 0: is everything at rest, for ever? */
bool safra_judge(const struct safra *s);
/* Passes the token on, which process 0 makes a new one: to process (me + 1) % count, perhaps itself. */
struct safra_token safra_pass(struct safra *s);
#endif
