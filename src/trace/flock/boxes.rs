//! The rays of a list and the boxes of a node's parts.

use super::super::query::Query;
use super::lists::{Columns, FROM, ROOM, TO};
use super::{Flocking, RAYS};
use crate::arena::node::{NODE, Node, PARTS};
use crate::simd::{Lanes, RayColumns};

/// Rays of a node's list, and of a leaf's, that go on by themselves: each step of a list
/// waits for the one before, so lists have to be long to be quicker.
const FEW: usize = 16;
const FEW_IN_LEAF: usize = 1;

/// Parts of a node in some order.
type Order = [u8; PARTS];

impl<Q: Query, L: Lanes> Flocking<'_, '_, '_, Q, L> {
    /// Goes on with a list that was taken.
    #[inline(always)]
    pub(super) fn meet(&mut self, part: u32, count: usize) {
        if count == 0 {
            return;
        }
        let is_node = part & NODE == NODE;
        let few = if is_node { FEW } else { FEW_IN_LEAF };
        if count <= few || (is_node && !self.lists.have_room(count)) {
            for i in 0..count {
                self.part_with(self.lists.rays[i % RAYS], part);
            }
        } else if is_node {
            self.node(part, count);
        } else {
            self.leaf(part, count);
        }
    }

    /// Makes lists for the parts of a node, the one that comes first last.
    #[inline(always)]
    fn node(&mut self, part: u32, count: usize) {
        let l = self.l;
        let whole = self.lists.fill_up(count, L::MANY);
        self.columns(whole);
        let (near, far) = (self.near.map(|row| row.row(part)), self.far.map(|row| row.row(part)));
        let parts = &self.sections.node::<Node>(part).parts;
        for i in self.order(near, count) {
            let i = usize::from(i) % PARTS;
            let start = self.lists.len;
            let bounds = [near[0][i], near[1][i], near[2][i], far[0][i], far[1][i], far[2][i]];
            self.enter(bounds, whole);
            if self.lists.push(parts[i], start) {
                self.sections.fetch_part::<Node, L>(l, parts[i]);
            }
        }
    }

    /// Looks up the rays of the list that was taken.
    #[inline(always)]
    fn columns(&mut self, whole: usize) {
        let l = self.l;
        let (members, lists) = (&self.members, &mut *self.lists);
        let mut at = 0;
        while at < whole {
            let rays: &[u32; 8] = eight(&lists.rays, at);
            let rows = |i: usize| &members[rays[i] as usize].rows;
            let pace = l.four_columns(|i| &rows(i)[0]);
            let enter = l.columns(|i| &rows(i)[1]);
            let leave = l.columns(|i| &rows(i)[2]);
            let to = l.load_wide(eight(&lists.ends, at));
            let columns = &mut lists.columns;
            store(l, columns, at, 0, pace[0]);
            store(l, columns, at, 1, pace[1]);
            store(l, columns, at, 2, pace[2]);
            store(l, columns, at, FROM, pace[3]);
            store(l, columns, at, 4, enter[0]);
            store(l, columns, at, 5, enter[1]);
            store(l, columns, at, 6, enter[2]);
            store(l, columns, at, TO, to);
            store(l, columns, at, 8, leave[0]);
            store(l, columns, at, 9, leave[1]);
            store(l, columns, at, 10, leave[2]);
            at += L::WIDE;
        }
    }

    /// The parts of a node with these near bounds: the one that is last for a ray in the middle of the
    /// list, and so on. For any hit the largest, which is first in its node, is to come first.
    #[inline(always)]
    fn order(&self, near: [&[f32; PARTS]; 3], count: usize) -> Order {
        let mut order = [7, 6, 5, 4, 3, 2, 1, 0];
        if Q::ANY {
            return order;
        }
        let l = self.l;
        let middle = self.lists.rays[count / 2 % RAYS];
        let [pace, enter, _] = self.members[middle as usize].rows;
        let at = each!(k => {
            l.mul_add_wide(l.load_wide(near[k]), l.splat_wide(pace[k]), l.splat_wide(enter[k]))
        });
        let mut entries = [0.0; PARTS];
        l.store_wide(l.max_wide(l.max_wide(at[0], at[1]), at[2]), &mut entries);
        for i in 1..PARTS {
            let part = order[i];
            let mut to = i;
            while to > 0 && entries[usize::from(order[to - 1]) % 8] < entries[usize::from(part) % 8]
            {
                order[to] = order[to - 1];
                to -= 1;
            }
            order[to] = part;
        }
        order
    }

    /// Adds those of the list that was taken that meet a box, near bounds and far ones.
    #[inline(always)]
    fn enter(&mut self, bounds: [f32; 6], whole: usize) {
        let lists = &mut *self.lists;
        let mut at = 0;
        while at < whole {
            let place = at % RAYS;
            let column =
                |k: usize| lists.columns[k][place..].first_chunk().expect("there is room for more");
            let rays = RayColumns {
                pace: [column(0), column(1), column(2)],
                from: column(FROM),
                enter: [column(4), column(5), column(6)],
                to: column(TO),
                leave: [column(8), column(9), column(10)],
            };
            let to = lists.len % ROOM;
            lists.len += self.l.enter_box(
                &rays,
                bounds,
                lists.rays[place..].first_chunk().expect("likewise"),
                lists.ids[to..].first_chunk_mut().expect("likewise"),
                lists.entries[to..].first_chunk_mut().expect("likewise"),
            );
            at += L::MANY;
        }
    }
}

/// Eight from number `at` on.
#[inline(always)]
pub fn eight<T, const N: usize>(row: &[T; N], at: usize) -> &[T; 8] {
    const { assert!(N >= RAYS + 8) };
    row[at % RAYS..].first_chunk().expect("there is room for more")
}

#[inline(always)]
fn store<L: Lanes>(l: L, columns: &mut Columns, at: usize, k: usize, a: L::Wide) {
    let to = columns[k][at % RAYS..].first_chunk_mut().expect("there is room for more");
    l.store_wide(a, to);
}
