//! Two `f64` side by side, as every x86-64 and AArch64 has them in one register; what
//! `triangle` estimates with. Written out, because compilers shuffle arrays of two
//! more than they compute with them.
//!
//! # Safety
//! The intrinsics need SSE2 or NEON, which the target has.

/// Wraps intrinsics; see the module on why they are there.
#[cfg(any(
    all(target_arch = "x86_64", target_feature = "sse2"),
    all(target_arch = "aarch64", target_feature = "neon")
))]
macro_rules! with {
    ($e:expr) => {
        // SAFETY: the target has SSE2 or NEON.
        unsafe { $e }
    };
}

#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
mod imp {
    use core::arch::x86_64::*;

    #[derive(Clone, Copy)]
    pub struct Pair(__m128d);

    impl Pair {
        #[inline(always)]
        pub fn widen(a: f32, b: f32) -> Self {
            Self(with!(_mm_cvtps_pd(_mm_setr_ps(a, b, 0.0, 0.0))))
        }
        #[inline(always)]
        pub fn splat(a: f64) -> Self {
            Self(with!(_mm_set1_pd(a)))
        }
        #[inline(always)]
        pub fn add(self, b: Self) -> Self {
            Self(with!(_mm_add_pd(self.0, b.0)))
        }
        #[inline(always)]
        pub fn sub(self, b: Self) -> Self {
            Self(with!(_mm_sub_pd(self.0, b.0)))
        }
        #[inline(always)]
        pub fn mul(self, b: Self) -> Self {
            Self(with!(_mm_mul_pd(self.0, b.0)))
        }
        #[inline(always)]
        pub fn max(self, b: Self) -> Self {
            Self(with!(_mm_max_pd(self.0, b.0)))
        }
        #[inline(always)]
        pub fn abs(self) -> Self {
            Self(with!(_mm_andnot_pd(_mm_set1_pd(-0.0), self.0)))
        }
        #[inline(always)]
        pub fn swap(self) -> Self {
            Self(with!(_mm_shuffle_pd::<1>(self.0, self.0)))
        }
        #[inline(always)]
        pub fn first(self) -> f64 {
            with!(_mm_cvtsd_f64(self.0))
        }
        #[inline(always)]
        pub fn second(self) -> f64 {
            with!(_mm_cvtsd_f64(_mm_unpackhi_pd(self.0, self.0)))
        }
    }
}

#[cfg(all(target_arch = "aarch64", target_feature = "neon"))]
mod imp {
    use core::arch::aarch64::*;

    #[derive(Clone, Copy)]
    pub struct Pair(float64x2_t);

    impl Pair {
        #[inline(always)]
        pub fn widen(a: f32, b: f32) -> Self {
            Self(with!(vcvt_f64_f32(vset_lane_f32::<1>(b, vdup_n_f32(a)))))
        }
        #[inline(always)]
        pub fn splat(a: f64) -> Self {
            Self(with!(vdupq_n_f64(a)))
        }
        #[inline(always)]
        pub fn add(self, b: Self) -> Self {
            Self(with!(vaddq_f64(self.0, b.0)))
        }
        #[inline(always)]
        pub fn sub(self, b: Self) -> Self {
            Self(with!(vsubq_f64(self.0, b.0)))
        }
        #[inline(always)]
        pub fn mul(self, b: Self) -> Self {
            Self(with!(vmulq_f64(self.0, b.0)))
        }
        #[inline(always)]
        pub fn max(self, b: Self) -> Self {
            Self(with!(vmaxq_f64(self.0, b.0)))
        }
        #[inline(always)]
        pub fn abs(self) -> Self {
            Self(with!(vabsq_f64(self.0)))
        }
        #[inline(always)]
        pub fn swap(self) -> Self {
            Self(with!(vextq_f64::<1>(self.0, self.0)))
        }
        #[inline(always)]
        pub fn first(self) -> f64 {
            with!(vgetq_lane_f64::<0>(self.0))
        }
        #[inline(always)]
        pub fn second(self) -> f64 {
            with!(vgetq_lane_f64::<1>(self.0))
        }
    }
}

#[cfg(not(any(
    all(target_arch = "x86_64", target_feature = "sse2"),
    all(target_arch = "aarch64", target_feature = "neon")
)))]
mod imp {
    #[derive(Clone, Copy)]
    pub struct Pair(f64, f64);

    impl Pair {
        #[inline(always)]
        pub fn widen(a: f32, b: f32) -> Self {
            Self(a.into(), b.into())
        }
        #[inline(always)]
        pub fn splat(a: f64) -> Self {
            Self(a, a)
        }
        #[inline(always)]
        pub fn add(self, b: Self) -> Self {
            Self(self.0 + b.0, self.1 + b.1)
        }
        #[inline(always)]
        pub fn sub(self, b: Self) -> Self {
            Self(self.0 - b.0, self.1 - b.1)
        }
        #[inline(always)]
        pub fn mul(self, b: Self) -> Self {
            Self(self.0 * b.0, self.1 * b.1)
        }
        #[inline(always)]
        pub fn max(self, b: Self) -> Self {
            let max = |a: f64, b: f64| if a > b { a } else { b };
            Self(max(self.0, b.0), max(self.1, b.1))
        }
        #[inline(always)]
        pub fn abs(self) -> Self {
            Self(self.0.abs(), self.1.abs())
        }
        #[inline(always)]
        pub fn swap(self) -> Self {
            Self(self.1, self.0)
        }
        #[inline(always)]
        pub fn first(self) -> f64 {
            self.0
        }
        #[inline(always)]
        pub fn second(self) -> f64 {
            self.1
        }
    }
}

pub(crate) use imp::Pair;
