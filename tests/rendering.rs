//! Rendering statistics against a walk that knows nothing of stepping: of every grid, all voxels
//! are cut with the ray, read from the arena's bytes, and every triangle is asked one by one.
#![allow(missing_docs)]

mod common;

use common::{build, layout as bytes};
use hug::{Calls, Geometry, Hit, Options, Profile, Ray, Scene, Structure};
use hug_kit::random::Random;
use hug_kit::{Mesh, soups};

struct Grid {
    level: usize,
    first: usize,
    n: [usize; 3],
    lo: [f64; 3],
    cell: [f64; 3],
}

fn grids(arena: &[u8]) -> Vec<Grid> {
    let f64_at = |at: usize| f64::from_bits(bytes::get64(arena, at));
    let of = |number| {
        let at = bytes::record(arena, bytes::GRIDS, number);
        let inv = |k: usize| f32::from_bits(bytes::get32(arena, at + bytes::INV_CELL + 4 * k));
        Grid {
            level: usize::from(arena[at + bytes::LEVEL]),
            first: bytes::get32(arena, at + bytes::FIRST) as usize,
            n: [0, 1, 2].map(|k| usize::from(bytes::get16(arena, at + bytes::N + 2 * k))),
            lo: [0, 1, 2].map(|k| f64_at(at + bytes::LO + 8 * k)),
            cell: [0, 1, 2].map(|k| 1.0 / f64::from(inv(k))),
        }
    };
    (0..bytes::count(arena, bytes::GRIDS)).map(of).collect()
}

/// What a voxel refers to: triangles, then grids.
fn refs(arena: &[u8], voxel: usize) -> (Vec<usize>, Vec<usize>) {
    match bytes::voxel(arena, voxel) {
        (bytes::LIST, start) => {
            let head = bytes::record(arena, bytes::REFS, start as usize);
            let all = (0..bytes::get32(arena, head + 4) as usize)
                .map(|i| bytes::get32(arena, head + 8 + 4 * i));
            let (grids, triangles): (Vec<u32>, Vec<u32>) =
                all.partition(|r| r & bytes::GRID_BIT != 0);
            let number = |r: &u32| (r & !bytes::GRID_BIT) as usize;
            (triangles.iter().map(number).collect(), grids.iter().map(number).collect())
        }
        (bytes::GRID, number) => (Vec::new(), vec![number as usize]),
        _ => (Vec::new(), Vec::new()),
    }
}

/// The triangles in the arena's order, each also as a scene of its own.
fn triangles(arena: &[u8]) -> Vec<([[f32; 3]; 3], Scene)> {
    let of = |number| {
        let at = bytes::record(arena, bytes::TRIANGLES, number);
        let c = bytes::COORDINATES.map(|k| f32::from_bits(bytes::get32(arena, at + k)));
        let corners = [0, 1, 2].map(|i| [c[i], c[3 + i], c[6 + i]]);
        let alone = Geometry::from_mesh(&corners, &[[0, 1, 2]]);
        let scene = Scene::build(&[alone], &Options::default()).expect("a triangle");
        (corners, scene)
    };
    (0..bytes::count(arena, bytes::TRIANGLES)).map(of).collect()
}

struct Reference<'a> {
    arena: &'a [u8],
    grids: &'a [Grid],
    triangles: &'a [([[f32; 3]; 3], Scene)],
    ray: &'a Ray,
    /// In the coordinates of the grids.
    org: [f64; 3],
    dir: [f64; 3],
    /// Whether the first hit ends the walk.
    any: bool,
    limit: f32,
    levels: [Calls; 16],
    /// The ray passes so close to an edge of a voxel, or ends so close to a face, that the
    /// library may see it on the other side.
    close: bool,
}

/// Of a voxel; the walk may be off by 2^-10.
const CLOSE: f64 = 1.0 / 256.0;

impl Reference<'_> {
    /// Walks a grid from `t0` to `t1`; whether the walk is over.
    fn grid(&mut self, number: usize, t0: f64, t1: f64) -> bool {
        let grid = &self.grids[number];
        self.levels[grid.level].grids += 1;
        let tolerance =
            (0..3).map(|k| CLOSE * grid.cell[k] / self.dir[k].abs()).fold(f64::INFINITY, f64::min);
        let mut met = Vec::new();
        for voxel in 0..grid.n.iter().product::<usize>() {
            let at =
                [voxel % grid.n[0], voxel / grid.n[0] % grid.n[1], voxel / grid.n[0] / grid.n[1]];
            let (mut low, mut high) = (t0, t1);
            for (k, i) in at.into_iter().enumerate() {
                let plane = |i: usize| grid.lo[k] + grid.cell[k] * i as f64;
                let ends = [i, i + 1].map(|i| (plane(i) - self.org[k]) / self.dir[k]);
                low = low.max(ends[0].min(ends[1]));
                high = high.min(ends[0].max(ends[1]));
            }
            self.close |= (high - low).abs() < tolerance;
            if low < high {
                met.push((low, high, grid.first + voxel));
            }
        }
        met.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (low, high, voxel) in met {
            let limit = f64::from(self.limit);
            self.close |= (low - limit).abs() < tolerance || (high - limit).abs() < tolerance;
            if low > limit {
                return false;
            }
            self.levels[grid.level].voxels += 1;
            let (triangles, grids) = refs(self.arena, voxel);
            // Walks that count look at four at a time.
            for four in triangles.chunks(4) {
                self.levels[grid.level].tests += four.len() as u64;
                four.iter().for_each(|&i| self.look(grid.level, i));
                for &i in four {
                    if self.meets(grid.level, i) && self.any {
                        return true;
                    }
                }
            }
            for child in grids {
                if self.grid(child, low, high.min(f64::from(self.limit))) {
                    return true;
                }
            }
        }
        false
    }

    fn look(&mut self, level: usize, number: usize) {
        let (first, second) = early(self.ray, &self.triangles[number].0);
        self.levels[level].passed_1 += u64::from(first);
        self.levels[level].passed_2 += u64::from(second);
    }

    fn meets(&mut self, level: usize, number: usize) -> bool {
        let hit: Hit = self.triangles[number].1.view().intersect_brute(self.ray);
        let met = hit.is_hit() && hit.t <= self.limit;
        self.levels[level].hits += u64::from(met);
        if met && !self.any {
            self.limit = hit.t;
        }
        met
    }
}

/// The paper's test_1, not parallel, and test_2: where the line meets the plane, in the box of the triangle's
/// projection along the normal's largest component.
fn early(ray: &Ray, corners: &[[f32; 3]; 3]) -> (bool, bool) {
    let [a, b, c] = corners.map(|p| p.map(f64::from));
    let (o, d) = (ray.org.map(f64::from), ray.dir.map(f64::from));
    let (e, f) = ([0, 1, 2].map(|k| b[k] - a[k]), [0, 1, 2].map(|k| c[k] - a[k]));
    let n = [0, 1, 2].map(|k| e[(k + 1) % 3] * f[(k + 2) % 3] - e[(k + 2) % 3] * f[(k + 1) % 3]);
    let across: f64 = (0..3).map(|k| d[k] * n[k]).sum();
    if across == 0.0 {
        return (false, false);
    }
    let t = (0..3).map(|k| (a[k] - o[k]) * n[k]).sum::<f64>() / across;
    let longest = (0..3).fold(0, |best, k| if n[k].abs() > n[best].abs() { k } else { best });
    let inside = |k: usize| {
        let p = o[k] + t * d[k];
        (a[k].min(b[k]).min(c[k])..=a[k].max(b[k]).max(c[k])).contains(&p)
    };
    (true, (0..3).filter(|&k| k != longest).all(inside))
}

/// Rays from around the mesh's box into it, and from inside.
fn rays(mesh: &Mesh, n: usize) -> Vec<Ray> {
    let bounds = mesh.bounds().expect("it has vertices");
    let mut random = Random::stream(0x400);
    let mut point = |grow: f64| {
        [0, 1, 2].map(|k| {
            let (lo, hi) = (f64::from(bounds.lo[k]), f64::from(bounds.hi[k]));
            random.range(lo - grow * (hi - lo), hi + grow * (hi - lo))
        })
    };
    let shoot = |i: usize| {
        let (from, to) = (point(if i.is_multiple_of(3) { 0.0 } else { 1.0 }), point(0.0));
        Ray::new(from.map(|x| x as f32), [0, 1, 2].map(|k| (to[k] - from[k]) as f32))
    };
    (0..n).map(shoot).collect()
}

#[test]
fn every_statistic_of_every_level() {
    let mut hits = 0;
    for mesh in [soups::clustered(300), soups::tangle(5, 120)] {
        for structure in [Structure::Uniform, Structure::Recursive, Structure::Hug] {
            let base = Options { structure, exit_boxes: false, ..Options::default() };
            let options = Options { maxp: 6, min_cluster: 2, ..base };
            let scene = build(&mesh, &options);
            let (view, arena) = (scene.view(), scene.view().bytes());
            let (grids, triangles) = (grids(arena), triangles(arena));
            let unit = f64::from_bits(bytes::get64(arena, bytes::UNIT));
            let mut clear = 0;
            let rays = rays(&mesh, 240);
            for (ray, any) in rays.iter().flat_map(|ray| [(ray, false), (ray, true)]) {
                let mut reference = Reference {
                    arena,
                    grids: &grids,
                    triangles: &triangles,
                    ray,
                    org: ray.org.map(|x| f64::from(x) * unit),
                    dir: ray.dir.map(|x| f64::from(x) * unit),
                    any,
                    limit: ray.tmax,
                    levels: [Calls::default(); 16],
                    close: false,
                };
                reference.grid(0, f64::from(ray.tmin), f64::from(ray.tmax));
                if reference.close {
                    continue;
                }
                clear += 1;
                let mut profile = Profile::default();
                if any {
                    view.occluded_profiled(ray, &mut profile);
                } else {
                    view.intersect_profiled(ray, &mut profile);
                }
                let what = format!("{structure:?}, occlusion {any}: {ray:?}");
                assert_eq!(profile.levels(), &reference.levels, "{what}");
                hits += profile.total().hits;
            }
            assert!(clear > 240, "{structure:?}: only {clear} rays are clear of all edges");
        }
    }
    assert!(hits > 200, "{hits} hits");
}
