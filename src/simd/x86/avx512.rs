//! AVX-512: more registers and comparisons into masks, in 256 bits. While wider
//! operations are in flight, processors close one of the ports that the walk's own
//! operations need; rows of 512 bits were slower.

use core::arch::x86_64::*;

use super::super::lanes::{Kernel, Lanes, RayColumns};
use super::{eight_lanes, four_lanes, shell, with};

shell! {
    /// Proof that AVX-512 (F, VL, DQ), AVX2, FMA, POPCNT and BMI are there.
    Avx512: "avx512f", "avx512vl", "avx512dq", "avx2", "fma", "popcnt", "bmi1",
        "bmi2"
}

impl Lanes for Avx512 {
    four_lanes!();
    eight_lanes!();

    #[inline(always)]
    fn compress(self, words: &[u32; 8], mask: u32, to: &mut [u32; 8]) {
        with!({
            let words = _mm256_loadu_si256(words.as_ptr().cast());
            let few = _mm256_maskz_compress_epi32(mask as u8, words);
            _mm256_storeu_si256(to.as_mut_ptr().cast(), few);
        });
    }

    const MANY: usize = 16;

    // Sixteen rays: here, where there is hardly anything else to do, wider rows are quicker.
    #[inline(always)]
    fn enter_box(
        self,
        rays: &RayColumns<'_>,
        bounds: [f32; 6],
        ids: &[u32; 16],
        to: &mut [u32; 16],
        entries: &mut [f32; 16],
    ) -> usize {
        let &RayColumns { pace, from, enter, to: ends, leave } = rays;
        with!({
            let pace = each!(k => _mm512_loadu_ps(pace[k].as_ptr()));
            let enter = each!(k => {
                let at = _mm512_loadu_ps(enter[k].as_ptr());
                _mm512_fmadd_ps(_mm512_set1_ps(bounds[k]), pace[k], at)
            });
            let leave = each!(k => {
                let at = _mm512_loadu_ps(leave[k].as_ptr());
                _mm512_fmadd_ps(_mm512_set1_ps(bounds[k + 3]), pace[k], at)
            });
            let first = _mm512_max_ps(enter[2], _mm512_loadu_ps(from.as_ptr()));
            let first = _mm512_max_ps(_mm512_max_ps(enter[0], enter[1]), first);
            let last = _mm512_min_ps(leave[2], _mm512_loadu_ps(ends.as_ptr()));
            let last = _mm512_min_ps(_mm512_min_ps(leave[0], leave[1]), last);
            let met = _mm512_cmp_ps_mask::<_CMP_LE_OQ>(first, last);
            let ids = _mm512_loadu_si512(ids.as_ptr().cast());
            let ids = _mm512_maskz_compress_epi32(met, ids);
            _mm512_storeu_si512(to.as_mut_ptr().cast(), ids);
            _mm512_storeu_ps(entries.as_mut_ptr(), _mm512_maskz_compress_ps(met, first));
            met.count_ones() as usize
        })
    }

    #[inline(always)]
    fn compress_wide(self, a: __m256, mask: u32, to: &mut [f32; 8]) {
        with!(_mm256_storeu_ps(to.as_mut_ptr(), _mm256_maskz_compress_ps(mask as u8, a)));
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
