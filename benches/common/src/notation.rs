//! Configurations written as in the paper (section 1.3): `dataSetName.dataStructureName`, such as
//! `kit.g28`, `kit.r50`, `kit.u.f3.sqrt2`, `csbc.u.f3.1`; options of a HUG that the paper has no
//! letter for follow after a plus sign ([`Variation`]).

use super::variation::Variation;
use hug::{Filter, Gridding, Hierarchy, MAX_LEVELS, Options, Structure};
use std::f32::consts::SQRT_2;
use std::fmt;
use std::str::FromStr;

/// A data structure and its parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Notation {
    /// `g28`: a uniform grid of 28 x 28 x 28 voxels; `g`: by the cube-root criterion.
    Uniform(Option<u32>),
    /// `r50`: a recursive grid with MAXP = 50.
    Recursive(u32),
    /// `u.f3.sqrt2`: a HUG, the levels of its filter, and alpha of its world cluster; what
    /// differs from the paper's.
    Hug { levels: u32, alpha: f32, with: Variation },
    /// `auto`: not the paper's; what the library builds unless it is told otherwise.
    Auto,
}

/// A scene, perhaps with a view of it, in a data structure.
#[derive(Clone, Debug, PartialEq)]
pub struct Configuration {
    pub scene: String,
    pub view: Option<String>,
    pub structure: Notation,
}

/// The paper's names of scenes: what is called so here, and the view that the name implies.
const SCENES: [(&str, &str, Option<&str>); 6] = [
    ("kit", "kitchen", None),
    ("kitchenBowlView", "kitchen", Some("kitchenBowlView")),
    ("csb", "building", None),
    ("csbc", "building", Some("desk")),
    ("csbw", "building_walls", None),
    ("gar", "garden", None),
];

/// References that the memory of a build is made for.
const MOST_REFS: u64 = 1 << 28;

/// A scene's name in the paper's notation.
pub fn short(scene: &str) -> &str {
    SCENES.iter().find(|s| s.1 == scene).map_or(scene, |s| s.0)
}

/// A scene and perhaps a view, by the paper's name or by ours.
pub fn scene(name: &str) -> (&str, Option<&'static str>) {
    SCENES.iter().find(|s| s.0 == name).map_or((name, None), |s| (s.1, s.2))
}

impl Notation {
    /// [`Notation::options`] for this many triangles: where capacities would ask for more memory
    /// than machines have they are lowered, never to less than the library's own.
    pub fn options_for(self, triangles: u64) -> Options {
        let options = self.options();
        let fair = (MOST_REFS / triangles.max(1)).max(u64::from(Options::default().max_refs));
        Options { max_refs: options.max_refs.min(fair as u32), ..options }
    }

    /// The options that make it. Those of the paper have homogeneous counts, plain steps, the
    /// paper's hierarchy with clusters of any size, and capacities that few grids reach.
    pub fn options(self) -> Options {
        let base = Options {
            gridding: Gridding::Homogeneous,
            exit_boxes: false,
            max_refs: 4096,
            hierarchy: Hierarchy::Paper,
            min_cluster: 1,
            ..Options::default()
        };
        match self {
            Self::Uniform(n) => {
                Options { structure: Structure::Uniform, counts: [n.unwrap_or(0); 3], ..base }
            }
            Self::Recursive(maxp) => Options { structure: Structure::Recursive, maxp, ..base },
            Self::Hug { levels, alpha, with } => with.apply(Options {
                structure: Structure::Hug,
                filter: match levels {
                    1 => Filter::Thresholds { count: 0, at: [0.0; MAX_LEVELS - 1] },
                    2 => Filter::default(),
                    _ => Filter::ThreeLevels,
                },
                world_alpha: Some(alpha),
                ..base
            }),
            Self::Auto => Options::default(),
        }
    }
}

impl fmt::Display for Notation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Uniform(None) => write!(f, "g"),
            Self::Uniform(Some(n)) => write!(f, "g{n}"),
            Self::Recursive(maxp) => write!(f, "r{maxp}"),
            Self::Hug { levels, alpha, with } if *alpha == SQRT_2 => {
                write!(f, "u.f{levels}.sqrt2{with}")
            }
            Self::Hug { levels, alpha, with } => write!(f, "u.f{levels}.{alpha}{with}"),
            Self::Auto => write!(f, "auto"),
        }
    }
}

impl fmt::Display for Configuration {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let implied = |s: &&(&str, &str, Option<&str>)| s.1 == self.scene && s.2 == self.view();
        match SCENES.iter().find(implied) {
            Some(known) => write!(f, "{}.{}", known.0, self.structure),
            None => write!(f, "{}.{}", short(&self.scene), self.structure),
        }
    }
}

impl Configuration {
    pub fn view(&self) -> Option<&str> {
        self.view.as_deref()
    }
}

const FORMS: &str = "g28, g, r50, u.f2.1, u.f3.sqrt2 or auto";

impl FromStr for Notation {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let refuse = |why: &str| format!("{text}: {why}; a data structure is written {FORMS}");
        let number = |digits: &str, most: u32| {
            // No sign, which `parse` would take.
            let plain = digits.bytes().all(|b| b.is_ascii_digit());
            let n = digits.parse().ok().filter(|n| plain && (1..=most).contains(n));
            n.ok_or_else(|| refuse(&format!("{digits:?} is not a number from 1 to {most}")))
        };
        if text == "auto" {
            Ok(Self::Auto)
        } else if let Some(rest) = text.strip_prefix("u.f") {
            let (rest, with) = Variation::split(rest).map_err(|why| refuse(&why))?;
            let (levels, alpha) = rest.split_once('.').ok_or_else(|| refuse("alpha is missing"))?;
            let levels = number(levels, 3)?;
            let alpha = coefficient(alpha).ok_or_else(|| {
                refuse(&format!("{alpha:?} is not a number from 0.1 to 16, or sqrt of one"))
            })?;
            Ok(Self::Hug { levels, alpha, with })
        } else if text == "g" {
            Ok(Self::Uniform(None))
        } else if let Some(n) = text.strip_prefix('g') {
            number(n, 2048).map(|n| Self::Uniform(Some(n)))
        } else if let Some(maxp) = text.strip_prefix('r') {
            number(maxp, u32::MAX).map(Self::Recursive)
        } else {
            Err(refuse("unknown"))
        }
    }
}

/// `1.5`, or the root of a number: `sqrt2`, the paper's `sqr2`, or with the sign.
fn coefficient(text: &str) -> Option<f32> {
    let under = ["sqrt", "sqr", "\u{221a}"].iter().find_map(|root| text.strip_prefix(root));
    let digits = under.unwrap_or(text);
    let plain = digits.bytes().all(|b| b.is_ascii_digit() || b == b'.');
    let x: f32 = digits.parse().ok().filter(|_| plain)?;
    let x = if under.is_some() { x.sqrt() } else { x };
    (0.1..=16.0).contains(&x).then_some(x)
}

impl FromStr for Configuration {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        // Alpha and scenes' names may have dots of their own.
        let split = text.rfind(".u.f").map(|at| (&text[..at], &text[at + 1..]));
        let (name, structure) = split
            .or_else(|| text.rsplit_once('.'))
            .filter(|(name, _)| !name.is_empty())
            .ok_or_else(|| format!("{text}: a configuration is SCENE.STRUCTURE, as kit.r50"))?;
        let (scene, view) = scene(name);
        let view = view.map(str::to_owned);
        Ok(Self { scene: scene.to_owned(), view, structure: structure.parse()? })
    }
}
