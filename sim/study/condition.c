/* condition.c - reads and judges conditions; see condition.h. */
#include "study/condition.h"
#include "study/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool read_comparison(struct condition *c, const char *sign)
{
    static const struct {
        const char *sign;
        bool less, equal, greater;
    } SIGNS[] = {{"<", true, false, false}, {"<=", true, true, false}, {"=", false, true, false},
                 {"!=", true, false, true}, {">=", false, true, true}, {">", false, false, true}};
    for (size_t i = 0; i < sizeof SIGNS / sizeof *SIGNS; i++)
        if (strcmp(sign, SIGNS[i].sign) == 0) {
            c->less = SIGNS[i].less;
            c->equal = SIGNS[i].equal;
            c->greater = SIGNS[i].greater;
            c->ordered = c->less != c->greater;
            return true;
        }
    return false;
}

static void read_side(struct condition_side *side, const char *word, const struct spec *s)
{
    char *end;
    side->axis = spec_axis(s, word);
    side->text = strdup(word);
    side->number = strtod(word, &end);
    if (*end)
        side->number = NAN;
}

static bool is_number(const struct condition_side *side)
{
    return side->axis ? side->axis->numeric : !isnan(side->number);
}

bool condition_read(struct condition *c, const char *text, const struct spec *s, char **why)
{
    char left[64], sign[3], right[64], more;
    *c = (struct condition){0};
    if (sscanf(text, "%63s %2s %63s %c", left, sign, right, &more) != 3 || !read_comparison(c, sign)) {
        *why = text_of("\"%s\" is no condition: AXIS < VALUE is one, also <= = != >= >, with blanks between",
                       text);
        return false;
    }
    read_side(&c->left, left, s);
    read_side(&c->right, right, s);
    if (!c->left.axis && !c->right.axis) {
        *why = text_of("neither %s nor %s is an axis", left, right);
        return false;
    }
    if (c->ordered && !(is_number(&c->left) && is_number(&c->right))) {
        *why = text_of("%s is no number or axis of numbers: only = and != are allowed",
                       is_number(&c->left) ? right : left);
        return false;
    }
    return true;
}

bool condition_holds(const struct condition *c, const struct spec *s, const size_t at[])
{
    const struct condition_side *sides[] = {&c->left, &c->right};
    const char *text[2];
    double number[2];
    for (int i = 0; i < 2; i++) {
        const struct spec_axis *axis = sides[i]->axis;
        const struct spec_value *value = axis ? &axis->values[at[spec_place(s, axis)]] : NULL;
        text[i] = value ? value->label : sides[i]->text;
        number[i] = value ? value->number : sides[i]->number;
    }
    if (isnan(number[0]) || isnan(number[1]))
        return (strcmp(text[0], text[1]) == 0) == c->equal;
    return number[0] < number[1] ? c->less : number[0] > number[1] ? c->greater : c->equal;
}

void condition_clear(struct condition *c)
{
    free(c->left.text);
    free(c->right.text);
    *c = (struct condition){0};
}
