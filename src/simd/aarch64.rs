//! Lanes on AArch64: NEON, four `f64` in two registers. Wide rows are of four:
//! lists hold few triangles, and a second register would compute for none.
//!
//! # Safety
//! The intrinsics need NEON, without which this module is not compiled; loads go
//! through references.

use core::arch::aarch64::*;

use super::lanes::{Kernel, Lanes};

/// Always there.
#[derive(Clone, Copy)]
pub struct Neon;

/// Lanes 0 and 1, lanes 2 and 3.
#[derive(Clone, Copy)]
pub struct F64(float64x2_t, float64x2_t);

/// Wraps intrinsics; see the module on why they are there.
macro_rules! with {
    ($e:expr) => {
        // SAFETY: the target has NEON.
        unsafe { $e }
    };
}

/// An operation on both halves of `f64`.
macro_rules! halves {
    ($f:ident, $($a:expr),+) => {
        F64(with!($f($($a.0),+)), with!($f($($a.1),+)))
    };
}

/// One bit for each lane of a comparison that is also in `lanes`.
#[inline(always)]
fn bits(compared: uint32x4_t, lanes: u32) -> u32 {
    const BITS: [u32; 4] = [1, 2, 4, 8];
    with!(vaddvq_u32(vandq_u32(compared, vld1q_u32(BITS.as_ptr())))) & lanes
}

/// Whether a comparison holds in one of the first three lanes.
#[inline(always)]
fn any3(low: uint64x2_t, high: uint64x2_t) -> bool {
    with!({
        let all = vorrq_u64(low, vdupq_laneq_u64::<0>(high));
        vget_lane_u64::<0>(vreinterpret_u64_u32(vmovn_u64(all))) != 0
    })
}

impl Lanes for Neon {
    type F64 = F64;
    type F32 = float32x4_t;
    type I32 = int32x4_t;
    type Wide = float32x4_t;
    const WIDE: usize = 4;

    #[inline(always)]
    fn run<K: Kernel<Self>>(self, kernel: K) -> K::Out {
        kernel.run(self)
    }

    #[inline(always)]
    fn load_f64(self, a: &[f64; 4]) -> F64 {
        let [low, high] = [&a[..2], &a[2..]];
        F64(with!(vld1q_f64(low.as_ptr())), with!(vld1q_f64(high.as_ptr())))
    }
    #[inline(always)]
    fn splat_f64(self, a: f64) -> F64 {
        let both = with!(vdupq_n_f64(a));
        F64(both, both)
    }
    #[inline(always)]
    fn widen(self, a: float32x4_t) -> F64 {
        F64(with!(vcvt_f64_f32(vget_low_f32(a))), with!(vcvt_high_f64_f32(a)))
    }
    #[inline(always)]
    fn i32_to_f64(self, a: int32x4_t) -> F64 {
        let (low, high) = with!((vmovl_s32(vget_low_s32(a)), vmovl_high_s32(a)));
        F64(with!(vcvtq_f64_s64(low)), with!(vcvtq_f64_s64(high)))
    }
    #[inline(always)]
    fn mul_f64(self, a: F64, b: F64) -> F64 {
        halves!(vmulq_f64, a, b)
    }
    #[inline(always)]
    fn add_f64(self, a: F64, b: F64) -> F64 {
        halves!(vaddq_f64, a, b)
    }
    #[inline(always)]
    fn sub_f64(self, a: F64, b: F64) -> F64 {
        halves!(vsubq_f64, a, b)
    }
    #[inline(always)]
    fn div_f64(self, a: F64, b: F64) -> F64 {
        halves!(vdivq_f64, a, b)
    }
    #[inline(always)]
    fn min_f64(self, a: F64, b: F64) -> F64 {
        halves!(vminq_f64, a, b)
    }
    #[inline(always)]
    fn max_f64(self, a: F64, b: F64) -> F64 {
        halves!(vmaxq_f64, a, b)
    }
    #[inline(always)]
    fn abs_f64(self, a: F64) -> F64 {
        halves!(vabsq_f64, a)
    }
    #[inline(always)]
    fn sign_f64(self, a: F64, b: F64) -> F64 {
        let sign = with!(vdupq_n_u64(1 << 63));
        F64(with!(vbslq_f64(sign, b.0, a.0)), with!(vbslq_f64(sign, b.1, a.1)))
    }
    #[inline(always)]
    fn mirror_f64(self, a: F64, b: F64, sign: F64) -> F64 {
        let negative = |x| with!(vcltzq_s64(vreinterpretq_s64_f64(x)));
        let other = self.sub_f64(b, a);
        F64(
            with!(vbslq_f64(negative(sign.0), other.0, a.0)),
            with!(vbslq_f64(negative(sign.1), other.1, a.1)),
        )
    }
    #[inline(always)]
    fn any_beyond(self, a: F64, b: f64) -> bool {
        let b = self.splat_f64(b);
        any3(with!(vcagtq_f64(a.0, b.0)), with!(vcagtq_f64(a.1, b.1)))
    }
    #[inline(always)]
    fn any_outside(self, a: F64, n: F64) -> bool {
        let outside = |a, n| with!(vorrq_u64(vcltzq_f64(a), vcgtq_f64(a, n)));
        any3(outside(a.0, n.0), outside(a.1, n.1))
    }
    #[inline(always)]
    fn highest3(self, a: F64) -> f64 {
        with!(vmaxvq_f64(vmaxq_f64(a.0, vdupq_laneq_f64::<0>(a.1))))
    }
    #[inline(always)]
    fn lowest3(self, a: F64) -> f64 {
        with!(vminvq_f64(vminq_f64(a.0, vdupq_laneq_f64::<0>(a.1))))
    }

    #[inline(always)]
    fn load_f32(self, a: &[f32; 4]) -> float32x4_t {
        with!(vld1q_f32(a.as_ptr()))
    }
    #[inline(always)]
    fn load3(self, a: &[f32; 4]) -> float32x4_t {
        with!(vsetq_lane_f32::<3>(0.0, vld1q_f32(a.as_ptr())))
    }
    #[inline(always)]
    fn splat_f32(self, a: f32) -> float32x4_t {
        with!(vdupq_n_f32(a))
    }
    #[inline(always)]
    fn narrow(self, a: F64) -> float32x4_t {
        with!(vcvt_high_f32_f64(vcvt_f32_f64(a.0), a.1))
    }
    #[inline(always)]
    fn to_f32(self, a: int32x4_t) -> float32x4_t {
        with!(vcvtq_f32_s32(a))
    }
    #[inline(always)]
    fn mul_f32(self, a: float32x4_t, b: float32x4_t) -> float32x4_t {
        with!(vmulq_f32(a, b))
    }
    #[inline(always)]
    fn add_f32(self, a: float32x4_t, b: float32x4_t) -> float32x4_t {
        with!(vaddq_f32(a, b))
    }
    #[inline(always)]
    fn sub_f32(self, a: float32x4_t, b: float32x4_t) -> float32x4_t {
        with!(vsubq_f32(a, b))
    }
    #[inline(always)]
    fn div_f32(self, a: float32x4_t, b: float32x4_t) -> float32x4_t {
        with!(vdivq_f32(a, b))
    }
    #[inline(always)]
    fn mul_add<const EXACT: bool>(
        self,
        a: float32x4_t,
        b: float32x4_t,
        c: float32x4_t,
    ) -> float32x4_t {
        with!(vfmaq_f32(c, a, b))
    }
    #[inline(always)]
    fn minus_f32(self, a: float32x4_t) -> float32x4_t {
        with!(vnegq_f32(a))
    }
    #[inline(always)]
    fn max_f32(self, a: float32x4_t, b: float32x4_t) -> float32x4_t {
        with!(vmaxq_f32(a, b))
    }
    #[inline(always)]
    fn highest(self, a: float32x4_t) -> float32x4_t {
        with!(vdupq_n_f32(vmaxvq_f32(vcopyq_laneq_f32::<3, 2>(a, a))))
    }
    #[inline(always)]
    fn abs_f32(self, a: float32x4_t) -> float32x4_t {
        with!(vabsq_f32(a))
    }
    #[inline(always)]
    fn lowest(self, a: float32x4_t) -> float32x4_t {
        // As integers, which takes less time.
        with!({
            let a = vreinterpretq_s32_f32(a);
            vreinterpretq_f32_s32(vdupq_n_s32(vminvq_s32(vcopyq_laneq_s32::<3, 2>(a, a))))
        })
    }
    #[inline(always)]
    fn first(self, a: float32x4_t) -> f32 {
        with!(vgetq_lane_f32::<0>(a))
    }
    #[inline(always)]
    fn truncate(self, a: float32x4_t) -> int32x4_t {
        with!(vcvtq_s32_f32(a))
    }
    #[inline(always)]
    fn equal(self, a: float32x4_t, b: float32x4_t) -> int32x4_t {
        with!(vreinterpretq_s32_u32(vceqq_f32(a, b)))
    }
    #[inline(always)]
    fn permute(self, a: float32x4_t, order: &[i32; 4]) -> float32x4_t {
        with!({
            // Lane k is bytes 4 k to 4 k + 3.
            let first = vmulq_n_u32(vld1q_u32(order.as_ptr().cast()), 0x0404_0404);
            let bytes = vaddq_u32(first, vdupq_n_u32(0x0302_0100));
            let a = vqtbl1q_u8(vreinterpretq_u8_f32(a), vreinterpretq_u8_u32(bytes));
            vreinterpretq_f32_u8(a)
        })
    }
    #[inline(always)]
    fn spread<const K: i32>(self, a: float32x4_t) -> float32x4_t {
        with!(vdupq_laneq_f32::<K>(a))
    }
    #[inline(always)]
    fn signs(self, a: float32x4_t) -> u32 {
        bits(with!(vcltzq_s32(vreinterpretq_s32_f32(a))), 7)
    }
    #[inline(always)]
    fn equals(self, a: float32x4_t, b: float32x4_t) -> u32 {
        bits(with!(vceqq_f32(a, b)), 7)
    }

    #[inline(always)]
    fn load_i32(self, a: &[i32; 4]) -> int32x4_t {
        with!(vld1q_s32(a.as_ptr()))
    }
    #[inline(always)]
    fn splat_i32(self, a: i32) -> int32x4_t {
        with!(vdupq_n_s32(a))
    }
    #[inline(always)]
    fn load_u16(self, a: &[u16; 4]) -> int32x4_t {
        with!(vreinterpretq_s32_u32(vmovl_u16(vld1_u16(a.as_ptr()))))
    }
    #[inline(always)]
    fn array(self, a: int32x4_t) -> [i32; 4] {
        with!([
            vgetq_lane_s32::<0>(a),
            vgetq_lane_s32::<1>(a),
            vgetq_lane_s32::<2>(a),
            vgetq_lane_s32::<3>(a),
        ])
    }
    #[inline(always)]
    fn add(self, a: int32x4_t, b: int32x4_t) -> int32x4_t {
        with!(vaddq_s32(a, b))
    }
    #[inline(always)]
    fn sub(self, a: int32x4_t, b: int32x4_t) -> int32x4_t {
        with!(vsubq_s32(a, b))
    }
    #[inline(always)]
    fn and(self, a: int32x4_t, b: int32x4_t) -> int32x4_t {
        with!(vandq_s32(a, b))
    }
    #[inline(always)]
    fn xor(self, a: int32x4_t, b: int32x4_t) -> int32x4_t {
        with!(veorq_s32(a, b))
    }
    #[inline(always)]
    fn min(self, a: int32x4_t, b: int32x4_t) -> int32x4_t {
        with!(vminq_s32(a, b))
    }
    #[inline(always)]
    fn max(self, a: int32x4_t, b: int32x4_t) -> int32x4_t {
        with!(vmaxq_s32(a, b))
    }
    #[inline(always)]
    fn select(self, mask: int32x4_t, a: int32x4_t, b: int32x4_t) -> int32x4_t {
        with!(vbslq_s32(vreinterpretq_u32_s32(mask), b, a))
    }
    #[inline(always)]
    fn shift_right(self, a: int32x4_t, by: int32x4_t) -> int32x4_t {
        with!({
            // To the left by less than nothing.
            let by = vnegq_s32(vandq_s32(by, vdupq_n_s32(31)));
            vreinterpretq_s32_u32(vshlq_u32(vreinterpretq_u32_s32(a), by))
        })
    }
    #[inline(always)]
    fn any_greater(self, a: int32x4_t, b: int32x4_t) -> bool {
        with!({
            let greater = vmovn_u32(vcgtq_s32(a, b));
            vget_lane_u64::<0>(vreinterpret_u64_u16(greater)) << 16 != 0
        })
    }

    #[inline(always)]
    fn thrice(self, numbers: &[u32]) -> [u32; 8] {
        let mut thrice = [0; 8];
        for (to, number) in thrice[..4].iter_mut().zip(numbers) {
            *to = number * 3;
        }
        thrice
    }
    #[inline(always)]
    fn columns<'a>(self, row: impl Fn(usize) -> &'a [f32; 4]) -> [float32x4_t; 3] {
        let (r0, r1) = (self.load_f32(row(0)), self.load_f32(row(1)));
        let (r2, r3) = (self.load_f32(row(2)), self.load_f32(row(3)));
        with!({
            let (low02, low13) = (vzip1q_f32(r0, r2), vzip1q_f32(r1, r3));
            let (high02, high13) = (vzip2q_f32(r0, r2), vzip2q_f32(r1, r3));
            [vzip1q_f32(low02, low13), vzip2q_f32(low02, low13), vzip1q_f32(high02, high13)]
        })
    }
    #[inline(always)]
    fn splat_wide(self, a: f32) -> float32x4_t {
        with!(vdupq_n_f32(a))
    }
    #[inline(always)]
    fn sub_wide(self, a: float32x4_t, b: float32x4_t) -> float32x4_t {
        with!(vsubq_f32(a, b))
    }
    #[inline(always)]
    fn mul_wide(self, a: float32x4_t, b: float32x4_t) -> float32x4_t {
        with!(vmulq_f32(a, b))
    }
    #[inline(always)]
    fn add_wide(self, a: float32x4_t, b: float32x4_t) -> float32x4_t {
        with!(vaddq_f32(a, b))
    }
    #[inline(always)]
    fn min_wide(self, a: float32x4_t, b: float32x4_t) -> float32x4_t {
        with!(vminq_f32(a, b))
    }
    #[inline(always)]
    fn max_wide(self, a: float32x4_t, b: float32x4_t) -> float32x4_t {
        with!(vmaxq_f32(a, b))
    }
    #[inline(always)]
    fn abs_wide(self, a: float32x4_t) -> float32x4_t {
        with!(vabsq_f32(a))
    }
    #[inline(always)]
    fn less_product(self, a: float32x4_t, b: float32x4_t, c: float32x4_t) -> float32x4_t {
        with!(vfmsq_f32(a, b, c))
    }
    #[inline(always)]
    fn cross_wide(
        self,
        a: float32x4_t,
        b: float32x4_t,
        c: float32x4_t,
        d: float32x4_t,
    ) -> float32x4_t {
        with!(vfmsq_f32(vmulq_f32(a, b), c, d))
    }
    #[inline(always)]
    fn misses(
        self,
        [a, b]: [float32x4_t; 2],
        c: float32x4_t,
        [d, e]: [float32x4_t; 2],
        [f, g]: [float32x4_t; 2],
    ) -> u32 {
        let out = with!({
            let beside = vandq_u32(vcgtq_f32(a, b), vcgtq_f32(c, b));
            vorrq_u32(beside, vorrq_u32(vcltq_f32(d, e), vcgtq_f32(f, g)))
        });
        bits(out, 15)
    }
}
