//! What stands between a panic, or overlapping memory, and C.

use super::types::{HUG_ERROR_INTERNAL, HUG_OK, hug_status};
use crate::Error;

/// Runs `f`; its error, or a panic where panics unwind, becomes a status.
pub fn guard(f: impl FnOnce() -> Result<(), Error>) -> hug_status {
    match caught(f) {
        Ok(Ok(())) => HUG_OK,
        Ok(Err(error)) => error as hug_status,
        Err(()) => HUG_ERROR_INTERNAL,
    }
}

/// Runs `f` and stops its panic, where panics unwind.
#[cfg(feature = "std")]
pub fn caught<R>(f: impl FnOnce() -> R) -> Result<R, ()> {
    // What a panic leaves behind is scratch memory, which is freed, and an out
    // pointer, which is still NULL.
    std::panic::catch_unwind(std::panic::AssertUnwindSafe(f)).map_err(|_| ())
}

/// Without `std` a panic does not unwind: the panic handler ends it.
#[cfg(not(feature = "std"))]
#[allow(clippy::unnecessary_wraps)]
pub fn caught<R>(f: impl FnOnce() -> R) -> Result<R, ()> {
    Ok(f())
}

/// Whether two blocks of memory share a byte.
pub fn overlap(a: usize, a_len: usize, b: usize, b_len: usize) -> Result<bool, Error> {
    let a_end = a.checked_add(a_len).ok_or(Error::Overflow)?;
    let b_end = b.checked_add(b_len).ok_or(Error::Overflow)?;
    Ok(a_len > 0 && b_len > 0 && a < b_end && b < a_end)
}
