/* tsearch.c - a sorted tree of the program's pointers: an AVL tree, whose branches differ by one level at
 * most. The program takes a node for a pointer to its pointer, which therefore is the first member. */
#define _GNU_SOURCE
#include <search.h>
#include <stdlib.h>

typedef int compare_function(const void *, const void *);

struct leaf {
    const void *key;
    struct leaf *below[2]; /* of what is less, and greater */
    int height;
};

static int height(const struct leaf *l)
{
    return l ? l->height : 0;
}

static void measure(struct leaf *l)
{
    int left = height(l->below[0]), right = height(l->below[1]);
    l->height = 1 + (left > right ? left : right);
}

/* The branch on that side comes to the top. */
static struct leaf *raise_branch(struct leaf *l, int side)
{
    struct leaf *top = l->below[side];
    l->below[side] = top->below[!side];
    top->below[!side] = l;
    measure(l);
    measure(top);
    return top;
}

static struct leaf *balance(struct leaf *l)
{
    int left = height(l->below[0]), right = height(l->below[1]), side = right > left;
    if (left - right < 2 && right - left < 2) {
        measure(l);
        return l;
    }
    struct leaf *tall = l->below[side];
    if (height(tall->below[!side]) > height(tall->below[side]))
        l->below[side] = raise_branch(tall, !side);
    return raise_branch(l, side);
}

/* Returns the branch with the key in it; *found: its leaf, NULL: there is no memory. */
static struct leaf *insert(struct leaf *l, const void *key, compare_function *compare, struct leaf **found)
{
    if (!l) {
        *found = l = calloc(1, sizeof *l);
        if (l)
            l->key = key, l->height = 1;
        return l;
    }
    int order = compare(key, l->key);
    if (order == 0) {
        *found = l;
        return l;
    }
    l->below[order > 0] = insert(l->below[order > 0], key, compare, found);
    return balance(l);
}

void *tsearch(const void *key, void **root, compare_function *compare)
{
    struct leaf *found = NULL;
    if (root)
        *root = insert(*root, key, compare, &found);
    return found;
}

void *tfind(const void *key, void *const *root, compare_function *compare)
{
    struct leaf *l = root ? *root : NULL;
    for (int order; l && (order = compare(key, l->key)) != 0;)
        l = l->below[order > 0];
    return l;
}

/* Takes the least leaf out of a branch. */
static struct leaf *take_least(struct leaf *l, struct leaf **least)
{
    if (!l->below[0]) {
        *least = l;
        return l->below[1];
    }
    l->below[0] = take_least(l->below[0], least);
    return balance(l);
}

static struct leaf *without(struct leaf *l)
{
    struct leaf *top;
    if (!l->below[0] || !l->below[1])
        return l->below[!l->below[0]];
    struct leaf *greater = take_least(l->below[1], &top);
    top->below[0] = l->below[0];
    top->below[1] = greater;
    return balance(top);
}

static struct leaf *delete_key(struct leaf *l, const void *key, compare_function *compare,
                               struct leaf **found)
{
    int order = l ? compare(key, l->key) : 0;
    if (!l || order == 0) {
        *found = l;
        return l ? without(l) : NULL;
    }
    l->below[order > 0] = delete_key(l->below[order > 0], key, compare, found);
    return balance(l);
}

/* Answers with the leaf that was above, of the root with something that is not NULL. */
void *tdelete(const void *restrict key, void **restrict root, compare_function *compare)
{
    struct leaf *found = NULL, *parent = NULL;
    if (!root || !*root)
        return NULL;
    for (struct leaf *l = *root; l;) {
        int order = compare(key, l->key);
        if (order == 0)
            break;
        parent = l;
        l = l->below[order > 0];
    }
    *root = delete_key(*root, key, compare, &found);
    if (!found)
        return NULL;
    free(found);
    return parent ? parent : (void *)root;
}

static void walk(const struct leaf *l, void (*visit)(const void *, VISIT, int), int level)
{
    if (!l->below[0] && !l->below[1]) {
        visit(l, leaf, level);
        return;
    }
    visit(l, preorder, level);
    if (l->below[0])
        walk(l->below[0], visit, level + 1);
    visit(l, postorder, level);
    if (l->below[1])
        walk(l->below[1], visit, level + 1);
    visit(l, endorder, level);
}

void twalk(const void *root, void (*visit)(const void *, VISIT, int))
{
    if (root && visit)
        walk(root, visit, 0);
}

void tdestroy(void *root, void (*release)(void *))
{
    struct leaf *l = root;
    if (!l)
        return;
    tdestroy(l->below[0], release);
    tdestroy(l->below[1], release);
    release((void *)(size_t)l->key);
    free(l);
}
