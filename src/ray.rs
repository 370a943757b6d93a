//! Rays and hits: the frozen, 4-byte aligned records shared by Rust and C.

use bytemuck::{Pod, Zeroable};

/// The id that names nothing: no geometry, no primitive, no instance.
pub const NONE: u32 = u32::MAX;

/// A ray `org + t * dir` with `tmin <= t <= tmax`. 48 bytes, aligned to 4.
///
/// The direction need not be normalised; `t` is in units of its length.
/// `tmin` and `tmax` may be infinite, and negative. A ray with a NaN anywhere,
/// a non-finite origin or direction, a zero direction or `tmin > tmax` misses.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Ray {
    /// Origin, in the units of the scene.
    pub org: [f32; 3],
    /// Smallest `t` of a hit, inclusive.
    pub tmin: f32,
    /// Direction, of any non-zero length.
    pub dir: [f32; 3],
    /// Largest `t` of a hit, inclusive.
    pub tmax: f32,
    /// A geometry is met only if this and its own mask share a bit.
    pub mask: u32,
    /// [`Ray::CULL_BACK`], [`Ray::CULL_FRONT`], both or neither. Other bits are reserved
    /// and must be 0; they change nothing.
    pub flags: u32,
    /// Geometry id of the one triangle to pass through, or [`NONE`].
    pub skip_geom: u32,
    /// Primitive id of the one triangle to pass through, or [`NONE`].
    pub skip_prim: u32,
}

impl Ray {
    /// Flag: passes through triangles that it meets from behind. The front of a triangle
    /// is where its normal points, [`Hit::ng`], and its corners go round counterclockwise;
    /// a ray comes from there if the exact `dir . ng` is negative. It is never 0 for a
    /// triangle that is hit.
    pub const CULL_BACK: u32 = 1;
    /// Flag: passes through triangles that it meets from the front.
    pub const CULL_FRONT: u32 = 2;

    /// A ray that meets everything in front of its origin.
    #[must_use]
    pub const fn new(org: [f32; 3], dir: [f32; 3]) -> Self {
        Self {
            org,
            tmin: 0.0,
            dir,
            tmax: f32::INFINITY,
            mask: u32::MAX,
            flags: 0,
            skip_geom: NONE,
            skip_prim: NONE,
        }
    }

    /// The same ray with these flags, [`Ray::CULL_BACK`] for one.
    #[must_use]
    pub const fn with_flags(mut self, flags: u32) -> Self {
        self.flags = flags;
        self
    }

    /// The record in rows of four: origin and `tmin`, direction and `tmax`, the rest.
    pub(crate) fn rows(&self) -> &[[f32; 4]; 3] {
        bytemuck::cast_ref(self)
    }

    /// The same ray limited to `tmin <= t <= tmax`.
    #[must_use]
    pub const fn with_range(mut self, tmin: f32, tmax: f32) -> Self {
        self.tmin = tmin;
        self.tmax = tmax;
        self
    }
}

/// Whether a ray's flags leave out triangles that it comes to from this side.
#[inline(always)]
pub(crate) const fn culls(flags: u32, front: bool) -> bool {
    flags & (if front { Ray::CULL_FRONT } else { Ray::CULL_BACK }) != 0
}

/// What a closest-hit query found. 40 bytes, aligned to 4.
///
/// The point is `(1 - u - v) * v0 + u * v1 + v * v2`. A miss has
/// `geom == prim == inst == NONE`, `t` equal to the ray's `tmax`, and zeros
/// elsewhere.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Hit {
    /// The exact ray parameter of the hit, rounded once to `f32`.
    pub t: f32,
    /// Barycentric weight of `v1`, exact but for one rounding.
    pub u: f32,
    /// Barycentric weight of `v2`, exact but for one rounding.
    pub v: f32,
    /// `(v1 - v0) x (v2 - v0)`, not normalised; evaluated in `f64`, then rounded
    /// (so it can overflow to infinity where edges are longer than about 1e19).
    pub ng: [f32; 3],
    /// Index of the geometry in the build's list.
    pub geom: u32,
    /// Index of the triangle in its geometry.
    pub prim: u32,
    /// Reserved for instances; always [`NONE`].
    pub inst: u32,
    /// Always 0.
    pub reserved: u32,
}

impl Hit {
    /// The record of a miss along a ray that ends at `tmax`.
    #[must_use]
    pub const fn miss(tmax: f32) -> Self {
        Self {
            t: tmax,
            u: 0.0,
            v: 0.0,
            ng: [0.0; 3],
            geom: NONE,
            prim: NONE,
            inst: NONE,
            reserved: 0,
        }
    }

    /// Whether a triangle was met.
    #[must_use]
    pub const fn is_hit(&self) -> bool {
        self.geom != NONE
    }
}

/// The first 32 bytes of a [`Hit`], of which the others are always the same, in rows of four. They
/// are stored by sixteen, as they will be copied by sixteen: of bytes that narrower stores have just
/// written, a wide load has to wait until they are in the cache.
#[derive(Clone, Copy)]
pub(crate) struct HitRows {
    /// t, u, v and the normal's x.
    first: glam::Vec4,
    /// The normal's y and z, geometry and primitive.
    second: glam::Vec4,
}

impl HitRows {
    #[inline(always)]
    pub fn new([t, u, v]: [f32; 3], [x, y, z]: [f32; 3], [geom, prim]: [u32; 2]) -> Self {
        Self {
            first: glam::Vec4::new(t, u, v, x),
            second: glam::Vec4::new(y, z, f32::from_bits(geom), f32::from_bits(prim)),
        }
    }

    /// That of [`Hit::miss`].
    #[inline(always)]
    pub fn miss(tmax: f32) -> Self {
        Self::new([tmax, 0.0, 0.0], [0.0; 3], [NONE; 2])
    }

    #[inline(always)]
    pub fn t(&self) -> f32 {
        self.first.x
    }

    /// Geometry and primitive.
    #[inline(always)]
    pub fn ids(&self) -> (u32, u32) {
        (self.second.z.to_bits(), self.second.w.to_bits())
    }

    #[inline(always)]
    pub fn set_weights(&mut self, (u, v): (f32, f32)) {
        (self.first.y, self.first.z) = (u, v);
    }

    #[inline(always)]
    pub fn set_normal(&mut self, [x, y, z]: [f32; 3]) {
        (self.first.w, self.second.x, self.second.y) = (x, y, z);
    }

    #[inline(always)]
    pub fn hit(&self) -> Hit {
        let rows = [self.first.to_array(), self.second.to_array()];
        let mut words = [0; 10];
        words[..8].copy_from_slice(bytemuck::cast_slice(&rows));
        words[8] = NONE;
        bytemuck::cast::<[u32; 10], Hit>(words)
    }
}

const _: () = assert!(size_of::<Ray>() == 48 && align_of::<Ray>() == 4);
const _: () = assert!(size_of::<Hit>() == 40 && align_of::<Hit>() == 4);
