//! Subtrees of the binary tree taken out and put in where they cost less (Bittner, Hapala &
//! Havran 2013): the sum of the nodes' surfaces falls.
//!
//! The best place is looked for from the old one on, upwards and from there downwards, as far
//! as the boxes on the way leave hope (Meister & Bittner 2018). Each subtree is moved before
//! the next is looked at.

use super::binary::{Binary, NONE, surface};
use crate::Error;
use crate::build::control::Control;

/// How often the tree is gone through.
const ROUNDS: usize = 3;
/// For so many triangles, one subtree is looked at in a round.
const SHARE: usize = 5;
/// Boxes that are looked at for a place, at most.
const LOOKS: usize = 64;

/// Moves subtrees, those near the root last. `queue` is room for as many as there are triangles.
pub fn reinsert(
    tree: &mut Binary<'_>,
    queue: &mut [u32],
    control: &mut Control<'_>,
) -> Result<(), Error> {
    let count = tree.triangles.div_ceil(SHARE);
    for round in 0..ROUNDS {
        let queue = nearest(tree, &mut queue[..count]);
        // Boxes that are to be fitted again, on average; a hostile tree may be very deep.
        let mut fits = LOOKS * count;
        for (i, &from) in queue.iter().rev().enumerate() {
            let mut looks = 0;
            if let Some(to) = place(tree, from, &mut looks) {
                let fitted = put(tree, from, to);
                fits = fits.saturating_sub(fitted);
                looks += fitted;
            }
            control.tick(looks, round * count + i, ROUNDS * count)?;
            if fits == 0 {
                break;
            }
        }
    }
    Ok(())
}

/// The boxes nearest to the root, level by level.
fn nearest<'a>(tree: &Binary<'_>, queue: &'a mut [u32]) -> &'a [u32] {
    queue[0] = tree.root;
    let (mut next, mut count) = (0, 1);
    while next < count && count < queue.len() {
        for i in tree.below(queue[next]).into_iter().flatten() {
            if let Some(to) = queue.get_mut(count) {
                *to = i;
                count += 1;
            }
        }
        next += 1;
    }
    &queue[..count]
}

/// The box beside which a subtree costs least, if that is not where it is.
fn place(tree: &Binary<'_>, from: u32, looks: &mut usize) -> Option<u32> {
    let above = tree.above(from);
    if above == NONE || tree.above(above) == NONE {
        return None;
    }
    let (lo, hi) = tree.corners(from);
    let own = tree.surface(from);
    let mut waiting = [(0.0, 0); LOOKS + 2];
    let (mut best, mut gain) = (NONE, 0.0);
    let mut pivot = above;
    let mut beside = tree.beside(from);
    // What taking it out saves, of the nodes up to the pivot; and what the pivot is without it.
    let mut saved = tree.surface(above);
    let mut without = tree.corners(beside);
    loop {
        waiting[0] = (saved, beside);
        let mut count = 1;
        while count > 0 {
            count -= 1;
            let (left, i) = waiting[count];
            // A box that holds it is no smaller than it.
            if left - own <= gain {
                continue;
            }
            *looks += 1;
            if *looks > LOOKS {
                break;
            }
            let (a, b) = tree.corners(i);
            let left_over = left - surface(a.min(lo), b.max(hi));
            if left_over > gain {
                (best, gain) = (i, left_over);
            }
            // Below, this box grows.
            let left = left_over + surface(a, b);
            for i in tree.below(i).into_iter().flatten() {
                waiting[count] = (left, i);
                count += 1;
            }
        }
        if pivot != above {
            let (a, b) = tree.corners(beside);
            without = (without.0.min(a), without.1.max(b));
            saved += tree.surface(pivot) - surface(without.0, without.1);
        }
        if *looks >= LOOKS || tree.above(pivot) == NONE {
            break;
        }
        *looks += 1;
        beside = tree.beside(pivot);
        pivot = tree.above(pivot);
    }
    (best != NONE).then_some(best)
}

/// Moves a subtree beside another box; how many boxes were fitted for that.
fn put(tree: &mut Binary<'_>, from: u32, to: u32) -> usize {
    let node = tree.above(from);
    let (old, beside) = (tree.above(node), tree.beside(from));
    tree.replace(old, node, beside);
    let new = tree.above(to);
    tree.replace(new, to, node);
    tree.join(node, [to, from]);
    tree.fit(node);
    climb(tree, old) + climb(tree, new)
}

/// Fits the boxes from a node on upwards.
#[inline(never)]
fn climb(tree: &mut Binary<'_>, mut node: u32) -> usize {
    let mut fits = 1;
    while node != NONE && tree.fit(node) {
        node = tree.above(node);
        fits += 1;
    }
    fits
}

#[cfg(test)]
mod tests {
    use super::super::binary::tests::{boxes, built, total};
    use super::*;
    use std::vec;

    #[test]
    fn surfaces_shrink_and_all_stays_a_tree() {
        for seed in 0..5 {
            let (mut boxes, mut below) = (boxes(seed, 700), vec![[0; 2]; 699]);
            let mut control = Control::default();
            let mut tree = built(&mut boxes, &mut below);
            let before = total(&mut tree);
            reinsert(&mut tree, &mut vec![0; 700], &mut control).expect("not cancelled");
            let after = total(&mut tree);
            assert!(after < before, "{after} of {before}");
        }
    }
}
