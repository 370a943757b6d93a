//! The ray sets: counts, order, invariants, and the bytes of small ones.

use hug_kit::mesh::fnv1a;
use hug_kit::rays::{
    FAR, Hit, NONE, Ray, bounce, bounce_count, primary, primary_pixels, random, shadow,
    shadow_count,
};
use hug_kit::{Bounds, View};

const BOX: Bounds = Bounds { lo: [-1.0, 0.0, -2.0], hi: [3.0, 2.0, 2.0] };

fn length(v: [f32; 3]) -> f32 {
    v.iter().map(|c| c * c).sum::<f32>().sqrt()
}

/// Every third ray misses; the others hit a wall that they see from behind or before.
fn hits(rays: &[Ray]) -> Vec<Hit> {
    let hit = |i: usize| Hit {
        t: 1.0 + (i % 5) as f32,
        u: 0.0,
        v: 0.0,
        ng: if i.is_multiple_of(2) { [2.0, 0.0, 0.0] } else { [0.0, -0.5, 0.1] },
        geom: if i % 3 == 2 { NONE } else { 0 },
        prim: 0,
        inst: NONE,
        reserved: 0,
    };
    (0..rays.len()).map(hit).collect()
}

fn fingerprint(rays: &[Ray]) -> u64 {
    fnv1a(bytemuck::cast_slice(rays).iter().copied())
}

#[test]
fn primary_rays_come_in_tiles() {
    let pixels: Vec<_> = primary_pixels(20).collect();
    assert_eq!(pixels.len(), 400);
    assert_eq!(
        pixels[..9],
        [[0, 0], [1, 0], [2, 0], [3, 0], [4, 0], [5, 0], [6, 0], [7, 0], [0, 1]]
    );
    assert_eq!(pixels[64], [8, 0]);
    assert_eq!(pixels[128], [16, 0]);
    assert_eq!(pixels[132], [16, 1]);
    let mut sorted = pixels.clone();
    sorted.sort_unstable();
    sorted.dedup();
    assert_eq!(sorted.len(), 400);
}

#[test]
fn primary_rays_span_the_field_of_view() {
    let view = View { eye: [0.0; 3], at: [0.0, 0.0, -5.0], up: [0.0, 1.0, -3.0], fov_deg: 90.0 };
    let rays: Vec<Ray> = primary(&view, 2).collect();
    let third = (1.0f32 / 6.0).sqrt();
    for (ray, [x, y]) in rays.iter().zip([[-1.0, 1.0], [1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]]) {
        let expected = [x * third, y * third, -2.0 * third];
        let error = ray.dir.iter().zip(expected).map(|(a, b)| (a - b).abs());
        assert!(error.fold(0.0, f32::max) < 1e-6, "{:?}", ray.dir);
        assert_eq!((ray.tmin, ray.tmax, ray.mask, ray.flags), (0.0, FAR, u32::MAX, 0));
        assert_eq!((ray.skip_geom, ray.skip_prim), (NONE, NONE));
    }
}

#[test]
fn secondary_rays_start_on_the_side_that_was_seen() {
    let rays: Vec<Ray> = primary(&View::derived(&BOX), 32).collect();
    let hits = hits(&rays);
    let shadow: Vec<Ray> = shadow(&BOX, 32, &rays, &hits).collect();
    assert_eq!(shadow.len(), shadow_count(32, &hits));
    assert!(shadow.len() > 32 * 32 / 2);
    assert!(shadow.iter().all(|r| (length(r.dir) - 1.0).abs() < 1e-6 && r.tmax < 10.0));
    let bounced: Vec<Ray> = bounce(1, &BOX, &rays, &hits).collect();
    assert_eq!(bounced.len(), bounce_count(&hits));
    let from = rays.iter().zip(&hits).filter(|(_, h)| h.is_hit());
    for ((ray, hit), next) in from.zip(&bounced) {
        let dot = |a: [f32; 3], b: [f32; 3]| (0..3).map(|k| a[k] * b[k]).sum::<f32>();
        assert!(dot(next.dir, hit.ng) * dot(ray.dir, hit.ng) <= 0.0);
        assert!((length(next.dir) - 1.0).abs() < 1e-6);
    }
}

#[test]
fn one_disagreement_changes_one_ray() {
    let rays: Vec<Ray> = primary(&View::derived(&BOX), 16).collect();
    let mut hits = hits(&rays);
    let before: Vec<Ray> = bounce(1, &BOX, &rays, &hits).collect();
    hits[0].geom = NONE;
    let after: Vec<Ray> = bounce(1, &BOX, &rays, &hits).collect();
    assert_eq!(before[1..], after);
}

#[test]
fn random_rays_fill_the_box() {
    let rays: Vec<Ray> = random(&BOX).take(4000).collect();
    let seen = Bounds::of(rays.iter().map(|r| r.org)).expect("a box");
    for k in 0..3 {
        assert!(BOX.lo[k] <= seen.lo[k] && seen.lo[k] < BOX.lo[k] + 0.02);
        assert!(BOX.hi[k] - 0.02 < seen.hi[k] && seen.hi[k] <= BOX.hi[k]);
        let mean = rays.iter().map(|r| r.dir[k]).sum::<f32>() / 4000.0;
        assert!(mean.abs() < 0.03);
    }
}

/// What the sets were when the first comparison was made.
#[test]
fn ray_sets_are_frozen() {
    let first: Vec<Ray> = primary(&View::derived(&BOX), 64).collect();
    let hits = hits(&first);
    let sets: [Vec<Ray>; 4] = [
        shadow(&BOX, 64, &first, &hits).collect(),
        bounce(1, &BOX, &first, &hits).collect(),
        bounce(2, &BOX, &first, &hits).collect(),
        random(&BOX).take(1000).collect(),
    ];
    let now = [fingerprint(&first)].into_iter().chain(sets.iter().map(|s| fingerprint(s)));
    let now: Vec<u64> = now.collect();
    let frozen = [
        0x4e62_7b8b_fd84_4df5,
        0xfe78_2a2d_5e94_ac1f,
        0xecba_ac1b_c4f0_6566,
        0xa136_cfa8_7024_a601,
        0xaaae_9c3c_1788_5c39,
    ];
    assert_eq!(now, frozen, "{now:#x?}");
}
