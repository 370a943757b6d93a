//! AVX2 and FMA.

use core::arch::x86_64::*;

use super::super::lanes::{Kernel, Lanes};
use super::{eight_lanes, four_lanes, shell, with};

shell! {
    /// Proof that AVX2, FMA, POPCNT and BMI are there.
    Avx2: "avx2", "fma", "popcnt", "bmi1", "bmi2"
}

/// For each mask the lanes that it has, then zeros.
const ORDERS: [[u8; 8]; 256] = {
    let mut orders = [[0; 8]; 256];
    let mut mask = 0;
    while mask < 256 {
        let (mut lane, mut at) = (0, 0);
        while lane < 8 {
            if mask >> lane & 1 != 0 {
                orders[mask][at] = lane as u8;
                at += 1;
            }
            lane += 1;
        }
        mask += 1;
    }
    orders
};

impl Lanes for Avx2 {
    four_lanes!();
    eight_lanes!();

    #[inline(always)]
    fn compress(self, words: &[u32; 8], mask: u32, to: &mut [u32; 8]) {
        let order = &ORDERS[mask as usize % ORDERS.len()];
        with!({
            let words = _mm256_loadu_si256(words.as_ptr().cast());
            let order = _mm256_cvtepu8_epi32(_mm_loadl_epi64(order.as_ptr().cast()));
            _mm256_storeu_si256(to.as_mut_ptr().cast(), _mm256_permutevar8x32_epi32(words, order));
        });
    }

    #[inline(always)]
    fn compress_wide(self, a: __m256, mask: u32, to: &mut [f32; 8]) {
        let order = &ORDERS[mask as usize % ORDERS.len()];
        with!({
            let order = _mm256_cvtepu8_epi32(_mm_loadl_epi64(order.as_ptr().cast()));
            _mm256_storeu_ps(to.as_mut_ptr(), _mm256_permutevar8x32_ps(a, order));
        });
    }

    #[inline(always)]
    fn at_most(self, a: __m256, b: __m256) -> u32 {
        with!(_mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(a, b)) as u32)
    }

    #[inline(always)]
    fn misses(self, [a, b]: [__m256; 2], [c, d]: [__m256; 2], [e, f]: [__m256; 2]) -> u32 {
        with!({
            let ab = _mm256_cmp_ps::<_CMP_GT_OQ>(a, b);
            let cd = _mm256_cmp_ps::<_CMP_GT_OQ>(c, d);
            let ef = _mm256_cmp_ps::<_CMP_GT_OQ>(e, f);
            _mm256_movemask_ps(_mm256_or_ps(ab, _mm256_and_ps(cd, ef))) as u32
        })
    }
}
