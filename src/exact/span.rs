//! Floats as integers on a common power of two.

/// The range of exponents of the bits of some numbers: in units of the lowest
/// bit's they are integers of `width` bits.
#[derive(Clone, Copy)]
pub struct Span {
    /// Exponent field of the least number but zero, as of a normal number.
    field: u32,
    pub width: u32,
}

const SIGN: u32 = 1 << 31;

/// The exponent field; denormal numbers have that of the least normal ones.
fn field(bits: u32) -> u32 {
    (bits >> 23 & 0xff).max(1)
}

impl Span {
    #[inline(always)]
    pub fn of(values: &[f32]) -> Self {
        let (mut least, mut most) = (u32::MAX, 0);
        for x in values {
            let size = x.to_bits() & !SIGN;
            // One less, so that zero is not the least.
            least = least.min(size.wrapping_sub(1));
            most = most.max(size);
        }
        if most == 0 {
            return Self { field: 1, width: 0 };
        }
        let low = field(least + 1);
        Self { field: low, width: field(most) - low + 24 }
    }

    /// The exponent of the unit.
    pub fn exponent(&self) -> i32 {
        self.field as i32 - 150
    }

    /// The 24 bits of a number of the span with their sign, and their place.
    pub fn split(&self, x: f32) -> (i64, u32) {
        let bits = x.to_bits();
        let implicit = u32::from(bits & 0x7f80_0000 != 0) << 23;
        let size = i64::from(bits & 0x007f_ffff | implicit);
        // Zero may lie below the span; wherever it is put it is zero.
        let place = field(bits).wrapping_sub(self.field);
        (if bits & SIGN == 0 { size } else { -size }, place)
    }

    /// A number of a span of at most 63 bits.
    #[inline(always)]
    pub fn integer(&self, x: f32) -> i64 {
        let (m, place) = self.split(x);
        m.wrapping_shl(place)
    }
}
