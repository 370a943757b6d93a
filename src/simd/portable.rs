//! Lanes on any processor: arrays, for the compiler to vectorise as it can.

use super::lanes::{Kernel, Lanes};

/// Always there.
#[derive(Clone, Copy)]
pub struct Portable;

#[inline(always)]
fn map<A: Copy, B: Copy, C>(a: [A; 4], b: [B; 4], f: impl Fn(A, B) -> C) -> [C; 4] {
    core::array::from_fn(|k| f(a[k], b[k]))
}

impl Lanes for Portable {
    type F64 = [f64; 4];
    type I32 = [i32; 4];
    type F32 = [f32; 4];

    #[inline(always)]
    fn run<K: Kernel<Self>>(self, kernel: K) -> K::Out {
        kernel.run(self)
    }

    #[inline(always)]
    fn f64(self, a: [f64; 4]) -> [f64; 4] {
        a
    }
    #[inline(always)]
    fn splat_f64(self, a: f64) -> [f64; 4] {
        [a; 4]
    }
    #[inline(always)]
    fn mul_add(self, a: [f64; 4], b: [f64; 4], c: [f64; 4]) -> [f64; 4] {
        core::array::from_fn(|k| a[k] * b[k] + c[k])
    }
    #[inline(always)]
    fn mul_f64(self, a: [f64; 4], b: [f64; 4]) -> [f64; 4] {
        map(a, b, |a, b| a * b)
    }
    #[inline(always)]
    fn add_f64(self, a: [f64; 4], b: [f64; 4]) -> [f64; 4] {
        map(a, b, |a, b| a + b)
    }
    #[inline(always)]
    fn sub_f64(self, a: [f64; 4], b: [f64; 4]) -> [f64; 4] {
        map(a, b, |a, b| a - b)
    }
    #[inline(always)]
    fn min_f64(self, a: [f64; 4], b: [f64; 4]) -> [f64; 4] {
        map(a, b, |a, b| if a < b { a } else { b })
    }
    #[inline(always)]
    fn max_f64(self, a: [f64; 4], b: [f64; 4]) -> [f64; 4] {
        map(a, b, |a, b| if a > b { a } else { b })
    }
    #[inline(always)]
    fn any_beyond(self, a: [f64; 4], b: [f64; 4]) -> bool {
        (0..3).any(|k| a[k].abs() > b[k])
    }
    #[inline(always)]
    fn highest(self, a: [f64; 4]) -> [f64; 4] {
        let high = |x: f64, y: f64| if x > y { x } else { y };
        [high(high(a[0], a[1]), high(a[2], a[3])); 4]
    }
    #[inline(always)]
    fn lowest(self, a: [f64; 4]) -> [f64; 4] {
        let low = |x: f64, y: f64| if x < y { x } else { y };
        [low(low(a[0], a[1]), low(a[2], a[3])); 4]
    }
    #[inline(always)]
    fn array_f64(self, a: [f64; 4]) -> [f64; 4] {
        a
    }
    #[inline(always)]
    fn first(self, a: [f64; 4]) -> f64 {
        a[0]
    }
    #[inline(always)]
    fn truncate(self, a: [f64; 4]) -> [i32; 4] {
        a.map(|x| x as i32)
    }
    #[inline(always)]
    fn select_eq(self, a: [f64; 4], b: [f64; 4], i: [i32; 4], j: [i32; 4]) -> [i32; 4] {
        core::array::from_fn(|k| if a[k] == b[k] { i[k] } else { j[k] })
    }

    #[inline(always)]
    fn i32(self, a: [i32; 4]) -> [i32; 4] {
        a
    }
    #[inline(always)]
    fn splat_i32(self, a: i32) -> [i32; 4] {
        [a; 4]
    }
    #[inline(always)]
    fn array(self, a: [i32; 4]) -> [i32; 4] {
        a
    }
    #[inline(always)]
    fn to_f64(self, a: [i32; 4]) -> [f64; 4] {
        a.map(f64::from)
    }
    #[inline(always)]
    fn add(self, a: [i32; 4], b: [i32; 4]) -> [i32; 4] {
        map(a, b, i32::wrapping_add)
    }
    #[inline(always)]
    fn sub(self, a: [i32; 4], b: [i32; 4]) -> [i32; 4] {
        map(a, b, i32::wrapping_sub)
    }
    #[inline(always)]
    fn and(self, a: [i32; 4], b: [i32; 4]) -> [i32; 4] {
        map(a, b, |a, b| a & b)
    }
    #[inline(always)]
    fn xor(self, a: [i32; 4], b: [i32; 4]) -> [i32; 4] {
        map(a, b, |a, b| a ^ b)
    }
    #[inline(always)]
    fn min(self, a: [i32; 4], b: [i32; 4]) -> [i32; 4] {
        map(a, b, i32::min)
    }
    #[inline(always)]
    fn max(self, a: [i32; 4], b: [i32; 4]) -> [i32; 4] {
        map(a, b, i32::max)
    }
    #[inline(always)]
    fn shift_right(self, a: [i32; 4], by: [i32; 4]) -> [i32; 4] {
        map(a, by, |a, by| (a as u32 >> by) as i32)
    }
    #[inline(always)]
    fn outside(self, a: [i32; 4], n: [i32; 4]) -> bool {
        map(a, n, |a, n| a as u32 >= n as u32).contains(&true)
    }

    #[inline(always)]
    fn splat_f32(self, a: f32) -> [f32; 4] {
        [a; 4]
    }
    #[inline(always)]
    fn load(self, a: &[f32; 4]) -> [f32; 4] {
        *a
    }
    #[inline(always)]
    fn sub_f32(self, a: [f32; 4], b: [f32; 4]) -> [f32; 4] {
        map(a, b, |a, b| a - b)
    }
    #[inline(always)]
    fn add_f32(self, a: [f32; 4], b: [f32; 4]) -> [f32; 4] {
        map(a, b, |a, b| a + b)
    }
    #[inline(always)]
    fn mul_f32(self, a: [f32; 4], b: [f32; 4]) -> [f32; 4] {
        map(a, b, |a, b| a * b)
    }
    #[inline(always)]
    fn abs_f32(self, a: [f32; 4]) -> [f32; 4] {
        a.map(f32::abs)
    }
    #[inline(always)]
    fn rotate(self, [x, y, z, w]: [f32; 4]) -> [f32; 4] {
        [y, z, x, w]
    }
    #[inline(always)]
    fn both_sides(self, a: [f32; 4], b: [f32; 4]) -> bool {
        let below = a[0] < -b[0] || a[1] < -b[1] || a[2] < -b[2];
        let above = a[0] > b[0] || a[1] > b[1] || a[2] > b[2];
        below && above
    }
}
