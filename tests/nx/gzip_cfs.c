/* gzip_cfs.c - gzip.c with files of the CFS.
 * simulator only: on a cluster zlib opens files by itself
 * compile: -DFOLDER="/cfs/"
 * run: -m ipsc860 -n 2
 * run: -m delta -n 3
 */
#include "gzip.c"
