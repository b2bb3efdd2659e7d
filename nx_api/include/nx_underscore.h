/* nx_underscore.h - every call of nx.h once more, with an underscore before its name. An error does not end
 * the process: the call returns -1 and sets errno (nxerrno.h). 0 or more is success; a call whose plain form
 * returns nothing returns 0. nx.h includes this file. */
#ifndef NX_UNDERSCORE_H
#define NX_UNDERSCORE_H
#ifdef __cplusplus
extern "C" {
#endif

long _csend(long type, const void *buf, long len, long node, long pid);
long _crecv(long typesel, void *buf, long len);
long _isend(long type, const void *buf, long len, long node, long pid);
long _irecv(long typesel, void *buf, long len);
long _hsend(long type, const void *buf, long len, long node, long pid,
            void (*handler)(long, long, long, long));
/* A message too long for a handler's buffer ends the process: there is no call to return from. */
long _hrecv(long typesel, void *buf, long len, void (*handler)(long, long, long, long));
long _csendrecv(long type, const void *buf, long len, long node, long pid, long typesel, void *answer,
                long room);
long _isendrecv(long type, const void *buf, long len, long node, long pid, long typesel, void *answer,
                long room);
long _hsendrecv(long type, const void *buf, long len, long node, long pid, long typesel, void *answer,
                long room, void (*handler)(long, long, long, long));
long _gsendx(long type, const void *buf, long len, const long nodes[], long count);
/* After EQMSGLONG the id is given back. */
long _msgwait(long id);
long _msgdone(long id);
long _msgcancel(long id);
long _msgignore(long id);
long _msgmerge(long first, long second);
long _cprobe(long typesel);
long _iprobe(long typesel);
long _flushmsg(long typesel, long node, long pid);
long _infocount(void);
long _infonode(void);
long _infopid(void);
long _infoptype(void);
long _infotype(void);
long _masktrap(long state);
long _crecvx(long typesel, void *buf, long len, long node, long ptype, long info[]);
long _irecvx(long typesel, void *buf, long len, long node, long ptype, long info[]);
long _hrecvx(long typesel, void *buf, long len, long node, long ptype,
             void (*handler)(long, long, long, long, long), long hparam);
long _hsendx(long type, const void *buf, long len, long node, long ptype,
             void (*handler)(long, long, long, long, long), long hparam);
long _cprobex(long typesel, long node, long ptype, long info[]);
long _iprobex(long typesel, long node, long ptype, long info[]);

long _mynode(void);
long _numnodes(void);
long _myhost(void);
long _nodedim(void);
long _myphysnode(void);
long _mypart(long *rows, long *columns);
unsigned long _mclock(void);
double _dclock(void);
long _hwclock(esize_t *ticks);
long _flick(void);
long _led(long state);
long _gray(long n);
long _ginv(long n);

long _mypid(void);
long _myptype(void);
long _setpid(long pid);
long _setptype(long ptype);
long _killproc(long node, long pid);
long _killcube(long node, long pid);
long _waitall(long node, long pid);
long _waitone(long node, long pid, long *ended_node, long *ended_pid, long *status);
long _handler(long trap, void (*function)(void));

/* Files. Errors are the C library's too: EBADF, EINVAL and others. After one, sizes are {-1, -1}. */
struct iovec;
int _gopen(const char *path, int flags, int iomode, unsigned permissions);
long _iomode(int fd);
long _setiomode(int fd, int mode);
long _cread(int fd, void *buf, unsigned long len);
long _cwrite(int fd, const void *buf, unsigned long len);
long _creadv(int fd, const struct iovec *parts, int count);
long _cwritev(int fd, const struct iovec *parts, int count);
long _iread(int fd, void *buf, unsigned long len);
long _iwrite(int fd, const void *buf, unsigned long len);
long _ireadv(int fd, const struct iovec *parts, int count);
long _iwritev(int fd, const struct iovec *parts, int count);
long _iodone(long id);
long _iowait(long id);
long _readoff(int fd, esize_t offset, void *buf, unsigned long len);
long _writeoff(int fd, esize_t offset, const void *buf, unsigned long len);
long _ireadoff(int fd, esize_t offset, void *buf, unsigned long len);
long _iwriteoff(int fd, esize_t offset, const void *buf, unsigned long len);
esize_t _eseek(int fd, esize_t offset, int whence);
long _lsize(int fd, long offset, int whence);
esize_t _esize(int fd, esize_t offset, int whence);
long _iseof(int fd);
long _restrictvol(int fd, int count, const int disks[]);

/* The global operations check lengths and pointers on this node first; an error in one of their messages ends
 * the process (silent). */
long _gsync(void);
long _gdsum(double x[], long n, double work[]);
long _gdprod(double x[], long n, double work[]);
long _gdhigh(double x[], long n, double work[]);
long _gdlow(double x[], long n, double work[]);
long _gssum(float x[], long n, float work[]);
long _gsprod(float x[], long n, float work[]);
long _gshigh(float x[], long n, float work[]);
long _gslow(float x[], long n, float work[]);
long _gisum(long x[], long n, long work[]);
long _giprod(long x[], long n, long work[]);
long _gihigh(long x[], long n, long work[]);
long _gilow(long x[], long n, long work[]);
long _giand(long x[], long n, long work[]);
long _gior(long x[], long n, long work[]);
long _gixor(long x[], long n, long work[]);
long _gland(long x[], long n, long work[]);
long _glor(long x[], long n, long work[]);
long _glxor(long x[], long n, long work[]);
long _gopf(void *x, long len, void *work, long (*f)(void *a, void *b));
long _gcolx(const void *x, const long lens[], void *y);
long _gcol(const void *x, long len, void *y, long room, long *total);

/* -1 may be a result of these calls: set errno to 0 before. After an error those that return an esize_t
 * return {-1, -1}. */
esize_t _eadd(esize_t a, esize_t b);
esize_t _esub(esize_t a, esize_t b);
esize_t _emul(esize_t a, long n);
esize_t _stoe(const char *s);
long _ediv(esize_t a, long n);
long _emod(esize_t a, long n);
long _ecmp(esize_t a, esize_t b);
long _etos(esize_t a, char *s);

#ifdef __cplusplus
}
#endif
#endif
