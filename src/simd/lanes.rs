//! The vector operations that the walk and the sieve are written in.

/// Four lanes of `f64`, `f32` and `i32` for the walk of one ray, and wide rows of `f32`
/// whose lanes are triangles, boxes, rays or pairs, with the operations needed.
///
/// A value of an implementing type is proof that the processor has the
/// instructions: values come from run-time detection, unless the target has them
/// anyway. What four lanes compute is the same everywhere, bit for bit, but for numbers
/// out of range, NaN and which of two zeros is the greater; wide rows may round
/// otherwise where an operation says so, and not in others: the tree of boxes is built with these.
pub(crate) trait Lanes: Copy + 'static {
    type F64: Copy;
    type F32: Copy;
    type I32: Copy;
    /// [`Lanes::WIDE`] `f32`, at most 8.
    type Wide: Copy;
    /// [`Lanes::WIDE`] `u32`.
    type Words: Copy;
    const WIDE: usize;
    /// Whether lanes are registers. Where they are arrays, what only saves time elsewhere is left
    /// out, as it would be much code.
    const REGISTERS: bool = true;

    /// Rays that [`Lanes::enter_box`] takes at once, at most 16.
    const MANY: usize = Self::WIDE;

    /// Brings what `at` points to closer, if that is quicker; reads nothing.
    #[inline(always)]
    fn prefetch<T>(self, at: *const T) {
        super::fetch(at);
    }

    /// Runs a kernel compiled for this instruction set.
    fn run<K: Kernel<Self>>(self, kernel: K) -> K::Out;

    /// Likewise, in a function of its own: what several places need is there but once.
    #[inline(never)]
    fn run_in_function<K: Kernel<Self>>(self, kernel: K) -> K::Out {
        self.run(kernel)
    }

    /// Likewise, never as part of the caller: what is rarely needed does not take its registers,
    /// and is there but once.
    #[cold]
    #[inline(never)]
    fn run_apart<K: Kernel<Self>>(self, kernel: K) -> K::Out {
        kernel.run(self)
    }

    fn load_f64(self, a: &[f64; 4]) -> Self::F64;
    fn splat_f64(self, a: f64) -> Self::F64;
    fn widen(self, a: Self::F32) -> Self::F64;
    fn i32_to_f64(self, a: Self::I32) -> Self::F64;
    fn mul_f64(self, a: Self::F64, b: Self::F64) -> Self::F64;
    fn add_f64(self, a: Self::F64, b: Self::F64) -> Self::F64;
    fn sub_f64(self, a: Self::F64, b: Self::F64) -> Self::F64;
    fn div_f64(self, a: Self::F64, b: Self::F64) -> Self::F64;
    fn min_f64(self, a: Self::F64, b: Self::F64) -> Self::F64;
    fn max_f64(self, a: Self::F64, b: Self::F64) -> Self::F64;
    fn abs_f64(self, a: Self::F64) -> Self::F64;
    /// `a` with the sign of `b`, for `a` not negative.
    fn sign_f64(self, a: Self::F64, b: Self::F64) -> Self::F64;
    /// Where `sign` is negative `b - a`, else `a`.
    fn mirror_f64(self, a: Self::F64, b: Self::F64, sign: Self::F64) -> Self::F64;
    /// Whether `|a| > b` in one of the first three lanes.
    fn any_beyond(self, a: Self::F64, b: f64) -> bool;
    /// Whether one of the first three lanes is below 0 or above that of `n`.
    fn any_outside(self, a: Self::F64, n: Self::F64) -> bool;
    /// `a * b + c`, rounded once or twice.
    fn mul_add_f64(self, a: Self::F64, b: Self::F64, c: Self::F64) -> Self::F64;
    /// Lanes 1, 2, 0 and 1.
    fn next_f64(self, a: Self::F64) -> Self::F64;
    /// `a` with the third lane of `b` as its last.
    fn with_last(self, a: Self::F64, b: Self::F64) -> Self::F64;
    /// One bit for each lane in which `a > b`.
    fn above_f64(self, a: Self::F64, b: Self::F64) -> u32;
    fn array_f64(self, a: Self::F64) -> [f64; 4];
    /// The greatest of the first three lanes.
    fn highest3(self, a: Self::F64) -> f64;
    /// The least of the first three lanes.
    fn lowest3(self, a: Self::F64) -> f64;

    fn load_f32(self, a: &[f32; 4]) -> Self::F32;
    /// Three lanes, and 0 in the fourth.
    fn load3(self, a: &[f32; 4]) -> Self::F32;
    fn splat_f32(self, a: f32) -> Self::F32;
    /// `a` with the third lane of `b` as its third.
    fn with_third(self, a: Self::F32, b: Self::F32) -> Self::F32;
    fn narrow(self, a: Self::F64) -> Self::F32;
    fn to_f32(self, a: Self::I32) -> Self::F32;
    fn mul_f32(self, a: Self::F32, b: Self::F32) -> Self::F32;
    fn add_f32(self, a: Self::F32, b: Self::F32) -> Self::F32;
    fn sub_f32(self, a: Self::F32, b: Self::F32) -> Self::F32;
    fn div_f32(self, a: Self::F32, b: Self::F32) -> Self::F32;
    /// `a * b + c`, rounded once; without `EXACT` perhaps twice.
    fn mul_add<const EXACT: bool>(self, a: Self::F32, b: Self::F32, c: Self::F32) -> Self::F32;
    /// `a` where `mask` is all ones, +0 where it is zero.
    fn mask_f32(self, a: Self::F32, mask: Self::I32) -> Self::F32;
    fn minus_f32(self, a: Self::F32) -> Self::F32;
    /// `a` with the sign of `b`, for `a` not negative.
    fn sign_f32(self, a: Self::F32, b: Self::F32) -> Self::F32;
    fn max_f32(self, a: Self::F32, b: Self::F32) -> Self::F32;
    /// The greatest of the first three lanes, in every lane.
    fn highest(self, a: Self::F32) -> Self::F32;
    fn abs_f32(self, a: Self::F32) -> Self::F32;
    /// The least of the first three lanes, none of them NaN, in each of them. Of several
    /// negative ones, any.
    fn lowest(self, a: Self::F32) -> Self::F32;
    fn first(self, a: Self::F32) -> f32;
    /// Towards zero; out of range and NaN give some number.
    fn truncate(self, a: Self::F32) -> Self::I32;
    /// All ones where `a == b`, else zeros.
    fn equal(self, a: Self::F32, b: Self::F32) -> Self::I32;
    /// Lane `order[k]` of `a` in lane k.
    fn permute(self, a: Self::F32, order: &[i32; 4]) -> Self::F32;
    fn array_f32(self, a: Self::F32) -> [f32; 4];
    /// Lane i of row k in lane k of row i.
    #[inline(always)]
    fn transpose(self, rows: [Self::F32; 4]) -> [Self::F32; 4] {
        let [a, b, c, d] = [
            self.array_f32(rows[0]),
            self.array_f32(rows[1]),
            self.array_f32(rows[2]),
            self.array_f32(rows[3]),
        ];
        [
            self.load_f32(&[a[0], b[0], c[0], d[0]]),
            self.load_f32(&[a[1], b[1], c[1], d[1]]),
            self.load_f32(&[a[2], b[2], c[2], d[2]]),
            self.load_f32(&[a[3], b[3], c[3], d[3]]),
        ]
    }
    /// One bit for each of the first three lanes that is negative, -0 included.
    fn signs(self, a: Self::F32) -> u32;
    /// Whether `|a| < b` in each of the first three lanes.
    fn all_below(self, a: Self::F32, b: f32) -> bool;
    /// Whether no lane is infinite or NaN.
    fn all_finite(self, a: Self::F32) -> bool;
    /// One bit for each lane in which `a == b`.
    fn same(self, a: Self::F32, b: Self::F32) -> u32;
    /// One bit for each of the first three lanes in which `a == b`.
    fn equals(self, a: Self::F32, b: Self::F32) -> u32;

    fn load_i32(self, a: &[i32; 4]) -> Self::I32;
    fn load_u32(self, a: &[u32; 4]) -> Self::I32;
    fn splat_i32(self, a: i32) -> Self::I32;
    fn load_u16(self, a: &[u16; 4]) -> Self::I32;
    fn array(self, a: Self::I32) -> [i32; 4];
    fn add(self, a: Self::I32, b: Self::I32) -> Self::I32;
    fn sub(self, a: Self::I32, b: Self::I32) -> Self::I32;
    fn and(self, a: Self::I32, b: Self::I32) -> Self::I32;
    fn xor(self, a: Self::I32, b: Self::I32) -> Self::I32;
    fn min(self, a: Self::I32, b: Self::I32) -> Self::I32;
    fn max(self, a: Self::I32, b: Self::I32) -> Self::I32;
    /// `b` where `mask` is all ones, `a` where it is zero.
    fn select(self, mask: Self::I32, a: Self::I32, b: Self::I32) -> Self::I32;
    /// Each lane of `a` shifted right by the lane of `by` modulo 32, zeros coming in.
    fn shift_right(self, a: Self::I32, by: Self::I32) -> Self::I32;
    /// Whether one of the first three lanes of `a` is greater than that of `b`.
    fn any_greater(self, a: Self::I32, b: Self::I32) -> bool;

    /// The first [`Lanes::WIDE`] words.
    fn words(self, words: &[u32; 8]) -> Self::Words;
    /// The bits of each word that are in `mask`, which has no sign, as a number.
    fn field(self, words: Self::Words, mask: &[u32; 8]) -> Self::Wide;
    /// The top bit of each word, and the bit below it: a bit each.
    fn tops(self, words: Self::Words) -> [u32; 2];
    /// Copies the words that `mask` has a bit for to the start of `to`, in their order;
    /// what follows them there becomes the first of `words`, or 0, or stays.
    fn compress(self, words: &[u32; 8], mask: u32, to: &mut [u32; 8]);
    /// The same of numbers.
    #[inline(always)]
    fn compress_wide(self, a: Self::Wide, mask: u32, to: &mut [f32; 8]) {
        let (mut numbers, mut words) = ([0.0; 8], [0; 8]);
        self.store_wide(a, &mut numbers);
        self.compress(bytemuck::cast_ref(&numbers), mask, &mut words);
        *to = bytemuck::cast(words);
    }
    /// Of the first [`Lanes::WIDE`] numbers of entries their values; modulo `N`, a power of two.
    #[inline(always)]
    fn gather<const N: usize>(self, from: &[f32; N], numbers: &[u32; 8]) -> Self::Wide {
        const { assert!(N.is_power_of_two()) };
        let mut all = [0.0; 8];
        for (to, &number) in all.iter_mut().zip(numbers) {
            *to = from[number as usize % N];
        }
        self.load_wide(&all)
    }
    /// Writes the ids of those of the first [`Lanes::MANY`] rays that meet a box, and where they enter it,
    /// in their order, to the start of `to` and `entries`, where what follows becomes anything;
    /// returns how many they are. `near` and `far`, the first and the last three of the box's
    /// `bounds`, are those that all of them come to first and last.
    #[inline(always)]
    fn enter_box(
        self,
        rays: &RayColumns<'_>,
        bounds: [f32; 6],
        ids: &[u32; 16],
        to: &mut [u32; 16],
        entries: &mut [f32; 16],
    ) -> usize {
        const { assert!(Self::MANY == Self::WIDE) };
        let &RayColumns { pace, from, enter, to: ends, leave } = rays;
        let pace = each!(k => self.load_wide(eight(pace[k])));
        let enter = each!(k => {
            self.mul_add_wide(self.splat_wide(bounds[k]), pace[k], self.load_wide(eight(enter[k])))
        });
        let leave = each!(k => {
            let bound = self.splat_wide(bounds[k + 3]);
            self.mul_add_wide(bound, pace[k], self.load_wide(eight(leave[k])))
        });
        let first = self.max_wide(enter[2], self.load_wide(eight(from)));
        let first = self.max_wide(self.max_wide(enter[0], enter[1]), first);
        let last = self.min_wide(leave[2], self.load_wide(eight(ends)));
        let last = self.min_wide(self.min_wide(leave[0], leave[1]), last);
        let met = self.at_most(first, last);
        self.compress(eight(ids), met, eight_mut(to));
        self.compress_wide(first, met, eight_mut(entries));
        met.count_ones() as usize
    }
    /// Three times the first [`Lanes::WIDE`] numbers, zeros where there are fewer.
    fn thrice(self, numbers: &[u32]) -> [u32; 8];
    /// The first, second and third numbers of `row(0)`, `row(1)` and so on.
    fn columns<'a>(self, row: impl Fn(usize) -> &'a [f32; 4]) -> [Self::Wide; 3];
    /// All four numbers of these.
    #[inline(always)]
    fn four_columns<'a>(self, row: impl Fn(usize) -> &'a [f32; 4]) -> [Self::Wide; 4] {
        let mut all = [[0.0; 8]; 4];
        for i in 0..Self::WIDE {
            for (column, &number) in all.iter_mut().zip(row(i)) {
                column[i] = number;
            }
        }
        let [a, b, c, d] = &all;
        [self.load_wide(a), self.load_wide(b), self.load_wide(c), self.load_wide(d)]
    }
    fn load_wide(self, a: &[f32; 8]) -> Self::Wide;
    /// Writes the first [`Lanes::WIDE`].
    fn store_wide(self, a: Self::Wide, to: &mut [f32; 8]);
    /// [`Lanes::WIDE`] numbers from `at` on, a multiple of that below 8.
    fn load_from(self, a: &[f32; 8], at: usize) -> Self::Wide;
    /// The same of bytes, as numbers.
    fn bytes_from(self, a: &[u8; 8], at: usize) -> Self::Wide;
    /// Writes them there.
    fn store_from(self, a: Self::Wide, to: &mut [f32; 8], at: usize);
    fn splat_wide(self, a: f32) -> Self::Wide;
    /// Towards zero; what is too large for an `i32`, and NaN, give anything.
    fn truncate_wide(self, a: Self::Wide) -> Self::Wide;
    /// `x` where `a <= b`, else `y`.
    fn choose_wide(self, a: Self::Wide, b: Self::Wide, x: Self::Wide, y: Self::Wide) -> Self::Wide;
    /// `first + near + far * stride`, of whole numbers, modulo 2^32; what is too large for an
    /// `i32`, and NaN, give any number.
    fn numbers(
        self,
        near: Self::Wide,
        far: Self::Wide,
        stride: &[u32; 8],
        first: &[u32; 8],
        to: &mut [u32; 8],
    );
    fn div_wide(self, a: Self::Wide, b: Self::Wide) -> Self::Wide;
    fn sub_wide(self, a: Self::Wide, b: Self::Wide) -> Self::Wide;
    fn mul_wide(self, a: Self::Wide, b: Self::Wide) -> Self::Wide;
    fn add_wide(self, a: Self::Wide, b: Self::Wide) -> Self::Wide;
    /// Of a NaN and a number, either.
    fn min_wide(self, a: Self::Wide, b: Self::Wide) -> Self::Wide;
    /// Likewise.
    fn max_wide(self, a: Self::Wide, b: Self::Wide) -> Self::Wide;
    fn abs_wide(self, a: Self::Wide) -> Self::Wide;
    /// `a * b + c`, rounded once or twice.
    fn mul_add_wide(self, a: Self::Wide, b: Self::Wide, c: Self::Wide) -> Self::Wide;
    /// `a - b * c`, rounded once or twice.
    fn less_product(self, a: Self::Wide, b: Self::Wide, c: Self::Wide) -> Self::Wide;
    /// `a * b - c * d`, rounded twice or three times.
    fn cross_wide(self, a: Self::Wide, b: Self::Wide, c: Self::Wide, d: Self::Wide) -> Self::Wide;
    /// One bit for each lane in which `a <= b`.
    fn at_most(self, a: Self::Wide, b: Self::Wide) -> u32;
    /// One bit for each lane in which the least of all is, none of them NaN.
    #[inline(always)]
    fn least(self, a: Self::Wide) -> u32 {
        let mut all = [f32::INFINITY; 8];
        self.store_wide(a, &mut all);
        let least = all.into_iter().fold(f32::INFINITY, f32::min);
        self.at_most(a, self.splat_wide(least))
    }
    /// `a`, negated where `b` is negative.
    fn turn_wide(self, a: Self::Wide, b: Self::Wide) -> Self::Wide;
    /// `a * b - c`, rounded once or twice.
    fn product_less(self, a: Self::Wide, b: Self::Wide, c: Self::Wide) -> Self::Wide;
    /// One bit for each lane in which `a > b`, or `c > d` and `e > f`.
    fn misses(self, ab: [Self::Wide; 2], cd: [Self::Wide; 2], ef: [Self::Wide; 2]) -> u32;
}

/// Rays as boxes want them, at least [`Lanes::MANY`] of them: by axes their pace and where they are at
/// plane 0, as they enter and as they leave, and the range of what is of interest.
pub(crate) struct RayColumns<'a> {
    pub pace: [&'a [f32; 16]; 3],
    pub from: &'a [f32; 16],
    pub enter: [&'a [f32; 16]; 3],
    pub to: &'a [f32; 16],
    pub leave: [&'a [f32; 16]; 3],
}

/// The first eight.
#[inline(always)]
fn eight<T>(all: &[T; 16]) -> &[T; 8] {
    all.first_chunk().expect("there are sixteen")
}

#[inline(always)]
fn eight_mut<T>(all: &mut [T; 16]) -> &mut [T; 8] {
    all.first_chunk_mut().expect("there are sixteen")
}

/// Code to be compiled for an instruction set.
pub(crate) trait Kernel<L> {
    type Out;
    /// Must be `#[inline(always)]`, down to the lanes' operations.
    fn run(self, lanes: L) -> Self::Out;
}
