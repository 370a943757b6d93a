//! The parameters of a build, named as in the paper.
//!
//! The default of every field is the one to use unless a measurement says
//! otherwise; a zeroed C descriptor means the same defaults.

use core::f32::consts::SQRT_2;

use crate::Error;
use crate::math::cbrt;
use crate::simd::fpenv;

/// Most levels a hierarchy can have: the depth of nested grids.
pub const MAX_LEVELS: usize = 16;

/// Which of the paper's three structures to build (section 1.3).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u32)]
pub enum Structure {
    /// Chosen from the triangles; a pure function of triangles and options.
    #[default]
    Auto = 0,
    /// One uniform grid.
    Uniform = 1,
    /// A grid whose crowded voxels are grids again.
    Recursive = 2,
    /// A hierarchy of uniform grids over filtered, clustered triangles.
    Hug = 3,
}

/// How a grid's voxel counts follow from its box and its number of objects.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u32)]
pub enum Gridding {
    /// In proportion to the box's sides (Klimaszewski & Sederberg 1997), so
    /// that voxels are near cubes.
    #[default]
    Proportional = 0,
    /// The same count along every axis, as in the paper.
    Homogeneous = 1,
    /// The more along an axis, the less the objects overlap along it
    /// (Definition 4): `n_i` in proportion to `(1 + c_i)^-q`, with `c_i` the
    /// objects that an end of an object lies in on the average and `q`
    /// [`Options::overlap_power`]. Turned clusters take [`Gridding::Proportional`].
    Overlap = 2,
    /// [`Gridding::Proportional`] times [`Gridding::Overlap`].
    Mixed = 3,
}

impl Gridding {
    /// Whether counts depend on overlap numbers.
    pub(crate) fn overlaps(self) -> bool {
        matches!(self, Self::Overlap | Self::Mixed)
    }
}

/// What a cluster of a hierarchy of uniform grids is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u32)]
pub enum Clustering {
    /// Objects whose projections are delta-connected along x, y and z
    /// (Definition 3).
    #[default]
    Projections = 0,
    /// A connected component of the graph of boxes that intersect
    /// (Definition 5); `delta` and `connectivity` say nothing.
    Components = 1,
}

/// What `f_k` stands for in `delta_k = alpha * f_k` (Definition 2).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u32)]
pub enum Delta {
    /// The middle of the level's interval of lengths, as in Definition 1.
    #[default]
    Midpoint = 0,
    /// The mean length of the level's objects.
    Mean = 1,
}

/// Which grids point to which (section 1.3, "the last step").
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u32)]
pub enum Hierarchy {
    /// A grid hangs under the smallest grid of the next higher level that
    /// contains its whole box, else of the level above, at last the world.
    #[default]
    Nested = 0,
    /// A grid hangs under every higher grid it intersects, and under the world
    /// unless one of them contains it whole. Where so many grids lie in one another that
    /// there were more than 16 ways from the world to a grid, on average, as nested.
    Paper = 1,
}

/// How the boxes of a HUG's clusters lie (section 7.2).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u32)]
pub enum Orientation {
    /// Along the axes of the scene.
    #[default]
    Aligned = 0,
    /// Along the principal components of the vertices.
    Vertices = 1,
    /// Along those of the convex hull's surface, by area (Gottschalk et al. 1996).
    Hull = 2,
    /// As a direct search for a small surface finds.
    Search = 3,
}

/// The filter of lengths of a hierarchy of uniform grids (Definition 1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Filter {
    /// Two levels split at this share of the largest length (section 7.1).
    TwoLevels(f32),
    /// Three levels, split where the logarithm of the lengths falls into three
    /// classes of least variance (Otsu 1979 with two thresholds, 128 classes).
    ThreeLevels,
    /// The inner thresholds `f_2 < f_3 < ...`, in the units of the scene; the
    /// first `count` of them are used.
    Thresholds {
        /// How many thresholds are set, one less than the number of levels.
        count: usize,
        /// The thresholds, strictly increasing, finite and positive.
        at: [f32; MAX_LEVELS - 1],
    },
}

impl Default for Filter {
    fn default() -> Self {
        Self::TwoLevels(0.05)
    }
}

/// How fine a structure AUTO builds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u32)]
pub enum Quality {
    /// Between the two others.
    #[default]
    Default = 0,
    /// Built soonest: fewer, coarser voxels.
    Fast = 1,
    /// Traced soonest: more, finer voxels, which take more time and memory to build.
    High = 2,
}

/// Everything a build can be told.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Which structure to build.
    pub structure: Structure,
    /// How voxel counts follow from the box.
    pub gridding: Gridding,
    /// How strongly overlap numbers act, for the griddings that look at them:
    /// the `q` of [`Gridding::Overlap`]. In (0, 4].
    pub overlap_power: f32,
    /// Voxel counts of the outermost grid along x, y, z, each at most 2048;
    /// zeros derive them from `alpha` or `world_alpha`.
    pub counts: [u32; 3],
    /// Voxels per axis and cube root of the objects (the cube-root criterion):
    /// `alpha^3 N` voxels for `N` objects. In [0.1, 16]. AUTO takes `alpha`, `world_alpha`
    /// and `maxp` from the quality.
    pub alpha: f32,
    /// The same for the outermost grid, in [0.1, 16]. Unless set, it is `alpha` for
    /// the uniform and the recursive grid. For the HUG's world cluster it is the
    /// paper's sqrt(2), or with a filter of two levels (section 7.5) 2, but then for
    /// no more voxels than sqrt(2) makes for all triangles.
    pub world_alpha: Option<f32>,
    /// Recursive grid: a voxel with more references than this becomes a grid.
    pub maxp: u32,
    /// Recursive grid: most levels of grids, 1 to [`MAX_LEVELS`].
    pub max_depth: u32,
    /// Recursive grid: where the outermost grid's crowded voxels hold fewer references than the
    /// scene has triangles, the grids below get a greater alpha: such that those directly below
    /// have `alpha^3` voxels for each triangle of the scene together, but 1 at most. So where
    /// little is crowded, that is cut finely. Without effect from an alpha of 1 on. AUTO does so.
    pub fill_up: bool,
    /// Uniform and recursive grids: whether a tree of boxes lies beside the grid, for rays on
    /// their own. It has some 10 bytes a triangle and takes longer to build than a grid; rays
    /// that take it are two or three times as fast. Hits are the same. Of 2^28
    /// triangles or more, of fewer than 8, of those that are tiny beside the scene's extent, and
    /// of a HUG's, whose triangles lie cluster by cluster, there is none. If `quality` is HIGH,
    /// it is built with more care; if `compact`, it takes three eighths of the memory. AUTO builds
    /// it with the qualities DEFAULT and HIGH.
    pub tree: bool,
    /// HUG: the filter of lengths.
    pub filter: Filter,
    /// HUG: what a cluster is.
    pub clustering: Clustering,
    /// HUG: the connectivity coefficient alpha of Definition 2. In (0, 1e6].
    pub connectivity: f32,
    /// HUG: what length delta is a multiple of.
    pub delta: Delta,
    /// HUG: which grids point to which.
    pub hierarchy: Hierarchy,
    /// HUG: a cluster of fewer objects pops up into the world. At least 1.
    pub min_cluster: u32,
    /// HUG: how the boxes of clusters without grids below lie.
    pub orientation: Orientation,
    /// HUG: a cluster's box is turned if it has less than this share of the surface of the
    /// aligned one. In (0, 1e6]; what it costs to turn rays is worth about 0.8.
    pub turn_below: f32,
    /// Whether voxels get exit boxes, which let a ray skip what holds nothing
    /// new. Without them the walk is the plain 3-D DDA of the paper's time; the
    /// hits are the same.
    pub exit_boxes: bool,
    /// Most references a grid may hold per object in it, 1 to 4096. Grids whose
    /// counts follow from alpha are made coarser until they keep to it, and
    /// the recursive grid stops splitting; with `counts` the build fails.
    pub max_refs: u32,
    /// AUTO: how fine. The other structures have parameters of their own.
    pub quality: Quality,
    /// AUTO: the smallest grids that are still sensible, whatever the quality, which then says
    /// whether there is a tree (with FAST there is none) and with how much care it is built. Of every
    /// structure: a tree has nodes of 96 bytes in place of 256, with boxes in 8 bits; rays that
    /// take it have 0.8 to 0.95 of the speed.
    pub compact: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            structure: Structure::Auto,
            gridding: Gridding::Proportional,
            overlap_power: 0.5,
            counts: [0; 3],
            alpha: 1.0,
            world_alpha: None,
            maxp: 50,
            max_depth: 8,
            fill_up: false,
            tree: false,
            filter: Filter::default(),
            clustering: Clustering::Projections,
            connectivity: 1.0,
            delta: Delta::Midpoint,
            hierarchy: Hierarchy::Nested,
            min_cluster: 8,
            orientation: Orientation::Aligned,
            turn_below: 0.8,
            exit_boxes: true,
            max_refs: 32,
            quality: Quality::Default,
            compact: false,
        }
    }
}

/// The alpha of the world cluster under a filter of two levels, where that has room.
const TWO_LEVELS_ALPHA: f32 = 2.0;

/// Voxels of AUTO's outermost grid, about: half a megabyte, so that the grid where every
/// ray begins stays in the second cache of most processors. Crowded voxels are split anyway;
/// but where triangles are everywhere alike, not before their lists are long, so that there
/// is a voxel for every eight triangles at least.
const WORLD_VOXELS: f64 = (1u32 << 17) as f64;
const WORLD_SHARE: f64 = 1.0 / 8.0;
/// Where triangles are so few that all of a scene may stay in a cache, there are more, as far
/// as voxels times triangles are no more than this: 2^18 voxels for 2^17 triangles.
const WORLD_TIMES: f64 = (1u64 << 35) as f64;

/// Largest voxel count along an axis.
pub(crate) const MAX_COUNT: u32 = 2048;

impl Options {
    /// Whether every field is in its range.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] if one is not.
    pub fn check(&self) -> Result<(), Error> {
        fpenv::with_default(|| self.check_ranges())
    }

    fn check_ranges(&self) -> Result<(), Error> {
        let alpha = |a: f32| (0.1..=16.0).contains(&a);
        let explicit = self.counts.iter().all(|&n| (1..=MAX_COUNT).contains(&n));
        let filter = match self.filter {
            Filter::TwoLevels(share) => share > 0.0 && share <= 1.0,
            Filter::ThreeLevels => true,
            Filter::Thresholds { count, at } => {
                count < MAX_LEVELS
                    && at[..count].iter().all(|f| f.is_finite() && *f > 0.0)
                    && at[..count].is_sorted_by(|a, b| a < b)
            }
        };
        let ok = (self.counts == [0; 3] || explicit)
            && alpha(self.alpha)
            && self.world_alpha.is_none_or(alpha)
            && self.maxp >= 1
            && (1..=MAX_LEVELS as u32).contains(&self.max_depth)
            && filter
            && self.overlap_power > 0.0
            && self.overlap_power <= 4.0
            && self.connectivity > 0.0
            && self.connectivity <= 1e6
            && self.min_cluster >= 1
            && self.turn_below > 0.0
            && self.turn_below <= 1e6
            && (1..=4096).contains(&self.max_refs);
        if ok { Ok(()) } else { Err(Error::InvalidValue) }
    }

    /// These options with the structure that AUTO stands for, for that many triangles.
    pub(crate) fn resolved(&self, triangles: usize) -> Self {
        if self.structure != Structure::Auto {
            return *self;
        }
        let (world_alpha, alpha, maxp) = match self.quality {
            _ if self.compact => (0.35, 0.2, 1024),
            Quality::Fast => (0.5, 0.4, 512),
            Quality::Default => (0.63, 0.4, 512),
            Quality::High => (1.26, 0.7, 128),
        };
        let n = triangles.max(1) as f64;
        let most = cbrt((WORLD_TIMES / n).max(WORLD_VOXELS).max(WORLD_SHARE * n) / n) as f32;
        let world_alpha = Some(if most < world_alpha { most } else { world_alpha });
        let structure = Structure::Recursive;
        let tree = self.quality != Quality::Fast;
        Self { structure, maxp, alpha, world_alpha, fill_up: true, tree, ..*self }
    }

    /// The alpha of the outermost grid.
    pub(crate) fn outer_alpha(&self) -> f32 {
        let default = match self.structure {
            Structure::Auto | Structure::Hug => SQRT_2,
            Structure::Uniform | Structure::Recursive => self.alpha,
        };
        self.world_alpha.unwrap_or(default)
    }

    /// The alpha of the HUG's world cluster for `objects` objects in a scene of
    /// `triangles`: the voxels are as many as [`Options::outer_alpha`] allows for the
    /// triangles, or fewer.
    pub(crate) fn cluster_alpha(&self, objects: usize, triangles: usize) -> f32 {
        let most = self.outer_alpha();
        if self.world_alpha.is_some() || !matches!(self.filter, Filter::TwoLevels(_)) {
            return most;
        }
        let room = cbrt(triangles as f64 / objects.max(1) as f64) as f32;
        // Not by `clamp`, whose panic would bring the formatting of numbers, a sixtieth of the library.
        let alpha = if most * room > most { most * room } else { most };
        if alpha < TWO_LEVELS_ALPHA { alpha } else { TWO_LEVELS_ALPHA }
    }
}
