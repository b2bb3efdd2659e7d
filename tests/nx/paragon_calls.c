/* What programs for the Paragon ask: of the machine and its partitions, and of the Parallel File System and
 * its stripes.
 * run: all
 * run: -m paragon -n 6
 * run: -m paragon95 -n 5
 */
#include <errno.h>
#include <fcntl.h>
#include <pfs/pfs.h>
#include <stdlib.h>
#include <string.h>
#include <sys/estat.h>
#include <unistd.h>
#include "rule.h"

static void ask_partitions(void)
{
    nx_part_info_t info;
    nx_nodes_t app, part, root, empty;
    unsigned long apps, parts, roots, empties;
    rule("myphysnode", myphysnode() == mynode() && _myphysnode() == mynode());
    rule("lists of nodes", nx_app_nodes(0, &app, &apps) == 0 && nx_part_nodes(".", &part, &parts) == 0 &&
                               nx_root_nodes(&root, &roots) == 0 && nx_empty_nodes(&empty, &empties) == 0);
    rule("how many", (long)apps == numnodes() && parts == apps && roots == apps && empties == 0);
    rule("which", app[mynode()] == myphysnode() && part[mynode()] == mynode() && root[mynode()] == mynode());
    free(app), free(part), free(root), free(empty);
    rule("nx_part_attr", nx_part_attr(".compute", &info) == 0 && info.nodes == numnodes() &&
                             info.mesh_x * info.mesh_y == info.nodes && info.access == 0777);
    rule("errors", nx_part_attr(".", NULL) == -1 && errno == EQPBUF && nx_root_nodes(NULL, &roots) == -1);
    rule("nx_pri", nx_pri(0, 5) == 0 && nx_pri(0, 11) == -1 && errno == EINVAL);
    rule("mcmsg_wire", mcmsg_wire(&info, sizeof info) == 0);
}

/* As MPI's ROMIO asks for it. */
static void ask_stripes(int fd)
{
    struct sattr now = {0, 0, 0}, other;
    rule("F_GETSATTR", fcntl(fd, F_GETSATTR, &now) == 0 && now.s_sunitsize > 0 && now.s_sfactor > 0 &&
                           now.s_start_sdir == 0);
    other = now;
    other.s_sfactor = 1;
    other.s_start_sdir = now.s_sfactor - 1;
    gsync();
    if (mynode() == 0)
        fcntl(fd, F_SETSATTR, &other);
    gsync();
    rule("F_SETSATTR", fcntl(fd, F_GETSATTR, &now) == 0 && memcmp(&now, &other, sizeof now) == 0);
    other.s_sunitsize *= 2;
    rule("another unit", fcntl(fd, F_SETSATTR, &other) == -1 && errno == EINVAL);
    rule("F_PFS_SVR_BUF", fcntl(fd, F_PFS_SVR_BUF, 1) == 0);
}

/* As Global Arrays' ELIO asks for it. */
static void ask_file_system(int fd)
{
    struct estatfs fs, same;
    struct statpfs stripes;
    struct estat st;
    char digits[24];
    rule("statpfs", statpfs("/pfs/stripes", &fs, &stripes, sizeof stripes) == 0 && fs.f_type == MOUNT_PFS &&
                        strcmp(fs.f_mntonname, "/pfs") == 0 && stripes.p_sunitsize > 0);
    etos(fs.f_bavail, digits);
    rule("room", atof(digits) > 1000 && ecmp(fs.f_bavail, fs.f_blocks) <= 0 && fs.f_fsize == 1024);
    rule("fstatpfs", fstatpfs(fd, &same, NULL, 0) == 0 && ecmp(same.f_blocks, fs.f_blocks) == 0 &&
                         same.f_type == MOUNT_PFS);
    rule("of another file system", statpfs("/", &fs, &stripes, sizeof stripes) == 0 &&
                                       fs.f_type == MOUNT_UFS && stripes.p_sunitsize == 0);
    rule("of no file", statpfs("/pfs/no/such", &fs, 0, 0) == -1 && errno == ENOENT);
    rule("lestat",
         lestat("/pfs/stripes", &st) == 0 && st.st_size.slow == 0 && _lestat("/nowhere", &st) == -1);
}

int main(void)
{
    int fd;
    ask_partitions();
    fd = gopen("/pfs/stripes", O_RDWR | O_CREAT | O_TRUNC, M_UNIX, 0644);
    ask_stripes(fd);
    ask_file_system(fd);
    rule("closed", (close(fd), fcntl(fd, F_GETSATTR, &fd)) == -1 && errno == EBADF);
    gsync();
    if (mynode() == 0)
        unlink("/pfs/stripes");
    errno = EQNODE;
    if (mynode() == 0)
        nx_perror("nx_perror");
    return 0;
}
