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
            && std::arch::is_x86_feature_detected!("fma")
            && std::arch::is_x86_feature_detected!("popcnt")
            && std::arch::is_x86_feature_detected!("bmi1")
            && std::arch::is_x86_feature_detected!("bmi2");
        #[cfg(not(feature = "std"))]
        let there = cfg!(all(
            target_feature = "avx2",
            target_feature = "fma",
            target_feature = "popcnt",
            target_feature = "bmi1",
            target_feature = "bmi2"
        ));
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

#[target_feature(enable = "avx2,fma,popcnt,bmi1,bmi2")]
fn compiled<K: Kernel<Avx2>>(kernel: K, lanes: Avx2) -> K::Out {
    kernel.run(lanes)
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
    fn run<K: Kernel<Self>>(self, kernel: K) -> K::Out {
        with!(compiled(kernel, self))
    }

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
    fn at_most(self, a: __m256, b: __m256) -> u32 {
        with!(_mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(a, b)) as u32)
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
