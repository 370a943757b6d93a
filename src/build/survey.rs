//! What the filter and each of the two clusterings make of a soup, before anything is
//! built: the figures of section 7.4, and the sum of %vol that section 7.1 goes by.

use core::ops::Range;

use super::capacity::Capacity;
use super::cluster::{Part, cluster};
use super::components::{components, pairs};
use super::control::Control;
use super::filter::Levels;
use super::frame::Grid;
use super::gather::Soup;
use super::hug::{length, level_ranges};
use super::scratch::Scratch;
use crate::Error;
use crate::aabb::Aabb;
use crate::geometry::{Geometry, count};
use crate::options::{Options, Structure};
use crate::simd::fpenv;

/// The clusters of all levels below the world's.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Clusters {
    /// All of them.
    pub clusters: u64,
    /// Those of at least `min_cluster` triangles, which become grids.
    pub grids: u64,
    /// Triangles in these; all others are in the world.
    pub objects: u64,
    /// The sum of %vol over all levels, over 100: volumes of the grids, that of the world
    /// included, over that of the world. The paper expects trouble above 1.2.
    pub volume: f64,
}

/// What the clusterings make of a soup.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Survey {
    /// Triangles that a build keeps.
    pub triangles: u64,
    /// Those in levels below the world's.
    pub filtered: u64,
    /// Pairs of these, of the same level, whose boxes' projections along z intersect.
    pub plane_pairs: u64,
    /// Pairs whose boxes intersect: the edges of Definition 5's graph.
    pub pairs: u64,
    /// By connected projections (Definition 3).
    pub projections: Clusters,
    /// By connected components (Definition 5).
    pub components: Clusters,
}

impl Survey {
    /// The share of intersections in the plane that are denied along z; 0 if there are
    /// none. The paper has 3/4.
    #[must_use]
    pub fn denied(&self) -> f64 {
        if self.plane_pairs == 0 {
            return 0.0;
        }
        fpenv::with_default(|| (self.plane_pairs - self.pairs) as f64 / self.plane_pairs as f64)
    }

    /// Looks at a soup with the filter, connectivity and smallest cluster of `options`.
    /// `scratch` is as for a HUG of the same options ([`super::measure`]), of any
    /// alignment. Cost: O(n log^3 n) at most; the pairs are counted, not listed.
    ///
    /// # Errors
    /// As [`super::plan`].
    pub fn of(soup: &[Geometry<'_>], options: &Options, scratch: &mut [u8]) -> Result<Self, Error> {
        fpenv::with_default(|| {
            let options = Options { structure: Structure::Hug, ..*options };
            options.check()?;
            survey(soup, &options, Scratch::new(scratch))
        })
    }

    /// [`Survey::of`] with memory from the allocator.
    ///
    /// # Errors
    /// As [`Survey::of`]; [`Error::OutOfMemory`].
    #[cfg(feature = "alloc")]
    pub fn new(soup: &[Geometry<'_>], options: &Options) -> Result<Self, Error> {
        let hug = Options { structure: Structure::Hug, ..*options };
        let bytes = super::measure(soup, &hug)?.scratch;
        let mut scratch = alloc::vec::Vec::new();
        scratch.try_reserve_exact(bytes).map_err(|_| Error::OutOfMemory)?;
        scratch.resize(bytes, 0);
        Self::of(soup, options, &mut scratch)
    }
}

fn survey(
    soup: &[Geometry<'_>],
    options: &Options,
    mut scratch: Scratch<'_>,
) -> Result<Survey, Error> {
    let control = &mut Control::default();
    let n = Capacity::new(count(soup)?, options).filtered;
    let soup = Soup::gather(soup, (n, n), &mut scratch, control)?;
    let boxes = soup.boxes;
    let mut all = Survey { triangles: boxes.len() as u64, ..Survey::default() };
    all.projections.volume = 1.0;
    all.components.volume = 1.0;
    if boxes.is_empty() {
        return Ok(all);
    }
    let levels = Levels::fit(&options.filter, boxes);
    let home = &mut scratch.take::<u8>(n)?[..boxes.len()];
    let order = &mut scratch.take::<u32>(n)?[..boxes.len()];
    let parts = scratch.take::<Part>(n)?;
    let bounds = level_ranges(&levels, boxes, home, order);
    let volume = |b: &Aabb| Grid::around(b, 0, &soup.bounds).extent.iter().product::<f64>();
    let world = volume(&soup.bounds);
    for level in 0..levels.count() - 1 {
        let members = &mut order[bounds[level] as usize..bounds[level + 1] as usize];
        all.filtered += members.len() as u64;
        let sum = |of: &mut Clusters, members: &[u32], found: Range<usize>| {
            of.clusters += 1;
            if found.len() >= options.min_cluster as usize {
                let mut b = Aabb::EMPTY;
                members[found.clone()].iter().for_each(|&i| b.join(&boxes[i as usize]));
                of.grids += 1;
                of.objects += found.len() as u64;
                of.volume += volume(&b) / world;
            }
        };
        let met = pairs(members, boxes, bytemuck::cast_slice_mut(parts), control)?;
        all.plane_pairs += met.plane;
        all.pairs += met.space;
        // A cluster's range is final when it is found, the rest is still permuted.
        let delta =
            f64::from(options.connectivity) * length(&levels, level, members, boxes, options);
        cluster(members, boxes, delta, parts, control, &mut |members, found| {
            sum(&mut all.projections, members, found);
        })?;
        components(
            members,
            boxes,
            bytemuck::cast_slice_mut(parts),
            control,
            &mut |members, found| {
                sum(&mut all.components, members, found);
            },
        )?;
    }
    Ok(all)
}
