//! Nodes, of both kinds, as their bytes say.

use crate::common::layout::*;
use std::ops::Range;

/// Where things are in a node.
pub struct Kind {
    pub size: usize,
    /// The words of its eight parts.
    pub parts: Range<usize>,
    /// What is zero.
    pub unused: Range<usize>,
    /// Bytes of a bound; there are six rows of eight, which come first.
    pub bound: usize,
}

/// Of the nodes in an arena.
pub fn kind(bytes: &[u8]) -> Kind {
    if get64(bytes, QUANTIZED) == 0 {
        Kind { size: NODE, parts: PARTS, unused: UNUSED, bound: 4 }
    } else {
        let [parts, unused] = [QUANTIZED_PARTS, QUANTIZED_UNUSED];
        Kind { size: QUANTIZED_NODE, parts, unused, bound: 1 }
    }
}

/// Where the word of a part of a node is.
pub fn part_at(bytes: &[u8], number: usize, part: usize) -> usize {
    record(bytes, NODES, number) + kind(bytes).parts.start + 4 * part
}

/// What a part's word says: the number of a node and [`IS_NODE`], or that of a leaf's first triangle
/// and how many there are.
pub fn named(word: u32) -> (u32, u32) {
    let kind = word & 15;
    (if kind == IS_NODE { word >> 5 } else { word >> 4 }, kind)
}

/// The word that says this.
pub fn word_of(place: u32, kind: u32) -> u32 {
    if kind == IS_NODE { place << 5 | kind } else { place << 4 | kind }
}

/// The parts of all nodes, in order: number of the node, which of its parts, and the word.
pub fn parts(bytes: &[u8]) -> Vec<(usize, usize, u32)> {
    let places = (0..count(bytes, NODES)).flat_map(|node| (0..8).map(move |part| (node, part)));
    places.map(|(node, part)| (node, part, get32(bytes, part_at(bytes, node, part)))).collect()
}

/// What an axis of a quantized node is counted in: from where on, and the step.
pub fn steps(bytes: &[u8], number: usize, axis: usize) -> [f32; 2] {
    let at = record(bytes, NODES, number);
    let origin = f32::from_bits(get32(bytes, at + ORIGIN + 4 * axis));
    [origin, f32::from_bits(u32::from(bytes[at + EXPONENTS + axis]) << 23)]
}

/// The box of a part of a node: lower and upper bound along x, y, z.
pub fn bounds(bytes: &[u8], number: usize, part: usize) -> [f32; 6] {
    let (kind, at) = (kind(bytes), record(bytes, NODES, number));
    [0, 1, 2, 3, 4, 5].map(|row| {
        let at = at + kind.bound * (8 * row + part);
        if kind.bound == 4 {
            return f32::from_bits(get32(bytes, at));
        }
        let [origin, step] = steps(bytes, number, row / 2);
        step.mul_add(f32::from(bytes[at]), origin)
    })
}

/// Calls `put` with where the bounds of all parts are, and with 0 for a lower and 1 for an upper one.
pub fn each_bound(bytes: &mut [u8], put: impl Fn(&mut [u8], usize)) {
    let kind = kind(bytes);
    for number in 0..count(bytes, NODES) {
        for i in 0..48 {
            let at = record(bytes, NODES, number) + kind.bound * i;
            put(&mut bytes[at..at + kind.bound], i / 8 % 2);
        }
    }
}
