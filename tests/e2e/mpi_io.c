/* mpi_io.c - MPI's files on simulated nodes: each line that rank 0 prints is a check over all ranks. What is
 * written by MPI is read by the C library, and the other way round. */
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "mpi_all.h"

static const char *folder;

static const char *path(const char *name)
{
    static char text[200];
    snprintf(text, sizeof text, "%s/%s", folder, name);
    return text;
}

static MPI_File open_file(const char *name, int amode)
{
    MPI_File file;
    MPI_File_open(MPI_COMM_WORLD, path(name), amode, MPI_INFO_NULL, &file);
    MPI_File_set_errhandler(file, MPI_ERRORS_ARE_FATAL);
    return file;
}

/* The file's ints, read by rank 0 with stdio; the others have none. */
static int ints_of(const char *name, int *into, int room)
{
    FILE *f = rank == 0 ? fopen(path(name), "rb") : NULL;
    int count = f ? (int)fread(into, sizeof *into, (size_t)room, f) : 0;
    if (f)
        fclose(f);
    return count;
}

enum { MANY = 5000 };

/* Each rank a block at its place, and the block of the next rank read back. */
static void blocks(void)
{
    static int own[MANY], other[MANY], whole[16 * MANY];
    MPI_Status status;
    MPI_Offset bytes;
    int count, next = (rank + 1) % size, holds = 1;
    MPI_File file = open_file("blocks", MPI_MODE_RDWR | MPI_MODE_CREATE);
    for (int i = 0; i < MANY; i++)
        own[i] = rank * MANY + i;
    MPI_File_set_view(file, 0, MPI_INT, MPI_INT, "native", MPI_INFO_NULL);
    MPI_File_write_at_all(file, (MPI_Offset)rank * MANY, own, MANY, MPI_INT, &status);
    MPI_Get_count(&status, MPI_INT, &count);
    holds = holds && count == MANY;
    MPI_File_sync(file);
    MPI_Barrier(MPI_COMM_WORLD);
    MPI_File_read_at(file, (MPI_Offset)next * MANY, other, MANY, MPI_INT, &status);
    for (int i = 0; i < MANY; i++)
        holds = holds && other[i] == next * MANY + i;
    MPI_File_read_at(file, (MPI_Offset)size * MANY - 10, other, MANY, MPI_INT, &status);
    MPI_Get_count(&status, MPI_INT, &count);
    MPI_File_get_size(file, &bytes);
    holds = holds && count == 10 && bytes == (MPI_Offset)size * MANY * (int)sizeof(int);
    MPI_File_close(&file);
    holds = holds && file == MPI_FILE_NULL;
    if (rank == 0)
        holds = holds && ints_of("blocks", whole, 16 * MANY) == size * MANY;
    for (int i = 0; rank == 0 && i < size * MANY; i++)
        holds = holds && whole[i] == i;
    all("blocks lie where they were written, and a read ends at the file's end", holds);
}

enum { SIDE = 12 };

/* A square of which each rank has a part, with a margin in memory. */
static void square(void)
{
    int grid[2] = {0, 0}, periods[2] = {0, 0}, at[2], whole[SIDE * SIDE], holds = 1;
    MPI_Dims_create(size, 2, grid);
    MPI_Comm comm;
    MPI_Cart_create(MPI_COMM_WORLD, 2, grid, periods, 0, &comm);
    MPI_Cart_coords(comm, rank, 2, at);
    int sizes[2] = {SIDE, SIDE}, part[2] = {SIDE / grid[0], SIDE / grid[1]};
    int starts[2] = {at[0] * part[0], at[1] * part[1]};
    int with_margin[2] = {part[0] + 2, part[1] + 2}, ones[2] = {1, 1};
    MPI_Datatype in_file, in_memory;
    MPI_Type_create_subarray(2, sizes, part, starts, MPI_ORDER_C, MPI_INT, &in_file);
    MPI_Type_create_subarray(2, with_margin, part, ones, MPI_ORDER_C, MPI_INT, &in_memory);
    MPI_Type_commit(&in_file);
    MPI_Type_commit(&in_memory);
    int *own = calloc((size_t)(with_margin[0] * with_margin[1]), sizeof *own),
        bytes = with_margin[0] * with_margin[1] * 4;
    int *back = calloc((size_t)(with_margin[0] * with_margin[1]), sizeof *back);
    for (int i = 0; i < part[0]; i++)
        for (int k = 0; k < part[1]; k++)
            own[(i + 1) * with_margin[1] + k + 1] = (starts[0] + i) * SIDE + starts[1] + k + 1;
    MPI_File file = open_file("square", MPI_MODE_RDWR | MPI_MODE_CREATE);
    MPI_File_set_view(file, 8, MPI_INT, in_file, "native", MPI_INFO_NULL);
    MPI_File_write_all(file, own, 1, in_memory, MPI_STATUS_IGNORE);
    MPI_File_seek(file, 0, MPI_SEEK_SET);
    MPI_File_read_all(file, back, 1, in_memory, MPI_STATUS_IGNORE);
    holds = memcmp(own, back, (size_t)bytes) == 0;
    MPI_File_close(&file);
    if (rank == 0) {
        FILE *f = fopen(path("square"), "rb");
        fseek(f, 8, SEEK_SET);
        holds = holds && fread(whole, sizeof(int), SIDE * SIDE + 1, f) == SIDE * SIDE;
        fclose(f);
    }
    for (int i = 0; rank == 0 && i < SIDE * SIDE; i++)
        holds = holds && whole[i] == i + 1;
    all("a square in parts with margins is whole in the file", holds);
    MPI_Type_free(&in_file);
    MPI_Type_free(&in_memory);
    MPI_Comm_free(&comm);
    free(own);
    free(back);
}

/* Every rank sees every size-th pair of ints; its pointer counts etypes of what it sees. */
static void stripes(void)
{
    int holds = 1, pair[2], count, got[40];
    MPI_Datatype stripe, spread;
    MPI_Offset place, byte;
    MPI_Status status;
    MPI_Type_vector(1, 2, 2 * size, MPI_INT, &stripe);
    MPI_Type_create_resized(stripe, 0, (MPI_Aint)(2 * size) * (int)sizeof(int), &spread);
    MPI_Type_commit(&spread);
    MPI_File file = open_file("stripes", MPI_MODE_RDWR | MPI_MODE_CREATE);
    MPI_File_set_view(file, (MPI_Offset)rank * 2 * (int)sizeof(int), MPI_INT, spread, "native",
                      MPI_INFO_NULL);
    for (int i = 0; i < 10; i++) {
        pair[0] = 100 * i + rank, pair[1] = -pair[0];
        MPI_File_write(file, pair, 2, MPI_INT, MPI_STATUS_IGNORE);
    }
    MPI_File_get_position(file, &place);
    MPI_File_get_byte_offset(file, 5, &byte);
    holds = place == 20 && byte == ((2 * 2 + 0) * size + 2 * rank / 1) * 4 + 4;
    MPI_Barrier(MPI_COMM_WORLD);
    MPI_File_seek(file, -3, MPI_SEEK_END);
    MPI_File_read(file, got, 40, MPI_INT, &status);
    MPI_Get_count(&status, MPI_INT, &count);
    MPI_File_get_position(file, &place);
    holds = holds && place == 20 && count == 3 && got[0] == -(800 + rank) && got[1] == 900 + rank;
    MPI_File_seek(file, -19, MPI_SEEK_CUR);
    MPI_File_read(file, got, 4, MPI_INT, MPI_STATUS_IGNORE);
    holds = holds && got[0] == -rank && got[1] == 100 + rank && got[2] == -got[1] && got[3] == 200 + rank;
    MPI_Type_free(&stripe);
    MPI_Type_create_hindexed_block(1, 1, &(MPI_Aint){12}, MPI_INT, &stripe); /* lb 12, extent 4 */
    MPI_Type_commit(&stripe);
    MPI_File_set_view(file, 0, MPI_INT, stripe, "native", MPI_INFO_NULL);
    MPI_File_seek(file, 0, MPI_SEEK_END);
    MPI_File_get_position(file, &place);
    holds = holds && place == 20 * size - 3;
    MPI_File_close(&file);
    MPI_Type_free(&stripe);
    MPI_Type_free(&spread);
    all("the pointer of a view with holes counts what the rank sees", holds);
}

/* One pointer for all: each record is there once. In order: those of a round lie in the order of ranks. */
static void shared(void)
{
    int record[2] = {rank, 0}, whole[2 * 3 * 16 + 40], seen[3 * 16] = {0}, holds = 1;
    MPI_Offset place;
    MPI_File file = open_file("shared", MPI_MODE_RDWR | MPI_MODE_CREATE);
    MPI_File_set_view(file, 0, MPI_INT, MPI_INT, "native", MPI_INFO_NULL);
    for (record[1] = 0; record[1] < 3; record[1]++)
        MPI_File_write_shared(file, record, 2, MPI_INT, MPI_STATUS_IGNORE);
    MPI_Barrier(MPI_COMM_WORLD);
    MPI_File_get_position_shared(file, &place);
    holds = place == 6 * size;
    MPI_File_write_ordered(file, &rank, rank == 1 ? 0 : 1, MPI_INT, MPI_STATUS_IGNORE);
    MPI_File_seek_shared(file, -(size - 1), MPI_SEEK_CUR);
    int got = -1;
    MPI_File_read_ordered(file, &got, rank == 1 ? 0 : 1, MPI_INT, MPI_STATUS_IGNORE);
    holds = holds && got == (rank == 1 ? -1 : rank);
    MPI_File_close(&file);
    if (rank == 0)
        holds = holds && ints_of("shared", whole, (int)(sizeof whole / sizeof *whole)) == 7 * size - 1;
    for (int i = 0; rank == 0 && i < 3 * size; i++)
        holds = holds && !seen[whole[2 * i] * 3 + whole[2 * i + 1]]++;
    for (int i = 0; rank == 0 && i < size - 1; i++)
        holds = holds && whole[6 * size + i] == (i ? i + 1 : 0);
    all("the shared pointer gives each record a place of its own", holds);
}

/* In atomic mode a range is one rank's. */
static void atomic(void)
{
    enum { LONG = 200000 };
    static char own[LONG], got[LONG];
    int holds = 1, flag;
    MPI_File file = open_file("atomic", MPI_MODE_RDWR | MPI_MODE_CREATE | MPI_MODE_DELETE_ON_CLOSE);
    MPI_File_set_atomicity(file, 1);
    MPI_File_get_atomicity(file, &flag);
    memset(own, 'a' + rank, LONG);
    MPI_File_write_at(file, 0, own, LONG, MPI_CHAR, MPI_STATUS_IGNORE);
    MPI_File_read_at(file, 0, got, LONG, MPI_CHAR, MPI_STATUS_IGNORE);
    for (int i = 0; i < LONG; i++)
        holds = holds && got[i] == got[0];
    MPI_File_close(&file);
    all("in atomic mode a range is one rank's", holds && flag);
    all("a file may be gone when it is closed", access(path("atomic"), F_OK) != 0);
}

static void compute(double seconds)
{
    double begin = MPI_Wtime();
    while (MPI_Wtime() - begin < seconds)
        continue;
}

/* A movement goes on while the program computes; requests of files and messages are waited for together. */
static void later(void)
{
    enum { LONG = 100000 };
    static int out[LONG], in[LONG];
    int left = (rank + size - 1) % size, holds = 1, flag = 0, index, got = -1;
    MPI_Request requests[3];
    MPI_Status statuses[3];
    for (int i = 0; i < LONG; i++)
        out[i] = rank + i;
    MPI_File file = open_file("later", MPI_MODE_RDWR | MPI_MODE_CREATE);
    MPI_Offset at = (MPI_Offset)rank * (int)sizeof out;
    double begin = MPI_Wtime();
    MPI_File_write_at(file, at, out, LONG, MPI_INT, MPI_STATUS_IGNORE);
    double writes = MPI_Wtime() - begin;
    MPI_Barrier(MPI_COMM_WORLD);
    MPI_File_iwrite_at(file, at, out, LONG, MPI_INT, &requests[0]);
    compute(3 * writes);
    MPI_Irecv(&got, 1, MPI_INT, left, 4, MPI_COMM_WORLD, &requests[1]);
    MPI_Isend(&rank, 1, MPI_INT, (rank + 1) % size, 4, MPI_COMM_WORLD, &requests[2]);
    MPI_Barrier(MPI_COMM_WORLD);
    begin = MPI_Wtime();
    MPI_Waitall(3, requests, statuses);
    MPI_Get_count(&statuses[0], MPI_INT, &index);
    holds = index == LONG && got == left && requests[0] == MPI_REQUEST_NULL;
    if (writes > 0.01) /* else it is a file of this computer */
        holds = holds && MPI_Wtime() - begin < 0.1 * writes;
    MPI_File_iread_at(file, at, in, LONG, MPI_INT, &requests[0]);
    while (!flag)
        MPI_Test(&requests[0], &flag, &statuses[0]);
    MPI_Get_count(&statuses[0], MPI_INT, &index);
    holds = holds && index == LONG && memcmp(in, out, sizeof in) == 0;
    memset(in, 0, sizeof in);
    MPI_File_iread_at(file, at, in, LONG, MPI_INT, &requests[0]);
    requests[1] = MPI_REQUEST_NULL;
    MPI_Waitany(2, requests, &index, MPI_STATUS_IGNORE);
    holds = holds && index == 0 && memcmp(in, out, sizeof in) == 0;
    memset(in, 0, sizeof in);
    MPI_File_read_at_all_begin(file, at, in, LONG, MPI_INT);
    MPI_File_read_at_all_end(file, in, &statuses[0]);
    MPI_Get_count(&statuses[0], MPI_INT, &index);
    holds = holds && index == LONG && memcmp(in, out, sizeof in) == 0;
    MPI_File_close(&file);
    all("a movement with a request goes on while the program computes", holds);
}

/* external32: the highest byte first, whatever computer reads. */
static void external(void)
{
    int value = 0x01020304 + rank, back = 0, holds = 1;
    double number = 1.5, number_back = 0;
    unsigned char bytes[4] = {0};
    char name[MPI_MAX_DATAREP_STRING];
    MPI_Datatype etype, filetype;
    MPI_Offset displacement;
    MPI_File file = open_file("external", MPI_MODE_RDWR | MPI_MODE_CREATE);
    MPI_File_set_view(file, (MPI_Offset)12 * rank, MPI_BYTE, MPI_BYTE, "external32", MPI_INFO_NULL);
    MPI_File_get_view(file, &displacement, &etype, &filetype, name);
    holds = displacement == 12 * rank && etype == MPI_BYTE && strcmp(name, "external32") == 0;
    MPI_File_write(file, &value, 1, MPI_INT, MPI_STATUS_IGNORE);
    MPI_File_write(file, &number, 1, MPI_DOUBLE, MPI_STATUS_IGNORE);
    MPI_File_seek(file, 0, MPI_SEEK_SET);
    MPI_File_read(file, &back, 1, MPI_INT, MPI_STATUS_IGNORE);
    MPI_File_read(file, &number_back, 1, MPI_DOUBLE, MPI_STATUS_IGNORE);
    MPI_File_set_view(file, 0, MPI_BYTE, MPI_BYTE, "native", MPI_INFO_NULL);
    MPI_File_read_at(file, 12 * rank, bytes, 4, MPI_BYTE, MPI_STATUS_IGNORE);
    MPI_File_close(&file);
    holds = holds && back == value && number_back == number && bytes[0] == 1 && bytes[3] == 4 + rank;
    all("external32 has the highest byte first", holds);
}

static int twice_as_long(MPI_Datatype type, MPI_Aint *extent, void *extra)
{
    MPI_Aint lb;
    MPI_Type_get_extent(type, &lb, extent);
    *extent *= *(int *)extra;
    return MPI_SUCCESS;
}

/* A representation of the program's own, which converts nothing. */
static void own_representation(void)
{
    static int twice = 2;
    char name[MPI_MAX_DATAREP_STRING];
    MPI_Datatype etype, filetype;
    MPI_Offset displacement;
    MPI_Aint extent;
    MPI_File file = open_file("own", MPI_MODE_RDWR | MPI_MODE_CREATE);
    MPI_Register_datarep("own", MPI_CONVERSION_FN_NULL, MPI_CONVERSION_FN_NULL, twice_as_long, &twice);
    int again =
        MPI_Register_datarep("own", MPI_CONVERSION_FN_NULL, MPI_CONVERSION_FN_NULL, twice_as_long, &twice);
    MPI_File_set_view(file, 0, MPI_INT, MPI_INT, "own", MPI_INFO_NULL);
    MPI_File_get_view(file, &displacement, &etype, &filetype, name);
    MPI_File_get_type_extent(file, MPI_INT, &extent);
    MPI_File_close(&file);
    all("a representation of the program's own",
        again == MPI_ERR_DUP_DATAREP && strcmp(name, "own") == 0 && extent == 2 * (MPI_Aint)sizeof(int));
}

/* All ranks begin behind what was there, also when rank 0 writes as soon as it has the file. */
static void append(void)
{
    int number = 7;
    MPI_Offset at;
    MPI_File file = open_file("append", MPI_MODE_WRONLY | MPI_MODE_CREATE);
    if (rank == 0)
        MPI_File_write(file, &number, 1, MPI_INT, MPI_STATUS_IGNORE);
    MPI_File_close(&file);
    file = open_file("append", MPI_MODE_WRONLY | MPI_MODE_APPEND);
    MPI_File_get_position(file, &at);
    if (rank == 0)
        MPI_File_write(file, &number, 1, MPI_INT, MPI_STATUS_IGNORE);
    MPI_File_close(&file);
    all("a file to append to is opened with its end, the same on all ranks", at == sizeof number);
}

static int handled;
static void on_error(MPI_File *file, int *code, ...)
{
    (void)file;
    handled = *code;
}

/* Errors return, unless the program asks for more; sizes. */
static void errors(void)
{
    MPI_File file;
    MPI_Errhandler handler;
    MPI_Offset bytes;
    int x = 0, holds, code;
    code = MPI_File_open(MPI_COMM_WORLD, path("missing"), MPI_MODE_RDONLY, MPI_INFO_NULL, &file);
    holds = code == MPI_ERR_NO_SUCH_FILE && file == MPI_FILE_NULL;
    code = MPI_File_open(MPI_COMM_WORLD, path("blocks"), MPI_MODE_RDWR | MPI_MODE_CREATE | MPI_MODE_EXCL,
                         MPI_INFO_NULL, &file);
    holds = holds && code == MPI_ERR_FILE_EXISTS;
    code =
        MPI_File_open(MPI_COMM_WORLD, path("blocks"), MPI_MODE_RDWR | MPI_MODE_RDONLY, MPI_INFO_NULL, &file);
    holds = holds && code == MPI_ERR_AMODE;
    code = MPI_File_open(MPI_COMM_WORLD, path("blocks"), rank ? MPI_MODE_RDWR : MPI_MODE_RDONLY,
                         MPI_INFO_NULL, &file);
    holds = holds && code == MPI_ERR_NOT_SAME;
    MPI_File_open(MPI_COMM_WORLD, path("blocks"), MPI_MODE_RDONLY, MPI_INFO_NULL, &file);
    holds = holds && MPI_File_write(file, &x, 1, MPI_INT, MPI_STATUS_IGNORE) == MPI_ERR_READ_ONLY;
    MPI_File_create_errhandler(on_error, &handler);
    MPI_File_set_errhandler(file, handler);
    MPI_Errhandler_free(&handler);
    MPI_File_read_at(file, -1, &x, 1, MPI_INT, MPI_STATUS_IGNORE);
    holds = holds && handled == MPI_ERR_ARG;
    MPI_File_close(&file);
    file = open_file("blocks", MPI_MODE_RDWR);
    MPI_File_set_size(file, 100);
    MPI_File_preallocate(file, 50);
    MPI_File_get_size(file, &bytes);
    holds = holds && bytes == 100;
    MPI_File_preallocate(file, 500);
    MPI_File_get_size(file, &bytes);
    holds = holds && bytes == 500;
    MPI_File_set_size(file, 5000000000); /* more than 32 bits */
    MPI_File_get_size(file, &bytes);
    holds = holds && bytes == 5000000000;
    MPI_File_set_size(file, 500);
    MPI_File_close(&file);
    if (rank == 0)
        holds = holds && MPI_File_delete(path("blocks"), MPI_INFO_NULL) == MPI_SUCCESS;
    MPI_Barrier(MPI_COMM_WORLD);
    holds = holds && MPI_File_delete(path("blocks"), MPI_INFO_NULL) == MPI_ERR_NO_SUCH_FILE;
    all("errors return, and sizes are set", holds);
}

int main(int argc, char **argv)
{
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    folder = argv[1];
    if (argc > 2) {
        MPI_File file = open_file("fatal", MPI_MODE_WRONLY | MPI_MODE_CREATE);
        MPI_File_read(file, &rank, 1, MPI_INT, MPI_STATUS_IGNORE);
    }
    blocks();
    square();
    stripes();
    shared();
    atomic();
    later();
    external();
    own_representation();
    append();
    errors();
    if (rank == 0)
        printf("after %.9f s\n", MPI_Wtime());
    MPI_Finalize();
    return 0;
}
