//! Whether a soup is prone to clustering, told before anything is built (section 7.1).
//!
//! The paper decides by the histogram of lengths, by the sum of %vol once a HUG is built,
//! and leaves integral geometry to later work. Here two passes over the triangles measure
//! how far lengths spread and how unevenly the centres of the small triangles lie in a
//! coarse grid: the cells they occupy against those that as many points at random would,
//! and Morisita's index of dispersion (1959), the probability that two of them share a
//! cell over that of two points at random. Both are 1 for a uniform scatter, whatever
//! the number of triangles.

use crate::Error;
use crate::aabb::Aabb;
use crate::geometry::{Geometry, count};
use crate::math::{exp, ln, sqrt};
use crate::options::{Clustering, Filter, Options, Structure};
use crate::simd::fpenv;

/// Cells of the coarse grid along each axis: 8 kB on the stack for two of them.
const SIDE: usize = 10;
const CELLS: usize = SIDE * SIDE * SIDE;

/// Shares of the largest length that a filter of two levels may cut at, the paper's first.
const SHARES: [f32; 3] = [0.05, 0.02, 0.01];
/// A filter that leaves fewer triangles than this in the world leaves those that bridge
/// the gaps between clusters among the small ones: the next share is taken.
const LARGE: f64 = 0.1;

/// Fewer triangles are in one grid of a few voxels whatever is chosen.
const FEW: u64 = 64;
/// A smaller share of small triangles leaves a filter little to part.
const SMALL: f64 = 0.5;
/// Lengths that vary less have one peak, and a filter cuts through it.
const VARIED: f64 = 1.0;
/// A scatter less crowded than this is taken for an even one.
const CROWDED: f64 = 2.0;

/// Why a structure was chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u32)]
pub enum Reason {
    /// There are too few triangles for the choice to matter.
    #[default]
    Few = 0,
    /// Lengths are alike and the triangles lie evenly: one grid divides them.
    Even = 1,
    /// Lengths are alike, so that a filter parts nothing, but the triangles lie unevenly.
    Alike = 2,
    /// Most triangles are small, but they lie all over the scene.
    Scattered = 3,
    /// Most triangles are small, and stand together in a part of the scene.
    Clustered = 4,
}

impl Reason {
    /// A short English sentence, without a full stop.
    #[must_use]
    pub const fn message(self) -> &'static core::ffi::CStr {
        match self {
            Self::Few => c"there are too few triangles for the choice to matter",
            Self::Even => c"lengths are alike and the triangles lie evenly",
            Self::Alike => {
                c"lengths are alike, so a filter parts nothing, but triangles lie unevenly"
            }
            Self::Scattered => c"most triangles are small, but lie all over the scene",
            Self::Clustered => c"most triangles are small and stand together",
        }
    }
}

/// What was measured of a soup, and what to build of it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Advice {
    /// Triangles with finite corners and a length, the diagonal of their box.
    pub triangles: u64,
    /// The share of them shorter than 5 % of the longest: the small ones.
    pub small: f64,
    /// The coefficient of variation of the lengths: deviation over mean.
    pub variation: f64,
    /// The share of the cells of a 10 x 10 x 10 grid over the scene that centres of small
    /// triangles lie in; of all triangles, if fewer than half of them are small.
    pub occupied: f64,
    /// What that share would be if as many points were scattered at random.
    pub expected: f64,
    /// How many times more likely two of the centres share a cell than two such points.
    pub crowding: f64,
    /// Whether clusters are to be expected.
    pub prone: bool,
    /// What to build.
    pub structure: Structure,
    /// The filter, should it be a HUG: of two levels, split at 5 % of the longest, or at
    /// 2 or 1 % if hardly a triangle is above.
    pub filter: Filter,
    /// The clustering, should it be a HUG.
    pub clustering: Clustering,
    /// Why.
    pub reason: Reason,
}

impl Advice {
    /// Measures a soup. Cost: two passes over the triangles; no allocation, some 8 kB of stack.
    ///
    /// ```
    /// let vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    /// let advice = hug::Advice::of(&[hug::Geometry::from_mesh(&vertices, &[[0, 1, 2]])])?;
    /// assert_eq!((advice.triangles, advice.reason), (1, hug::Reason::Few));
    /// # Ok::<(), hug::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::IndexRange`] for an index that names no vertex, [`Error::Limit`] for too
    /// many triangles.
    pub fn of(soup: &[Geometry<'_>]) -> Result<Self, Error> {
        count(soup)?;
        Self::of_each(soup.iter().copied().map(Ok))
    }

    /// [`Advice::of`] for geometries that come one by one, twice.
    pub(crate) fn of_each<'a>(
        soup: impl Iterator<Item = Result<Geometry<'a>, Error>> + Clone,
    ) -> Result<Self, Error> {
        fpenv::with_default(|| {
            let lengths = Spread::of(soup.clone())?;
            let scatter = Scatter::of(soup, &lengths)?;
            Ok(Self::decided(&lengths, &scatter))
        })
    }

    /// `options` with the structure, the filter and the clustering that were chosen.
    #[must_use]
    pub fn options(&self, options: Options) -> Options {
        let Self { structure, filter, clustering, .. } = *self;
        Options { structure, filter, clustering, ..options }
    }

    fn decided(lengths: &Spread, scatter: &Scatter) -> Self {
        let shorter = scatter.shorter.map(|n| n as f64 / lengths.count.max(1) as f64);
        let small = shorter[0];
        let parts = |share: &usize| 1.0 - shorter[*share] >= LARGE;
        let share = (0..SHARES.len()).find(parts).unwrap_or(SHARES.len() - 1);
        let cells = scatter.of_interest(small);
        let crowded = cells.crowding >= CROWDED;
        let parted = small >= SMALL && lengths.variation() >= VARIED;
        let (reason, structure) = match (parted, crowded) {
            _ if lengths.count < FEW => (Reason::Few, Structure::Uniform),
            (true, true) => (Reason::Clustered, Structure::Hug),
            (true, false) => (Reason::Scattered, Structure::Recursive),
            (false, true) => (Reason::Alike, Structure::Recursive),
            (false, false) => (Reason::Even, Structure::Uniform),
        };
        Self {
            triangles: lengths.count,
            small,
            variation: lengths.variation(),
            occupied: cells.occupied,
            expected: cells.expected,
            crowding: cells.crowding,
            prone: reason == Reason::Clustered,
            structure,
            filter: Filter::TwoLevels(SHARES[share]),
            clustering: Clustering::Components,
            reason,
        }
    }
}

/// The boxes of the triangles that count.
fn each<'a>(
    soup: impl Iterator<Item = Result<Geometry<'a>, Error>>,
    mut f: impl FnMut(&Aabb, f64),
) -> Result<(), Error> {
    for geometry in soup {
        let geometry = geometry?;
        for prim in 0..geometry.triangle_count() {
            let corners = geometry.triangle(prim)?;
            let b = Aabb::of(&corners);
            let length = b.diagonal();
            let finite = corners.as_flattened().iter().all(|x| x.is_finite());
            if finite && length > 0.0 {
                f(&b, length);
            }
        }
    }
    Ok(())
}

/// The first pass: the box of all, and how far lengths spread.
struct Spread {
    bounds: Aabb,
    count: u64,
    longest: f64,
    sum: f64,
    squares: f64,
}

impl Spread {
    fn of<'a>(soup: impl Iterator<Item = Result<Geometry<'a>, Error>>) -> Result<Self, Error> {
        let mut all = Self { bounds: Aabb::EMPTY, count: 0, longest: 0.0, sum: 0.0, squares: 0.0 };
        each(soup, |b, length| {
            all.bounds.join(b);
            all.count += 1;
            all.longest = all.longest.max(length);
            all.sum += length;
            all.squares += length * length;
        })?;
        Ok(all)
    }

    fn variation(&self) -> f64 {
        let n = self.count as f64;
        if self.sum > 0.0 {
            sqrt((n * self.squares / (self.sum * self.sum) - 1.0).max(0.0))
        } else {
            0.0
        }
    }
}

/// The second pass: centres of the small triangles, and of all, in a coarse grid.
struct Scatter {
    /// Triangles shorter than each of the shares.
    shorter: [u64; SHARES.len()],
    all: u64,
    /// Cells along each axis: one where the scene is flat.
    sides: [usize; 3],
    in_cells: [[u32; CELLS]; 2],
}

impl Scatter {
    fn of<'a>(
        soup: impl Iterator<Item = Result<Geometry<'a>, Error>>,
        spread: &Spread,
    ) -> Result<Self, Error> {
        let Spread { bounds, longest, count, .. } = spread;
        let lo = bounds.lo.map(f64::from);
        let extent: [f64; 3] = core::array::from_fn(|k| f64::from(bounds.hi[k]) - lo[k]);
        let sides = extent.map(|side| if side > 0.0 { SIDE } else { 1 });
        let mut found = Self { shorter: [0; 3], all: *count, sides, in_cells: [[0; CELLS]; 2] };
        each(soup, |b, length| {
            let mut cell = 0;
            for k in (0..3).filter(|&k| sides[k] > 1) {
                let middle = 0.5 * (f64::from(b.lo[k]) + f64::from(b.hi[k]));
                let at = ((middle - lo[k]) / extent[k] * SIDE as f64) as usize;
                cell = cell * SIDE + at.min(SIDE - 1);
            }
            found.in_cells[1][cell] += 1;
            for (shorter, share) in found.shorter.iter_mut().zip(SHARES) {
                *shorter += u64::from(length < f64::from(share) * longest);
            }
            found.in_cells[0][cell] += u32::from(length < f64::from(SHARES[0]) * longest);
        })?;
        Ok(found)
    }

    /// How the small triangles lie, or if they are too few, all.
    fn of_interest(&self, small: f64) -> Cells {
        let (count, in_cells) = if small >= SMALL {
            (self.shorter[0] as f64, &self.in_cells[0])
        } else {
            (self.all as f64, &self.in_cells[1])
        };
        let cells = self.sides.iter().product::<usize>() as f64;
        let occupied = in_cells.iter().filter(|&&n| n > 0).count() as f64 / cells;
        let pairs: f64 = in_cells.iter().map(|&n| f64::from(n) * (f64::from(n) - 1.0)).sum();
        let crowding = if count > 1.0 { cells * pairs / (count * (count - 1.0)) } else { 0.0 };
        // A cell stays empty with probability (1 - 1 / cells)^count.
        let empty = if cells > 1.0 { exp(count * ln(1.0 - 1.0 / cells)) } else { 0.0 };
        Cells { occupied, expected: 1.0 - empty, crowding }
    }
}

/// How a number of points lie in the cells.
struct Cells {
    occupied: f64,
    expected: f64,
    crowding: f64,
}
