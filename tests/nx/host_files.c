/* Node 0 opens files of the computer by open and fopen, as parameters and results were read and written; it
 * tells the others.
 * run: all
 */
#include <fcntl.h>
#include <string.h>
#include <unistd.h>
#include "rule.h"

static const char name[] = "host_files.tmp";

static int writes_and_reads(double *x)
{
    char line[80];
    int fd, good;
    FILE *f = fopen(name, "w");
    if (!f)
        return 0;
    fprintf(f, "# parameters\n%g\n", 2.5);
    fclose(f);
    f = fopen(name, "r");
    good = f && fgets(line, sizeof line, f) && fscanf(f, "%lf", x) == 1;
    fclose(f);
    fd = open(name, O_RDONLY);
    good = good && fd >= 0 && lseek(fd, 2, SEEK_SET) == 2 && read(fd, line, 10) == 10 &&
           memcmp(line, "parameters", 10) == 0;
    close(fd);
    return good && unlink(name) == 0 && !fopen(name, "r");
}

int main(void)
{
    double x = 0;
    int good = mynode() != 0 || writes_and_reads(&x);
    if (mynode() == 0)
        csend(1, &x, sizeof x, -1, 0);
    else
        crecv(1, &x, sizeof x);
    rule("node 0 writes and reads", good);
    rule("all know what was read", x == 2.5);
    return 0;
}
