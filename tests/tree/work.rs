//! What building trees takes, at most, what more care is worth, and where there is none.

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

/// Trees of soups that are joined or split one by one: as much work as is promised, not too
/// deep, and what they find is right.
#[test]
fn chains_are_bounded() {
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
    for (name, mesh) in meshes().into_iter().chain(chains) {
        let n = mesh.indices.len() as u64;
        let [normal, high] = trees().map(|options| {
            let scene = build(&mesh, &options);
            let rays: Vec<Ray> =
                adversarial_rays(&mesh, 9, 20).iter().map(|(_, one)| ray(one)).collect();
            // In a stream some of them are on their way through more nodes than it has room for.
            let mut hits = vec![Hit::miss(7.0); rays.len()];
            scene.view().intersect_n(&rays, &mut hits);
            for (one, hit) in rays.iter().zip(&hits) {
                let expected = scene.view().intersect_brute(one);
                assert_same(&scene.view().intersect(one), &expected, one, &name);
                assert_same(hit, &expected, one, &name);
            }
            work(&mesh, &options)
        });
        assert!(normal <= 22 * n, "{name}: {normal}");
        assert!(high <= n * (187 + u64::from(n.ilog2() + 1)) + 400, "{name}: {high}");
    }
}

/// More care is worth it, in the mean of soups: what nodes and leaves cost, by surface, is less.
#[test]
fn care_costs_less() {
    let soups = [
        soups::clustered(4000),
        soups::surface(4000),
        soups::uniform(4000),
        soups::tangle(2, 4000),
    ];
    let mut ratio = 1.0;
    for mesh in soups {
        let [normal, high] = trees().map(|options| {
            let scene = build(&mesh, &options);
            let bytes = scene.view().bytes();
            let mut cost = 0.0;
            for (number, part, word) in parts(bytes) {
                let b = bounds(bytes, number, part).map(f64::from);
                let [x, y, z] = [b[1] - b[0], b[3] - b[2], b[5] - b[4]];
                // In instructions.
                let of_part = match word & 15 {
                    IS_NODE => 67.0,
                    triangles => 190.0 + 3.0 * f64::from(triangles),
                };
                if word != 0 {
                    cost += (x * y + y * z + z * x) * of_part;
                }
            }
            cost
        });
        ratio *= high / normal;
    }
    assert!(ratio < 0.9, "{ratio}");
}

/// A fine model on a plane of a million times its size: margins would make one leaf of it all.
#[test]
fn what_is_tiny_has_none() {
    let mut mesh = soups::clustered(2000);
    let bounds = mesh.bounds().expect("vertices");
    let size = bounds.hi[0] - bounds.lo[0];
    assert!(count(build(&mesh, &options()).view().bytes(), NODES) > 0);
    let far = 1e6 * size;
    mesh.push([[-far, -far, 0.0], [far, -far, 0.0], [0.0, far, 0.0]]);
    let scene = build(&mesh, &options());
    assert_eq!(count(scene.view().bytes(), NODES), 0);
    for (_, one) in adversarial_rays(&mesh, 8, 20) {
        let one = ray(&one);
        let expected = scene.view().intersect_brute(&one);
        assert_same(&scene.view().intersect(&one), &expected, &one, &"tiny");
    }
}
