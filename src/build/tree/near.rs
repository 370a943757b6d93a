//! With which of its neighbours along the curve a box makes the one of least surface.

use super::rows::Seen;
use crate::simd::{AnyKernel, Isa, Lanes, dispatch};

/// Neighbours that are looked at on either side.
pub const REACH: usize = 8;

/// By what surfaces are multiplied, a number for each place of the lower box: of pairs that are alike,
/// as in a regular mesh, one is least then, and others beside it are, too. Of a chain of boxes each of
/// which would go with the one before, only the first two could be joined.
static NOISE: [f32; NOISES + 8] = {
    let (mut noise, mut i) = ([0.0; NOISES + 8], 0);
    while i < noise.len() {
        let hash = ((i % NOISES) as u32).wrapping_mul(2_654_435_761) >> 24;
        noise[i] = 1.0 + hash as f32 / (1 << 15) as f32;
        i += 1;
    }
    noise
};
const NOISES: usize = 64;

/// Finds it for the boxes from `first` on, as many as `to`; two at least are seen. Of equal ones it
/// is the first.
pub fn nearest(seen: &Seen<'_>, first: usize, to: &mut [u32]) {
    dispatch(Nearest { seen, first, to });
}

struct Nearest<'a> {
    seen: &'a Seen<'a>,
    first: usize,
    to: &'a mut [u32],
}

/// Boxes in a row whose neighbours are found together.
const GROUP: usize = 8;

/// A group and its neighbours, and as many more as may be loaded with these.
type Window = [f32; GROUP + 3 * REACH];

impl AnyKernel for Nearest<'_> {
    type Out = ();
    const BEST: Isa = Isa::Avx2;
    #[inline(always)]
    fn run_on<L: Lanes>(self, l: L) {
        let Self { seen, first, to } = self;
        for (i, to) in (first..).step_by(GROUP).zip(to.chunks_mut(GROUP)) {
            let begin = i.wrapping_sub(REACH);
            let end = begin.wrapping_add(size_of::<Window>() / 4);
            let inner = begin < end && end <= seen.ids.len();
            let edges;
            let rows = if inner {
                each_row(|k| window(seen.bounds[k], begin))
            } else {
                edges = edge(seen, i);
                each_row(|k| &edges[k])
            };
            several(l, rows, i, to);
        }
    }
}

#[inline(always)]
fn each_row<T>(row: impl Fn(usize) -> T) -> [T; 6] {
    [row(0), row(1), row(2), row(3), row(4), row(5)]
}

#[inline(always)]
fn window(row: &[f32], at: usize) -> &Window {
    const NONE: &Window = &[0.0; size_of::<Window>() / 4];
    debug_assert!(at + NONE.len() <= row.len());
    row[at..].first_chunk().unwrap_or(NONE)
}

/// Windows at the ends of the rows: where there is no box, one with which nothing is joined.
#[inline(never)]
fn edge(seen: &Seen<'_>, i: usize) -> [Window; 6] {
    const FAR: f32 = 1e12;
    let mut windows = [[-FAR; size_of::<Window>() / 4]; 6];
    let first = i.saturating_sub(REACH);
    for (k, (window, row)) in windows.iter_mut().zip(seen.bounds).enumerate() {
        if k >= 3 {
            window.fill(FAR);
        }
        for (to, from) in window[first + REACH - i..].iter_mut().zip(&row[first..]) {
            *to = *from;
        }
    }
    windows
}

/// The boxes of a group from `i` on; there may be fewer than that.
#[inline(always)]
fn several<L: Lanes>(l: L, rows: [&Window; 6], i: usize, to: &mut [u32]) {
    for part in (0..GROUP).step_by(L::WIDE) {
        let own = columns(l, rows, REACH + part);
        let mut best = (l.splat_wide(f32::INFINITY), l.splat_wide(0.0));
        for at in 0..=2 * REACH {
            if at != REACH {
                let lower = i + part + NOISES - REACH + at.min(REACH);
                let noise = l.load_wide(from(&NOISE, lower % NOISES));
                best = better(l, best, own, columns(l, rows, part + at), noise, at);
            }
        }
        let mut offsets = [0.0; 8];
        l.store_wide(best.1, &mut offsets);
        for (lane, to) in to.iter_mut().skip(part).take(L::WIDE).enumerate() {
            *to = (i + part + lane) as u32 + offsets[lane] as u32 - REACH as u32;
        }
    }
}

#[inline(always)]
fn from(row: &[f32], at: usize) -> &[f32; 8] {
    debug_assert!(at + 8 <= row.len());
    row[at..].first_chunk().unwrap_or(&[0.0; 8])
}

/// Bounds of boxes in lanes, from that place in the window on.
#[inline(always)]
fn columns<L: Lanes>(l: L, rows: [&Window; 6], at: usize) -> [[L::Wide; 3]; 2] {
    let lo = each!(k => l.load_wide(from(rows[k], at)));
    [lo, each!(k => l.load_wide(from(rows[3 + k], at)))]
}

/// The better of what was found and other boxes, at that place in the window.
#[inline(always)]
fn better<L: Lanes>(
    l: L,
    (best, found): (L::Wide, L::Wide),
    [lo, hi]: [[L::Wide; 3]; 2],
    [a, b]: [[L::Wide; 3]; 2],
    noise: L::Wide,
    at: usize,
) -> (L::Wide, L::Wide) {
    let [x, y, z] = each!(k => l.sub_wide(l.max_wide(hi[k], b[k]), l.min_wide(lo[k], a[k])));
    let size = l.add_wide(l.mul_wide(x, y), l.mul_wide(y, z));
    let size = l.mul_wide(l.add_wide(size, l.mul_wide(z, x)), noise);
    let found = l.choose_wide(best, size, found, l.splat_wide(at as f32));
    (l.min_wide(best, size), found)
}

#[cfg(test)]
mod tests {
    use super::super::rows::{Rows, WORDS, union};
    use super::*;
    use crate::simd::Portable;
    use std::{vec, vec::Vec};

    /// That of one box.
    fn one(seen: &Seen<'_>, i: usize) -> u32 {
        let own = seen.bounds(i);
        let (mut best, mut nearest) = (f32::INFINITY, i);
        for j in i.saturating_sub(REACH)..seen.ids.len().min(i + REACH + 1) {
            if j != i {
                let [a, b, c, d, e, f] = union(own, seen.bounds(j));
                let [x, y, z] = [d - a, e - b, f - c];
                let size = (x * y + y * z + z * x) * NOISE[i.min(j) % NOISES];
                if size < best {
                    (best, nearest) = (size, j);
                }
            }
        }
        nearest as u32
    }

    /// Whatever the instruction set, and wherever a part begins.
    #[test]
    fn one_by_one_and_eight_at_once() {
        const COUNT: usize = 300;
        let mut words = vec![0; WORDS * COUNT];
        let mut rows = Rows::new(&mut words);
        for i in 0..COUNT {
            let hash = |k: usize| ((i * 6 + k) as u32).wrapping_mul(2_654_435_761);
            // Many are alike.
            let x = |k: usize| (hash(k) >> 30) as f32;
            let size = |k: usize| (hash(k) >> 31) as f32;
            let [a, b, c] = [x(0), x(1), x(2)];
            let bounds = [a, b, c, a + size(3), b + size(4), c + size(5)];
            rows.set(i, bounds, [0, 1]);
        }
        for count in [2, 9, 16, 17, 40, COUNT] {
            let seen = rows.seen(count);
            let all: Vec<u32> = (0..count).map(|i| one(&seen, i)).collect();
            for first in [0, 1, count / 2] {
                let mut found = vec![0; count - first];
                nearest(&seen, first, &mut found);
                assert_eq!(found, all[first..]);
                found.fill(0);
                Nearest { seen: &seen, first, to: &mut found }.run_on(Portable);
                assert_eq!(found, all[first..]);
            }
            let pairs = (0..count).filter(|&i| all[all[i] as usize] as usize == i).count();
            assert!(pairs > 1 && all.iter().enumerate().all(|(i, &j)| i != j as usize));
        }
    }

    /// Of boxes that are alike, in a row, many pairs are each other's nearest, and not only the
    /// first two.
    #[test]
    fn a_regular_row() {
        const COUNT: usize = 512;
        let mut words = vec![0; WORDS * COUNT];
        let mut rows = Rows::new(&mut words);
        for i in 0..COUNT {
            let at = i as f32 / COUNT as f32;
            rows.set(i, [at, 0.0, 0.0, at + 0.25 / COUNT as f32, 0.125, 0.0], [0, 1]);
        }
        let mut found = vec![0; COUNT];
        nearest(&rows.seen(COUNT), 0, &mut found);
        let paired = (0..COUNT).filter(|&i| found[found[i] as usize] as usize == i).count();
        assert!(paired > COUNT / 2, "{paired}");
    }
}
