//! Which setting is best, by what is known of some scenes.

use super::measure::{Figures, Measured};

/// What makes a setting the best.
#[derive(Clone, Copy)]
pub enum Rule {
    /// Its queries are quickest: for quality HIGH.
    BestQueries,
    /// Of those with this share of that one's speed in each set of rays, it builds soonest: for
    /// the default quality.
    SoonestBuild { keep: f64 },
}

impl Rule {
    pub fn name(self) -> String {
        match self {
            Self::BestQueries => "Quickest queries".to_owned(),
            Self::SoonestBuild { keep } => {
                format!("Soonest build with {keep} of that speed in each set of rays, single")
            }
        }
    }

    /// The best setting's place.
    pub fn choose(self, scenes: &[&Measured]) -> usize {
        let means = means(scenes);
        let best = means.iter().min_by(|a, b| a.queries().total_cmp(&b.queries()));
        let best = best.copied().unwrap_or_default();
        let place = match self {
            Self::BestQueries => means.iter().position(|m| m.queries() <= best.queries()),
            Self::SoonestBuild { keep } => {
                let keeps = |m: &Figures| {
                    m.single.iter().zip(&best.single).all(|(one, best)| *one <= best - keep.ln())
                };
                let fine = means.iter().enumerate().filter(|(_, m)| keeps(m));
                fine.min_by(|a, b| a.1.build.total_cmp(&b.1.build)).map(|(place, _)| place)
            }
        };
        place.unwrap_or(0)
    }
}

/// Each setting's mean figures over scenes.
pub fn means(scenes: &[&Measured]) -> Vec<Figures> {
    let count = scenes.first().map_or(0, |scene| scene.figures.len());
    let mean = |place: usize, figure: &dyn Fn(&Figures) -> f64| {
        scenes.iter().map(|s| figure(&s.figures[place])).sum::<f64>() / scenes.len() as f64
    };
    (0..count)
        .map(|place| Figures {
            build: mean(place, &|f| f.build),
            bytes: mean(place, &|f| f.bytes),
            single: std::array::from_fn(|k| mean(place, &|f| f.single[k])),
            stream: std::array::from_fn(|k| mean(place, &|f| f.stream[k])),
        })
        .collect()
}
