//! The convex hull of a cluster, nearly: of the points that lie farthest in directions
//! all around, which is all that a box around it can touch.

use super::pca::Moments;
use glam::DVec3;

/// Points of a hull.
pub const MOST: usize = 96;
/// Faces of a hull of so many points.
const FACES: usize = 2 * MOST;

/// Points that lie farthest in some direction, without repetition.
pub struct Extremes {
    points: [DVec3; MOST],
    reach: [f64; MOST],
    len: usize,
}

/// Direction `i`, of a spiral of even density from pole to pole: a step along the axis, and
/// the golden angle around it, whose cosine and sine are kept as powers.
fn directions() -> impl Iterator<Item = DVec3> {
    const COS: f64 = -0.737_368_878_078_320_6;
    const SIN: f64 = 0.675_490_294_261_523_6;
    (0..MOST).scan((1.0, 0.0), |around: &mut (f64, f64), i| {
        let (c, s) = *around;
        *around = (c * COS - s * SIN, s * COS + c * SIN);
        let z = 1.0 - (2 * i + 1) as f64 / MOST as f64;
        let r = crate::math::sqrt(1.0 - z * z);
        Some(DVec3::new(r * c, r * s, z))
    })
}

impl Extremes {
    pub fn new(points: impl Iterator<Item = DVec3>) -> Self {
        let mut all =
            Self { points: [DVec3::ZERO; MOST], reach: [f64::NEG_INFINITY; MOST], len: 0 };
        let mut ways = [DVec3::ZERO; MOST];
        ways.iter_mut().zip(directions()).for_each(|(to, way)| *to = way);
        for p in points {
            for (i, way) in ways.iter().enumerate() {
                let reach = way.dot(p);
                if reach > all.reach[i] {
                    (all.reach[i], all.points[i]) = (reach, p);
                }
            }
        }
        for i in 0..MOST {
            let p = all.points[i];
            if !all.points[..all.len].contains(&p) {
                all.points[all.len] = p;
                all.len += 1;
            }
        }
        all
    }

    pub fn points(&self) -> &[DVec3] {
        &self.points[..self.len]
    }

    /// The moments of the hull's surface; `None` for one without volume.
    pub fn surface(&self) -> Option<Moments> {
        let points = self.points();
        let mut hull = Hull::start(points)?;
        for i in 0..points.len() {
            hull.add(points, i);
        }
        let mut moments = Moments::NONE;
        for face in &hull.faces[..hull.len] {
            moments.triangle(face.map(|i| points[i as usize]));
        }
        Some(moments)
    }
}

/// Faces, seen from outside counterclockwise.
struct Hull {
    faces: [[u8; 3]; FACES],
    len: usize,
    /// A face sees a point that is farther than this from it.
    least: f64,
}

fn normal(points: &[DVec3], face: [u8; 3]) -> DVec3 {
    let [a, b, c] = face.map(|i| points[i as usize]);
    (b - a).cross(c - a)
}

/// The number of the point for which `far` is greatest.
fn farthest(points: &[DVec3], far: impl Fn(DVec3) -> f64) -> Option<usize> {
    (0..points.len()).max_by(|&i, &j| far(points[i]).total_cmp(&far(points[j])))
}

impl Hull {
    /// A tetrahedron of points that are far from each other.
    fn start(points: &[DVec3]) -> Option<Self> {
        let a = *points.first()?;
        let i = farthest(points, |p| (p - a).length_squared())?;
        let along = points[i] - a;
        let j = farthest(points, |p| (p - a).cross(along).length_squared())?;
        let across = along.cross(points[j] - a);
        let k = farthest(points, |p| (p - a).dot(across).abs())?;
        let size = crate::math::sqrt(along.length_squared());
        let height = (points[k] - a).dot(across);
        if height.abs() <= 1e-9 * size * size * size {
            return None;
        }
        let [i, j, k] = [i as u8, j as u8, k as u8];
        let (i, j) = if height > 0.0 { (j, i) } else { (i, j) };
        let mut hull = Self { faces: [[0; 3]; FACES], len: 0, least: 1e-12 * size * size * size };
        for face in [[0, i, j], [0, j, k], [0, k, i], [i, k, j]] {
            hull.push(face);
        }
        Some(hull)
    }

    fn push(&mut self, face: [u8; 3]) {
        // A hull of so many points has fewer faces; rounding errors cannot harm more than
        // the choice of axes.
        if let Some(place) = self.faces.get_mut(self.len) {
            *place = face;
            self.len += 1;
        }
    }

    /// Replaces the faces that see a point by those that it makes with their outline.
    fn add(&mut self, points: &[DVec3], i: usize) {
        let mut edges = [[0u8; 2]; 3 * FACES];
        let (mut count, mut kept) = (0, 0);
        for at in 0..self.len {
            let face = self.faces[at];
            let n = normal(points, face);
            if n.dot(points[i] - points[face[0] as usize]) <= self.least {
                self.faces[kept] = face;
                kept += 1;
                continue;
            }
            for e in 0..3 {
                let [from, to] = [face[e], face[(e + 1) % 3]];
                // An edge of two such faces is inside the outline.
                if let Some(twin) = edges[..count].iter().position(|&edge| edge == [to, from]) {
                    count -= 1;
                    edges.swap(twin, count);
                } else {
                    edges[count] = [from, to];
                    count += 1;
                }
            }
        }
        self.len = kept;
        for &[from, to] in &edges[..count] {
            self.push([from, to, i as u8]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_a_cube_with_points_inside() {
        let corner =
            |i: i32| DVec3::new(f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2));
        let inside = (0..50).map(|i| DVec3::splat(0.25) + corner(i % 8) * (f64::from(i) / 100.0));
        let extremes = Extremes::new((0..8).map(corner).chain(inside));
        assert_eq!(extremes.points().len(), 8);
        let hull = {
            let mut hull = Hull::start(extremes.points()).expect("a volume");
            (0..8).for_each(|i| hull.add(extremes.points(), i));
            hull
        };
        assert_eq!(hull.len, 12);
        let area: f64 =
            hull.faces[..12].iter().map(|&f| normal(extremes.points(), f).length() / 2.0).sum();
        assert!((area - 6.0).abs() < 1e-12);
    }

    #[test]
    fn a_flat_one_has_none() {
        let points = (0..20).map(|i| DVec3::new(f64::from(i % 5), f64::from(i / 5), 1.0));
        assert!(Extremes::new(points).surface().is_none());
    }
}
