//! What makes an instruction set one: its proof, and kernels compiled for it.

/// A type whose values prove that the processor has these features, and `compiled`
/// and `compiled_apart`, which run a kernel compiled for them.
macro_rules! shell {
    ($(#[$doc:meta])* $name:ident: $($feature:tt),+) => {
        $(#[$doc])*
        #[derive(Clone, Copy)]
        pub struct $name(());

        impl $name {
            /// Asks the processor.
            pub fn detect() -> Option<Self> {
                #[cfg(feature = "std")]
                let there = $(std::arch::is_x86_feature_detected!($feature))&&+;
                #[cfg(not(feature = "std"))]
                let there = cfg!(all($(target_feature = $feature),+));
                there.then_some(Self(()))
            }

            /// Asks nobody.
            ///
            /// # Safety
            /// `detect` has succeeded in this process.
            #[inline(always)]
            pub unsafe fn detected() -> Self {
                Self(())
            }
        }

        #[target_feature($(enable = $feature),+)]
        fn compiled<K: Kernel<$name>>(kernel: K, lanes: $name) -> K::Out {
            kernel.run(lanes)
        }

        #[cold]
        #[inline(never)]
        #[target_feature($(enable = $feature),+)]
        fn compiled_apart<K: Kernel<$name>>(kernel: K, lanes: $name) -> K::Out {
            kernel.run(lanes)
        }
    };
}
pub(super) use shell;
