//! AVX-512: more registers and comparisons into masks, in 256 bits. While wider
//! operations are in flight, processors close one of the ports that the walk's own
//! operations need; rows of 512 bits were slower.

use core::arch::x86_64::*;

use super::super::lanes::{Kernel, Lanes};
use super::{eight_lanes, four_lanes, with};

/// Proof that AVX-512 (F, VL, DQ), AVX2 and FMA are there.
#[derive(Clone, Copy)]
pub struct Avx512(());

impl Avx512 {
    /// Asks the processor.
    pub fn detect() -> Option<Self> {
        #[cfg(feature = "std")]
        let there = std::arch::is_x86_feature_detected!("avx512f")
            && std::arch::is_x86_feature_detected!("avx512vl")
            && std::arch::is_x86_feature_detected!("avx512dq")
            && super::Avx2::detect().is_some();
        #[cfg(not(feature = "std"))]
        let there = cfg!(all(
            target_feature = "avx512f",
            target_feature = "avx512vl",
            target_feature = "avx512dq"
        )) && super::Avx2::detect().is_some();
        there.then_some(Self(()))
    }

    /// Asks nobody.
    ///
    /// # Safety
    /// [`Avx512::detect`] has succeeded in this process.
    #[inline(always)]
    pub unsafe fn detected() -> Self {
        Self(())
    }
}

#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx2,fma,popcnt,bmi1,bmi2")]
fn compiled<K: Kernel<Avx512>>(kernel: K, lanes: Avx512) -> K::Out {
    kernel.run(lanes)
}

impl Lanes for Avx512 {
    four_lanes!();

    eight_lanes!();

    #[inline(always)]
    fn run<K: Kernel<Self>>(self, kernel: K) -> K::Out {
        with!(compiled(kernel, self))
    }

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
    fn misses(
        self,
        [a, b]: [__m256; 2],
        c: __m256,
        [d, e]: [__m256; 2],
        [f, g]: [__m256; 2],
    ) -> u32 {
        with!({
            let ab = _mm256_cmp_ps_mask::<_CMP_GT_OQ>(a, b);
            let beside = _mm256_mask_cmp_ps_mask::<_CMP_GT_OQ>(ab, c, b);
            let before = _mm256_cmp_ps_mask::<_CMP_LT_OQ>(d, e);
            let behind = _mm256_cmp_ps_mask::<_CMP_GT_OQ>(f, g);
            u32::from(beside | before | behind)
        })
    }
}
