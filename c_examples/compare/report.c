#include "compare/report.h"

#include <stdio.h>

#include "compare/decisions.h"
#include "compare/report_csv.h"
#include "compare/report_markdown.h"
#include "compare/report_text.h"
#include "message.h"

void report_begin(const settings *with)
{
    if (with->format == FORMAT_CSV)
        csv_begin(with);
    fflush(stdout);
}

/* Triangles that no structure of hug has. */
static size_t dropped(const comparison *c)
{
    int i = 0;
    while (!c->built[i])
        i++;
    return c->from->triangle_count - c->builds[i].triangles;
}

void report_scene(const comparison *c)
{
    if (dropped(c))
        message("%s: hug leaves out %lu triangles, degenerate or not finite; Embree has them all",
                c->from->name, (unsigned long)dropped(c));
    if (c->with->format == FORMAT_TEXT)
        text_scene(c);
}

void report_build(int format, const build_row *row)
{
    if (format == FORMAT_TEXT)
        text_build(row);
    fflush(stdout);
}

void report_view(const comparison *c)
{
    if (c->with->format == FORMAT_TEXT)
        text_view(c->view_name);
    fflush(stdout);
}

void report_query(const comparison *c, const query_row *row, const build_row *build)
{
    if (c->with->format == FORMAT_TEXT)
        text_query(row);
    else if (c->with->format == FORMAT_CSV)
        csv_query(c->with, row, build, &c->threaded,
                  build->peer ? NULL : &c->threaded_builds[build - c->builds]);
    fflush(stdout);
}

size_t report_decisions(const comparison *c)
{
    return print_decisions(c->with->format == FORMAT_TEXT ? stdout : stderr, c);
}

void report_summary(const settings *with, const results *found)
{
    if (found->build_count == 0)
        return;
    if (with->format == FORMAT_MARKDOWN)
        markdown_summary(with, found);
    else if (with->all && with->format == FORMAT_CSV)
        csv_summary(with, found);
    else if (with->all)
        text_summary(found);
    fflush(stdout);
}
