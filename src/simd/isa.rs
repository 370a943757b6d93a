//! Which instruction set runs: found out once, or forced for tests.

use core::sync::atomic::{AtomicU8, Ordering};

#[cfg(all(target_arch = "aarch64", target_feature = "neon"))]
use super::aarch64::Neon;
use super::lanes::{Kernel, Lanes};
use super::portable::Portable;
#[cfg(target_arch = "x86_64")]
use super::x86::{Avx2, Avx512};

/// An instruction set that queries can run on. Results do not depend on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Isa {
    /// What every processor of the target has.
    Portable = 1,
    /// AVX2 and FMA.
    Avx2 = 2,
    /// AVX-512 (F, VL, DQ).
    Avx512 = 3,
    /// NEON, which nearly every AArch64 processor has.
    Neon = 4,
}

impl Isa {
    /// All of them; of those that a processor can have, the best last.
    pub const ALL: [Self; 4] = [Self::Portable, Self::Avx2, Self::Avx512, Self::Neon];

    /// Lower-case name.
    #[must_use]
    pub const fn name(self) -> &'static core::ffi::CStr {
        match self {
            Self::Portable => c"portable",
            Self::Avx2 => c"avx2",
            Self::Avx512 => c"avx512",
            Self::Neon => c"neon",
        }
    }

    fn available(self) -> bool {
        match self {
            Self::Portable => true,
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => Avx2::detect().is_some(),
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 => Avx512::detect().is_some(),
            #[cfg(not(target_arch = "x86_64"))]
            Self::Avx2 | Self::Avx512 => false,
            Self::Neon => cfg!(all(target_arch = "aarch64", target_feature = "neon")),
        }
    }
}

/// 0 until the first query, then the set in use, which is available.
static CHOSEN: AtomicU8 = AtomicU8::new(0);

#[cold]
fn choose() -> u8 {
    let best = Isa::ALL.into_iter().rfind(|set| set.available()).unwrap_or(Isa::Portable);
    // Threads that race here store the same value.
    CHOSEN.store(best as u8, Ordering::Relaxed);
    best as u8
}

#[inline(always)]
fn chosen() -> u8 {
    match CHOSEN.load(Ordering::Relaxed) {
        0 => choose(),
        set => set,
    }
}

/// The instruction set in use by this process.
#[must_use]
pub fn isa() -> Isa {
    let set = chosen();
    Isa::ALL.into_iter().find(|&i| i as u8 == set).unwrap_or(Isa::Portable)
}

/// Makes all queries of the process use `isa`, for tests and comparisons.
/// `false`, and no change, if the processor does not have it.
pub fn force_isa(isa: Isa) -> bool {
    let there = isa.available();
    if there {
        CHOSEN.store(isa as u8, Ordering::Relaxed);
    }
    there
}

/// A kernel for every instruction set.
pub(crate) trait AnyKernel: Sized {
    type Out;
    /// On x86-64 the best set that it is compiled for; on better ones it runs on that.
    /// What is for measuring need not be fast, and would make the library larger.
    const BEST: Isa;
    fn run_on<L: Lanes>(self, lanes: L) -> Self::Out;
    /// Where none of the other instruction sets is there.
    #[inline(always)]
    fn run_portable(self) -> Self::Out {
        portably(self)
    }
}

/// Runs a kernel on what every processor has.
#[inline(always)]
pub(crate) fn portably<K: AnyKernel>(kernel: K) -> K::Out {
    Portable.run(On(kernel))
}

struct On<K>(K);

impl<K: AnyKernel, L: Lanes> Kernel<L> for On<K> {
    type Out = K::Out;
    #[inline(always)]
    fn run(self, lanes: L) -> K::Out {
        self.0.run_on(lanes)
    }
}

/// Runs a kernel on the instruction set in use.
#[inline(always)]
pub(crate) fn dispatch<K: AnyKernel>(kernel: K) -> K::Out {
    let set = chosen();
    #[cfg(target_arch = "x86_64")]
    {
        if set == Isa::Avx512 as u8 && K::BEST as u8 >= Isa::Avx512 as u8 {
            // SAFETY: the set in use is available.
            return unsafe { Avx512::detected() }.run(On(kernel));
        }
        if set >= Isa::Avx2 as u8 && K::BEST as u8 >= Isa::Avx2 as u8 {
            // SAFETY: the set in use is available, AVX2 with AVX-512.
            return unsafe { Avx2::detected() }.run(On(kernel));
        }
    }
    #[cfg(all(target_arch = "aarch64", target_feature = "neon"))]
    if set == Isa::Neon as u8 {
        return Neon.run(On(kernel));
    }
    let _ = (set, K::BEST);
    kernel.run_portable()
}
