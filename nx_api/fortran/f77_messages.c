/* f77_messages.c - sending, receiving, probing and message ids, from Fortran. */
#include <stdlib.h>
#include "f77_entry.h"

/* --- sending --- */

ENTRY void csend_(in *type, const void *buf, in *len, in *node, in *pid)
{
    csend(*type, buf, *len, *node, *pid);
}

ENTRY integer isend_(in *type, const void *buf, in *len, in *node, in *pid)
{
    return (integer)isend(*type, buf, *len, *node, *pid);
}

ENTRY void hsend_(in *type, const void *buf, in *len, in *node, in *pid, procedure *p)
{
    hsend(*type, buf, *len, *node, *pid, nx_fortran_handler(p, "hsend"));
}

ENTRY void hsendx_(in *type, const void *buf, in *len, in *node, in *ptype, procedure *p, in *param)
{
    hsendx(*type, buf, *len, *node, *ptype, nx_fortran_xhandler(p, "hsendx"), *param);
}

ENTRY void gsendx_(in *type, const void *buf, in *len, in nodes[], in *count)
{
    long *longs = nx_fortran_longs(nodes, *count, "gsendx");
    gsendx(*type, buf, *len, longs, *count);
    free(longs);
}

/* --- receiving --- */

ENTRY void crecv_(in *typesel, void *buf, in *len)
{
    crecv(*typesel, buf, *len);
}

ENTRY integer irecv_(in *typesel, void *buf, in *len)
{
    return (integer)irecv(*typesel, buf, *len);
}

ENTRY void hrecv_(in *typesel, void *buf, in *len, procedure *p)
{
    hrecv(*typesel, buf, *len, nx_fortran_handler(p, "hrecv"));
}

ENTRY void crecvx_(in *typesel, void *buf, in *len, in *node, in *ptype, integer info[])
{
    long longs[8];
    crecvx(*typesel, buf, *len, *node, *ptype, longs);
    nx_fortran_info(info, longs);
}

ENTRY integer irecvx_(in *typesel, void *buf, in *len, in *node, in *ptype, integer info[])
{
    long *longs = calloc(8, sizeof *longs);
    if (!longs)
        nx_fail("irecvx", ENOMEM);
    longs[0] = -1; /* no type: not filled yet */
    long id = irecvx(*typesel, buf, *len, *node, *ptype, longs);
    nx_fortran_info_at(id, info, longs);
    return (integer)id;
}

ENTRY void hrecvx_(in *typesel, void *buf, in *len, in *node, in *ptype, procedure *p, in *param)
{
    hrecvx(*typesel, buf, *len, *node, *ptype, nx_fortran_xhandler(p, "hrecvx"), *param);
}

/* --- sending and receiving the answer --- */

ENTRY integer csendrecv_(in *type, const void *buf, in *len, in *node, in *pid, in *typesel, void *answer,
                         in *room)
{
    return (integer)csendrecv(*type, buf, *len, *node, *pid, *typesel, answer, *room);
}

ENTRY integer isendrecv_(in *type, const void *buf, in *len, in *node, in *pid, in *typesel, void *answer,
                         in *room)
{
    return (integer)isendrecv(*type, buf, *len, *node, *pid, *typesel, answer, *room);
}

ENTRY void hsendrecv_(in *type, const void *buf, in *len, in *node, in *pid, in *typesel, void *answer,
                      in *room, procedure *p)
{
    hsendrecv(*type, buf, *len, *node, *pid, *typesel, answer, *room, nx_fortran_handler(p, "hsendrecv"));
}

/* --- message ids --- */

ENTRY void msgwait_(in *id)
{
    msgwait(*id);
    nx_fortran_info_done(*id);
}

ENTRY integer msgdone_(in *id)
{
    long done = msgdone(*id);
    if (done)
        nx_fortran_info_done(*id);
    return (integer)done;
}

ENTRY void msgcancel_(in *id)
{
    nx_fortran_info_forget(*id, false);
    msgcancel(*id);
}

/* INFO of an ignored receive is not filled. */
ENTRY void msgignore_(in *id)
{
    nx_fortran_info_forget(*id, true);
    msgignore(*id);
}

ENTRY integer msgmerge_(in *first, in *second)
{
    long merged = msgmerge(*first, *second);
    nx_fortran_info_merge(*first, *second, merged);
    return (integer)merged;
}

/* --- probing --- */

ENTRY void cprobe_(in *typesel)
{
    cprobe(*typesel);
}

ENTRY integer iprobe_(in *typesel)
{
    return (integer)iprobe(*typesel);
}

ENTRY void cprobex_(in *typesel, in *node, in *ptype, integer info[])
{
    long longs[8];
    cprobex(*typesel, *node, *ptype, longs);
    nx_fortran_info(info, longs);
}

ENTRY integer iprobex_(in *typesel, in *node, in *ptype, integer info[])
{
    long longs[8];
    long is_there = iprobex(*typesel, *node, *ptype, longs);
    if (is_there)
        nx_fortran_info(info, longs);
    return (integer)is_there;
}

ENTRY void flushmsg_(in *typesel, in *node, in *pid)
{
    flushmsg(*typesel, *node, *pid);
}

/* --- of the message last received --- */

#define VALUE(name)                                                                                          \
    ENTRY integer name##_(void)                                                                              \
    {                                                                                                        \
        return (integer)name();                                                                              \
    }
VALUE(infocount)
VALUE(infonode)
VALUE(infopid)
VALUE(infoptype)
VALUE(infotype)

ENTRY integer masktrap_(in *state)
{
    return (integer)masktrap(*state);
}
