//! The first downward crossing of a scalar gap that is quadratic in time.

/// First t in [0, `horizon`] with f(t) = c₀ + c₁t + c₂t² ≤ 0 and f′(t) < 0, or `None`.
pub fn first_crossing(c0: f64, c1: f64, c2: f64, horizon: f64) -> Option<f64> {
    let _ = (c0, c1, c2, horizon);
    None
}
