//! Clusters as connected components of the graph of boxes that intersect
//! (Definition 5, section 7.4).
//!
//! The paper lists the pairs that intersect in the plane, tests these along z, and
//! searches the graph depth first: `k'` pairs may be `n^2`, and it pays for them in
//! memory. Here no pair is listed. Two intervals intersect if one holds the lower end of
//! the other, so a segment tree over lower ends, streamed as by Zomorodian & Edelsbrunner
//! (2000), finds along x groups of boxes each of which intersects each of another group,
//! and within those the same along y; what is left is a sweep along z over two groups
//! that intersect in the plane, all with all. The sweep unites sets (union-find), and
//! from those of a group that it has united it keeps the one that reaches farthest.
//!
//! A box is in O(log n) groups along x, in O(log n) along y for each, and a sweep sorts:
//! O(n log^3 n), whatever the boxes, and less where they overlap, since groups of one
//! component are left alone. Memory: three words a triangle, those of the other
//! clustering's parts; the recursion is at most 2 log2 n deep.
//!
//! Without union-find the same search counts the pairs, listing none of them.

use super::control::Control;
use super::scratch::cut;
use super::sort;
use crate::Error;
use crate::aabb::Aabb;
use crate::math::ordered;

/// Groups of at most so many boxes are compared one by one.
const FEW: usize = 12;

/// Splits `order` into clusters by permuting it and calls `found` with it and the range
/// of each. `room` is for three words for each box.
pub fn components(
    order: &mut [u32],
    boxes: &[Aabb],
    room: &mut [u32],
    control: &mut Control<'_>,
    found: &mut dyn FnMut(&[u32], core::ops::Range<usize>),
) -> Result<(), Error> {
    let mut rest = room;
    let parent = cut(&mut rest, boxes.len());
    for (i, parent) in (0..).zip(parent.iter_mut()) {
        *parent = i;
    }
    let mut search = Search { boxes, parent, pairs: Pairs::default(), control, done: 0 };
    search.all(order, rest)?;
    let parent = search.parent;
    for &i in &*order {
        let root = find(parent, i);
        parent[i as usize] = root;
    }
    sort::by_key(order, &|i| u64::from(parent[i as usize]) << 32 | u64::from(i));
    let mut start = 0;
    for same in order.chunk_by(|&a, &b| parent[a as usize] == parent[b as usize]) {
        found(order, start..start + same.len());
        start += same.len();
    }
    Ok(())
}

/// Pairs of boxes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Pairs {
    /// Those that intersect in projection along z.
    pub plane: u64,
    /// Those that intersect.
    pub space: u64,
}

/// Counts the pairs among the boxes named. `room` is for two words for each.
pub fn pairs(
    order: &[u32],
    boxes: &[Aabb],
    room: &mut [u32],
    control: &mut Control<'_>,
) -> Result<Pairs, Error> {
    let mut search = Search { boxes, parent: &mut [], pairs: Pairs::default(), control, done: 0 };
    search.all(order, room)?;
    Ok(search.pairs)
}

/// Moves those that pass to the front; how many there are.
fn partition(objects: &mut [u32], pass: &dyn Fn(u32) -> bool) -> usize {
    let mut count = 0;
    for i in 0..objects.len() {
        if pass(objects[i]) {
            objects.swap(i, count);
            count += 1;
        }
    }
    count
}

fn find(parent: &mut [u32], mut i: u32) -> u32 {
    while parent[i as usize] != i {
        let above = parent[parent[i as usize] as usize];
        parent[i as usize] = above;
        i = above;
    }
    i
}

struct Search<'a, 'c> {
    boxes: &'a [Aabb],
    /// A box of the same component with a lower number, or the box itself; empty if pairs
    /// are counted.
    parent: &'a mut [u32],
    pairs: Pairs,
    control: &'a mut Control<'c>,
    /// Lower ends along x that are done with.
    done: usize,
}

impl Search<'_, '_> {
    fn all(&mut self, order: &[u32], room: &mut [u32]) -> Result<(), Error> {
        let mut rest = room;
        let bars = cut(&mut rest, order.len());
        let ends = cut(&mut rest, order.len());
        bars.copy_from_slice(order);
        ends.copy_from_slice(order);
        self.node(0, bars, ends)
    }

    /// The lower end along an axis. No two are the same, so that of two intervals that
    /// intersect exactly one holds the lower end of the other.
    fn low(&self, axis: usize, i: u32) -> u64 {
        u64::from(ordered(self.boxes[i as usize].lo[axis])) << 32 | u64::from(i)
    }

    fn high(&self, axis: usize, i: u32) -> u64 {
        u64::from(ordered(self.boxes[i as usize].hi[axis])) << 32 | u64::from(u32::MAX)
    }

    fn meet(&self, axis: usize, i: u32, j: u32) -> bool {
        let (a, b) = (&self.boxes[i as usize], &self.boxes[j as usize]);
        a.lo[axis] <= b.hi[axis] && b.lo[axis] <= a.hi[axis]
    }

    /// Finds the pairs of a box of `bars` that holds, along the axis, the lower end of one
    /// of `ends`; along the axes before, all of these intersect all of those.
    fn node(&mut self, axis: usize, bars: &mut [u32], ends: &mut [u32]) -> Result<(), Error> {
        self.control.tick(bars.len() + ends.len(), self.done, self.boxes.len())?;
        let few = bars.len().min(ends.len()) <= FEW;
        if few || self.is_one(bars, ends) {
            if axis == 0 {
                self.done += ends.len();
            }
            if few {
                self.compare(axis, bars, ends);
            }
            return Ok(());
        }
        let (mut first, mut last) = (u64::MAX, 0);
        for &i in &*ends {
            let key = self.low(axis, i);
            (first, last) = (first.min(key), last.max(key));
        }
        // A box's own lower end is not one that it holds.
        let holds_all = |i| self.low(axis, i) < first && last <= self.high(axis, i);
        let count = partition(bars, &holds_all);
        let (all, rest) = bars.split_at_mut(count);
        if axis == 0 {
            self.node(1, all, ends)?;
            self.node(1, ends, all)?;
        } else if count > 0 {
            self.sweep(all, ends);
        }
        let holds_some = |i| self.low(axis, i) < last && first <= self.high(axis, i);
        let count = partition(rest, &holds_some);
        let some = &mut rest[..count];
        let middle = ends.len() / 2;
        let key: &dyn Fn(u32) -> u64 = &|i| self.low(axis, i);
        ends.select_nth_unstable_by_key(middle, |&i| key(i));
        let (left, right) = ends.split_at_mut(middle);
        self.node(axis, some, left)?;
        self.node(axis, some, right)
    }

    /// Whether all are of one component already.
    fn is_one(&mut self, a: &[u32], b: &[u32]) -> bool {
        if self.parent.is_empty() {
            return false;
        }
        let root = find(self.parent, a[0]);
        a.iter().chain(b).all(|&i| find(self.parent, i) == root)
    }

    /// [`Search::node`] for few boxes.
    fn compare(&mut self, axis: usize, bars: &[u32], ends: &[u32]) {
        for &i in bars {
            let (low, high) = (self.low(axis, i), self.high(axis, i));
            for &j in ends {
                let end = self.low(axis, j);
                if low < end && end <= high && (axis == 1 || self.meet(1, i, j)) {
                    self.meet_in_plane(i, j);
                }
            }
        }
    }

    fn meet_in_plane(&mut self, i: u32, j: u32) {
        let met = self.meet(2, i, j);
        if !self.parent.is_empty() {
            if met {
                self.unite(i, j);
            }
            return;
        }
        self.pairs.plane += 1;
        self.pairs.space += u64::from(met);
    }

    fn unite(&mut self, i: u32, j: u32) {
        let (a, b) = (find(self.parent, i), find(self.parent, j));
        self.parent[a.max(b) as usize] = a.min(b);
    }

    /// Pairs of two groups that intersect in the plane, all with all.
    fn sweep(&mut self, a: &mut [u32], b: &mut [u32]) {
        if a.len().min(b.len()) <= FEW {
            for &i in &*a {
                for &j in &*b {
                    self.meet_in_plane(i, j);
                }
            }
        } else if self.parent.is_empty() {
            let all = a.len() as u64 * b.len() as u64;
            self.pairs.plane += all;
            self.pairs.space += all - self.below(a, b) - self.below(b, a);
        } else {
            self.sweep_united(a, b);
        }
    }

    /// Pairs of which the first ends, along z, before the second begins.
    fn below(&self, a: &mut [u32], b: &mut [u32]) -> u64 {
        sort::by_key(a, &|i| self.high(2, i));
        sort::by_key(b, &|i| self.low(2, i));
        let (mut count, mut sum) = (0, 0);
        for &j in &*b {
            let low = self.boxes[j as usize].lo[2];
            count += a[count..].iter().take_while(|&&i| self.boxes[i as usize].hi[2] < low).count();
            sum += count as u64;
        }
        sum
    }

    /// Upwards along z: a box is united with those of the other group that have begun and
    /// have not ended.
    fn sweep_united(&mut self, a: &mut [u32], b: &mut [u32]) {
        sort::by_key(a, &|i| self.low(2, i));
        sort::by_key(b, &|i| self.low(2, i));
        let groups = [&*a, &*b];
        let (mut next, mut fresh, mut farthest) = ([0, 0], [0, 0], [None; 2]);
        loop {
            let heads = [0, 1].map(|g| groups[g].get(next[g]).map(|&i| self.low(2, i)));
            let (own, other) = match heads {
                [None, None] => return,
                [Some(a), Some(b)] if b < a => (1, 0),
                [None, _] => (1, 0),
                _ => (0, 1),
            };
            let i = groups[own][next[own]];
            next[own] += 1;
            let since = fresh[other]..next[other];
            fresh[other] = next[other];
            let before: Option<u32> = farthest[other];
            for &j in before.iter().chain(&groups[other][since]) {
                if self.boxes[j as usize].hi[2] >= self.boxes[i as usize].lo[2] {
                    self.unite(i, j);
                }
                let reach = |j: u32| self.high(2, j);
                if farthest[other].is_none_or(|far| reach(far) < reach(j)) {
                    farthest[other] = Some(j);
                }
            }
        }
    }
}
