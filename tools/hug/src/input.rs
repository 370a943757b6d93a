//! Where scenes come from: files of triangles, built-in ones, and files of built scenes.

use crate::args::How;
use crate::file::Saved;
use crate::progress;
use hug::build::{Control, Task, Threads};
use hug::{Error, Options, Scene, View};
use hug_bench::clock;
use hug_bench::load::Loaded;
use hug_kit::Bounds;
use std::ops::ControlFlow;
use std::path::Path;

/// A scene ready to be asked, and the triangles if it was built of any here.
pub enum Input {
    Built { loaded: Loaded, scene: Scene, seconds: f64 },
    Saved(Saved),
}

impl Input {
    pub fn new(name: &str, how: &How, quiet: bool) -> Result<Self, String> {
        let path = Path::new(name);
        if path.is_file()
            && let Some(saved) = Saved::read(path)?
        {
            saved.open().map_err(|error| format!("{name}: {error}"))?;
            return Ok(Self::Saved(saved));
        }
        let loaded = load(name, quiet)?;
        let (scene, seconds) = build(&loaded, &how.options(), how.threads, quiet)?;
        Ok(Self::Built { loaded, scene, seconds })
    }

    pub fn view(&self) -> Result<View<'_>, String> {
        match self {
            Self::Built { scene, .. } => Ok(scene.view()),
            Self::Saved(saved) => saved.open().map_err(|error| error.to_string()),
        }
    }

    /// A camera by name; without one the first, or one from inside the box.
    pub fn camera(&self, name: Option<&str>) -> Result<hug_kit::View, String> {
        match self {
            Self::Built { loaded, .. } => loaded.view(name),
            Self::Saved(_) if name.is_some() => {
                Err("--view: a built scene's file names no views; use --camera".to_owned())
            }
            Self::Saved(_) => {
                let (lo, hi) = self.view()?.bounds();
                Ok(hug_kit::View::derived(&Bounds { lo, hi }))
            }
        }
    }
}

/// The triangles.
pub fn load(name: &str, quiet: bool) -> Result<Loaded, String> {
    let bar = progress::spinner(&format!("reading {name}"), quiet);
    let loaded = Loaded::new(name);
    bar.finish_and_clear();
    loaded
}

/// Builds and says how many seconds of CPU time that took.
pub fn build(
    loaded: &Loaded,
    options: &Options,
    threads: u32,
    quiet: bool,
) -> Result<(Scene, f64), String> {
    let bar = progress::bar(&format!("building {}", loaded.name), 1000, quiet);
    let mut at = |fraction: f64| {
        bar.set_position((1000.0 * fraction) as u64);
        ControlFlow::Continue(())
    };
    let team = Team(threads as usize);
    let mut control = Control::default().with_progress(&mut at);
    if threads > 1 {
        control = control.with_threads(&team);
    }
    let mut built = None;
    let soup = loaded.soup();
    let seconds = clock::seconds(clock::process, || {
        built = Some(Scene::build_with(&soup, options, &mut control));
    });
    bar.finish_and_clear();
    match built {
        Some(Ok(scene)) => Ok((scene, seconds)),
        Some(Err(Error::IndexRange)) => {
            let triangle = soup[0].first_bad_index().unwrap_or_default();
            Err(format!("{}: triangle {triangle}: {}", loaded.name, Error::IndexRange))
        }
        Some(Err(error)) => Err(format!("{}: {error}", loaded.name)),
        None => Err(format!("{}: not built", loaded.name)),
    }
}

/// So many threads, for the length of a pass.
struct Team(usize);

impl Threads for Team {
    fn run(&self, tasks: &mut [Task<'_>]) {
        let share = tasks.len().div_ceil(self.0).max(1);
        std::thread::scope(|scope| {
            for tasks in tasks.chunks_mut(share) {
                scope.spawn(|| tasks.iter_mut().for_each(Task::run));
            }
        });
    }
}
