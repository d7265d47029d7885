//! Comparison of numbers in tests.

/// Fails, with both numbers, unless `ours` is within `tolerance` of `expected`.
#[track_caller]
pub(crate) fn assert_near(ours: f64, expected: f64, tolerance: f64) {
    assert!(
        (ours - expected).abs() <= tolerance,
        "ours {ours}, expected {expected}: differ by {:e}, more than {tolerance:e}",
        (ours - expected).abs()
    );
}
