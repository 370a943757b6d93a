//! Lanes on any processor: arrays, for the compiler to vectorise as it can.

use super::lanes::{Kernel, Lanes};

/// Always there.
#[derive(Clone, Copy)]
pub struct Portable;

#[inline(always)]
fn map<A: Copy, B: Copy, C>(a: [A; 4], b: [B; 4], f: impl Fn(A, B) -> C) -> [C; 4] {
    core::array::from_fn(|k| f(a[k], b[k]))
}

#[inline(always)]
fn lesser(x: f32, y: f32) -> f32 {
    // As integers: as numbers, but for the order of negative ones.
    if (x.to_bits() as i32) < y.to_bits() as i32 { x } else { y }
}

/// `a * b + c`, rounded once: the product is exact in `f64`, the sum rounded to
/// odd (Boldo & Melquiond 2008), so that rounding to `f32` is as of the exact sum.
fn fused(a: f32, b: f32, c: f32) -> f32 {
    let (p, c) = (f64::from(a) * f64::from(b), f64::from(c));
    let s = p + c;
    let back = s - p;
    let lost = (p - (s - back)) + (c - back);
    if lost != 0.0 && lost.is_finite() && s.to_bits() & 1 == 0 {
        let away = (lost > 0.0) == (s > 0.0);
        return f64::from_bits(if away { s.to_bits() + 1 } else { s.to_bits() - 1 }) as f32;
    }
    s as f32
}

/// Operations that are one expression.
macro_rules! operations {
    ($(fn $name:ident($self:ident $(, $a:tt: $t:ty)*) -> $out:ty = $e:expr;)*) => {$(
        #[inline(always)]
        fn $name($self $(, $a: $t)*) -> $out {
            $e
        }
    )*};
}

impl Lanes for Portable {
    type F64 = [f64; 4];
    type F32 = [f32; 4];
    type I32 = [i32; 4];
    type Wide = [f32; 4];
    type Words = [u32; 4];
    const WIDE: usize = 4;
    const REGISTERS: bool = false;

    operations! {
        fn array_f32(self, a: [f32; 4]) -> [f32; 4] = a;
        fn load_f64(self, a: &[f64; 4]) -> [f64; 4] = *a;
        fn widen(self, a: [f32; 4]) -> [f64; 4] = a.map(f64::from);
        fn i32_to_f64(self, a: [i32; 4]) -> [f64; 4] = a.map(f64::from);
        fn mul_f64(self, a: [f64; 4], b: [f64; 4]) -> [f64; 4] = map(a, b, |a, b| a * b);
        fn add_f64(self, a: [f64; 4], b: [f64; 4]) -> [f64; 4] = map(a, b, |a, b| a + b);
        fn sub_f64(self, a: [f64; 4], b: [f64; 4]) -> [f64; 4] = map(a, b, |a, b| a - b);
        fn div_f64(self, a: [f64; 4], b: [f64; 4]) -> [f64; 4] = map(a, b, |a, b| a / b);
        fn min_f64(self, a: [f64; 4], b: [f64; 4]) -> [f64; 4] =
            map(a, b, |a, b| if a < b { a } else { b });
        fn max_f64(self, a: [f64; 4], b: [f64; 4]) -> [f64; 4] =
            map(a, b, |a, b| if a > b { a } else { b });
        fn abs_f64(self, a: [f64; 4]) -> [f64; 4] = a.map(f64::abs);
        fn sign_f64(self, a: [f64; 4], b: [f64; 4]) -> [f64; 4] = map(a, b, f64::copysign);
        fn mirror_f64(self, a: [f64; 4], b: [f64; 4], sign: [f64; 4]) -> [f64; 4] =
            core::array::from_fn(|k| if sign[k].is_sign_negative() { b[k] - a[k] } else { a[k] });
        fn any_beyond(self, a: [f64; 4], b: f64) -> bool = (0..3).any(|k| a[k].abs() > b);
        fn above_f64(self, a: [f64; 4], b: [f64; 4]) -> u32 =
            (0..4).map(|k| u32::from(a[k] > b[k]) << k).sum();
        fn any_outside(self, a: [f64; 4], n: [f64; 4]) -> bool =
            (0..3).any(|k| a[k] < 0.0 || a[k] > n[k]);
        fn mul_add_f64(self, a: [f64; 4], b: [f64; 4], c: [f64; 4]) -> [f64; 4] =
            core::array::from_fn(|k| a[k] * b[k] + c[k]);
        fn next_f64(self, [x, y, z, _]: [f64; 4]) -> [f64; 4] = [y, z, x, y];
        fn with_last(self, [x, y, z, _]: [f64; 4], b: [f64; 4]) -> [f64; 4] = [x, y, z, b[2]];
        fn array_f64(self, a: [f64; 4]) -> [f64; 4] = a;
        fn load_f32(self, a: &[f32; 4]) -> [f32; 4] = *a;
        fn with_third(self, [x, y, _, w]: [f32; 4], b: [f32; 4]) -> [f32; 4] = [x, y, b[2], w];
        fn load3(self, [x, y, z, _]: &[f32; 4]) -> [f32; 4] = [*x, *y, *z, 0.0];
        fn narrow(self, a: [f64; 4]) -> [f32; 4] = a.map(|x| x as f32);
        fn to_f32(self, a: [i32; 4]) -> [f32; 4] = a.map(|x| x as f32);
        fn mul_f32(self, a: [f32; 4], b: [f32; 4]) -> [f32; 4] = map(a, b, |a, b| a * b);
        fn add_f32(self, a: [f32; 4], b: [f32; 4]) -> [f32; 4] = map(a, b, |a, b| a + b);
        fn sub_f32(self, a: [f32; 4], b: [f32; 4]) -> [f32; 4] = map(a, b, |a, b| a - b);
        fn div_f32(self, a: [f32; 4], b: [f32; 4]) -> [f32; 4] = map(a, b, |a, b| a / b);
        fn mask_f32(self, a: [f32; 4], mask: [i32; 4]) -> [f32; 4] =
            map(a, mask, |a, mask| f32::from_bits(a.to_bits() & mask as u32));
        fn minus_f32(self, a: [f32; 4]) -> [f32; 4] = a.map(|x| -x);
        fn sign_f32(self, a: [f32; 4], b: [f32; 4]) -> [f32; 4] = map(a, b, f32::copysign);
        fn max_f32(self, a: [f32; 4], b: [f32; 4]) -> [f32; 4] =
            map(a, b, |a, b| if a > b { a } else { b });
        fn abs_f32(self, a: [f32; 4]) -> [f32; 4] = a.map(f32::abs);
        fn first(self, a: [f32; 4]) -> f32 = a[0];
        fn truncate(self, a: [f32; 4]) -> [i32; 4] = a.map(|x| x as i32);
        fn equal(self, a: [f32; 4], b: [f32; 4]) -> [i32; 4] = map(a, b, |a, b| -i32::from(a == b));
        fn permute(self, a: [f32; 4], order: &[i32; 4]) -> [f32; 4] =
            order.map(|k| a[k as usize & 3]);
        fn signs(self, a: [f32; 4]) -> u32 = (0..3).map(|k| a[k].to_bits() >> 31 << k).sum();
        fn all_below(self, a: [f32; 4], b: f32) -> bool = (0..3).all(|k| a[k].abs() < b);
        fn all_finite(self, a: [f32; 4]) -> bool = a.iter().all(|x| x.is_finite());
        fn same(self, a: [f32; 4], b: [f32; 4]) -> u32 =
            (0..4).map(|k| u32::from(a[k] == b[k]) << k).sum();
        fn equals(self, a: [f32; 4], b: [f32; 4]) -> u32 =
            (0..3).map(|k| u32::from(a[k] == b[k]) << k).sum();
        fn load_i32(self, a: &[i32; 4]) -> [i32; 4] = *a;
        fn load_u32(self, a: &[u32; 4]) -> [i32; 4] = a.map(|x| x as i32);
        fn load_u16(self, a: &[u16; 4]) -> [i32; 4] = a.map(i32::from);
        fn array(self, a: [i32; 4]) -> [i32; 4] = a;
        fn add(self, a: [i32; 4], b: [i32; 4]) -> [i32; 4] = map(a, b, i32::wrapping_add);
        fn sub(self, a: [i32; 4], b: [i32; 4]) -> [i32; 4] = map(a, b, i32::wrapping_sub);
        fn and(self, a: [i32; 4], b: [i32; 4]) -> [i32; 4] = map(a, b, |a, b| a & b);
        fn xor(self, a: [i32; 4], b: [i32; 4]) -> [i32; 4] = map(a, b, |a, b| a ^ b);
        fn min(self, a: [i32; 4], b: [i32; 4]) -> [i32; 4] = map(a, b, i32::min);
        fn max(self, a: [i32; 4], b: [i32; 4]) -> [i32; 4] = map(a, b, i32::max);
        fn select(self, mask: [i32; 4], a: [i32; 4], b: [i32; 4]) -> [i32; 4] =
            core::array::from_fn(|k| a[k] & !mask[k] | b[k] & mask[k]);
        fn shift_right(self, a: [i32; 4], by: [i32; 4]) -> [i32; 4] =
            map(a, by, |a, by| (a as u32).wrapping_shr(by as u32) as i32);
        fn any_greater(self, a: [i32; 4], b: [i32; 4]) -> bool =
            a[0] > b[0] || a[1] > b[1] || a[2] > b[2];
        fn words(self, words: &[u32; 8]) -> [u32; 4] = core::array::from_fn(|k| words[k]);
        fn field(self, words: [u32; 4], mask: &[u32; 8]) -> [f32; 4] =
            core::array::from_fn(|k| (words[k] & mask[k]) as i32 as f32);
        fn tops(self, words: [u32; 4]) -> [u32; 2] =
            [31, 30].map(|bit| (0..4).map(|k| (words[k] >> bit & 1) << k).sum());
        fn load_wide(self, a: &[f32; 8]) -> [f32; 4] = core::array::from_fn(|k| a[k]);
        fn truncate_wide(self, a: [f32; 4]) -> [f32; 4] = a.map(|a| a as i32 as f32);
        fn choose_wide(self, a: [f32; 4], b: [f32; 4], x: [f32; 4], y: [f32; 4]) -> [f32; 4] =
            core::array::from_fn(|k| if a[k] <= b[k] { x[k] } else { y[k] });
        fn load_from(self, a: &[f32; 8], at: usize) -> [f32; 4] =
            core::array::from_fn(|k| a[(at + k) % 8]);
        fn bytes_from(self, a: &[u8; 8], at: usize) -> [f32; 4] =
            core::array::from_fn(|k| f32::from(a[(at + k) % 8]));
        fn div_wide(self, a: [f32; 4], b: [f32; 4]) -> [f32; 4] = self.div_f32(a, b);
        fn sub_wide(self, a: [f32; 4], b: [f32; 4]) -> [f32; 4] = self.sub_f32(a, b);
        fn mul_wide(self, a: [f32; 4], b: [f32; 4]) -> [f32; 4] = self.mul_f32(a, b);
        fn add_wide(self, a: [f32; 4], b: [f32; 4]) -> [f32; 4] = self.add_f32(a, b);
        fn min_wide(self, a: [f32; 4], b: [f32; 4]) -> [f32; 4] =
            map(a, b, |a, b| if a < b { a } else { b });
        fn max_wide(self, a: [f32; 4], b: [f32; 4]) -> [f32; 4] = self.max_f32(a, b);
        fn abs_wide(self, a: [f32; 4]) -> [f32; 4] = self.abs_f32(a);
        fn mul_add_wide(self, a: [f32; 4], b: [f32; 4], c: [f32; 4]) -> [f32; 4] =
            core::array::from_fn(|k| a[k] * b[k] + c[k]);
        fn at_most(self, a: [f32; 4], b: [f32; 4]) -> u32 =
            (0..4).map(|k| u32::from(a[k] <= b[k]) << k).sum();
        fn less_product(self, a: [f32; 4], b: [f32; 4], c: [f32; 4]) -> [f32; 4] =
            self.sub_f32(a, self.mul_f32(b, c));
        fn product_less(self, a: [f32; 4], b: [f32; 4], c: [f32; 4]) -> [f32; 4] =
            self.sub_f32(self.mul_f32(a, b), c);
        fn turn_wide(self, a: [f32; 4], b: [f32; 4]) -> [f32; 4] =
            map(a, b, |a, b| f32::from_bits(a.to_bits() ^ b.to_bits() & 1 << 31));
        fn cross_wide(self, a: [f32; 4], b: [f32; 4], c: [f32; 4], d: [f32; 4]) -> [f32; 4] =
            self.sub_f32(self.mul_f32(a, b), self.mul_f32(c, d));
    }

    /// Not inlined: its stack would be taken where another instruction set is in use.
    #[inline(never)]
    fn run<K: Kernel<Self>>(self, kernel: K) -> K::Out {
        kernel.run(self)
    }

    #[inline(always)]
    fn prefetch<T>(self, _: *const T) {}
    #[inline(always)]
    fn splat_f64(self, a: f64) -> [f64; 4] {
        [a; 4]
    }
    #[inline(always)]
    fn highest3(self, [x, y, z, _]: [f64; 4]) -> f64 {
        let high = |x: f64, y: f64| if x > y { x } else { y };
        high(high(x, y), z)
    }
    #[inline(always)]
    fn lowest3(self, [x, y, z, _]: [f64; 4]) -> f64 {
        let low = |x: f64, y: f64| if x < y { x } else { y };
        low(low(x, y), z)
    }

    #[inline(always)]
    fn splat_f32(self, a: f32) -> [f32; 4] {
        [a; 4]
    }
    #[inline(always)]
    fn mul_add<const EXACT: bool>(self, a: [f32; 4], b: [f32; 4], c: [f32; 4]) -> [f32; 4] {
        core::array::from_fn(|k| if EXACT { fused(a[k], b[k], c[k]) } else { a[k] * b[k] + c[k] })
    }
    #[inline(always)]
    fn highest(self, [x, y, z, _]: [f32; 4]) -> [f32; 4] {
        let high = |x: f32, y: f32| if x > y { x } else { y };
        [high(high(x, y), z); 4]
    }
    #[inline(always)]
    fn lowest(self, [x, y, z, _]: [f32; 4]) -> [f32; 4] {
        [lesser(lesser(x, y), z); 4]
    }

    #[inline(always)]
    fn splat_i32(self, a: i32) -> [i32; 4] {
        [a; 4]
    }

    #[inline(always)]
    fn compress(self, words: &[u32; 8], mask: u32, to: &mut [u32; 8]) {
        let mut n = 0;
        for (k, &word) in words[..4].iter().enumerate() {
            to[n] = word;
            n += (mask >> k & 1) as usize;
        }
        to[n] = 0;
    }
    #[inline(always)]
    fn thrice(self, numbers: &[u32]) -> [u32; 8] {
        let mut thrice = [0; 8];
        for (to, number) in thrice[..4].iter_mut().zip(numbers) {
            *to = number * 3;
        }
        thrice
    }
    #[inline(always)]
    fn columns<'a>(self, row: impl Fn(usize) -> &'a [f32; 4]) -> [[f32; 4]; 3] {
        let rows = [row(0), row(1), row(2), row(3)];
        [0, 1, 2].map(|k| [rows[0][k], rows[1][k], rows[2][k], rows[3][k]])
    }
    #[inline(always)]
    fn store_wide(self, a: [f32; 4], to: &mut [f32; 8]) {
        to[..4].copy_from_slice(&a);
    }
    #[inline(always)]
    fn numbers(
        self,
        near: [f32; 4],
        far: [f32; 4],
        stride: &[u32; 8],
        first: &[u32; 8],
        to: &mut [u32; 8],
    ) {
        for k in 0..4 {
            let far = (far[k] as i32 as u32).wrapping_mul(stride[k]);
            to[k] = (near[k] as i32 as u32).wrapping_add(first[k]).wrapping_add(far);
        }
    }
    #[inline(always)]
    fn store_from(self, a: [f32; 4], to: &mut [f32; 8], at: usize) {
        for (k, a) in a.into_iter().enumerate() {
            to[(at + k) % 8] = a;
        }
    }
    #[inline(always)]
    fn splat_wide(self, a: f32) -> [f32; 4] {
        [a; 4]
    }
    #[inline(always)]
    fn misses(self, [a, b]: [[f32; 4]; 2], [c, d]: [[f32; 4]; 2], [e, f]: [[f32; 4]; 2]) -> u32 {
        let miss = |k: usize| (a[k] > b[k]) | (c[k] > d[k]) & (e[k] > f[k]);
        (0..4).map(|k| u32::from(miss(k)) << k).sum()
    }
}
