//! Triangles, options and rays out of an input.

use super::input::Input;
use hug::{
    Clustering, Delta, Filter, Geometry, Gridding, Hierarchy, Hit, NONE, Options, Orientation,
    Probe, Quality, Ray, Structure, intersect_triangle,
};

/// Few enough triangles for brute force.
const MOST: usize = 48;

/// Two meshes over the same vertices.
pub struct Soup {
    pub vertices: Vec<[f32; 3]>,
    pub indices: [Vec<[u32; 3]>; 2],
    masks: [u32; 2],
}

impl Soup {
    pub fn read(input: &mut Input<'_>) -> Self {
        let mut vertices = vec![input.point()];
        let mut indices: [Vec<[u32; 3]>; 2] = Default::default();
        for _ in 0..input.below(MOST + 1) {
            let kind = input.byte();
            let to = usize::from(kind >> 7);
            let triangle = [0, 1, 2].map(|corner| {
                let old = kind >> corner & 1 != 0;
                if old {
                    input.below(vertices.len()) as u32
                } else {
                    let near = kind >> 3 & 1 != 0;
                    let last = vertices[vertices.len() - 1];
                    let point = input.point();
                    let nearby = [0, 1, 2].map(|k| last[k] + point[k] / 1024.0);
                    vertices.push(if near { nearby } else { point });
                    vertices.len() as u32 - 1
                }
            });
            // Several of the same.
            for _ in 0..=kind >> 4 & 7 {
                indices[to].push(triangle);
            }
        }
        let masks = [(); 2].map(|()| if input.rarely(8) { input.bits() } else { u32::MAX });
        Self { vertices, indices, masks }
    }

    pub fn geometries(&self) -> [Geometry<'_>; 2] {
        [0, 1]
            .map(|i| Geometry::from_mesh(&self.vertices, &self.indices[i]).with_mask(self.masks[i]))
    }

    /// What a ray hits, in order: each triangle on its own.
    pub fn all_hits(&self, ray: &Ray) -> Vec<Hit> {
        let mut hits = Vec::new();
        for (geom, (indices, mask)) in (0..).zip(self.indices.iter().zip(self.masks)) {
            for (prim, corners) in (0..).zip(indices) {
                if mask & ray.mask == 0 || (ray.skip_geom, ray.skip_prim) == (geom, prim) {
                    continue;
                }
                let any = Ray { mask: u32::MAX, skip_geom: NONE, skip_prim: NONE, ..*ray };
                let corners = corners.map(|vertex| self.vertices[vertex as usize]);
                let hit = intersect_triangle(&any, &corners);
                if hit.is_hit() {
                    hits.push(Hit { geom, prim, ..hit });
                }
            }
        }
        let place = |hit: &Hit| (hit.t, hit.geom, hit.prim);
        hits.sort_by(|a, b| place(a).partial_cmp(&place(b)).expect("no NaN"));
        hits
    }

    /// Through a vertex, an edge, or the inside of a triangle, or anywhere.
    fn target(&self, input: &mut Input<'_>) -> [f32; 3] {
        let at = |i: usize| self.vertices[i % self.vertices.len()];
        let (a, b, c) = (at(input.below(256)), at(input.below(256)), at(input.below(256)));
        match input.below(4) {
            0 => a,
            1 => [0, 1, 2].map(|k| (a[k] + b[k]) / 2.0),
            2 => [0, 1, 2].map(|k| (a[k] + b[k] + c[k]) / 3.0),
            _ => input.point(),
        }
    }

    pub fn ray(&self, input: &mut Input<'_>) -> Ray {
        let (org, target) = (input.point(), self.target(input));
        let mut dir = [0, 1, 2].map(|k| target[k] - org[k]);
        let kind = input.byte();
        if kind & 1 != 0 {
            dir = input.point();
        }
        for (k, d) in dir.iter_mut().enumerate() {
            if kind >> (1 + k) & 1 != 0 {
                *d = 0.0;
            }
        }
        let mut ray = Ray::new(org, dir);
        if kind >> 4 & 1 != 0 {
            (ray.tmin, ray.tmax) = (input.float(), input.float());
        }
        if kind >> 5 & 1 != 0 {
            (ray.skip_geom, ray.skip_prim) = (input.below(3) as u32, input.below(64) as u32);
        }
        if kind >> 6 & 1 != 0 {
            ray.mask = input.bits();
        }
        if kind >> 7 & 1 != 0 {
            (ray.tmin, ray.tmax) = (f32::NEG_INFINITY, f32::INFINITY);
        }
        debug_assert!(ray.skip_geom == NONE || ray.skip_geom < 3);
        ray
    }
}

/// What was added to the options later: read after all else, so that older inputs mean
/// what they did, and zeros are the defaults.
pub fn later(input: &mut Input<'_>, options: Options) -> Options {
    let gridding = match input.below(4) {
        1 => Gridding::Overlap,
        2 => Gridding::Mixed,
        _ => options.gridding,
    };
    let overlap_power = match input.byte() {
        0 => options.overlap_power,
        power => f32::from(power) / 64.0,
    };
    let clustering = input.one_of(&[Clustering::Projections, Clustering::Components]);
    let orientation = match input.below(4) {
        1 => Orientation::Vertices,
        2 => Orientation::Hull,
        3 => Orientation::Search,
        _ => Orientation::Aligned,
    };
    let turn_below = input.one_of(&[options.turn_below, 1e6, 1.0]);
    let fill_up = input.below(2) != 0;
    let tree = input.below(2) != 0;
    let options = Options { gridding, overlap_power, clustering, orientation, ..options };
    Options { turn_below, fill_up, tree, ..options }
}

/// Balls anywhere, of any size.
pub fn probe(input: &mut Input<'_>) -> Probe {
    let mut probe = Probe::new(input.point(), f32::INFINITY);
    let kind = input.byte();
    if kind & 1 != 0 {
        probe.radius = input.float();
    }
    if kind & 6 == 6 {
        (probe.skip_geom, probe.skip_prim) = (input.below(3) as u32, input.below(64) as u32);
    }
    if kind & 24 == 24 {
        probe.mask = input.bits();
    }
    probe
}

/// Options in their ranges, of a structure.
pub fn options(input: &mut Input<'_>, structure: Structure) -> Options {
    let share = |input: &mut Input<'_>| (f32::from(input.byte()) + 1.0) / 256.0;
    let alpha = |input: &mut Input<'_>| 0.1 + 2.0 * share(input);
    let counts =
        if input.rarely(8) { [(); 3].map(|()| 1 + input.below(12) as u32) } else { [0; 3] };
    let filter = match input.below(4) {
        0 => Filter::TwoLevels(share(input)),
        1 => Filter::ThreeLevels,
        2 => Filter::default(),
        _ => {
            let (mut at, count) = ([0.0; 15], input.below(16));
            let mut length = 0.0;
            for to in &mut at[..count] {
                length += 4.0 * share(input);
                *to = length;
            }
            Filter::Thresholds { count, at }
        }
    };
    Options {
        structure,
        gridding: input.one_of(&[Gridding::Proportional, Gridding::Homogeneous]),
        counts,
        alpha: alpha(input),
        world_alpha: if input.rarely(4) { None } else { Some(alpha(input)) },
        maxp: 1 + input.below(64) as u32,
        max_depth: 1 + input.below(16) as u32,
        filter,
        connectivity: 8.0 * share(input),
        delta: input.one_of(&[Delta::Midpoint, Delta::Mean]),
        hierarchy: input.one_of(&[Hierarchy::Nested, Hierarchy::Paper]),
        min_cluster: 1 + input.below(10) as u32,
        exit_boxes: !input.rarely(6),
        max_refs: input.one_of(&[1, 2, 8, 32, 64]),
        quality: input.one_of(&[Quality::Default, Quality::Fast, Quality::High]),
        compact: input.rarely(4),
        ..Options::default()
    }
}
