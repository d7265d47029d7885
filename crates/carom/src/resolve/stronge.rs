//! W. J. Stronge, *Impact Mechanics* (Cambridge University Press 2000), section 5.1: an impact
//! between surfaces with tangential compliance, which give part of the slip back. The surface of a
//! rubber ball that is dragged sideways springs back; phenolic balls and cushions do so slightly.
//!
//! Two springs join the bodies at the contact. The stiffness of the normal spring rises in the
//! restitution phase, so that the separation speed is e times the approach speed. The tangential
//! spring slides over the surface when its force exceeds μ times the normal force. τ is the time in
//! radians of the normal spring and ω the ratio of the tangential to the normal frequency:
//!
//! * normal force ∝ dν/dτ = sin τ for τ < π/2 (compression), sin ψ after it, where
//!   ψ = π − y runs from π/2 to π at rate 1/e; ν is the normal impulse per approach speed,
//!   1 − cos τ, then 1 + e·cos y, at last 1 + e;
//! * while the surfaces slide, the slip x (in units of μ × approach speed) falls at β·dν/dτ;
//! * while they stick, x oscillates: x″ = −ω²x.
//!
//! β = 7/2 for a homogeneous sphere, both against a wall and against another sphere (with the
//! relative velocities and the reduced mass), and η² = β/ω² is the ratio of the stiffnesses.
//!
//! The surfaces stick from the first touch (x ≤ η²), or slide first and stick later, or slide to
//! the end. Departure from the book: sliding to the end also needs x ≥ β. Where e·ω < 1 the book's
//! bound, (1 + e)β − η²/e, is smaller than β, and surfaces between the two bounds do stick before
//! compression ends.

use crate::math::{acos, sin_cos, sqrt};
use core::f64::consts::FRAC_PI_2;

/// β: change of slip per tangential impulse, divided by the change of approach speed per normal
/// impulse.
pub(super) const BETA: f64 = 3.5;

/// Accuracy of the instant of the last slip, rad. The final slip is stationary there, so its error
/// is the square of this number, less than a rounding error.
const LAST_SLIP_ACCURACY: f64 = 1e-8;

/// The most steps of the search for that instant. It converges cubically, in two or three steps.
const LAST_SLIP_STEPS: usize = 30;

/// An impact in quantities at the contact point.
#[derive(Clone, Copy, Debug)]
pub struct Impact {
    /// Normal approach speed, m/s, > 0.
    pub approach: f64,
    /// Tangential slip speed, m/s, ≥ 0.
    pub slip: f64,
    /// Coefficient of normal restitution e.
    pub restitution: f64,
    /// Coefficient of friction μ.
    pub friction: f64,
    /// ω = ω_t/ω_n, from 1 to 2 (1.70 for Poisson's ratio 0.3: η² = (2 − ν)/(2 − 2ν)).
    pub frequency_ratio: f64,
}

/// The instant at which the surfaces begin to stick, in radians of the normal spring.
struct Stick {
    /// Time from this instant to the end of the impact.
    remaining: f64,
    /// Slip x.
    slip: f64,
    /// dx/dτ.
    rate: f64,
}

impl Impact {
    /// The slip speed after the impact along the line of the initial slip, m/s; negative if the
    /// surfaces have sprung back.
    pub fn final_slip(&self) -> f64 {
        let unit = self.friction * self.approach;
        if unit == 0.0 {
            return self.slip;
        }
        let slip = self.slip / unit;
        let last = match self.stick(slip) {
            None => slip - BETA * (1.0 + self.restitution),
            // The spring can only give back its energy. The limit also holds against rounding
            // errors.
            Some(stick) => self.slip_at_end(&stick).clamp(-slip, slip),
        };
        last * unit
    }

    /// The instant at which the surfaces first stick; `None` if they slide all the time.
    fn stick(&self, slip: f64) -> Option<Stick> {
        let e = self.restitution;
        let eta_squared = BETA / (self.frequency_ratio * self.frequency_ratio);
        let length = FRAC_PI_2 * (1.0 + e);
        if slip <= eta_squared {
            return Some(Stick { remaining: length, slip, rate: 0.0 });
        }
        // In compression the force of the sliding spring becomes small enough where x = η² cos τ …
        if slip <= BETA {
            let cos = (slip - BETA) / (eta_squared - BETA);
            return Some(Stick {
                remaining: length - acos(cos),
                slip: slip - BETA * (1.0 - cos),
                rate: -BETA * sqrt(1.0 - cos * cos),
            });
        }
        // … and in restitution where x = −(η²/e) cos y.
        let sweep = e * BETA - eta_squared / e;
        if e == 0.0 || slip - BETA >= sweep {
            return None;
        }
        let cos = (slip - BETA) / sweep;
        Some(Stick {
            remaining: e * acos(cos),
            slip: slip - BETA * (1.0 + e * cos),
            rate: -BETA * sqrt(1.0 - cos * cos),
        })
    }

    /// The slip at the end of the impact. The sticking surfaces always slide again before the
    /// normal force ends.
    fn slip_at_end(&self, stick: &Stick) -> f64 {
        let (e, omega) = (self.restitution, self.frequency_ratio);
        let oscillate = |since: f64| {
            let (sin, cos) = sin_cos(omega * since);
            let quarter = stick.rate / omega;
            (stick.slip * cos + quarter * sin, omega * (quarter * cos - stick.slip * sin))
        };
        let (mut x, mut rate) = oscillate(stick.remaining);
        // The sign of the spring's force at the end is the direction of the last slip.
        let side = if rate > 0.0 { 1.0 } else { -1.0 };
        let longest =
            if e * FRAC_PI_2 <= stick.remaining { FRAC_PI_2 } else { stick.remaining / e };
        let (mut sin, mut cos) = (0.0, 1.0);
        let (mut y, mut low, mut high) = (0.0, 0.0, longest);
        for _ in 0..LAST_SLIP_STEPS {
            let gap = BETA * sin - side * rate;
            let slope = BETA * cos - side * e * omega * omega * x;
            let bend = side * e * e * omega * omega * rate - BETA * sin;
            if gap < 0.0 {
                low = y
            } else {
                high = y
            }
            let halley = 2.0 * gap * slope / (2.0 * slope * slope - gap * bend);
            if halley.abs() < LAST_SLIP_ACCURACY {
                break;
            }
            let newton = y - halley;
            y = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            (sin, cos) = sin_cos(y);
            (x, rate) = oscillate(stick.remaining - e * y);
        }
        x + side * BETA * e * (1.0 - cos)
    }
}

#[cfg(test)]
mod tests {
    use super::{BETA, Impact};
    use crate::math::sin;
    use core::f64::consts::{FRAC_PI_2, PI};

    fn final_slip(slip: f64, restitution: f64, friction: f64, frequency_ratio: f64) -> f64 {
        Impact { approach: 1.0, slip, restitution, friction, frequency_ratio }.final_slip()
    }

    /// The same two springs in small steps of time: the force of the tangential spring changes with
    /// the slip and is limited to ±μ times the normal force.
    fn stepped(slip: f64, e: f64, friction: f64, omega: f64) -> f64 {
        const STEPS: u32 = 40_000;
        let end = FRAC_PI_2 * (1.0 + e);
        let step = end / f64::from(STEPS);
        let (mut x, mut force) = (slip / friction, 0.0);
        for n in 0..STEPS {
            let tau = (f64::from(n) + 0.5) * step;
            let normal = if tau < FRAC_PI_2 { sin(tau) } else { sin(PI - (end - tau) / e) };
            let held: f64 = force + omega * omega * x * step;
            force = held.clamp(-BETA * normal, BETA * normal);
            x -= force * step;
        }
        x * friction
    }

    #[test]
    fn the_closed_form_agrees_with_the_springs_integrated_in_small_steps() {
        for e in [0.02, 0.3, 0.55, 0.7, 0.85, 0.95, 1.0] {
            for omega in [1.05, 1.4, 1.7, 1.95] {
                for n in 1..40 {
                    let slip = 0.05 * f64::from(n);
                    let (ours, stepped) =
                        (final_slip(slip, e, 0.2, omega), stepped(slip, e, 0.2, omega));
                    assert!(
                        (ours - stepped).abs() < 1e-4,
                        "e {e} ω {omega} slip {slip}: {ours} stepped {stepped}"
                    );
                }
            }
        }
    }

    #[test]
    fn cu_11_final_slip_of_pooltools_stronge_cushion() {
        for (slip, expected) in [
            (0.05, -0.00700),
            (0.2, 0.02279),
            (0.4, 0.19084),
            (0.8, 0.38319),
            (1.2, 0.09500),
            (1.6, -0.30500),
        ] {
            let ours = -final_slip(slip, 0.85, 0.2, 1.7);
            assert!((ours - expected).abs() < 1e-4, "slip {slip}: {ours}, expected {expected}");
        }
    }

    #[test]
    fn final_slip_is_continuous_and_never_longer_than_the_initial_slip() {
        for e in [0.0, 0.1, 0.5, 0.59, 0.85, 1.0] {
            let mut last = 0.0;
            for n in 0..20_000 {
                let slip = 1e-4 * f64::from(n);
                let now = final_slip(slip, e, 0.2, 1.7);
                assert!(now.abs() <= slip && (now - last).abs() < 1e-3, "e {e} slip {slip}");
                last = now;
            }
        }
    }
}
