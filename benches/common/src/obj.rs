//! Meshes from OBJ files: triangles, or polygons cut into them; materials are not looked at.

use hug_kit::Mesh;
use std::fs::File;
use std::io::BufReader;
use std::path::Path;
use tobj::{LoadError, LoadOptions};

/// The mesh of an OBJ file, all objects of it in their order.
pub fn read(path: &Path) -> Result<Mesh, String> {
    let failed = |what: &dyn std::fmt::Display| format!("{}: {what}", path.display());
    let file = File::open(path).map_err(|error| failed(&error))?;
    let options = LoadOptions { triangulate: true, ..LoadOptions::default() };
    let no_materials = |_: &Path| Err(LoadError::GenericFailure);
    let read = tobj::load_obj_buf(&mut BufReader::new(file), &options, no_materials);
    let (models, _) = read.map_err(|error| match error {
        LoadError::ReadError => failed(&"is not text, as an OBJ file is"),
        error => failed(&error),
    })?;
    let mut mesh = Mesh::default();
    for model in models {
        let first = u32::try_from(mesh.vertices.len()).map_err(|error| failed(&error))?;
        mesh.vertices.extend(model.mesh.positions.chunks_exact(3).map(|p| [p[0], p[1], p[2]]));
        let triangles = model.mesh.indices.chunks_exact(3);
        mesh.indices.extend(triangles.map(|t| [t[0], t[1], t[2]].map(|corner| first + corner)));
    }
    if mesh.indices.is_empty() {
        return Err(failed(&"has no faces that can be read"));
    }
    Ok(mesh)
}
