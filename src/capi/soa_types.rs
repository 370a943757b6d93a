//! The C records of many rays and hits, with an array for each component.
#![allow(non_camel_case_types)]

/// Rays with an array for each component. Set struct_size; arrays of org and dir are
/// required, others may be NULL, which stands for the value named.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct hug_ray_soa {
    /// sizeof(hug_ray_soa).
    pub struct_size: usize,
    /// Origins: x, y, z.
    pub org: [*const f32; 3],
    /// Directions: x, y, z.
    pub dir: [*const f32; 3],
    /// Smallest t of a hit, inclusive; 0.
    pub tmin: *const f32,
    /// Largest t of a hit, inclusive; infinity.
    pub tmax: *const f32,
    /// Masks; all ones.
    pub mask: *const u32,
    /// The triangle to pass through; HUG_NONE.
    pub skip_geom: *const u32,
    /// The triangle to pass through; HUG_NONE.
    pub skip_prim: *const u32,
    /// HUG_RAY_* flags; 0.
    pub flags: *const u32,
}

/// Hits with an array for each component, as in hug_hit. Set struct_size; what has
/// NULL for an array is not written.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct hug_hit_soa {
    /// sizeof(hug_hit_soa).
    pub struct_size: usize,
    /// Ray parameters; the ray's tmax for a miss.
    pub t: *mut f32,
    /// Barycentric weights of the second corner.
    pub u: *mut f32,
    /// Barycentric weights of the third corner.
    pub v: *mut f32,
    /// Normals, not normalised: x, y, z.
    pub ng: [*mut f32; 3],
    /// Geometries; HUG_NONE for a miss.
    pub geom: *mut u32,
    /// Triangles of the geometries.
    pub prim: *mut u32,
    /// Always HUG_NONE.
    pub inst: *mut u32,
}
