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
type F32 = float32x4_t;
type I32 = int32x4_t;
type Wide = float32x4_t;

/// Wraps intrinsics; see the module on why they are there.
macro_rules! with {
    ($e:expr) => {
        // SAFETY: the target has NEON.
        unsafe { $e }
    };
}

/// Operations that are one expression of intrinsics.
macro_rules! operations {
    ($(fn $name:ident($self:ident $(, $a:ident: $t:ty)*) -> $out:ty = $e:expr;)*) => {$(
        #[inline(always)]
        fn $name($self $(, $a: $t)*) -> $out {
            with!($e)
        }
    )*};
}

/// An operation on both halves of `f64`.
macro_rules! halves {
    ($f:ident, $($a:expr),+) => {
        F64($f($($a.0),+), $f($($a.1),+))
    };
}

/// One bit for each of the lanes of a comparison that are in `lanes`.
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

/// All ones where the sign bit is set.
#[inline(always)]
fn negative(a: float64x2_t) -> uint64x2_t {
    with!(vcltzq_s64(vreinterpretq_s64_f64(a)))
}

/// Whether `a < 0` or `a > n`.
#[inline(always)]
fn outside(a: float64x2_t, n: float64x2_t) -> uint64x2_t {
    with!(vorrq_u64(vcltzq_f64(a), vcgtq_f64(a, n)))
}

/// For each mask the lanes that it has, then zeros.
const ORDERS: [[i32; 4]; 16] = {
    let mut orders = [[0; 4]; 16];
    let mut mask = 0;
    while mask < 16 {
        let (mut lane, mut at) = (0, 0);
        while lane < 4 {
            if mask >> lane & 1 != 0 {
                orders[mask][at] = lane;
                at += 1;
            }
            lane += 1;
        }
        mask += 1;
    }
    orders
};

impl Lanes for Neon {
    type F64 = F64;
    type F32 = F32;
    type I32 = I32;
    type Wide = Wide;
    type Words = uint32x4_t;
    const WIDE: usize = 4;

    #[inline(always)]
    fn run<K: Kernel<Self>>(self, kernel: K) -> K::Out {
        kernel.run(self)
    }

    operations! {
        fn load_f64(self, a: &[f64; 4]) -> F64 =
            F64(vld1q_f64(a[..2].as_ptr()), vld1q_f64(a[2..].as_ptr()));
        fn splat_f64(self, a: f64) -> F64 = F64(vdupq_n_f64(a), vdupq_n_f64(a));
        fn widen(self, a: F32) -> F64 = F64(vcvt_f64_f32(vget_low_f32(a)), vcvt_high_f64_f32(a));
        fn i32_to_f64(self, a: I32) -> F64 = F64(
            vcvtq_f64_s64(vmovl_s32(vget_low_s32(a))),
            vcvtq_f64_s64(vmovl_high_s32(a)),
        );
        fn mul_f64(self, a: F64, b: F64) -> F64 = halves!(vmulq_f64, a, b);
        fn add_f64(self, a: F64, b: F64) -> F64 = halves!(vaddq_f64, a, b);
        fn sub_f64(self, a: F64, b: F64) -> F64 = halves!(vsubq_f64, a, b);
        fn div_f64(self, a: F64, b: F64) -> F64 = halves!(vdivq_f64, a, b);
        fn min_f64(self, a: F64, b: F64) -> F64 = halves!(vminq_f64, a, b);
        fn max_f64(self, a: F64, b: F64) -> F64 = halves!(vmaxq_f64, a, b);
        fn abs_f64(self, a: F64) -> F64 = halves!(vabsq_f64, a);
        fn sign_f64(self, a: F64, b: F64) -> F64 = {
            let sign = vdupq_n_u64(1 << 63);
            F64(vbslq_f64(sign, b.0, a.0), vbslq_f64(sign, b.1, a.1))
        };
        fn mirror_f64(self, a: F64, b: F64, sign: F64) -> F64 = {
            let other = self.sub_f64(b, a);
            let (low, high) = (negative(sign.0), negative(sign.1));
            F64(vbslq_f64(low, other.0, a.0), vbslq_f64(high, other.1, a.1))
        };
        fn any_beyond(self, a: F64, b: f64) -> bool =
            any3(vcagtq_f64(a.0, vdupq_n_f64(b)), vcagtq_f64(a.1, vdupq_n_f64(b)));
        fn above_f64(self, a: F64, b: F64) -> u32 = {
            let (low, high) = (vcgtq_f64(a.0, b.0), vcgtq_f64(a.1, b.1));
            bits(vcombine_u32(vmovn_u64(low), vmovn_u64(high)), 15)
        };
        fn mul_add_f64(self, a: F64, b: F64, c: F64) -> F64 = halves!(vfmaq_f64, c, a, b);
        fn next_f64(self, a: F64) -> F64 = F64(vextq_f64::<1>(a.0, a.1), a.0);
        fn with_last(self, a: F64, b: F64) -> F64 = F64(a.0, vcopyq_laneq_f64::<1, 0>(a.1, b.1));
        fn array_f64(self, a: F64) -> [f64; 4] = {
            let mut array = [0.0; 4];
            vst1q_f64(array.as_mut_ptr(), a.0);
            vst1q_f64(array[2..].as_mut_ptr(), a.1);
            array
        };
        fn highest3(self, a: F64) -> f64 = vmaxvq_f64(vmaxq_f64(a.0, vdupq_laneq_f64::<0>(a.1)));
        fn lowest3(self, a: F64) -> f64 = vminvq_f64(vminq_f64(a.0, vdupq_laneq_f64::<0>(a.1)));

        fn load_f32(self, a: &[f32; 4]) -> F32 = vld1q_f32(a.as_ptr());
        fn load3(self, a: &[f32; 4]) -> F32 = vsetq_lane_f32::<3>(0.0, vld1q_f32(a.as_ptr()));
        fn with_third(self, a: F32, b: F32) -> F32 = vcopyq_laneq_f32::<2, 2>(a, b);
        fn splat_f32(self, a: f32) -> F32 = vdupq_n_f32(a);
        fn narrow(self, a: F64) -> F32 = vcvt_high_f32_f64(vcvt_f32_f64(a.0), a.1);
        fn to_f32(self, a: I32) -> F32 = vcvtq_f32_s32(a);
        fn mul_f32(self, a: F32, b: F32) -> F32 = vmulq_f32(a, b);
        fn add_f32(self, a: F32, b: F32) -> F32 = vaddq_f32(a, b);
        fn sub_f32(self, a: F32, b: F32) -> F32 = vsubq_f32(a, b);
        fn div_f32(self, a: F32, b: F32) -> F32 = vdivq_f32(a, b);
        fn mask_f32(self, a: F32, mask: I32) -> F32 =
            vreinterpretq_f32_s32(vandq_s32(vreinterpretq_s32_f32(a), mask));
        fn minus_f32(self, a: F32) -> F32 = vnegq_f32(a);
        fn sign_f32(self, a: F32, b: F32) -> F32 = vbslq_f32(vdupq_n_u32(1 << 31), b, a);
        fn max_f32(self, a: F32, b: F32) -> F32 = vmaxq_f32(a, b);
        fn highest(self, a: F32) -> F32 = vdupq_n_f32(vmaxvq_f32(vcopyq_laneq_f32::<3, 2>(a, a)));
        fn abs_f32(self, a: F32) -> F32 = vabsq_f32(a);
        fn lowest(self, a: F32) -> F32 = {
            // As integers, which takes less time.
            let a = vreinterpretq_s32_f32(a);
            vreinterpretq_f32_s32(vdupq_n_s32(vminvq_s32(vcopyq_laneq_s32::<3, 2>(a, a))))
        };
        fn array_f32(self, a: F32) -> [f32; 4] = {
            let mut array = [0.0; 4];
            vst1q_f32(array.as_mut_ptr(), a);
            array
        };
        fn first(self, a: F32) -> f32 = vgetq_lane_f32::<0>(a);
        fn truncate(self, a: F32) -> I32 = vcvtq_s32_f32(a);
        fn equal(self, a: F32, b: F32) -> I32 = vreinterpretq_s32_u32(vceqq_f32(a, b));
        fn permute(self, a: F32, order: &[i32; 4]) -> F32 = {
            // Lane k is bytes 4 k to 4 k + 3.
            let first = vmulq_n_u32(vld1q_u32(order.as_ptr().cast()), 0x0404_0404);
            let bytes = vreinterpretq_u8_u32(vaddq_u32(first, vdupq_n_u32(0x0302_0100)));
            vreinterpretq_f32_u8(vqtbl1q_u8(vreinterpretq_u8_f32(a), bytes))
        };
        fn signs(self, a: F32) -> u32 = bits(vcltzq_s32(vreinterpretq_s32_f32(a)), 7);
        fn all_below(self, a: F32, b: f32) -> bool =
            bits(vcaltq_f32(a, vdupq_n_f32(b)), 7) == 7;
        fn all_finite(self, a: F32) -> bool =
            vminvq_u32(vcltq_f32(vabsq_f32(a), vdupq_n_f32(f32::INFINITY))) != 0;
        fn same(self, a: F32, b: F32) -> u32 = bits(vceqq_f32(a, b), 15);
        fn equals(self, a: F32, b: F32) -> u32 = bits(vceqq_f32(a, b), 7);

        fn load_i32(self, a: &[i32; 4]) -> I32 = vld1q_s32(a.as_ptr());
        fn load_u32(self, a: &[u32; 4]) -> I32 = vreinterpretq_s32_u32(vld1q_u32(a.as_ptr()));
        fn splat_i32(self, a: i32) -> I32 = vdupq_n_s32(a);
        fn load_u16(self, a: &[u16; 4]) -> I32 =
            vreinterpretq_s32_u32(vmovl_u16(vld1_u16(a.as_ptr())));
        fn array(self, a: I32) -> [i32; 4] = [
            vgetq_lane_s32::<0>(a),
            vgetq_lane_s32::<1>(a),
            vgetq_lane_s32::<2>(a),
            vgetq_lane_s32::<3>(a),
        ];
        fn add(self, a: I32, b: I32) -> I32 = vaddq_s32(a, b);
        fn sub(self, a: I32, b: I32) -> I32 = vsubq_s32(a, b);
        fn and(self, a: I32, b: I32) -> I32 = vandq_s32(a, b);
        fn xor(self, a: I32, b: I32) -> I32 = veorq_s32(a, b);
        fn min(self, a: I32, b: I32) -> I32 = vminq_s32(a, b);
        fn max(self, a: I32, b: I32) -> I32 = vmaxq_s32(a, b);
        fn select(self, mask: I32, a: I32, b: I32) -> I32 =
            vbslq_s32(vreinterpretq_u32_s32(mask), b, a);
        fn shift_right(self, a: I32, by: I32) -> I32 = {
            // To the left by less than nothing.
            let by = vnegq_s32(vandq_s32(by, vdupq_n_s32(31)));
            vreinterpretq_s32_u32(vshlq_u32(vreinterpretq_u32_s32(a), by))
        };
        fn any_greater(self, a: I32, b: I32) -> bool = {
            let greater = vmovn_u32(vcgtq_s32(a, b));
            vget_lane_u64::<0>(vreinterpret_u64_u16(greater)) << 16 != 0
        };

        fn words(self, words: &[u32; 8]) -> uint32x4_t = vld1q_u32(words.as_ptr());
        fn field(self, words: uint32x4_t, mask: &[u32; 8]) -> Wide =
            vcvtq_f32_u32(vandq_u32(words, vld1q_u32(mask.as_ptr())));
        fn tops(self, words: uint32x4_t) -> [u32; 2] = {
            let zero = vdupq_n_s32(0);
            let below = vreinterpretq_s32_u32(vaddq_u32(words, words));
            let top = vcltq_s32(vreinterpretq_s32_u32(words), zero);
            [bits(top, 15), bits(vcltq_s32(below, zero), 15)]
        };
        fn mul_add_wide(self, a: Wide, b: Wide, c: Wide) -> Wide = vfmaq_f32(c, a, b);
        fn at_most(self, a: Wide, b: Wide) -> u32 = bits(vcleq_f32(a, b), 15);
        fn load_wide(self, a: &[f32; 8]) -> Wide = vld1q_f32(a.as_ptr());
        fn store_wide(self, a: Wide, to: &mut [f32; 8]) -> () = vst1q_f32(to.as_mut_ptr(), a);
        fn load_from(self, a: &[f32; 8], at: usize) -> Wide =
            vld1q_f32(a.as_chunks::<4>().0[at / 4 % 2].as_ptr());
        fn bytes_from(self, a: &[u8; 8], at: usize) -> Wide = {
            let words = vmovl_u8(vld1_u8(a.as_ptr()));
            let half = if at == 0 { vget_low_u16(words) } else { vget_high_u16(words) };
            vcvtq_f32_u32(vmovl_u16(half))
        };
        fn store_from(self, a: Wide, to: &mut [f32; 8], at: usize) -> () =
            vst1q_f32(to.as_chunks_mut::<4>().0[at / 4 % 2].as_mut_ptr(), a);
        fn truncate_wide(self, a: Wide) -> Wide = vrndq_f32(a);
        fn choose_wide(self, a: Wide, b: Wide, x: Wide, y: Wide) -> Wide =
            vbslq_f32(vcleq_f32(a, b), x, y);
        fn splat_wide(self, a: f32) -> Wide = vdupq_n_f32(a);
        fn div_wide(self, a: Wide, b: Wide) -> Wide = vdivq_f32(a, b);
        fn sub_wide(self, a: Wide, b: Wide) -> Wide = vsubq_f32(a, b);
        fn mul_wide(self, a: Wide, b: Wide) -> Wide = vmulq_f32(a, b);
        fn add_wide(self, a: Wide, b: Wide) -> Wide = vaddq_f32(a, b);
        fn min_wide(self, a: Wide, b: Wide) -> Wide = vminq_f32(a, b);
        fn max_wide(self, a: Wide, b: Wide) -> Wide = vmaxq_f32(a, b);
        fn abs_wide(self, a: Wide) -> Wide = vabsq_f32(a);
        fn less_product(self, a: Wide, b: Wide, c: Wide) -> Wide = vfmsq_f32(a, b, c);
        fn product_less(self, a: Wide, b: Wide, c: Wide) -> Wide =
            vnegq_f32(vfmsq_f32(c, a, b));
        fn turn_wide(self, a: Wide, b: Wide) -> Wide = {
            let sign = vandq_u32(vreinterpretq_u32_f32(b), vdupq_n_u32(1 << 31));
            vreinterpretq_f32_u32(veorq_u32(vreinterpretq_u32_f32(a), sign))
        };
        fn cross_wide(self, a: Wide, b: Wide, c: Wide, d: Wide) -> Wide =
            vfmsq_f32(vmulq_f32(a, b), c, d);
    }

    #[inline(always)]
    fn any_outside(self, a: F64, n: F64) -> bool {
        any3(outside(a.0, n.0), outside(a.1, n.1))
    }
    #[inline(always)]
    fn mul_add<const EXACT: bool>(self, a: F32, b: F32, c: F32) -> F32 {
        with!(vfmaq_f32(c, a, b))
    }
    #[inline(always)]
    fn compress(self, words: &[u32; 8], mask: u32, to: &mut [u32; 8]) {
        with!({
            let words = vreinterpretq_f32_u32(vld1q_u32(words.as_ptr()));
            let few = self.permute(words, &ORDERS[mask as usize % ORDERS.len()]);
            vst1q_u32(to.as_mut_ptr(), vreinterpretq_u32_f32(few));
        });
    }
    #[inline(always)]
    fn numbers(
        self,
        near: Wide,
        far: Wide,
        stride: &[u32; 8],
        first: &[u32; 8],
        to: &mut [u32; 8],
    ) {
        with!({
            let near = vaddq_u32(vcvtq_u32_f32(near), vld1q_u32(first.as_ptr()));
            let far = vmulq_u32(vcvtq_u32_f32(far), vld1q_u32(stride.as_ptr()));
            vst1q_u32(to.as_mut_ptr(), vaddq_u32(near, far));
        });
    }
    #[inline(always)]
    fn thrice(self, numbers: &[u32]) -> [u32; 8] {
        let mut thrice = [0; 8];
        if let Some(four) = numbers.first_chunk::<4>() {
            with!(vst1q_u32(thrice.as_mut_ptr(), vmulq_n_u32(vld1q_u32(four.as_ptr()), 3)));
            return thrice;
        }
        for (to, number) in thrice[..3].iter_mut().zip(numbers) {
            *to = number * 3;
        }
        thrice
    }
    #[inline(always)]
    fn columns<'a>(self, row: impl Fn(usize) -> &'a [f32; 4]) -> [Wide; 3] {
        let (r0, r1) = (self.load_f32(row(0)), self.load_f32(row(1)));
        let (r2, r3) = (self.load_f32(row(2)), self.load_f32(row(3)));
        with!({
            let (low02, low13) = (vzip1q_f32(r0, r2), vzip1q_f32(r1, r3));
            let (high02, high13) = (vzip2q_f32(r0, r2), vzip2q_f32(r1, r3));
            [vzip1q_f32(low02, low13), vzip2q_f32(low02, low13), vzip1q_f32(high02, high13)]
        })
    }
    #[inline(always)]
    fn misses(self, [a, b]: [Wide; 2], [c, d]: [Wide; 2], [e, f]: [Wide; 2]) -> u32 {
        let out = with!({
            let both = vandq_u32(vcgtq_f32(c, d), vcgtq_f32(e, f));
            vorrq_u32(vcgtq_f32(a, b), both)
        });
        bits(out, 15)
    }
}
