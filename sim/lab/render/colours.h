/* colours.h - colours of surfaces and nodes, as names, as sRGB, and as linear light. */
#ifndef LAB_RENDER_COLOURS_H
#define LAB_RENDER_COLOURS_H
#include <stdbool.h>
#include <stdint.h>

/* Reads "#rrggbb", "rrggbb", or a name that colours_names() lists. False: it is none. */
bool colours_read(const char *text, float linear[3]);
/* The names, as "red, green ...". */
const char *colours_names(void);

/* The colour of surface number 0, 1 ...: Okabe and Ito's, which people who see colours differently tell apart
 * (Color Universal Design, 2008). From the 9th on they repeat, darker. */
void colours_of_surface(unsigned surface, float linear[3]);
/* A colour for each node; neighbouring numbers differ much in hue and lightness. */
void colours_of_node(uint32_t node, float linear[3]);

/* sRGB's transfer function (IEC 61966-2-1): a value of 0 to 255 as linear light, and back; rounded, and cut
 * to 0 to 255. */
float colours_linear(uint8_t srgb);
uint8_t colours_srgb(float linear);
#endif
