//! What a build may use of the caller's while it runs: threads, and an ear.
//!
//! The library starts no thread. It cuts its longer passes into [`Task`]s with
//! results that lie apart, hands them to the caller's [`Threads`] if there are
//! any, and counts what was done. What a task does depends on the triangles and
//! the options alone, or makes no difference: so do the bytes built.

use core::ops::ControlFlow;

use crate::Error;
use crate::simd::fpenv;

/// Triangles or voxels between two reports.
const STRIDE: usize = 4096;
/// Most tasks handed out at a time.
pub(super) const TASKS: usize = 32;

/// Parts of a pass, as many as are handed out at a time or fewer.
pub(super) type Parts<T> = [Option<T>; TASKS];

/// The next parts, until there are none.
pub(super) fn parts<T>(mut next: impl FnMut() -> Option<T>) -> Parts<T> {
    let mut parts = [const { None }; TASKS];
    for part in &mut parts {
        *part = next();
        if part.is_none() {
            break;
        }
    }
    parts
}

/// One part of a pass.
pub struct Task<'a> {
    work: Option<&'a mut (dyn Work + 'a)>,
    done: bool,
}

impl Task<'_> {
    /// Tasks of nothing. Not inlined, for size.
    #[inline(never)]
    fn none() -> [Self; TASKS] {
        [const { Self { work: None, done: false } }; TASKS]
    }

    /// Does the part, on this thread. Again, it does nothing.
    pub fn run(&mut self) {
        if let Some(work) = self.work.take() {
            fpenv::with_default(|| work.work());
            self.done = true;
        }
    }
}

/// Threads that a build can borrow.
pub trait Threads {
    /// Runs every task, on any threads and in any order, and returns when all are
    /// done. The build fails with [`Error::Unfinished`] if one was left out.
    fn run(&self, tasks: &mut [Task<'_>]);
}

/// Runs the tasks on the threads of the rayon pool it is called in.
#[cfg(feature = "rayon")]
#[derive(Clone, Copy, Debug, Default)]
pub struct Rayon;

#[cfg(feature = "rayon")]
impl Threads for Rayon {
    fn run(&self, tasks: &mut [Task<'_>]) {
        use rayon::prelude::*;
        tasks.par_iter_mut().with_max_len(1).for_each(Task::run);
    }
}

/// Told how far a build is, from 0 to 1 and never falling; may break it off.
type Progress<'a> = &'a mut dyn FnMut(f64) -> ControlFlow<()>;

/// What a build may use of the caller's while it runs. The default is nothing.
#[derive(Default)]
pub struct Control<'a> {
    threads: Option<&'a dyn Threads>,
    progress: Option<Progress<'a>>,
    /// The range of fractions that the pass at hand stands for.
    pass: [f64; 2],
    last: f64,
    /// Work since the last report, and in all.
    work: usize,
    all_work: u64,
}

impl<'a> Control<'a> {
    /// With threads to run parts of the build on. The bytes built are the same.
    #[must_use]
    pub fn with_threads(mut self, threads: &'a dyn Threads) -> Self {
        self.threads = Some(threads);
        self
    }

    /// With a function that is told how far the build is, on the thread that
    /// builds: from 0 to 1 and never falling. A break ends the build with
    /// [`Error::Cancelled`].
    #[must_use]
    pub fn with_progress(mut self, progress: &'a mut dyn FnMut(f64) -> ControlFlow<()>) -> Self {
        self.progress = Some(progress);
        self
    }

    /// What the build has done so far, or had done when it ended, in units that take a
    /// bounded number of operations each: a triangle gathered, a row of voxels that one
    /// was tested in, a reference or voxel written, a triangle of a part that was sorted
    /// (times the logarithm of their number), a candidate for a parent looked at.
    /// docs/promises.md bounds it. It depends on triangles and options alone.
    #[must_use]
    pub fn work(&self) -> u64 {
        self.all_work
    }

    /// Begins a build.
    pub(super) fn begin(&mut self) {
        (self.pass, self.last, self.work, self.all_work) = ([0.0; 2], 0.0, 0, 0);
    }

    /// Counts work that needs no report of its own.
    pub(super) fn count(&mut self, work: usize) {
        self.all_work += work as u64;
    }

    /// Begins a pass that ends where this share of the whole build is done.
    pub(super) fn pass(&mut self, end: f64) -> Result<(), Error> {
        self.pass = [self.pass[1], end];
        self.at(0, 1)
    }

    /// Says how much of the pass is done.
    pub(super) fn at(&mut self, done: usize, of: usize) -> Result<(), Error> {
        let Some(progress) = &mut self.progress else { return Ok(()) };
        let [from, to] = self.pass;
        let share = (done as f64 / of.max(1) as f64).min(1.0);
        self.last = self.last.max(from + share * (to - from)).min(1.0);
        self.work = 0;
        match progress(self.last) {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(()) => Err(Error::Cancelled),
        }
    }

    /// The same, but only now and then: after `work` more triangles or voxels.
    #[inline]
    pub(super) fn tick(&mut self, work: usize, done: usize, of: usize) -> Result<(), Error> {
        self.count(work);
        if self.progress.is_none() {
            return Ok(());
        }
        self.work += work;
        if self.work < STRIDE { Ok(()) } else { self.at(done, of) }
    }

    /// Runs `f`, whose own reports do not move the fraction.
    pub(super) fn within<R>(&mut self, f: impl FnOnce(&mut Self) -> R) -> R {
        let pass = core::mem::replace(&mut self.pass, [self.last; 2]);
        let result = f(self);
        self.pass = pass;
        result
    }

    /// Whether there are threads to share work with.
    pub(super) fn shares(&self) -> bool {
        self.threads.is_some()
    }

    /// Does `work` to each part, on the caller's threads if there are any. Parts are a slice and
    /// this is no part of its callers, or compilers write it out task by task.
    #[inline(never)]
    pub(super) fn each<T: Send>(
        &self,
        parts: &mut [Option<T>],
        work: impl Fn(&mut T) + Sync,
    ) -> Result<(), Error> {
        let mut items = [const { None }; TASKS];
        let mut tasks = Task::none();
        let mut count = 0;
        let parts = parts.iter_mut().flatten();
        for (item, room) in parts.zip(&mut items) {
            tasks[count].work = Some(room.insert(Part { item, work: &work }));
            count += 1;
        }
        self.run(&mut tasks[..count])
    }

    #[inline(never)]
    fn run(&self, tasks: &mut [Task<'_>]) -> Result<(), Error> {
        match self.threads {
            Some(threads) if tasks.len() > 1 => threads.run(tasks),
            _ => tasks.iter_mut().for_each(Task::run),
        }
        if tasks.iter().all(|task| task.done) { Ok(()) } else { Err(Error::Unfinished) }
    }
}

/// What a task does.
trait Work: Send {
    fn work(&mut self);
}

struct Part<'a, T, F> {
    item: &'a mut T,
    work: &'a F,
}

impl<T: Send, F: Fn(&mut T) + Sync> Work for Part<'_, T, F> {
    fn work(&mut self) {
        (self.work)(self.item);
    }
}
