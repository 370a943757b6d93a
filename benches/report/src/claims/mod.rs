//! The paper's claims, each judged by what was measured here.

mod calls;
mod clusters;
mod costs;
mod occupancy;
mod oriented;
mod selected;
mod time;

use crate::measure::{Built, Subject};
use crate::oriented::Oriented;
use crate::selected::Comparison;
use crate::sheet::{Cell, Sheet};

/// What becomes of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    Holds,
    Partly,
    DoesNotHold,
    NotMeasured,
}

impl Verdict {
    fn text(self) -> &'static str {
        match self {
            Self::Holds => "holds",
            Self::Partly => "holds in part",
            Self::DoesNotHold => "does not hold",
            Self::NotMeasured => "not measured",
        }
    }

    /// Whether it holds; if not, whether it nearly does.
    fn of(holds: bool, nearly: bool) -> Self {
        match (holds, nearly) {
            (true, _) => Self::Holds,
            (false, true) => Self::Partly,
            (false, false) => Self::DoesNotHold,
        }
    }
}

/// A claim, judged.
pub struct Claim {
    pub what: &'static str,
    pub paper: &'static str,
    pub ours: String,
    pub verdict: Verdict,
    /// The statistic that decides, and what it says of why.
    pub reason: String,
}

impl Claim {
    fn missing(what: &'static str, paper: &'static str, needed: &str) -> Self {
        let reason = format!("needs {needed}");
        Self { what, paper, ours: String::new(), verdict: Verdict::NotMeasured, reason }
    }
}

/// What the claims are judged on: scenes by the paper's names.
pub struct Evidence<'a>(pub &'a [Subject]);

impl<'a> Evidence<'a> {
    fn scene(&self, short: &str) -> Option<&'a Subject> {
        self.0.iter().find(|s| s.short == short)
    }

    fn kitchen(&self, notation: &str) -> Option<&'a Built> {
        self.scene("kit")?.find(notation)
    }

    /// The kitchen's uniform grid by the cube-root criterion.
    fn kitchen_uniform(&self) -> Option<&'a Built> {
        let kitchen = self.scene("kit")?;
        kitchen.built.iter().find(|b| b.stats.structure == hug::Structure::Uniform)
    }
}

/// Those of the parts that were measured.
pub fn all(subjects: &[Subject], boxes: &[Oriented], comparisons: &[Comparison]) -> Vec<Claim> {
    let mut claims = Vec::new();
    if !subjects.is_empty() {
        let evidence = Evidence(subjects);
        let all = [occupancy::claims, calls::claims, costs::claims, time::claims, clusters::claims];
        claims.extend(all.into_iter().flat_map(|claims| claims(&evidence)));
    }
    if !boxes.is_empty() {
        claims.extend(oriented::claims(boxes));
    }
    if !comparisons.is_empty() {
        claims.extend(selected::claims(comparisons));
    }
    claims
}

pub fn sheet(claims: &[Claim]) -> Sheet {
    let head = ["claim", "paper", "ours", "verdict", "why"];
    let mut sheet = Sheet::new("claims", "The paper's claims on our scenes", &head);
    for claim in claims {
        let verdict = claim.verdict.text();
        let cells = [claim.what, claim.paper, &claim.ours, verdict, &claim.reason];
        sheet.row(cells.map(Cell::from));
    }
    sheet
}
