//! The square root. IEEE 754 rounds it correctly, so its bits are the same in each of these ways.

/// √x.
#[inline(always)]
pub(crate) fn sqrt(x: f64) -> f64 {
    #[cfg(feature = "std")]
    return x.sqrt();
    // The instruction of the device; the function of `libm` takes a hundred.
    #[cfg(target_arch = "nvptx64")]
    return core::f64::math::sqrt(x);
    #[cfg(not(any(feature = "std", target_arch = "nvptx64")))]
    return libm::sqrt(x);
}
