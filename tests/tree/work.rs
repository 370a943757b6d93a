//! What building trees takes, at most, and what more care is worth.

use super::*;

/// Triangles each larger than the one before, about one point.
fn nested(count: i32, growth: f32) -> Mesh {
    let mut mesh = Mesh::default();
    for i in 0..count {
        let size = growth.powi(i - count / 2);
        mesh.push([[-size, 0.0, 0.0], [size, 0.0, 0.0], [0.0, size, size]]);
    }
    mesh
}

/// The work of the tree alone.
fn work(mesh: &Mesh, options: &Options) -> u64 {
    let soup = [hug::Geometry::from_mesh(&mesh.vertices, &mesh.indices)];
    let [with, without] = [true, false].map(|tree| {
        let mut control = Control::default();
        let options = Options { tree, ..*options };
        let scene = Scene::build_with(&soup, &options, &mut control).expect("a scene");
        assert_eq!(View::open(scene.view().bytes()).err(), None);
        control.work()
    });
    with - without
}

/// What is counted is levels, so this says how many there are at the most.
#[test]
fn levels_are_few() {
    for (name, mesh) in meshes().into_iter().chain([("nested", nested(120, 2.0))]) {
        let n = mesh.indices.len() as u64;
        let work = work(&mesh, &options());
        assert!(work <= n * (2 + 2 * u64::from(n.ilog2())), "{name}: {work}");
    }
}

/// Trees with more care, of soups that are split one by one: as much work as is promised, not
/// too deep, and what they find is right.
#[test]
fn chains_are_bounded() {
    let [_, high] = trees();
    let mut row = Mesh::default();
    for i in 0..3000 {
        let x = 1.02f32.powi(i);
        row.push([[x, 0.0, 0.0], [x, x, 0.0], [x, 0.0, x]]);
    }
    let one = row.triangle(0);
    let mut same = Mesh::default();
    (0..3000).for_each(|_| same.push(one));
    let chains = [
        ("row", row),
        ("same", same),
        ("nested", nested(120, 2.0)),
        ("nested slowly", nested(5000, 1.01)),
    ];
    for (name, mesh) in chains {
        let n = mesh.indices.len() as u64;
        let work = work(&mesh, &high);
        assert!(work <= n * (220 + 2 * u64::from(n.ilog2() + 1)) + 400, "{name}: {work}");
        let scene = build(&mesh, &high);
        for (_, one) in adversarial_rays(&mesh, 9, 20) {
            let one = ray(&one);
            let expected = scene.view().intersect_brute(&one);
            assert_same(&scene.view().intersect(&one), &expected, &one, &name);
        }
    }
}

/// More care is worth it: what nodes and leaves cost, by surface, is less in sum.
#[test]
fn care_costs_less() {
    let mesh = soups::clustered(4000);
    let [normal, high] = trees().map(|options| {
        let scene = build(&mesh, &options);
        let bytes = scene.view().bytes();
        let mut cost = 0.0;
        for (number, at, word) in parts(bytes) {
            let part = (at - record(bytes, NODES, number) - PARTS.start) / 4;
            let b = bounds(bytes, number, part).map(f64::from);
            let [x, y, z] = [b[1] - b[0], b[3] - b[2], b[5] - b[4]];
            if word != 0 {
                cost += (x * y + y * z + z * x) * if word & 15 == IS_NODE { 67.0 } else { 210.0 };
            }
        }
        cost
    });
    assert!(high < 0.95 * normal, "{high} {normal}");
}
