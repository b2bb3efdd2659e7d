/* otf2_folder.c - a trace in Open Trace Format 2 (score-p.org), written by its library: a folder of a file of
 * definitions and a file of events a node, which OUT/traces.otf2 names.
 *
 * A node is a process with one location, the slices of timeline.h are regions, the clock ticks in
 * picoseconds. Messages are MpiSend and MpiRecv of one communicator, whose ranks are the nodes: readers such
 * as Vampir draw these, and pair them by nodes, type and order. The attribute `message` names the pairs; it
 * is the row of the table `messages` of csv. */
#include "lab/export/otf2_folder.h"
#include <ftw.h>
#include <otf2/otf2.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "files/atomic_file.h"
#include "kernel/xalloc.h"

enum { COMMUNICATOR = 0, ATTRIBUTE_MESSAGE = 0, EVENT_BYTES = 1 << 20, DEFINITION_BYTES = 4 << 20 };

/* Regions: the names of calls, and behind them those of timeline_name(). */
enum {
    COMPUTING,
    WAITING,
    SYSTEM,
    SYSTEM_TASK, /* and one a task behind it */
    HANDLER = SYSTEM_TASK + TRACE_EMPTYING + 1,
    OTHER_REGIONS
};

struct writing {
    const struct timeline *l;
    OTF2_Archive *archive;
    OTF2_EvtWriter *events; /* of the node under way */
    OTF2_GlobalDefWriter *definitions;
    OTF2_AttributeList *attributes;
    OTF2_StringRef strings; /* defined so far */
    uint32_t *rank;         /* of a node, among those that are traced */
    uint64_t *event_count;  /* of a rank */
    uint32_t ranks;
    char *error; /* the library's first; malloc'd */
};

/* --- the library's ways --- */

static OTF2_FlushType before_flush(void *ctx, OTF2_FileType type, OTF2_LocationRef location, void *caller,
                                   bool final)
{
    (void)ctx, (void)type, (void)location, (void)caller, (void) final;
    return OTF2_FLUSH;
}

static const OTF2_FlushCallbacks FLUSH = {before_flush, NULL};

static OTF2_ErrorCode note_error(void *ctx, const char *file, uint64_t line, const char *function,
                                 OTF2_ErrorCode code, const char *format, va_list list)
{
    struct writing *w = ctx;
    (void)file, (void)line, (void)function;
    if (code != OTF2_SUCCESS && !w->error) {
        char *more = xvasprintf(format, list);
        w->error = xasprintf("%s%s%s", OTF2_Error_GetDescription(code), *more ? ": " : "", more);
        free(more);
    }
    return code;
}

/* --- events --- */

static OTF2_RegionRef region_of(const struct writing *w, const struct timeline_slice *s)
{
    const struct trace *t = w->l->trace;
    OTF2_RegionRef others = (OTF2_RegionRef)t->name_count;
    switch (s->kind) {
    case TIMELINE_CALL:
    case TIMELINE_LIBRARY:
        return (OTF2_RegionRef)t->calls[s->index].name;
    case TIMELINE_COMPUTING:
        return others + COMPUTING;
    case TIMELINE_WAITING:
        return others + WAITING;
    case TIMELINE_SYSTEM:
        return others + (s->index == TRACE_NONE ? SYSTEM : SYSTEM_TASK + t->systems[s->index].task);
    case TIMELINE_HANDLER:
        break;
    }
    return others + HANDLER;
}

static void enter(void *ctx, const struct timeline_slice *s)
{
    struct writing *w = ctx;
    OTF2_EvtWriter_Enter(w->events, NULL, s->begin, region_of(w, s));
}

static void leave(void *ctx, const struct timeline_slice *s)
{
    struct writing *w = ctx;
    OTF2_EvtWriter_Leave(w->events, NULL, s->end, region_of(w, s));
}

static void message(void *ctx, const struct timeline_end *e)
{
    struct writing *w = ctx;
    const struct trace_message *m = &w->l->trace->messages[e->message];
    if (!timeline_has_ends(w->l, e->message))
        return;
    OTF2_AttributeList_AddUint32(w->attributes, ATTRIBUTE_MESSAGE, (uint32_t)e->message);
    if (e->taken)
        OTF2_EvtWriter_MpiRecv(w->events, w->attributes, e->at, w->rank[timeline_sender(w->l, e->message)],
                               COMMUNICATOR, (uint32_t)m->type, m->bytes);
    else
        OTF2_EvtWriter_MpiSend(w->events, w->attributes, e->at, w->rank[m->to], COMMUNICATOR,
                               (uint32_t)m->type, m->bytes);
}

static void write_events(struct writing *w, const struct export_progress *p)
{
    static const struct timeline_visitor VISITOR = {enter, leave, message};
    const struct trace *t = w->l->trace;
    OTF2_Archive_OpenEvtFiles(w->archive);
    for (int32_t i = 0; i < t->node_count && !w->error; i++) {
        if (!t->nodes[i].traced)
            continue;
        w->events = OTF2_Archive_GetEvtWriter(w->archive, w->rank[i]);
        if (!w->events)
            return;
        timeline_walk(w->l, i, &VISITOR, w);
        OTF2_EvtWriter_GetNumberOfEvents(w->events, &w->event_count[w->rank[i]]);
        OTF2_Archive_CloseEvtWriter(w->archive, w->events);
        export_progress_show(p, i);
    }
    OTF2_Archive_CloseEvtFiles(w->archive);
}

/* --- definitions --- */

/* Each location needs definitions of its own, be they none. */
static void write_local_definitions(struct writing *w)
{
    OTF2_Archive_OpenDefFiles(w->archive);
    for (uint32_t rank = 0; rank < w->ranks && !w->error; rank++) {
        OTF2_DefWriter *d = OTF2_Archive_GetDefWriter(w->archive, rank);
        if (d)
            OTF2_Archive_CloseDefWriter(w->archive, d);
    }
    OTF2_Archive_CloseDefFiles(w->archive);
}

static OTF2_StringRef define_string(struct writing *w, const char *text)
{
    OTF2_GlobalDefWriter_WriteString(w->definitions, w->strings, text ? text : "");
    return w->strings++;
}

static void define_region(struct writing *w, OTF2_RegionRef self, const char *name, OTF2_RegionRole role,
                          OTF2_Paradigm paradigm)
{
    OTF2_StringRef s = define_string(w, name), none = 0;
    OTF2_GlobalDefWriter_WriteRegion(w->definitions, self, s, s, none, role, paradigm, OTF2_REGION_FLAG_NONE,
                                     none, 0, 0);
}

static void define_call_regions(struct writing *w)
{
    static const OTF2_RegionRole ROLES[] = {[TRACE_SENDS] = OTF2_REGION_ROLE_POINT2POINT,
                                            [TRACE_RECEIVES] = OTF2_REGION_ROLE_POINT2POINT,
                                            [TRACE_GLOBAL] = OTF2_REGION_ROLE_COLL_OTHER,
                                            [TRACE_FILES] = OTF2_REGION_ROLE_FILE_IO,
                                            [TRACE_OTHER] = OTF2_REGION_ROLE_FUNCTION};
    const struct trace *t = w->l->trace;
    for (int32_t i = 0; i < t->name_count; i++)
        define_region(w, (OTF2_RegionRef)i, t->names[i], ROLES[t->classes[i]], OTF2_PARADIGM_MPI);
}

static void define_other_regions(struct writing *w)
{
    static const struct {
        const char *name;
        OTF2_RegionRole role;
        OTF2_Paradigm paradigm;
    } OTHERS[OTHER_REGIONS] = {
        [COMPUTING] = {"computing", OTF2_REGION_ROLE_CODE, OTF2_PARADIGM_USER},
        [WAITING] = {"waiting", OTF2_REGION_ROLE_ARTIFICIAL, OTF2_PARADIGM_MPI},
        [SYSTEM] = {"system", OTF2_REGION_ROLE_DATA_TRANSFER, OTF2_PARADIGM_UNKNOWN},
        [SYSTEM_TASK +
            TRACE_SENDING] = {"system: sending", OTF2_REGION_ROLE_DATA_TRANSFER, OTF2_PARADIGM_UNKNOWN},
        [SYSTEM_TASK +
            TRACE_RECEIVING] = {"system: receiving", OTF2_REGION_ROLE_DATA_TRANSFER, OTF2_PARADIGM_UNKNOWN},
        [SYSTEM_TASK +
            TRACE_FEEDING] = {"system: feeding", OTF2_REGION_ROLE_DATA_TRANSFER, OTF2_PARADIGM_UNKNOWN},
        [SYSTEM_TASK +
            TRACE_EMPTYING] = {"system: emptying", OTF2_REGION_ROLE_DATA_TRANSFER, OTF2_PARADIGM_UNKNOWN},
        [HANDLER] = {"handler", OTF2_REGION_ROLE_FUNCTION, OTF2_PARADIGM_USER},
    };
    for (int i = 0; i < OTHER_REGIONS; i++)
        define_region(w, (OTF2_RegionRef)(w->l->trace->name_count + i), OTHERS[i].name, OTHERS[i].role,
                      OTHERS[i].paradigm);
}

/* The machine, its nodes, a process on each, a location in it. */
static void define_nodes(struct writing *w)
{
    enum { MACHINE, NODES };
    const struct trace *t = w->l->trace;
    OTF2_StringRef of_machine = define_string(w, "machine"), of_node = define_string(w, "node");
    OTF2_GlobalDefWriter_WriteSystemTreeNode(w->definitions, MACHINE, define_string(w, t->machine),
                                             of_machine, OTF2_UNDEFINED_SYSTEM_TREE_NODE);
    for (int32_t i = 0; i < t->node_count; i++) {
        uint32_t rank = w->rank[i];
        if (!t->nodes[i].traced)
            continue;
        OTF2_StringRef name = define_string(w, t->nodes[i].name);
        OTF2_GlobalDefWriter_WriteSystemTreeNode(w->definitions, NODES + rank, name, of_node, MACHINE);
        OTF2_GlobalDefWriter_WriteLocationGroup(w->definitions, rank, name, OTF2_LOCATION_GROUP_TYPE_PROCESS,
                                                NODES + rank, OTF2_UNDEFINED_LOCATION_GROUP);
        OTF2_GlobalDefWriter_WriteLocation(w->definitions, rank, name, OTF2_LOCATION_TYPE_CPU_THREAD,
                                           w->event_count[rank], rank);
    }
}

static void define_communicator(struct writing *w)
{
    enum { LOCATIONS, GROUP };
    OTF2_StringRef none = 0, name = define_string(w, "all nodes");
    uint64_t *members = xcalloc(w->ranks + 1, sizeof *members);
    for (uint32_t i = 0; i < w->ranks; i++)
        members[i] = i;
    OTF2_GlobalDefWriter_WriteGroup(w->definitions, LOCATIONS, none, OTF2_GROUP_TYPE_COMM_LOCATIONS,
                                    OTF2_PARADIGM_MPI, OTF2_GROUP_FLAG_NONE, w->ranks, members);
    OTF2_GlobalDefWriter_WriteGroup(w->definitions, GROUP, none, OTF2_GROUP_TYPE_COMM_GROUP,
                                    OTF2_PARADIGM_MPI, OTF2_GROUP_FLAG_NONE, w->ranks, members);
    OTF2_GlobalDefWriter_WriteComm(w->definitions, COMMUNICATOR, name, GROUP, OTF2_UNDEFINED_COMM,
                                   OTF2_COMM_FLAG_NONE);
    free(members);
}

static void write_definitions(struct writing *w)
{
    const struct trace *t = w->l->trace;
    if (!(w->definitions = OTF2_Archive_GetGlobalDefWriter(w->archive)))
        return;
    OTF2_GlobalDefWriter_WriteClockProperties(w->definitions, VT_SECOND, t->from, t->to - t->from, 0);
    define_string(w, ""); /* the string of number 0 */
    OTF2_GlobalDefWriter_WriteAttribute(w->definitions, ATTRIBUTE_MESSAGE, define_string(w, "message"),
                                        define_string(w, "number of the message"), OTF2_TYPE_UINT32);
    define_call_regions(w);
    define_other_regions(w);
    define_nodes(w);
    define_communicator(w);
    OTF2_Archive_CloseGlobalDefWriter(w->archive, w->definitions);
}

/* --- the folder --- */

static void number_ranks(struct writing *w)
{
    const struct trace *t = w->l->trace;
    w->rank = xcalloc((size_t)t->node_count, sizeof *w->rank);
    w->event_count = xcalloc((size_t)t->node_count, sizeof *w->event_count);
    for (int32_t i = 0; i < t->node_count; i++)
        if (t->nodes[i].traced)
            w->rank[i] = w->ranks++;
}

static void write_archive(struct writing *w, const char *folder, const struct export_progress *p)
{
    w->archive = OTF2_Archive_Open(folder, "traces", OTF2_FILEMODE_WRITE, EVENT_BYTES, DEFINITION_BYTES,
                                   OTF2_SUBSTRATE_POSIX, OTF2_COMPRESSION_NONE);
    if (!w->archive)
        return;
    w->attributes = OTF2_AttributeList_New();
    number_ranks(w);
    OTF2_Archive_SetFlushCallbacks(w->archive, &FLUSH, NULL);
    OTF2_Archive_SetSerialCollectiveCallbacks(w->archive);
    OTF2_Archive_SetCreator(w->archive, "touchstone");
    OTF2_Archive_SetDescription(w->archive, w->l->trace->command);
    write_events(w, p);
    write_local_definitions(w);
    write_definitions(w);
    OTF2_Archive_Close(w->archive);
    OTF2_AttributeList_Delete(w->attributes);
    free(w->rank);
    free(w->event_count);
}

static int remove_one(const char *path, const struct stat *st, int type, struct FTW *at)
{
    (void)st, (void)type, (void)at;
    return remove(path);
}

/* Makes an empty folder beside that of the name. NULL with errno. */
static char *begin_folder(const char *folder)
{
    size_t length = strlen(folder);
    while (length > 1 && folder[length - 1] == '/')
        length--;
    char *unfinished = xasprintf("%.*s.XXXXXX", (int)length, folder);
    mode_t without = umask(0);
    umask(without);
    if (mkdtemp(unfinished) && chmod(unfinished, 0777 & ~without) == 0)
        return unfinished;
    free(unfinished);
    return NULL;
}

bool otf2_folder_write(const struct timeline *l, const char *folder, const struct export_progress *p,
                       char **error)
{
    struct writing w = {.l = l};
    struct stat st;
    if (lstat(folder, &st) == 0) {
        *error =
            xasprintf("%s is already there: otf2 makes a new folder; name another, or remove it", folder);
        return false;
    }
    char *unfinished = begin_folder(folder);
    if (!unfinished) {
        *error = xasprintf("%s cannot be made: %m", folder);
        return false;
    }
    atomic_file_drop_folder_at_signals(unfinished);
    OTF2_ErrorCallback before = OTF2_Error_RegisterCallback(note_error, &w);
    write_archive(&w, unfinished, p);
    OTF2_Error_RegisterCallback(before, NULL);
    bool ok = w.archive && !w.error && rename(unfinished, folder) == 0;
    atomic_file_drop_folder_at_signals(NULL);
    if (!ok) {
        *error = w.error ? xasprintf("%s cannot be written: %s", folder, w.error)
                         : xasprintf("%s cannot be written: %m", folder);
        nftw(unfinished, remove_one, 8, FTW_DEPTH | FTW_PHYS);
    }
    free(w.error);
    free(unfinished);
    return ok;
}
