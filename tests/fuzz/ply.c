/* ply.c - surfaces in PLY files (lab/render/ply_file.h). */
#include "lab/render/ply_file.h"
#include <stdlib.h>
#include "fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    char *path = fuzz_path("fuzzed.ply"), *error = NULL;
    struct mesh mesh;
    fuzz_file("fuzzed.ply", bytes, size);
    if (ply_file_read(path, &mesh, &error))
        mesh_free(&mesh);
    else
        fuzz_refused(error, path);
    free(path);
    return 0;
}
