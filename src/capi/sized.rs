//! Structs that grow from version to version: each begins with its size, as its
//! caller's header knows it.

use core::mem::MaybeUninit;

use crate::Error;

/// Larger than any struct will ever be: a size beyond is a mistake.
const MAX: usize = 4096;

/// Reads a struct of at least `first` bytes, its size in its first version. Fields
/// that the caller's header lacks are zeros; fields that this library does not know
/// must be zeros.
///
/// # Safety
/// `from` is NULL or readable for the size it begins with, and zeros are a value of
/// `T`, which begins with a `usize`.
pub unsafe fn read<T>(from: *const T, first: usize) -> Result<T, Error> {
    if from.is_null() {
        return Err(Error::Null);
    }
    if !from.is_aligned() {
        return Err(Error::Alignment);
    }
    // SAFETY: by the caller.
    let size = unsafe { from.cast::<usize>().read() };
    if !(first..=MAX).contains(&size) || !size.is_multiple_of(align_of_val(&size)) {
        return Err(Error::StructSize);
    }
    let known = size.min(size_of::<T>());
    let mut to = MaybeUninit::<T>::zeroed();
    // SAFETY: the caller vouches for `size` bytes and for zeros.
    let (to, tail) = unsafe {
        to.as_mut_ptr().cast::<u8>().copy_from_nonoverlapping(from.cast(), known);
        let bytes = core::slice::from_raw_parts(from.cast::<u8>(), size);
        (to.assume_init(), &bytes[known..])
    };
    if tail.iter().any(|&b| b != 0) { Err(Error::StructSize) } else { Ok(to) }
}
