//! An arena in a file, mapped: the same scene, of which a trusted one brings only what
//! rays touch into memory.
#![allow(missing_docs)]
#![cfg(all(target_os = "linux", target_pointer_width = "64"))]

mod common;

use common::{assert_same, build};
use hug::{Options, Ray, View};
use hug_kit::scenes;
use std::ffi::c_void;
use std::fs::{self, File};
use std::os::fd::AsRawFd;
use std::path::Path;

unsafe extern "C" {
    fn mmap(at: *mut c_void, len: usize, prot: i32, flags: i32, fd: i32, from: i64) -> *mut c_void;
    fn munmap(at: *mut c_void, len: usize) -> i32;
}

const PROT_READ: i32 = 1;
const MAP_PRIVATE: i32 = 2;

/// A file in memory.
struct Mapping {
    start: *mut c_void,
    len: usize,
}

impl Mapping {
    fn new(path: &Path) -> Self {
        let file = File::open(path).expect("a file");
        let len = file.metadata().expect("its size").len() as usize;
        // SAFETY: a new mapping, of a file that nothing changes.
        let start =
            unsafe { mmap(std::ptr::null_mut(), len, PROT_READ, MAP_PRIVATE, file.as_raw_fd(), 0) };
        assert_ne!(start as isize, -1, "mmap");
        Self { start, len }
    }

    fn bytes(&self) -> &[u8] {
        // SAFETY: mapped as long as this lives.
        unsafe { std::slice::from_raw_parts(self.start.cast(), self.len) }
    }

    /// Bytes that this process has touched, with what the system maps around them.
    fn resident(&self) -> usize {
        let maps = fs::read_to_string("/proc/self/smaps").expect("Linux has it");
        let start = format!("{:x}-", self.start as usize);
        let ours = maps.lines().skip_while(|line| !line.starts_with(&start));
        let size = ours.into_iter().find_map(|line| line.strip_prefix("Rss:"));
        let size = size.and_then(|rest| rest.trim().strip_suffix(" kB")).expect("a size");
        size.trim().parse::<usize>().expect("a number") << 10
    }
}

impl Drop for Mapping {
    fn drop(&mut self) {
        // SAFETY: mapped by `new`, used no more.
        unsafe { munmap(self.start, self.len) };
    }
}

#[test]
fn a_trusted_mapping_is_read_where_rays_go() {
    // Large: for each place that is touched the system may map some megabytes around it.
    let mesh = scenes::generate("clustered:300000").expect("a scene").mesh;
    let scene = build(&mesh, &Options::default());
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("mapped.hug");
    fs::write(&path, scene.view().bytes()).expect("a file");
    let ray = Ray::new(mesh.vertices[0], [-1.0, -0.5, -0.25]);
    let expected = scene.view().intersect(&ray);

    let mapping = Mapping::new(&path);
    // SAFETY: the bytes are what was built.
    let trusted = unsafe { View::open_trusted(mapping.bytes()) };
    assert_same(&trusted.intersect(&ray), &expected, &ray, &"trusted");
    let (some, whole) = (mapping.resident(), mapping.len);
    assert!(some < whole / 2, "{some} of {whole} bytes for one ray");

    let checked = View::open(mapping.bytes()).expect("what was built opens");
    assert_same(&checked.intersect(&ray), &expected, &ray, &"checked");
    assert!(mapping.resident() >= whole / 10 * 9, "a check reads everything");
    drop(mapping);
    fs::remove_file(&path).expect("the file is there");
}
