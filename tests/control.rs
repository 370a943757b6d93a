//! Builds on the caller's threads, watched and broken off: the bytes do not depend
//! on how many threads there are, and a build that is cancelled says so.
#![allow(missing_docs)]

mod common;

use common::{build, configurations, soups};
use hug::build::{Control, Task, Threads};
use hug::{Error, Geometry, Options, Scene, Structure};
use hug_kit::{Mesh, scenes, soups as kit};
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicUsize, Ordering};

/// That many threads, with an equal share of the tasks each.
struct Some(usize);

impl Threads for Some {
    fn run(&self, tasks: &mut [Task<'_>]) {
        let share = tasks.len().div_ceil(self.0);
        std::thread::scope(|scope| {
            let run = |tasks: &mut [Task<'_>]| tasks.iter_mut().for_each(Task::run);
            let threads = tasks.chunks_mut(share).map(|tasks| scope.spawn(move || run(tasks)));
            // Joined one by one, which ThreadSanitizer sees; not so the end of a scope.
            let threads: Vec<_> = threads.collect();
            threads.into_iter().for_each(|thread| thread.join().expect("no task panics"));
        });
    }
}

/// This thread, last task first, each one twice.
struct Backwards;

impl Threads for Backwards {
    fn run(&self, tasks: &mut [Task<'_>]) {
        for task in tasks.iter_mut().rev() {
            task.run();
            task.run();
        }
    }
}

/// Leaves out one task, of the batch of this number.
struct Lazy {
    batch: usize,
    seen: AtomicUsize,
}

impl Threads for Lazy {
    fn run(&self, tasks: &mut [Task<'_>]) {
        let lazy = self.seen.fetch_add(1, Ordering::Relaxed) == self.batch;
        tasks.iter_mut().skip(usize::from(lazy)).for_each(Task::run);
    }
}

fn with(mesh: &Mesh, options: &Options, control: &mut Control<'_>) -> Result<Vec<u8>, Error> {
    let soup = [Geometry::from_mesh(&mesh.vertices, &mesh.indices)];
    Scene::build_with(&soup, options, control).map(|scene| scene.view().bytes().to_vec())
}

#[track_caller]
fn assert_same_bytes(mesh: &Mesh, options: &Options, what: &str) {
    let mut alone = Control::default();
    let expected = with(mesh, options, &mut alone);
    assert!(expected.is_ok(), "{what}: {expected:?}");
    let mut teams: Vec<Box<dyn Threads>> = vec![Box::new(Backwards)];
    teams.extend([1, 2, 3, 7].map(|n| Box::new(Some(n)) as Box<dyn Threads>));
    #[cfg(feature = "rayon")]
    teams.push(Box::new(hug::build::Rayon));
    for (i, threads) in teams.iter().enumerate() {
        let mut control = Control::default().with_threads(&**threads);
        assert!(with(mesh, options, &mut control) == expected, "{what}: team {i}");
        assert_eq!(control.work(), alone.work(), "{what}: team {i}");
    }
}

#[test]
fn threads_do_not_change_the_bytes() {
    for (name, mesh) in soups() {
        for (kind, options) in configurations() {
            assert_same_bytes(&mesh, &options, &format!("{name} in {kind}"));
        }
    }
}

/// Large enough for slabs, several batches, and parts with gaps.
#[test]
fn threads_do_not_change_the_bytes_of_large_scenes() {
    let mut mesh = scenes::kitchen().mesh;
    for triangle in mesh.indices.iter_mut().step_by(37) {
        triangle[1] = triangle[0];
    }
    for (kind, options) in configurations() {
        if kind != "r1 deep" {
            assert_same_bytes(&mesh, &options, kind);
        }
    }
}

/// More references than some parts, or all, may have: these are looked at once more.
#[test]
fn threads_do_not_change_the_bytes_of_crowded_scenes() {
    let mut mesh = kit::tangle(3, 5000);
    assert_same_bytes(&mesh, &Options::default(), "large triangles");
    let small = scenes::kitchen().mesh;
    let before = mesh.vertices.len() as u32;
    mesh.indices.truncate(200);
    mesh.vertices.extend(&small.vertices);
    mesh.indices.extend(small.indices.iter().map(|triangle| triangle.map(|i| i + before)));
    for max_refs in [2, 4, 32] {
        let options = Options { max_refs, ..Options::default() };
        assert_same_bytes(&mesh, &options, &format!("some large ones, {max_refs}"));
    }
}

/// Slivers across the scene, which many rows of voxels are looked at for: not too many in any part
/// that a task has, but in all of them together, as the last part is short.
#[test]
fn threads_do_not_change_the_bytes_where_rows_are_many() {
    for slivers in (40..66).step_by(3) {
        let mut next = 1u32;
        let mut random = || {
            next = next.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (next >> 8) as f32 / 16_777_216.0
        };
        let mut mesh = Mesh::default();
        for (count, slivers) in [(2048, slivers), (2048, slivers), (200, 30)] {
            for i in 0..count {
                if i * slivers / count != (i + 1) * slivers / count {
                    let e = 0.01 * random();
                    mesh.push([[0.0, e, 0.0], [1.0, 1.0, 1.0 - e], [1.0, 1.0 - e, 1.0]]);
                } else {
                    let [x, y, z] = [(); 3].map(|()| 0.99 * random());
                    mesh.push([[x, y, z], [x + 0.001, y, z], [x, y + 0.001, z + 0.001]]);
                }
            }
        }
        for structure in [Structure::Uniform, Structure::Recursive] {
            let options =
                Options { structure, world_alpha: Option::Some(4.0), ..Options::default() };
            assert_same_bytes(&mesh, &options, &format!("{slivers} slivers, {structure:?}"));
        }
    }
}

#[test]
fn many_geometries_are_gathered_in_order() {
    let mesh = kit::tangle(1, 600);
    let soup: Vec<Geometry<'_>> =
        mesh.indices.chunks(7).map(|part| Geometry::from_mesh(&mesh.vertices, part)).collect();
    let options = Options::default();
    let expected = Scene::build(&soup, &options).expect("valid");
    let mut control = Control::default().with_threads(&Some(3));
    let scene = Scene::build_with(&soup, &options, &mut control).expect("valid");
    assert!(scene.view().bytes() == expected.view().bytes());
}

#[test]
fn a_task_left_out_is_an_error() {
    let mesh = scenes::kitchen().mesh;
    let mut batch = 0;
    loop {
        let lazy = Lazy { batch, seen: AtomicUsize::new(0) };
        let made = with(&mesh, &Options::default(), &mut Control::default().with_threads(&lazy));
        if lazy.seen.into_inner() <= batch {
            assert!(made.is_ok());
            break;
        }
        assert!(made == Err(Error::Unfinished), "batch {batch}");
        batch += 1;
    }
    assert!(batch > 1);
}

/// All fractions a build reports, and how it ends when the call of number `last`
/// breaks it off.
fn watch(mesh: &Mesh, options: &Options, last: usize) -> (Vec<f64>, Result<Vec<u8>, Error>) {
    let mut seen = vec![];
    let mut progress = |fraction| {
        seen.push(fraction);
        if seen.len() > last { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let made = with(mesh, options, &mut Control::default().with_progress(&mut progress));
    (seen, made)
}

#[test]
fn progress_rises_to_one() {
    for (name, mesh) in soups().into_iter().chain([("kitchen", scenes::kitchen().mesh)]) {
        for (kind, options) in configurations() {
            if name == "kitchen" && kind == "r1 deep" {
                continue;
            }
            let (seen, made) = watch(&mesh, &options, usize::MAX);
            let expected = build(&mesh, &options);
            assert!(made.as_deref() == Ok(expected.view().bytes()), "{name} in {kind}");
            assert!(seen.is_sorted() && seen[0] == 0.0, "{name} in {kind}: {seen:?}");
            assert_eq!(seen.last(), Option::Some(&1.0), "{name} in {kind}");
            if name == "kitchen" {
                assert!(seen.len() > mesh.indices.len() / 4096, "{kind}: {}", seen.len());
            }
        }
    }
}

#[test]
fn every_report_can_cancel() {
    let mesh = kit::tangle(1, 600);
    for (kind, options) in configurations() {
        let (all, _) = watch(&mesh, &options, usize::MAX);
        for last in 0..all.len() {
            let (seen, made) = watch(&mesh, &options, last);
            assert!(made == Err(Error::Cancelled), "{kind}: call {last}");
            assert!(seen == all[..=last], "{kind}: call {last}");
        }
    }
}
