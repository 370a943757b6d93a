//! Lanes on x86-64: AVX2 with FMA, and AVX-512 for its registers and comparisons.
//!
//! # Safety
//! The intrinsics are sound because a value of [`Avx2`] or [`Avx512`] exists only
//! after `detect` found the instructions, in this call or an earlier one of the
//! process; loads go through references, or gather from an array whose length is a power of two at
//! places modulo that.

mod avx2;
mod avx512;
mod eight;
mod four;
mod shell;

pub use avx2::Avx2;
pub use avx512::Avx512;
use eight::eight_lanes;
use four::four_lanes;
use shell::shell;

/// Wraps intrinsics; see the module on why they are there.
macro_rules! with {
    ($e:expr) => {
        // SAFETY: `self` proves that the instructions are there.
        unsafe { $e }
    };
}
use with;
