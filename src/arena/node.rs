//! The bytes of the tree of boxes: its nodes, in full and in less.
//!
//! A node has up to eight parts, nodes or runs of triangles, by their boxes. The first node is
//! the root. In the order of nodes, and of their parts' places, nodes from number 1 on and triangles
//! from number 0 on are named one after the other: so it is a tree, its nodes are level by level,
//! and each triangle is in one leaf. A part that is not there is a leaf of no triangles with an
//! inverted box, which in less is inverted by a few margins of a descent only: a ray from far away may
//! go there, and find nothing. Bounds are in coordinates from the header's `lower` on and times its
//! `unit`.

use bytemuck::{Pod, Zeroable};

/// Parts of a node.
pub const PARTS: usize = 8;
/// A part's word, if it is a leaf: the number of its first triangle times 16, and how many there
/// are.
pub const LEAF_SHIFT: u32 = 4;
/// A part's word, if it is a node: its number times 32, and [`NODE`]. Nodes' sizes are multiples
/// of 32, so that the word, multiplied, is a node's place.
pub const NODE_SHIFT: u32 = 5;
/// The lower four bits of a part's word, where it is a node.
pub const NODE: u32 = 15;
/// Most triangles of a leaf, and fewest of a scene that has a tree.
pub const LEAF: u32 = 8;
/// Units of a scene with nodes: what a descent computes then stays in the range of `f32`.
pub const TREE_UNITS: core::ops::RangeInclusive<f64> =
    1.0 / (1 << 28) as f64..=(1u128 << 100) as f64;
/// Most nodes on the way from the first to a leaf.
pub const MAX_DEPTH: usize = 64;

/// A node in full: four cache lines.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C, align(64))]
pub struct Node {
    /// Lower and upper bounds of the parts along x, then y, then z.
    pub bounds: [[f32; PARTS]; 6],
    /// See [`LEAF_SHIFT`] and [`NODE_SHIFT`].
    pub parts: [u32; PARTS],
    pub reserved: [u32; PARTS],
}

/// A node of a compact arena: bounds are eight bits, from the lowest of the node on, in steps of
/// a power of two along each axis (as in Ylitie, Karras & Laine 2017). A line and a half.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C, align(32))]
pub struct QuantizedNode {
    /// As those of a [`Node`], in steps.
    pub bounds: [[u8; PARTS]; 6],
    /// See [`LEAF_SHIFT`] and [`NODE_SHIFT`].
    pub parts: [u32; PARTS],
    pub origin: [f32; 3],
    /// The exponents of steps, as in an `f32`: a step is 2^(e - 127), or 0, and in bytes from
    /// elsewhere perhaps infinite.
    pub exponents: [u8; 3],
    pub reserved: u8,
}

const _: () = assert!(size_of::<Node>() == 256);
const _: () = assert!(size_of::<QuantizedNode>() == 96);

/// Nodes of either kind.
pub trait AnyNode: Pod {
    /// Bounds of eight parts.
    type Row: Pod;

    fn parts(&self) -> &[u32; PARTS];

    /// For each set of axes, a bit each, how many bytes from a node's first are the rows of the
    /// upper bounds along these and of the lower along others.
    const FIRST: [[usize; 3]; 8] = {
        let mut rows = [[0; 3]; 8];
        let mut i = 0;
        while i < 24 {
            let (set, axis) = (i / 3, i % 3);
            rows[set][axis] = (2 * axis + (set >> axis & 1)) * size_of::<Self::Row>();
            i += 1;
        }
        rows
    };

    /// How many bytes lie before the node that a part's word names.
    #[inline(always)]
    fn place(part: u32) -> usize {
        // Nothing else is in the words of nodes, so no bit has to be masked. What the words of leaves
        // make may wrap, and is not looked at.
        const { assert!(size_of::<Self>().is_multiple_of(1 << NODE_SHIFT)) };
        let scale = size_of::<Self>() >> NODE_SHIFT;
        (part as usize).wrapping_mul(scale).wrapping_sub(NODE as usize * scale)
    }

    /// Whether nothing is in what means nothing.
    fn is_clean(&self) -> bool;
}

impl AnyNode for Node {
    type Row = [f32; PARTS];

    #[inline(always)]
    fn parts(&self) -> &[u32; PARTS] {
        &self.parts
    }

    fn is_clean(&self) -> bool {
        self.reserved == [0; PARTS]
    }
}

impl AnyNode for QuantizedNode {
    type Row = [u8; PARTS];

    #[inline(always)]
    fn parts(&self) -> &[u32; PARTS] {
        &self.parts
    }

    fn is_clean(&self) -> bool {
        self.reserved == 0
    }
}

impl QuantizedNode {
    /// How long a step is along axis `k`, 0 to 2.
    #[inline(always)]
    pub fn step(&self, k: usize) -> f32 {
        f32::from_bits(u32::from(self.exponents[k]) << 23)
    }
}
