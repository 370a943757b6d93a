//! One split: where to cut some boxes in two.

use super::item::Item;
use glam::Vec3A;

/// Some items that lie together, and their box.
#[derive(Clone, Copy)]
pub struct Part {
    pub lo: Vec3A,
    pub hi: Vec3A,
    pub len: usize,
}

impl Part {
    /// No items.
    pub const EMPTY: Self = Self { lo: Vec3A::INFINITY, hi: Vec3A::NEG_INFINITY, len: 0 };

    pub fn of(items: &[Item]) -> Self {
        let mut part = Self::EMPTY;
        for item in items {
            part.add(Vec3A::from_array(item.lo), Vec3A::from_array(item.hi));
        }
        part
    }

    #[inline(always)]
    fn add(&mut self, lo: Vec3A, hi: Vec3A) {
        *self = Self { lo: self.lo.min(lo), hi: self.hi.max(hi), len: self.len + 1 };
    }

    #[inline(always)]
    fn join(&mut self, other: &Self) {
        let len = self.len + other.len;
        *self = Self { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi), len };
    }

    /// Half the surface of the box, which is not empty.
    #[inline(always)]
    pub fn surface(&self) -> f32 {
        let side = self.hi - self.lo;
        side.x * side.y + side.y * side.z + side.z * side.x
    }

    /// What it costs to meet the triangles, times the chance to come there.
    #[inline(always)]
    fn cost(&self) -> f32 {
        if self.len == 0 { f32::INFINITY } else { self.surface() * (self.len + 3) as f32 }
    }
}

/// Most bins.
pub const BINS: usize = 32;

/// Twice the centre of a box.
#[inline(always)]
fn centre(item: &Item) -> Vec3A {
    Vec3A::from_array(item.lo) + Vec3A::from_array(item.hi)
}

/// Which bin a centre is in, on each axis.
#[derive(Clone, Copy)]
struct Binning {
    low: Vec3A,
    scale: Vec3A,
    last: Vec3A,
}

impl Binning {
    #[inline(always)]
    fn bins(&self, item: &Item) -> [usize; 3] {
        let at = ((centre(item) - self.low) * self.scale).min(self.last);
        // Not negative and small: the low bits of a sum are the number, rounded; half is taken
        // off before.
        const WHOLE: f32 = 1.5 * (1 << 23) as f32;
        let bits = (at - 0.5 + WHOLE).max(Vec3A::splat(WHOLE)).to_array();
        bits.map(|x| x.to_bits() as usize % BINS)
    }
}

/// Cuts `items`, more than one, in two that are not empty: at the
/// cheapest border of `bins` bins, or halves them where there is none.
pub fn split(items: &mut [Item], bins: usize) -> [Part; 2] {
    match cheapest(items, bins.min(2 * items.len())) {
        Some((binning, axis, border)) => apart(items, &binning, axis, border),
        None => {
            let (a, b) = items.split_at(items.len() / 2);
            [Part::of(a), Part::of(b)]
        }
    }
}

/// The cheapest split: its axis and the last bin before it.
fn cheapest(items: &[Item], bins: usize) -> Option<(Binning, usize, usize)> {
    let (mut low, mut high) = (Vec3A::INFINITY, Vec3A::NEG_INFINITY);
    for item in items {
        let centre = centre(item);
        (low, high) = (low.min(centre), high.max(centre));
    }
    let extent = high - low;
    // An axis without extent has a single bin, which cannot be split.
    let scale = Vec3A::splat(bins as f32) / extent.max(Vec3A::splat(f32::MIN_POSITIVE));
    let scale = scale.min(Vec3A::splat(f32::MAX));
    let last = Vec3A::splat(bins as f32 - 0.5);
    let binning = Binning { low, scale, last };
    let mut filled = [[Part::EMPTY; BINS]; 3];
    for item in items {
        let (lo, hi) = (Vec3A::from_array(item.lo), Vec3A::from_array(item.hi));
        let [x, y, z] = binning.bins(item);
        filled[0][x].add(lo, hi);
        filled[1][y].add(lo, hi);
        filled[2][z].add(lo, hi);
    }
    let (mut best, mut least) = (None, f32::INFINITY);
    for (axis, filled) in filled.iter().enumerate() {
        let mut behind = [f32::INFINITY; BINS];
        let mut sum = Part::EMPTY;
        for i in (1..bins).rev() {
            sum.join(&filled[i]);
            behind[i] = sum.cost();
        }
        let mut sum = Part::EMPTY;
        for i in 0..bins.saturating_sub(1) {
            sum.join(&filled[i]);
            let cost = sum.cost() + behind[i + 1];
            if cost < least {
                (best, least) = (Some((binning, axis, i)), cost);
            }
        }
    }
    best
}

/// Moves the items up to a bin before the others.
fn apart(items: &mut [Item], binning: &Binning, axis: usize, border: usize) -> [Part; 2] {
    let (mut a, mut b) = (Part::EMPTY, Part::EMPTY);
    let (mut at, mut end) = (0, items.len());
    while at < end {
        let item = items[at];
        let (lo, hi) = (Vec3A::from_array(item.lo), Vec3A::from_array(item.hi));
        if binning.bins(&item)[axis] <= border {
            a.add(lo, hi);
            at += 1;
        } else {
            b.add(lo, hi);
            end -= 1;
            items.swap(at, end);
        }
    }
    [a, b]
}
