//! A ray made ready for every grid.
//!
//! Grids are in coordinates times the header's `unit`, and the walk's parameter is
//! tau = t `per_t`, such that the largest component of the direction is in [1, 2);
//! both are powers of two, so nothing is rounded and `f32` can hold all speeds.
//!
//! A component of the direction under 2^-300 is taken for 2^-300 where the ray enters
//! a grid, in `f64`, and one under 2^-95 for 2^-95 from there on, in `f32`: across the
//! scene's box, which is less than 4 wide, that moves the ray by less than 2^-13 of the
//! smallest voxel there can be (2^-79, `build::frame`). So no axis is special, and
//! nothing is divided by zero.

use crate::arena::layout::{EXIT_BITS, EXIT_MAX};
use crate::ray::Ray;
use crate::simd::Lanes;

const fn three(x: f64) -> [f64; 4] {
    [x, x, x, 0.0]
}

/// The least component, 2^-300, in lanes; the idle one stays where it is.
const LEAST: [f64; 4] = three(f64::from_bits((1023 - 300) << 52));
/// The least in `f32`, 2^-95, likewise.
const LEAST_SPEED: [f64; 4] = three(f64::from_bits((1023 - 95) << 52));
/// The bits of an `f64`'s exponent.
const EXPONENT: u64 = 0x7ff << 52;

/// A ray in lanes x, y, z and an idle one.
#[derive(Clone, Copy)]
pub(super) struct Course<L: Lanes> {
    unit: f64,
    /// Origin.
    pub org: L::F64,
    /// Direction, a change of place per tau; 0 in the idle lane.
    pub dir: L::F64,
    /// `|dir|`.
    pub speed: L::F32,
    pub per_t: f64,
    /// All ones on axes along which the ray descends, else 0.
    pub down: L::I32,
    pub mirror: &'static Mirror,
}

/// What follows from the axes along which a ray descends.
#[derive(Clone, Copy)]
pub(super) struct Mirror {
    /// All ones on these axes, else 0.
    down: [i32; 4],
    /// Of the words of exit boxes and of boxes, the bounds that the ray comes to first,
    /// and last; what the idle lane finds does not matter.
    pub near: Bounds,
    pub far: Bounds,
}

/// One bound on each axis.
#[derive(Clone, Copy)]
pub(super) struct Bounds {
    /// Where it begins in a word.
    pub shift: [u32; 4],
    /// The bits that it is, for eight words.
    pub mask: [[u32; 8]; 3],
    /// What these bits count, negative where the ray descends.
    pub unit: [f32; 4],
}

impl Bounds {
    const NONE: Self = Self { shift: [0; 4], mask: [[0; 8]; 3], unit: [0.0; 4] };

    const fn set(&mut self, axis: usize, down: bool, upper: bool) {
        let shift = EXIT_BITS * (2 * axis as u32 + upper as u32);
        self.shift[axis] = shift;
        self.mask[axis] = [EXIT_MAX << shift; 8];
        let unit = 1.0 / (1u32 << shift) as f32;
        self.unit[axis] = if down { -unit } else { unit };
    }
}

impl Mirror {
    /// That of a ray that ascends on all axes.
    pub const ASCENDING: &'static Self = &MIRRORS[0];
}

/// One for each set of axes, a bit each.
static MIRRORS: [Mirror; 8] = {
    let mut mirrors = [Mirror { down: [0; 4], near: Bounds::NONE, far: Bounds::NONE }; 8];
    let mut descends = 0;
    while descends < 8 {
        let (mirror, mut k) = (&mut mirrors[descends], 0);
        while k < 3 {
            let down = descends >> k & 1 != 0;
            mirror.down[k] = -(down as i32);
            mirror.near.set(k, down, down);
            mirror.far.set(k, down, !down);
            k += 1;
        }
        descends += 1;
    }
    mirrors
};

impl<L: Lanes> Course<L> {
    /// `org` and `dir` have 0 in the idle lane.
    #[inline(always)]
    pub fn new(l: L, org: L::F32, dir: L::F32, unit: f64) -> Self {
        let scale = l.splat_f64(unit);
        let d = l.mul_f64(l.widen(dir), scale);
        // A power of two, and 1 over it: every f32 times a unit is a normal f64.
        let power = l.highest3(l.abs_f64(d)).to_bits() & EXPONENT;
        let (per_t, inverse) = (f64::from_bits(power), f64::from_bits((0x7fe << 52) - power));
        let d = l.mul_f64(d, l.splat_f64(inverse));
        let mirror = &MIRRORS[l.signs(dir) as usize % MIRRORS.len()];
        let size = l.max_f64(l.abs_f64(d), l.load_f64(&LEAST));
        let dir = l.sign_f64(size, d);
        Self {
            unit,
            org: l.mul_f64(l.widen(org), scale),
            dir,
            speed: l.narrow(l.max_f64(size, l.load_f64(&LEAST_SPEED))),
            per_t,
            down: l.load_i32(&mirror.down),
            mirror,
        }
    }

    /// This course in coordinates in which the ray has direction `dir`; what it says of the
    /// origin means nothing there.
    #[inline(always)]
    pub fn turned(&self, l: L, dir: [f64; 3]) -> Self {
        let [x, y, z] = dir;
        let d = l.load_f64(&[x, y, z, 0.0]);
        let size = l.max_f64(l.abs_f64(d), l.load_f64(&LEAST));
        let sign = |k: usize| usize::from(dir[k].is_sign_negative()) << k;
        let mirror = &MIRRORS[sign(0) | sign(1) | sign(2)];
        Self {
            dir: l.sign_f64(size, d),
            speed: l.narrow(l.max_f64(size, l.load_f64(&LEAST_SPEED))),
            down: l.load_i32(&mirror.down),
            mirror,
            ..*self
        }
    }

    /// Origin and direction of `ray`, whose course this is, however small.
    pub fn exact(&self, ray: &Ray) -> [[f64; 3]; 2] {
        let scale = |v: [f32; 3], by: f64| v.map(|x| f64::from(x) * self.unit / by);
        [scale(ray.org, 1.0), scale(ray.dir, self.per_t)]
    }
}
