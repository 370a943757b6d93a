//! The descriptor's callbacks as what a Rust build takes.

use core::ffi::c_void;
use core::ops::ControlFlow;
use core::sync::atomic::{AtomicU32, Ordering};

use super::guard::caught;
use super::types::{hug_build_desc, hug_progress_fn};
use crate::build::{Control, Task, Threads};

/// `parallel_for` and `progress` of a descriptor.
pub struct Callbacks<'a>(&'a hug_build_desc);

impl<'a> Callbacks<'a> {
    pub fn new(desc: &'a hug_build_desc) -> Self {
        Self(desc)
    }

    /// Runs `f` with what there is of them.
    pub fn run<R>(&self, f: impl FnOnce(&mut Control<'_>) -> R) -> R {
        let mut progress = progress(self.0.progress, self.0.progress_user);
        let mut control = Control::default();
        if self.0.parallel_for.is_some() {
            control = control.with_threads(self);
        }
        if self.0.progress.is_some() {
            control = control.with_progress(&mut progress);
        }
        f(&mut control)
    }
}

fn progress(told: hug_progress_fn, user: *mut c_void) -> impl FnMut(f64) -> ControlFlow<()> {
    move |fraction| match told {
        // SAFETY: the caller's function, called as documented.
        Some(told) if unsafe { told(user, fraction) } != 0 => ControlFlow::Break(()),
        _ => ControlFlow::Continue(()),
    }
}

/// What the context of a task points to.
struct Batch<'a> {
    tasks: *mut Task<'a>,
    count: usize,
    /// Bit i: task i was called, so that nothing but that call may touch it.
    called: AtomicU32,
}

impl Threads for Callbacks<'_> {
    fn run(&self, tasks: &mut [Task<'_>]) {
        let Some(parallel_for) = self.0.parallel_for else { return };
        let count = tasks.len();
        let batch = Batch { tasks: tasks.as_mut_ptr(), count, called: AtomicU32::new(0) };
        let context = (&raw const batch).cast_mut().cast();
        // SAFETY: the caller's function, called as documented: `batch` outlives the
        // call, and with it, by contract, every call of `task`.
        unsafe { parallel_for(self.0.parallel_user, count, Some(task), context) };
    }
}

/// # Safety
/// `context` is a batch whose `parallel_for` has not returned.
unsafe extern "C" fn task(context: *mut c_void, index: usize) {
    // SAFETY: by the caller; a batch is only read through shared references.
    let batch = unsafe { &*context.cast::<Batch<'_>>() };
    if index >= batch.count.min(u32::BITS as usize) {
        return;
    }
    let bit = 1 << index;
    if batch.called.fetch_or(bit, Ordering::Relaxed) & bit == 0 {
        // SAFETY: in the range of the tasks, and no other call gets the same one.
        let task = unsafe { &mut *batch.tasks.add(index) };
        // A task that panics stays undone, which the build notices.
        let _ = caught(|| task.run());
    }
}
