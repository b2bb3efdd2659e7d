/* random.c - writes a random C program that ends, has no undefined behaviour and prints a checksum of all
 * that it computed.
 *
 *     random SEED > program.c
 *
 * Functions call only those before them, loops have bounded trip counts, integers are unsigned,
 * indices are masked.
 */
#include <stdio.h>
#include <stdlib.h>

enum { FUNCTIONS = 6, VARIABLES = 5 };

static unsigned state;
static int function; /* the one being written */
static int labels;

static int pick(int n)
{
    state = state * 1664525u + 1013904223u;
    return (int)(state >> 16) % n;
}

static void indent(int depth)
{
    printf("%*s", 4 * depth, "");
}

static void expression(int depth)
{
    static const char *const operators[] = {"+", "-", "*", "^", "&", "|", "<", "=="};
    if (depth == 0) {
        if (pick(3) == 0)
            printf("%du", pick(1000));
        else
            printf("v%d", pick(VARIABLES));
        return;
    }
    switch (pick(10)) {
    case 9:
        printf("(%s(v%d) + ", pick(2) ? "leaf" : "uneven", pick(VARIABLES));
        break;
    case 0:
        printf("(g[v%d & 15] + ", pick(VARIABLES));
        break;
    case 1:
        printf("((v%d / (", pick(VARIABLES));
        expression(depth - 1);
        printf(" | 1u)) + ");
        break;
    case 2:
        printf("((unsigned)(d%d * 0.5) + ", pick(2));
        break;
    case 3:
        printf("((v%d >> (v%d & 7)) + ", pick(VARIABLES), pick(VARIABLES));
        break;
    default:
        printf("(");
        expression(depth - 1);
        printf(" %s ", operators[pick(8)]);
    }
    expression(depth - 1);
    printf(")");
}

static void statements(int count, int depth);

static void block(int depth)
{
    printf(" {\n");
    statements(1 + pick(3), depth + 1);
    indent(depth);
    printf("}");
}

static void call(int depth)
{
    indent(depth);
    switch (function ? pick(5) : 3 + pick(2)) {
    case 0:
        printf("v%d += (table[v%d %% %d])(v%d & 7, v%d);\n", pick(VARIABLES), pick(VARIABLES), function,
               pick(VARIABLES), pick(VARIABLES));
        break;
    case 1:
        printf("{ jmp_buf place; if (setjmp(place) == 0) { g[1] ^= f%d(3, v%d); back(place, v%d & 1); } }\n",
               pick(function), pick(VARIABLES), pick(VARIABLES));
        break;
    case 2:
        printf("v%d += f%d(v%d & 7, v%d);\n", pick(VARIABLES), pick(function), pick(VARIABLES),
               pick(VARIABLES));
        break;
    case 3:
        printf("v%d += turns(v%d & 15);\n", pick(VARIABLES), pick(VARIABLES));
        break;
    default:
        printf("memcpy(g + 8, g, (v%d & 7) * sizeof *g); d%d = sqrt(fabs(d%d)) + v%d;\n", pick(VARIABLES),
               pick(2), pick(2), pick(VARIABLES));
    }
}

static void many_ways(int depth)
{
    int v = pick(VARIABLES);
    indent(depth);
    printf("switch (v%d & 7) {\n", v);
    for (int i = 0; i < 6; i++) {
        indent(depth);
        printf("case %d:", i);
        block(depth);
        printf(pick(3) ? " break;\n" : " /* on */\n");
    }
    indent(depth);
    printf("}\n");
}

static void loop(int depth)
{
    int n = labels++;
    indent(depth);
    if (pick(3) == 0) {
        printf("{ unsigned r%d = %d; again%d:", n, pick(20), n);
        block(depth);
        printf(" if (r%d-- > 0) goto again%d; }\n", n, n);
    } else {
        printf("for (unsigned i%d = 0; i%d < %du + (v%d & 7); i%d++)", n, n, (unsigned)pick(12),
               pick(VARIABLES), n);
        block(depth);
        printf("\n");
    }
}

static void statement(int depth)
{
    int kind = pick(10);
    if (kind == 0 && depth < 4) {
        loop(depth);
    } else if (kind == 1 && depth < 3) {
        many_ways(depth);
    } else if (kind == 2 && depth < 3) {
        call(depth);
    } else if (kind < 5 && depth < 5) {
        indent(depth);
        printf("if (");
        expression(1);
        printf(" & 1)");
        block(depth);
        printf("\n");
    } else if (kind == 5) {
        indent(depth);
        printf("d%d = d%d * 0.25 + v%d;\n", pick(2), pick(2), pick(VARIABLES));
    } else if (kind == 6 && pick(2)) {
        indent(depth);
        printf("if (served) served();\n");
    } else if (kind == 6) {
        indent(depth);
        printf("g[v%d & 15] = ", pick(VARIABLES));
        expression(2);
        printf(";\n");
    } else {
        indent(depth);
        printf("v%d = ", pick(VARIABLES));
        expression(2);
        printf(";\n");
    }
}

static void statements(int count, int depth)
{
    for (int i = 0; i < count; i++)
        statement(depth);
}

static void one_function(void)
{
    printf("%sunsigned f%d(unsigned v0, unsigned v1)\n{\n", pick(2) ? "static " : "", function);
    printf("    volatile unsigned v2 = v0; unsigned v3 = v1 ^ 3, v4 = 4; double d0 = v0, d1 = 0.5;\n");
    printf("    if (budget-- == 0) { budget = 0; return 0; }\n");
    statements(4 + pick(6), 1);
    if (pick(3) == 0)
        printf("    if (v0 > 0) return f%d((v0 & 7) - (v0 & 7 ? 1 : 0), v3 + v4);\n", function);
    printf("    return v0 ^ v1 ^ v2 ^ v3 ^ v4 ^ (unsigned)fmod(d0 + d1, 1e6);\n}\n\n");
}

int main(int argc, char **argv)
{
    state = argc > 1 ? (unsigned)atoi(argv[1]) * 2654435761u : 1;
    printf(
        "#include <math.h>\n#include <setjmp.h>\n#include <stdio.h>\n#include <string.h>\n\n"
        "static unsigned g[32];\nstatic unsigned budget = 300;\n"
        "__attribute__((noinline)) static unsigned leaf(unsigned x) { return g[x & 15] / 3 + x; }\n"
        "static unsigned odd;\n"
        "static unsigned uneven(unsigned x) { if (x & 1) { odd += 3; x /= 7; } return x; }\n"
        "#define TURNS(name) static unsigned name(unsigned n) { unsigned s = 0; "
        "for (unsigned i = 0; i < n; i++)"
        " for (unsigned k = 0; k < 8 && s < 9000000; k++) { s += k != 7 ? g[(i + k) & 15] %% (k + 2) * n : 1;"
        " if (k == 7 && s & 64) s /= 3; } return s; }\n"
        "__attribute__((noinline)) TURNS(turns)\nTURNS(turns_once)\n"
        "void served(void) __attribute__((weak));\n"
        "static void back(jmp_buf place, unsigned really) { if (really) longjmp(place, 1); }\n"
        "static unsigned (*const table[%d])(unsigned, unsigned);\n\n",
        FUNCTIONS);
    for (function = 0; function < FUNCTIONS; function++)
        one_function();
    printf("static unsigned (*const table[%d])(unsigned, unsigned) = {f0, f1, f2, f3, f4, f5};\n\n",
           FUNCTIONS);
    printf("int main(void)\n{\n    unsigned sum = 0;\n    for (unsigned i = 0; i < 20; i++) {\n        "
           "budget = 300;\n"
           "        sum = sum * 31 + f5(i & 7, i * 77) + turns_once(i);\n    }\n"
           "    for (int i = 0; i < 32; i++)\n        sum = sum * 31 + g[i] + odd;\n"
           "    printf(\"%%u\\n\", sum);\n    return 0;\n}\n");
    return 0;
}
