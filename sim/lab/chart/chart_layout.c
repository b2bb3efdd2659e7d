/* chart_layout.c - see chart_layout.h. */
#include "lab/chart/chart_layout.h"

enum {
    HEADING = 42,
    HEADING_LINE = 20, /* that a further line of it takes */
    NOTES = 20,        /* below the heading */
    TITLE = 24,        /* of a panel */
    LABEL = 22,        /* of an axis */
    GAP = 22,          /* between panels */
    SAMPLE = 74,       /* a legend's sample of a line, with the room around it */
    ENTRY = 20,        /* the height of a legend's entry */
    ONE_WIDTH = 560,   /* of the only panel */
    ONE_HEIGHT = 360,
    PANEL_WIDTH = 400, /* of one of several */
    PANEL_HEIGHT = 270,
    NARROW_WIDTH = 300, /* of one of three or more in a row */
    NARROW_HEIGHT = 240
};

static unsigned columns_of(size_t panels)
{
    unsigned columns = 1;
    while ((size_t)columns * columns < panels)
        columns++;
    return panels == 3 ? 3 : columns;
}

unsigned layout_panel_width(size_t panels)
{
    return panels == 1 ? ONE_WIDTH : columns_of(panels) == 2 ? PANEL_WIDTH : NARROW_WIDTH;
}

static unsigned panel_height(size_t panels)
{
    return panels == 1 ? ONE_HEIGHT : columns_of(panels) == 2 ? PANEL_HEIGHT : NARROW_HEIGHT;
}

/* Puts the legend at the panels' right: as many columns as its entries need, under a title. */
static void place_legend(struct layout *l, unsigned right, unsigned bottom)
{
    l->legend = (struct box){right, l->first.top, 0, bottom - l->first.top};
    l->width = right;
    if (!l->needs.entries)
        return;
    l->legend_rows = (l->legend.height - ENTRY) / ENTRY;
    size_t columns = (l->needs.entries + l->legend_rows - 1) / l->legend_rows;
    l->legend.width = (unsigned)columns * (SAMPLE + l->needs.entry_width);
    l->width += l->legend.width;
}

static unsigned heading_height(const struct layout_needs *needs)
{
    return HEADING + (needs->heading_lines - 1) * HEADING_LINE;
}

struct layout layout_of(const struct layout_needs *needs)
{
    struct layout l = {.needs = *needs, .columns = columns_of(needs->panels)};
    unsigned rows = ((unsigned)needs->panels + l.columns - 1) / l.columns;
    unsigned title = needs->panel_titles ? TITLE : 0;
    l.first =
        (struct box){LABEL + needs->y_labels, heading_height(needs) + (needs->notes ? NOTES : 0) + title,
                     layout_panel_width(needs->panels), panel_height(needs->panels)};
    l.right = l.first.width + needs->y_labels + GAP;
    l.down = l.first.height + needs->x_labels + title + GAP;
    unsigned bottom = l.first.top + (rows - 1) * l.down + l.first.height;
    place_legend(&l, l.first.left + (l.columns - 1) * l.right + l.first.width + GAP, bottom);
    if (l.width < needs->heading_width)
        l.width = needs->heading_width;
    l.height = bottom + needs->x_labels + LABEL + GAP / 2;
    return l;
}

unsigned layout_notes_top(const struct layout *l)
{
    return heading_height(&l->needs) - 4;
}

struct box layout_panel(const struct layout *l, size_t panel)
{
    struct box b = l->first;
    b.left += (unsigned)(panel % l->columns) * l->right;
    b.top += (unsigned)(panel / l->columns) * l->down;
    return b;
}

bool layout_is_left(const struct layout *l, size_t panel)
{
    return panel % l->columns == 0;
}

bool layout_is_lowest(const struct layout *l, size_t panel)
{
    return panel + l->columns >= l->needs.panels;
}
