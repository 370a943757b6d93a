//! The operations on wide rows, which have eight lanes.

/// The operations on eight lanes but for comparisons, the same for both.
macro_rules! eight_lanes {
    () => {
        type Wide = __m256;
        type Words = __m256i;
        const WIDE: usize = 8;

        #[inline(always)]
        fn words(self, words: &[u32; 8]) -> __m256i {
            with!(_mm256_loadu_si256(words.as_ptr().cast()))
        }
        #[inline(always)]
        fn field(self, words: __m256i, mask: &[u32; 8]) -> __m256 {
            with!({
                let mask = _mm256_loadu_si256(mask.as_ptr().cast());
                _mm256_cvtepi32_ps(_mm256_and_si256(words, mask))
            })
        }
        #[inline(always)]
        fn tops(self, words: __m256i) -> [u32; 2] {
            with!({
                let below = _mm256_add_epi32(words, words);
                let top = _mm256_movemask_ps(_mm256_castsi256_ps(words));
                [top as u32, _mm256_movemask_ps(_mm256_castsi256_ps(below)) as u32]
            })
        }
        #[inline(always)]
        fn thrice(self, numbers: &[u32]) -> [u32; 8] {
            const MASK: [i32; 16] = [-1, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 0];
            let mask = &MASK[8 - numbers.len().min(8)..][..8];
            let mut thrice = [0; 8];
            // Reads no number that the mask leaves out.
            with!({
                let mask = _mm256_loadu_si256(mask.as_ptr().cast());
                let n = _mm256_maskload_epi32(numbers.as_ptr().cast(), mask);
                let n = _mm256_add_epi32(n, _mm256_add_epi32(n, n));
                _mm256_storeu_si256(thrice.as_mut_ptr().cast(), n);
            });
            thrice
        }
        #[inline(always)]
        fn columns<'a>(self, row: impl Fn(usize) -> &'a [f32; 4]) -> [__m256; 3] {
            let [a, b, c, _] = self.four_columns(row);
            [a, b, c]
        }
        #[inline(always)]
        fn four_columns<'a>(self, row: impl Fn(usize) -> &'a [f32; 4]) -> [__m256; 4] {
            with!({
                let r04 = _mm256_loadu2_m128(row(4).as_ptr(), row(0).as_ptr());
                let r15 = _mm256_loadu2_m128(row(5).as_ptr(), row(1).as_ptr());
                let r26 = _mm256_loadu2_m128(row(6).as_ptr(), row(2).as_ptr());
                let r37 = _mm256_loadu2_m128(row(7).as_ptr(), row(3).as_ptr());
                let low01 = _mm256_unpacklo_ps(r04, r15);
                let low23 = _mm256_unpacklo_ps(r26, r37);
                let high01 = _mm256_unpackhi_ps(r04, r15);
                let high23 = _mm256_unpackhi_ps(r26, r37);
                [
                    _mm256_shuffle_ps::<0b01_00_01_00>(low01, low23),
                    _mm256_shuffle_ps::<0b11_10_11_10>(low01, low23),
                    _mm256_shuffle_ps::<0b01_00_01_00>(high01, high23),
                    _mm256_shuffle_ps::<0b11_10_11_10>(high01, high23),
                ]
            })
        }
        #[inline(always)]
        fn gather<const N: usize>(self, from: &[f32; N], numbers: &[u32; 8]) -> __m256 {
            const { assert!(N.is_power_of_two() && N <= 1 << 30) };
            with!({
                let at = _mm256_loadu_si256(numbers.as_ptr().cast());
                let at = _mm256_and_si256(at, _mm256_set1_epi32(N as i32 - 1));
                _mm256_i32gather_ps::<4>(from.as_ptr(), at)
            })
        }
        #[inline(always)]
        fn load_wide(self, a: &[f32; 8]) -> __m256 {
            with!(_mm256_loadu_ps(a.as_ptr()))
        }
        #[inline(always)]
        fn store_wide(self, a: __m256, to: &mut [f32; 8]) {
            with!(_mm256_storeu_ps(to.as_mut_ptr(), a))
        }
        #[inline(always)]
        fn truncate_wide(self, a: __m256) -> __m256 {
            with!(_mm256_round_ps::<{ _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC }>(a))
        }
        #[inline(always)]
        fn choose_wide(self, a: __m256, b: __m256, x: __m256, y: __m256) -> __m256 {
            with!(_mm256_blendv_ps(y, x, _mm256_cmp_ps::<_CMP_LE_OQ>(a, b)))
        }
        #[inline(always)]
        fn numbers(
            self,
            near: __m256,
            far: __m256,
            stride: &[u32; 8],
            first: &[u32; 8],
            to: &mut [u32; 8],
        ) {
            with!({
                let stride = _mm256_loadu_si256(stride.as_ptr().cast());
                let first = _mm256_loadu_si256(first.as_ptr().cast());
                let near = _mm256_add_epi32(_mm256_cvttps_epi32(near), first);
                let far = _mm256_mullo_epi32(_mm256_cvttps_epi32(far), stride);
                _mm256_storeu_si256(to.as_mut_ptr().cast(), _mm256_add_epi32(near, far));
            });
        }
        #[inline(always)]
        fn load_from(self, a: &[f32; 8], _: usize) -> __m256 {
            self.load_wide(a)
        }
        #[inline(always)]
        fn bytes_from(self, a: &[u8; 8], _: usize) -> __m256 {
            with!({
                let bytes = _mm_loadl_epi64(a.as_ptr().cast());
                _mm256_cvtepi32_ps(_mm256_cvtepu8_epi32(bytes))
            })
        }
        #[inline(always)]
        fn store_from(self, a: __m256, to: &mut [f32; 8], _: usize) {
            self.store_wide(a, to);
        }
        #[inline(always)]
        fn splat_wide(self, a: f32) -> __m256 {
            with!(_mm256_set1_ps(a))
        }
        #[inline(always)]
        fn div_wide(self, a: __m256, b: __m256) -> __m256 {
            with!(_mm256_div_ps(a, b))
        }
        #[inline(always)]
        fn sub_wide(self, a: __m256, b: __m256) -> __m256 {
            with!(_mm256_sub_ps(a, b))
        }
        #[inline(always)]
        fn mul_wide(self, a: __m256, b: __m256) -> __m256 {
            with!(_mm256_mul_ps(a, b))
        }
        #[inline(always)]
        fn add_wide(self, a: __m256, b: __m256) -> __m256 {
            with!(_mm256_add_ps(a, b))
        }
        #[inline(always)]
        fn min_wide(self, a: __m256, b: __m256) -> __m256 {
            with!(_mm256_min_ps(a, b))
        }
        #[inline(always)]
        fn max_wide(self, a: __m256, b: __m256) -> __m256 {
            with!(_mm256_max_ps(a, b))
        }
        #[inline(always)]
        fn least(self, a: __m256) -> u32 {
            with!({
                let least = _mm256_min_ps(a, _mm256_permute2f128_ps::<1>(a, a));
                let least = _mm256_min_ps(least, _mm256_permute_ps::<0b01_00_11_10>(least));
                let least = _mm256_min_ps(least, _mm256_permute_ps::<0b10_11_00_01>(least));
                self.at_most(a, least)
            })
        }
        #[inline(always)]
        fn abs_wide(self, a: __m256) -> __m256 {
            with!(_mm256_andnot_ps(_mm256_set1_ps(-0.0), a))
        }
        #[inline(always)]
        fn mul_add_wide(self, a: __m256, b: __m256, c: __m256) -> __m256 {
            with!(_mm256_fmadd_ps(a, b, c))
        }
        #[inline(always)]
        fn less_product(self, a: __m256, b: __m256, c: __m256) -> __m256 {
            with!(_mm256_fnmadd_ps(b, c, a))
        }
        #[inline(always)]
        fn product_less(self, a: __m256, b: __m256, c: __m256) -> __m256 {
            with!(_mm256_fmsub_ps(a, b, c))
        }
        #[inline(always)]
        fn turn_wide(self, a: __m256, b: __m256) -> __m256 {
            with!(_mm256_xor_ps(a, _mm256_and_ps(_mm256_set1_ps(-0.0), b)))
        }
        #[inline(always)]
        fn cross_wide(self, a: __m256, b: __m256, c: __m256, d: __m256) -> __m256 {
            with!(_mm256_fmsub_ps(a, b, _mm256_mul_ps(c, d)))
        }
    };
}
pub(super) use eight_lanes;
