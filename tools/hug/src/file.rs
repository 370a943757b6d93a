//! Built scenes as files: the arena's bytes, read to where a scene may lie.

use bytemuck::{Pod, Zeroable};
use hug::{Error, View};
use std::fs::File;
use std::io::{Read, Write};
use std::path::Path;

/// The unit that an arena is aligned to.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C, align(64))]
struct Line([u8; 64]);

/// The bytes of a file, aligned.
pub struct Saved {
    lines: Vec<Line>,
    length: usize,
}

impl Saved {
    /// Reads the whole file if it begins as an arena does, else nothing of it.
    pub fn read(path: &Path) -> Result<Option<Self>, String> {
        let failed = |error: std::io::Error| format!("{}: {error}", path.display());
        let mut file = File::open(path).map_err(failed)?;
        let length = file.metadata().map_err(failed)?.len();
        let length =
            usize::try_from(length).map_err(|_| format!("{}: too large", path.display()))?;
        let mut lines = vec![Line::zeroed()];
        file.read_exact(&mut lines[0].0[..length.min(64)]).map_err(failed)?;
        if View::open(bytemuck::cast_slice(&lines)).is_err_and(|error| error == Error::Magic) {
            return Ok(None);
        }
        lines.resize(length.div_ceil(64), Line::zeroed());
        let bytes = &mut bytemuck::cast_slice_mut::<Line, u8>(&mut lines)[..length];
        file.read_exact(&mut bytes[length.min(64)..]).map_err(failed)?;
        Ok(Some(Self { lines, length }))
    }

    /// The scene, checked.
    pub fn open(&self) -> Result<View<'_>, Error> {
        View::open(&bytemuck::cast_slice::<Line, u8>(&self.lines)[..self.length])
    }
}

/// Saves a scene.
pub fn write(view: &View<'_>, path: &Path) -> Result<(), String> {
    let mut file = File::create(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let written = file.write_all(view.bytes()).and_then(|()| file.sync_all());
    written.map_err(|error| format!("{}: {error}", path.display()))
}
