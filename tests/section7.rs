//! Section 7 of the paper: components of the box graph and overlap numbers against their
//! definitions, and what is told before a build against what is built.
#![allow(missing_docs)]

mod common;

use common::{build, soups};
use hug::build::{Survey, measure};
use hug::{Advice, Clustering, Error, Filter, Geometry, Options, Reason, Stats, Structure};
use hug_kit::{Mesh, scenes, soups as kit};

fn soup(mesh: &Mesh) -> [Geometry<'_>; 1] {
    [Geometry::from_mesh(&mesh.vertices, &mesh.indices)]
}

/// All triangles in one level below an empty world.
fn all_below() -> Options {
    let mut at = [0.0; 15];
    at[0] = f32::MAX;
    Options {
        structure: Structure::Hug,
        filter: Filter::Thresholds { count: 1, at },
        min_cluster: 1,
        clustering: Clustering::Components,
        ..Options::default()
    }
}

type Box3 = [[f32; 2]; 3];

fn boxes(mesh: &Mesh) -> Vec<Box3> {
    let along = |tri: &[[f32; 3]; 3], k: usize| {
        let c = tri.map(|v| v[k]);
        [c[0].min(c[1]).min(c[2]), c[0].max(c[1]).max(c[2])]
    };
    mesh.triangles().map(|tri| [0, 1, 2].map(|k| along(&tri, k))).collect()
}

fn meet(a: &Box3, b: &Box3, axes: usize) -> bool {
    (0..axes).all(|k| a[k][0] <= b[k][1] && b[k][0] <= a[k][1])
}

/// The triangles that a build does not drop.
fn kept(mesh: &Mesh) -> Mesh {
    let mut kept = Mesh::default();
    for triangle in mesh.triangles() {
        let mut alone = Mesh::default();
        alone.push(triangle);
        if Stats::of(&build(&alone, &Options::default()).view()).triangles == 1 {
            kept.push(triangle);
        }
    }
    kept
}

/// Pairs in the plane and in space, and the sizes of the components, by looking at all.
fn by_definition(boxes: &[Box3]) -> (u64, u64, usize) {
    let (mut plane, mut space) = (0, 0);
    let mut home: Vec<usize> = (0..boxes.len()).collect();
    for i in 0..boxes.len() {
        for j in 0..i {
            plane += u64::from(meet(&boxes[i], &boxes[j], 2));
            if meet(&boxes[i], &boxes[j], 3) {
                space += 1;
                let [from, to] = [home[i].max(home[j]), home[i].min(home[j])];
                home.iter_mut().filter(|h| **h == from).for_each(|h| *h = to);
            }
        }
    }
    let components = (0..boxes.len()).filter(|&i| home.contains(&i)).count();
    (plane, space, components)
}

#[test]
fn components_are_those_of_the_box_graph() {
    let rescaled = kit::rescaled(&kit::clustered(700), 1e-20);
    let more = [("clustered, tiny", rescaled), ("tangle of 1500", kit::tangle(9, 1500))];
    for (name, mesh) in soups().into_iter().chain(more) {
        let survey = Survey::new(&soup(&mesh), &all_below()).expect("a valid soup");
        let mesh = kept(&mesh);
        assert_eq!(survey.triangles, mesh.indices.len() as u64, "{name}");
        let (plane, space, components) = by_definition(&boxes(&mesh));
        let found = (survey.plane_pairs, survey.pairs, survey.components.clusters as usize);
        assert_eq!(found, (plane, space, components), "{name}");
        assert_eq!(survey.components.objects, survey.triangles, "{name}");
        // What is built is what was told.
        let stats = Stats::of(&build(&mesh, &all_below()).view());
        assert_eq!(
            stats.total.grids,
            survey.components.grids + u64::from(components > 0),
            "{name}"
        );
        if components == 0 {
            continue;
        }
        let volume = stats.total.volume / survey.components.volume;
        assert!((volume - 1.0).abs() < 1e-4, "{name}: {volume}");
    }
}

#[test]
fn projections_are_told_too() {
    for (name, mesh) in [("kitchen", scenes::kitchen().mesh), ("garden", scenes::garden().mesh)] {
        for clustering in [Clustering::Projections, Clustering::Components] {
            let options = Options { structure: Structure::Hug, clustering, ..Options::default() };
            let survey = Survey::new(&soup(&mesh), &options).expect("a valid soup");
            let told = match clustering {
                Clustering::Projections => survey.projections,
                Clustering::Components => survey.components,
            };
            let stats = Stats::of(&build(&mesh, &options).view());
            assert_eq!(stats.total.grids - 1, told.grids, "{name}, {clustering:?}");
            assert_eq!(stats.levels()[0].objects, told.objects, "{name}, {clustering:?}");
            assert!((stats.total.volume / told.volume - 1.0).abs() < 1e-4, "{name}");
            assert!(survey.denied() > 0.5, "{name}: {}", survey.denied());
        }
    }
}

/// Components are parts of what is connected in projection, at a delta of nearly nothing.
#[test]
fn components_take_no_more_space() {
    for (name, scene) in [("city", scenes::city()), ("building", scenes::building())] {
        let options = Options { structure: Structure::Hug, ..Options::default() };
        let survey = Survey::new(&soup(&scene.mesh), &options).expect("a valid soup");
        let (before, after) = (survey.projections, survey.components);
        assert!(after.clusters > before.clusters, "{name}: {survey:?}");
        assert!(before.volume > 1.1 && after.volume < 1.1, "{name}: {survey:?}");
    }
}

#[test]
fn a_survey_needs_the_memory_of_a_build() {
    let mesh = kit::clustered(500);
    let options = Options { structure: Structure::Hug, ..Options::default() };
    let bytes = measure(&soup(&mesh), &options).expect("it fits").scratch;
    let mut scratch = vec![0xa5; bytes + 1];
    let expected = Survey::new(&soup(&mesh), &options);
    assert!(expected.is_ok());
    for skip in [0, 1] {
        let part = &mut scratch[skip..skip + bytes];
        assert_eq!(Survey::of(&soup(&mesh), &options, part), expected);
    }
    let short = Survey::of(&soup(&mesh), &options, &mut scratch[..1000]);
    assert_eq!(short, Err(Error::BufferTooSmall));
    let wrong = Survey::new(&soup(&mesh), &Options { min_cluster: 0, ..options });
    assert_eq!(wrong, Err(Error::InvalidValue));
}

#[test]
fn advice() {
    let of = |mesh: &Mesh| Advice::of(&soup(mesh)).expect("a valid soup");
    for (mesh, reason) in [
        (Mesh::default(), Reason::Few),
        (kit::single(), Reason::Few),
        (kit::uniform(20_000), Reason::Even),
        (kit::surface(20_000), Reason::Alike),
        (scenes::kitchen().mesh, Reason::Clustered),
        (scenes::building().mesh, Reason::Clustered),
        (scenes::city().mesh, Reason::Clustered),
        (scenes::garden().mesh, Reason::Clustered),
    ] {
        let advice = of(&mesh);
        assert_eq!(advice.reason, reason, "{advice:?}");
        assert_eq!(advice.prone, reason == Reason::Clustered);
        assert!(advice.structure != Structure::Auto && !advice.reason.message().is_empty());
        assert!((0.0..=1.0).contains(&advice.small) && (0.0..=1.0).contains(&advice.occupied));
        assert_eq!(advice.options(Options::default()).check(), Ok(()));
    }
    let even = of(&kit::uniform(20_000));
    assert!((even.crowding - 1.0).abs() < 0.1 && even.variation < 0.5, "{even:?}");
    assert!((even.occupied - even.expected).abs() < 0.01, "{even:?}");
    // Scale changes nothing that is measured, but for rounding.
    let (kitchen, small) = (scenes::kitchen().mesh, 2f32.powi(-20));
    let scaled = of(&kit::rescaled(&kitchen, small));
    assert_eq!(Advice { ..of(&kitchen) }, scaled);
    let bad = Geometry::from_mesh(&[[0.0; 3]], &[[0, 0, 1]]);
    assert_eq!(Advice::of(&[bad]), Err(Error::IndexRange));
}

/// What does not count is left out, whatever it is.
#[test]
fn advice_of_what_is_not_finite() {
    let mut mesh = kit::uniform(500);
    let plain = Advice::of(&soup(&mesh)).expect("a valid soup");
    mesh.push([[f32::NAN; 3], [0.0; 3], [1.0; 3]]);
    mesh.push([[f32::INFINITY, 0.0, 0.0], [0.0; 3], [1.0; 3]]);
    mesh.push([[7.0; 3]; 3]);
    assert_eq!(Advice::of(&soup(&mesh)), Ok(plain));
    let mut far = Mesh::default();
    for x in [-3e38, 0.0, 3e38f32] {
        far.push([[x; 3], [0.0, x, 1.0], [1.0, 0.0, x]]);
    }
    let advice = Advice::of(&soup(&far)).expect("a valid soup");
    assert!(advice.crowding.is_finite() && advice.variation.is_finite(), "{advice:?}");
}
