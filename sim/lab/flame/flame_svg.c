/* flame_svg.c - a flame graph as one SVG file, which needs no other: see flame.h.
 *
 * A frame is a rectangle as wide as its time, above the one that has called it. The picture is complete
 * without its script: a viewer of pictures shows it, and a title tells each frame's times. In a browser the
 * script zooms into a frame (click, or Enter at the one with the focus), marks the frames that a search
 * finds, and tells what the pointer is at. */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "files/text_file.h"
#include "files/virtual_time.h"
#include "lab/flame/flame.h"

enum { WIDTH = 1200, MARGIN = 10, ROW = 18, TOP = 66, BOTTOM = 40, LETTER = 7 };

static const double LEAST_WIDTH = 0.3; /* of a frame that is drawn, in pixels */

struct svg {
    const struct flame *flame;
    FILE *out;
    int rows;
    double largest; /* change of all frames */
    size_t left_out;
};

/* In pixels. A frame that is gone, in a difference, has no width. */
static double width_of(const struct svg *s, const struct flame_frame *f)
{
    double all = (double)s->flame->root->total[FLAME_NOW];
    return all > 0 ? (double)f->total[FLAME_NOW] / all * (WIDTH - 2 * MARGIN) : 0;
}

static int rows_of(const struct svg *s, const struct flame_frame *f)
{
    int most = 0;
    if (width_of(s, f) < LEAST_WIDTH)
        return 0;
    for (const struct flame_frame *c = f->children; c; c = c->next) {
        int rows = rows_of(s, c);
        most = rows > most ? rows : most;
    }
    return most + 1;
}

/* What a frame itself takes more than before, in seconds. */
static double change_of(const struct flame_frame *f)
{
    return vt_sum_seconds(f->self[FLAME_NOW] - f->self[FLAME_BEFORE]);
}

/* The time of frames that are there no more: nothing is as wide as they were. */
static vtime_sum gone(const struct flame_frame *f)
{
    vtime_sum sum = f->total[FLAME_NOW] ? 0 : f->total[FLAME_BEFORE];
    for (const struct flame_frame *c = f->total[FLAME_NOW] ? f->children : NULL; c; c = c->next)
        sum += gone(c);
    return sum;
}

static void find_largest(struct svg *s, const struct flame_frame *f)
{
    s->largest = fmax(s->largest, fabs(change_of(f)));
    for (const struct flame_frame *c = f->children; c; c = c->next)
        find_largest(s, c);
}

/* --- colours --- */

/* A number from 0 to 1 by the name, so that a function has one colour in all pictures. */
static double shade(const char *name)
{
    uint32_t hash = 2166136261u; /* FNV-1a */
    for (; *name; name++)
        hash = (hash ^ (unsigned char)*name) * 16777619u;
    return (double)(hash >> 8 & 0xff) / 255;
}

static void write_colour(const struct svg *s, const struct flame_frame *f)
{
    /* As in pictures of traces (lab/draw/palette.c) computing is blue, calls are yellow, other system time
     * is red, waiting grey; all lighter, since text stands on them. */
    static const struct {
        int hue, saturation, light, span;
    } KINDS[FLAME_KINDS] = {[FLAME_ROOT] = {0, 0, 85, 0},       [FLAME_FUNCTION] = {206, 60, 72, 16},
                            [FLAME_INLINED] = {196, 60, 85, 8}, [FLAME_LIBRARY] = {160, 35, 72, 16},
                            [FLAME_CALL] = {42, 76, 62, 5},     [FLAME_WAITING] = {0, 0, 91, 0},
                            [FLAME_OTHER] = {344, 48, 76, 12}};
    double change = s->largest > 0 ? change_of(f) / s->largest : 0;
    if (!flame_is_diff(s->flame))
        fprintf(s->out, "hsl(%.0f,%d%%,%d%%)", KINDS[f->kind].hue + shade(f->name) * KINDS[f->kind].span,
                KINDS[f->kind].saturation, KINDS[f->kind].light);
    else if (fabs(change) < 1e-6)
        fputs("hsl(0,0%,92%)", s->out);
    else
        fprintf(s->out, "hsl(%d,85%%,%.0f%%)", change > 0 ? 8 : 215, 92 - 34 * sqrt(fabs(change)));
}

/* --- text --- */

static void write_escaped(const char *text, size_t most, FILE *out)
{
    for (size_t i = 0, length = text_cut(text, most); i < length; i++) {
        switch (text[i]) {
        case '<':
            fputs("&lt;", out);
            break;
        case '>':
            fputs("&gt;", out);
            break;
        case '&':
            fputs("&amp;", out);
            break;
        case '"':
            fputs("&quot;", out);
            break;
        default:
            fputc((unsigned char)text[i] < ' ' ? ' ' : text[i], out);
        }
    }
}

static void write_time(vtime_sum t, FILE *out)
{
    double s = vt_sum_seconds(t);
    if (s >= 1 || s == 0)
        fprintf(out, "%.3f s", s);
    else if (s >= 1e-3)
        fprintf(out, "%.3f ms", 1e3 * s);
    else
        fprintf(out, "%.3f us", 1e6 * s);
}

static void write_title(const struct svg *s, const struct flame_frame *f)
{
    const struct flame *flame = s->flame;
    fputs("<title>", s->out);
    write_escaped(f->name, SIZE_MAX, s->out);
    fprintf(s->out, ": %.2f %%, ", 100 * flame_share(flame, f->total, FLAME_NOW));
    write_time(f->total[FLAME_NOW], s->out);
    if (f->self[FLAME_NOW] != f->total[FLAME_NOW]) {
        fputs(", itself ", s->out);
        write_time(f->self[FLAME_NOW], s->out);
    }
    if (flame_is_diff(flame)) {
        fprintf(s->out, "; before %.2f %%, ", 100 * flame_share(flame, f->total, FLAME_BEFORE));
        write_time(f->total[FLAME_BEFORE], s->out);
        fputs(", itself ", s->out);
        write_time(f->self[FLAME_BEFORE], s->out);
    }
    if (f->kind == FLAME_INLINED)
        fputs(" (inlined)", s->out);
    if (*f->file) {
        fputs(" - ", s->out);
        write_escaped(f->file, SIZE_MAX, s->out);
        fprintf(s->out, ":%d", f->line);
    }
    fputs("</title>", s->out);
}

/* --- frames --- */

static void write_label(const struct svg *s, const struct flame_frame *f, double x, double y, double width)
{
    int fits = (int)((width - 6) / LETTER);
    size_t length = strlen(f->name);
    fprintf(s->out, "<text x='%.2f' y='%.0f'>", x + 3, y + ROW - 5);
    if ((int)length <= fits)
        write_escaped(f->name, SIZE_MAX, s->out);
    else if (fits >= 3) {
        write_escaped(f->name, (size_t)fits - 1, s->out);
        fputs("\u2026", s->out);
    }
    fputs("</text>", s->out);
}

static void write_frame(struct svg *s, const struct flame_frame *f, int depth, double x)
{
    double width = width_of(s, f), y = TOP + (double)(s->rows - 1 - depth) * ROW;
    if (width < LEAST_WIDTH) {
        s->left_out++;
        return;
    }
    fprintf(s->out, "<g class='f' tabindex='0' data-n='");
    for (const char *c = f->name; *c; c++) /* within single quotes */
        if (*c == '\'')
            fputs("&#39;", s->out);
        else
            write_escaped((const char[]){*c, 0}, 1, s->out);
    fputs("'>", s->out);
    write_title(s, f);
    fprintf(s->out, "<rect x='%.2f' y='%.0f' width='%.2f' height='%d' fill='", x, y, width, ROW - 1);
    write_colour(s, f);
    fputs("'/>", s->out);
    write_label(s, f, x, y, width);
    fputs("</g>\n", s->out);
    for (const struct flame_frame *c = f->children; c; c = c->next) {
        write_frame(s, c, depth + 1, x);
        x += width_of(s, c);
    }
}

/* --- the page around them --- */

static const char STYLE[] =
    "<style>\n"
    "svg{background:#fff}text{font:12px 'DejaVu Sans Mono',Menlo,Consolas,monospace;fill:#111}\n"
    ".title{font-size:17px;font-weight:bold}.note{fill:#444}.button{cursor:pointer;fill:#0645ad}\n"
    ".f{cursor:pointer}.f text{pointer-events:none}.f rect{stroke:#fff;stroke-width:.5}\n"
    ".f:hover rect,.f:focus rect{stroke:#000;stroke-width:1.2}.f:focus{outline:none}\n"
    ".dim rect{opacity:.45}.hit rect{fill:#d040d0!important}.hit text{fill:#fff}\n"
    "</style>\n";

/* Positions are kept as shares of the whole, from which a zoom makes new ones. */
static const char SCRIPT[] =
    "<script><![CDATA[\n"
    "(function(){'use strict';\n"
    "var svg=document.documentElement,W=1200,M=10,L=7,fs=[],\n"
    "info=document.getElementById('info'),found=document.getElementById('found'),\n"
    "reset=document.getElementById('reset'),search=document.getElementById('search'),idle=info.textContent;\n"
    "Array.prototype.forEach.call(document.getElementsByClassName('f'),function(g){\n"
    " var r=g.getElementsByTagName('rect')[0],t=g.getElementsByTagName('text')[0],\n"
    " f={g:g,r:r,t:t,x:(+r.getAttribute('x')-M)/(W-2*M),w:+r.getAttribute('width')/(W-2*M),\n"
    "  y:+r.getAttribute('y'),n:g.getAttribute('data-n'),\n"
    "  title:g.getElementsByTagName('title')[0].textContent};\n"
    " fs.push(f);\n"
    " g.addEventListener('mouseover',function(){info.textContent=f.title});\n"
    " g.addEventListener('focus',function(){info.textContent=f.title});\n"
    " g.addEventListener('mouseout',function(){info.textContent=idle});\n"
    " g.addEventListener('click',function(){zoom(f)});\n"
    " g.addEventListener('keydown',function(e){if(e.key==='Enter')zoom(f)});\n"
    "});\n"
    "function zoom(z){var e=1e-6;fs.forEach(function(f){\n"
    " var below=f.y>z.y,in_=f.x>=z.x-e&&f.x+f.w<=z.x+z.w+e,over=f.x<=z.x+e&&f.x+f.w>=z.x+z.w-e,\n"
    " show=below?over:in_;\n"
    " f.g.style.display=show?'':'none';if(!show)return;\n"
    " var x=below?0:(f.x-z.x)/z.w,w=below?1:f.w/z.w;place(f,M+x*(W-2*M),w*(W-2*M));\n"
    " f.g.classList.toggle('dim',below)});\n"
    " reset.style.display=z===fs[0]?'none':''}\n"
    "function place(f,x,w){f.r.setAttribute('x',x);f.r.setAttribute('width',w);f.t.setAttribute('x',x+3);\n"
    " var n=Math.floor((w-6)/L);f.t.textContent=f.n.length<=n?f.n:n>=3?f.n.slice(0,n-1)+'\\u2026':''}\n"
    "function find(){var s=prompt('Find frames by name (a regular expression; empty: none)','');\n"
    " if(s!==null)mark(s)}\n"
    "function mark(s){var re,spans=[],sum=0,end=-1;try{re=s?new RegExp(s,'i'):null}catch(e){\n"
    "  found.textContent='not a regular expression';return}\n"
    " fs.forEach(function(f){var hit=!!re&&re.test(f.n);f.g.classList.toggle('hit',hit);\n"
    "  if(hit)spans.push([f.x,f.x+f.w])});\n"
    " spans.sort(function(a,b){return a[0]-b[0]}).forEach(function(p){\n"
    "  sum+=Math.max(0,p[1]-Math.max(p[0],end));end=Math.max(end,p[1])});\n"
    " found.textContent=re?'found: '+(100*sum).toFixed(2)+' %':''}\n"
    "[[reset,function(){zoom(fs[0])}],[search,find]].forEach(function(b){\n"
    " b[0].addEventListener('click',b[1]);\n"
    " b[0].addEventListener('keydown',function(e){if(e.key==='Enter')b[1]()})});\n"
    "window.addEventListener('keydown',function(e){\n"
    " if(e.key==='Escape')zoom(fs[0]);\n"
    " else if(e.key==='/'||((e.ctrlKey||e.metaKey)&&e.key==='f')){e.preventDefault();find()}});\n"
    "search.style.display='';window.flame={zoom:function(i){zoom(fs[i])},mark:mark,frames:fs};\n"
    "})();\n"
    "]]></script>\n";

static void write_head(const struct svg *s)
{
    const struct flame *f = s->flame;
    FILE *out = s->out;
    int height = TOP + s->rows * ROW + BOTTOM;
    fprintf(
        out,
        "<?xml version='1.0' encoding='UTF-8'?>\n<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 %d %d' "
        "width='%d' height='%d' role='img' aria-labelledby='title'>\n",
        WIDTH, height, WIDTH, height);
    fputs(STYLE, out);
    fprintf(out, "<rect width='%d' height='%d' fill='#fff'/>\n", WIDTH, height);
    fprintf(out, "<text id='title' class='title' x='%d' y='24'>", MARGIN);
    write_escaped(f->program[FLAME_NOW], 60, out);
    fprintf(out, " on %" PRIu32 " node%s%s</text>\n", f->nodes[FLAME_NOW],
            f->nodes[FLAME_NOW] == 1 ? "" : "s", flame_is_diff(f) ? ", compared" : "");
    fprintf(out, "<text class='note' x='%d' y='44'>", MARGIN);
    if (flame_is_diff(f)) {
        fputs("width: time now; red: itself takes more, blue: less. Before: ", out);
        write_escaped(f->program[FLAME_BEFORE], 60, out);
        fprintf(out, ": %s of the nodes' time; now %s",
                duration_text(vt_sum_seconds(f->root->total[FLAME_BEFORE])).text,
                duration_text(vt_sum_seconds(f->root->total[FLAME_NOW])).text);
    } else {
        fprintf(out, "width: virtual time, summed over nodes: %s in all. Counted, not sampled",
                duration_text(vt_sum_seconds(f->root->total[FLAME_NOW])).text);
    }
    fprintf(out,
            "</text>\n<text id='reset' class='button' x='%d' y='24' style='display:none' tabindex='0' "
            "role='button'>all (Esc)</text>\n",
            WIDTH - 250);
    fprintf(out,
            "<text id='search' class='button' x='%d' y='24' style='display:none' tabindex='0' "
            "role='button'>search (/)</text>\n",
            WIDTH - 150);
    fprintf(out, "<text id='found' class='note' x='%d' y='44' text-anchor='end'></text>\n", WIDTH - MARGIN);
}

static void write_legend(const struct svg *s, int y)
{
    static const struct {
        enum flame_kind kind;
        const char *what;
    } ITEMS[] = {{FLAME_FUNCTION, "function"},    {FLAME_INLINED, "inlined"}, {FLAME_LIBRARY, "C library"},
                 {FLAME_CALL, "system: NX call"}, {FLAME_WAITING, "waiting"}, {FLAME_OTHER, "other"}};
    int x = WIDTH - MARGIN - 640;
    if (flame_is_diff(s->flame))
        return;
    for (size_t i = 0; i < sizeof ITEMS / sizeof *ITEMS; i++) {
        struct flame_frame sample = {.kind = ITEMS[i].kind, .name = (char *)(uintptr_t) "x"};
        fprintf(s->out, "<rect x='%d' y='%d' width='12' height='12' fill='", x, y - 10);
        write_colour(s, &sample);
        fprintf(s->out, "'/><text class='note' x='%d' y='%d'>%s</text>\n", x + 16, y, ITEMS[i].what);
        x += 16 + 26 + LETTER * (int)strlen(ITEMS[i].what) + 6;
    }
}

void flame_write_svg(const struct flame *f, FILE *out)
{
    struct svg s = {.flame = f, .out = out};
    s.rows = rows_of(&s, f->root);
    find_largest(&s, f->root);
    write_head(&s);
    write_frame(&s, f->root, 0, MARGIN);
    int y = TOP + s.rows * ROW + 24;
    fprintf(out, "<text id='info' class='note' x='%d' y='%d'>", MARGIN, y);
    if (s.left_out)
        fprintf(out, "%zu frames are too narrow to be drawn", s.left_out);
    if (flame_is_diff(f) && gone(f->root)) {
        fputs(s.left_out ? "; gone with their frames: " : "gone with their frames: ", out);
        write_time(gone(f->root), out);
    }
    fputs("</text>\n", out);
    write_legend(&s, y + (s.rows ? 0 : ROW));
    fputs(SCRIPT, out);
    fputs("</svg>\n", out);
}
