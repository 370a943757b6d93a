//! Claims of section 4: what a call costs depends on who calls.

use super::{Claim, Evidence, Verdict};
use crate::measure::{Built, Subject};
use crate::sheet::number;
use crate::tables::costs::{PAPERS, factor};
use hug_bench::costs::{Costs, Function};
use hug_bench::notation::Notation;

pub fn claims(e: &Evidence<'_>) -> Vec<Claim> {
    vec![vary(e), coarse(e), model(e)]
}

/// The paper's structures of a scene, as a view of it calls them.
struct Callers<'a> {
    subject: &'a Subject,
    frame: usize,
    all: Vec<(&'a Built, &'a Costs)>,
}

impl<'a> Callers<'a> {
    fn all(e: &Evidence<'a>) -> Vec<Self> {
        let views = e.0.iter().flat_map(|s| (0..s.frames.len()).map(move |frame| (s, frame)));
        let papers = |&(b, _): &(&Built, &Costs)| b.notation != Notation::Auto;
        let callers = views.map(|(subject, frame)| {
            let costs = subject.costs[frame].iter();
            Self { subject, frame, all: subject.built.iter().zip(costs).filter(papers).collect() }
        });
        callers.filter(|callers| callers.all.len() > 1).collect()
    }

    fn name(&self) -> String {
        format!("{}, view {}", self.subject.short, self.subject.frames[self.frame].view)
    }

    fn factors(&self) -> [f64; 3] {
        PAPERS.map(|f| factor(self.all.iter().map(|&(_, costs)| costs), f))
    }
}

fn vary(e: &Evidence<'_>) -> Claim {
    let what = "Call costs vary by up to 5 with the structure they are called from";
    let paper = "t_pi 5.5 (2.9e-7 to 1.6e-6 s), t_rg + t_bi 1.8, t_nc 2.3";
    let all = Callers::all(e);
    let largest = |c: &Callers<'_>| c.factors().into_iter().fold(0.0, f64::max);
    let Some(most) = all.iter().max_by(|a, b| largest(a).total_cmp(&largest(b))) else {
        return Claim::missing(what, paper, "two of the paper's structures and a view");
    };
    let text = |[pi, bi, nc]: [f64; 3]| {
        format!("t_pi {}, t_rg + t_bi {}, t_nc {}", number(pi), number(bi), number(nc))
    };
    let each: Vec<String> =
        all.iter().map(|c| format!("{}: {}", c.name(), text(c.factors()))).collect();
    Claim {
        what,
        paper,
        ours: format!("{} ({})", text(most.factors()), most.name()),
        verdict: Verdict::of(largest(most) >= 4.0, largest(most) >= 2.0),
        reason: format!(
            "largest over smallest cost among the paper's structures: {}",
            each.join("; ")
        ),
    }
}

/// The pair of the paper's text.
fn coarse(e: &Evidence<'_>) -> Claim {
    let what = "A ray-polygon test costs 4 times as much in csbc.r50 as in csbc.r500";
    let paper = "1.19e-6 against 2.97e-7 s";
    let pair = e.scene("csb").and_then(|s| {
        let frame = s.frames.iter().position(|f| f.view == "desk")?;
        let find = |maxp| s.built.iter().position(|b| b.notation == Notation::Recursive(maxp));
        let (fine, coarse) = (find(50)?, find(500)?);
        Some((
            &s.costs[frame][fine],
            &s.costs[frame][coarse],
            &s.built[fine],
            &s.built[coarse],
            frame,
        ))
    });
    let Some((fine, coarse, r50, r500, frame)) = pair else {
        return Claim::missing(what, paper, "csbc.r50 and csbc.r500");
    };
    let cost = |c: &Costs| c.each(Function::Test).median;
    let ratio = cost(fine) / cost(coarse);
    let passed = |b: &Built| number(b.calls(frame).percent_passed_2());
    let list = |c: &Costs| c.calls(Function::Test) as f64 / c.calls(Function::Voxel) as f64;
    Claim {
        what,
        paper,
        ours: format!("{} against {} ns", number(cost(fine)), number(cost(coarse))),
        verdict: Verdict::of(ratio >= 3.0, ratio >= 1.5),
        reason: format!(
            "a factor of {}; %s2 {} and {}, so with r500 fewer tests go far; but mostly because \
             tests come in lists, {} a voxel with r50 and {} with r500, and the cost of a list is \
             shared by its triangles: eight are sieved at once, and boxes are looked at first \
             where a list is long",
            number(ratio),
            passed(r50),
            passed(r500),
            number(list(fine)),
            number(list(coarse))
        ),
    }
}

fn model(e: &Evidence<'_>) -> Claim {
    let what = "So time cannot be predicted as sum(calls x cost) with costs measured elsewhere";
    let paper = "\"difficult\"";
    let all = Callers::all(e);
    if all.is_empty() {
        return Claim::missing(what, paper, "two of the paper's structures and a view");
    }
    let off = |calls: &Costs, costs: &Costs| {
        calls.predicted(costs, &Function::ALL) / calls.measured.median
    };
    let (mut own, mut others) = (Vec::new(), Vec::new());
    for callers in &all {
        for (i, &(_, calls)) in callers.all.iter().enumerate() {
            own.push(off(calls, calls));
            let rest = callers.all.iter().enumerate().filter(|&(j, _)| j != i);
            others.extend(rest.map(|(_, &(_, costs))| off(calls, costs)));
        }
    }
    let least = |of: &[f64]| of.iter().copied().fold(f64::INFINITY, f64::min);
    let most = |of: &[f64]| of.iter().copied().fold(0.0, f64::max);
    let range = |of: &[f64]| format!("{} to {}", number(least(of)), number(most(of)));
    let width = |of: &[f64]| most(of) / least(of);
    Claim {
        what,
        paper,
        ours: format!("predicted over measured: {}", range(&others)),
        verdict: Verdict::of(width(&others) >= 2.0 * width(&own), width(&others) > width(&own)),
        reason: format!(
            "with its own costs each configuration is predicted at {} of its measured time; with \
             those of another structure in the same view the spread is {} times as wide",
            range(&own),
            number(width(&others) / width(&own))
        ),
    }
}
