//! Rays that are hard to get right, aimed at a soup.

use super::Ray;
use crate::arbiter;
use crate::random::Random;
use crate::{Bounds, Mesh};

/// What makes a ray hard.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aim {
    /// Along one axis, through a triangle; the other components are 0 or -0.
    Axis,
    /// In the plane of a voxel face.
    VoxelFace,
    /// Along a voxel edge.
    VoxelEdge,
    /// At a vertex.
    Vertex,
    /// At the middle of an edge.
    EdgeMidpoint,
    /// From a point in the box, anywhere.
    Inside,
    /// At a triangle from up to 1e20 times the size of the box away.
    Far,
    /// With one or two components that are -0.
    NegativeZero,
    /// With tmin = tmax = the t of a hit.
    Instant,
    /// With a component so small that it is denormal.
    Denormal,
}

impl Aim {
    /// All of them.
    pub const ALL: [Self; 10] = [
        Self::Axis,
        Self::VoxelFace,
        Self::VoxelEdge,
        Self::Vertex,
        Self::EdgeMidpoint,
        Self::Inside,
        Self::Far,
        Self::NegativeZero,
        Self::Instant,
        Self::Denormal,
    ];
}

/// Coordinates stay below this, so that differences of two are finite.
const HUGE: f64 = 1e38;

/// `n` rays of one kind at `mesh`, whose grid would have `counts` voxels in `bounds`.
pub fn adversarial(
    aim: Aim,
    mesh: &Mesh,
    bounds: &Bounds,
    counts: [u32; 3],
    seed: u64,
    n: usize,
) -> Vec<Ray> {
    let mut shooter = Shooter {
        mesh,
        bounds,
        counts,
        random: Random::stream(((0x100 + aim as u64) << 32) ^ seed),
    };
    (0..n).map(|_| shooter.shoot(aim)).collect()
}

struct Shooter<'a> {
    mesh: &'a Mesh,
    bounds: &'a Bounds,
    counts: [u32; 3],
    random: Random,
}

impl Shooter<'_> {
    fn shoot(&mut self, aim: Aim) -> Ray {
        let axis = self.random.below(3);
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        match aim {
            Aim::Axis => {
                let mut org = self.target();
                let mut dir = [0.0; 3].map(|zero: f64| self.signed(zero));
                dir[axis] = self.signed(1.0);
                org[axis] = self.beyond(axis, dir[axis]);
                ray(org, dir)
            }
            Aim::VoxelFace => {
                let mut org = self.inside();
                let mut dir = self.random.direction();
                org[axis] = self.face(axis);
                dir[axis] = self.signed(0.0);
                ray(org, dir)
            }
            Aim::VoxelEdge => {
                let mut org = self.inside();
                let mut dir = [0.0; 3].map(|zero: f64| self.signed(zero));
                (org[next], org[last]) = (self.face(next), self.face(last));
                dir[axis] = self.signed(1.0);
                org[axis] = self.beyond(axis, dir[axis]);
                ray(org, dir)
            }
            Aim::Vertex => {
                let [target, _, _] = self.corners();
                self.toward(target)
            }
            Aim::EdgeMidpoint => {
                let [a, b, _] = self.corners();
                self.toward([0, 1, 2].map(|k| (a[k] + b[k]) / 2.0))
            }
            Aim::Inside => ray(self.inside(), self.random.direction()),
            Aim::Far => {
                let target = self.target();
                let away = self.random.direction();
                let size = self.bounds.diagonal() * libm::pow(10.0, self.random.range(1.0, 20.0));
                let size = size.min(HUGE);
                ray([0, 1, 2].map(|k| target[k] - away[k] * size), away)
            }
            Aim::NegativeZero => {
                let mut dir = self.random.direction();
                dir[axis] = -0.0;
                if self.random.chance(0.5) {
                    dir[next] = -0.0;
                }
                let (target, size) = (self.target(), self.bounds.diagonal());
                ray([0, 1, 2].map(|k| target[k] - dir[k] * size), dir)
            }
            Aim::Instant => self.instant(),
            Aim::Denormal => {
                let target = self.target();
                let mut shot = self.toward(target);
                shot.dir[axis] = f32::from_bits(1 + self.random.below(1 << 22) as u32);
                if self.random.chance(0.5) {
                    shot.dir[axis] = -shot.dir[axis];
                }
                shot.org[axis] = target[axis] as f32;
                shot
            }
        }
    }

    fn signed(&mut self, magnitude: f64) -> f64 {
        if self.random.chance(0.5) { -magnitude } else { magnitude }
    }

    fn inside(&mut self) -> [f64; 3] {
        let fraction = [(); 3].map(|()| self.random.unit());
        self.bounds.at(fraction)
    }

    /// A plane between voxels, or a side of the box.
    fn face(&mut self, axis: usize) -> f64 {
        let count = self.counts[axis].max(1);
        let index = self.random.below(count as usize + 1);
        let mut fraction = [0.0; 3];
        fraction[axis] = index as f64 / f64::from(count);
        self.bounds.at(fraction)[axis]
    }

    /// A coordinate outside the box that a ray in direction `dir` along this axis comes from.
    fn beyond(&mut self, axis: usize, dir: f64) -> f64 {
        let fraction = if dir > 0.0 { [-0.5; 3] } else { [1.5; 3] };
        self.bounds.at(fraction)[axis]
    }

    /// The corners of some triangle in random order; points of the box if there is none.
    fn corners(&mut self) -> [[f64; 3]; 3] {
        if self.mesh.indices.is_empty() {
            return [(); 3].map(|()| self.inside());
        }
        let pick = self.random.below(self.mesh.indices.len());
        let mut corners = self.mesh.triangle(pick).map(|v| v.map(f64::from));
        corners.rotate_left(self.random.below(3));
        corners
    }

    /// A point inside some triangle.
    fn target(&mut self) -> [f64; 3] {
        let [a, b, c] = self.corners();
        let (mut u, mut v) = (self.random.unit(), self.random.unit());
        if u + v > 1.0 {
            (u, v) = (1.0 - u, 1.0 - v);
        }
        [0, 1, 2].map(|k| a[k] + (b[k] - a[k]) * u + (c[k] - a[k]) * v)
    }

    /// From somewhere in or about the box; the direction reaches the target at t = 1.
    fn toward(&mut self, target: [f64; 3]) -> Ray {
        let fraction = [(); 3].map(|()| self.random.range(-1.0, 2.0));
        let org = self.bounds.at(fraction).map(|c| c as f32);
        ray(org.map(f64::from), [0, 1, 2].map(|k| target[k] - f64::from(org[k])))
    }

    fn instant(&mut self) -> Ray {
        let target = self.target();
        let mut shot = self.toward(target);
        let hits = self.mesh.triangles().enumerate();
        let hits = hits.map(|(prim, tri)| (0, prim as u32, tri));
        let t = arbiter::closest(&shot, hits).map_or(1.0, |found| found.hit.t);
        (shot.tmin, shot.tmax) = (t, t);
        shot
    }
}

fn ray(org: [f64; 3], dir: [f64; 3]) -> Ray {
    let limit = |c: f64| c.clamp(-HUGE, HUGE) as f32;
    Ray::new(org.map(limit), dir.map(limit), 0.0, f32::INFINITY)
}
