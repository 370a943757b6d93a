//! Triangles and their bounding box.

/// A triangle soup with shared vertices.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    pub vertices: Vec<[f32; 3]>,
    pub indices: Vec<[u32; 3]>,
}

impl Mesh {
    /// The corners of triangle `i`.
    pub fn triangle(&self, i: usize) -> [[f32; 3]; 3] {
        let [a, b, c] = self.indices[i];
        [self.vertices[a as usize], self.vertices[b as usize], self.vertices[c as usize]]
    }

    /// The corners of every triangle, in order.
    pub fn triangles(&self) -> impl ExactSizeIterator<Item = [[f32; 3]; 3]> + '_ {
        (0..self.indices.len()).map(|i| self.triangle(i))
    }

    /// The box of the vertices; `None` for a mesh without finite vertices.
    pub fn bounds(&self) -> Option<Bounds> {
        Bounds::of(self.vertices.iter().copied())
    }

    /// Appends three vertices and the triangle they make.
    pub fn push(&mut self, triangle: [[f32; 3]; 3]) {
        let first = self.vertices.len() as u32;
        self.vertices.extend(triangle);
        self.indices.push([first, first + 1, first + 2]);
    }

    /// FNV-1a over the bytes of vertices and indices, little-endian: what the tests freeze.
    pub fn fingerprint(&self) -> u64 {
        let vertices = self.vertices.iter().flatten().map(|c| c.to_bits());
        let indices = self.indices.iter().flatten().copied();
        fnv1a(vertices.chain(indices))
    }
}

/// FNV-1a, 64 bits, over the little-endian bytes of `words`.
pub fn fnv1a(words: impl Iterator<Item = u32>) -> u64 {
    words.flat_map(u32::to_le_bytes).fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

/// An axis-aligned box.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    pub lo: [f32; 3],
    pub hi: [f32; 3],
}

impl Bounds {
    /// The box of those points that are finite; `None` if there are none.
    pub fn of(points: impl IntoIterator<Item = [f32; 3]>) -> Option<Self> {
        points.into_iter().filter(|p| p.iter().all(|c| c.is_finite())).fold(
            None,
            |bounds: Option<Self>, p| {
                let b = bounds.unwrap_or(Self { lo: p, hi: p });
                Some(Self {
                    lo: [0, 1, 2].map(|k| b.lo[k].min(p[k])),
                    hi: [0, 1, 2].map(|k| b.hi[k].max(p[k])),
                })
            },
        )
    }

    /// The point at the given fractions of the box.
    pub fn at(&self, fraction: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|k| {
            let (lo, hi) = (f64::from(self.lo[k]), f64::from(self.hi[k]));
            lo + (hi - lo) * fraction[k]
        })
    }

    /// The length of the diagonal.
    pub fn diagonal(&self) -> f64 {
        let squares = [0, 1, 2].map(|k| {
            let d = f64::from(self.hi[k]) - f64::from(self.lo[k]);
            d * d
        });
        libm::sqrt(squares[0] + squares[1] + squares[2])
    }
}
