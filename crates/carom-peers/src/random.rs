//! Random numbers for motions, so that every case is named by a family, a seed and an index.

pub use carom_check::random::Random;

/// Draws that use the platform's own mathematical functions; the engine's code must not.
pub trait RandomMotion {
    /// 10ˣ with x uniform in [low, high).
    fn magnitude(&mut self, low: f64, high: f64) -> f64;

    /// A unit vector in the plane.
    fn direction(&mut self) -> [f64; 2];
}

impl RandomMotion for Random {
    fn magnitude(&mut self, low: f64, high: f64) -> f64 {
        10f64.powf(self.between(low, high))
    }

    fn direction(&mut self) -> [f64; 2] {
        let (sin, cos) = self.between(0.0, core::f64::consts::TAU).sin_cos();
        [cos, sin]
    }
}
