//! Building: from a triangle soup to an arena, in passes over flat arrays.
//!
//! `gather` reads the soup; `uniform`, `recursive` or `hug` (with `filter`,
//! `cluster`, `hierarchy`) shape the structure in a `draft`, where `overlap` and
//! `frame` decide geometry; `flatten` writes the arena. All memory is cut from one
//! scratch block (`capacity`, `scratch`), so that both doors of the library, with
//! and without an allocator, run the same code and write the same bytes. `control`
//! is what a build may use of the caller's meanwhile: `gather`, `bucket` for many
//! triangles, `split` for the grids below, `parts`, which `flatten` leaves the voxels to,
//! and `counts` cut their work into tasks.

mod arrangement;
mod bounds;
mod bucket;
mod capacity;
mod cluster;
mod components;
mod control;
mod counts;
mod draft;
mod exit;
mod filter;
mod flatten;
mod footprint;
mod frame;
mod gather;
mod grow;
mod hierarchy;
mod hug;
mod masks;
mod occluders;
mod orient;
mod overlap;
mod parts;
mod reach;
mod recursive;
mod rows;
mod scratch;
mod sort;
mod split;
mod stretch;
mod survey;
mod tree;
mod turn;
mod uniform;

pub use capacity::Sizes;
#[cfg(feature = "rayon")]
pub use control::Rayon;
pub use control::{Control, Task, Threads};
pub use flatten::Plan;
pub use survey::{Clusters, Survey};

use crate::Error;
use crate::arena::node::{LEAF, Node};
use crate::geometry::{Geometry, count};
use crate::options::{Options, Quality, Structure};
use crate::simd::fpenv;
use capacity::Capacity;
use draft::Draft;
use gather::Soup;
use scratch::Scratch;

/// Upper bounds on the memory a build of these geometries needs; their
/// vertices are not looked at.
///
/// # Errors
/// [`Error::Limit`] for too many triangles, [`Error::Overflow`] if the bounds do
/// not fit the address space, [`Error::InvalidValue`] for options out of range.
pub fn measure(soup: &[Geometry<'_>], options: &Options) -> Result<Sizes, Error> {
    measure_count(count(soup)?, options)
}

/// [`measure`] for a number of triangles.
pub(crate) fn measure_count(triangles: usize, options: &Options) -> Result<Sizes, Error> {
    fpenv::with_default(|| {
        options.check()?;
        Capacity::new(triangles, &options.resolved(triangles)).sizes()
    })
}

/// Builds a structure in scratch memory.
///
/// # Errors
/// As [`measure`]; [`Error::BufferTooSmall`] if `scratch` is; and
/// [`Error::IndexRange`] for an index that names no vertex.
pub fn plan<'s>(
    soup: &[Geometry<'_>],
    options: &Options,
    scratch: &'s mut [u8],
) -> Result<Plan<'s>, Error> {
    plan_with(soup, options, scratch, &mut Control::default())
}

/// [`plan`] with the caller's threads, and telling how far it is; to be followed by
/// [`Plan::write_with`].
///
/// # Errors
/// As [`plan`]; [`Error::Cancelled`], [`Error::Unfinished`].
pub fn plan_with<'s>(
    soup: &[Geometry<'_>],
    options: &Options,
    scratch: &'s mut [u8],
    control: &mut Control<'_>,
) -> Result<Plan<'s>, Error> {
    fpenv::with_default(|| {
        options.check()?;
        let triangles = count(soup)?;
        let options = &options.resolved(triangles);
        let capacity = Capacity::new(triangles, options);
        let mut scratch = Scratch::new(scratch);
        control.begin();
        control.pass(0.1)?;
        let mut soup =
            Soup::gather(soup, (capacity.triangles, capacity.filtered), &mut scratch, control)?;
        let count = soup.triangles.len();
        let objects = scratch.take::<u32>(capacity.triangles + capacity.links)?;
        let table = scratch.take::<u64>(capacity.table)?;
        let mut nodes: &[Node] = &[];
        if capacity.tree > 0 && count >= LEAF as usize {
            let memory = scratch.take::<Node>(tree::capacity(capacity.tree))?;
            let care = options.quality == Quality::High;
            let order = &mut objects[..count];
            nodes = tree::build(&soup, memory, order, care, scratch.rest(), control)?;
            if !nodes.is_empty() {
                control.pass(0.42)?;
                soup.reorder(order, &mut scratch, control)?;
            }
        }
        let mut draft = Draft::new(soup, &capacity, options.max_refs, &mut scratch)?;
        if !nodes.is_empty() {
            draft.keep_order();
        }
        if count > 0 {
            match options.structure {
                Structure::Uniform => {
                    control.pass(0.45)?;
                    uniform::uniform(&mut draft, options, objects, control)?;
                }
                Structure::Recursive => {
                    recursive::recursive(&mut draft, options, objects, control)?;
                }
                Structure::Auto | Structure::Hug => {
                    hug::hug(&mut draft, options, &capacity, objects, &mut scratch, control)?;
                }
            }
        }
        Plan::new(draft, options, table, nodes)
    })
}

/// Builds an arena in the caller's memory, with no allocation: `scratch` of any
/// alignment, `arena` aligned to 64, both at least as [`measure`] says.
///
/// ```
/// use hug::{Geometry, Options, View, build};
/// #[repr(align(64))]
/// struct Memory([u8; 8192]);
/// let (mut scratch, mut arena) = ([0; 65536], Memory([0; 8192]));
/// let vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
/// let (mesh, options) = ([Geometry::from_mesh(&vertices, &[[0, 1, 2]])], Options::default());
/// let sizes = build::measure(&mesh, &options)?;
/// assert!(sizes.scratch <= scratch.len() && sizes.arena <= arena.0.len());
/// let bytes = build::build_into(&mesh, &options, &mut scratch, &mut arena.0)?;
/// assert!(View::open(bytes)?.occluded(&hug::Ray::new([0.2, 0.3, 1.0], [0.0, 0.0, -1.0])));
/// # Ok::<(), hug::Error>(())
/// ```
///
/// # Errors
/// As [`plan`] and [`Plan::write`].
pub fn build_into<'a>(
    soup: &[Geometry<'_>],
    options: &Options,
    scratch: &mut [u8],
    arena: &'a mut [u8],
) -> Result<&'a [u8], Error> {
    build_into_with(soup, options, scratch, arena, &mut Control::default())
}

/// [`build_into`] with the caller's threads, and telling how far it is.
///
/// # Errors
/// As [`plan_with`] and [`Plan::write_with`].
pub fn build_into_with<'a>(
    soup: &[Geometry<'_>],
    options: &Options,
    scratch: &mut [u8],
    arena: &'a mut [u8],
    control: &mut Control<'_>,
) -> Result<&'a [u8], Error> {
    let plan = plan_with(soup, options, scratch, control)?;
    let bytes = plan.arena_bytes();
    plan.write_with(arena, control)?;
    Ok(&arena[..bytes])
}
