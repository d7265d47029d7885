//! What this build of the engine is: its version, the version of its results, and how it was compiled.

use alloc::vec::Vec;

/// Name and version, as traces, records of frames and records of matches have them.
pub const ENGINE: &str = concat!("carom ", env!("CARGO_PKG_VERSION"));

/// The version of the results. Two engines with the same one compute the same bits for the same input.
///
/// Purpose: users who stored a result can see whether they would get it again. It rises by one with
/// every change of a golden; `make goldens` refuses to write other results under the same number.
pub const RESULTS_VERSION: u32 = 1;

/// The commit from which this was built, if the variable `CAROM_COMMIT` had it during the build.
pub const COMMIT: Option<&str> = option_env!("CAROM_COMMIT");

/// The features with which this was compiled.
pub fn features() -> Vec<&'static str> {
    [("std", cfg!(feature = "std")), ("json", cfg!(feature = "json"))]
        .into_iter()
        .chain([("parallel", cfg!(feature = "parallel")), ("peers", cfg!(feature = "peers"))])
        .filter_map(|(name, is_on)| is_on.then_some(name))
        .collect()
}

/// The widest vector instructions that the event loop uses here: those of the build's target, or
/// AVX2 if this processor has it. The bits are the same with each.
pub fn vector_path() -> &'static str {
    if cfg!(target_feature = "avx512f") {
        "AVX-512"
    } else if cfg!(target_feature = "avx2") || crate::math::has_wide_vectors() {
        "AVX2"
    } else if cfg!(target_feature = "sse2") {
        "SSE2"
    } else if cfg!(target_feature = "neon") {
        "NEON"
    } else if cfg!(target_feature = "simd128") {
        "WebAssembly SIMD"
    } else {
        "plain"
    }
}

#[cfg(test)]
mod tests {
    use super::{ENGINE, features};

    #[test]
    fn the_engine_is_named_with_its_version() {
        assert_eq!(ENGINE, format!("carom {}", env!("CARGO_PKG_VERSION")));
    }

    #[test]
    fn a_feature_is_listed_if_it_is_compiled_in() {
        assert_eq!(features().contains(&"json"), cfg!(feature = "json"));
        assert_eq!(features().contains(&"std"), cfg!(feature = "std"));
    }

    #[test]
    #[cfg(all(target_arch = "x86_64", feature = "std"))]
    fn a_processor_with_avx2_uses_at_least_avx2() {
        let wide = matches!(super::vector_path(), "AVX2" | "AVX-512");
        assert_eq!(wide, std::is_x86_feature_detected!("avx2"));
    }
}
