//! Reading an arena.
//!
//! # Safety
//! A `View` exists only over bytes that [`View::open`] found consistent, that
//! the build wrote, or that a caller of the unsafe constructors vouches for.
//! Consistent means (see `check`): every voxel number of a grid lies in the
//! voxels' section; every voxel's list lies in the references' section; every
//! reference names an existing triangle or a later grid; exit boxes lie in their
//! grids; if a grid is turned there is a frame for each; parts of nodes name nodes and
//! triangles that exist, and where there are nodes there is room for seven triangles after the
//! last.
//! The accessors below rely on it instead of testing bounds.

use core::hint::select_unpredictable;
use core::marker::PhantomData;

use super::check;
use super::layout::{
    Frame, GRID, GRID_BIT, Grid, Header, LIST, LIST_HEAD, PAYLOAD, Section, TAG_SHIFT, Triangle,
};
use super::node::{AnyNode, LEAF_SHIFT, NODE, NODE_SHIFT};
use crate::Error;
use crate::simd::{Lanes, fpenv};

/// A scene in borrowed memory: an arena ready for queries. Copying it is free.
#[derive(Clone, Copy)]
pub struct View<'a> {
    base: *const u8,
    marker: PhantomData<&'a [u8]>,
}

// SAFETY: a view only reads, and its bytes are borrowed immutably.
unsafe impl Send for View<'_> {}
// SAFETY: as above.
unsafe impl Sync for View<'_> {}

impl<'a> View<'a> {
    /// Checks untrusted bytes and reads them in place. Bytes after the arena
    /// are ignored. Cost: linear in the arena, no allocation.
    ///
    /// ```
    /// # let vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    /// # let scene = hug::Scene::builder().mesh(&vertices, &[[0, 1, 2]]).build()?;
    /// #[repr(align(64))]
    /// struct Saved([u8; 4096]);
    /// let mut saved = Saved([0; 4096]);
    /// let bytes = scene.view().bytes();
    /// saved.0[..bytes.len()].copy_from_slice(bytes);
    /// let ray = hug::Ray::new([0.2, 0.3, 1.0], [0.0, 0.0, -1.0]);
    /// assert!(hug::View::open(&saved.0)?.occluded(&ray));
    /// saved.0[40] ^= 1;
    /// assert!(hug::View::open(&saved.0).is_err());
    /// # Ok::<(), hug::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Alignment`] unless the bytes are aligned to 64; otherwise what
    /// is wrong with them.
    pub fn open(bytes: &'a [u8]) -> Result<Self, Error> {
        fpenv::with_default(|| check::check(bytes))?;
        Ok(Self { base: bytes.as_ptr(), marker: PhantomData })
    }

    /// Reads bytes that are known to be an arena, without looking at them.
    ///
    /// # Safety
    /// The bytes must be an arena that a build wrote, aligned to 64.
    #[must_use]
    pub unsafe fn open_trusted(bytes: &'a [u8]) -> Self {
        Self { base: bytes.as_ptr(), marker: PhantomData }
    }

    /// The view of an arena that starts at `base`.
    ///
    /// # Safety
    /// As [`View::open_trusted`], for as long as `'a`.
    #[cfg(feature = "capi")]
    pub(crate) unsafe fn from_ptr(base: *const u8) -> Self {
        Self { base, marker: PhantomData }
    }

    /// The arena's bytes, to be saved or copied.
    #[must_use]
    pub fn bytes(&self) -> &'a [u8] {
        // SAFETY: the header's size is the arena's.
        unsafe { core::slice::from_raw_parts(self.base, self.header().bytes as usize) }
    }

    /// The box of the triangles, as lower and upper corner; infinite and
    /// inverted for an empty scene.
    #[must_use]
    pub fn bounds(&self) -> ([f32; 3], [f32; 3]) {
        (self.header().lower, self.header().upper)
    }

    pub(crate) fn header(&self) -> &'a Header {
        // SAFETY: an arena starts with an aligned header.
        unsafe { &*self.base.cast() }
    }

    #[inline(always)]
    fn start<T>(&self, section: &Section) -> *const T {
        // SAFETY: sections lie in the block, at aligned offsets.
        unsafe { self.base.add(section.offset as usize).cast() }
    }

    fn all<T>(&self, section: &Section) -> &'a [T] {
        // SAFETY: sections lie in the block and hold `count` records.
        unsafe { core::slice::from_raw_parts(self.start(section), section.count as usize) }
    }

    pub(crate) fn grids(&self) -> &'a [Grid] {
        self.all(&self.header().grids)
    }

    pub(crate) fn triangles(&self) -> &'a [Triangle] {
        self.all(&self.header().triangles)
    }

    /// The pointers a walk keeps at hand.
    #[inline(always)]
    pub(crate) fn sections(&self) -> Sections<'a> {
        let h = self.header();
        Sections {
            grids: self.start(&h.grids),
            voxels: self.start(&h.voxels),
            refs: self.start(&h.refs),
            triangles: self.start(&h.triangles),
            frames: self.start(&h.frames),
            nodes: self.start(&h.nodes),
            marker: PhantomData,
        }
    }
}

/// The starts of the sections, with unchecked access by number.
#[derive(Clone, Copy)]
pub(crate) struct Sections<'a> {
    grids: *const Grid,
    voxels: *const u32,
    refs: *const u32,
    triangles: *const Triangle,
    frames: *const Frame,
    /// Of the kind that the header says.
    nodes: *const u8,
    marker: PhantomData<&'a [u8]>,
}

impl<'a> Sections<'a> {
    /// Grid number `i`: 0 of a scene that is not empty, or from a reference.
    #[inline(always)]
    pub fn grid(&self, i: u32) -> &'a Grid {
        // SAFETY: see the module.
        unsafe { &*self.grids.add(i as usize) }
    }

    /// The frame of grid number `i`, which is turned.
    #[inline(always)]
    pub fn frame(&self, i: u32) -> &'a Frame {
        // SAFETY: see the module.
        unsafe { &*self.frames.add(i as usize) }
    }

    /// The node that a part's word names; [`NODE`] is the word of the first. `N` is what the header
    /// says.
    #[inline(always)]
    pub fn node<N: AnyNode>(&self, part: u32) -> &'a N {
        debug_assert!(part % (1 << NODE_SHIFT) == NODE);
        // SAFETY: see the module.
        unsafe { &*self.nodes.add(N::place(part)).cast() }
    }

    /// Bounds of all nodes, which are there and of this kind, along the axes: for each set of axes,
    /// a bit each, the upper bounds along these and the lower along others, where a ray comes to
    /// first that descends on them.
    #[inline(always)]
    pub fn bounds<N: AnyNode>(&self, descending: usize) -> [Bounds<'a, N>; 3] {
        let [x, y, z] = N::FIRST[descending % 8];
        let bounds = |row: usize| {
            // SAFETY: there is a node at least, which this row lies in.
            let rows = unsafe { self.nodes.add(row) };
            Bounds { rows, marker: PhantomData }
        };
        [bounds(x), bounds(y), bounds(z)]
    }

    /// Fetches what a part's word names: four lines, which are a node or most of a leaf. Two are enough
    /// for nodes of 96 bytes, wherever these begin.
    #[inline(always)]
    pub fn fetch_part<N: AnyNode, L: Lanes>(&self, l: L, part: u32) {
        let node = self.nodes.wrapping_add(N::place(part));
        // The number of triangles, in the lower bits, makes less than a triangle of it.
        let place = (part as usize).wrapping_mul(size_of::<Triangle>() >> LEAF_SHIFT);
        let leaf = self.triangles.cast::<u8>().wrapping_add(place);
        let is_node = part & NODE == NODE;
        let lines = select_unpredictable(is_node, node, leaf).cast::<[u8; 64]>();
        (0..2).for_each(|line| l.prefetch(lines.wrapping_add(line)));
        if !is_node || size_of::<N>() > 128 {
            (2..4).for_each(|line| l.prefetch(lines.wrapping_add(line)));
        }
    }

    /// Voxel number `i` of some grid.
    #[inline(always)]
    pub fn voxel(&self, i: usize) -> u32 {
        // SAFETY: see the module.
        unsafe { *self.voxels.add(i) }
    }

    /// The exit box and the references of the list at `offset`, a voxel's payload.
    #[inline(always)]
    pub fn list(&self, offset: u32) -> (u32, &'a [u32]) {
        // SAFETY: see the module.
        unsafe {
            let head = self.refs.add(offset as usize);
            (*head, core::slice::from_raw_parts(head.add(LIST_HEAD), *head.add(1) as usize))
        }
    }

    /// The exit box and the number of references of the list at `offset`.
    #[inline(always)]
    pub fn head(&self, offset: u32) -> (u32, u32) {
        // SAFETY: see the module.
        unsafe {
            let head = self.refs.add(offset as usize);
            (*head, *head.add(1))
        }
    }

    /// Eight words from number `at` of the references' section on, which must be one of
    /// a list: references or boxes, then whatever follows them.
    #[inline(always)]
    pub fn eight(&self, at: u32) -> &'a [u32; 8] {
        // SAFETY: see the module; behind the section is a triangle at least.
        unsafe { &*self.refs.add(at as usize).cast() }
    }

    /// Fetches grid number `i`.
    #[inline(always)]
    pub fn fetch_grid<L: Lanes>(&self, l: L, i: u32) {
        l.prefetch(self.grids.wrapping_add(i as usize));
    }

    /// Fetches a voxel; any number will do.
    #[inline(always)]
    pub fn fetch_voxel<L: Lanes>(&self, l: L, i: u32) {
        l.prefetch(self.voxels.wrapping_add(i as usize));
    }

    /// Fetches a line of the references' section and the next.
    #[inline(always)]
    pub fn fetch_list<L: Lanes>(&self, l: L, offset: u32) {
        let at = self.refs.wrapping_add(offset as usize);
        l.prefetch(at);
        l.prefetch(at.wrapping_add(16));
    }

    /// Fetches triangle number `i`.
    #[inline(always)]
    pub fn fetch_triangle<L: Lanes>(&self, l: L, i: u32) {
        let at = self.triangles.wrapping_add(i as usize).cast::<u8>();
        l.prefetch(at);
        l.prefetch(at.wrapping_add(size_of::<Triangle>() - 1));
    }

    /// How many triangles and how many grids voxel number `i` refers to.
    pub fn counts(&self, i: usize) -> (u64, u64) {
        let voxel = self.voxel(i);
        match voxel >> TAG_SHIFT {
            LIST => {
                let (_, refs) = self.list(voxel & PAYLOAD);
                let grids = refs.iter().filter(|&&r| r & GRID_BIT != 0).count();
                ((refs.len() - grids) as u64, grids as u64)
            }
            GRID => (0, 1),
            _ => (0, 0),
        }
    }

    /// The triangles' coordinates along axis `k`, 0 to 2.
    #[inline(always)]
    pub fn axis(&self, k: usize) -> Axis<'a> {
        // SAFETY: a triangle starts with three rows, and there is at least one.
        let rows = unsafe { self.triangles.cast::<[f32; 4]>().add(k.min(2)) };
        Axis { rows, marker: PhantomData }
    }

    /// The triangles' coordinates along the axes, in this order.
    #[inline(always)]
    pub fn axes(&self, order: &Order) -> [Axis<'a>; 3] {
        let axis = |k: usize| {
            // SAFETY: a triangle starts with three rows, one of which `Order::new` has taken, and
            // there is at least one.
            let rows = unsafe { self.triangles.cast::<u8>().add(order.rows[k]).cast() };
            Axis { rows, marker: PhantomData }
        };
        [axis(0), axis(1), axis(2)]
    }

    /// Triangle number `i`, from a reference or a leaf.
    #[inline(always)]
    pub fn triangle(&self, i: u32) -> &'a Triangle {
        // SAFETY: see the module.
        unsafe { &*self.triangles.add(i as usize) }
    }
}

/// One of the six rows of bounds of all nodes.
#[derive(Clone, Copy)]
pub(crate) struct Bounds<'a, N> {
    rows: *const u8,
    marker: PhantomData<&'a N>,
}

impl<'a, N: AnyNode> Bounds<'a, N> {
    /// That of the node that a part's word names.
    #[inline(always)]
    pub fn row(&self, part: u32) -> &'a N::Row {
        debug_assert!(part % (1 << NODE_SHIFT) == NODE);
        // SAFETY: see the module.
        unsafe { &*self.rows.add(N::place(part)).cast() }
    }
}

/// The three axes in some order.
#[derive(Clone, Copy)]
pub(crate) struct Order {
    /// That order, for lanes; the fourth stays where it is.
    pub lanes: [i32; 4],
    /// How many bytes from a triangle's first coordinates.
    rows: [usize; 3],
}

impl Order {
    const fn new(lanes: [i32; 4]) -> Self {
        let mut rows = [0; 3];
        let mut k = 0;
        while k < 3 {
            assert!(0 <= lanes[k] && lanes[k] < 3);
            rows[k] = lanes[k] as usize * size_of::<[f32; 4]>();
            k += 1;
        }
        Self { lanes, rows }
    }

    /// For each axis a cyclic order in which it is third.
    pub const THIRD: [Self; 3] =
        [Self::new([1, 2, 0, 3]), Self::new([2, 0, 1, 3]), Self::new([0, 1, 2, 3])];
}

/// The coordinates of all triangles along an axis.
#[derive(Clone, Copy)]
pub(crate) struct Axis<'a> {
    rows: *const [f32; 4],
    marker: PhantomData<&'a [u8]>,
}

impl<'a> Axis<'a> {
    /// Those of the corners of a triangle, from three times its number, which is a
    /// reference's, a leaf's, below one of these or in a leaf's eight, where there may be no such
    /// triangle and numbers mean nothing; the fourth number never does.
    #[inline(always)]
    pub fn row(&self, thrice: u32) -> &'a [f32; 4] {
        // SAFETY: see the module; a triangle is three rows.
        unsafe { &*self.rows.add(thrice as usize) }
    }
}
