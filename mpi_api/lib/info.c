/* info.c - hints: pairs of texts, which are kept and have no effect. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "lib.h"

struct pair {
    struct pair *next;
    char *key, *value;
};
struct info {
    struct object object;
    struct pair *pairs; /* in the order in which they were set */
};

static struct info *info_of(MPI_Info handle)
{
    static struct info env; /* of how the run was begun nothing is told */
    return handle == MPI_INFO_ENV ? &env : object_of(handle, INFO);
}

static int no_info(int call)
{
    return fail(NULL, call, MPI_ERR_INFO, "the info is null, or freed");
}

static struct pair **find(struct info *i, const char *key)
{
    struct pair **link = &i->pairs;
    while (*link && strcmp((*link)->key, key) != 0)
        link = &(*link)->next;
    return link;
}

CALL(Info_create, (MPI_Info * info))
{
    struct info *i = object_new(INFO, sizeof *i);
    *info = HANDLE(MPI_Info, i);
    return MPI_SUCCESS;
}

CALL(Info_set, (MPI_Info info, const char *key, const char *value))
{
    struct info *i = info_of(info);
    if (!i)
        return no_info(CALL_Info_set);
    if (!*key || strnlen(key, MPI_MAX_INFO_KEY) == MPI_MAX_INFO_KEY)
        return fail(NULL, CALL_Info_set, MPI_ERR_INFO_KEY, "the key is empty, or longer than %d letters",
                    MPI_MAX_INFO_KEY - 1);
    if (strnlen(value, MPI_MAX_INFO_VAL) == MPI_MAX_INFO_VAL)
        return fail(NULL, CALL_Info_set, MPI_ERR_INFO_VALUE, "the value is longer than %d letters",
                    MPI_MAX_INFO_VAL - 1);
    struct pair **link = find(i, key);
    if (!*link) {
        *link = calloc(1, sizeof **link);
        (*link)->key = strdup(key);
    }
    free((*link)->value);
    (*link)->value = strdup(value);
    return MPI_SUCCESS;
}

CALL(Info_get, (MPI_Info info, const char *key, int room, char *value, int *flag))
{
    struct info *i = info_of(info);
    if (!i)
        return no_info(CALL_Info_get);
    if (room < 0)
        return fail(NULL, CALL_Info_get, MPI_ERR_ARG, "room for %d letters", room);
    const struct pair *p = *find(i, key);
    *flag = p != NULL;
    if (p) {
        size_t length = strnlen(p->value, (size_t)room);
        memmove(value, p->value, length);
        value[length] = '\0';
    }
    return MPI_SUCCESS;
}

/* room: with the end of the text; the length with it, too. */
CALL(Info_get_string, (MPI_Info info, const char *key, int *room, char *value, int *flag))
{
    struct info *i = info_of(info);
    if (!i)
        return no_info(CALL_Info_get_string);
    const struct pair *p = *find(i, key);
    *flag = p != NULL;
    if (p && *room > 0)
        snprintf(value, (size_t)*room, "%s", p->value);
    if (p)
        *room = (int)strlen(p->value) + 1;
    return MPI_SUCCESS;
}

CALL(Info_create_env, (int argc, char *argv[], MPI_Info *info))
{
    (void)argc, (void)argv;
    return PMPI_Info_create(info);
}

CALL(Info_get_valuelen, (MPI_Info info, const char *key, int *length, int *flag))
{
    struct info *i = info_of(info);
    if (!i)
        return no_info(CALL_Info_get_valuelen);
    const struct pair *p = *find(i, key);
    *flag = p != NULL;
    if (p)
        *length = (int)strlen(p->value);
    return MPI_SUCCESS;
}

CALL(Info_get_nkeys, (MPI_Info info, int *count))
{
    struct info *i = info_of(info);
    if (!i)
        return no_info(CALL_Info_get_nkeys);
    *count = 0;
    for (const struct pair *p = i->pairs; p; p = p->next)
        ++*count;
    return MPI_SUCCESS;
}

CALL(Info_get_nthkey, (MPI_Info info, int n, char *key))
{
    struct info *i = info_of(info);
    if (!i)
        return no_info(CALL_Info_get_nthkey);
    const struct pair *p = i->pairs;
    for (int k = 0; p && k < n; k++)
        p = p->next;
    if (!p || n < 0)
        return fail(NULL, CALL_Info_get_nthkey, MPI_ERR_ARG, "there is no key %d", n);
    strcpy(key, p->key);
    return MPI_SUCCESS;
}

static void remove_pair(struct pair **link)
{
    struct pair *p = *link;
    *link = p->next;
    free(p->key);
    free(p->value);
    free(p);
}

CALL(Info_delete, (MPI_Info info, const char *key))
{
    struct info *i = info_of(info);
    if (!i)
        return no_info(CALL_Info_delete);
    struct pair **link = find(i, key);
    if (!*link)
        return fail(NULL, CALL_Info_delete, MPI_ERR_INFO_NOKEY, "the info has no key \"%.80s\"", key);
    remove_pair(link);
    return MPI_SUCCESS;
}

CALL(Info_dup, (MPI_Info info, MPI_Info *to))
{
    struct info *i = info_of(info);
    if (!i)
        return no_info(CALL_Info_dup);
    PMPI_Info_create(to);
    for (const struct pair *p = i->pairs; p; p = p->next)
        PMPI_Info_set(*to, p->key, p->value);
    return MPI_SUCCESS;
}

CALL(Info_free, (MPI_Info * info))
{
    struct info *i = object_of(*info, INFO); /* MPI_INFO_ENV is nobody's to free */
    if (!i)
        return no_info(CALL_Info_free);
    while (i->pairs)
        remove_pair(&i->pairs);
    if (object_leave(&i->object))
        free(i);
    *info = MPI_INFO_NULL;
    return MPI_SUCCESS;
}

int info_keep(MPI_Info *own, MPI_Info info)
{
    if (*own != MPI_INFO_NULL)
        PMPI_Info_free(own);
    return info == MPI_INFO_NULL ? MPI_SUCCESS : PMPI_Info_dup(info, own);
}

int info_give(MPI_Info own, MPI_Info *info)
{
    return own == MPI_INFO_NULL ? PMPI_Info_create(info) : PMPI_Info_dup(own, info);
}
