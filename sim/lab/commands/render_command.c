/* render_command.c - touchstone render: pictures of surfaces, and other formats of them. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "lab/commands/lab_commands.h"
#include "cli/options.h"
#include "cli/say.h"
#include "files/atomic_file.h"
#include "files/number.h"
#include "kernel/xalloc.h"
#include "lab/render/colours.h"
#include "lab/render/render_output.h"
#include "lab/render/render.h"

enum { SIZE = CLI_KEY, VIEW, ZOOM, BY, COLOUR, OPACITY, BACKGROUND, TURNTABLE, WELD };

struct arguments {
    struct output_request request;
    const char *colours, *opacities; /* lists, as given */
    char *chosen;                    /* the result's path, if the user gave none */
    const char *of_pictures;         /* an option that was given and is for pictures only */
};

static const struct argp_option OPTIONS[] = {
    {"output", 'o', "OUT", 0,
     "The file to write, whose ending says what: .png or .webp a picture, .obj, .stl, .vtk or .ply the "
     "surfaces themselves in one file, - a picture to standard output; default the first FILE's name with "
     ".png, or with .webp for a turntable",
     1},
    {"weld", WELD, NULL, 0, "Join vertices that are at exactly one place", 1},
    {NULL, 0, NULL, 0, "Pictures:", 2},
    {"size", SIZE, "WxH", 0, "Pixels across and down; default 1200x900, for a turntable 640x480", 0},
    {"view", VIEW, "AZIM,ELEV", 0,
     "Where the viewer is, in degrees: AZIM around the z axis, which points up, counted from the x axis "
     "towards the y axis; ELEV above the ground; default 60,20",
     0},
    {"zoom", ZOOM, "Z", 0, "Enlarge Z times around the middle, 0.01 to 100; 1: all is in the picture", 0},
    {"by", BY, "node", 0,
     "Colour each polygon by the node that made it: the files' faces have a property node, as the model "
     "writes it with -bynode; standard output says which colour is whose",
     0},
    {"colour", COLOUR, "C,C...", 0,
     "A colour for each FILE, or one for all: RRGGBB in hexadecimal, or a name (below); default colours that "
     "colour-blind people tell apart",
     0},
    {"opacity", OPACITY, "A,A...", 0,
     "How opaque each FILE is, or all are, 0 to 1; default 1, and less for a surface that is around another",
     0},
    {"background", BACKGROUND, "C", 0, "A colour, or none: transparent; default a light grey", 0},
    {"turntable", TURNTABLE, "N", 0,
     "Turn once around in N pictures, 2 to 720, as animated WebP, which browsers play", 0},
    {0}};

static const char DOC[] =
    "Draws the surfaces that programs write as PLY files, such as the model with -ply, as a picture or as a "
    "turntable; or writes them in the formats of other programs. Each FILE is one surface, - standard "
    "input.\v"
    "Names of colours: orange, sky, green, yellow, blue, red, pink, grey, white, black, bone, skin, steel, "
    "copper, gold.\n\n"
    "Transparent surfaces may lie within each other in any way. PLY, VTK and OBJ files keep polygons and "
    "normals; PLY and VTK files also nodes and colours. STL files have triangles only.\n\n"
    "Exit status:\n"
    "  0   the file is written\n"
    "  1   it cannot be written\n"
    "  64  wrong arguments\n"
    "  65  a FILE cannot be used\n\n"
    "Example:\n"
    "  touchstone render head_0.ply head_1.ply --opacity 0.3,1 -o head.png\n"
    "  touchstone render engine_0.ply --view 30,40 --colour steel\n"
    "  touchstone render head_1.ply --by node --turntable 72 -o head.webp\n"
    "  touchstone render head_1.ply -o head.vtk";

static double number(struct argp_state *state, const char *option, const char *text, double least,
                     double most)
{
    double value;
    if (!number_read(text, &value, NULL) || value < least || value > most)
        argp_error(state, "%s takes numbers from %g to %g, not '%s'", option, least, most, text);
    return value;
}

static void set_size(struct argp_state *state, struct output_request *r, const char *text)
{
    const char *x = strchr(text, 'x');
    char *width = xstrndup(text, x ? (size_t)(x - text) : 0);
    if (!x || !cli_is_whole(width, RENDER_MOST_SIZE, &r->width) ||
        !cli_is_whole(x + 1, RENDER_MOST_SIZE, &r->height))
        argp_error(state, "--size takes WIDTHxHEIGHT in pixels, each 1 to %d, not '%s'", RENDER_MOST_SIZE,
                   text);
    free(width);
}

static void set_view(struct argp_state *state, struct output_request *r, const char *text)
{
    const char *comma = strchr(text, ',');
    if (!comma)
        argp_error(state, "--view takes AZIM,ELEV in degrees, as 60,20, not '%s'", text);
    char *azimuth = xstrndup(text, comma ? (size_t)(comma - text) : 0);
    r->azimuth = number(state, "--view AZIM", azimuth, -360, 360);
    r->elevation = number(state, "--view ELEV", comma + 1, -90, 90);
    free(azimuth);
}

static void set_background(struct argp_state *state, struct output_request *r, const char *text)
{
    r->is_transparent = !strcmp(text, "none");
    r->has_background = !r->is_transparent;
    if (r->has_background && !colours_read(text, r->background))
        argp_error(state, "--background takes a colour (RRGGBB, %s) or none, not '%s'", colours_names(),
                   text);
}

/* Calls set for each part of a list: one a file, or one for all. */
static void each_file(struct argp_state *state, const char *option, const char *list,
                      void (*set)(struct argp_state *state, struct output_request *r, size_t i,
                                  const char *text))
{
    struct arguments *a = state->input;
    char *copy = xstrdup(list), *rest = copy, *part;
    size_t count = 1, i = 0;
    for (const char *c = list; *c; c++)
        count += *c == ',';
    if (count != 1 && count != a->request.count)
        argp_error(state, "%s has %zu values for %zu FILE%s: give one for each, or one for all", option,
                   count, a->request.count, a->request.count == 1 ? "" : "s");
    while ((part = strsep(&rest, ",")))
        do
            set(state, &a->request, i++, part);
        while (count == 1 && i < a->request.count);
    free(copy);
}

static void set_colour(struct argp_state *state, struct output_request *r, size_t i, const char *text)
{
    if (!colours_read(text, r->colour[i]))
        argp_error(state, "--colour takes RRGGBB or one of %s, not '%s'", colours_names(), text);
    r->has_colour[i] = true;
}

static void set_opacity(struct argp_state *state, struct output_request *r, size_t i, const char *text)
{
    r->opacity[i] = (float)number(state, "--opacity", text, 0, 1);
    r->has_opacity[i] = true;
}

/* The name of the result if the user gives none; malloc'd. */
static char *default_path(const struct output_request *r)
{
    const char *first = r->file[0], *ending = r->frames ? "webp" : "png";
    size_t length = strlen(first);
    if (!strcmp(first, "-"))
        return xstrdup("-");
    if (length > 4 && !strcasecmp(first + length - 4, ".ply"))
        length -= 4;
    return xasprintf("%.*s.%s", (int)length, first, ending);
}

static void finish(struct argp_state *state, struct arguments *a)
{
    struct output_request *r = &a->request;
    enum output_kind kind;
    if (!r->count)
        argp_error(state, "which surfaces? (PLY files)");
    if (!r->path)
        r->path = a->chosen = default_path(r);
    if (!output_kind_of(r->path, r->frames, &kind))
        argp_error(state,
                   r->frames ? "a turntable is a .webp file, not '%s'"
                             : "-o takes a file ending in .png, .webp, .ply, .obj, .stl or .vtk, not '%s'",
                   r->path);
    if (kind == OUTPUT_MESH && a->of_pictures)
        argp_error(state, "%s is for pictures, and %s is none", a->of_pictures, r->path);
    if (a->colours && r->by_node)
        argp_error(state, "--by node gives the colours, and leaves none for --colour");
    if (a->colours)
        each_file(state, "--colour", a->colours, set_colour);
    if (a->opacities)
        each_file(state, "--opacity", a->opacities, set_opacity);
    if (!r->width)
        r->width = r->frames ? 640 : 1200, r->height = r->frames ? 480 : 900;
}

/* Options that are for pictures only; false: key is none of them. */
static bool set_picture(struct argp_state *state, struct arguments *a, int key, const char *arg)
{
    struct output_request *r = &a->request;
    switch (key) {
    case SIZE:
        set_size(state, r, arg);
        break;
    case VIEW:
        set_view(state, r, arg);
        break;
    case ZOOM:
        r->zoom = number(state, "--zoom", arg, 0.01, RENDER_MOST_ZOOM);
        break;
    case COLOUR:
        a->colours = arg;
        break;
    case OPACITY:
        a->opacities = arg;
        break;
    case BACKGROUND:
        set_background(state, r, arg);
        break;
    case TURNTABLE:
        if (!cli_is_whole(arg, OUTPUT_MOST_FRAMES, &r->frames) || r->frames < 2)
            argp_error(state, "--turntable takes a number of pictures from 2 to %d, not '%s'",
                       OUTPUT_MOST_FRAMES, arg);
        break;
    case BY:
        r->by_node = !strcmp(arg, "node");
        if (!r->by_node)
            argp_error(state, "--by takes node, not '%s'", arg);
        break;
    default:
        return false;
    }
    for (const struct argp_option *o = OPTIONS; o->name || o->doc; o++)
        if (o->key == key && o->name)
            a->of_pictures = o->name;
    return true;
}

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct arguments *a = state->input;
    if (set_picture(state, a, key, arg))
        return 0;
    switch (key) {
    case 'o':
        a->request.path = arg;
        return 0;
    case WELD:
        a->request.weld = true;
        return 0;
    case ARGP_KEY_ARGS:
        a->request.file = state->argv + state->next;
        a->request.count = (size_t)(state->argc - state->next);
        if (a->request.count > OUTPUT_MOST_FILES)
            argp_error(state, "at most %d FILEs", OUTPUT_MOST_FILES);
        return 0;
    case ARGP_KEY_END:
        finish(state, a);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static void show_progress(unsigned frame, unsigned frames)
{
    fprintf(stderr, frame < frames ? "\rpicture %u of %u" : "\r\033[K", frame, frames);
}

/* Which colour is whose, as a page's legend has it: of the first nodes. */
static void say_nodes(const struct output_file *f)
{
    const size_t most = 64;
    for (size_t i = 0; i < f->node_count && i < most; i++) {
        float linear[3];
        colours_of_node(f->node[i] % SCENE_NODE_COLOURS, linear);
        printf("%s%u %02x%02x%02x", i ? ", " : "  nodes: ", f->node[i], colours_srgb(linear[0]),
               colours_srgb(linear[1]), colours_srgb(linear[2]));
    }
    if (f->node_count > most)
        printf(", and %zu more", f->node_count - most);
    if (f->node_count)
        printf("\n");
}

/* Says what is in each file, how it is shown, and last the name of the result. */
static void say(const struct output_request *r, const struct output_file *file)
{
    enum output_kind kind;
    output_kind_of(r->path, r->frames, &kind);
    for (size_t i = 0; i < r->count; i++) {
        const struct output_file *f = &file[i];
        if (!f->polygons)
            cli_say_warning("render", "there are no polygons in %s", r->file[i]);
        if (!strcmp(r->path, "-"))
            continue;
        printf("%s: %ju polygons, %ju vertices", r->file[i], (uintmax_t)f->polygons, (uintmax_t)f->vertices);
        if (kind != OUTPUT_MESH && f->has_colour)
            printf("; colour %02x%02x%02x", f->colour[0], f->colour[1], f->colour[2]);
        if (kind != OUTPUT_MESH)
            printf("%s opacity %.2g", f->has_colour ? "," : ";", f->opacity);
        printf("\n");
        say_nodes(f);
    }
    if (strcmp(r->path, "-"))
        puts(r->path);
}

/* Returns the exit status. */
static int make(const struct output_request *r)
{
    struct output_file file[OUTPUT_MOST_FILES] = {0};
    char *error = NULL;
    cli_say_doing("reading", r->file[0]);
    enum output_status status = output_make(r, file, &error);
    cli_say_done();
    if (status == OUTPUT_DONE)
        say(r, file);
    for (size_t i = 0; i < r->count; i++)
        free(file[i].node);
    if (status == OUTPUT_DONE)
        return 0;
    return cli_failed("render", error, status == OUTPUT_BAD_INPUT ? CLI_EXIT_INPUT : 1);
}

int cli_render(int argc, char **argv)
{
    static const struct argp ARGP = {OPTIONS, parse, "FILE.ply...", DOC, NULL, NULL, NULL};
    struct arguments a = {.request = {.azimuth = 60, .elevation = 20, .zoom = 1}};
    cli_parse(&ARGP, "touchstone render", 0, argc, argv, &a);
    a.request.progress = isatty(STDERR_FILENO) ? show_progress : NULL;
    atomic_file_drop_at_signals();
    int status = make(&a.request);
    free(a.chosen);
    return status;
}
