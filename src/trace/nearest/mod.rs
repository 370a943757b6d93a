//! The nearest point of a scene: a search by distance instead of a walk.
//!
//! A grid's voxels are halved again and again into blocks, the half nearer to the centre
//! first, and a block is left alone if it is farther away than what was found. It is not
//! halved further if it lies in the exit box of its nearest voxel: then all in it is in
//! that voxel's list (`build::exit`), so empty space is passed in large pieces. A grid
//! below is searched in the part of space that is the block's.
//!
//! The voxels of a grid share out space, at planes computed in `f64`, and so do the blocks
//! of the grids below what is a voxel's: no place is searched twice on one way down, and
//! the nearest point of a triangle lies in one voxel of each grid that holds it. Computed
//! planes are off by 2^-14 of a voxel (`local`), footprints grown by 2^-10
//! (`build::overlap`): so that voxel refers to the triangle, or to a grid that does, and
//! nothing is lost. For distances, blocks are grown by 2^-8 of a voxel and squares made
//! smaller by a part in 10^12.
//!
//! A turned grid is searched in its own coordinates, in the part of space that a box there
//! around the block has; so places may be searched twice, and still none is left out.
//!
//! The search is in coordinates times the header's `unit`.

mod frame;

use super::query::beyond;
use crate::arena::layout::{EMPTY, GRID_BIT, LIST, PAYLOAD, TAG_SHIFT, Triangle};
use crate::arena::{Sections, View};
use crate::point;
use crate::probe::{Nearest, Probe};
use crate::ray::NONE;
use crate::simd::fpenv;
use frame::{Block, Bounds, Frame};

struct Search<'a> {
    sections: Sections<'a>,
    probe: &'a Probe,
    unit: f64,
    /// The centre, as it is and in the units of grids.
    org: [f64; 3],
    p: [f64; 3],
    /// What was found, and bounds of the squares of interest, in both units.
    distance: f32,
    found: Option<&'a Triangle>,
    limits: [f64; 2],
    /// Triangles seen lately, by the low bits of their numbers.
    seen: [u32; 16],
}

impl<'a> Search<'a> {
    fn new(sections: Sections<'a>, probe: &'a Probe, unit: f64) -> Self {
        let org = probe.org.map(f64::from);
        let mut search = Self {
            sections,
            probe,
            unit,
            org,
            p: org.map(|x| x * unit),
            distance: probe.radius,
            found: None,
            limits: [0.0; 2],
            seen: [NONE; 16],
        };
        search.limit();
        search
    }

    /// Takes the distance for the largest of interest.
    fn limit(&mut self) {
        let limit = beyond(self.distance);
        self.limits = [limit, limit * self.unit].map(|x| x * x);
    }

    /// Searches part of a grid.
    fn grid(&mut self, number: u32, part: Bounds) {
        if !part.is_empty() {
            let frame = Frame::new(&self.sections, number, &self.p, part);
            self.block(&frame, frame.block());
        }
    }

    fn block(&mut self, frame: &Frame<'a>, mut block: Block) {
        loop {
            if frame.bounds(&block).square(&frame.p) > self.limits[1] {
                return;
            }
            let at: [u32; 3] =
                core::array::from_fn(|k| frame.at[k].clamp(block.lo[k], block.hi[k]));
            let [nx, ny, _] = frame.grid.n.map(u32::from);
            let number = frame.grid.first + (at[2] * ny + at[1]) * nx + at[0];
            let voxel = self.sections.voxel(number as usize);
            let (tag, payload) = (voxel >> TAG_SHIFT, voxel & PAYLOAD);
            let exit = match tag {
                EMPTY => payload,
                LIST => self.sections.head(payload).0,
                _ => 0,
            };
            if block.inside(exit, at) {
                match tag {
                    EMPTY => {}
                    LIST => self.list(payload, &frame.share(&block)),
                    _ => self.grid(payload, frame.share(&block)),
                }
                return;
            }
            // Along its longest side.
            let side = |k: usize| f64::from(block.hi[k] - block.lo[k]) * frame.cell[k];
            let longer = |a: usize, b: usize| if side(b) > side(a) { b } else { a };
            let k = longer(longer(0, 1), 2);
            let middle = block.lo[k].midpoint(block.hi[k]);
            let (mut low, mut high) = (block, block);
            low.hi[k] = middle;
            high.lo[k] = middle + 1;
            let (first, second) = if at[k] <= middle { (low, high) } else { (high, low) };
            self.block(frame, first);
            block = second;
        }
    }

    /// What a list refers to, in a part of space.
    fn list(&mut self, place: u32, part: &Bounds) {
        for &r in self.sections.list(place).1 {
            if r & GRID_BIT == 0 {
                let seen = &mut self.seen[r as usize % 16];
                if core::mem::replace(seen, r) != r {
                    self.triangle(self.sections.triangle(r));
                }
            } else {
                self.grid(r & !GRID_BIT, *part);
            }
        }
    }

    fn triangle(&mut self, triangle: &'a Triangle) {
        let Probe { org, mask, skip_geom, skip_prim, .. } = *self.probe;
        let skip = (triangle.geom, triangle.prim) == (skip_geom, skip_prim);
        if skip
            || mask & triangle.mask == 0
            || Bounds::of(triangle).square(&self.org) > self.limits[0]
        {
            return;
        }
        let Some(distance) = point::distance(org, triangle, self.distance) else {
            return;
        };
        let before = |other: &Triangle| (triangle.geom, triangle.prim) < (other.geom, other.prim);
        if distance < self.distance || self.found.is_none_or(before) {
            self.distance = distance;
            self.found = Some(triangle);
            self.limit();
        }
    }

    fn record(&self) -> Nearest {
        let nothing = Nearest::nothing(self.probe.radius);
        self.found.map_or(nothing, |triangle| {
            let (point, (u, v)) = point::place(self.probe.org, triangle);
            let Triangle { geom, prim, .. } = *triangle;
            Nearest { distance: self.distance, u, v, point, geom, prim, ..nothing }
        })
    }
}

/// Whether the probe can find anything; NaN fails the comparisons.
fn usable(probe: &Probe) -> bool {
    probe.org.iter().all(|x| x.is_finite()) && probe.radius >= 0.0
}

impl View<'_> {
    /// The point of the scene that is nearest to the probe's centre and no farther away
    /// than its radius.
    ///
    /// The distance of a triangle is that of real arithmetic, rounded once to `f32`; the
    /// triangle of the smallest is found, ties by lowest geometry, then primitive. Its
    /// nearest point is real too, each coordinate rounded once. So the answer is the same
    /// in every structure, on every machine; it is what [`View::closest_point_brute`]
    /// finds. A distance that is too large for `f32` is none.
    ///
    /// One search at a time; there is no form for streams. 96 kB of stack suffice.
    /// Empty space costs little where there are exit boxes; without them
    /// (`exit_boxes: false`) every voxel in the ball is looked at.
    ///
    /// ```
    /// # let vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    /// # let mesh = hug::Geometry::from_mesh(&vertices, &[[0, 1, 2]]);
    /// # let scene = hug::Scene::build(&[mesh], &hug::Options::default())?;
    /// let near = scene.view().closest_point(&hug::Probe::new([0.25, -3.0, 4.0], 10.0));
    /// assert_eq!((near.distance, near.point, near.prim), (5.0, [0.25, 0.0, 0.0], 0));
    /// # Ok::<(), hug::Error>(())
    /// ```
    #[must_use]
    pub fn closest_point(&self, probe: &Probe) -> Nearest {
        self.search(probe, |search| {
            search.grid(0, Bounds::EVERYWHERE);
        })
    }

    /// [`View::closest_point`] by looking at every triangle. Cost: linear in the triangles.
    #[must_use]
    pub fn closest_point_brute(&self, probe: &Probe) -> Nearest {
        self.search(probe, |search| {
            self.triangles().iter().for_each(|triangle| search.triangle(triangle));
        })
    }

    fn search<'a>(&'a self, probe: &'a Probe, run: impl FnOnce(&mut Search<'a>)) -> Nearest {
        fpenv::with_default(|| {
            let header = self.header();
            if header.grids.count == 0 || !usable(probe) {
                return Nearest::nothing(probe.radius);
            }
            let mut search = Search::new(self.sections(), probe, header.unit);
            run(&mut search);
            search.record()
        })
    }
}
