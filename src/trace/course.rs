//! A ray made ready for every grid.
//!
//! Grids are in coordinates times the header's `unit`, and the walk's parameter is
//! tau = t `per_t`; both are powers of two, so nothing is rounded. `per_t` is 1
//! unless the direction is so long or short that `f32` could not hold the speeds.
//!
//! A component of the direction under 2^-90 is taken for 2^-90: over all the grid's
//! box, and from any origin that the walk starts from directly, that moves the ray by
//! less than 2^-12 of the walk's error. So no axis is special, and nothing is divided
//! by zero.

use crate::arena::layout::EXIT_BITS;
use crate::ray::Ray;
use crate::simd::Lanes;

/// Components of a direction that are used as they are.
const USUAL: core::ops::Range<f64> = 1.0 / (1u64 << 40) as f64..(1u64 << 40) as f64;
/// 2^-90, the least component.
const LEAST: f64 = 1.0 / (1u128 << 90) as f64;
/// The same in lanes; the idle one stays where it is.
const LEASTS: [f64; 4] = [LEAST, LEAST, LEAST, 0.0];

/// A ray in lanes x, y, z and an idle one.
#[derive(Clone, Copy)]
pub(super) struct Course<L: Lanes> {
    /// Origin.
    pub org: L::F64,
    /// Direction, a change of place per tau; 0 in the idle lane.
    pub dir: L::F64,
    /// `1 / dir`; infinite in the idle lane, whose planes are never reached.
    pub inv: L::F64,
    /// `|dir|` and `|1 / dir|`.
    pub speed: L::F32,
    pub pace: L::F32,
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
    /// `org` and `dir` are those of `ray`, with 0 in the idle lane.
    #[inline(always)]
    pub fn new(l: L, org: L::F32, dir: L::F32, ray: &Ray, unit: f64) -> Self {
        let scale = l.splat_f64(unit);
        let mut per_t = 1.0;
        let mut d = l.mul_f64(l.widen(dir), scale);
        let longest = l.highest3(l.abs_f64(d));
        if !USUAL.contains(&longest) {
            (d, per_t) = Self::unusual(l, ray, unit, longest);
        }
        let descends = l.signs(dir) as usize;
        let size = l.max_f64(l.abs_f64(d), l.load_f64(&LEASTS));
        let dir = l.sign_f64(size, d);
        let inv = l.div_f64(l.splat_f64(1.0), dir);
        Self {
            org: l.mul_f64(l.widen(org), scale),
            dir,
            inv,
            speed: l.narrow(size),
            pace: l.abs_f32(l.narrow(inv)),
            per_t,
            down: l.load_i32(&DOWN[descends]),
            shift: l.load_i32(&SHIFTS[descends]),
        }
    }

    #[cold]
    #[inline(never)]
    fn unusual(l: L, ray: &Ray, unit: f64, longest: f64) -> (L::F64, f64) {
        // The power of two not above `longest`, which is normal: f32 times unit.
        let per_t = f64::from_bits(longest.to_bits() & (0x7ff << 52));
        let d = ray.dir.map(|d| f64::from(d) * unit / per_t);
        (l.load_f64(&[d[0], d[1], d[2], 0.0]), per_t)
    }
}
