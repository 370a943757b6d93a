//! Integers of 256 bits.

use core::cmp::Ordering;

use super::round;

/// In two's complement: `hi * 2^128 + lo`.
#[derive(Clone, Copy)]
pub struct Quad {
    lo: u128,
    hi: i128,
}

/// Without a sign.
#[derive(Clone, Copy)]
pub struct Magnitude {
    lo: u128,
    hi: u128,
}

impl Quad {
    /// `a * b`, for |a| < 2^127.
    #[inline(always)]
    pub fn product(a: i128, b: i64) -> Self {
        let low = i128::from(a as u64) * i128::from(b);
        let high = i128::from((a >> 64) as i64) * i128::from(b);
        let (lo, carry) = (low as u128).overflowing_add((high as u128) << 64);
        Self { lo, hi: (low >> 127) + (high >> 64) + i128::from(carry) }
    }

    #[inline(always)]
    pub fn add(self, other: Self) -> Self {
        let (lo, carry) = self.lo.overflowing_add(other.lo);
        Self { lo, hi: self.hi + other.hi + i128::from(carry) }
    }

    #[inline(always)]
    pub fn neg(self) -> Self {
        let (lo, borrow) = 0u128.overflowing_sub(self.lo);
        Self { lo, hi: -self.hi - i128::from(borrow) }
    }

    #[inline(always)]
    pub fn signum(&self) -> i32 {
        if self.hi < 0 { -1 } else { i32::from(self.hi != 0 || self.lo != 0) }
    }

    #[inline(always)]
    pub fn magnitude(&self) -> Magnitude {
        let Self { lo, hi } = if self.hi < 0 { self.neg() } else { *self };
        Magnitude { lo, hi: hi as u128 }
    }
}

impl round::Magnitude for Magnitude {
    #[inline(always)]
    fn bits(&self) -> u32 {
        match self.hi {
            0 => 128 - self.lo.leading_zeros(),
            hi => 256 - hi.leading_zeros(),
        }
    }

    #[inline(always)]
    fn leading(&self) -> u64 {
        (self.shl(256 - self.bits()).hi >> 64) as u64
    }

    #[inline(always)]
    fn shl(&self, by: u32) -> Self {
        match by {
            0 => *self,
            1..128 => Self { lo: self.lo << by, hi: self.hi << by | self.lo >> (128 - by) },
            _ => Self { lo: 0, hi: self.lo << (by - 128) },
        }
    }

    #[inline(always)]
    fn times(&self, by: u32) -> Self {
        let by = u128::from(by);
        let (low, middle) = ((self.lo as u64 as u128) * by, (self.lo >> 64) * by);
        let (lo, carry) = low.overflowing_add(middle << 64);
        Self { lo, hi: self.hi * by + (middle >> 64) + u128::from(carry) }
    }

    #[inline(always)]
    fn compare(&self, other: &Self) -> Ordering {
        (self.hi, self.lo).cmp(&(other.hi, other.lo))
    }
}

#[cfg(test)]
mod tests {
    use super::super::round::Magnitude as _;
    use super::Quad;

    type Int = super::super::int::Int<14>;

    /// The same number as a wide integer, from its top 64 bits down.
    fn wide(n: &super::Magnitude) -> Int {
        let limbs = [n.hi >> 64, n.hi, n.lo >> 64, n.lo].map(|limb| limb as u64);
        limbs.iter().fold(Int::ZERO, |sum, &limb| {
            let high = Int::shifted((limb >> 32) as i64, 32);
            sum.shl(64).add(&high).add(&Int::shifted((limb & 0xffff_ffff) as i64, 0))
        })
    }

    fn int(x: i128) -> Int {
        let n = wide(&super::Magnitude { lo: x.unsigned_abs(), hi: 0 });
        if x < 0 { n.neg() } else { n }
    }

    #[test]
    fn agrees_with_wide_integers() {
        let mut seed = 1u64;
        let mut next = || {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            seed
        };
        let ends = [0, 1, -1, i64::MAX, i64::MIN + 1, 1 << 32, -(1 << 32)];
        for i in 0..20_000 {
            let mut long = || {
                let x = (next() as i64 as i128) << 64 | i128::from(next());
                let x = x >> (next() % 126 + 1);
                let end = i128::from(ends[next() as usize % 7]) << (next() % 64);
                if next() % 4 == 0 { end } else { x }
            };
            let (a, c) = (long(), long());
            let (b, d) = ((long() >> 64) as i64, ends[i % 7]);
            let sum = Quad::product(a, b).add(Quad::product(c, d));
            let expected = int(a).mul(&int(b.into())).add(&int(c).mul(&int(d.into())));
            assert_eq!(sum.signum(), expected.signum(), "{a} * {b} + {c} * {d}");
            assert_eq!(sum.neg().signum(), -expected.signum(), "{a} * {b} + {c} * {d}");
            let magnitude = sum.magnitude();
            assert!(wide(&magnitude).sub(&expected.abs()).signum() == 0, "{a} * {b} + {c} * {d}");
            let negated = sum.neg().magnitude();
            assert!(negated.compare(&magnitude).is_eq(), "{a} * {b} + {c} * {d}");
            assert_eq!(magnitude.bits(), expected.bits());
            if expected.signum() != 0 {
                assert_eq!(magnitude.leading(), expected.leading());
            }
            let (by, times) = ((next() % 30) as u32, (next() >> 39) as u32);
            let (moved, expected) = (magnitude.times(times).shl(by), expected.times(times).shl(by));
            assert!(wide(&moved).sub(&expected.abs()).signum() == 0, "times {times} << {by}");
        }
    }
}
