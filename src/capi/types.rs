//! The C mirrors of the library's types: descriptors, records, constants.
//!
//! Every struct is `repr(C)`; enumerations are integers with constants, so that
//! an unknown value from C is an error status and never undefined behaviour.
#![allow(non_camel_case_types)]

use core::ffi::c_void;

pub use super::soa_types::{hug_hit_soa, hug_ray_soa};
pub use super::stat_types::{hug_counters, hug_level_shares, hug_level_stats, hug_scene_stats};

/// What a function that can fail returns: HUG_OK or one of HUG_ERROR_*.
pub type hug_status = i32;

/// Success.
pub const HUG_OK: hug_status = 0;
/// A required pointer is NULL.
pub const HUG_ERROR_NULL: hug_status = 1;
/// struct_size is smaller than the first version of the descriptor, or a field that this version does not know is not zero.
pub const HUG_ERROR_STRUCT_SIZE: hug_status = 2;
/// An option or enumeration is out of its range.
pub const HUG_ERROR_INVALID_VALUE: hug_status = 3;
/// A pointer or stride is not aligned as its type requires.
pub const HUG_ERROR_ALIGNMENT: hug_status = 4;
/// Input, scratch, arena or output memory overlap.
pub const HUG_ERROR_OVERLAP: hug_status = 5;
/// A count times a size does not fit the address space.
pub const HUG_ERROR_OVERFLOW: hug_status = 6;
/// A vertex index is not below its geometry's vertex count.
pub const HUG_ERROR_INDEX_RANGE: hug_status = 7;
/// The allocator returned NULL.
pub const HUG_ERROR_OUT_OF_MEMORY: hug_status = 8;
/// The scratch or arena memory handed in is too small.
pub const HUG_ERROR_BUFFER_TOO_SMALL: hug_status = 9;
/// More than 2^30 - 1 triangles, or more references than max_refs allows at the counts asked for.
pub const HUG_ERROR_LIMIT: hug_status = 10;
/// hug_open: the bytes end before the arena does.
pub const HUG_ERROR_TRUNCATED: hug_status = 11;
/// hug_open: the bytes do not begin with an arena's magic number.
pub const HUG_ERROR_MAGIC: hug_status = 12;
/// hug_open: the arena's format version is not this library's.
pub const HUG_ERROR_VERSION: hug_status = 13;
/// hug_open: the arena was written for a machine of other endianness.
pub const HUG_ERROR_ENDIANNESS: hug_status = 14;
/// hug_open: the arena's records contradict each other.
pub const HUG_ERROR_CORRUPT: hug_status = 15;
/// A bug in hug: a panic was stopped at the boundary.
pub const HUG_ERROR_INTERNAL: hug_status = 16;

/// The progress callback cancelled the build.
pub const HUG_ERROR_CANCELLED: hug_status = 17;
/// parallel_for returned before every task had been run.
pub const HUG_ERROR_UNFINISHED: hug_status = 18;
/// hug_open: sections overlap, leave gaps or the arena, or their sizes overflow.
pub const HUG_ERROR_SECTIONS: hug_status = 19;
/// hug_open: a grid points to itself, or to one that is not below it.
pub const HUG_ERROR_CYCLE: hug_status = 20;
/// hug_open: a voxel or list refers to a list, triangle or grid that there is not, or out of order.
pub const HUG_ERROR_REFERENCE: hug_status = 21;

/// The id that names nothing, in hits and in a ray's skip_geom and skip_prim.
pub const HUG_NONE: u32 = 0xffff_ffff;

/// Which structure to build: HUG_STRUCTURE_*.
pub type hug_structure = u32;
/// Chosen from the triangles: a pure function of triangles and options.
pub const HUG_STRUCTURE_AUTO: hug_structure = 0;
/// One uniform grid.
pub const HUG_STRUCTURE_UNIFORM: hug_structure = 1;
/// A grid whose crowded voxels are grids again.
pub const HUG_STRUCTURE_RECURSIVE: hug_structure = 2;
/// A hierarchy of uniform grids over filtered, clustered triangles.
pub const HUG_STRUCTURE_HUG: hug_structure = 3;

/// How voxel counts follow from a grid's box: HUG_GRIDDING_*.
pub type hug_gridding = u32;
/// In proportion to the sides of the box.
pub const HUG_GRIDDING_PROPORTIONAL: hug_gridding = 0;
/// The same count along every axis, as in the paper.
pub const HUG_GRIDDING_HOMOGENEOUS: hug_gridding = 1;
/// The more along an axis, the less the objects overlap along it (Definition 4): in
/// proportion to (1 + c)^-overlap_power, with c the objects that an end of an object
/// lies in on the average.
pub const HUG_GRIDDING_OVERLAP: hug_gridding = 2;
/// In proportion to the sides of the box and to the overlap's power.
pub const HUG_GRIDDING_MIXED: hug_gridding = 3;

/// What a cluster of a HUG is: HUG_CLUSTERING_*.
pub type hug_clustering = u32;
/// Triangles whose projections are delta-connected along x, y and z (Definition 3).
pub const HUG_CLUSTERING_PROJECTIONS: hug_clustering = 0;
/// A connected component of the graph of boxes that intersect (Definition 5).
pub const HUG_CLUSTERING_COMPONENTS: hug_clustering = 1;

/// What delta is a multiple of (Definition 2): HUG_DELTA_*.
pub type hug_delta = u32;
/// The middle of the level's interval of lengths.
pub const HUG_DELTA_MIDPOINT: hug_delta = 0;
/// The mean length of the level's objects.
pub const HUG_DELTA_MEAN: hug_delta = 1;

/// Which grids point to which: HUG_HIERARCHY_*.
pub type hug_hierarchy = u32;
/// A grid hangs under the smallest higher grid that contains it whole.
pub const HUG_HIERARCHY_NESTED: hug_hierarchy = 0;
/// A grid hangs under every higher grid that it intersects, as in the paper; nested where
/// that would make more than 16 ways from the world to a grid, on average.
pub const HUG_HIERARCHY_PAPER: hug_hierarchy = 1;

/// How the boxes of a HUG's clusters lie: HUG_ORIENTATION_*.
pub type hug_orientation = u32;
/// Along the axes of the scene.
pub const HUG_ORIENTATION_ALIGNED: hug_orientation = 0;
/// Along the principal components of the vertices.
pub const HUG_ORIENTATION_VERTICES: hug_orientation = 1;
/// Along those of the convex hull's surface.
pub const HUG_ORIENTATION_HULL: hug_orientation = 2;
/// As a direct search for a small surface finds.
pub const HUG_ORIENTATION_SEARCH: hug_orientation = 3;

/// How fine a structure AUTO builds: HUG_QUALITY_*.
pub type hug_quality = u32;
/// Between the two others.
pub const HUG_QUALITY_DEFAULT: hug_quality = 0;
/// Built soonest: fewer, coarser voxels.
pub const HUG_QUALITY_FAST: hug_quality = 1;
/// Traced soonest: more, finer voxels, which take more time and memory to build.
pub const HUG_QUALITY_HIGH: hug_quality = 2;

/// The type of a geometry's indices: HUG_INDEX_*.
pub type hug_index_type = u32;
/// No indices: triangle i is vertices 3 i, 3 i + 1, 3 i + 2.
pub const HUG_INDEX_NONE: hug_index_type = 0;
/// uint16_t, three a triangle, packed.
pub const HUG_INDEX_U16: hug_index_type = 1;
/// uint32_t, three a triangle, packed.
pub const HUG_INDEX_U32: hug_index_type = 2;

/// Build flag: no exit boxes, so that a step of the walk is one voxel, as in
/// the paper. The hits are the same.
pub const HUG_BUILD_PLAIN_STEPS: u32 = 1;

/// Build flag: AUTO makes the smallest grids that are still sensible, whatever the quality, which
/// then says whether there is a tree of boxes (with FAST there is none) and with how much care it
/// is built. Of every structure: such a tree has nodes of 96 bytes in place of 256, with boxes in
/// 8 bits; rays that take it have 0.8 to 0.95 of the speed.
pub const HUG_BUILD_COMPACT: u32 = 2;

/// hug_build flag: the scene keeps the build's scratch memory, so that hug_rebuild
/// allocates nothing, and has room for an arena larger by half. hug_free frees
/// it too.
pub const HUG_BUILD_KEEP_SCRATCH: u32 = 4;

/// Build flag, for the recursive grid: where the outermost grid's crowded voxels hold fewer
/// references than the scene has triangles, the grids below get a greater alpha, such that
/// those directly below have alpha^3 voxels for each triangle of the scene together, but 1 at
/// most. Without effect from an alpha of 1 on, the default. AUTO does so.
pub const HUG_BUILD_FILL_UP: u32 = 8;

/// Build flag, for uniform and recursive grids: a tree of boxes lies beside the grid, for rays
/// on their own. It has some 10 bytes a triangle and takes longer to build than a grid; rays that
/// take it are two or three times as fast. Hits are the same. Of 2^28 triangles or
/// more, of fewer than 8, of those that are tiny beside the scene's extent, and of a HUG's, whose
/// triangles lie cluster by cluster, there is none. If quality is HIGH it is built with more
/// care; with HUG_BUILD_COMPACT it takes three eighths of the memory. AUTO builds it with the
/// qualities DEFAULT and HIGH.
pub const HUG_BUILD_TREE: u32 = 16;

/// hug_open flag: the bytes come from this library and are not checked.
/// Damaged bytes then make queries undefined.
pub const HUG_OPEN_TRUSTED: u32 = 1;

/// Most levels of grids in a scene.
pub const HUG_MAX_LEVELS: usize = 16;

/// One geometry of a scene; its id is its place in the descriptor's list.
/// The memory is read during the build only, never past the third coordinate
/// of the last vertex.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct hug_geometry {
    /// x, y, z of the first vertex, aligned to 4. NULL only if vertex_count is 0.
    pub vertices: *const f32,
    /// Number of vertices.
    pub vertex_count: usize,
    /// Bytes from one vertex to the next: a multiple of 4, at least 12, or 0 for 12.
    pub vertex_stride: usize,
    /// Indices of index_type, aligned to their size. Ignored for HUG_INDEX_NONE.
    pub indices: *const c_void,
    /// Number of triangles.
    pub triangle_count: usize,
    /// HUG_INDEX_*.
    pub index_type: hug_index_type,
    /// A ray meets the geometry only if its mask shares a bit with this one. 0 means all bits.
    pub mask: u32,
}

/// One of the tasks of a build, as a hug_parallel_for_fn is given it. Any thread may
/// call it; it returns when the task is done. It never unwinds, allocates or locks.
pub type hug_task_fn = Option<unsafe extern "C" fn(context: *mut c_void, index: usize)>;
/// Calls task(context, index) once for every index from 0 to tasks - 1, on any
/// threads, in any order, and returns when all calls have returned. An index that
/// was called already does nothing; one that was left out makes the build fail
/// with HUG_ERROR_UNFINISHED. Calling task after having returned is undefined.
pub type hug_parallel_for_fn = Option<
    unsafe extern "C" fn(user: *mut c_void, tasks: usize, task: hug_task_fn, context: *mut c_void),
>;
/// Told how far a build is, from 0 to 1 and never falling. A result that is not 0
/// cancels the build: HUG_ERROR_CANCELLED.
pub type hug_progress_fn = Option<unsafe extern "C" fn(user: *mut c_void, fraction: f64) -> i32>;

/// Allocates size bytes, of any values, aligned to align (a power of two, at most 64), or returns
/// NULL.
pub type hug_alloc_fn =
    Option<unsafe extern "C" fn(size: usize, align: usize, user: *mut c_void) -> *mut c_void>;
/// Frees what hug_alloc_fn returned; size is the size it was asked for.
pub type hug_free_fn =
    Option<unsafe extern "C" fn(memory: *mut c_void, size: usize, user: *mut c_void)>;

/// What to build, from which triangles, in whose memory. Zero it, set
/// struct_size = sizeof(hug_build_desc), geometries and geometry_count; every
/// other field may stay 0 for its default. A program compiled against an older
/// header passes a smaller struct_size, and the fields it lacks are 0.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct hug_build_desc {
    /// sizeof(hug_build_desc).
    pub struct_size: usize,
    /// The geometries. NULL only if geometry_count is 0.
    pub geometries: *const hug_geometry,
    /// Number of geometries; 0 builds an empty scene.
    pub geometry_count: usize,
    /// HUG_STRUCTURE_*.
    pub structure: hug_structure,
    /// HUG_GRIDDING_*.
    pub gridding: hug_gridding,
    /// Voxels of the outermost grid along x, y, z, 1 to 2048 each; all 0 derive them from world_alpha.
    pub counts: [u32; 3],
    /// Voxels per axis and cube root of a grid's objects, 0.1 to 16. 0 means 1. AUTO takes alpha,
    /// world_alpha and maxp from the quality.
    pub alpha: f32,
    /// The same for the outermost grid. 0 means alpha, for the HUG sqrt(2), or with two levels up
    /// to 2 as long as there are no more voxels than sqrt(2) makes for all triangles.
    pub world_alpha: f32,
    /// Recursive grid: a voxel of more references becomes a grid. 0 means 50.
    pub maxp: u32,
    /// Recursive grid: most levels of grids, at most HUG_MAX_LEVELS. 0 means 8.
    pub max_depth: u32,
    /// HUG: levels of the filter when filter_thresholds is NULL: 2 (split at
    /// filter_share of the largest length) or 3 (from the histogram of lengths).
    /// 0 means 2. With thresholds: their number plus one.
    pub filter_levels: u32,
    /// HUG: the share that splits two levels, in (0, 1]. 0 means 0.05.
    pub filter_share: f32,
    /// HUG: filter_levels - 1 increasing lengths in the units of the scene, or NULL.
    pub filter_thresholds: *const f32,
    /// HUG: the connectivity coefficient alpha of Definition 2. 0 means 1.
    pub connectivity: f32,
    /// HUG: HUG_DELTA_*.
    pub delta: hug_delta,
    /// HUG: HUG_HIERARCHY_*.
    pub hierarchy: hug_hierarchy,
    /// HUG: a cluster of fewer triangles pops up into the world. 0 means 8.
    pub min_cluster: u32,
    /// Most references a grid may hold per object in it, up to 4096. 0 means 32.
    pub max_refs: u32,
    /// HUG_BUILD_* flags.
    pub flags: u32,
    /// hug_build only: the allocator, or both NULL for the default one, which is C's malloc and free
    /// where there are these. hug_rebuild uses the one of the scene.
    pub alloc: hug_alloc_fn,
    /// hug_build only: frees what alloc returned, also from hug_free.
    pub free: hug_free_fn,
    /// Passed to alloc and free.
    pub user: *mut c_void,
    /// AUTO: HUG_QUALITY_*.
    pub quality: hug_quality,
    /// Must be 0.
    pub reserved: u32,
    /// Runs parts of the build on the caller's threads, or NULL. The bytes built are the same.
    pub parallel_for: hug_parallel_for_fn,
    /// Passed to parallel_for.
    pub parallel_user: *mut c_void,
    /// Is told how far the build is, on the thread that builds, or NULL.
    pub progress: hug_progress_fn,
    /// Passed to progress.
    pub progress_user: *mut c_void,
    /// HUG: HUG_CLUSTERING_*.
    pub clustering: hug_clustering,
    /// HUG_GRIDDING_OVERLAP and HUG_GRIDDING_MIXED: how strongly overlap acts, in (0, 4]. 0 means 0.5.
    pub overlap_power: f32,
    /// HUG: HUG_ORIENTATION_*, for clusters without grids below.
    pub orientation: hug_orientation,
    /// HUG: a cluster's box is turned if it has less than this share of the surface of the
    /// aligned one, in (0, 1e6]. 0 means 0.8.
    pub turn_below: f32,
}

/// Ray flag: passes through triangles that it meets from behind. The front of a triangle
/// is where its normal points (hug_hit's ng) and its corners go round counterclockwise; a
/// ray comes from there if the exact dot product of dir and ng is negative.
pub const HUG_RAY_CULL_BACK: u32 = 1;
/// Ray flag: passes through triangles that it meets from the front.
pub const HUG_RAY_CULL_FRONT: u32 = 2;

/// A ray org + t dir, tmin <= t <= tmax. 48 bytes, aligned to 4.
///
/// dir need not be normalised; t is in units of its length. tmin and tmax may
/// be infinite. NaN anywhere, a non-finite origin or direction, a zero
/// direction or tmin > tmax make the ray miss.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct hug_ray {
    /// Origin, in the units of the scene.
    pub org: [f32; 3],
    /// Smallest t of a hit, inclusive.
    pub tmin: f32,
    /// Direction, of any non-zero length.
    pub dir: [f32; 3],
    /// Largest t of a hit, inclusive.
    pub tmax: f32,
    /// A geometry is met only if its mask shares a bit with this one.
    pub mask: u32,
    /// HUG_RAY_* flags. Other bits are reserved and must be 0; they change nothing.
    pub flags: u32,
    /// Geometry of the one triangle that the ray passes through, or HUG_NONE.
    pub skip_geom: u32,
    /// Primitive of the one triangle that the ray passes through, or HUG_NONE.
    pub skip_prim: u32,
}

/// The closest hit. 40 bytes, aligned to 4.
///
/// The point is (1 - u - v) v0 + u v1 + v v2. A miss has
/// geom = prim = inst = HUG_NONE, t = the ray's tmax, and zeros elsewhere.
/// Of hits with equal t the one of lowest geom, then lowest prim, is returned.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct hug_hit {
    /// The exact parameter of the hit, rounded once to float.
    pub t: f32,
    /// Weight of v1, exact but for one rounding.
    pub u: f32,
    /// Weight of v2, exact but for one rounding.
    pub v: f32,
    /// (v1 - v0) x (v2 - v0), not normalised; infinite where it overflows float.
    pub ng: [f32; 3],
    /// Index of the geometry in the descriptor.
    pub geom: u32,
    /// Index of the triangle in its geometry.
    pub prim: u32,
    /// Reserved for instances; HUG_NONE.
    pub inst: u32,
    /// 0.
    pub reserved: u32,
}

const _: () = assert!(size_of::<hug_ray>() == size_of::<crate::Ray>());
const _: () = assert!(size_of::<hug_hit>() == size_of::<crate::Hit>());
