//! The first contact of two balls whose relative path is quadratic in time.

/// Relative motion: separation d + v t + h t², h being half the relative acceleration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion<const N: usize> {
    /// Separation of the centres at t = 0, m.
    pub d: [f64; N],
    /// Relative velocity at t = 0, m/s.
    pub v: [f64; N],
    /// Half the relative acceleration, m/s².
    pub h: [f64; N],
}

/// First t in [0, `horizon`] at which the centres are within `distance` and approaching.
pub fn first_contact<const N: usize>(
    motion: &Motion<N>,
    distance: f64,
    horizon: f64,
) -> Option<f64> {
    let _ = (motion, distance, horizon);
    None
}
