//! Builds of both libraries, timed in turns.

use super::Args;
use super::peer::{self, Builder};
use hug::Scene;
use hug_bench::clock;
use hug_bench::figures::Spread;
use hug_bench::kind::Kind;
use hug_bench::load::Loaded;
use hug_bench::rounds::{self, Contender};
use std::hint::black_box;

/// A structure of hug's.
pub struct Hug {
    pub kind: Kind,
    pub scene: Scene,
    pub seconds: Spread,
}

/// A tree of obvhs's.
pub struct Obvhs {
    pub builder: Builder,
    pub tree: peer::Built,
    pub seconds: Spread,
}

pub struct Builds {
    pub hug: Vec<Hug>,
    pub obvhs: Vec<Obvhs>,
}

impl Builds {
    /// The contenders' names, in the order of the contests.
    pub fn names(&self) -> Vec<String> {
        let hug = self.hug.iter().map(|b| format!("hug {}", b.kind.name()));
        hug.chain(self.obvhs.iter().map(|b| format!("obvhs {}", b.builder.name()))).collect()
    }
}

pub fn run(scene: &Loaded, args: &Args) -> Result<Builds, String> {
    let hug = args.structure.iter().map(|&kind| scene.build(&kind.options()).map(|b| (kind, b)));
    let hug: Vec<(Kind, Scene)> = hug.collect::<Result<_, _>>()?;
    let obvhs: Vec<(Builder, peer::Built)> =
        args.builder.iter().map(|&b| (b, peer::Built::new(b, &scene.mesh))).collect();
    let ours = args.structure.iter().map(|kind| -> Contender<'_> {
        let options = kind.options();
        Box::new(move |_| {
            black_box(Scene::build(&scene.soup(), &options).ok());
        })
    });
    let theirs = args.builder.iter().map(|&builder| -> Contender<'_> {
        Box::new(move |_| {
            black_box(peer::Built::new(builder, &scene.mesh));
        })
    });
    let mut all: Vec<Contender<'_>> = ours.chain(theirs).collect();
    let rounds = args.build_rounds as usize;
    // The builds above were the warm-up.
    let seconds = rounds::run_warm(&mut all, 1, rounds, clock::process);
    let mut spreads = seconds.into_iter().map(Spread::of);
    let mut timed = || spreads.next().expect("one a contender");
    Ok(Builds {
        hug: hug.into_iter().map(|(kind, scene)| Hug { kind, scene, seconds: timed() }).collect(),
        obvhs: obvhs
            .into_iter()
            .map(|(builder, tree)| Obvhs { builder, tree, seconds: timed() })
            .collect(),
    })
}
