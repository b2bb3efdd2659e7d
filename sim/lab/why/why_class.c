/* why_class.c - see why_class.h. */
#include "lab/why/why_class.h"

static const struct {
    const char *name, *key, *subject;
} CLASSES[WHY_CLASSES] = {
    [WHY_COMPUTING] = {"computing", "computing", "computing"},
    [WHY_CALLS] = {"system: the program's calls", "calls", "the system's work for calls"},
    [WHY_HANDLERS] = {"handlers", "handlers", "handlers"},
    [WHY_OTHER_MESSAGES] = {"system: other messages", "other_messages",
                            "the system's work for other messages"},
    [WHY_MESSAGE] = {"system: the message itself", "message", "the system's work for messages"},
    [WHY_NETWORK] = {"network", "network", "the network"},
    [WHY_CHANNEL] = {"channel busy", "channel_busy", "contention for channels"},
    [WHY_GRANT] = {"late receiver", "late_receiver", "waiting for late receivers"},
    [WHY_FILES] = {"files", "files", "waiting for files"},
    [WHY_WAITING] = {"services, or unknown", "unknown", "waiting for services"},
    [WHY_ABSENT] = {"no program", "absent", "time without a program"},
};

const char *why_class_name(enum why_class c)
{
    return CLASSES[c].name;
}

const char *why_class_key(enum why_class c)
{
    return CLASSES[c].key;
}

const char *why_class_subject(enum why_class c)
{
    return CLASSES[c].subject;
}
