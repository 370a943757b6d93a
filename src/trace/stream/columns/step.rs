//! Steps, lanes being rays: the same operations as those of `local`, for one ray.

use super::{Columns, eight, eight_mut};
use crate::arena::layout::{BOX_CELLS, BOX_MARGIN, GRID, LIST, TAG_SHIFT};
use crate::simd::Lanes;

/// Voxels, places at s = 0, voxels per s and its reciprocal, s of plane 0, how far exit
/// boxes reach.
#[derive(Clone, Copy)]
struct Axis<L: Lanes> {
    at: L::Wide,
    start: L::Wide,
    speed: L::Wide,
    pace: L::Wide,
    zero: L::Wide,
    far: L::Wide,
}

impl Columns {
    /// What slots from `i` on need for a step and for placing boxes, along axis `k`.
    #[inline(always)]
    fn axis<L: Lanes>(&self, l: L, exits: L::Words, k: usize, i: usize) -> Axis<L> {
        let at = l.load_wide(eight(&self.at[k], i));
        let start = l.load_wide(eight(&self.start[k], i));
        let speed = l.load_wide(eight(&self.speed[k], i));
        let pace = l.div_wide(l.splat_wide(1.0), speed);
        let zero = l.sub_wide(l.splat_wide(0.0), l.mul_wide(start, pace));
        let far = self.far.reach(l, exits, k, i);
        Axis { at, start, speed, pace, zero, far }
    }

    /// Where the boxes of lists are: `Local::boxes` of slots from `i` on.
    #[inline(always)]
    fn place_boxes<L: Lanes>(&mut self, l: L, exits: L::Words, axes: &[Axis<L>; 3], i: usize) {
        let margin = l.splat_wide(BOX_MARGIN);
        let whole = l.splat_wide(1.0 + 2.0 * BOX_MARGIN);
        let none = l.splat_wide(0.0);
        for (k, &Axis { at, pace, zero, far, .. }) in axes.iter().enumerate() {
            let near = self.near.reach(l, exits, k, i);
            let low = l.sub_wide(l.sub_wide(at, near), margin);
            let side = l.add_wide(l.add_wide(near, far), whole);
            let cell = l.mul_wide(side, l.splat_wide(1.0 / BOX_CELLS as f32));
            let width = l.mul_wide(cell, pace);
            // Cells are counted from the lower end, mirrored or not.
            let far_unit = self.far.unit(l, k, i);
            let last = l.mul_wide(width, l.splat_wide((BOX_CELLS - 1) as f32));
            let last = l.choose_wide(none, far_unit, none, last);
            let start = l.add_wide(l.mul_add_wide(low, pace, zero), last);
            let [scale, offset] = &mut self.box_near;
            l.store_wide(l.mul_wide(width, self.near.unit(l, k, i)), eight_mut(&mut scale[k], i));
            l.store_wide(start, eight_mut(&mut offset[k], i));
            let [scale, offset] = &mut self.box_far;
            l.store_wide(l.mul_wide(width, far_unit), eight_mut(&mut scale[k], i));
            l.store_wide(l.add_wide(start, width), eight_mut(&mut offset[k], i));
        }
    }

    /// Leaves the exit boxes of slots from `i` on: `Local::step` and the numbers of the
    /// voxels it leads to, in `number` if they lie in the grid. `lists`: places the boxes of
    /// lists too.
    #[inline(always)]
    pub fn step<L: Lanes>(&mut self, l: L, i: usize, lists: bool) {
        let exits = l.words(eight(&self.exit, i));
        let axes = each!(k => self.axis(l, exits, k, i));
        if lists {
            self.place_boxes(l, exits, &axes, i);
        }
        let (none, one) = (l.splat_wide(0.0), l.splat_wide(1.0));
        // The planes behind the boxes, and when the rays are there.
        let behind = each!(k => l.add_wide(l.add_wide(axes[k].at, one), axes[k].far));
        let leave = each!(k => l.mul_add_wide(behind[k], axes[k].pace, axes[k].zero));
        let out = l.min_wide(l.min_wide(leave[0], leave[1]), leave[2]);
        let place = each!(k => {
            let Axis { at, start, speed, .. } = axes[k];
            // Off the axis of the exit the position says where, inside the box.
            let low = l.choose_wide(leave[k], out, behind[k], at);
            let high = l.choose_wide(leave[k], out, behind[k], l.sub_wide(behind[k], one));
            let place = l.truncate_wide(l.mul_add_wide(out, speed, start));
            let to = l.min_wide(l.max_wide(place, low), high);
            l.store_wide(to, eight_mut(&mut self.at[k], i));
            let last = l.load_wide(eight(&self.last[k], i));
            let flip = l.choose_wide(none, self.far.unit(l, k, i), none, last);
            l.abs_wide(l.sub_wide(to, flip))
        });
        l.store_wide(out, eight_mut(&mut self.out, i));
        let stop = l.load_wide(eight(&self.stop, i));
        l.store_wide(l.min_wide(out, stop), eight_mut(&mut self.until, i));
        let row = l.mul_add_wide(place[1], l.load_wide(eight(&self.nx, i)), place[0]);
        let (plane, first) = (eight(&self.plane, i), eight(&self.first, i));
        l.numbers(row, place[2], plane, first, eight_mut(&mut self.number, i));
    }

    /// Slots whose words in `exit` are those of lists, and of grids, from `i` on.
    #[inline(always)]
    pub fn tags<L: Lanes>(&self, l: L, i: usize) -> [u32; 2] {
        const { assert!(LIST == 1 && GRID == 2 && TAG_SHIFT == 30) };
        let [grids, lists] = l.tops(l.words(eight(&self.exit, i)));
        [lists, grids]
    }

    /// Which slots from `i` on go on where the step led them: a bit each.
    #[inline(always)]
    pub fn who_go_on<L: Lanes>(&self, l: L, i: usize) -> u32 {
        let out = l.load_wide(eight(&self.out, i));
        // No NaN passes any of this.
        let mut on = l.at_most(out, l.load_wide(eight(&self.stop, i)));
        for k in 0..3 {
            let last = l.load_wide(eight(&self.last[k], i));
            on &= l.at_most(l.load_wide(eight(&self.at[k], i)), last);
        }
        on
    }
}
