//! Vector instructions.

use std::sync::atomic::{AtomicU8, Ordering};

/// Number in [`InstructionSet::ALL`] of the widest instructions that may be used.
static WIDEST: AtomicU8 = AtomicU8::new(u8::MAX);

crate::named_enum! {
    /// Vector instructions that the right-hand side was compiled for, from the narrowest.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
    pub enum InstructionSet {
        /// Instructions of every processor of the target.
        Baseline = "baseline",
        /// 256-bit vectors (x86-64).
        Avx2 = "avx2",
        /// 512-bit vectors (x86-64).
        Avx512 = "avx512",
    }
}

impl InstructionSet {
    /// The widest that this processor has and this build was compiled for.
    pub(crate) fn detect() -> Self {
        #[cfg(all(target_arch = "x86_64", not(any(test, debug_assertions))))]
        {
            if std::arch::is_x86_feature_detected!("avx512f")
                && std::arch::is_x86_feature_detected!("avx512vl")
                && std::arch::is_x86_feature_detected!("avx512dq")
            {
                return Self::Avx512;
            }
            if std::arch::is_x86_feature_detected!("avx2") {
                return Self::Avx2;
            }
        }
        Self::Baseline
    }

    /// The widest that this processor has and [`Self::limit_to`] admits: what runs are
    /// computed with.
    pub fn chosen() -> Self {
        let limit = usize::from(WIDEST.load(Ordering::Relaxed)).min(Self::ALL.len() - 1);
        Self::detect().min(Self::ALL[limit])
    }

    /// Computes with nothing wider in the whole process from now on. Results have the same
    /// bits; only their time differs.
    pub fn limit_to(self) {
        WIDEST.store(self as u8, Ordering::Relaxed);
    }

    /// Whether this processor has it.
    pub fn available(self) -> bool {
        self <= Self::detect()
    }
}

/// Evaluates a call compiled for the instructions of a set; its arguments are named as where it stands.
/// Builds without optimisation and unit tests have the baseline alone, which compiles in a third of the time
/// and has the same bits.
macro_rules! with_instructions {
    ($isa:expr, [$($generics:tt)*]($($argument:ident: $type:ty),*) $(-> $output:ty)?, $call:expr) => {{
        #[inline(always)]
        fn baseline<$($generics)*>($($argument: $type),*) $(-> $output)? {
            $call
        }
        #[cfg(all(target_arch = "x86_64", not(any(test, debug_assertions))))]
        #[target_feature(enable = "avx2")]
        fn avx2<$($generics)*>($($argument: $type),*) $(-> $output)? {
            $call
        }
        #[cfg(all(target_arch = "x86_64", not(any(test, debug_assertions))))]
        #[target_feature(enable = "avx512f,avx512vl,avx512dq")]
        fn avx512<$($generics)*>($($argument: $type),*) $(-> $output)? {
            $call
        }
        match $isa {
            #[cfg(all(target_arch = "x86_64", not(any(test, debug_assertions))))]
            $crate::simd::InstructionSet::Baseline => baseline($($argument),*),
            // SAFETY: `RightHandSide::build` and `InstructionSet::chosen` admit only what the processor has.
            #[cfg(all(target_arch = "x86_64", not(any(test, debug_assertions))))]
            $crate::simd::InstructionSet::Avx2 => unsafe { avx2($($argument),*) },
            // SAFETY: `RightHandSide::build` and `InstructionSet::chosen` admit only what the processor has.
            #[cfg(all(target_arch = "x86_64", not(any(test, debug_assertions))))]
            $crate::simd::InstructionSet::Avx512 => unsafe { avx512($($argument),*) },
            #[cfg(any(not(target_arch = "x86_64"), test, debug_assertions))]
            _ => baseline($($argument),*),
        }
    }};
}
pub(crate) use with_instructions;
