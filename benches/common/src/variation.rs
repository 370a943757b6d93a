//! What may follow the name of a structure: options that the paper has no letter for, each after
//! a plus sign, as in `u.f2.sqrt2+components+min=8`.

use hug::{Clustering, Filter, Gridding, Hierarchy, Options, Orientation};
use std::fmt;
use std::str::FromStr;

/// Options that differ from those of a structure's name.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Variation {
    clustering: Option<Clustering>,
    gridding: Option<Gridding>,
    power: Option<f32>,
    hierarchy: Option<Hierarchy>,
    orientation: Option<Orientation>,
    turn_below: Option<f32>,
    min_cluster: Option<u32>,
    share: Option<f32>,
    alpha: Option<f32>,
    world_alpha: Option<f32>,
    exit_boxes: Option<bool>,
    maxp: Option<u32>,
    fill_up: Option<bool>,
    tree: Option<bool>,
}

const CLUSTERINGS: [(&str, Clustering); 2] =
    [("projections", Clustering::Projections), ("components", Clustering::Components)];

const GRIDDINGS: [(&str, Gridding); 4] = [
    ("proportional", Gridding::Proportional),
    ("homogeneous", Gridding::Homogeneous),
    ("overlap", Gridding::Overlap),
    ("mixed", Gridding::Mixed),
];

const HIERARCHIES: [(&str, Hierarchy); 2] =
    [("nested", Hierarchy::Nested), ("paper", Hierarchy::Paper)];

const ORIENTATIONS: [(&str, Orientation); 4] = [
    ("aligned", Orientation::Aligned),
    ("vertices", Orientation::Vertices),
    ("hull", Orientation::Hull),
    ("search", Orientation::Search),
];

const STEPS: [(&str, bool); 2] = [("exit", true), ("plain", false)];

const CROWDED: [(&str, bool); 2] = [("fill", true), ("unfilled", false)];

const TREES: [(&str, bool); 2] = [("tree", true), ("treeless", false)];

const FORMS: &str = "projections, components, proportional, homogeneous, overlap, mixed, nested, \
                     paper, aligned, vertices, hull, search, exit, plain, fill, unfilled, tree, treeless, or power, \
                     min, share, alpha, world, turn, maxp = a number";

fn of<T: Copy>(list: &[(&str, T)], name: &str) -> Option<T> {
    list.iter().find(|known| known.0 == name).map(|known| known.1)
}

fn name<T: PartialEq>(list: &[(&'static str, T)], value: &T) -> &'static str {
    list.iter().find(|known| known.1 == *value).map_or("", |known| known.0)
}

impl Variation {
    /// A name, and what follows it from the first plus sign on.
    pub fn split(text: &str) -> Result<(&str, Self), String> {
        match text.split_once('+') {
            None => Ok((text, Self::default())),
            Some((name, rest)) => Ok((name, rest.parse()?)),
        }
    }

    /// `options` with what differs.
    pub fn apply(&self, options: Options) -> Options {
        Options {
            clustering: self.clustering.unwrap_or(options.clustering),
            gridding: self.gridding.unwrap_or(options.gridding),
            overlap_power: self.power.unwrap_or(options.overlap_power),
            hierarchy: self.hierarchy.unwrap_or(options.hierarchy),
            orientation: self.orientation.unwrap_or(options.orientation),
            turn_below: self.turn_below.unwrap_or(options.turn_below),
            min_cluster: self.min_cluster.unwrap_or(options.min_cluster),
            filter: self.share.map_or(options.filter, Filter::TwoLevels),
            alpha: self.alpha.unwrap_or(options.alpha),
            world_alpha: self.world_alpha.or(options.world_alpha),
            exit_boxes: self.exit_boxes.unwrap_or(options.exit_boxes),
            maxp: self.maxp.unwrap_or(options.maxp),
            fill_up: self.fill_up.unwrap_or(options.fill_up),
            tree: self.tree.unwrap_or(options.tree),
            ..options
        }
    }

    fn set(&mut self, item: &str) -> Option<()> {
        let Some((key, value)) = item.split_once('=') else {
            self.clustering = of(&CLUSTERINGS, item).or(self.clustering);
            self.gridding = of(&GRIDDINGS, item).or(self.gridding);
            self.hierarchy = of(&HIERARCHIES, item).or(self.hierarchy);
            self.orientation = of(&ORIENTATIONS, item).or(self.orientation);
            self.exit_boxes = of(&STEPS, item).or(self.exit_boxes);
            self.fill_up = of(&CROWDED, item).or(self.fill_up);
            self.tree = of(&TREES, item).or(self.tree);
            let known = of(&CLUSTERINGS, item).is_some()
                || of(&GRIDDINGS, item).is_some()
                || of(&HIERARCHIES, item).is_some()
                || of(&ORIENTATIONS, item).is_some()
                || of(&STEPS, item).is_some()
                || of(&CROWDED, item).is_some()
                || of(&TREES, item).is_some();
            return known.then_some(());
        };
        let plain = value.bytes().all(|b| b.is_ascii_digit() || b == b'.');
        let number = || value.parse().ok().filter(|_| plain);
        let count = || value.parse().ok().filter(|_| plain);
        match key {
            "min" => self.min_cluster = Some(count()?),
            "maxp" => self.maxp = Some(count()?),
            "power" => self.power = Some(number()?),
            "turn" => self.turn_below = Some(number()?),
            "share" => self.share = Some(number()?),
            "alpha" => self.alpha = Some(number()?),
            "world" => self.world_alpha = Some(number()?),
            _ => return None,
        }
        self.apply(Options::default()).check().ok()
    }
}

impl FromStr for Variation {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut all = Self::default();
        for item in text.split('+') {
            all.set(item).ok_or_else(|| {
                format!("+{item}: unknown, or out of range; after a plus sign comes {FORMS}")
            })?;
        }
        Ok(all)
    }
}

impl fmt::Display for Variation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words = [
            self.clustering.map(|c| name(&CLUSTERINGS, &c)),
            self.gridding.map(|g| name(&GRIDDINGS, &g)),
            self.hierarchy.map(|h| name(&HIERARCHIES, &h)),
            self.orientation.map(|o| name(&ORIENTATIONS, &o)),
            self.exit_boxes.map(|e| name(&STEPS, &e)),
            self.fill_up.map(|f| name(&CROWDED, &f)),
            self.tree.map(|t| name(&TREES, &t)),
        ];
        words.into_iter().flatten().try_for_each(|word| write!(f, "+{word}"))?;
        for (key, count) in [("min", self.min_cluster), ("maxp", self.maxp)] {
            if let Some(n) = count {
                write!(f, "+{key}={n}")?;
            }
        }
        let numbers = [
            ("power", self.power),
            ("turn", self.turn_below),
            ("share", self.share),
            ("alpha", self.alpha),
            ("world", self.world_alpha),
        ];
        for (key, number) in numbers {
            if let Some(x) = number {
                write!(f, "+{key}={x}")?;
            }
        }
        Ok(())
    }
}
