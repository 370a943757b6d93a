#include "compare/results.h"

#include <stdlib.h>
#include <string.h>

#include "compare/ray_sets.h"
#include "message.h"

/* Room for one more after count rows; NULL after a message. */
static void *grow(void *rows, size_t count, size_t size)
{
    void *grown = rows;
    /* doubled whenever the count is a power of two, and so full */
    if ((count & (count - 1)) == 0)
        grown = realloc(rows, (count ? 2 * count : 1) * size);
    if (!grown)
        message("no memory for the results");
    return grown;
}

int results_add_build(results *r, const build_row *row)
{
    build_row *grown = (build_row *)grow(r->builds, r->build_count, sizeof *row);
    if (!grown)
        return 0;
    r->builds = grown;
    r->builds[r->build_count++] = *row;
    return 1;
}

int results_add_query(results *r, const query_row *row)
{
    query_row *grown = (query_row *)grow(r->queries, r->query_count, sizeof *row);
    if (!grown)
        return 0;
    r->queries = grown;
    r->queries[r->query_count++] = *row;
    return 1;
}

void results_free(results *r)
{
    free(r->builds);
    free(r->queries);
    memset(r, 0, sizeof *r);
}

const char *query_name(int set, int stream)
{
    if (set == RAYS_SHADOW)
        return stream ? "occluded_stream" : "occluded";
    return stream ? "closest_stream" : "closest";
}

double ratio_of(double reference, double own)
{
    return own > 0.0 ? reference / own : 0.0;
}

double query_ratio(const query_row *row)
{
    return ratio_of(row->reference, row->seconds);
}

double build_ratio(const build_row *row)
{
    return ratio_of(row->reference_cpu, row->cpu);
}

double millions(size_t number, double seconds)
{
    return seconds > 0.0 ? 1e-6 * (double)number / seconds : 0.0;
}

double bytes_per_triangle(unsigned long long bytes, size_t triangles)
{
    return triangles ? (double)bytes / (double)triangles : 0.0;
}
