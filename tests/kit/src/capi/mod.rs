//! The C functions of `include/hug_kit.h`, which documents them.
#![allow(unsafe_code)]

mod arbiter;
mod rays;
mod scenes;

use core::ffi::{CStr, c_char};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// What a C function answers when it cannot do its work.
#[derive(Clone, Copy, Debug)]
enum Error {
    Null = 1,
    Name = 2,
    Range = 3,
    Capacity = 4,
    Soup = 5,
    Internal = 6,
}

const STATUS_STRINGS: [&CStr; 7] = [
    c"ok",
    c"a required pointer is NULL",
    c"no such scene",
    c"an index, count or enumeration is out of range",
    c"the output array is too small",
    c"a triangle names a vertex that does not exist",
    c"internal error in the kit",
];

/// Runs `body` and turns its outcome, a panic included, into a status.
fn status(body: impl FnOnce() -> Result<(), Error>) -> i32 {
    match catch_unwind(AssertUnwindSafe(body)) {
        Ok(Ok(())) => 0,
        Ok(Err(error)) => error as i32,
        Err(_) => Error::Internal as i32,
    }
}

/// Like [`status`] for functions that return a value, with `default` in place of an error.
fn value<T>(default: T, body: impl FnOnce() -> Option<T>) -> T {
    catch_unwind(AssertUnwindSafe(body)).ok().flatten().unwrap_or(default)
}

/// # Safety
/// `pointer` is NULL or valid for reads for `'a`.
unsafe fn input<'a, T>(pointer: *const T) -> Result<&'a T, Error> {
    // SAFETY: the caller's promise.
    unsafe { pointer.as_ref() }.ok_or(Error::Null)
}

/// # Safety
/// `pointer` is NULL or valid for reads of `n` values for `'a`.
unsafe fn inputs<'a, T>(pointer: *const T, n: usize) -> Result<&'a [T], Error> {
    if n == 0 {
        return Ok(&[]);
    }
    if pointer.is_null() {
        return Err(Error::Null);
    }
    if n > isize::MAX as usize / size_of::<T>() {
        return Err(Error::Range);
    }
    // SAFETY: not NULL, no longer than an object can be; the rest is the caller's promise.
    Ok(unsafe { core::slice::from_raw_parts(pointer, n) })
}

/// # Safety
/// `pointer` is NULL or valid for a write.
unsafe fn output<T>(pointer: *mut T, value: T) -> Result<(), Error> {
    if pointer.is_null() {
        return Err(Error::Null);
    }
    // SAFETY: not NULL; the rest is the caller's promise.
    unsafe { pointer.write(value) };
    Ok(())
}

/// Writes as many `items` as fit and reports how many there are; more than `capacity` is an error.
///
/// # Safety
/// `out` is NULL or valid for writes of `capacity` values, `written` NULL or valid for a write.
unsafe fn outputs<T>(
    out: *mut T,
    capacity: usize,
    written: *mut usize,
    items: impl Iterator<Item = T>,
) -> Result<(), Error> {
    if out.is_null() || written.is_null() {
        return Err(Error::Null);
    }
    let mut count = 0;
    for item in items {
        if count < capacity {
            // SAFETY: not NULL and below the capacity the caller promised.
            unsafe { out.add(count).write(item) };
        }
        count += 1;
    }
    // SAFETY: not NULL; the rest is the caller's promise.
    unsafe { written.write(count) };
    if count > capacity {
        return Err(Error::Capacity);
    }
    Ok(())
}

/// The words for a status.
#[unsafe(no_mangle)]
pub extern "C" fn kit_status_string(status: i32) -> *const c_char {
    usize::try_from(status)
        .ok()
        .and_then(|i| STATUS_STRINGS.get(i))
        .unwrap_or(&c"unknown status")
        .as_ptr()
}
