//! The paper's notation is read, written, and refused with a reason.
#![allow(missing_docs)]

use hug::{Clustering, Filter, Gridding, Hierarchy, Options, Structure};
use hug_bench::notation::{Configuration, Notation, scene, short};
use hug_bench::variation::Variation;
use std::f32::consts::SQRT_2;

fn read(text: &str) -> Configuration {
    text.parse().unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn the_papers_configurations() {
    let hug = |levels, alpha| Notation::Hug { levels, alpha, with: Variation::default() };
    let with = "components+min=16".parse().expect("options");
    let components = Notation::Hug { levels: 2, alpha: SQRT_2, with };
    for (text, scene, view, structure) in [
        ("kit.g28", "kitchen", None, Notation::Uniform(Some(28))),
        ("kit.r50", "kitchen", None, Notation::Recursive(50)),
        ("kit.r500", "kitchen", None, Notation::Recursive(500)),
        ("kit.u.f3.sqrt2", "kitchen", None, hug(3, SQRT_2)),
        ("kit.u.f2.sqrt2", "kitchen", None, hug(2, SQRT_2)),
        ("csbc.u.f3.1", "building", Some("desk"), hug(3, 1.0)),
        ("csbc.g80", "building", Some("desk"), Notation::Uniform(Some(80))),
        ("kitchenBowlView.r50", "kitchen", Some("kitchenBowlView"), Notation::Recursive(50)),
        ("city.g", "city", None, Notation::Uniform(None)),
        ("bunny.auto", "bunny", None, Notation::Auto),
        ("clustered:500.u.f1.1.5", "clustered:500", None, hug(1, 1.5)),
        ("kit.u.f2.sqrt2+components+min=16", "kitchen", None, components),
        ("my.scene.r4", "my.scene", None, Notation::Recursive(4)),
    ] {
        let found = read(text);
        let view = view.map(str::to_owned);
        assert_eq!(found, Configuration { scene: scene.to_owned(), view, structure }, "{text}");
        assert_eq!(found.to_string(), text);
    }
}

#[test]
fn variations_of_the_recursive_grid() {
    let written = "+fill+maxp=128+world=0.8";
    let variation: Variation = "world=0.8+maxp=128+fill".parse().expect("options");
    let options = variation.apply(Options::default());
    assert_eq!((options.maxp, options.fill_up, options.world_alpha), (128, true, Some(0.8)));
    assert_eq!(variation.to_string(), written);
}

#[test]
fn other_spellings() {
    for (text, written) in [
        ("kit.u.f3.\u{221a}2", "kit.u.f3.sqrt2"),
        ("kit.u.f3.sqr2", "kit.u.f3.sqrt2"),
        ("kitchen.u.f2.1.0", "kit.u.f2.1"),
        ("building_walls.r050", "csbw.r50"),
        ("kit.u.f2.sqrt4", "kit.u.f2.2"),
    ] {
        assert_eq!(read(text).to_string(), written);
    }
}

#[test]
fn refused_with_a_reason() {
    for text in [
        "",
        "kit",
        "kit.",
        ".r50",
        "kit.x",
        "kit.r",
        "kit.r0",
        "kit.r-1",
        "kit.r+5",
        "kit.r5x",
        "kit.g0",
        "kit.g2049",
        "kit.g1.5",
        "kit.u",
        "kit.u.f3",
        "kit.u.f0.1",
        "kit.u.f4.1",
        "kit.u.f2.",
        "kit.u.f2.nan",
        "kit.u.f2.-1",
        "kit.u.f2.17",
        "kit.u.f2.sqrt",
        "kit.u.f2.1e1",
        "kit.u.f2.1+",
        "kit.u.f2.1+island",
        "kit.u.f2.1+min=0",
        "kit.u.f2.1+power=5",
        "kit.u.f2.1+power=-1",
        "kit.u.f2.1+components=1",
        "kit.r99999999999",
    ] {
        let error = text.parse::<Configuration>().expect_err(text);
        assert!(error.starts_with(text) || error.contains(": "), "{text}: {error}");
    }
}

#[test]
fn options_are_the_papers() {
    for text in ["g28", "g", "r50", "u.f1.1", "u.f2.sqrt2", "u.f3.1"] {
        let options: Options = text.parse::<Notation>().expect(text).options();
        assert_eq!(options.check(), Ok(()), "{text}");
        assert!(!options.exit_boxes && options.gridding == Gridding::Homogeneous, "{text}");
    }
    let options = |text: &str| text.parse::<Notation>().expect("as in the paper").options();
    assert_eq!(options("g28").counts, [28; 3]);
    assert_eq!((options("r500").structure, options("r500").maxp), (Structure::Recursive, 500));
    assert_eq!(options("u.f3.1").filter, Filter::ThreeLevels);
    assert_eq!(options("u.f2.sqrt2").world_alpha, Some(SQRT_2));
    assert_eq!(options("auto"), Options::default());
    let varied = options("u.f2.1+components+mixed+nested+exit+power=0.25+world=2.5+share=0.01");
    assert_eq!((varied.clustering, varied.gridding), (Clustering::Components, Gridding::Mixed));
    assert_eq!((varied.hierarchy, varied.exit_boxes), (Hierarchy::Nested, true));
    assert_eq!((varied.overlap_power, varied.world_alpha), (0.25, Some(2.5)));
    assert_eq!(varied.filter, Filter::TwoLevels(0.01));
    let refs = |triangles| Notation::Recursive(50).options_for(triangles).max_refs;
    assert_eq!((refs(0), refs(20_000), refs(1 << 20), refs(1 << 30)), (4096, 4096, 256, 32));
}

#[test]
fn names_of_scenes() {
    assert_eq!((short("kitchen"), short("building"), short("bunny")), ("kit", "csb", "bunny"));
    assert_eq!(scene("kit"), ("kitchen", None));
    assert_eq!(scene("csbc"), ("building", Some("desk")));
    assert_eq!(scene("city"), ("city", None));
}
