/* trace_format.h - the format of trace files: doc/trace-format.md describes it for those who read them
 * without this library.
 *
 *     the line "touchstone trace 1\n"
 *     a Zstandard stream of: a length and a JSON object of so many bytes (the head), then records up to
 *     RECORD_END
 *
 * A record is its kind, a byte, and its fields. A number is written in groups of seven bits, the lowest
 * first, each but the last with bit 7 set (LEB128); a signed one as 2n, or -2n - 1 (zigzag). A time is a
 * count of picoseconds, mostly of the time since another one. */
#ifndef TRACE_TRACE_FORMAT_H
#define TRACE_TRACE_FORMAT_H

#define TRACE_MAGIC "touchstone trace 1\n"

/* Names, programs and stacks are numbered from 0 in the order in which they come. "+1" is a number plus
 * one, or 0 for none. */
enum record_kind {
    RECORD_END,     /* end of the run, digest as 8 bytes */
    RECORD_NAME,    /* length, bytes: of a call */
    RECORD_PROGRAM, /* length, bytes: path */
    /* program, depth, then offsets in the program of the return addresses, innermost first: each as a signed
     * difference from the one before */
    RECORD_STACK,
    /* address, flags, name, stack +1, [signed type], signed begin since the last record of the address,
     * duration, ordered since its begin, [first order, count of sent], [source, order of the one taken,
     * how long before the end], number of waits, each: begin since the last end or the call's begin,
     * duration, busy time, flags, [signed type], [from] */
    RECORD_CALL,
    /* address, flags, signed type, stack +1, signed begin since the last record of the address, begin less
     * due, duration of the system's part, of the program's, of the system's, [source, order] */
    RECORD_HANDLER,
    /* address, task, signed: charged since the last such record's end, begin since then, duration */
    RECORD_SYSTEM,
    /* source, order, from, to, flags, signed type, bytes, signed sent since the last such record's, then
     * the times whose bits are set in the flags, each since the one before; number of blocks, each:
     * channel, begin since the last end or `entered`, duration +1 */
    RECORD_MESSAGE,
    RECORD_NODE_END, /* address, time */
    RECORD_KINDS
};

enum {
    CALL_HAS_TYPE = 1,
    CALL_UNFINISHED = 2,
    CALL_IN_HANDLER = 4,
    CALL_SENT = 8,
    CALL_TOOK = 16,
    CALL_CONTINUES = 32
};
enum { WAIT_HAS_TYPE = 1, WAIT_SENDS = 2, WAIT_HAS_FROM = 4 };
enum { HANDLER_UNFINISHED = 1, HANDLER_HAS_MESSAGE = 2 };
enum {
    MESSAGE_LONG = 1,
    MESSAGE_FIRST_TIME = 2,
    MESSAGE_HAS_PID = 256
}; /* MESSAGE_FIRST_TIME << i: the time i of enum message_time is there */
enum message_time {
    MESSAGE_ASKED,
    MESSAGE_GRANTED,
    MESSAGE_ENTERED,
    MESSAGE_MOVED,
    MESSAGE_FREED,
    MESSAGE_LEFT,
    MESSAGE_COMPLETE,
    MESSAGE_TIMES
};

#endif
