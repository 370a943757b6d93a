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

use crate::arena::layout::EXIT_BITS;
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
    /// Where an exit box's word has the reach along the ray.
    pub shift: L::I32,
}

/// [`Course::down`] for the axes along which a ray descends, a bit each.
const DOWN: [[i32; 4]; 8] = {
    let mut down = [[0; 4]; 8];
    let mut descends = 0;
    while descends < 8 {
        let mut k = 0;
        while k < 3 {
            down[descends][k] = -(descends as i32 >> k & 1);
            k += 1;
        }
        descends += 1;
    }
    down
};

/// [`Course::shift`], likewise. What the idle lane finds does not matter.
const SHIFTS: [[i32; 4]; 8] = {
    let mut shifts = [[0; 4]; 8];
    let mut descends = 0;
    while descends < 8 {
        let mut k = 0;
        while k < 3 {
            shifts[descends][k] = EXIT_BITS as i32 * (2 * k as i32 + 1 + DOWN[descends][k]);
            k += 1;
        }
        descends += 1;
    }
    shifts
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
        let descends = l.signs(dir) as usize;
        let size = l.max_f64(l.abs_f64(d), l.load_f64(&LEAST));
        let dir = l.sign_f64(size, d);
        Self {
            unit,
            org: l.mul_f64(l.widen(org), scale),
            dir,
            speed: l.narrow(l.max_f64(size, l.load_f64(&LEAST_SPEED))),
            per_t,
            down: l.load_i32(&DOWN[descends]),
            shift: l.load_i32(&SHIFTS[descends]),
        }
    }

    /// Origin and direction of `ray`, whose course this is, however small.
    pub fn exact(&self, ray: &Ray) -> [[f64; 3]; 2] {
        let scale = |v: [f32; 3], by: f64| v.map(|x| f64::from(x) * self.unit / by);
        [scale(ray.org, 1.0), scale(ray.dir, self.per_t)]
    }
}
