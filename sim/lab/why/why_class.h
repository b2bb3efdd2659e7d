/* why_class.h - the classes into which time is divided: of the critical path, and of a message's way. */
#ifndef LAB_WHY_CLASS_H
#define LAB_WHY_CLASS_H
#include <stdbool.h>

enum why_class {
    WHY_COMPUTING,      /* the program, outside of handlers */
    WHY_CALLS,          /* the system works for a call of the program, outside of handlers */
    WHY_HANDLERS,       /* into a handler, in it and its calls, and out of it */
    WHY_OTHER_MESSAGES, /* the system works for other messages than the one that matters */
    WHY_MESSAGE,        /* the system works for the message that matters, at either end */
    WHY_NETWORK,        /* the message, its request or its clear to send is on its way */
    WHY_CHANNEL,        /* the message waits for a channel that another message holds */
    WHY_GRANT,          /* the message waits for its receiver: for the clear to send */
    WHY_FILES,          /* a call waits for the file system */
    WHY_WAITING,        /* a call waits for a service (load, getcube), or the trace does not say for what */
    WHY_ABSENT,         /* the node had no program, or is not in the trace */
    WHY_CLASSES
};

/* "computing", "handlers" ... */
const char *why_class_name(enum why_class c);
/* The same, as a key of JSON: "computing", "other_messages" ... A class and a cause of waits that have one
 * name have one key. */
const char *why_class_key(enum why_class c);
/* What would take no time, as the subject of a sentence: "handlers", "the channels' contention" ... */
const char *why_class_subject(enum why_class c);
#endif
