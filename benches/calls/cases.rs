//! Scenes so small that nothing but the fixed cost of a call is left, and rays at them.

use hug::{Geometry, Options, Ray, Scene};
use hug_kit::random::Random;

/// Rays that all meet the same fate.
pub struct Case {
    pub what: &'static str,
    pub scene: Scene,
    pub rays: Vec<Ray>,
    /// Whether every ray hits; if not, every ray misses.
    pub hits: bool,
}

/// Streams of the kit's seed that no other generator uses.
const STREAM: u64 = 0x300;

type Point = [f64; 3];

/// Picks a point to aim at from an origin.
type Aim = fn(&mut Random, &Points, &Point) -> Point;

/// All cases, `count` rays each.
pub fn all(count: usize, options: &Options) -> Result<Vec<Case>, String> {
    let corners = triangle();
    let vertices = corners.map(|p| p.map(|c| c as f32));
    let case = |what, soup: &[Geometry<'_>], hits, aim: Aim| -> Result<Case, String> {
        let scene = Scene::build(soup, options).map_err(|error| format!("{what}: {error}"))?;
        let points = Points::new(corners);
        let rays = rays(&scene, hits, count, &points, aim);
        Ok(Case { what, scene, rays, hits })
    };
    let one = [Geometry::from_mesh(&vertices, &[[0, 1, 2]])];
    Ok(vec![
        case("empty scene", &[], false, Points::inside)?,
        case("one triangle, box missed", &one, false, Points::beside)?,
        case("one triangle, missed in its box", &one, false, Points::within)?,
        case("one triangle, hit", &one, true, Points::inside)?,
    ])
}

/// A triangle whose coordinates are no round numbers.
fn triangle() -> [Point; 3] {
    let mut random = Random::stream(STREAM);
    [[-0.8, -0.6, -0.5], [0.9, -0.4, 0.3], [-0.2, 0.8, 0.6]]
        .map(|corner| corner.map(|c| f64::from((c + random.range(-0.1, 0.1)) as f32)))
}

/// Rays at points that `aim` picks, those alone that end as the case says: different ones, from
/// all around, so that no digit of t, u or v is given away.
fn rays(scene: &Scene, hits: bool, count: usize, points: &Points, aim: Aim) -> Vec<Ray> {
    let mut random = Random::stream(STREAM + 1);
    let view = scene.view();
    let shoot = || {
        let (away, distance) = (random.direction(), random.range(3.0, 6.0));
        let org = away.map(|c| (c * distance) as f32);
        let from = org.map(f64::from);
        let target = aim(&mut random, points, &from);
        let way = [0, 1, 2].map(|k| target[k] - from[k]);
        let length = way.iter().map(|c| c * c).sum::<f64>().sqrt();
        Ray::new(org, way.map(|c| (c / length) as f32)).with_range(0.0, 1e30)
    };
    let as_said = |ray: &Ray| view.occluded(ray) == hits;
    std::iter::repeat_with(shoot).filter(as_said).take(count).collect()
}

/// The triangle and its box, to aim at.
struct Points {
    corners: [Point; 3],
    lo: Point,
    hi: Point,
}

impl Points {
    fn new(corners: [Point; 3]) -> Self {
        let fold = |of: fn(f64, f64) -> f64| {
            [0, 1, 2].map(|k| corners.iter().map(|p| p[k]).reduce(of).unwrap_or(0.0))
        };
        Self { corners, lo: fold(f64::min), hi: fold(f64::max) }
    }

    /// In the triangle.
    fn inside(random: &mut Random, points: &Self, _: &Point) -> Point {
        let (mut u, mut v) = (random.unit(), random.unit());
        if u + v > 1.0 {
            (u, v) = (1.0 - u, 1.0 - v);
        }
        let [a, b, c] = points.corners;
        [0, 1, 2].map(|k| a[k] + (b[k] - a[k]) * u + (c[k] - a[k]) * v)
    }

    /// In its box.
    fn within(random: &mut Random, points: &Self, _: &Point) -> Point {
        [0, 1, 2].map(|k| random.range(points.lo[k], points.hi[k]))
    }

    /// Beside its box: at least 2 from the middle and at a right angle to an origin at least 3
    /// from it, so that the line stays 6 / sqrt(13) away, farther than any corner of the box.
    fn beside(random: &mut Random, _: &Self, from: &Point) -> Point {
        let (away, distance) = (random.direction(), random.range(2.0, 4.0));
        let dot = |a: &Point, b: &Point| (0..3).map(|k| a[k] * b[k]).sum::<f64>();
        let share = dot(&away, from) / dot(from, from);
        let across = [0, 1, 2].map(|k| away[k] - from[k] * share);
        let scale = distance / dot(&across, &across).sqrt();
        across.map(|c| c * scale)
    }
}
