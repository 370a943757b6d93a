//! Claims of section 5: how full voxels are, and what it takes.

use super::{Claim, Evidence, Verdict};
use crate::measure::Built;
use crate::sheet::number;

pub fn claims(e: &Evidence<'_>) -> Vec<Claim> {
    vec![mean(e), below_twenty(e), evenly(e), memory(e), two_levels(e)]
}

fn mean(e: &Evidence<'_>) -> Claim {
    let what = "Uniform grid of the kitchen: about one object a voxel, with a standard deviation \
                many times larger";
    let paper = "0.952 and 23";
    let Some(built) = e.kitchen_uniform() else {
        return Claim::missing(what, paper, "the kitchen in a uniform grid");
    };
    let level = &built.stats.total;
    let (distinct, refs) = (level.distinct_per_voxel(), level.objects_per_voxel());
    let many = refs.deviation / refs.mean;
    let near = (0.5..=2.0).contains(&distinct);
    Claim {
        what,
        paper,
        ours: format!("{} and {}", number(distinct), number(refs.deviation)),
        verdict: Verdict::of(near && many >= 5.0, near && many >= 2.0),
        reason: format!(
            "{}: {} objects over {} voxels, figure 12's reading; by section 3's, references, the \
             mean is {} and the deviation {} times that. {} % of the voxels are empty.",
            built.name,
            level.objects,
            level.voxels,
            number(refs.mean),
            number(many),
            number(100.0 - built.stats.shares(level).object_voxels),
        ),
    }
}

fn below_twenty(e: &Evidence<'_>) -> Claim {
    let (what, paper) = ("About 98 % of its voxels hold fewer than 20 objects", "98 %");
    let Some(built) = e.kitchen_uniform() else {
        return Claim::missing(what, paper, "the kitchen in a uniform grid");
    };
    let counts = &built.histograms[0];
    let voxels: u64 = counts.iter().sum();
    let share = 100.0 * counts.iter().take(20).sum::<u64>() as f64 / voxels as f64;
    let refs: u64 = counts.iter().zip(0u64..).map(|(n, i)| n * i).sum();
    let crowded: u64 = counts.iter().zip(0u64..).skip(20).map(|(n, i)| n * i).sum();
    let held = 100.0 * crowded as f64 / refs as f64;
    Claim {
        what,
        paper,
        ours: format!("{} %", number(share)),
        verdict: Verdict::of((share - 98.0).abs() <= 1.5, (share - 98.0).abs() <= 4.0),
        reason: format!(
            "the other {} % hold {} % of all references, the fullest one {}",
            number(100.0 - share),
            number(held),
            counts.len() - 1
        ),
    }
}

/// Mean occupancies of the non-empty voxels, level by level.
fn filled(built: &Built) -> Vec<(f64, f64)> {
    let levels = built.stats.levels().iter().filter(|l| l.object_voxels > 0);
    levels.map(|l| l.objects_per_filled_voxel()).map(|m| (m.mean, m.deviation)).collect()
}

fn spread(values: impl Iterator<Item = f64> + Clone) -> f64 {
    values.clone().fold(0.0, f64::max) / values.fold(f64::INFINITY, f64::min)
}

fn evenly(e: &Evidence<'_>) -> Claim {
    let what = "HUG u.f3.sqrt2: mean and deviation of the occupancy of non-empty voxels are within \
                a factor of two or so on all levels";
    let paper = "means 7.28 to 7.62, deviations 5.96 to 10.6";
    let (Some(hug), Some(uniform)) = (e.kitchen("u.f3.sqrt2"), e.kitchen_uniform()) else {
        return Claim::missing(what, paper, "kit.u.f3.sqrt2 and the kitchen in a uniform grid");
    };
    let levels = filled(hug);
    let (means, deviations) =
        (spread(levels.iter().map(|l| l.0)), spread(levels.iter().map(|l| l.1)));
    let list = |of: fn(&(f64, f64)) -> f64| {
        levels.iter().map(of).map(number).collect::<Vec<_>>().join(", ")
    };
    let ratios: Vec<String> = levels.iter().map(|l| number(l.1 / l.0)).collect();
    let one = uniform.stats.total.objects_per_filled_voxel();
    Claim {
        what,
        paper,
        ours: format!("means {}; deviations {}", list(|l| l.0), list(|l| l.1)),
        verdict: Verdict::of(means <= 2.0 && deviations <= 2.5, means <= 2.0),
        reason: format!(
            "between levels the means differ by a factor of {}, the deviations by {}; deviation \
             over mean is {}, where {} has {}",
            number(means),
            number(deviations),
            ratios.join(", "),
            uniform.name,
            number(one.deviation / one.mean)
        ),
    }
}

fn memory(e: &Evidence<'_>) -> Claim {
    let (what, paper) = ("HUG u.f3.sqrt2 takes half the memory of r50", "4.0 against 7.87 MB");
    let (Some(hug), Some(r50)) = (e.kitchen("u.f3.sqrt2"), e.kitchen("r50")) else {
        return Claim::missing(what, paper, "kit.u.f3.sqrt2 and kit.r50");
    };
    let ratio = hug.megabytes() / r50.megabytes();
    let counts = |b: &Built| {
        format!("{} voxels and {} pointers", b.stats.total.voxels, b.stats.total.pointers())
    };
    Claim {
        what,
        paper,
        ours: format!("{} against {} MB", number(hug.megabytes()), number(r50.megabytes())),
        verdict: Verdict::of(ratio <= 0.6, ratio <= 0.8),
        reason: format!(
            "a ratio of {} without the triangles: {} against {}; the paper has 31443 and 103150 \
             against 61030 and 196232",
            number(ratio),
            counts(hug),
            counts(r50)
        ),
    }
}

fn two_levels(e: &Evidence<'_>) -> Claim {
    let what = "r50: two levels of recursion hold about 88 % of the polygons";
    let paper = "70.4 + 18 %";
    let Some(built) = e.kitchen("r50") else {
        return Claim::missing(what, paper, "kit.r50");
    };
    let shares: Vec<f64> =
        built.stats.levels().iter().map(|l| built.stats.shares(l).objects_of_levels).collect();
    let two: f64 = shares.iter().rev().take(2).sum();
    let list: Vec<String> = shares.iter().rev().map(|&s| number(s)).collect();
    Claim {
        what,
        paper,
        ours: format!("{} %", number(two)),
        verdict: Verdict::of((two - 88.4).abs() <= 8.0, two >= 70.0),
        reason: format!(
            "%obj from the outermost level down, as the tables print it: {}",
            list.join(", ")
        ),
    }
}
