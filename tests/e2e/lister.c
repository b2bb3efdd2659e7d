/* lister.c - lists a folder as ls -l does, each node those files whose turn is its own. */
#include <dirent.h>
#include <err.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <nx.h>

int main(int argc, char **argv)
{
    const char *folder = argc > 1 ? argv[1] : ".";
    DIR *d = opendir(folder);
    struct dirent *e;
    char path[1000];
    struct stat st;
    if (!d)
        err(2, "%s", folder);
    for (long i = 0; (e = readdir(d)); i++) {
        snprintf(path, sizeof path, "%s/%s", folder, e->d_name);
        if (*e->d_name == '.' || i % numnodes() != mynode())
            continue;
        if (stat(path, &st) < 0)
            err(1, "%s", path);
        printf("%ld: %c %6ld %s\n", mynode(), S_ISDIR(st.st_mode) ? 'd' : '-', (long)st.st_size, e->d_name);
    }
    return closedir(d);
}
