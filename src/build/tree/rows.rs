//! What is to be joined, by columns.

use crate::build::scratch::cut;

/// Boxes and what they are in the binary tree: lower corners along x, y, z, upper corners.
pub struct Rows<'a> {
    bounds: [&'a mut [f32]; 6],
    ids: &'a mut [u32],
    lens: &'a mut [u32],
}

/// Some of them, to read.
#[derive(Clone, Copy)]
pub struct Seen<'a> {
    pub bounds: [&'a [f32]; 6],
    pub ids: &'a [u32],
    /// How many triangles they hold.
    pub lens: &'a [u32],
}

/// Words that one takes.
pub const WORDS: usize = 8;

impl<'a> Rows<'a> {
    /// Room for as many as there are words for.
    pub fn new(mut words: &'a mut [u32]) -> Self {
        let count = words.len() / WORDS;
        let mut row = || cut(&mut words, count);
        let bounds = [row(), row(), row(), row(), row(), row()].map(bytemuck::cast_slice_mut);
        Self { bounds, ids: row(), lens: row() }
    }

    /// The first `count`.
    pub fn seen(&self, count: usize) -> Seen<'_> {
        let [a, b, c, d, e, f] = &self.bounds;
        let bounds = [&a[..count], &b[..count], &c[..count], &d[..count], &e[..count], &f[..count]];
        Seen { bounds, ids: &self.ids[..count], lens: &self.lens[..count] }
    }

    /// All of them, for a while.
    pub fn all(&mut self) -> Rows<'_> {
        let [a, b, c, d, e, f] = &mut self.bounds;
        Rows { bounds: [a, b, c, d, e, f], ids: self.ids, lens: self.lens }
    }

    pub fn len(&self) -> usize {
        self.ids.len()
    }

    /// Cuts off the first `count`.
    pub fn cut(&mut self, count: usize) -> Self {
        let [a, b, c, d, e, f] = &mut self.bounds;
        let row = |rest| cut(rest, count);
        let bounds = [row(a), row(b), row(c), row(d), row(e), row(f)];
        Self { bounds, ids: cut(&mut self.ids, count), lens: cut(&mut self.lens, count) }
    }

    #[inline(always)]
    pub fn set(&mut self, i: usize, bounds: [f32; 6], [id, len]: [u32; 2]) {
        for (row, x) in self.bounds.iter_mut().zip(bounds) {
            row[i] = x;
        }
        (self.ids[i], self.lens[i]) = (id, len);
    }
}

impl Seen<'_> {
    #[inline(always)]
    pub fn bounds(&self, i: usize) -> [f32; 6] {
        self.bounds.map(|row| row[i])
    }
}

/// The box around two.
#[inline(always)]
pub fn union(a: [f32; 6], b: [f32; 6]) -> [f32; 6] {
    let least = |k: usize| if a[k] < b[k] { a[k] } else { b[k] };
    let most = |k: usize| if a[k] > b[k] { a[k] } else { b[k] };
    [least(0), least(1), least(2), most(3), most(4), most(5)]
}

/// Half the surface of a box.
#[inline(always)]
pub fn half_surface([a, b, c, d, e, f]: [f32; 6]) -> f32 {
    let [x, y, z] = [d - a, e - b, f - c];
    x * y + y * z + z * x
}
