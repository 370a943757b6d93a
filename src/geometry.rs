//! The triangle soup: borrowed, strided views of the caller's vertices.
//!
//! Nothing is copied here and nothing outlives the build. A view never reads
//! past its last vertex's third coordinate, however large the stride (Embree
//! reads 16 bytes at the last vertex; we do not).

use crate::Error;

/// Largest number of triangles in a scene, over all geometries.
pub const MAX_TRIANGLES: usize = (1 << 30) - 1;

/// Three vertex indices a triangle, or none: vertices in order.
#[derive(Clone, Copy, Debug)]
pub enum Indices<'a> {
    /// Triangle `i` is vertices `3 i`, `3 i + 1`, `3 i + 2`.
    None,
    /// Packed 16-bit indices, three a triangle.
    U16(&'a [u16]),
    /// Packed 32-bit indices, three a triangle.
    U32(&'a [u32]),
}

/// One geometry of a scene. Its id is its place in the list given to the build.
#[derive(Clone, Copy, Debug)]
pub struct Geometry<'a> {
    coords: &'a [f32],
    stride: usize,
    vertices: usize,
    indices: Indices<'a>,
    mask: u32,
}

impl<'a> Geometry<'a> {
    /// Vertices at every `stride` floats of `coords` (3 when packed), the last
    /// of which may end right after its `z`.
    ///
    /// # Errors
    /// [`Error::Alignment`] if `stride < 3`; [`Error::InvalidValue`] if the
    /// number of indices (or, without indices, of vertices) is not a multiple
    /// of three.
    pub fn new(coords: &'a [f32], stride: usize, indices: Indices<'a>) -> Result<Self, Error> {
        if stride < 3 {
            return Err(Error::Alignment);
        }
        let whole = coords.len() / stride;
        let vertices = whole + usize::from(coords.len() - whole * stride >= 3);
        let corners = match indices {
            Indices::None => vertices,
            Indices::U16(i) => i.len(),
            Indices::U32(i) => i.len(),
        };
        if !corners.is_multiple_of(3) {
            return Err(Error::InvalidValue);
        }
        Ok(Self { coords, stride, vertices, indices, mask: u32::MAX })
    }

    /// Packed vertices and 32-bit index triples, as meshes usually have them.
    #[must_use]
    pub fn from_mesh(vertices: &'a [[f32; 3]], indices: &'a [[u32; 3]]) -> Self {
        Self {
            coords: vertices.as_flattened(),
            stride: 3,
            vertices: vertices.len(),
            indices: Indices::U32(indices.as_flattened()),
            mask: u32::MAX,
        }
    }

    /// The same geometry, met only by rays whose mask shares a bit with `mask`.
    #[must_use]
    pub const fn with_mask(mut self, mask: u32) -> Self {
        self.mask = mask;
        self
    }

    /// The mask that rays are matched with; all ones by default.
    #[must_use]
    pub const fn mask(&self) -> u32 {
        self.mask
    }

    /// Number of triangles, degenerate ones included.
    #[must_use]
    pub const fn triangle_count(&self) -> usize {
        match self.indices {
            Indices::None => self.vertices / 3,
            Indices::U16(i) => i.len() / 3,
            Indices::U32(i) => i.len() / 3,
        }
    }

    /// The first triangle with an index that names no vertex: for a message, after
    /// a build ended in [`Error::IndexRange`].
    ///
    /// ```
    /// let vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    /// let mesh = hug::Geometry::from_mesh(&vertices, &[[0, 1, 2], [0, 1, 3]]);
    /// assert_eq!(hug::Scene::build(&[mesh], &Default::default()).err(), Some(hug::Error::IndexRange));
    /// assert_eq!(mesh.first_bad_index(), Some(1));
    /// ```
    #[must_use]
    pub fn first_bad_index(&self) -> Option<usize> {
        (0..self.triangle_count()).find(|&prim| self.triangle(prim).is_err())
    }

    /// The corners of triangle `prim`.
    #[inline(always)]
    pub(crate) fn triangle(&self, prim: usize) -> Result<[[f32; 3]; 3], Error> {
        let at = prim * 3;
        let vertices = match self.indices {
            Indices::None => [at, at + 1, at + 2],
            Indices::U16(i) => [0, 1, 2].map(|k| usize::from(i[at..at + 3][k])),
            Indices::U32(i) => [0, 1, 2].map(|k| i[at..at + 3][k] as usize),
        };
        let [i, j, k] = vertices;
        if i.max(j).max(k) >= self.vertices {
            return Err(Error::IndexRange);
        }
        Ok(vertices.map(|vertex| {
            let c = &self.coords[vertex * self.stride..][..3];
            [c[0], c[1], c[2]]
        }))
    }
}

/// Number of triangles in `soup`, within [`MAX_TRIANGLES`] and the id range.
pub(crate) fn count(soup: &[Geometry<'_>]) -> Result<usize, Error> {
    let mut n = 0usize;
    for geometry in soup {
        n = n.checked_add(geometry.triangle_count()).ok_or(Error::Limit)?;
    }
    if n > MAX_TRIANGLES || soup.len() > MAX_TRIANGLES {
        return Err(Error::Limit);
    }
    Ok(n)
}
