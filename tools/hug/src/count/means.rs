//! All scenes together: each structure beside the first.

use super::Counted;
use hug_bench::table::Table;

/// Sums of logarithms, by structure in the order they came.
#[derive(Default)]
pub struct Means {
    all: Vec<(String, [f64; FIGURES])>,
}

const FIGURES: usize = 6;

const HEAD: [&str; FIGURES] = ["steps", "grids", "voxels", "tests", "bytes", "references"];

impl Means {
    pub fn add(&mut self, name: &str, counted: &Counted) {
        // Primary and random rays count alike.
        let mean = |of: fn(&[f64; 3]) -> f64| {
            counted.rays.iter().map(|rays| of(rays).ln()).sum::<f64>() / counted.rays.len() as f64
        };
        let logs = [
            mean(|[grids, voxels, tests]| grids + voxels + tests),
            mean(|rays| rays[0]),
            mean(|rays| rays[1]),
            mean(|rays| rays[2]),
            counted.bytes().ln(),
            (counted.stats.total.pointers() as f64).ln(),
        ];
        match self.all.iter_mut().find(|known| known.0 == name) {
            Some((_, sums)) => sums.iter_mut().zip(logs).for_each(|(sum, log)| *sum += log),
            None => self.all.push((name.to_owned(), logs)),
        }
    }

    pub fn print(&self, scenes: usize) {
        let Some((first, of_first)) = self.all.first() else { return };
        println!(
            "geometric means over {scenes} scenes, against {first}; steps are grids, voxels and \
             tests together\n"
        );
        let mut table = Table::new(["structure"].into_iter().chain(HEAD));
        for (name, sums) in &self.all {
            let ratios = sums.iter().zip(of_first).map(|(of, first)| {
                let ratio = ((of - first) / scenes as f64).exp();
                if ratio.is_finite() { format!("{ratio:.2}") } else { "-".to_owned() }
            });
            table.row([name.clone()].into_iter().chain(ratios));
        }
        table.print();
    }
}
