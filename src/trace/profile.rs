//! What a walk does on each level of a hierarchy, and how far the paper's
//! intersection routine would have gone (sections 3 and 4).

use super::counters::{Count, Meter};
use crate::options::MAX_LEVELS;
use crate::ray::Ray;
use crate::triangle::Corners;

/// The rendering statistics of section 3, of one level or of several.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Calls {
    /// Grids whose box was tested (#bbi).
    pub grids: u64,
    /// Voxels traversed (#vt).
    pub voxels: u64,
    /// Ray-triangle tests (#pit), one per reference met.
    pub tests: u64,
    /// Tests that met the triangle within the ray's range (#pi).
    pub hits: u64,
    /// Tests that pass the paper's `test_1`: the ray is not parallel to the plane.
    pub passed_1: u64,
    /// Of these, tests that pass `test_2`: where the ray's line meets the plane is in
    /// the triangle's box, seen along the longest component of its normal.
    pub passed_2: u64,
}

impl Calls {
    /// %s1: of the tests, those that pass `test_1`.
    #[must_use]
    pub fn percent_passed_1(&self) -> f64 {
        percent(self.passed_1, self.tests)
    }

    /// %s2: of those that pass `test_1`, and so come to `test_2`, those that pass it.
    #[must_use]
    pub fn percent_passed_2(&self) -> f64 {
        percent(self.passed_2, self.passed_1)
    }

    /// %pi / %pit: of the tests, those that are hits.
    #[must_use]
    pub fn percent_hits(&self) -> f64 {
        percent(self.hits, self.tests)
    }

    fn add(&mut self, other: &Self) {
        self.grids = self.grids.saturating_add(other.grids);
        self.voxels = self.voxels.saturating_add(other.voxels);
        self.tests = self.tests.saturating_add(other.tests);
        self.hits = self.hits.saturating_add(other.hits);
        self.passed_1 = self.passed_1.saturating_add(other.passed_1);
        self.passed_2 = self.passed_2.saturating_add(other.passed_2);
    }
}

fn percent(part: u64, whole: u64) -> f64 {
    if whole == 0 { 0.0 } else { 100.0 * part as f64 / whole as f64 }
}

/// What queries did, level by level; a profiled query adds to it. The same numbers
/// on every machine and instruction set.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Profile {
    levels: [Calls; MAX_LEVELS],
    /// The level that the walk is on.
    now: u8,
}

impl Profile {
    /// By level: 0 is the deepest. Those that the scene does not have are zeros.
    #[must_use]
    pub fn levels(&self) -> &[Calls; MAX_LEVELS] {
        &self.levels
    }

    /// All levels together.
    #[must_use]
    pub fn total(&self) -> Calls {
        let mut total = Calls::default();
        self.levels.iter().for_each(|level| total.add(level));
        total
    }

    /// Adds what another has counted.
    pub fn add(&mut self, other: &Self) {
        for (to, from) in self.levels.iter_mut().zip(&other.levels) {
            to.add(from);
        }
    }

    fn here(&mut self) -> &mut Calls {
        &mut self.levels[usize::from(self.now) % MAX_LEVELS]
    }
}

impl Count for Profile {
    type Meter<'m> = Meter<'m>;
    fn meter(&mut self) -> Meter<'_> {
        Meter::Profile(self)
    }
    const LOOKS: bool = true;
    type Level = u8;
    fn of(level: u8) -> u8 {
        level
    }
    fn level(&mut self, level: u8) {
        self.now = level;
    }
    fn grid(&mut self) {
        self.here().grids += 1;
    }
    fn voxel(&mut self) {
        self.here().voxels += 1;
    }
    fn tests(&mut self, n: usize) {
        self.here().tests += n as u64;
    }
    fn hit(&mut self) {
        self.here().hits += 1;
    }
    fn look(&mut self, ray: &Ray, triangle: &impl Corners) {
        let (first, second) = early_tests(ray, triangle);
        self.here().passed_1 += u64::from(first);
        self.here().passed_2 += u64::from(second);
    }
}

/// The two early tests of the paper's `Intersect(ray, polygon)`, in `f64` without
/// fused operations. They only tell how far it would have gone: no hit depends on
/// them.
fn early_tests(ray: &Ray, triangle: &impl Corners) -> (bool, bool) {
    let corners = triangle.all().map(|c| c.map(f64::from));
    let [a, b, c] = corners;
    let (org, dir) = (ray.org.map(f64::from), ray.dir.map(f64::from));
    let sub = |p: [f64; 3], q: [f64; 3]| [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
    let dot = |p: [f64; 3], q: [f64; 3]| p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    let (e, f) = (sub(b, a), sub(c, a));
    let normal = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]];
    let across = dot(dir, normal);
    if across == 0.0 {
        return (false, false);
    }
    let t = dot(sub(a, org), normal) / across;
    let size = normal.map(f64::abs);
    // The axis of the longest component: the triangle is widest seen along it.
    let axis = if size[0] >= size[1] && size[0] >= size[2] {
        0
    } else if size[1] >= size[2] {
        1
    } else {
        2
    };
    let inside = (0..3).filter(|&k| k != axis).all(|k| {
        let at = org[k] + t * dir[k];
        let (low, high) = (a[k].min(b[k]).min(c[k]), a[k].max(b[k]).max(c[k]));
        low <= at && at <= high
    });
    (true, inside)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parallel_beside_and_inside() {
        let triangle = [[0.0, 0.0, 0.0], [4.0, 0.0, 1.0], [0.0, 4.0, 1.0]];
        let shot = |org, dir| early_tests(&Ray::new(org, dir), &triangle);
        assert_eq!(shot([9.0, 9.0, 9.0], [4.0, 0.0, 1.0]), (false, false));
        assert_eq!(shot([5.0, 1.0, 9.0], [0.0, 0.0, -1.0]), (true, false));
        // In the box but not in the triangle, and behind the origin: both pass.
        assert_eq!(shot([3.5, 3.5, 9.0], [0.0, 0.0, -1.0]), (true, true));
        assert_eq!(shot([1.0, 1.0, 9.0], [0.0, 0.0, 1.0]), (true, true));
    }
}
