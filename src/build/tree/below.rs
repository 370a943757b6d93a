//! A binary tree over single triangles, built from below.
//!
//! Boxes lie along a curve. Two that are each other's best, among a few neighbours there, are
//! joined, all such pairs at once, and so on with what there is then (parallel locally-ordered
//! clustering, Meister & Bittner 2018). A node's number is above those of the nodes below it.

use super::binary::Binary;
use super::costs::{Costs, joined, of_triangle};
use super::item::Item;
use super::near::nearest;
use super::rows::{Rows, Seen, half_surface, union};
use crate::Error;
use crate::build::control::{Control, TASKS, parts};
use crate::build::scratch::cut;
use crate::simd::fetch;

/// Boxes of a task.
const SHARE: usize = 1024;
/// Where fewer than one pair is found among so many boxes, each is joined with its neighbour: so
/// what is to be done is bounded, and how deep the tree is.
const SLOW: usize = 16;

/// Some of the boxes that there are, to be joined.
struct Share<'a> {
    seen: Seen<'a>,
    best: &'a [u32],
    first: usize,
    len: usize,
    to: Rows<'a>,
    /// The first node that is made.
    node: usize,
    nodes: &'a mut [Item],
    below: &'a mut [[u32; 2]],
    triangles: usize,
    /// Of the nodes that there are, and of those that are made.
    known: &'a [Costs],
    costs: &'a mut [Costs],
}

/// What becomes of some boxes: pairs, and all that are left.
#[derive(Clone, Copy, Default)]
struct Counts {
    pairs: usize,
    left: usize,
}

/// Builds a tree over the items in the first half of `boxes`, two at least, which are also the
/// rows to begin with; `then` is room for as many, and so is `best`. `costs` become those of the
/// nodes.
pub fn build<'a>(
    boxes: &'a mut [Item],
    below: &'a mut [[u32; 2]],
    [mut now, mut then]: [Rows<'_>; 2],
    best: &mut [u32],
    costs: &mut [Costs],
    control: &mut Control<'_>,
) -> Result<Binary<'a>, Error> {
    let n = below.len() + 1;
    let (mut count, mut done) = (n, 0);
    while count > 1 {
        let best = &mut best[..count];
        let share = SHARE.max(count.div_ceil(TASKS));
        let seen = now.seen(count);
        let starts = || (0..count).step_by(share);
        let mut some = best.chunks_mut(share).zip(starts());
        let mut tasks = parts(|| some.next());
        control.each(&mut tasks, |(best, first)| nearest(&seen, *first, best))?;
        let mut counts = counted(best, share, control)?;
        let pairs = |counts: &[Counts; TASKS]| counts.iter().map(|some| some.pairs).sum();
        let mut made: usize = pairs(&counts);
        if made * SLOW < count {
            let last = count as u32 - 1;
            (0..).zip(&mut *best).for_each(|(i, best)| *best = last.min(i ^ 1));
            counts = counted(best, share, control)?;
            made = pairs(&counts);
        }
        let (mut to, mut node) = (then.all(), done);
        let (mut nodes, mut rest) = (&mut boxes[n + done..], &mut below[done..]);
        let (known, mut costs) = costs.split_at_mut(done);
        let known = &*known;
        let mut some = starts().zip(&counts);
        let mut tasks = parts(|| {
            let (first, counts) = some.next()?;
            node += counts.pairs;
            Some(Share {
                seen,
                best,
                first,
                len: share.min(count - first),
                to: to.cut(counts.left),
                node: n + node - counts.pairs,
                nodes: cut(&mut nodes, counts.pairs),
                below: cut(&mut rest, counts.pairs),
                triangles: n,
                known,
                costs: cut(&mut costs, counts.pairs),
            })
        });
        control.each(&mut tasks, Share::join)?;
        control.count(count);
        control.at(done, n)?;
        (count, done) = (count - made, done + made);
        (now, then) = (then, now);
    }
    Ok(Binary { triangles: n, boxes, below, root: 2 * n as u32 - 2 })
}

/// Counts what becomes of boxes, in parts of so many.
#[inline(never)]
fn counted(best: &[u32], share: usize, control: &Control<'_>) -> Result<[Counts; TASKS], Error> {
    let mut some = best.chunks(share).zip((0..).step_by(share));
    let mut tasks = parts(|| some.next().map(|some| (some, Counts::default())));
    control.each(&mut tasks, |((some, first), counts)| *counts = count(best, some, *first))?;
    let mut counts = [Counts::default(); TASKS];
    for (to, task) in counts.iter_mut().zip(tasks.iter().flatten()) {
        *to = task.1;
    }
    Ok(counts)
}

#[inline(never)]
fn count(best: &[u32], some: &[u32], first: u32) -> Counts {
    let mut counts = Counts::default();
    for (i, &other) in (first..).zip(some) {
        let pair = other != i && best[other as usize] == i;
        counts.pairs += usize::from(pair && i < other);
        counts.left += usize::from(!pair || i < other);
    }
    counts
}

/// Boxes that are looked at before any of them are joined.
const BLOCK: usize = 64;

impl Share<'_> {
    /// Makes a node of each pair, in the place of the first; what is not joined stays. Boxes are
    /// copied before pairs are made of them, whoever is joined, so that their costs are asked for in
    /// time.
    fn join(&mut self) {
        let (mut made, mut left) = (0, 0);
        let mut pairs = [(0, 0, 0); BLOCK];
        let end = self.first + self.len;
        for start in (self.first..end).step_by(BLOCK) {
            let mut count = 0;
            for i in start..end.min(start + BLOCK) {
                let other = self.best[i] as usize;
                let pair = other != i && self.best[other] as usize == i;
                // What is overwritten by the next may be the last, and past all that is left.
                if left < self.to.len() {
                    self.to.set(left, self.seen.bounds(i), [self.seen.ids[i], self.seen.lens[i]]);
                }
                pairs[count] = (i, other, left);
                if pair {
                    self.ask(self.seen.ids[i]);
                }
                count += usize::from(pair && i < other);
                left += usize::from(!pair || i < other);
            }
            for &(i, other, left) in &pairs[..count] {
                self.make(made, [i, other], left);
                made += 1;
            }
        }
    }

    /// Asks for the costs of a node ahead.
    #[inline(always)]
    fn ask(&self, id: u32) {
        if let Some(costs) = self.known.get((id as usize).wrapping_sub(self.triangles)) {
            fetch(costs);
        }
    }

    /// Makes a node of two boxes.
    #[inline(always)]
    fn make(&mut self, made: usize, pair: [usize; 2], to: usize) {
        let seen = &self.seen;
        let [a, b] = pair.map(|i| seen.bounds(i));
        let len = seen.lens[pair[0]] + seen.lens[pair[1]];
        let bounds = union(a, b);
        self.nodes[made] = Item::node(bounds, len);
        self.below[made] = pair.map(|i| seen.ids[i]);
        self.to.set(to, bounds, [(self.node + made) as u32, len]);
        let of = |i: usize| match (seen.ids[i] as usize).checked_sub(self.triangles) {
            Some(node) => self.known[node],
            None => of_triangle(half_surface(seen.bounds(i))),
        };
        let alone = pair.map(|i| seen.lens[i] == 1);
        self.costs[made] = joined(half_surface(bounds), len, pair.map(of), alone);
    }
}

#[cfg(test)]
mod tests {
    use super::super::binary::NONE;
    use super::super::binary::tests::{boxes, total};
    use super::super::collapse::Collapse;
    use super::super::rows::WORDS;
    use super::*;
    use glam::Vec3A;
    use std::vec;

    /// Builds a tree over boxes in their order, and looks at it: what it took, in units of work a
    /// box, and how deep it is.
    fn check(boxes: &mut [Item]) -> (f64, usize) {
        let n = boxes.len().div_ceil(2);
        let mut words = [vec![0; WORDS * n], vec![0; WORDS * n]];
        let [mut now, then] = words.each_mut().map(|words| Rows::new(words));
        for (i, item) in boxes[..n].iter().enumerate() {
            let (lo, hi) = item.corners();
            now.set(i, [lo.x, lo.y, lo.z, hi.x, hi.y, hi.z], [i as u32, 1]);
        }
        let (mut best, mut below) = (vec![0; n], vec![[0; 2]; n - 1]);
        let mut costs = vec![[0.0; 8]; n - 1];
        let mut control = Control::default();
        let built = build(boxes, &mut below, [now, then], &mut best, &mut costs, &mut control);
        let mut tree = built.expect("not cancelled");
        let mut depth = vec![0; 2 * n - 1];
        tree.boxes[tree.root as usize].set_above(NONE);
        for node in (n as u32..=tree.root).rev() {
            let len = |i: u32| tree.below(i).map_or(1, |_| tree.number(i));
            let below = tree.below(node).expect("a node");
            assert_eq!(tree.number(node), below.map(len).iter().sum::<u32>());
            for i in below {
                assert!(i < node);
                tree.boxes[i as usize].set_above(node);
                depth[i as usize] = depth[node as usize] + 1;
            }
        }
        assert!(total(&mut tree) > 0.0);
        // What was counted meanwhile is what is counted afterwards.
        let mut again = vec![[0.0; 8]; n - 1];
        let mut all = Collapse::new(tree, &mut again);
        all.count_all(&mut Control::default()).expect("not cancelled");
        assert_eq!(costs, again);
        (control.work() as f64 / n as f64, depth.into_iter().max().unwrap_or(0))
    }

    #[test]
    fn it_is_a_tree() {
        // More than one task has, too.
        for count in [2, 3, 100, 9000] {
            check(&mut boxes(7, count));
        }
    }

    /// Boxes each of which is nearest to the one before: rounds of one pair each would be too
    /// many.
    #[test]
    fn few_pairs() {
        const COUNT: usize = 3000;
        let (mut boxes, mut at) = (boxes(1, COUNT), 0.0);
        for (i, item) in boxes[..COUNT].iter_mut().enumerate() {
            let size = 1.01_f32.powi(i as i32 - COUNT as i32);
            item.set_corners(Vec3A::new(at, 0.0, 0.0), Vec3A::new(at, size, size));
            at += size;
        }
        // Each round leaves 15 of 16 at most.
        let (work, depth) = check(&mut boxes);
        assert!(work <= 16.0 && depth <= 125, "{work} {depth}");
    }
}
