//! Lanes on x86-64: AVX2.
//!
//! # Safety
//! The intrinsics are sound because a value of [`Avx2`] exists only after
//! [`Avx2::detect`] found the instructions (or the whole program is compiled for
//! them); loads go through references.

use core::arch::x86_64::*;

use super::lanes::{Kernel, Lanes};

/// Proof that AVX2 is there.
#[derive(Clone, Copy)]
pub struct Avx2(());

impl Avx2 {
    /// Asks the processor, once per process.
    #[inline(always)]
    pub fn detect() -> Option<Self> {
        #[cfg(feature = "std")]
        let there = std::arch::is_x86_feature_detected!("avx2");
        #[cfg(not(feature = "std"))]
        let there = cfg!(target_feature = "avx2");
        there.then_some(Self(()))
    }
}

#[target_feature(enable = "avx2")]
fn compiled<K: Kernel<Avx2>>(kernel: K, lanes: Avx2) -> K::Out {
    kernel.run(lanes)
}

/// Wraps intrinsics; see the module on why they are there.
macro_rules! with {
    ($e:expr) => {
        // SAFETY: `self` proves that the instructions are there.
        unsafe { $e }
    };
}

impl Lanes for Avx2 {
    type F64 = __m256d;
    type I32 = __m128i;
    type F32 = __m128;

    #[inline(always)]
    fn run<K: Kernel<Self>>(self, kernel: K) -> K::Out {
        with!(compiled(kernel, self))
    }

    #[inline(always)]
    fn f64(self, [x, y, z, w]: [f64; 4]) -> __m256d {
        with!(_mm256_setr_pd(x, y, z, w))
    }
    #[inline(always)]
    fn splat_f64(self, a: f64) -> __m256d {
        with!(_mm256_set1_pd(a))
    }
    #[inline(always)]
    fn mul_add(self, a: __m256d, b: __m256d, c: __m256d) -> __m256d {
        with!(_mm256_add_pd(_mm256_mul_pd(a, b), c))
    }
    #[inline(always)]
    fn mul_f64(self, a: __m256d, b: __m256d) -> __m256d {
        with!(_mm256_mul_pd(a, b))
    }
    #[inline(always)]
    fn add_f64(self, a: __m256d, b: __m256d) -> __m256d {
        with!(_mm256_add_pd(a, b))
    }
    #[inline(always)]
    fn sub_f64(self, a: __m256d, b: __m256d) -> __m256d {
        with!(_mm256_sub_pd(a, b))
    }
    #[inline(always)]
    fn min_f64(self, a: __m256d, b: __m256d) -> __m256d {
        with!(_mm256_min_pd(a, b))
    }
    #[inline(always)]
    fn max_f64(self, a: __m256d, b: __m256d) -> __m256d {
        with!(_mm256_max_pd(a, b))
    }
    #[inline(always)]
    fn any_beyond(self, a: __m256d, b: __m256d) -> bool {
        with!({
            let size = _mm256_andnot_pd(_mm256_set1_pd(-0.0), a);
            _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_GT_OQ>(size, b)) & 7 != 0
        })
    }
    #[inline(always)]
    fn highest(self, a: __m256d) -> __m256d {
        with!({
            let pairs = _mm256_max_pd(a, _mm256_permute_pd::<0b0101>(a));
            _mm256_max_pd(pairs, _mm256_permute2f128_pd::<0x01>(pairs, pairs))
        })
    }
    #[inline(always)]
    fn lowest(self, a: __m256d) -> __m256d {
        with!({
            let pairs = _mm256_min_pd(a, _mm256_permute_pd::<0b0101>(a));
            _mm256_min_pd(pairs, _mm256_permute2f128_pd::<0x01>(pairs, pairs))
        })
    }
    #[inline(always)]
    fn array_f64(self, a: __m256d) -> [f64; 4] {
        let mut out = [0.0; 4];
        with!(_mm256_storeu_pd(out.as_mut_ptr(), a));
        out
    }
    #[inline(always)]
    fn first(self, a: __m256d) -> f64 {
        with!(_mm256_cvtsd_f64(a))
    }
    #[inline(always)]
    fn truncate(self, a: __m256d) -> __m128i {
        with!(_mm256_cvttpd_epi32(a))
    }
    #[inline(always)]
    fn select_eq(self, a: __m256d, b: __m256d, i: __m128i, j: __m128i) -> __m128i {
        with!({
            let mask = _mm256_castpd_si256(_mm256_cmp_pd::<_CMP_EQ_OQ>(a, b));
            let (low, high) = (_mm256_castsi256_si128(mask), _mm256_extracti128_si256::<1>(mask));
            _mm_blendv_epi8(j, i, _mm_packs_epi32(low, high))
        })
    }

    #[inline(always)]
    fn i32(self, [x, y, z, w]: [i32; 4]) -> __m128i {
        with!(_mm_setr_epi32(x, y, z, w))
    }
    #[inline(always)]
    fn splat_i32(self, a: i32) -> __m128i {
        with!(_mm_set1_epi32(a))
    }
    #[inline(always)]
    fn array(self, a: __m128i) -> [i32; 4] {
        with!([
            _mm_cvtsi128_si32(a),
            _mm_extract_epi32::<1>(a),
            _mm_extract_epi32::<2>(a),
            _mm_extract_epi32::<3>(a),
        ])
    }
    #[inline(always)]
    fn to_f64(self, a: __m128i) -> __m256d {
        with!(_mm256_cvtepi32_pd(a))
    }
    #[inline(always)]
    fn add(self, a: __m128i, b: __m128i) -> __m128i {
        with!(_mm_add_epi32(a, b))
    }
    #[inline(always)]
    fn sub(self, a: __m128i, b: __m128i) -> __m128i {
        with!(_mm_sub_epi32(a, b))
    }
    #[inline(always)]
    fn and(self, a: __m128i, b: __m128i) -> __m128i {
        with!(_mm_and_si128(a, b))
    }
    #[inline(always)]
    fn xor(self, a: __m128i, b: __m128i) -> __m128i {
        with!(_mm_xor_si128(a, b))
    }
    #[inline(always)]
    fn min(self, a: __m128i, b: __m128i) -> __m128i {
        with!(_mm_min_epi32(a, b))
    }
    #[inline(always)]
    fn max(self, a: __m128i, b: __m128i) -> __m128i {
        with!(_mm_max_epi32(a, b))
    }
    #[inline(always)]
    fn shift_right(self, a: __m128i, by: __m128i) -> __m128i {
        with!(_mm_srlv_epi32(a, by))
    }
    #[inline(always)]
    fn outside(self, a: __m128i, n: __m128i) -> bool {
        // Below 0 or above n - 1: a negative number has its sign bit set.
        with!({
            let above = _mm_cmpgt_epi32(n, a);
            let bad = _mm_or_si128(a, _mm_xor_si128(above, _mm_set1_epi32(-1)));
            _mm_movemask_ps(_mm_castsi128_ps(bad)) != 0
        })
    }

    #[inline(always)]
    fn splat_f32(self, a: f32) -> __m128 {
        with!(_mm_set1_ps(a))
    }
    #[inline(always)]
    fn load(self, a: &[f32; 4]) -> __m128 {
        with!(_mm_loadu_ps(a.as_ptr()))
    }
    #[inline(always)]
    fn sub_f32(self, a: __m128, b: __m128) -> __m128 {
        with!(_mm_sub_ps(a, b))
    }
    #[inline(always)]
    fn add_f32(self, a: __m128, b: __m128) -> __m128 {
        with!(_mm_add_ps(a, b))
    }
    #[inline(always)]
    fn mul_f32(self, a: __m128, b: __m128) -> __m128 {
        with!(_mm_mul_ps(a, b))
    }
    #[inline(always)]
    fn abs_f32(self, a: __m128) -> __m128 {
        with!(_mm_andnot_ps(_mm_set1_ps(-0.0), a))
    }
    #[inline(always)]
    fn rotate(self, a: __m128) -> __m128 {
        with!(_mm_permute_ps::<0b11_00_10_01>(a))
    }
    #[inline(always)]
    fn both_sides(self, a: __m128, b: __m128) -> bool {
        with!({
            let above = _mm_movemask_ps(_mm_cmplt_ps(b, a)) & 7;
            let minus = _mm_xor_ps(b, _mm_set1_ps(-0.0));
            let below = _mm_movemask_ps(_mm_cmplt_ps(a, minus)) & 7;
            above != 0 && below != 0
        })
    }
}
