//! The sorts of whatever a hierarchy's passes sort: the library's is large, and each key of a
//! type of its own would be one copy more of it.

/// Numbers of which each is put in its place among those before it.
const FEW: usize = 16;

/// Sorts numbers by keys that differ, or among which the order does not matter: in parts below and
/// above a key (Hoare 1962), with a heap where parts are again and again of very different sizes
/// (Musser 1997).
pub fn by_key(numbers: &mut [u32], key: &dyn Fn(u32) -> u64) {
    let deep = 2 * (usize::BITS - numbers.len().leading_zeros());
    in_parts(numbers, key, deep);
}

fn in_parts(mut numbers: &mut [u32], key: &dyn Fn(u32) -> u64, mut deep: u32) {
    while numbers.len() > FEW {
        if deep == 0 {
            return with_heap(numbers, &|a, b| key(a) < key(b));
        }
        deep -= 1;
        let last = numbers.len() - 1;
        let [a, b, c] = [0, last / 2, last].map(|i| key(numbers[i]));
        let middle = a.min(b).max(a.max(b).min(c));
        let (mut low, mut high) = (0, last);
        // The key is there: neither end is passed.
        loop {
            while key(numbers[low]) < middle {
                low += 1;
            }
            while key(numbers[high]) > middle {
                high -= 1;
            }
            if low >= high {
                break;
            }
            numbers.swap(low, high);
            (low, high) = (low + 1, high - 1);
        }
        let (below, above) = numbers.split_at_mut(low);
        in_parts(below, key, deep);
        numbers = above;
    }
    for i in 1..numbers.len() {
        let (mut at, number) = (i, numbers[i]);
        let own = key(number);
        while at > 0 && key(numbers[at - 1]) > own {
            numbers[at] = numbers[at - 1];
            at -= 1;
        }
        numbers[at] = number;
    }
}

/// Sorts pairs.
pub fn pairs(pairs: &mut [[u32; 2]]) {
    with_heap(pairs, &|a, b| a < b);
}

/// Whether one comes before another.
type Less<'a, T> = &'a dyn Fn(T, T) -> bool;

/// Sorts with a heap (Williams 1964).
fn with_heap<T: Copy>(all: &mut [T], less: Less<'_, T>) {
    for root in (0..all.len() / 2).rev() {
        sift(all, root, less);
    }
    for end in (1..all.len()).rev() {
        all.swap(0, end);
        sift(&mut all[..end], 0, less);
    }
}

/// Moves one down until none below it in the heap is greater.
fn sift<T: Copy>(heap: &mut [T], mut at: usize, less: Less<'_, T>) {
    loop {
        let mut child = 2 * at + 1;
        if child + 1 < heap.len() && less(heap[child], heap[child + 1]) {
            child += 1;
        }
        if child >= heap.len() || !less(heap[at], heap[child]) {
            return;
        }
        heap.swap(at, child);
        at = child;
    }
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    /// Numbers lying about, in order, the other way round, up and down, and all but a few alike; by
    /// parts, as far as these go, and with a heap.
    #[test]
    fn numbers_by_key() {
        let keys: [fn(u32) -> u64; 5] = [
            |i| u64::from(i.wrapping_mul(2_654_435_761)),
            u64::from,
            |i| u64::from(u32::MAX - i),
            |i| u64::from(i.abs_diff(500)),
            |i| u64::from(i % 7 == 0),
        ];
        for len in (0..40).chain([1000, 4001]) {
            for key in keys {
                for deep in [None, Some(0), Some(3)] {
                    let mut numbers: Vec<u32> = (0..len).collect();
                    match deep {
                        None => super::by_key(&mut numbers, &key),
                        Some(deep) => super::in_parts(&mut numbers, &key, deep),
                    }
                    assert!(numbers.is_sorted_by_key(|&i| key(i)), "{len} {deep:?}");
                    numbers.sort_unstable();
                    assert_eq!(numbers, (0..len).collect::<Vec<_>>());
                }
            }
        }
    }

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
