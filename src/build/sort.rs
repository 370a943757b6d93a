//! The sorts of whatever a hierarchy's passes sort: the library's is large, and each key of a
//! type of its own would be one copy more of it.

/// Sorts numbers by keys that differ, or among which the order does not matter.
pub fn by_key(numbers: &mut [u32], key: &dyn Fn(u32) -> u64) {
    numbers.sort_unstable_by_key(|&n| key(n));
}

/// Sorts pairs, with a heap (Williams 1964).
pub fn pairs(pairs: &mut [[u32; 2]]) {
    for root in (0..pairs.len() / 2).rev() {
        sift(pairs, root);
    }
    for end in (1..pairs.len()).rev() {
        pairs.swap(0, end);
        sift(&mut pairs[..end], 0);
    }
}

/// Moves a pair down until none below it in the heap is greater.
fn sift(heap: &mut [[u32; 2]], mut at: usize) {
    loop {
        let mut child = 2 * at + 1;
        if child + 1 < heap.len() && heap[child] < heap[child + 1] {
            child += 1;
        }
        if child >= heap.len() || heap[child] <= heap[at] {
            return;
        }
        heap.swap(at, child);
        at = child;
    }
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    #[test]
    fn pairs_in_order() {
        let number = |i: u32| i.wrapping_mul(2_654_435_761) >> 20 & 63;
        for len in (0..40).chain([1000]) {
            let mut pairs: Vec<[u32; 2]> = (0..len).map(|i| [number(i), number(i + 7)]).collect();
            let mut expected = pairs.clone();
            expected.sort_unstable();
            super::pairs(&mut pairs);
            assert_eq!(pairs, expected);
        }
    }
}
