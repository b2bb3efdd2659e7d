/* f77_units.c - the calls on files, from Fortran. They take units, and bypass the unit's buffer. */
#include "f77_entry.h"

/* GNU Fortran's library: a unit's descriptor, or -1; and writing what a unit has buffered. */
extern integer _gfortran_fnum_i4(in *unit);
extern void _gfortran_flush_i4(in *unit);

static int fd_of(in *unit)
{
    int fd = _gfortran_fnum_i4(unit);
    if (fd >= 0)
        _gfortran_flush_i4(unit);
    return fd;
}

ENTRY void setiomode_(in *unit, in *mode)
{
    setiomode(fd_of(unit), *mode);
}

ENTRY integer iomode_(in *unit)
{
    return (integer)iomode(fd_of(unit));
}

ENTRY integer cread_(in *unit, void *buf, in *len)
{
    return (integer)cread(fd_of(unit), buf, (unsigned long)*len);
}

ENTRY integer cwrite_(in *unit, const void *buf, in *len)
{
    return (integer)cwrite(fd_of(unit), buf, (unsigned long)*len);
}

ENTRY integer iread_(in *unit, void *buf, in *len)
{
    return (integer)iread(fd_of(unit), buf, (unsigned long)*len);
}

ENTRY integer iwrite_(in *unit, const void *buf, in *len)
{
    return (integer)iwrite(fd_of(unit), buf, (unsigned long)*len);
}

ENTRY integer iodone_(in *id)
{
    return (integer)iodone(*id);
}

ENTRY integer iowait_(in *id)
{
    return (integer)iowait(*id);
}

static esize_t place(in offset[2])
{
    return (esize_t){offset[0], offset[1]};
}

ENTRY integer readoff_(in *unit, in offset[2], void *buf, in *len)
{
    return (integer)readoff(fd_of(unit), place(offset), buf, (unsigned long)*len);
}

ENTRY integer writeoff_(in *unit, in offset[2], const void *buf, in *len)
{
    return (integer)writeoff(fd_of(unit), place(offset), buf, (unsigned long)*len);
}

ENTRY integer ireadoff_(in *unit, in offset[2], void *buf, in *len)
{
    return (integer)ireadoff(fd_of(unit), place(offset), buf, (unsigned long)*len);
}

ENTRY integer iwriteoff_(in *unit, in offset[2], const void *buf, in *len)
{
    return (integer)iwriteoff(fd_of(unit), place(offset), buf, (unsigned long)*len);
}

ENTRY integer iseof_(in *unit)
{
    return (integer)iseof(fd_of(unit));
}

ENTRY integer lsize_(in *unit, in *offset, in *whence)
{
    return (integer)lsize(fd_of(unit), *offset, *whence);
}

ENTRY integer lseek_(in *unit, in *offset, in *whence)
{
    return (integer)eseek(fd_of(unit), (esize_t){*offset, *offset < 0 ? -1 : 0}, *whence).slow;
}

ENTRY void eseek_(in *unit, in offset[2], in *whence, integer now[2])
{
    esize_t e = eseek(fd_of(unit), place(offset), *whence);
    now[0] = (integer)e.slow, now[1] = (integer)e.shigh;
}

ENTRY void esize_(in *unit, in offset[2], in *whence, integer size[2])
{
    esize_t e = esize(fd_of(unit), place(offset), *whence);
    size[0] = (integer)e.slow, size[1] = (integer)e.shigh;
}

ENTRY void restrictvol_(in *unit, in *count, in disks[])
{
    restrictvol(fd_of(unit), *count, disks);
}

ENTRY void forflush_(in *unit)
{
    _gfortran_flush_i4(unit);
}
