/* Scene files through Assimp's C interface. */
#include "scene.h"

#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <string.h>

#include "message.h"

static size_t count_faces(const struct aiMesh *mesh, unsigned corners)
{
    size_t count = 0;
    unsigned i;
    for (i = 0; i < mesh->mNumFaces; i++)
        count += mesh->mFaces[i].mNumIndices == corners;
    return count;
}

/* Appends a mesh; the counts of *out say how much is there already. */
static void append(const struct aiMesh *mesh, scene *out)
{
    uint32_t first = (uint32_t)out->vertex_count;
    unsigned i, corner;
    for (i = 0; i < mesh->mNumVertices; i++) {
        float *vertex = out->vertices + 3 * out->vertex_count++;
        vertex[0] = mesh->mVertices[i].x;
        vertex[1] = mesh->mVertices[i].y;
        vertex[2] = mesh->mVertices[i].z;
    }
    for (i = 0; i < mesh->mNumFaces; i++) {
        const struct aiFace *face = &mesh->mFaces[i];
        uint32_t *triangle = out->indices + 3 * out->triangle_count;
        if (face->mNumIndices != 3)
            continue;
        for (corner = 0; corner < 3; corner++)
            triangle[corner] = first + face->mIndices[corner];
        out->triangle_count++;
    }
}

static int gather(const char *path, const struct aiScene *file, scene *out)
{
    size_t vertices = 0, triangles = 0, faces = 0;
    unsigned i;
    for (i = 0; i < file->mNumMeshes; i++) {
        vertices += file->mMeshes[i]->mNumVertices;
        triangles += count_faces(file->mMeshes[i], 3);
        faces += file->mMeshes[i]->mNumFaces;
    }
    if (triangles == 0) {
        message("%s: holds no triangle", path);
        return 0;
    }
    if (vertices > 0xffffffffu) {
        message("%s: more than 2^32 vertices", path);
        return 0;
    }
    if (!scene_reserve(out, vertices, triangles))
        return 0;
    out->not_triangles = faces - triangles;
    for (i = 0; i < file->mNumMeshes; i++)
        append(file->mMeshes[i], out);
    return 1;
}

int scene_read_file(const char *path, scene *out)
{
    /* PreTransformVertices puts each mesh where the file's node tree has it. */
    const struct aiScene *file =
        aiImportFile(path, aiProcess_Triangulate | aiProcess_PreTransformVertices);
    int ok;
    if (!file) {
        message("%s: cannot be read: %s", path, aiGetErrorString());
        return 0;
    }
    ok = gather(path, file, out);
    aiReleaseImport(file);
    return ok;
}
