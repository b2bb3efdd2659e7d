/* The calls on files with an underscore return -1 and set errno, on files of the CFS and of this computer.
 * again: --long32
 * run: -m ipsc860 -n 2
 * run: -m delta -n 3
 */
#include <estat.h>
#include <fcntl.h>
#include <nx.h>
#include <stdio.h>
#include <unistd.h>

static char buf[10000];

static void expect(const char *what, long result, int error)
{
    if (result != -1 || errno != error)
        printf("%s: %ld, errno %d\n", what, result, errno);
    errno = 0;
}

/* A gopen that fails leaves no file open. */
static void keep_none(void)
{
    int before = open("/cfs/b", O_RDWR | O_CREAT, 0666);
    close(before);
    expect("no mode", _gopen("/cfs/b", O_RDWR, 9, 0), EINVAL);
    int after = open("/cfs/b", O_RDWR);
    if (after != before)
        printf("file %d, then %d\n", before, after);
    close(after);
}

static void stream(void)
{
    FILE *f = fopen("/cfs/c", "w");
    if (_lsize(fileno(f), 100, SIZE_SET) < 100 || _setiomode(fileno(f), M_LOG) != 0)
        printf("a stream's file is none of the CFS\n");
    fclose(f);
}

static void errors(int fd)
{
    struct estat st;
    esize_t five = {5, 0}, at;
    expect("no file", _cread(77, buf, 1), EBADF);
    expect("no file", _iwrite(77, buf, 1), EBADF);
    expect("null pointer", _cread(fd, 0, 1), EQPBUF);
    expect("null pointer", _iread(fd, 0, 1), EQPBUF);
    expect("no id", _iowait(3), EQMID);
    expect("no id", _iodone(0), EQMID);
    expect("no mode", _setiomode(fd, 9), EINVAL);
    expect("no disks", _restrictvol(fd, 1, 0), EINVAL);
    expect("no such file", _estat("/cfs/none", &st), ENOENT);
    expect("no such file", _estat("/none/at/all", &st), ENOENT);
    at = _eseek(77, five, SIZE_SET);
    expect("no file", at.slow, EBADF);
    at = _eseek(fd, five, SIZE_SET);
    printf("eseek %ld\n", at.slow);
}

int main(void)
{
    struct estat st;
    int fd;
    long id;
    expect("gopen", _gopen("/cfs/none", O_RDONLY, M_UNIX, 0), ENOENT);
    fd = _gopen("/cfs/a", O_RDWR | O_CREAT | O_TRUNC, M_UNIX, 0666);
    if (mynode() == 0) {
        errors(fd);
        _eseek(fd, (esize_t){0, 0}, SIZE_SET);
        printf("wrote %ld\n", _cwrite(fd, buf, sizeof buf));
        id = _iread(fd, buf, 10);
        printf("iowait %ld\n", _iowait(id));
        _festat(fd, &st);
        printf("size %ld, end %ld, mode %ld\n", st.st_size.slow, _iseof(fd), _iomode(fd));
    }
    keep_none();
    stream();
    gsync();
    setiomode(fd, 9); /* ends this process with an error */
    return 0;
}
