//! AVX2 and FMA.

use core::arch::x86_64::*;

use super::super::lanes::{Kernel, Lanes};
use super::{eight_lanes, four_lanes, shell, with};

shell! {
    /// Proof that AVX2 and FMA are there.
    Avx2: "avx2", "fma"
}

impl Lanes for Avx2 {
    four_lanes!();
    eight_lanes!();

    #[inline(always)]
    fn misses(
        self,
        [a, b]: [__m256; 2],
        c: __m256,
        [d, e]: [__m256; 2],
        [f, g]: [__m256; 2],
    ) -> u32 {
        with!({
            let ab = _mm256_cmp_ps::<_CMP_GT_OQ>(a, b);
            let cb = _mm256_cmp_ps::<_CMP_GT_OQ>(c, b);
            let de = _mm256_cmp_ps::<_CMP_LT_OQ>(d, e);
            let fg = _mm256_cmp_ps::<_CMP_GT_OQ>(f, g);
            let out = _mm256_or_ps(_mm256_and_ps(ab, cb), _mm256_or_ps(de, fg));
            _mm256_movemask_ps(out) as u32
        })
    }
}
