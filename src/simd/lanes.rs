//! The vector operations that the walk and the sieve are written in.

/// Four `f64`, four `i32` and four `f32`, with the operations needed.
///
/// A value of an implementing type is proof that the processor has the
/// instructions: values come from run-time detection alone.
pub(crate) trait Lanes: Copy {
    type F64: Copy;
    type I32: Copy;
    type F32: Copy;

    /// Runs a kernel compiled for this instruction set.
    fn run<K: Kernel<Self>>(self, kernel: K) -> K::Out;

    fn f64(self, a: [f64; 4]) -> Self::F64;
    fn splat_f64(self, a: f64) -> Self::F64;
    /// `a * b + c`, rounded twice: the counters of a walk are then the same on
    /// every instruction set.
    fn mul_add(self, a: Self::F64, b: Self::F64, c: Self::F64) -> Self::F64;
    fn mul_f64(self, a: Self::F64, b: Self::F64) -> Self::F64;
    fn add_f64(self, a: Self::F64, b: Self::F64) -> Self::F64;
    fn sub_f64(self, a: Self::F64, b: Self::F64) -> Self::F64;
    fn min_f64(self, a: Self::F64, b: Self::F64) -> Self::F64;
    fn max_f64(self, a: Self::F64, b: Self::F64) -> Self::F64;
    /// Whether `|a| > b` in one of the first three lanes.
    fn any_beyond(self, a: Self::F64, b: Self::F64) -> bool;
    /// The greatest lane, in every lane.
    fn highest(self, a: Self::F64) -> Self::F64;
    /// The least lane, in every lane.
    fn lowest(self, a: Self::F64) -> Self::F64;
    fn array_f64(self, a: Self::F64) -> [f64; 4];
    fn first(self, a: Self::F64) -> f64;
    /// Towards zero; out of range gives some number.
    fn truncate(self, a: Self::F64) -> Self::I32;
    /// `i` where `a == b`, else `j`.
    fn select_eq(self, a: Self::F64, b: Self::F64, i: Self::I32, j: Self::I32) -> Self::I32;

    fn i32(self, a: [i32; 4]) -> Self::I32;
    fn splat_i32(self, a: i32) -> Self::I32;
    fn array(self, a: Self::I32) -> [i32; 4];
    fn to_f64(self, a: Self::I32) -> Self::F64;
    fn add(self, a: Self::I32, b: Self::I32) -> Self::I32;
    fn sub(self, a: Self::I32, b: Self::I32) -> Self::I32;
    fn and(self, a: Self::I32, b: Self::I32) -> Self::I32;
    fn xor(self, a: Self::I32, b: Self::I32) -> Self::I32;
    fn min(self, a: Self::I32, b: Self::I32) -> Self::I32;
    fn max(self, a: Self::I32, b: Self::I32) -> Self::I32;
    /// Each lane of `a` shifted right by the lane of `by`, zeros coming in.
    fn shift_right(self, a: Self::I32, by: Self::I32) -> Self::I32;
    /// Whether some lane of `a` is negative or not below that of `n`.
    fn outside(self, a: Self::I32, n: Self::I32) -> bool;

    fn splat_f32(self, a: f32) -> Self::F32;
    /// Four lanes from memory; the fourth may be no number.
    fn load(self, a: &[f32; 4]) -> Self::F32;
    fn sub_f32(self, a: Self::F32, b: Self::F32) -> Self::F32;
    fn add_f32(self, a: Self::F32, b: Self::F32) -> Self::F32;
    fn mul_f32(self, a: Self::F32, b: Self::F32) -> Self::F32;
    fn abs_f32(self, a: Self::F32) -> Self::F32;
    /// Lanes 1, 2, 0 of `a` in lanes 0, 1, 2.
    fn rotate(self, a: Self::F32) -> Self::F32;
    /// Whether one of the first three lanes of `a` is below `-b` and another
    /// above `b`.
    fn both_sides(self, a: Self::F32, b: Self::F32) -> bool;
}

/// Code to be compiled for an instruction set.
pub(crate) trait Kernel<L> {
    type Out;
    /// Must be `#[inline(always)]`, down to the lanes' operations.
    fn run(self, lanes: L) -> Self::Out;
}
