//! Triangles as the tree sees them: boxes, relative to the scene's.

use super::curve::Key;
use super::rows::Rows;
use crate::Error;
use crate::aabb::Aabb;
use crate::arena::layout::Triangle;
use crate::build::control::{Control, TASKS, parts};
use crate::build::frame::unit;
use crate::build::gather::{SOON, Soup};
use crate::simd::fetch;
use bytemuck::{Pod, Zeroable};
use glam::{Vec3A, Vec4};

/// The box of a triangle, in coordinates times `unit` from the scene's lowest corner on, and
/// its place in the soup; or, in a binary tree, of a node, and how many triangles it holds.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C, align(32))]
pub struct Item {
    lo: [f32; 3],
    number: u32,
    hi: [f32; 3],
    /// In a binary tree, which node it is under.
    above: u32,
}

/// In the fourth lanes of corners: they are normal numbers, as denormal ones would take long to
/// compute with.
const NORMAL: u32 = 1 << 30;

impl Item {
    /// A node's, by its bounds.
    #[inline(always)]
    pub fn node([a, b, c, d, e, f]: [f32; 6], len: u32) -> Self {
        Self { lo: [a, b, c], number: len | NORMAL, hi: [d, e, f], above: NORMAL }
    }

    /// Its triangle's place in the soup, or a node's number of triangles, below 2^30.
    pub fn number(&self) -> u32 {
        self.number & !NORMAL
    }

    pub fn set_number(&mut self, number: u32) {
        self.number = number | NORMAL;
    }

    #[inline(always)]
    pub fn set_corners(&mut self, lo: Vec3A, hi: Vec3A) {
        (self.lo, self.hi) = (lo.to_array(), hi.to_array());
    }

    /// The node it is under.
    pub fn above(&self) -> u32 {
        self.above & !NORMAL
    }

    pub fn set_above(&mut self, node: u32) {
        self.above = node | NORMAL;
    }

    /// The lower and the upper corner.
    #[inline(always)]
    pub fn corners(&self) -> (Vec3A, Vec3A) {
        let halves: &[[f32; 4]; 2] = bytemuck::cast_ref(self);
        (
            Vec3A::from_vec4(Vec4::from_array(halves[0])),
            Vec3A::from_vec4(Vec4::from_array(halves[1])),
        )
    }
}

/// Triangles of a task.
const SHARE: usize = 4096;

/// The triangles of a soup in the order of keys, as items and as what is to be joined.
pub fn items(
    soup: &Soup<'_>,
    frame: &Frame,
    keys: &[Key],
    (to, rows): (&mut [Item], &mut Rows<'_>),
    control: &mut Control<'_>,
) -> Result<(), Error> {
    let chunk = SHARE * TASKS;
    let mut rows = rows.all();
    for (i, (to, keys)) in to.chunks_mut(chunk).zip(keys.chunks(chunk)).enumerate() {
        let starts = (i * chunk..).step_by(SHARE);
        let mut rest = to.chunks_mut(SHARE).zip(keys.chunks(SHARE)).zip(starts);
        let mut tasks = parts(|| {
            let ((to, keys), start) = rest.next()?;
            Some((rows.cut(to.len()), to, keys, start as u32))
        });
        control.each(&mut tasks, |(rows, to, keys, start)| {
            for (i, (to, key)) in to.iter_mut().zip(*keys).enumerate() {
                if let Some(key) = keys.get(i + SOON) {
                    fetch(&raw const soup.triangles[key[1] as usize]);
                }
                *to = frame.item(&soup.triangles[key[1] as usize], key[1] as u32);
                let ([a, b, c], [d, e, f]) = (to.lo, to.hi);
                rows.set(i, [a, b, c, d, e, f], [*start + i as u32, 1]);
            }
        })?;
        control.count(to.len());
        control.at(i * chunk, keys.len())?;
    }
    Ok(())
}

/// The tree's coordinates.
pub struct Frame {
    lower: [f64; 3],
    unit: f64,
}

#[inline(always)]
fn least([a, b, c]: [f32; 3]) -> f32 {
    let least = |a: f32, b: f32| if a < b { a } else { b };
    least(least(a, b), c)
}

#[inline(always)]
fn most([a, b, c]: [f32; 3]) -> f32 {
    let most = |a: f32, b: f32| if a > b { a } else { b };
    most(most(a, b), c)
}

impl Frame {
    pub fn new(bounds: &Aabb) -> Self {
        Self { lower: bounds.lo.map(f64::from), unit: unit(bounds) }
    }

    /// The cell that the middle of a triangle's box is in, of cells whose sides are 1 / `count`.
    #[inline(always)]
    pub fn cell(&self, triangle: &Triangle, count: u32) -> [u32; 3] {
        let corners = [triangle.x, triangle.y, triangle.z];
        let scale = self.unit * f64::from(count) * 0.5;
        [0, 1, 2].map(|k| {
            let twice = f64::from(least(corners[k])) + f64::from(most(corners[k]));
            ((twice - 2.0 * self.lower[k]) * scale) as u32
        })
    }

    #[inline(always)]
    fn item(&self, triangle: &Triangle, number: u32) -> Item {
        let number = number | NORMAL;
        let mut item = Item { lo: [0.0; 3], number, hi: [0.0; 3], above: NORMAL };
        for (k, along) in [triangle.x, triangle.y, triangle.z].into_iter().enumerate() {
            item.lo[k] = self.below(k, least(along));
            item.hi[k] = self.above(k, most(along));
        }
        item
    }

    /// A coordinate, not negative. In `f64`, what it is off by is far below the descent's margin.
    #[inline(always)]
    fn place(&self, k: usize, x: f32) -> f64 {
        // Zeros are positive: processors differ in which of two is the lesser.
        (f64::from(x) - self.lower[k]) * self.unit + 0.0
    }

    /// The `f32` at or below it.
    #[inline(always)]
    fn below(&self, k: usize, x: f32) -> f32 {
        let exact = self.place(k, x);
        let near = exact as f32;
        f32::from_bits(near.to_bits() - u32::from(f64::from(near) > exact))
    }

    /// The `f32` at or above it.
    #[inline(always)]
    fn above(&self, k: usize, x: f32) -> f32 {
        let exact = self.place(k, x);
        let near = exact as f32;
        f32::from_bits(near.to_bits() + u32::from(f64::from(near) < exact))
    }
}
