//! The floating-point environment of the caller.
//!
//! A renderer may have set flush-to-zero, denormals-are-zero or another
//! rounding mode, or have unmasked exceptions; results must not change. Each call looks at the control
//! register, and only if it differs from the default sets the default and
//! restores the caller's afterwards. Cost when it does not differ: one store and
//! one load.
//!
//! # Safety
//! The only instructions used store and load the control register; the caller's
//! value is put back on every way out.

/// Runs `f` with round-to-nearest, without flushing of denormals, and with no exception
/// that stops the program.
#[inline(always)]
pub(crate) fn with_default<R>(f: impl FnOnce() -> R) -> R {
    let caller = control::get();
    if control::is_default(caller) { f() } else { switched(caller, f) }
}

#[cold]
#[inline(never)]
fn switched<R>(caller: control::Word, f: impl FnOnce() -> R) -> R {
    struct Restore(control::Word);
    impl Drop for Restore {
        fn drop(&mut self) {
            control::set(self.0);
        }
    }
    let _restore = Restore(caller);
    control::set(control::defaulted(caller));
    f()
}

#[cfg(any(target_arch = "x86_64", all(target_arch = "x86", target_feature = "sse")))]
mod control {
    use core::arch::asm;

    pub type Word = u32;
    /// Flush to zero, denormals are zero, rounding control.
    const MODES: Word = 0x8000 | 0x0040 | 0x6000;
    /// Exceptions that are not to stop the program: idle lanes may divide by zero.
    const MASKS: Word = 0x1f80;

    #[inline(always)]
    pub fn get() -> Word {
        let mut word = 0;
        // SAFETY: stores MXCSR to a local variable.
        unsafe { asm!("stmxcsr [{}]", in(reg) &raw mut word, options(nostack, preserves_flags)) };
        word
    }

    pub fn set(word: Word) {
        // SAFETY: loads a value that came from MXCSR, with modes as by default or as they were.
        unsafe { asm!("ldmxcsr [{}]", in(reg) &raw const word, options(nostack, preserves_flags)) };
    }

    #[inline(always)]
    pub fn is_default(word: Word) -> bool {
        word & (MODES | MASKS) == MASKS
    }

    pub fn defaulted(word: Word) -> Word {
        word & !MODES | MASKS
    }
}

#[cfg(target_arch = "aarch64")]
mod control {
    use core::arch::asm;

    pub type Word = u64;
    /// Flush to zero (FZ, FZ16) and rounding control.
    const MODES: Word = 1 << 24 | 1 << 19 | 3 << 22;

    #[inline(always)]
    pub fn get() -> Word {
        let word;
        // SAFETY: reads FPCR.
        unsafe { asm!("mrs {}, fpcr", out(reg) word, options(nomem, nostack, preserves_flags)) };
        word
    }

    pub fn set(word: Word) {
        // SAFETY: writes a value that came from FPCR, with modes as by default or as they were.
        unsafe { asm!("msr fpcr, {}", in(reg) word, options(nostack, preserves_flags)) };
    }

    #[inline(always)]
    pub fn is_default(word: Word) -> bool {
        word & MODES == 0
    }

    pub fn defaulted(word: Word) -> Word {
        word & !MODES
    }
}

#[cfg(not(any(
    target_arch = "x86_64",
    target_arch = "aarch64",
    all(target_arch = "x86", target_feature = "sse")
)))]
mod control {
    /// WebAssembly has no modes; elsewhere the default environment is required.
    pub type Word = ();

    #[inline(always)]
    pub fn get() -> Word {}

    pub fn set((): Word) {}

    #[inline(always)]
    pub fn is_default((): Word) -> bool {
        true
    }

    pub fn defaulted((): Word) -> Word {}
}
