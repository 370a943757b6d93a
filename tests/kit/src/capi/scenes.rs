//! Scenes, views and boxes for C.

use super::{Error, input, output, status, value};
use crate::scenes::{NAMES, generate};
use crate::{Bounds, Mesh, View};
use core::ffi::{CStr, c_char};
use std::ffi::CString;

/// What `kit_scene` points at: views' names as C strings beside the mesh.
pub struct KitScene {
    mesh: Mesh,
    views: Vec<(CString, View)>,
}

/// The names of [`NAMES`], in the same order.
const C_NAMES: [&CStr; NAMES.len()] =
    [c"kitchen", c"building_walls", c"building", c"city", c"garden"];

#[unsafe(no_mangle)]
pub extern "C" fn kit_scene_count() -> usize {
    C_NAMES.len()
}

#[unsafe(no_mangle)]
pub extern "C" fn kit_scene_name(index: usize) -> *const c_char {
    C_NAMES.get(index).map_or(core::ptr::null(), |name| name.as_ptr())
}

/// # Safety
/// `name` is NULL or a C string, `out` is NULL or valid for a write.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kit_scene_generate(name: *const c_char, out: *mut *mut KitScene) -> i32 {
    status(|| {
        if name.is_null() || out.is_null() {
            return Err(Error::Null);
        }
        // SAFETY: not NULL, and a C string by the caller's promise.
        let name = unsafe { CStr::from_ptr(name) };
        let scene = name.to_str().ok().and_then(generate).ok_or(Error::Name)?;
        let views = scene
            .views
            .into_iter()
            .map(|v| (CString::new(v.name).expect("no NUL in names"), v.view))
            .collect();
        let mesh = scene.mesh;
        // SAFETY: `out` is valid for a write by the caller's promise.
        unsafe { output(out, Box::into_raw(Box::new(KitScene { mesh, views }))) }
    })
}

/// # Safety
/// `scene` is NULL or comes from `kit_scene_generate` and was not freed before.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kit_scene_free(scene: *mut KitScene) {
    if !scene.is_null() {
        // SAFETY: a box that `kit_scene_generate` gave away, by the caller's promise.
        drop(unsafe { Box::from_raw(scene) });
    }
}

/// # Safety
/// `scene` is NULL or a living scene, `vertex_count` NULL or valid for a write.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kit_scene_vertices(
    scene: *const KitScene,
    vertex_count: *mut usize,
) -> *const f32 {
    value(core::ptr::null(), || {
        // SAFETY: both by the caller's promise.
        unsafe {
            let vertices = &input(scene).ok()?.mesh.vertices;
            output(vertex_count, vertices.len()).ok()?;
            Some(vertices.as_ptr().cast())
        }
    })
}

/// # Safety
/// `scene` is NULL or a living scene, `triangle_count` NULL or valid for a write.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kit_scene_indices(
    scene: *const KitScene,
    triangle_count: *mut usize,
) -> *const u32 {
    value(core::ptr::null(), || {
        // SAFETY: both by the caller's promise.
        unsafe {
            let indices = &input(scene).ok()?.mesh.indices;
            output(triangle_count, indices.len()).ok()?;
            Some(indices.as_ptr().cast())
        }
    })
}

/// # Safety
/// `scene` is NULL or a living scene, `out` NULL or valid for a write.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kit_scene_bounds(scene: *const KitScene, out: *mut Bounds) -> i32 {
    // SAFETY: both by the caller's promise.
    status(|| unsafe {
        let bounds = input(scene)?.mesh.bounds().ok_or(Error::Range)?;
        output(out, bounds)
    })
}

/// # Safety
/// `scene` is NULL or a living scene.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kit_scene_view_count(scene: *const KitScene) -> usize {
    // SAFETY: the caller's promise.
    value(0, || Some(unsafe { input(scene) }.ok()?.views.len()))
}

/// # Safety
/// `scene` is NULL or a living scene, `name` and `out` each NULL or valid for a write.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kit_scene_view(
    scene: *const KitScene,
    index: usize,
    name: *mut *const c_char,
    out: *mut View,
) -> i32 {
    // SAFETY: all by the caller's promise.
    status(|| unsafe {
        let (called, view) = input(scene)?.views.get(index).ok_or(Error::Range)?;
        output(out, *view)?;
        if !name.is_null() {
            output(name, called.as_ptr())?;
        }
        Ok(())
    })
}

/// # Safety
/// `bounds` is NULL or valid for a read, `out` NULL or valid for a write.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kit_view_derived(bounds: *const Bounds, out: *mut View) -> i32 {
    // SAFETY: both by the caller's promise.
    status(|| unsafe { output(out, View::derived(input(bounds)?)) })
}

/// # Safety
/// `vertices` is NULL or has three readable floats at each multiple of `stride` below
/// `vertex_count`, `out` is NULL or valid for a write.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kit_bounds(
    vertices: *const f32,
    stride: usize,
    vertex_count: usize,
    out: *mut Bounds,
) -> i32 {
    status(|| {
        if vertices.is_null() {
            return Err(Error::Null);
        }
        let bytes = stride.checked_mul(vertex_count);
        if stride < 12 || !stride.is_multiple_of(4) || bytes.is_none_or(|n| n > isize::MAX as usize)
        {
            return Err(Error::Range);
        }
        // SAFETY: within the array the caller promised, which is no longer than an object can be.
        let vertex = |i: usize| unsafe { vertices.add(i * (stride / 4)).cast::<[f32; 3]>().read() };
        let bounds = Bounds::of((0..vertex_count).map(vertex)).ok_or(Error::Range)?;
        // SAFETY: `out` is valid for a write by the caller's promise.
        unsafe { output(out, bounds) }
    })
}
