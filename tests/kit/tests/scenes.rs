//! Scenes and soups are what they were, bit for bit, and free of what a soup may contain but a
//! scene should not.

use hug_kit::scenes::{MAX_SIZE, NAMES, generate};
use hug_kit::{Mesh, soups};

/// Fingerprints of the calibrated scenes; a change here makes every recorded figure void.
const FROZEN: [(&str, usize, u64); 8] = [
    ("kitchen", 20987, 0x1cd6_92f3_47ba_ec53),
    ("building_walls", 33060, 0xa9b7_fe05_31d9_4b15),
    ("building", 118670, 0x3f1f_e7d8_4aa0_754b),
    ("city", 52526, 0xa9c6_8974_f03b_8c51),
    ("garden", 45380, 0xc2da_f109_ca7a_9f7d),
    ("surface:1000", 968, 0xe138_d255_4eb6_1850),
    ("uniform:1000", 1000, 0x2bca_79b0_b52c_d55f),
    ("clustered:1000", 1000, 0x7c07_73d1_60d2_8336),
];

#[test]
fn scenes_are_frozen() {
    let now = FROZEN.map(|(name, _, _)| {
        let mesh = generate(name).expect("a scene").mesh;
        (name, mesh.indices.len(), mesh.fingerprint())
    });
    assert_eq!(now, FROZEN, "{now:#x?}");
}

#[test]
fn counts_are_those_of_figure_4_within_a_percent() {
    for (name, paper) in NAMES.into_iter().zip([20947, 32811, 117605, 52136, 45293]) {
        let count = generate(name).expect("a scene").mesh.indices.len();
        assert!(100 * count.abs_diff(paper) <= paper, "{name}: {count}");
    }
}

/// Twice the area is not zero, in arithmetic that is exact enough to tell.
fn is_flat(mesh: &Mesh, prim: usize) -> bool {
    let [a, b, c] = mesh.triangle(prim).map(|v| v.map(f64::from));
    let (e, f) = ([0, 1, 2].map(|k| b[k] - a[k]), [0, 1, 2].map(|k| c[k] - a[k]));
    (0..3).all(|k| e[(k + 1) % 3] * f[(k + 2) % 3] == e[(k + 2) % 3] * f[(k + 1) % 3])
}

#[test]
fn scenes_have_sound_triangles_and_views_inside() {
    for name in NAMES {
        let scene = generate(name).expect("a scene");
        let mesh = &scene.mesh;
        assert!(mesh.vertices.iter().flatten().all(|c| c.is_finite()));
        assert!(mesh.indices.iter().flatten().all(|&v| (v as usize) < mesh.vertices.len()));
        let flat = (0..mesh.indices.len()).filter(|&i| is_flat(mesh, i)).count();
        assert_eq!(flat, 0, "{name} has degenerate triangles");
        let bounds = mesh.bounds().expect("a box");
        assert!(!scene.views.is_empty());
        for v in &scene.views {
            let inside = |k: usize| bounds.lo[k] < v.view.eye[k] && v.view.eye[k] < bounds.hi[k];
            assert!((0..3).all(inside), "{name} {}", v.name);
        }
    }
}

#[test]
fn names_and_sizes_are_checked() {
    for name in ["", "Kitchen", "kitchen:5", "surface", "surface:0", "uniform:x", "city:"] {
        assert!(generate(name).is_none(), "{name}");
    }
    assert!(generate(&format!("uniform:{}", MAX_SIZE + 1)).is_none());
}

#[test]
fn scaling_soups_have_about_as_many_triangles_as_asked() {
    for n in [1, 10, 1000, 40_000] {
        assert_eq!(soups::uniform(n).indices.len(), n);
        assert_eq!(soups::clustered(n).indices.len(), n);
        let surface = soups::surface(n).indices.len();
        assert!(surface.abs_diff(n) <= 2 + n / 10, "{n}: {surface}");
    }
}

#[test]
fn bumpy_spheres_are_closed() {
    for scale in [1e-3, 1.0, 1e6, 1e-30, 1e30] {
        let sphere = soups::bumpy_sphere(24, scale, [0.0; 3]);
        let triangles = sphere.mesh.indices.len();
        assert_eq!(triangles, 4 * 24 * 23);
        assert_eq!(2 * sphere.edges.len(), 3 * triangles);
        // Euler's formula for a sphere.
        assert_eq!(sphere.mesh.vertices.len() + triangles, sphere.edges.len() + 2);
        // Every directed edge once: neighbours agree on what is outside.
        let mut sides: Vec<_> =
            sphere.mesh.indices.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect();
        sides.sort_unstable();
        sides.dedup();
        assert_eq!(sides.len(), 3 * triangles);
    }
}

#[test]
fn lattices_fill_their_cube() {
    let bounds = soups::lattice(5, 200, 16).bounds().expect("a box");
    assert_eq!((bounds.lo, bounds.hi), ([0.0; 3], [16.0; 3]));
}
