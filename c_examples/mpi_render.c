/* What it teaches: one frame on many machines. Rank 0 builds the scene and writes its
 * arena to a file; every rank maps that file, so the arena is what travels (through a
 * shared file system here; MPI_Bcast of the same bytes would do where there is none) and
 * no rank builds anything. Ranks take tiles in turn, trace each as one stream, and rank 0
 * gathers them. The picture does not depend on the number of ranks: not a bit of it, for
 * hits are exact on every processor.
 *
 * usage: mpirun -n RANKS mpi_render ARENA PICTURE.png [SIZE]
 */
#define _DEFAULT_SOURCE
#include <errno.h>
#include <fcntl.h>
#define OMPI_SKIP_MPICXX
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <stb_image_write.h>

#include "lessons/waves.h"

#define SIDE 400
#define TILE 32u
#define TILE_PIXELS (TILE * TILE)

/* What a rank cannot recover from, and so nor can the others. */
static void stop(int rank, const char *what, const char *why)
{
    fprintf(stderr, "mpi_render: rank %d: %s: %s\n", rank, what, why);
    MPI_Abort(MPI_COMM_WORLD, 1);
}

static void build_and_write(const char *path)
{
    float *vertices = (float *)malloc(3 * WAVES_VERTICES(SIDE) * sizeof(float));
    uint32_t *indices = (uint32_t *)malloc(3 * WAVES_TRIANGLES(SIDE) * sizeof(uint32_t));
    hug_geometry geometry;
    hug_build_desc desc;
    hug_scene *scene;
    hug_status status;
    const void *bytes;
    size_t size;
    FILE *file;
    if (!vertices || !indices) {
        stop(0, "the mesh", "no memory");
        return;
    }
    waves_vertices(SIDE, 0.0f, vertices);
    waves_indices(SIDE, indices);
    geometry = waves_geometry(SIDE, vertices, indices);
    desc = waves_desc(&geometry);
    status = hug_build(&desc, &scene);
    if (status != HUG_OK)
        stop(0, "the build", hug_status_string(status));
    bytes = hug_data(scene, &size);
    file = fopen(path, "wb");
    if (!file || fwrite(bytes, 1, size, file) != size || fclose(file) != 0)
        stop(0, path, strerror(errno));
    printf("%lu triangles, an arena of %lu bytes\n", (unsigned long)WAVES_TRIANGLES(SIDE),
           (unsigned long)size);
    hug_free(scene);
    free(vertices);
    free(indices);
}

static const hug_scene *map(const char *path, int rank)
{
    const hug_scene *scene = NULL;
    struct stat info;
    hug_status status;
    void *bytes = MAP_FAILED;
    int file = open(path, O_RDONLY);
    if (file >= 0 && fstat(file, &info) == 0)
        bytes = mmap(NULL, (size_t)info.st_size, PROT_READ, MAP_SHARED, file, 0);
    if (bytes == MAP_FAILED)
        stop(rank, path, strerror(errno));
    close(file); /* the mapping stays */
    status = hug_open(bytes, (size_t)info.st_size, 0, &scene);
    if (status != HUG_OK)
        stop(rank, path, hug_status_string(status));
    return scene;
}

static void render_tile(const hug_scene *scene, unsigned tile, unsigned size,
                        unsigned char *pixels)
{
    static hug_ray rays[TILE_PIXELS];
    static hug_hit hits[TILE_PIXELS];
    unsigned left = tile % (size / TILE) * TILE, top = tile / (size / TILE) * TILE, i;
    for (i = 0; i < TILE_PIXELS; i++)
        rays[i] = waves_ray(left + i % TILE, top + i / TILE, size, size);
    hug_intersect_n(scene, rays, 0, hits, 0, TILE_PIXELS);
    for (i = 0; i < TILE_PIXELS; i++)
        pixels[i] = waves_shade(&hits[i]);
}

/* Tiles come rank by rank: rank r's k-th is number r + k ranks. */
static void write_picture(const char *path, const unsigned char *tiles, unsigned size,
                          unsigned ranks, unsigned share)
{
    unsigned count = (size / TILE) * (size / TILE), tile, i;
    unsigned char *picture = (unsigned char *)malloc((size_t)size * size);
    if (!picture) {
        stop(0, path, "no memory for the picture");
        return;
    }
    for (tile = 0; tile < count; tile++) {
        unsigned left = tile % (size / TILE) * TILE, top = tile / (size / TILE) * TILE;
        const unsigned char *from = tiles + (size_t)(tile % ranks * share + tile / ranks) * TILE_PIXELS;
        for (i = 0; i < TILE_PIXELS; i++)
            picture[(size_t)(top + i / TILE) * size + left + i % TILE] = from[i];
    }
    if (!stbi_write_png(path, (int)size, (int)size, 1, picture, (int)size))
        stop(0, path, "cannot be written");
    printf("%u tiles by %u ranks, picture %016llx\n", count, ranks,
           (unsigned long long)waves_digest(WAVES_SEED, picture, (size_t)size * size));
    free(picture);
}

int main(int argc, char **argv)
{
    int rank, ranks, size = argc > 3 ? atoi(argv[3]) : 512;
    unsigned count, share, k;
    const hug_scene *scene;
    unsigned char *mine, *all = NULL;
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    if (argc < 3 || size < (int)TILE || size > 16384 || size % (int)TILE) {
        if (rank == 0)
            fprintf(stderr, "usage: mpirun -n RANKS mpi_render ARENA PICTURE.png "
                            "[SIZE, a multiple of %u]\n", TILE);
        MPI_Finalize();
        return 2;
    }
    if (rank == 0)
        build_and_write(argv[1]);
    MPI_Barrier(MPI_COMM_WORLD);
    scene = map(argv[1], rank);

    count = (unsigned)size / TILE * ((unsigned)size / TILE);
    share = (count + (unsigned)ranks - 1) / (unsigned)ranks;
    mine = (unsigned char *)calloc(share, TILE_PIXELS);
    if (rank == 0)
        all = (unsigned char *)calloc((size_t)share * (unsigned)ranks, TILE_PIXELS);
    if (!mine || (rank == 0 && !all))
        stop(rank, "tiles", "no memory");
    for (k = 0; (unsigned)rank + k * (unsigned)ranks < count; k++)
        render_tile(scene, (unsigned)rank + k * (unsigned)ranks, (unsigned)size,
                    mine + (size_t)k * TILE_PIXELS);
    MPI_Gather(mine, (int)(share * TILE_PIXELS), MPI_UNSIGNED_CHAR, all,
               (int)(share * TILE_PIXELS), MPI_UNSIGNED_CHAR, 0, MPI_COMM_WORLD);
    if (rank == 0)
        write_picture(argv[2], all, (unsigned)size, (unsigned)ranks, share);
    free(mine);
    free(all);
    MPI_Finalize();
    return 0;
}
