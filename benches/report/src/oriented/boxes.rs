//! Figure 25: how large the boxes of clusters are, turned ones over aligned ones.

use hug::View;

/// A side that is thinner than this, beside the longest, is the room that grids of flat clusters
/// get, and counts as none.
const FLAT: f64 = 1.0 / 65536.0;

/// Ratios nearer to 1 than this are 1: boxes are rounded.
const SAME: f64 = 1e-3;

/// One figure of a cluster's boxes.
pub type Measure = fn(&Ratios) -> Option<f64>;

/// A cluster's turned box over its aligned one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ratios {
    /// `None` where both boxes have none: lines have no surface, walls no volume. Infinite where
    /// only the aligned one has none.
    pub surface: Option<f64>,
    pub volume: Option<f64>,
}

impl Ratios {
    /// Of the sides of two boxes.
    pub fn new(aligned: [f64; 3], turned: [f64; 3]) -> Self {
        let of = |size: fn([f64; 3]) -> f64| {
            let [a, t] = [aligned, turned].map(|sides| size(without_room(sides)));
            (a > 0.0 || t > 0.0).then(|| t / a)
        };
        Self { surface: of(|[x, y, z]| x * y + y * z + z * x), volume: of(|[x, y, z]| x * y * z) }
    }
}

fn without_room(sides: [f64; 3]) -> [f64; 3] {
    let longest = sides.into_iter().fold(0.0, f64::max);
    sides.map(|side| if side < FLAT * longest { 0.0 } else { side })
}

/// Of every grid that is turned in the second scene, by number. Apart from that the two are of
/// the same clusters.
pub fn compare(aligned: &View<'_>, turned: &View<'_>) -> Vec<Option<Ratios>> {
    let sides = |view: &View<'_>, number: usize| {
        let shape = view.grid_shape(number)?;
        Some([0, 1, 2].map(|k| shape.upper[k] - shape.lower[k]))
    };
    let ratios = |number: usize| {
        turned.grid_shape(number)?.frame?;
        Some(Ratios::new(sides(aligned, number)?, sides(turned, number)?))
    };
    (0..turned.grid_count()).map(ratios).collect()
}

/// How many grids of a scene are turned.
pub fn turned(view: &View<'_>) -> usize {
    let frame = |number: &usize| view.grid_shape(*number).is_some_and(|s| s.frame.is_some());
    (0..view.grid_count()).filter(frame).count()
}

/// Percentages of ratios below 1, at 1 and above 1.
pub fn beside_one(ratios: &[f64]) -> [f64; 3] {
    let share = |of: &dyn Fn(f64) -> bool| {
        100.0 * ratios.iter().filter(|&&r| of(r)).count() as f64 / ratios.len().max(1) as f64
    };
    let (below, above) = (share(&|r| r < 1.0 - SAME), share(&|r| r > 1.0 + SAME));
    [below, share(&|r| (r - 1.0).abs() <= SAME), above]
}

/// The middle one, or the mean of the two in the middle; `None` of none.
pub fn median(mut ratios: Vec<f64>) -> Option<f64> {
    ratios.sort_by(f64::total_cmp);
    let n = ratios.len();
    (n > 0).then(|| 0.5 * (ratios[(n - 1) / 2] + ratios[n / 2]))
}

/// Classes of the histograms: the first is of ratios about 0, and then there is one about every
/// multiple of the width, so that what is 1 but for rounding is in one class.
pub const CLASSES: usize = 61;
pub const WIDTH: f64 = 0.05;
pub const START: f64 = -0.5 * WIDTH;

/// How many ratios are in each class. Larger ones are in none.
pub fn histogram(ratios: &[f64]) -> Vec<u64> {
    let mut counts = vec![0; CLASSES];
    for ratio in ratios {
        // Infinite ones become the largest number.
        let class = ((ratio - START) / WIDTH) as usize;
        if let Some(count) = counts.get_mut(class) {
            *count += 1;
        }
    }
    counts
}
