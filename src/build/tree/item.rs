//! Triangles as the tree sees them: boxes, relative to the scene's.

use crate::Error;
use crate::arena::layout::Triangle;
use crate::build::control::{Control, TASKS, parts};
use crate::build::frame::unit;
use crate::build::gather::Soup;
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

/// Writes an item for each triangle.
pub fn items(soup: &Soup<'_>, to: &mut [Item], control: &mut Control<'_>) -> Result<(), Error> {
    let frame = Frame { lower: soup.bounds.lo.map(f64::from), unit: unit(&soup.bounds) };
    let chunk = SHARE * TASKS;
    for (i, (to, from)) in to.chunks_mut(chunk).zip(soup.triangles.chunks(chunk)).enumerate() {
        let starts = (i * chunk..).step_by(SHARE);
        let mut rest = to.chunks_mut(SHARE).zip(from.chunks(SHARE)).zip(starts);
        let mut tasks = parts(|| rest.next());
        control.each(&mut tasks, |((to, from), start)| {
            for (number, (to, triangle)) in (*start as u32..).zip(to.iter_mut().zip(*from)) {
                *to = frame.item(triangle, number);
            }
        })?;
        control.count(from.len());
        control.at(i * chunk, soup.triangles.len())?;
    }
    Ok(())
}

struct Frame {
    lower: [f64; 3],
    unit: f64,
}

impl Frame {
    #[inline(always)]
    fn item(&self, triangle: &Triangle, number: u32) -> Item {
        let number = number | NORMAL;
        let mut item = Item { lo: [0.0; 3], number, hi: [0.0; 3], above: NORMAL };
        for (k, [a, b, c]) in [triangle.x, triangle.y, triangle.z].into_iter().enumerate() {
            let least = |a: f32, b: f32| if a < b { a } else { b };
            let most = |a: f32, b: f32| if a > b { a } else { b };
            item.lo[k] = self.below(k, least(least(a, b), c));
            item.hi[k] = self.above(k, most(most(a, b), c));
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
