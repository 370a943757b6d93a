//! Large pages, for memory of the default allocator.
//!
//! A scene is read all over and a build writes hundreds of megabytes once: with pages of 4 kB
//! much of the time goes to tables of pages. Linux gives large ones to who asks, if it is set
//! to (`/sys/kernel/mm/transparent_hugepage/enabled`: `madvise`, as on most systems).
//!
//! # Safety
//! The advice changes no contents, whatever memory it is given for; refusal is ignored.

/// What is asked for: memory in whole pages of this size, which x86-64 and most AArch64 have.
#[cfg(all(feature = "std", target_os = "linux", not(miri)))]
const LARGE: usize = 2 << 20;

/// Asks for large pages in `size` bytes from `start` on, if some would fit.
#[cfg(all(feature = "std", target_os = "linux", not(miri)))]
pub(crate) fn ask_for_large(start: *const u8, size: usize) {
    use core::ffi::{c_int, c_void};

    const MADV_HUGEPAGE: c_int = 14;
    unsafe extern "C" {
        fn madvise(start: *mut c_void, size: usize, advice: c_int) -> c_int;
    }
    let skip = start.align_offset(LARGE);
    let whole = size.saturating_sub(skip) / LARGE * LARGE;
    if whole > 0 {
        // SAFETY: see the module.
        let _ =
            unsafe { madvise(start.wrapping_add(skip).cast_mut().cast(), whole, MADV_HUGEPAGE) };
    }
}

/// There is nobody to ask.
#[cfg(not(all(feature = "std", target_os = "linux", not(miri))))]
pub(crate) fn ask_for_large(_: *const u8, _: usize) {}
