//! Bytes read as whatever is wanted next; zeros once they are used up.

/// What is left of an input.
pub struct Input<'a>(&'a [u8]);

/// Numbers at which arithmetic does something of its own.
const SPECIAL: [f32; 16] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    f32::MIN_POSITIVE,
    1e-45,
    -1e-39,
    1e-30,
    -1e30,
    f32::MAX,
    f32::MIN,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::NAN,
    1.0 + f32::EPSILON,
    16_777_216.0,
];

impl<'a> Input<'a> {
    pub fn new(bytes: &'a [u8]) -> Self {
        Self(bytes)
    }

    /// All that is left.
    pub fn rest(&mut self) -> &'a [u8] {
        std::mem::take(&mut self.0)
    }

    pub fn byte(&mut self) -> u8 {
        let Some((first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        *first
    }

    pub fn bits(&mut self) -> u32 {
        u32::from_le_bytes([(); 4].map(|()| self.byte()))
    }

    /// Of any size.
    pub fn long(&mut self) -> u64 {
        let bits = u64::from(self.bits()) << 32 | u64::from(self.bits());
        bits >> (self.byte() & 63)
    }

    /// Below `n`, which is at most 65536 and not 0.
    pub fn below(&mut self, n: usize) -> usize {
        let wide = if n > 256 { self.byte() } else { 0 };
        usize::from(u16::from_be_bytes([wide, self.byte()])) % n
    }

    /// One time in `n`.
    pub fn rarely(&mut self, n: usize) -> bool {
        self.below(n) == n - 1
    }

    /// One of these.
    pub fn one_of<T: Copy>(&mut self, values: &[T]) -> T {
        values[self.below(values.len())]
    }

    /// Mostly small integers and fractions, that meet each other exactly.
    pub fn float(&mut self) -> f32 {
        let kind = self.byte();
        match kind {
            0..128 => f32::from(kind as i8 - 64) / 8.0,
            128..192 => f32::from(kind as i8),
            192..224 => SPECIAL[usize::from(kind) % SPECIAL.len()],
            224..232 => f32::from_bits(self.bits() & 0x80ff_ffff | 0x3f00_0000),
            232..240 => f32::from(kind as i8) * 2f32.powi(i32::from(self.byte()) - 128),
            _ => f32::from_bits(self.bits()),
        }
    }

    pub fn point(&mut self) -> [f32; 3] {
        [(); 3].map(|()| self.float())
    }
}
