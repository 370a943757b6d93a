//! One split: where to cut some boxes in two.

use super::binary::surface;
use super::item::Item;
use glam::Vec3A;

/// Some items that lie together: their box, and that of their centres, twice as large.
#[derive(Clone, Copy)]
pub struct Part {
    pub lo: Vec3A,
    pub hi: Vec3A,
    first: Vec3A,
    last: Vec3A,
    pub len: usize,
}

impl Part {
    /// No items.
    pub const EMPTY: Self = Self {
        lo: Vec3A::INFINITY,
        hi: Vec3A::NEG_INFINITY,
        first: Vec3A::INFINITY,
        last: Vec3A::NEG_INFINITY,
        len: 0,
    };

    pub fn of(items: &[Item]) -> Self {
        let mut part = Self::EMPTY;
        items.iter().for_each(|item| part.add(item));
        part
    }

    #[inline(always)]
    fn add(&mut self, item: &Item) {
        let (lo, hi) = item.corners();
        let centre = lo + hi;
        *self = Self {
            lo: self.lo.min(lo),
            hi: self.hi.max(hi),
            first: self.first.min(centre),
            last: self.last.max(centre),
            len: self.len + 1,
        };
    }
}

/// The items whose centres lie in a stretch of an axis: their box.
#[derive(Clone, Copy)]
struct Bin {
    lo: Vec3A,
    hi: Vec3A,
    len: u32,
}

impl Bin {
    const EMPTY: Self = Self { lo: Vec3A::INFINITY, hi: Vec3A::NEG_INFINITY, len: 0 };

    #[inline(always)]
    fn add(&mut self, item: &Item) {
        let (lo, hi) = item.corners();
        *self = Self { lo: self.lo.min(lo), hi: self.hi.max(hi), len: self.len + 1 };
    }

    #[inline(always)]
    fn join(&mut self, other: &Self) {
        let len = self.len + other.len;
        *self = Self { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi), len };
    }

    /// What it costs to meet the triangles, some of it whatever their number, times the chance
    /// to come there.
    #[inline(always)]
    fn cost(&self) -> f32 {
        if self.len == 0 {
            f32::INFINITY
        } else {
            surface(self.lo, self.hi) * (self.len + 3) as f32
        }
    }
}

/// Most bins.
const BINS: usize = 16;

/// Room for the bins of three axes, whatever they hold.
pub struct Bins([[Bin; BINS]; 3]);

impl Bins {
    pub fn new() -> Self {
        Self([[Bin::EMPTY; BINS]; 3])
    }
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
        let (lo, hi) = item.corners();
        let at = ((lo + hi - self.low) * self.scale).min(self.last);
        // Not negative and small: the low bits of a sum are the number, rounded; half is taken
        // off before.
        const WHOLE: f32 = 1.5 * (1 << 23) as f32;
        let bits = (at - 0.5 + WHOLE).max(Vec3A::splat(WHOLE)).to_array();
        bits.map(|x| x.to_bits() as usize % BINS)
    }
}

/// Cuts the items of a part, more than one, in two that are not empty: at the cheapest border of
/// bins or, where there is none or it is not to be looked for, in the middle.
pub fn split(items: &mut [Item], part: &Part, look: bool, bins: &mut Bins) -> [Part; 2] {
    match look.then(|| cheapest(items, part, bins)).flatten() {
        Some((binning, axis, border)) => apart(items, &binning, axis, border),
        None => {
            let (a, b) = items.split_at(items.len() / 2);
            [Part::of(a), Part::of(b)]
        }
    }
}

/// The cheapest split: its axis and the last bin before it.
#[inline(never)]
fn cheapest(
    items: &[Item],
    part: &Part,
    Bins(filled): &mut Bins,
) -> Option<(Binning, usize, usize)> {
    // Fewer bins for fewer items: what is done for a bin would take longer than the items.
    let bins = BINS.min(3 + items.len() / 8);
    let extent = part.last - part.first;
    // An axis without extent has a single bin, which cannot be split.
    let scale = Vec3A::splat(bins as f32) / extent.max(Vec3A::splat(f32::MIN_POSITIVE));
    let scale = scale.min(Vec3A::splat(f32::MAX));
    let last = Vec3A::splat(bins as f32 - 0.5);
    let binning = Binning { low: part.first, scale, last };
    let mut best = Best { split: None, cost: f32::INFINITY };
    filled.iter_mut().for_each(|axis| axis[..bins].fill(Bin::EMPTY));
    for item in items {
        let [x, y, z] = binning.bins(item);
        filled[0][x].add(item);
        filled[1][y].add(item);
        filled[2][z].add(item);
    }
    for (axis, filled) in filled.iter().enumerate() {
        best.look(&filled[..bins], axis);
    }
    best.split.map(|(axis, border)| (binning, axis, border))
}

/// The best border so far.
struct Best {
    split: Option<(usize, usize)>,
    cost: f32,
}

impl Best {
    /// Looks at the borders between the bins of an axis.
    #[inline(never)]
    fn look(&mut self, filled: &[Bin], axis: usize) {
        let mut behind = [f32::INFINITY; BINS];
        let mut sum = Bin::EMPTY;
        for (cost, bin) in behind.iter_mut().zip(filled).skip(1).rev() {
            sum.join(bin);
            *cost = sum.cost();
        }
        let mut sum = Bin::EMPTY;
        for (i, (bin, behind)) in filled.iter().zip(&behind[1..]).enumerate() {
            sum.join(bin);
            let cost = sum.cost() + behind;
            if cost < self.cost {
                *self = Self { split: Some((axis, i)), cost };
            }
        }
    }
}

/// Moves the items up to a bin before the others.
#[inline(never)]
fn apart(items: &mut [Item], binning: &Binning, axis: usize, border: usize) -> [Part; 2] {
    let (mut a, mut b) = (Part::EMPTY, Part::EMPTY);
    let (mut at, mut end) = (0, items.len());
    while at < end {
        let item = items[at];
        if binning.bins(&item)[axis] <= border {
            a.add(&item);
            at += 1;
        } else {
            b.add(&item);
            end -= 1;
            items.swap(at, end);
        }
    }
    [a, b]
}
