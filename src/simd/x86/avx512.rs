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

    type Rows = __m512;
    const ROWS: usize = 4;

    #[inline(always)]
    fn run<K: Kernel<Self>>(self, kernel: K) -> K::Out {
        with!(compiled(kernel, self))
    }

    #[inline(always)]
    fn rows<'a>(self, row: impl Fn(usize) -> &'a [f32; 4]) -> __m512 {
        with!({
            let low = _mm256_loadu2_m128(row(1).as_ptr(), row(0).as_ptr());
            let high = _mm256_loadu2_m128(row(3).as_ptr(), row(2).as_ptr());
            _mm512_insertf32x8::<1>(_mm512_castps256_ps512(low), high)
        })
    }
    #[inline(always)]
    fn splat_rows(self, a: f32) -> __m512 {
        with!(_mm512_set1_ps(a))
    }
    #[inline(always)]
    fn sub_rows(self, a: __m512, b: __m512) -> __m512 {
        with!(_mm512_sub_ps(a, b))
    }
    #[inline(always)]
    fn mul_rows(self, a: __m512, b: __m512) -> __m512 {
        with!(_mm512_mul_ps(a, b))
    }
    #[inline(always)]
    fn add_rows(self, a: __m512, b: __m512) -> __m512 {
        with!(_mm512_add_ps(a, b))
    }
    #[inline(always)]
    fn abs_rows(self, a: __m512) -> __m512 {
        with!(_mm512_abs_ps(a))
    }
    #[inline(always)]
    fn less_product(self, a: __m512, b: __m512, c: __m512) -> __m512 {
        with!(_mm512_fnmadd_ps(b, c, a))
    }
    #[inline(always)]
    fn cross_rows(self, a: __m512, b: __m512, c: __m512, d: __m512) -> __m512 {
        with!(_mm512_fmsub_ps(a, b, _mm512_mul_ps(c, d)))
    }
    #[inline(always)]
    fn rotate(self, a: __m512) -> __m512 {
        with!(_mm512_permute_ps::<0b11_00_10_01>(a))
    }
    #[inline(always)]
    fn spread<const K: i32>(self, a: __m128) -> __m512 {
        let lane = self.permute(a, &[K; 4]);
        with!(_mm512_broadcastss_ps(lane))
    }
    #[inline(always)]
    fn misses(self, side: __m512, error: __m512, z: __m512, [lo, hi]: [__m512; 2]) -> u32 {
        let [above, below, before, behind] = with!({
            let other = _mm512_xor_ps(_mm512_set1_ps(-0.0), side);
            [
                _mm512_mask_cmp_ps_mask::<_CMP_GT_OQ>(0x7777, side, error),
                _mm512_mask_cmp_ps_mask::<_CMP_GT_OQ>(0x7777, other, error),
                _mm512_mask_cmp_ps_mask::<_CMP_LT_OQ>(0x7777, z, lo),
                _mm512_mask_cmp_ps_mask::<_CMP_GT_OQ>(0x7777, z, hi),
            ]
        })
        .map(u32::from);
        // Carries into every fourth bit from any, or from all, of the three below.
        (above + 0x7777) & (below + 0x7777) | (before + 0x1111) | (behind + 0x1111)
    }
}
