//! Memory from Rust's allocator: when it has no more, at whatever call, a build says so
//! and keeps nothing; queries never ask for any.
#![allow(missing_docs)]

mod common;

use common::{adversarial_rays, configurations, ray, soups};
use hug::{Counters, Error, Geometry, Hit, Ray, Scene, Stats, View};
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

thread_local! {
    /// Calls until the one that gets nothing; calls so far; bytes live.
    static REFUSE: Cell<usize> = const { Cell::new(usize::MAX) };
    static CALLS: Cell<usize> = const { Cell::new(0) };
    static LIVE: Cell<isize> = const { Cell::new(0) };
}

/// The system's, with a thread's calls counted and one of them refused.
struct Counting;

fn refused(size: usize) -> bool {
    let call = CALLS.get();
    CALLS.set(call + 1);
    let refused = call == REFUSE.get();
    if !refused {
        LIVE.set(LIVE.get() + size as isize);
    }
    refused
}

// SAFETY: memory is the system's or none.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        if refused(layout.size()) {
            return std::ptr::null_mut();
        }
        // SAFETY: the caller's contract.
        unsafe { System.alloc(layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        if refused(layout.size()) {
            return std::ptr::null_mut();
        }
        // SAFETY: the caller's contract.
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn dealloc(&self, memory: *mut u8, layout: Layout) {
        LIVE.set(LIVE.get() - layout.size() as isize);
        // SAFETY: the caller's contract.
        unsafe { System.dealloc(memory, layout) };
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// What `f` returns, the calls it made, and the bytes it kept, if call `refuse` of it
/// gets nothing.
fn watch<R>(refuse: usize, f: impl FnOnce() -> R) -> (R, usize, isize) {
    let (calls, live) = (CALLS.get(), LIVE.get());
    REFUSE.set(refuse.saturating_add(calls));
    let result = f();
    REFUSE.set(usize::MAX);
    (result, CALLS.get() - calls, LIVE.get() - live)
}

#[test]
fn every_allocation_of_a_build_may_fail() {
    for (name, mesh) in soups() {
        for (kind, options) in configurations() {
            let what = format!("{name} in {kind}");
            let soup = [Geometry::from_mesh(&mesh.vertices, &mesh.indices)];
            let build = || Scene::build(&soup, &options);
            let (scene, needed, kept) = watch(usize::MAX, build);
            assert!(needed > 0 && kept > 0, "{what}");
            let (bytes, _, back) = watch(usize::MAX, || scene.map(|s| s.view().bytes().len()));
            assert!(bytes.is_ok() && back == -kept, "{what}: {back} of {kept} bytes came back");
            for refuse in 0..needed {
                let (scene, _, kept) = watch(refuse, build);
                let error = scene.err();
                assert_eq!(error, Some(Error::OutOfMemory), "{what}: call {refuse}");
                assert_eq!(kept, 0, "{what}: call {refuse}");
            }
        }
    }
}

/// Not one call, of any kind of query, nor of opening and of statistics.
#[test]
fn queries_allocate_nothing() {
    for (name, mesh) in soups() {
        let rays: Vec<Ray> = adversarial_rays(&mesh, 9, 4).iter().map(|(_, r)| ray(r)).collect();
        let mut hits = vec![Hit::miss(0.0); rays.len()];
        let mut shadows = vec![false; rays.len()];
        for (kind, options) in configurations() {
            let scene = common::build(&mesh, &options);
            let (_, calls, _) = watch(0, || {
                let view = View::open(scene.view().bytes()).expect("what was built opens");
                let mut counters = Counters::default();
                for r in &rays {
                    let _ = (view.intersect(r), view.occluded(r), view.intersect_brute(r));
                    let _ = view.intersect_counted(r, &mut counters);
                    let _ = view.intersect_within(r, 10);
                }
                view.intersect_n(&rays, &mut hits);
                view.occluded_n(&rays, &mut shadows);
                let _ = (Stats::of(&view), view.most_steps(), view.bounds());
            });
            assert_eq!(calls, 0, "{name} in {kind}");
        }
    }
}
