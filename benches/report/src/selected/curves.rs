//! What section 7.5 compares: curves, each a structure over one of its parameters.

use hug_bench::notation::Notation;
use std::str::FromStr;

/// What everything else is read against.
pub const RECURSIVE: &str = "rMAXP";

/// The others, unless the command line names others. A new variant of the HUG is a line here, in
/// the notation that `hug_bench::notation` reads.
pub const COMPARED: [&str; 5] = ["u.f2.ALPHA", "u.f3.ALPHA", "u.f2.ALPHA+components", "g", "auto"];

/// What stands for `ALPHA`, the subdivision of the world cluster, the coarsest first.
const ALPHAS: [&str; 8] = ["0.25", "0.35", "0.5", "0.7", "1", "sqrt2", "2", "2.8"];

/// What stands for `MAXP`.
const MAXPS: [&str; 7] = ["1000", "500", "200", "100", "50", "20", "10"];

/// A structure over one of its parameters: `u.f2.ALPHA`, `rMAXP`; or a single structure.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    pub name: String,
    /// The parameter's value, empty for a single structure, and the whole notation.
    pub members: Vec<(String, Notation)>,
}

impl FromStr for Curve {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        let over = [("ALPHA", &ALPHAS[..]), ("MAXP", &MAXPS[..])];
        let found = over.iter().find(|(place, _)| name.contains(place));
        let members = match found {
            None => vec![(String::new(), name.parse()?)],
            Some((place, values)) => values
                .iter()
                .map(|&value| Ok((value.to_owned(), name.replacen(place, value, 1).parse()?)))
                .collect::<Result<_, String>>()?,
        };
        Ok(Self { name: name.to_owned(), members })
    }
}

/// The recursive grid's curve, and then those asked for or the usual ones, each once.
pub fn all(asked: &[Curve]) -> Result<Vec<Curve>, String> {
    let mut all: Vec<Curve> = vec![RECURSIVE.parse()?];
    let usual = COMPARED.iter().filter(|_| asked.is_empty()).map(|name| name.parse());
    for curve in asked.iter().cloned().map(Ok).chain(usual) {
        let curve = curve?;
        if !all.contains(&curve) {
            all.push(curve);
        }
    }
    Ok(all)
}
