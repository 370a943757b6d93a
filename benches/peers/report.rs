//! The tables, in Markdown.

use super::builds::Builds;
use super::contest::Contest;
use hug_bench::figures::Spread;
use hug_bench::load::Loaded;
use hug_bench::table::Table;

pub fn scene(scene: &Loaded, build_rounds: u64) {
    println!("### {}, {} triangles\n", scene.name, scene.mesh.indices.len());
    println!("Builds, from vertices and indices to ready: CPU time, medians of {build_rounds}\n");
}

pub fn builds(built: &Builds, triangles: usize) {
    let mut table = Table::new(["", "build ms", "least - most", "bytes", "B/tri"]);
    let mut names = built.names().into_iter();
    let mut row = |seconds: Spread, bytes: usize| {
        let milliseconds = seconds.times(1e3);
        table.row([
            names.next().unwrap_or_default(),
            format!("{:.1}", milliseconds.median),
            milliseconds.range(1),
            bytes.to_string(),
            format!("{:.1}", bytes as f64 / triangles.max(1) as f64),
        ]);
    };
    for hug in &built.hug {
        row(hug.seconds, hug.scene.view().bytes().len());
    }
    for peer in &built.obvhs {
        row(peer.seconds, peer.tree.bytes());
    }
    table.print();
}

fn name(contest: &Contest) -> String {
    format!("{} {}", contest.set.name(), contest.query.name())
}

pub fn speeds(built: &Builds, contests: &[Contest], rounds: u64) {
    println!("Millions of rays a second, medians of {rounds} rounds\n");
    let head = ["rays", "number"].map(str::to_owned).into_iter();
    let mut table = Table::new(head.chain(built.names()));
    for contest in contests {
        let mut row = vec![name(contest), contest.rays.to_string()];
        for seconds in &contest.seconds {
            let speed = seconds.iter().map(|s| contest.rays as f64 / s / 1e6);
            row.push(format!("{:.3}", Spread::of(speed).median));
        }
        table.row(row);
    }
    table.print();
}

pub fn ratios(built: &Builds, contests: &[Contest]) {
    println!(
        "Speed of hug over that of obvhs, above 1: hug is faster; medians of the rounds' ratios, least - most\n"
    );
    let trees = built.obvhs.iter().map(|b| b.builder.name().to_owned());
    let head = ["rays", "structure"].map(str::to_owned).into_iter();
    let mut table = Table::new(head.chain(trees));
    for contest in contests {
        let (ours, theirs) = contest.seconds.split_at(built.hug.len());
        for (hug, own) in built.hug.iter().zip(ours) {
            let mut row = vec![name(contest), hug.kind.name().to_owned()];
            for other in theirs {
                let ratio = Spread::of(other.iter().zip(own).map(|(theirs, ours)| theirs / ours));
                row.push(format!("{:.3} ({})", ratio.median, ratio.range(3)));
            }
            table.row(row);
        }
    }
    table.print();
}

pub fn differences(built: &Builds, contests: &[Contest]) {
    println!("Rays that end differently: lost by obvhs / invented by it / hit elsewhere\n");
    let trees = built.obvhs.iter().map(|b| b.builder.name().to_owned());
    let head = ["rays", "number"].map(str::to_owned).into_iter();
    let mut table = Table::new(head.chain(trees));
    for contest in contests {
        let mut row = vec![name(contest), contest.rays.to_string()];
        row.extend(
            contest
                .differences
                .iter()
                .map(|d| format!("{} / {} / {}", d.lost, d.invented, d.elsewhere)),
        );
        table.row(row);
    }
    table.print();
}
