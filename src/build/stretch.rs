//! The voxels of a long row that pass a test, without asking each of them.
//!
//! Every part of the overlap tests compares a rounded linear function of the voxel's
//! number with a bound. Rounding keeps order, so each part lets through all voxels from
//! some place on, or all up to some place, and what passes all parts is a stretch whose
//! ends a search by halves finds: exactly the voxels that asking each would give.

/// Rows of at most so many voxels are looked at voxel by voxel.
pub const LONG: u32 = 64;

/// The voxels of `first..=last` that pass, as first and end. `pass`: whether a voxel
/// passes the parts that let through all from some place on, and the others.
#[inline(always)]
pub fn stretch(first: u32, last: u32, pass: impl Fn(u32) -> [bool; 2]) -> [u32; 2] {
    let search = |side: usize, until: bool| {
        let (mut from, mut to) = (first, last + 1);
        while from < to {
            let middle = from + (to - from) / 2;
            if pass(middle)[side] == until { to = middle } else { from = middle + 1 }
        }
        from
    };
    [search(0, true), search(1, false)]
}

#[cfg(test)]
mod tests {
    use super::{LONG, stretch};
    use core::cell::Cell;

    /// Lines rounded in `f32`, of any slope, that let through any part of a row.
    #[test]
    fn finds_what_asking_each_finds() {
        let lines = [-3.0e8f32, -17.3, -1.0, -1e-3, -1e-30, 0.0, 1e-38, 0.1, 1.0, 2.5, 4e9];
        let (mut all, mut some) = (0, 0);
        for (a, b) in lines.into_iter().flat_map(|a| lines.map(|b| (a, b))) {
            for at in [0.0f32, 3.0, 70.0, 512.5, 1500.0, 2047.0, 9000.0] {
                // a (x - at) <= 7 and b (x - at) <= 5, as the tests have it.
                let line = |m: f32, c: f32, x: u32| m * x as f32 - m * at <= c;
                let calls = Cell::new(0);
                let pass = |x: u32| {
                    calls.set(calls.get() + 1);
                    let mut parts = [true; 2];
                    parts[usize::from(a >= 0.0)] &= line(a, 7.0, x);
                    parts[usize::from(b >= 0.0)] &= line(b, 5.0, x);
                    parts
                };
                let [first, end] = stretch(5, 2047, pass);
                assert!(calls.get() <= 24, "{} questions", calls.get());
                for x in 5..=2047 {
                    let expected = line(a, 7.0, x) && line(b, 5.0, x);
                    assert_eq!((first..end).contains(&x), expected, "{a}, {b}, {at}: {x}");
                    all += 1;
                    some += u32::from(expected);
                }
            }
        }
        assert!(some > all / 10 && some < all * 9 / 10, "{some} of {all}");
        const { assert!(LONG >= 24) };
    }
}
