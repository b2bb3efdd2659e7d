/* colours.c - see colours.h. */
#include "lab/render/colours.h"
#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const struct {
    const char *name;
    uint32_t srgb;
} NAMED[] = {{"orange", 0xe69f00}, {"sky", 0x56b4e9},    {"green", 0x009e73}, {"yellow", 0xf0e442},
             {"blue", 0x0072b2},   {"red", 0xd55e00},    {"pink", 0xcc79a7},  {"grey", 0x999999},
             {"white", 0xffffff},  {"black", 0x000000},  {"bone", 0xe8dcc4},  {"skin", 0xe0ac8b},
             {"steel", 0x8fa3b5},  {"copper", 0xb87333}, {"gold", 0xd4af37}};

const char *colours_names(void)
{
    return "orange, sky, green, yellow, blue, red, pink, grey, white, black, bone, skin, steel, copper, gold";
}

float colours_linear(uint8_t srgb)
{
    float v = (float)srgb / 255;
    return v <= 0.04045f ? v / 12.92f : powf((v + 0.055f) / 1.055f, 2.4f);
}

uint8_t colours_srgb(float linear)
{
    if (!(linear > 0))
        return 0;
    if (linear >= 1)
        return 255;
    float v = linear <= 0.0031308f ? 12.92f * linear : 1.055f * powf(linear, 1 / 2.4f) - 0.055f;
    return (uint8_t)lroundf(255 * v);
}

static void to_linear(uint32_t srgb, float linear[3])
{
    for (int i = 0; i < 3; i++)
        linear[i] = colours_linear((uint8_t)(srgb >> (16 - 8 * i)));
}

bool colours_read(const char *text, float linear[3])
{
    for (size_t i = 0; i < sizeof NAMED / sizeof *NAMED; i++)
        if (!strcmp(text, NAMED[i].name)) {
            to_linear(NAMED[i].srgb, linear);
            return true;
        }
    text += *text == '#';
    if (strlen(text) != 6 || strspn(text, "0123456789abcdefABCDEF") != 6)
        return false;
    to_linear((uint32_t)strtoul(text, NULL, 16), linear);
    return true;
}

void colours_of_surface(unsigned surface, float linear[3])
{
    static const uint32_t ORDER[] = {0x56b4e9, 0xe69f00, 0x009e73, 0xcc79a7,
                                     0xd55e00, 0xf0e442, 0x0072b2, 0x999999};
    const unsigned count = sizeof ORDER / sizeof *ORDER;
    to_linear(ORDER[surface % count], linear);
    for (int i = 0; i < 3; i++)
        linear[i] *= powf(0.45f, (float)(surface / count));
}

/* Hues at steps of the golden angle never come close to each other soon; lightness takes turns. */
void colours_of_node(uint32_t node, float linear[3])
{
    static const float LIGHTNESS[] = {0.72f, 0.58f, 0.82f, 0.65f};
    const float lightness = LIGHTNESS[node % 4], chroma = 0.125f;
    const float hue = (float)fmod(0.6 + node * 2.399963229728653, 2 * M_PI);
    /* Oklab (B. Ottosson, 2020) to linear sRGB */
    float a = chroma * cosf(hue), b = chroma * sinf(hue);
    float l = powf(lightness + 0.3963377774f * a + 0.2158037573f * b, 3);
    float m = powf(lightness - 0.1055613458f * a - 0.0638541728f * b, 3);
    float s = powf(lightness - 0.0894841775f * a - 1.2914855480f * b, 3);
    linear[0] = 4.0767416621f * l - 3.3077115913f * m + 0.2309699292f * s;
    linear[1] = -1.2684380046f * l + 2.6097574011f * m - 0.3413193965f * s;
    linear[2] = -0.0041960863f * l - 0.7034186147f * m + 1.7076147010f * s;
    for (int i = 0; i < 3; i++)
        linear[i] = fminf(fmaxf(linear[i], 0.01f), 1);
}
