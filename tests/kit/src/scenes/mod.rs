//! The project's own scenes, after section 2 of the paper: y is up, lengths are metres.

mod building;
mod city;
mod garden;
mod kitchen;
mod shape;

pub use building::{building, building_walls};
pub use city::city;
pub use garden::garden;
pub use kitchen::kitchen;

use crate::{Mesh, View, soups};

/// The scenes of the paper's figure 4, in its order.
pub const NAMES: [&str; 5] = ["kitchen", "building_walls", "building", "city", "garden"];

/// The largest size that `generate` accepts after a colon.
pub const MAX_SIZE: usize = 50_000_000;

/// A mesh and good places to look at it from.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    pub mesh: Mesh,
    pub views: Vec<NamedView>,
}

/// A view and what to call it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NamedView {
    pub name: &'static str,
    pub view: View,
}

/// A scene by name: one of [`NAMES`], or `surface:N`, `uniform:N`, `clustered:N` with about N
/// triangles. `None` for other names and sizes.
pub fn generate(name: &str) -> Option<Scene> {
    let (kind, size) = match name.split_once(':') {
        Some((kind, size)) => (kind, Some(size.parse::<usize>().ok()?)),
        None => (name, None),
    };
    let sized = |make: fn(usize) -> Mesh| {
        let size = size.filter(|n| (1..=MAX_SIZE).contains(n))?;
        let mesh = make(size);
        let view = View::derived(&mesh.bounds()?);
        let views = vec![NamedView { name: "derived", view }];
        Some(Scene { mesh, views })
    };
    match (kind, size) {
        ("kitchen", None) => Some(kitchen()),
        ("building_walls", None) => Some(building_walls()),
        ("building", None) => Some(building()),
        ("city", None) => Some(city()),
        ("garden", None) => Some(garden()),
        ("surface", _) => sized(soups::surface),
        ("uniform", _) => sized(soups::uniform),
        ("clustered", _) => sized(soups::clustered),
        _ => None,
    }
}
