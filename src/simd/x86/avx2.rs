//! AVX2 and FMA.

use core::arch::x86_64::*;

use super::super::lanes::{Kernel, Lanes};
use super::{eight_lanes, four_lanes, with};

/// Proof that AVX2 and FMA are there.
#[derive(Clone, Copy)]
pub struct Avx2(());

impl Avx2 {
    /// Asks the processor.
    pub fn detect() -> Option<Self> {
        #[cfg(feature = "std")]
        let there = std::arch::is_x86_feature_detected!("avx2")
            && std::arch::is_x86_feature_detected!("fma");
        #[cfg(not(feature = "std"))]
        let there = cfg!(all(target_feature = "avx2", target_feature = "fma"));
        there.then_some(Self(()))
    }

    /// Asks nobody.
    ///
    /// # Safety
    /// [`Avx2::detect`] has succeeded in this process.
    #[inline(always)]
    pub unsafe fn detected() -> Self {
        Self(())
    }
}

#[target_feature(enable = "avx2,fma")]
fn compiled<K: Kernel<Avx2>>(kernel: K, lanes: Avx2) -> K::Out {
    kernel.run(lanes)
}

impl Lanes for Avx2 {
    four_lanes!();

    eight_lanes!();

    #[inline(always)]
    fn run<K: Kernel<Self>>(self, kernel: K) -> K::Out {
        with!(compiled(kernel, self))
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
            let ab = _mm256_cmp_ps::<_CMP_GT_OQ>(a, b);
            let cb = _mm256_cmp_ps::<_CMP_GT_OQ>(c, b);
            let de = _mm256_cmp_ps::<_CMP_LT_OQ>(d, e);
            let fg = _mm256_cmp_ps::<_CMP_GT_OQ>(f, g);
            let out = _mm256_or_ps(_mm256_and_ps(ab, cb), _mm256_or_ps(de, fg));
            _mm256_movemask_ps(out) as u32
        })
    }
}
