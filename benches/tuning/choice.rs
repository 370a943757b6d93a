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
        let all = means.iter().enumerate();
        let quickest = all.clone().min_by(|a, b| a.1.queries().total_cmp(&b.1.queries()));
        let Some((place, best)) = quickest else { return 0 };
        match self {
            Self::BestQueries => place,
            Self::SoonestBuild { keep } => {
                let keeps = |m: &Figures| {
                    m.single.iter().zip(&best.single).all(|(one, best)| *one <= best - keep.ln())
                };
                let soonest =
                    all.filter(|(_, m)| keeps(m)).min_by(|a, b| a.1.build.total_cmp(&b.1.build));
                soonest.map_or(place, |(place, _)| place)
            }
        }
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
