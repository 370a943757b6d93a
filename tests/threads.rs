//! Any number of threads can query one scene; each gets what one alone gets.
#![allow(missing_docs)]

mod common;

use common::{adversarial_rays, build, ray, section_7, structures};
use hug::{Hit, Ray};
use hug_kit::soups;

#[test]
fn sixteen_threads_get_what_one_gets() {
    let mesh = soups::clustered(3000);
    let rays: Vec<Ray> = adversarial_rays(&mesh, 3, 500).iter().map(|(_, r)| ray(r)).collect();
    let bits = |hit: Hit| bytemuck::cast::<Hit, [u32; 10]>(hit);
    for (name, options) in structures().into_iter().chain(section_7()) {
        let scene = build(&mesh, &options);
        let trace = || -> Vec<([u32; 10], bool)> {
            let view = scene.view();
            let mut hits = vec![Hit::miss(0.0); rays.len()];
            view.intersect_n(&rays, &mut hits);
            let streamed = rays.iter().zip(hits).map(|(r, hit)| (bits(hit), view.occluded(r)));
            let single = rays.iter().map(|r| (bits(view.intersect(r)), view.occluded(r)));
            single.chain(streamed).collect()
        };
        let alone = trace();
        assert!(alone.iter().any(|(_, hit)| *hit), "{name}: nothing was hit");
        std::thread::scope(|scope| {
            let others: Vec<_> = (0..16).map(|_| scope.spawn(trace)).collect();
            for other in others {
                let found = other.join().expect("no query panics");
                assert!(found == alone, "{name}: a thread found something else");
            }
        });
    }
}

/// Builds share nothing either: no global state, no lock.
#[test]
fn eight_builds_at_once_make_the_same_bytes() {
    let mesh = soups::tangle(1, 3000);
    for (name, options) in structures().into_iter().chain(section_7()) {
        let alone = build(&mesh, &options);
        std::thread::scope(|scope| {
            let others: Vec<_> = (0..8).map(|_| scope.spawn(|| build(&mesh, &options))).collect();
            for other in others {
                let scene = other.join().expect("no build panics");
                assert!(scene.view().bytes() == alone.view().bytes(), "{name}");
            }
        });
    }
}
