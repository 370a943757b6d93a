//! AVX-512: rows of four triangles.

use core::arch::x86_64::*;

use super::super::lanes::{Kernel, Lanes};
use super::{four_lanes, with};

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
        ));
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

#[target_feature(enable = "avx512f,avx512vl,avx512dq,avx2,fma")]
fn compiled<K: Kernel<Avx512>>(kernel: K, lanes: Avx512) -> K::Out {
    kernel.run(lanes)
}

impl Lanes for Avx512 {
    four_lanes!();

    /// Not 512 bits: while such operations are in flight, processors close one of
    /// the ports that the walk's own operations need.
    type Rows = __m256;
    const ROWS: usize = 2;

    #[inline(always)]
    fn run<K: Kernel<Self>>(self, kernel: K) -> K::Out {
        with!(compiled(kernel, self))
    }

    #[inline(always)]
    fn rows<'a>(self, row: impl Fn(usize) -> &'a [f32; 4]) -> __m256 {
        with!(_mm256_loadu2_m128(row(1).as_ptr(), row(0).as_ptr()))
    }
    #[inline(always)]
    fn splat_rows(self, a: f32) -> __m256 {
        with!(_mm256_set1_ps(a))
    }
    #[inline(always)]
    fn sub_rows(self, a: __m256, b: __m256) -> __m256 {
        with!(_mm256_sub_ps(a, b))
    }
    #[inline(always)]
    fn mul_rows(self, a: __m256, b: __m256) -> __m256 {
        with!(_mm256_mul_ps(a, b))
    }
    #[inline(always)]
    fn add_rows(self, a: __m256, b: __m256) -> __m256 {
        with!(_mm256_add_ps(a, b))
    }
    #[inline(always)]
    fn abs_rows(self, a: __m256) -> __m256 {
        with!(_mm256_andnot_ps(_mm256_set1_ps(-0.0), a))
    }
    #[inline(always)]
    fn less_product(self, a: __m256, b: __m256, c: __m256) -> __m256 {
        with!(_mm256_fnmadd_ps(b, c, a))
    }
    #[inline(always)]
    fn cross_rows(self, a: __m256, b: __m256, c: __m256, d: __m256) -> __m256 {
        with!(_mm256_fmsub_ps(a, b, _mm256_mul_ps(c, d)))
    }
    #[inline(always)]
    fn rotate(self, a: __m256) -> __m256 {
        with!(_mm256_permute_ps::<0b11_00_10_01>(a))
    }
    #[inline(always)]
    fn spread<const K: i32>(self, a: __m128) -> __m256 {
        let lane = self.permute(a, &[K; 4]);
        with!(_mm256_broadcastss_ps(lane))
    }
    #[inline(always)]
    fn misses(self, side: __m256, error: __m256, z: __m256, [lo, hi]: [__m256; 2]) -> u32 {
        let [above, below, before, behind] = with!({
            let other = _mm256_xor_ps(_mm256_set1_ps(-0.0), side);
            [
                _mm256_mask_cmp_ps_mask::<_CMP_GT_OQ>(0x77, side, error),
                _mm256_mask_cmp_ps_mask::<_CMP_GT_OQ>(0x77, other, error),
                _mm256_mask_cmp_ps_mask::<_CMP_LT_OQ>(0x77, z, lo),
                _mm256_mask_cmp_ps_mask::<_CMP_GT_OQ>(0x77, z, hi),
            ]
        })
        .map(u32::from);
        // Carries into bits 3 and 7 from any, or from all, of the three bits below.
        (above + 0x77) & (below + 0x77) | (before + 0x11) | (behind + 0x11)
    }
}
