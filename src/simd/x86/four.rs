//! The operations on four lanes, of a ray alone.

/// The four-lane operations, the same for both.
macro_rules! four_lanes {
    () => {
        type F64 = __m256d;
        type F32 = __m128;
        type I32 = __m128i;

        #[inline(always)]
        fn array_f32(self, a: __m128) -> [f32; 4] {
            let mut array = [0.0; 4];
            with!(_mm_storeu_ps(array.as_mut_ptr(), a));
            array
        }
        #[inline(always)]
        fn transpose(self, [a, b, c, d]: [__m128; 4]) -> [__m128; 4] {
            with!({
                let (low, high) = (_mm_unpacklo_ps(a, b), _mm_unpackhi_ps(a, b));
                let (more_low, more_high) = (_mm_unpacklo_ps(c, d), _mm_unpackhi_ps(c, d));
                [
                    _mm_movelh_ps(low, more_low),
                    _mm_movehl_ps(more_low, low),
                    _mm_movelh_ps(high, more_high),
                    _mm_movehl_ps(more_high, high),
                ]
            })
        }
        #[inline(always)]
        fn run<K: Kernel<Self>>(self, kernel: K) -> K::Out {
            with!(compiled(kernel, self))
        }
        #[inline(always)]
        fn run_apart<K: Kernel<Self>>(self, kernel: K) -> K::Out {
            with!(compiled_apart(kernel, self))
        }
        #[inline(always)]
        fn load_f64(self, a: &[f64; 4]) -> __m256d {
            with!(_mm256_loadu_pd(a.as_ptr()))
        }
        #[inline(always)]
        fn splat_f64(self, a: f64) -> __m256d {
            with!(_mm256_set1_pd(a))
        }
        #[inline(always)]
        fn widen(self, a: __m128) -> __m256d {
            with!(_mm256_cvtps_pd(a))
        }
        #[inline(always)]
        fn i32_to_f64(self, a: __m128i) -> __m256d {
            with!(_mm256_cvtepi32_pd(a))
        }
        #[inline(always)]
        fn mul_f64(self, a: __m256d, b: __m256d) -> __m256d {
            with!(_mm256_mul_pd(a, b))
        }
        #[inline(always)]
        fn add_f64(self, a: __m256d, b: __m256d) -> __m256d {
            with!(_mm256_add_pd(a, b))
        }
        #[inline(always)]
        fn sub_f64(self, a: __m256d, b: __m256d) -> __m256d {
            with!(_mm256_sub_pd(a, b))
        }
        #[inline(always)]
        fn div_f64(self, a: __m256d, b: __m256d) -> __m256d {
            with!(_mm256_div_pd(a, b))
        }
        #[inline(always)]
        fn min_f64(self, a: __m256d, b: __m256d) -> __m256d {
            with!(_mm256_min_pd(a, b))
        }
        #[inline(always)]
        fn max_f64(self, a: __m256d, b: __m256d) -> __m256d {
            with!(_mm256_max_pd(a, b))
        }
        #[inline(always)]
        fn abs_f64(self, a: __m256d) -> __m256d {
            with!(_mm256_andnot_pd(_mm256_set1_pd(-0.0), a))
        }
        #[inline(always)]
        fn sign_f64(self, a: __m256d, b: __m256d) -> __m256d {
            with!(_mm256_or_pd(a, _mm256_and_pd(_mm256_set1_pd(-0.0), b)))
        }
        #[inline(always)]
        fn mirror_f64(self, a: __m256d, b: __m256d, sign: __m256d) -> __m256d {
            with!(_mm256_blendv_pd(a, _mm256_sub_pd(b, a), sign))
        }
        #[inline(always)]
        fn any_beyond(self, a: __m256d, b: f64) -> bool {
            with!({
                let size = _mm256_andnot_pd(_mm256_set1_pd(-0.0), a);
                let beyond = _mm256_cmp_pd::<_CMP_GT_OQ>(size, _mm256_set1_pd(b));
                _mm256_movemask_pd(beyond) & 7 != 0
            })
        }
        #[inline(always)]
        fn above_f64(self, a: __m256d, b: __m256d) -> u32 {
            with!(_mm256_movemask_pd(_mm256_cmp_pd::<_CMP_GT_OQ>(a, b))) as u32
        }
        #[inline(always)]
        fn any_outside(self, a: __m256d, n: __m256d) -> bool {
            with!({
                let below = _mm256_cmp_pd::<_CMP_LT_OQ>(a, _mm256_setzero_pd());
                let above = _mm256_cmp_pd::<_CMP_GT_OQ>(a, n);
                _mm256_movemask_pd(_mm256_or_pd(below, above)) & 7 != 0
            })
        }
        #[inline(always)]
        fn mul_add_f64(self, a: __m256d, b: __m256d, c: __m256d) -> __m256d {
            with!(_mm256_fmadd_pd(a, b, c))
        }
        #[inline(always)]
        fn next_f64(self, a: __m256d) -> __m256d {
            with!(_mm256_permute4x64_pd::<0b01_00_10_01>(a))
        }
        #[inline(always)]
        fn with_last(self, a: __m256d, b: __m256d) -> __m256d {
            with!(_mm256_blend_pd::<0b1000>(a, _mm256_movedup_pd(b)))
        }
        #[inline(always)]
        fn array_f64(self, a: __m256d) -> [f64; 4] {
            let mut array = [0.0; 4];
            with!(_mm256_storeu_pd(array.as_mut_ptr(), a));
            array
        }
        #[inline(always)]
        fn highest3(self, a: __m256d) -> f64 {
            with!({
                let (low, z) = (_mm256_castpd256_pd128(a), _mm256_extractf128_pd::<1>(a));
                let xy = _mm_max_sd(low, _mm_unpackhi_pd(low, low));
                _mm_cvtsd_f64(_mm_max_sd(xy, z))
            })
        }
        #[inline(always)]
        fn lowest3(self, a: __m256d) -> f64 {
            with!({
                let (low, z) = (_mm256_castpd256_pd128(a), _mm256_extractf128_pd::<1>(a));
                let xy = _mm_min_sd(low, _mm_unpackhi_pd(low, low));
                _mm_cvtsd_f64(_mm_min_sd(xy, z))
            })
        }
        #[inline(always)]
        fn load_f32(self, a: &[f32; 4]) -> __m128 {
            with!(_mm_loadu_ps(a.as_ptr()))
        }
        #[inline(always)]
        fn load3(self, a: &[f32; 4]) -> __m128 {
            with!(_mm_blend_ps::<0b1000>(_mm_loadu_ps(a.as_ptr()), _mm_setzero_ps()))
        }
        #[inline(always)]
        fn splat_f32(self, a: f32) -> __m128 {
            with!(_mm_set1_ps(a))
        }
        #[inline(always)]
        fn with_third(self, a: __m128, b: __m128) -> __m128 {
            with!(_mm_blend_ps::<0b0100>(a, b))
        }
        #[inline(always)]
        fn narrow(self, a: __m256d) -> __m128 {
            with!(_mm256_cvtpd_ps(a))
        }
        #[inline(always)]
        fn to_f32(self, a: __m128i) -> __m128 {
            with!(_mm_cvtepi32_ps(a))
        }
        #[inline(always)]
        fn mul_f32(self, a: __m128, b: __m128) -> __m128 {
            with!(_mm_mul_ps(a, b))
        }
        #[inline(always)]
        fn add_f32(self, a: __m128, b: __m128) -> __m128 {
            with!(_mm_add_ps(a, b))
        }
        #[inline(always)]
        fn sub_f32(self, a: __m128, b: __m128) -> __m128 {
            with!(_mm_sub_ps(a, b))
        }
        #[inline(always)]
        fn div_f32(self, a: __m128, b: __m128) -> __m128 {
            with!(_mm_div_ps(a, b))
        }
        #[inline(always)]
        fn mul_add<const EXACT: bool>(self, a: __m128, b: __m128, c: __m128) -> __m128 {
            with!(_mm_fmadd_ps(a, b, c))
        }
        #[inline(always)]
        fn mask_f32(self, a: __m128, mask: __m128i) -> __m128 {
            with!(_mm_and_ps(a, _mm_castsi128_ps(mask)))
        }
        #[inline(always)]
        fn minus_f32(self, a: __m128) -> __m128 {
            with!(_mm_xor_ps(_mm_set1_ps(-0.0), a))
        }
        #[inline(always)]
        fn sign_f32(self, a: __m128, b: __m128) -> __m128 {
            with!(_mm_or_ps(a, _mm_and_ps(_mm_set1_ps(-0.0), b)))
        }
        #[inline(always)]
        fn max_f32(self, a: __m128, b: __m128) -> __m128 {
            with!(_mm_max_ps(a, b))
        }
        #[inline(always)]
        fn highest(self, a: __m128) -> __m128 {
            with!({
                let xy = _mm_max_ps(a, _mm_shuffle_ps::<0b01_01_00_01>(a, a));
                _mm_max_ps(_mm_shuffle_ps::<0>(xy, xy), _mm_shuffle_ps::<0b10_10_10_10>(a, a))
            })
        }
        #[inline(always)]
        fn abs_f32(self, a: __m128) -> __m128 {
            with!(_mm_andnot_ps(_mm_set1_ps(-0.0), a))
        }
        #[inline(always)]
        fn lowest(self, a: __m128) -> __m128 {
            // As integers, which takes a quarter of the time.
            with!({
                let a = _mm_castps_si128(a);
                let xy_z = _mm_min_epi32(a, _mm_shuffle_epi32::<0b10_10_00_01>(a));
                let xyz = _mm_min_epi32(xy_z, _mm_shuffle_epi32::<0b00_00_10_10>(xy_z));
                _mm_castsi128_ps(xyz)
            })
        }
        #[inline(always)]
        fn first(self, a: __m128) -> f32 {
            with!(_mm_cvtss_f32(a))
        }
        #[inline(always)]
        fn truncate(self, a: __m128) -> __m128i {
            with!(_mm_cvttps_epi32(a))
        }
        #[inline(always)]
        fn equal(self, a: __m128, b: __m128) -> __m128i {
            with!(_mm_castps_si128(_mm_cmpeq_ps(a, b)))
        }
        #[inline(always)]
        fn permute(self, a: __m128, order: &[i32; 4]) -> __m128 {
            with!(_mm_permutevar_ps(a, _mm_loadu_si128(order.as_ptr().cast())))
        }
        #[inline(always)]
        fn signs(self, a: __m128) -> u32 {
            with!(_mm_movemask_ps(a)) as u32 & 7
        }
        #[inline(always)]
        fn all_below(self, a: __m128, b: f32) -> bool {
            with!({
                let size = _mm_andnot_ps(_mm_set1_ps(-0.0), a);
                _mm_movemask_ps(_mm_cmplt_ps(size, _mm_set1_ps(b))) & 7 == 7
            })
        }
        #[inline(always)]
        fn all_finite(self, a: __m128) -> bool {
            with!({
                let size = _mm_andnot_ps(_mm_set1_ps(-0.0), a);
                let finite = _mm_cmplt_ps(size, _mm_set1_ps(f32::INFINITY));
                _mm_movemask_ps(finite) == 15
            })
        }
        #[inline(always)]
        fn same(self, a: __m128, b: __m128) -> u32 {
            with!(_mm_movemask_ps(_mm_cmpeq_ps(a, b))) as u32
        }
        #[inline(always)]
        fn equals(self, a: __m128, b: __m128) -> u32 {
            with!(_mm_movemask_ps(_mm_cmpeq_ps(a, b))) as u32 & 7
        }

        #[inline(always)]
        fn load_i32(self, a: &[i32; 4]) -> __m128i {
            with!(_mm_loadu_si128(a.as_ptr().cast()))
        }
        #[inline(always)]
        fn load_u32(self, a: &[u32; 4]) -> __m128i {
            with!(_mm_loadu_si128(a.as_ptr().cast()))
        }
        #[inline(always)]
        fn splat_i32(self, a: i32) -> __m128i {
            with!(_mm_set1_epi32(a))
        }
        #[inline(always)]
        fn load_u16(self, a: &[u16; 4]) -> __m128i {
            with!(_mm_cvtepu16_epi32(_mm_loadl_epi64(a.as_ptr().cast())))
        }
        #[inline(always)]
        fn array(self, a: __m128i) -> [i32; 4] {
            with!([
                _mm_cvtsi128_si32(a),
                _mm_extract_epi32::<1>(a),
                _mm_extract_epi32::<2>(a),
                _mm_extract_epi32::<3>(a),
            ])
        }
        #[inline(always)]
        fn add(self, a: __m128i, b: __m128i) -> __m128i {
            with!(_mm_add_epi32(a, b))
        }
        #[inline(always)]
        fn sub(self, a: __m128i, b: __m128i) -> __m128i {
            with!(_mm_sub_epi32(a, b))
        }
        #[inline(always)]
        fn and(self, a: __m128i, b: __m128i) -> __m128i {
            with!(_mm_and_si128(a, b))
        }
        #[inline(always)]
        fn xor(self, a: __m128i, b: __m128i) -> __m128i {
            with!(_mm_xor_si128(a, b))
        }
        #[inline(always)]
        fn min(self, a: __m128i, b: __m128i) -> __m128i {
            with!(_mm_min_epi32(a, b))
        }
        #[inline(always)]
        fn max(self, a: __m128i, b: __m128i) -> __m128i {
            with!(_mm_max_epi32(a, b))
        }
        #[inline(always)]
        fn select(self, mask: __m128i, a: __m128i, b: __m128i) -> __m128i {
            with!(_mm_or_si128(_mm_andnot_si128(mask, a), _mm_and_si128(mask, b)))
        }
        #[inline(always)]
        fn shift_right(self, a: __m128i, by: __m128i) -> __m128i {
            with!(_mm_srlv_epi32(a, _mm_and_si128(by, _mm_set1_epi32(31))))
        }
        #[inline(always)]
        fn any_greater(self, a: __m128i, b: __m128i) -> bool {
            with!(_mm_movemask_ps(_mm_castsi128_ps(_mm_cmpgt_epi32(a, b)))) & 7 != 0
        }
    };
}
pub(super) use four_lanes;
