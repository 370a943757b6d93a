//! Call costs in context (section 4 of the paper): the calls that a traversal makes, recorded and
//! made again, function by function.

use super::clock;
use super::figures::Spread;
use super::rounds::{self, Contender};
pub use hug::replay::Function;
use hug::replay::Tape;
use hug::{Ray, View};
use std::cell::RefCell;
use std::hint::black_box;

/// Most rays of each kind that are recorded: what a record says does not change with more, and
/// many records are held at once so that they can be timed in turn.
const RAYS: usize = 1 << 13;
/// Rays that stay together: a tile of a picture.
const TILE: usize = 64;

/// Whole tiles from all over a picture.
pub fn sample(rays: &[Ray]) -> Vec<Ray> {
    let every = rays.len().div_ceil(RAYS).max(1);
    rays.chunks(TILE).step_by(every).flatten().copied().collect()
}

/// The rays of a picture that are recorded: for closest hits and for occlusion.
pub struct Rays {
    pub closest: Vec<Ray>,
    pub any: Vec<Ray>,
}

impl Rays {
    pub fn of(closest: &[Ray], any: &[Ray]) -> Self {
        Self { closest: sample(closest), any: sample(any) }
    }

    pub fn count(&self) -> usize {
        self.closest.len() + self.any.len()
    }

    /// The queries themselves.
    pub fn trace(&self, view: &View<'_>) {
        for ray in &self.closest {
            black_box(view.intersect(ray));
        }
        for ray in &self.any {
            black_box(view.occluded(ray));
        }
    }

    pub fn record<'a>(&'a self, view: View<'a>) -> Tape<'a> {
        Tape::record(view, &self.closest, &self.any)
    }
}

/// What the calls of one configuration cost.
#[derive(Clone, Debug)]
pub struct Costs {
    pub rays: usize,
    /// How often each of [`Function::ALL`] was called.
    pub calls: [u64; 4],
    /// Nanoseconds a call.
    pub each: [Spread; 4],
    /// Nanoseconds a ray, of the queries themselves.
    pub measured: Spread,
    /// How far the ray-triangle tests got.
    pub tests: Tests,
}

impl Costs {
    pub fn calls(&self, function: Function) -> u64 {
        self.calls[function as usize]
    }

    pub fn each(&self, function: Function) -> Spread {
        self.each[function as usize]
    }

    /// Nanoseconds a ray by the model sum(calls x cost) over some functions, with the costs of
    /// `other`.
    pub fn predicted(&self, other: &Self, functions: &[Function]) -> f64 {
        let part = |&f: &Function| self.calls(f) as f64 * other.each(f).median;
        functions.iter().map(part).sum::<f64>() / self.rays as f64
    }
}

/// The costs of each of some scenes, for the same rays. In every round each scene's queries and
/// each function's calls are run once, in rotating order.
pub fn measure(views: &[View<'_>], rays: &Rays, rounds: usize) -> Vec<Costs> {
    let mut tapes: Vec<Tape<'_>> = views.iter().map(|&view| rays.record(view)).collect();
    let tests: Vec<Tests> = tapes.iter_mut().map(Tests::of).collect();
    let calls: Vec<[u64; 4]> =
        tapes.iter().map(|tape| Function::ALL.map(|f| tape.calls(f))).collect();
    let tapes: Vec<RefCell<Tape<'_>>> = tapes.into_iter().map(RefCell::new).collect();
    let mut all: Vec<Contender<'_>> = Vec::new();
    for (view, tape) in views.iter().zip(&tapes) {
        all.push(Box::new(move |_| rays.trace(view)));
        for function in Function::ALL {
            all.push(Box::new(move |_| {
                black_box(tape.borrow_mut().run(function));
            }));
        }
    }
    // One round to warm up.
    rounds::run_warm(&mut all, 0, 1, clock::thread);
    let seconds = rounds::run_warm(&mut all, 0, rounds, clock::thread);
    let per = |seconds: &[f64], n: f64| Spread::of(seconds.iter().map(|s| s * 1e9 / n.max(1.0)));
    let costs = seconds.chunks(1 + Function::ALL.len()).zip(calls).zip(tests);
    costs
        .map(|((seconds, calls), tests)| Costs {
            rays: rays.count(),
            calls,
            each: [0, 1, 2, 3].map(|i| per(&seconds[1 + i], calls[i] as f64)),
            measured: per(&seconds[0], rays.count() as f64),
            tests,
        })
        .collect()
}

/// Sines of the angle between ray and plane that test_1 might ask for.
pub const SINES: [f64; 3] = [0.001, 0.01, 0.1];

/// Ray-triangle tests by how test_1 might be read: "if the ray and the polygon are coplanar,
/// return".
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tests {
    pub all: u64,
    /// Not parallel to the last bit.
    pub not_parallel: u64,
    /// An angle whose sine is no less than each of [`SINES`].
    pub steep: [u64; 3],
    /// The plane is met at a parameter in the ray's own range.
    pub in_range: u64,
    /// It is met before the closest hit known, too.
    pub in_reach: u64,
    /// The ray comes from the side that the normal points to.
    pub facing: u64,
}

impl Tests {
    fn of(tape: &mut Tape<'_>) -> Self {
        let mut tests = Self::default();
        tape.each_test(|ray, corners, limit| tests.add(ray, corners, f64::from(limit)));
        tests
    }

    fn add(&mut self, ray: &Ray, corners: [[f32; 3]; 3], limit: f64) {
        let [a, b, c] = corners.map(|p| p.map(f64::from));
        let (org, dir) = (ray.org.map(f64::from), ray.dir.map(f64::from));
        let sub = |p: [f64; 3], q: [f64; 3]| [0, 1, 2].map(|k| p[k] - q[k]);
        let dot = |p: [f64; 3], q: [f64; 3]| (0..3).map(|k| p[k] * q[k]).sum::<f64>();
        let (e, f) = (sub(b, a), sub(c, a));
        let normal = [0, 1, 2].map(|k| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            e[i] * f[j] - e[j] * f[i]
        });
        let across = dot(dir, normal);
        self.all += 1;
        self.not_parallel += u64::from(across != 0.0);
        let sine = across.abs() / (dot(dir, dir) * dot(normal, normal)).sqrt();
        for (count, least) in self.steep.iter_mut().zip(SINES) {
            *count += u64::from(sine >= least);
        }
        let t = dot(sub(a, org), normal) / across;
        let range = f64::from(ray.tmin)..=f64::from(ray.tmax);
        self.in_range += u64::from(range.contains(&t));
        self.in_reach += u64::from(range.contains(&t) && t <= limit);
        self.facing += u64::from(across < 0.0);
    }
}
