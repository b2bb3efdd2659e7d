/* info_names.c - Fortran's names for the calls on hints, whose texts lose the blanks around them. */
#include "fortran.h"

#define F_INFO(x) F_HANDLE(MPI_Info, *(x))

static char *trimmed(const char *text, size_t length)
{
    while (length && *text == ' ')
        text++, length--;
    return f_text(text, length);
}

FORTRAN(info_create, (f_int * info, f_int *ierr))
{
    WITH(MPI_Info, info, MPI_Info_create(&handle));
}

FORTRAN(info_free, (f_int * info, f_int *ierr))
{
    WITH(MPI_Info, info, MPI_Info_free(&handle));
}

FORTRAN(info_dup, (f_int * info, f_int *to, f_int *ierr))
{
    WITH(MPI_Info, to, MPI_Info_dup(F_INFO(info), &handle));
}

FORTRAN(info_set,
        (f_int * info, const char *key, const char *value, f_int *ierr, size_t key_length, size_t length))
{
    char *key_text = trimmed(key, key_length), *text = trimmed(value, length);
    IERR = MPI_Info_set(F_INFO(info), key_text, text);
    free(key_text);
    free(text);
}

FORTRAN(info_get, (f_int * info, const char *key, f_int *most, char *value, f_int *flag, f_int *ierr,
                   size_t key_length, size_t room))
{
    char *key_text = trimmed(key, key_length), *text = get_memory((size_t)*most + 1);
    IERR = MPI_Info_get(F_INFO(info), key_text, *most, text, flag);
    if (!IERR && *flag)
        f_give_text(value, room, text);
    free(key_text);
    free(text);
}

FORTRAN(info_get_valuelen,
        (f_int * info, const char *key, f_int *length, f_int *flag, f_int *ierr, size_t key_length))
{
    char *key_text = trimmed(key, key_length);
    IERR = MPI_Info_get_valuelen(F_INFO(info), key_text, length, flag);
    free(key_text);
}

FORTRAN(info_delete, (f_int * info, const char *key, f_int *ierr, size_t key_length))
{
    char *key_text = trimmed(key, key_length);
    IERR = MPI_Info_delete(F_INFO(info), key_text);
    free(key_text);
}

FORTRAN(info_get_nkeys, (f_int * info, f_int *count, f_int *ierr))
{
    IERR = MPI_Info_get_nkeys(F_INFO(info), count);
}

FORTRAN(info_get_nthkey, (f_int * info, f_int *n, char *key, f_int *ierr, size_t room))
{
    char text[MPI_MAX_INFO_KEY];
    IERR = MPI_Info_get_nthkey(F_INFO(info), *n, text);
    if (!IERR)
        f_give_text(key, room, text);
}

FORTRAN(info_get_string, (f_int * info, const char *key, f_int *room, char *value, f_int *flag, f_int *ierr,
                          size_t key_length, size_t length))
{
    size_t some = *room < 0 ? 0 : (size_t)*room < length ? (size_t)*room : length;
    char *key_text = trimmed(key, key_length), *text = get_memory(some + 1);
    int most = (int)some + 1;
    IERR = MPI_Info_get_string(F_INFO(info), key_text, &most, text, flag);
    if (!IERR && *flag) {
        if (some)
            f_give_text(value, length, text);
        *room = most - 1;
    }
    free(key_text);
    free(text);
}

FORTRAN(info_create_env, (f_int * info, f_int *ierr))
{
    WITH(MPI_Info, info, MPI_Info_create_env(0, NULL, &handle));
}
