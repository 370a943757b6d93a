//! The one sort of whatever a hierarchy's passes sort: its code is large, and each key of a
//! type of its own would be one copy more in the library.

/// Sorts numbers by keys that differ, or among which the order does not matter.
pub fn by_key(numbers: &mut [u32], key: &dyn Fn(u32) -> u64) {
    numbers.sort_unstable_by_key(|&n| key(n));
}
