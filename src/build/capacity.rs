//! How much memory a build can need: a function of counts alone.
//!
//! For n triangles, G grids, L links between them, V voxels and R references the scratch memory is
//! about `64 n + 136 G + 12 L + 20 V + 8 R` bytes, for a hierarchy `41 n` more, and the arena
//! `48 n + 64 G + 12 V + 8 R`; where grids may be turned, `144 G` and `128 G` more; with a tree
//! of boxes `113 n` and `65 n` more, or, should grids need less than the binary tree that was in
//! their memory before, `171 n` in all besides what triangles take.
//! Every pass keeps to these capacities: grids are made coarser, or the
//! recursion stops, before one is exceeded.

use super::cluster::Part;
use super::draft::Span;
use super::frame::Grid;
use super::tree;
use super::turn::Turn;
use crate::Error;
use crate::aabb::Aabb;
use crate::arena::layout::{Counts, REF_WORDS, Triangle, sections};
use crate::options::{Options, Orientation, Structure};

/// Bytes that [`super::plan`] and [`super::Plan::write`] need at the most.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sizes {
    /// Size of the arena, a multiple of 64.
    pub arena: usize,
    /// Size of the scratch memory, a multiple of 64.
    pub scratch: usize,
}

/// Most records of each kind.
#[derive(Clone, Copy, Debug)]
pub struct Capacity {
    pub triangles: usize,
    /// Triangles of which a hierarchy's passes remember things: all or none.
    pub filtered: usize,
    pub grids: usize,
    /// Grids of which it is known how they are turned: all or none.
    pub turns: usize,
    pub voxels: usize,
    pub refs: usize,
    /// Entries of the bucket sort's stream: a grid's references and objects.
    pub stream: usize,
    /// Pairs of a grid and a grid that points to it.
    pub links: usize,
    /// Entries of the table that exit boxes are grown with.
    pub table: usize,
    /// Triangles that a tree of boxes is built over: all or none.
    pub tree: usize,
    /// Whether its nodes are written in less.
    pub quantized: bool,
}

/// Voxels that a grid over `objects` objects can have with `alpha`: rounding
/// three counts of at least 1 makes at most 27 / 8 of `alpha^3 N`.
fn voxels(alpha: f32, objects: f64) -> f64 {
    let a = f64::from(alpha);
    4.0 * a * a * a * objects + 1.0
}

impl Capacity {
    pub fn new(triangles: usize, options: &Options) -> Self {
        let n = triangles as f64;
        let per_object = f64::from(options.max_refs);
        let hug = matches!(options.structure, Structure::Auto | Structure::Hug);
        let recursive = options.structure == Structure::Recursive;
        let links = if hug { 4.0 * n / f64::from(options.min_cluster) + 1.0 } else { 0.0 };
        let explicit: u64 = options.counts.iter().map(|&c| u64::from(c)).product();
        let outer = (explicit as f64).max(voxels(options.outer_alpha(), n + links));
        let (mut inner, mut refs) = (0.0, per_object * (n + links));
        let mut grids = 1.0 + links;
        if hug {
            inner = voxels(options.alpha, n + links) + grids;
        } else if recursive {
            // Voxels and references of grids below, replaced lists included.
            inner = 2.0 * voxels(options.alpha, n);
            refs *= 2.0;
            grids += refs / (f64::from(options.maxp) + 1.0);
        }
        let whole = |x: f64| (x.min(f64::from(u32::MAX - 1))) as usize + 1;
        let none = triangles == 0;
        let turned = hug && options.orientation != Orientation::Aligned;
        let tree = options.tree && !hug && triangles < tree::MOST;
        Self {
            triangles,
            tree: if tree { triangles } else { 0 },
            quantized: options.compact,
            filtered: if hug { triangles } else { 0 },
            grids: if none { 0 } else { whole(grids) },
            turns: if none || !turned { 0 } else { whole(grids) },
            voxels: if none { 0 } else { whole(outer + inner) },
            refs: if none { 0 } else { whole(refs) },
            stream: if none { 0 } else { whole((per_object + 1.0) * (n + links)) },
            links: if none { 0 } else { whole(links) },
            // A grid of n voxels takes n / 8 words and its largest plane twice over,
            // flat ones 2 n; where it does not fit, the grid goes without exit boxes.
            table: if none || !options.exit_boxes {
                0
            } else {
                whole(1.5 * outer.max(inner) + 256.0)
            },
        }
    }

    pub fn sizes(&self) -> Result<Sizes, Error> {
        // A list has two words besides its references, at least one of these, of two
        // words each, and a voxel of its own.
        let heads = self.refs.min(self.voxels).saturating_mul(2);
        let words = self.refs.saturating_mul(REF_WORDS).saturating_add(heads);
        let (_, arena) = sections(&Counts {
            grids: self.grids as u64,
            voxels: self.voxels as u64,
            refs: words as u64,
            triangles: self.triangles as u64,
            frames: self.turns as u64,
            nodes: tree::capacity(self.tree) as u64,
            quantized: self.quantized,
        })?;
        let [nodes, for_nodes, for_triangles] = tree::records(self.tree);
        let all = [
            (self.triangles, size_of::<Triangle>()),
            (self.filtered, size_of::<Aabb>()),
            // The objects of the grid at hand, before the order of the tree.
            (self.triangles + self.links, 4),
            (self.table, 8),
            nodes,
        ];
        let grids = [
            // The triangles' order, and notes of the bucket sort.
            (self.triangles, 4 + 8),
            // The clustering's order and parts, levels.
            (self.filtered, 4 + size_of::<Part>() + 1),
            (self.grids, size_of::<Grid>() + size_of::<[u32; 2]>()),
            (self.turns, size_of::<Turn>()),
            (self.links, size_of::<[u32; 2]>()),
            (self.voxels, size_of::<Span>()),
            (self.refs, 4),
            (self.stream, 4),
            // In the order of the tree.
            (self.tree, size_of::<Triangle>()),
        ];
        // The tree is built before the grids, in the same memory. Room to align each slice.
        let memory = bytes(&grids)?.max(bytes(&[for_nodes, for_triangles])?);
        let scratch = bytes(&all)?.checked_add(memory).ok_or(Error::Overflow)?;
        let scratch = scratch.checked_add(64 * 20).ok_or(Error::Overflow)?;
        let scratch = scratch.checked_next_multiple_of(64).ok_or(Error::Overflow)?;
        isize::try_from(scratch).map_err(|_| Error::Overflow)?;
        Ok(Sizes { arena: arena as usize, scratch })
    }
}

/// Bytes for so many records of these sizes.
fn bytes(records: &[(usize, usize)]) -> Result<usize, Error> {
    records.iter().try_fold(0usize, |sum, &(count, size)| {
        let bytes = count.checked_mul(size).ok_or(Error::Overflow)?;
        sum.checked_add(bytes).ok_or(Error::Overflow)
    })
}
