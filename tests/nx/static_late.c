/* Functions that are called, or declared without static, before they turn out to be static; and static
 * declarations in blocks.
 * compile: -w
 * run: -m ipsc860 -n 1
 * run: -m delta -n 2
 */
#include <stdio.h>
#include <nx.h>

/* static int in_a_comment() { */
extern void reset();
int plain();
char *text();
#if 0
static int elsewhere() { return 1; }
#else
int elsewhere();
#endif

main()
{
    static int work(), *other();
    static char *text2();
    static int twice = 2, (*pointer)();
    pointer = work;
    work();
    reset();
    implicit(3);
    if (mynode() == 0)
        printf("%s %s %d", text(), text2(2), (*pointer)());
/* clang-format off */
#if 0
    if (numnodes() > 5) {
#else
    if (mynode() == 0) { /* the text has one brace more that opens */
#endif
        printf(" %d %d %d\n", *other(), plain() * twice, elsewhere());
    }
/* clang-format on */
return 0;
}

static int calls;

static int work()
{
    return ++calls;
}

static void reset()
{
    calls = 10;
}

static implicit(n) int n;
{
    calls += n;
}

static int plain()
{
    extern int deep();
    return deep();
}

static char *text()
{
    return "static int brackets() {";
}

static char *text2(n)
int n;
{
    return "text2";
}

static int *other()
{
    return &calls;
}

static int deep()
{
    return 4;
}

int elsewhere()
{
    return 5;
}
