//! Signed integers wide enough for the deciding polynomials, on the stack.
//!
//! Coordinates are `f32`, so on a common power of two they are integers of at
//! most 277 bits; a difference has 278, a determinant of three rows at most
//! 840, and rounding a quotient takes 26 more: 14 limbs of 64 bits hold anything.
//! The square of a determinant over that of a normal, and rounding its root, take 1730.

use core::cmp::Ordering;

#[derive(Clone, Copy)]
pub struct Int<const LIMBS: usize> {
    negative: bool,
    len: usize,
    limb: [u64; LIMBS],
}

impl<const LIMBS: usize> Int<LIMBS> {
    pub const ZERO: Self = Self { negative: false, len: 0, limb: [0; LIMBS] };

    /// `value * 2^shift`.
    pub fn shifted(value: i64, shift: u32) -> Self {
        let mut n = Self::ZERO;
        n.limb[0] = value.unsigned_abs();
        n.len = usize::from(value != 0);
        n.negative = value < 0;
        n.shl(shift)
    }

    /// -1, 0 or 1.
    pub fn signum(&self) -> i32 {
        match (self.len, self.negative) {
            (0, _) => 0,
            (_, true) => -1,
            (_, false) => 1,
        }
    }

    pub fn neg(mut self) -> Self {
        self.negative = !self.negative && self.len > 0;
        self
    }

    pub fn abs(mut self) -> Self {
        self.negative = false;
        self
    }

    /// Number of bits of the magnitude.
    pub fn bits(&self) -> u32 {
        match self.len {
            0 => 0,
            n => 64 * n as u32 - self.limb[n - 1].leading_zeros(),
        }
    }

    pub fn shl(self, by: u32) -> Self {
        let (limbs, bits) = ((by / 64) as usize, by % 64);
        let mut out = Self { negative: self.negative, ..Self::ZERO };
        for i in 0..self.len {
            let wide = u128::from(self.limb[i]) << bits;
            out.limb[i + limbs] |= wide as u64;
            if wide >> 64 != 0 {
                out.limb[i + limbs + 1] = (wide >> 64) as u64;
            }
        }
        out.trim((self.len + limbs + 1).min(LIMBS))
    }

    /// The 64 leading bits of the magnitude, the first of them 1; not of zero.
    pub fn leading(&self) -> u64 {
        let n = self.len;
        let empty = self.limb[n - 1].leading_zeros();
        let below = if n > 1 { self.limb[n - 2] } else { 0 };
        ((u128::from(self.limb[n - 1]) << 64 | u128::from(below)) << empty >> 64) as u64
    }

    pub fn times(&self, by: u32) -> Self {
        self.mul(&Self::shifted(by.into(), 0))
    }

    pub fn add(&self, other: &Self) -> Self {
        if self.negative == other.negative {
            return self.add_magnitude(other);
        }
        match self.cmp_magnitude(other) {
            Ordering::Less => other.sub_magnitude(self),
            Ordering::Equal => Self::ZERO,
            Ordering::Greater => self.sub_magnitude(other),
        }
    }

    pub fn sub(&self, other: &Self) -> Self {
        self.add(&other.neg())
    }

    pub fn mul(&self, other: &Self) -> Self {
        let mut out = Self::ZERO;
        for i in 0..self.len {
            let mut carry = 0u128;
            for j in 0..other.len {
                let at = u128::from(out.limb[i + j]);
                let sum = u128::from(self.limb[i]) * u128::from(other.limb[j]) + at + carry;
                out.limb[i + j] = sum as u64;
                carry = sum >> 64;
            }
            if carry != 0 {
                out.limb[i + other.len] = carry as u64;
            }
        }
        out.negative = self.negative != other.negative;
        out.trim((self.len + other.len).min(LIMBS))
    }

    pub fn cmp_magnitude(&self, other: &Self) -> Ordering {
        self.len.cmp(&other.len).then_with(|| {
            self.limb[..self.len].iter().rev().cmp(other.limb[..other.len].iter().rev())
        })
    }

    fn add_magnitude(&self, other: &Self) -> Self {
        let mut out = Self { negative: self.negative, ..Self::ZERO };
        let len = self.len.max(other.len);
        let mut carry = false;
        for i in 0..len {
            let (a, c) = self.limb[i].overflowing_add(other.limb[i]);
            let (b, d) = a.overflowing_add(u64::from(carry));
            out.limb[i] = b;
            carry = c || d;
        }
        if carry {
            out.limb[len] = 1;
        }
        out.trim((len + 1).min(LIMBS))
    }

    /// `|self| - |other|` with the sign of `self`, for `|self| > |other|`.
    fn sub_magnitude(&self, other: &Self) -> Self {
        let mut out = Self { negative: self.negative, ..Self::ZERO };
        let mut borrow = false;
        for i in 0..self.len {
            let (a, c) = self.limb[i].overflowing_sub(other.limb[i]);
            let (b, d) = a.overflowing_sub(u64::from(borrow));
            out.limb[i] = b;
            borrow = c || d;
        }
        out.trim(self.len)
    }

    fn trim(mut self, mut len: usize) -> Self {
        while len > 0 && self.limb[len - 1] == 0 {
            len -= 1;
        }
        self.len = len;
        self.negative &= len > 0;
        self
    }
}

#[cfg(test)]
mod tests {
    type Int = super::Int<14>;

    fn int(value: i128) -> Int {
        let high = Int::shifted((value >> 62) as i64, 62);
        high.add(&Int::shifted((value & ((1 << 62) - 1)) as i64, 0))
    }

    fn value(n: &Int) -> i128 {
        let magnitude = i128::from(n.limb[0]) | i128::from(n.limb[1]) << 64;
        assert!(n.len <= 2);
        if n.negative { -magnitude } else { magnitude }
    }

    #[test]
    fn agrees_with_machine_integers() {
        let mut seed = 1u64;
        let mut next = || {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (i128::from(seed as i64)) >> (seed % 61)
        };
        for _ in 0..10_000 {
            let (a, b) = (next(), next());
            assert_eq!(value(&int(a).add(&int(b))), a + b);
            assert_eq!(value(&int(a).sub(&int(b))), a - b);
            assert_eq!(value(&int(a).mul(&int(b))), a * b);
            assert_eq!(int(a).signum(), a.signum() as i32);
            assert_eq!(int(a).bits(), 128 - a.unsigned_abs().leading_zeros());
            assert_eq!(int(a).cmp_magnitude(&int(b)), a.unsigned_abs().cmp(&b.unsigned_abs()));
        }
    }

    #[test]
    fn wide_products_keep_every_bit() {
        let a = Int::shifted(-0x00ff_ffff, 253);
        let cube = a.mul(&a).mul(&a);
        assert_eq!(cube.bits(), 3 * 277);
        assert_eq!(cube.signum(), -1);
        let low = Int::shifted(1, 0);
        assert_eq!(cube.sub(&low).add(&low).sub(&cube).signum(), 0);
        assert_eq!(cube.sub(&low).sub(&cube).neg().cmp_magnitude(&low), core::cmp::Ordering::Equal);
    }
}
