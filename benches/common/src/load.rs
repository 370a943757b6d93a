//! Scenes by name: built in, a file, or a file in the folder that `HUG_SCENES` names.

use super::{cameras, obj, ply};
use hug::{Geometry, Options, Scene};
use hug_kit::{Bounds, Mesh, View, scenes};
use std::env;
use std::path::{Path, PathBuf};

/// A scene to measure on.
pub struct Loaded {
    pub name: String,
    pub mesh: Mesh,
    pub bounds: Bounds,
    views: Vec<(String, View)>,
}

impl Loaded {
    /// One of the kit's, `clustered:100000` and the like included, or a PLY or OBJ file.
    pub fn new(name: &str) -> Result<Self, String> {
        if let Some(scene) = scenes::generate(name) {
            let views = scene.views.iter().map(|v| (v.name.to_owned(), v.view)).collect();
            return Self::of(name, name.to_owned(), scene.mesh, views);
        }
        let path = find(name).ok_or_else(|| missing(name))?;
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let obj = path.extension().is_some_and(|end| end.eq_ignore_ascii_case("obj"));
        let mesh = if obj { obj::read(&path)? } else { ply::read(&path)? };
        Self::of(&path.to_string_lossy(), stem, mesh, cameras::beside(&path)?)
    }

    fn of(
        from: &str,
        name: String,
        mesh: Mesh,
        views: Vec<(String, View)>,
    ) -> Result<Self, String> {
        let bounds = mesh.bounds().ok_or_else(|| format!("{from}: no finite vertex"))?;
        Ok(Self { name, mesh, bounds, views })
    }

    /// The triangles as the library takes them.
    pub fn soup(&self) -> [Geometry<'_>; 1] {
        [Geometry::from_mesh(&self.mesh.vertices, &self.mesh.indices)]
    }

    pub fn build(&self, options: &Options) -> Result<Scene, String> {
        Scene::build(&self.soup(), options).map_err(|error| format!("{}: {error}", self.name))
    }

    /// Up to so many views, by name; one from inside the box if it has none.
    pub fn first_views(&self, most: usize) -> Vec<(String, View)> {
        if self.views.is_empty() {
            return vec![("inside".to_owned(), View::derived(&self.bounds))];
        }
        self.views.iter().take(most).cloned().collect()
    }

    /// The view of this name; without one the first, of a scene that has any, or else one from
    /// inside the box.
    pub fn view(&self, name: Option<&str>) -> Result<View, String> {
        let Some(name) = name else {
            return Ok(self.views.first().map_or_else(|| View::derived(&self.bounds), |v| v.1));
        };
        self.views.iter().find(|v| v.0 == name).map(|v| v.1).ok_or_else(|| {
            let known: Vec<&str> = self.views.iter().map(|v| v.0.as_str()).collect();
            format!("{}: no view {name}; it has: {}", self.name, known.join(", "))
        })
    }
}

fn find(name: &str) -> Option<PathBuf> {
    let in_folder = |folder: PathBuf| {
        let path = folder.join(name);
        if path.is_file() {
            return path;
        }
        let ply = folder.join(format!("{name}.ply"));
        if ply.is_file() { ply } else { folder.join(format!("{name}.obj")) }
    };
    let given = Some(PathBuf::from(name));
    let kept = folder().map(in_folder);
    [given, kept].into_iter().flatten().find(|path| path.is_file())
}

/// Why there is no such scene: a name with a dot or a slash was meant to be a file's.
fn missing(name: &str) -> String {
    if Path::new(name).is_dir() {
        return format!("{name}: a folder, not a file");
    }
    if name.contains(['.', '/']) {
        return format!("{name}: no such file, nor in the folder $HUG_SCENES");
    }
    let known = scenes::NAMES.join(", ");
    format!(
        "{name}: no such scene: {known}, surface:N, uniform:N, clustered:N, \
         or a PLY or OBJ file, also one in the folder $HUG_SCENES"
    )
}

fn folder() -> Option<PathBuf> {
    env::var_os("HUG_SCENES").map(PathBuf::from)
}

/// The PLY files of at most so many bytes in the folder that `HUG_SCENES` names, by name; none
/// without it.
pub fn files(most_bytes: u64) -> Result<Vec<String>, String> {
    let Some(folder) = folder() else { return Ok(Vec::new()) };
    let failed = |error| format!("HUG_SCENES: {}: {error}", folder.display());
    let mut names = Vec::new();
    for entry in folder.read_dir().map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        let small = || path.metadata().is_ok_and(|m| m.is_file() && m.len() <= most_bytes);
        if path.extension().is_some_and(|e| e == "ply") && small() {
            names.push(stem(&path));
        }
    }
    names.sort();
    Ok(names)
}

fn stem(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}
