//! AVX-512: more registers and comparisons into masks, in 256 bits. While wider
//! operations are in flight, processors close one of the ports that the walk's own
//! operations need; rows of 512 bits were slower.

use core::arch::x86_64::*;

use super::super::lanes::{Kernel, Lanes};
use super::{eight_lanes, four_lanes, shell, with};

shell! {
    /// Proof that AVX-512 (F, VL, DQ), AVX2, FMA, POPCNT and BMI are there.
    Avx512: "avx512f", "avx512vl", "avx512dq", "avx2", "fma", "popcnt", "bmi1",
        "bmi2"
}

impl Lanes for Avx512 {
    four_lanes!();
    eight_lanes!();
    const MASKS: bool = true;

    #[inline(always)]
    fn compress(self, words: &[u32; 8], mask: u32, to: &mut [u32; 8]) {
        with!({
            let words = _mm256_loadu_si256(words.as_ptr().cast());
            let few = _mm256_maskz_compress_epi32(mask as u8, words);
            _mm256_storeu_si256(to.as_mut_ptr().cast(), few);
        });
    }

    #[inline(always)]
    fn at_most(self, a: __m256, b: __m256) -> u32 {
        with!(u32::from(_mm256_cmp_ps_mask::<_CMP_LE_OQ>(a, b)))
    }

    #[inline(always)]
    fn misses(self, [a, b]: [__m256; 2], [c, d]: [__m256; 2], [e, f]: [__m256; 2]) -> u32 {
        with!({
            let ab = _mm256_cmp_ps_mask::<_CMP_GT_OQ>(a, b);
            let cd = _mm256_cmp_ps_mask::<_CMP_GT_OQ>(c, d);
            u32::from(ab | _mm256_mask_cmp_ps_mask::<_CMP_GT_OQ>(cd, e, f))
        })
    }
}
