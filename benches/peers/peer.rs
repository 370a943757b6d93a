//! obvhs as its documentation says to use it for speed: triangles prepared for intersection, in
//! the order of the tree's leaves.

use clap::ValueEnum;
use hug_kit::Mesh;
use obvhs::BvhBuildParams;
use obvhs::bvh2::{Bvh2, builder::build_bvh2_from_tris};
use obvhs::cwbvh::{CwBvh, builder::build_cwbvh_from_tris};
use obvhs::ray::{Ray, RayHit};
use obvhs::rt_triangle::RtTriangle;
use obvhs::triangle::Triangle;
use std::time::Duration;

/// A kind of tree and one of obvhs's presets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Builder {
    CwbvhMedium,
    CwbvhSlow,
    Bvh2Medium,
    Bvh2Slow,
}

impl Builder {
    pub const NAMES: [&'static str; 4] = ["cwbvh-medium", "cwbvh-slow", "bvh2-medium", "bvh2-slow"];

    pub fn name(self) -> &'static str {
        Self::NAMES[self as usize]
    }

    fn parameters(self) -> BvhBuildParams {
        match self {
            Self::CwbvhMedium | Self::Bvh2Medium => BvhBuildParams::medium_build(),
            Self::CwbvhSlow | Self::Bvh2Slow => BvhBuildParams::slow_build(),
        }
    }
}

enum Tree {
    Wide(CwBvh),
    Binary(Bvh2),
}

/// What a closest hit of obvhs says; a miss has no triangle.
#[derive(Clone, Copy)]
pub struct Found {
    pub t: f32,
    pub triangle: u32,
}

impl Found {
    pub const MISS: Self = Self { t: f32::INFINITY, triangle: u32::MAX };

    pub fn is_hit(&self) -> bool {
        self.triangle != u32::MAX
    }
}

/// A tree, ready for rays.
pub struct Built {
    tree: Tree,
    triangles: Vec<RtTriangle>,
}

impl Built {
    /// From vertices and indices, as hug's builds start.
    pub fn new(builder: Builder, mesh: &Mesh) -> Self {
        let soup: Vec<Triangle> = mesh
            .triangles()
            .map(|[a, b, c]| Triangle { v0: a.into(), v1: b.into(), v2: c.into() })
            .collect();
        // obvhs adds its own wall-clock time to this.
        let (parameters, mut unused) = (builder.parameters(), Duration::ZERO);
        let tree = match builder {
            Builder::CwbvhMedium | Builder::CwbvhSlow => {
                Tree::Wide(build_cwbvh_from_tris(&soup, parameters, &mut unused))
            }
            Builder::Bvh2Medium | Builder::Bvh2Slow => {
                Tree::Binary(build_bvh2_from_tris(&soup, parameters, &mut unused))
            }
        };
        let order = indices(&tree).iter();
        let triangles = order.map(|&i| RtTriangle::from(&soup[i as usize])).collect();
        Self { tree, triangles }
    }

    /// What queries read: nodes, triangles, and the triangles' original numbers.
    pub fn bytes(&self) -> usize {
        let nodes = match &self.tree {
            Tree::Wide(tree) => size_of_val(tree.nodes.as_slice()),
            Tree::Binary(tree) => size_of_val(tree.nodes.as_slice()),
        };
        nodes + size_of_val(self.triangles.as_slice()) + size_of_val(indices(&self.tree))
    }

    pub fn closest(&self, rays: &[Ray], found: &mut [Found]) {
        let order = indices(&self.tree);
        let answer = |hit: &RayHit| match order.get(hit.primitive_id as usize) {
            Some(&triangle) => Found { t: hit.t, triangle },
            None => Found::MISS,
        };
        let test = |ray: &Ray, i: usize| self.triangles[i].intersect(ray);
        for (ray, found) in rays.iter().zip(found) {
            let mut hit = RayHit::none();
            match &self.tree {
                Tree::Wide(tree) => tree.ray_traverse(*ray, &mut hit, test),
                Tree::Binary(tree) => tree.ray_traverse(*ray, &mut hit, test),
            };
            *found = answer(&hit);
        }
    }

    pub fn occluded(&self, rays: &[Ray], answers: &mut [bool]) {
        let test = |ray: &Ray, i: usize| self.triangles[i].intersect(ray);
        for (ray, answer) in rays.iter().zip(answers) {
            *answer = !match &self.tree {
                Tree::Wide(tree) => tree.ray_traverse_miss(*ray, test),
                Tree::Binary(tree) => tree.ray_traverse_miss(*ray, test),
            };
        }
    }
}

fn indices(tree: &Tree) -> &[u32] {
    match tree {
        Tree::Wide(tree) => &tree.primitive_indices,
        Tree::Binary(tree) => &tree.primitive_indices,
    }
}

/// Rays in obvhs's record, which holds the reciprocals of the direction.
pub fn rays(set: &[hug::Ray]) -> Vec<Ray> {
    set.iter().map(|r| Ray::new(r.org.into(), r.dir.into(), r.tmin, r.tmax)).collect()
}
