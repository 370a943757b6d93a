//! The pyramid of a packet, or of a part of it, in a grid.

use super::bounds::Bounds;
use super::{Packet, Part};
use crate::arena::layout::{EXIT_BITS, EXIT_MAX, Grid};
use crate::simd::Lanes;
use crate::trace::query::Query;

/// In voxels: how far from a grid the rays may come from.
const REACH: f64 = (1u64 << 36) as f64;

/// More than errors of places, in voxels.
const ROOM: f64 = 1.0 / 4096.0;

/// Voxels of a grid, or places in it, from the lower on both axes to the upper.
#[derive(Clone, Copy)]
pub(super) struct Rect<T> {
    pub x: [T; 2],
    pub y: [T; 2],
}

impl Rect<i32> {
    pub fn count(&self) -> i32 {
        (self.x[1] - self.x[0] + 1) * (self.y[1] - self.y[0] + 1)
    }

    fn is_in(&self, other: &Self) -> bool {
        other.x[0] <= self.x[0]
            && self.x[1] <= other.x[1]
            && other.y[0] <= self.y[0]
            && self.y[1] <= other.y[1]
    }
}

/// The edges of the pyramid in voxels of a grid, whose z is turned the way rays go; and
/// where it enters and leaves the grid.
pub(super) struct Lines {
    /// The origin.
    pub at: [f64; 3],
    /// The least and the greatest change of x, and of y, with the distance.
    pub slopes: Rect<f64>,
    /// The rays in the pyramid, and their slopes in the units of the scene.
    pub bounds: Bounds,
    /// Voxels in a unit of distance.
    pub scale: f64,
    /// Counts along x, y and z.
    pub n: [i32; 3],
    /// How far numbers of voxels are apart along x, y and z, turned likewise, and the
    /// number of the first of these.
    strides: [u32; 3],
    first: u32,
    /// The distances, in voxels, at which the pyramid can be in the grid.
    pub range: [f64; 2],
}

/// The exit box of a voxel, in voxels along x and y, and how many slabs it goes on.
pub(super) struct Exit {
    rect: Rect<i32>,
    ahead: i32,
}

#[inline(always)]
fn min(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

#[inline(always)]
fn max(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// The part of `range` where `a + b d` is not less than 0.
#[inline(always)]
fn clip([mut low, mut high]: [f64; 2], a: f64, b: f64) -> [f64; 2] {
    let zero = -a / b;
    if b > 0.0 {
        low = max(low, zero);
    } else if b < 0.0 {
        high = min(high, zero);
    } else if a < 0.0 {
        high = f64::NEG_INFINITY;
    }
    [low, high]
}

impl Lines {
    /// `None`: the rays come from too far away.
    #[inline(always)]
    pub fn new<Q: Query, L: Lanes>(
        packet: &Packet<'_, '_, Q, L>,
        grid: &Grid,
        part: Part,
        from: f64,
    ) -> Option<Self> {
        let &Packet { axes, down, place, unit, .. } = packet;
        let along = |k: usize| f64::from(grid.inv_cell[axes[k]]);
        let inv = [along(0), along(1), along(2)];
        let count = |k: usize| i32::from(grid.n[axes[k]]);
        let n = [count(0), count(1), count(2)];
        let org = |k: usize| (place[k] - grid.lo[axes[k]]) * inv[k];
        let mut at = [org(0), org(1), org(2)];
        if at.iter().any(|x| x.abs() > REACH) {
            return None;
        }
        let plane = u32::from(grid.n[0]) * u32::from(grid.n[1]);
        let stride = |k: usize| [1, u32::from(grid.n[0]), plane][axes[k]];
        let mut strides = [stride(0), stride(1), stride(2)];
        let mut first = grid.first;
        if down {
            at[2] = f64::from(n[2]) - at[2];
            first = first.wrapping_add((n[2] as u32 - 1).wrapping_mul(strides[2]));
            strides[2] = strides[2].wrapping_neg();
        }
        let scale = unit * inv[2];
        let bounds = packet.bounds(part, from);
        // Slopes are rounded.
        let room = |s: f32| f64::from(s.abs()) * f64::from(f32::EPSILON) + 1e-40;
        let wider = |[a, b]: [f32; 2]| [f64::from(a) - room(a), f64::from(b) + room(b)];
        let [x, y] = [wider(bounds.slopes[0]), wider(bounds.slopes[1])];
        let widths = [inv[0] / inv[2], inv[1] / inv[2]];
        let slopes = Rect { x: x.map(|s| s * widths[0]), y: y.map(|s| s * widths[1]) };
        let end = f64::from(n[2]) - at[2];
        let mut range = [max(from * scale, -at[2]), end];
        for (k, slopes) in [slopes.x, slopes.y].into_iter().enumerate() {
            let room = ROOM * (1.0 + slopes[0].abs() + slopes[1].abs());
            range = clip(range, at[k] + room, slopes[1]);
            range = clip(range, f64::from(n[k]) - at[k] + room, -slopes[0]);
        }
        Some(Self { at, slopes, bounds, scale, n, strides, first, range })
    }

    /// The first slab in which the pyramid is in the grid, if `range` is not empty.
    #[inline(always)]
    pub fn first_slab(&self) -> i32 {
        let z = self.range[0] + self.at[2] - ROOM;
        (max(z, 0.0) as i32).min(self.n[2] - 1)
    }

    /// Where the pyramid lies between two distances.
    #[inline(always)]
    fn places(&self, [near, far]: [f64; 2]) -> Rect<f64> {
        let Self { at, slopes: Rect { x, y }, .. } = self;
        let low = |s: f64| min(s * near, s * far);
        let high = |s: f64| max(s * near, s * far);
        Rect {
            x: [at[0] + low(x[0]), at[0] + high(x[1])],
            y: [at[1] + low(y[0]), at[1] + high(y[1])],
        }
    }

    /// The voxels where the pyramid lies between two distances, if there are any.
    #[inline(always)]
    pub fn voxels(&self, range: [f64; 2]) -> Option<Rect<i32>> {
        let Rect { x, y } = self.places(range);
        let axis = |[low, high]: [f64; 2], n: i32| {
            let low = max(low, 0.0) as i32;
            let inside = high >= 0.0 && low < n;
            inside.then(|| [low, (high as i32).min(n - 1)])
        };
        Some(Rect { x: axis(x, self.n[0])?, y: axis(y, self.n[1])? })
    }

    /// The number of a voxel, along x, y and z.
    #[inline(always)]
    pub fn number(&self, [x, y, z]: [i32; 3]) -> u32 {
        let [a, b, c] = self.strides;
        let rows = (z as u32).wrapping_mul(c).wrapping_add((y as u32).wrapping_mul(b));
        rows.wrapping_add((x as u32).wrapping_mul(a)).wrapping_add(self.first)
    }
}

impl Exit {
    /// That of the voxel at x and y.
    #[inline(always)]
    pub fn new(axes: [usize; 3], down: bool, [x, y]: [i32; 2], exit: u32) -> Self {
        let reach = |k: usize, upper: bool| {
            (exit >> (EXIT_BITS * (2 * axes[k] as u32 + u32::from(upper))) & EXIT_MAX) as i32
        };
        let side = |k: usize, at: i32| [at - reach(k, false), at + reach(k, true)];
        Self { rect: Rect { x: side(0, x), y: side(1, y) }, ahead: reach(2, !down) }
    }

    /// In how many slabs from a distance on, the first of them up to `until`, the pyramid
    /// stays in the box.
    #[inline(always)]
    pub fn slabs(&self, lines: &Lines, [from, until]: [f64; 2], here: &Rect<i32>) -> i32 {
        if !here.is_in(&self.rect) {
            return 0;
        }
        let mut ahead = self.ahead;
        while ahead > 0 {
            let all = lines.voxels([from, until + f64::from(ahead)]);
            if all.is_none_or(|all| all.is_in(&self.rect)) {
                break;
            }
            ahead /= 2;
        }
        ahead + 1
    }
}
