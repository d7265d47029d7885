//! W. J. Stronge, *Impact Mechanics* (Cambridge University Press 2000), section 5.1: an impact
//! whose contact is compliant along the surface too, so that part of the slip is given back.
//!
//! Two springs, one along the normal and one along the slip, joined to the surface by Coulomb
//! friction. The normal spring turns the ball round in the time π/2ω_n and gives it back the share
//! e of its speed in the time eπ/2ω_n. The tangential one holds or slides:
//!
//! * **stick** from the first touch, where the ball slips little: r < μη²;
//! * **gross slip** to the end, where it slips much;
//! * **slip, stick, slip** between.
//!
//! Symbols: r = |v_t/v_n| at the first touch, β_n = 1 and β_t = 7/2 the inverse mass factors of a
//! sphere against a wall, Ω = ω_t/ω_n the ratio of the two frequencies, η² = β_t/(β_n Ω²),
//! τ = ω_n t. Departure from the book: gross slip also needs r ≥ μβ_t; where eΩ < 1 the book's
//! bound lies below that, and a ball between the two does stick before compression ends.

use super::{Change, Impact};
use crate::math::{acos, asin, atan2, sin_cos, sqrt};
use core::f64::consts::{FRAC_PI_2, PI};

/// β_t of a solid sphere: 1 + mR²/I.
const BETA: f64 = 3.5;

/// Ω below 1 or above 2 is no elastic solid's (Poisson's ratio ½ and beyond); it is taken as the
/// nearer bound. With Ω ≤ 2 a ball that sticks at the first touch still sticks at full compression.
const RATIOS: (f64, f64) = (1.0, 2.0);

/// What one impact changes, with restitution `e` along the contact's normal, friction `mu`, and
/// `ratio` the tangential frequency over the normal one.
pub(super) fn resolve(impact: &Impact, e: f64, mu: f64, ratio: f64) -> Change {
    let slip = impact.nose_slip();
    let speed = sqrt(slip.length_squared());
    let approach = impact.velocity.x * impact.cos;
    let normal = (1.0 + e) * approach;
    let share = if speed > 0.0 && mu > 0.0 {
        let left = mu * approach * slip_after(speed / (mu * approach), e, ratio);
        (left - speed) / (BETA * speed)
    } else {
        0.0
    };
    impact.change(impact.impulse(normal, slip * share))
}

/// The slip when the ball leaves, in units of μv_n and in the direction of the first slip, which
/// is `rho` in the same units.
fn slip_after(rho: f64, e: f64, ratio: f64) -> f64 {
    let omega = ratio.clamp(RATIOS.0, RATIOS.1);
    let eta2 = BETA / (omega * omega);
    let k = e * omega;
    let sticks_late = k > 1.0 && rho < (1.0 + e) * BETA - eta2 / e;
    if rho >= BETA && !sticks_late {
        return rho - BETA * (1.0 + e);
    }
    let (amplitude, zero) = hold(rho, e, omega, eta2);
    // Phase of the spring, past its unloaded state, when the ball leaves: beyond 0 it has been
    // unloaded and drawn the other way.
    let phase = k * FRAC_PI_2 - omega * zero;
    let side = if phase > 0.0 { 1.0 } else { -1.0 };
    let (cos_z, cos_phase) = release(amplitude, phase.abs(), side * k);
    side * BETA * e * (1.0 - cos_z) - BETA / omega * amplitude * cos_phase
}

/// The tangential spring while the contact holds: its force, in units of μ times the largest
/// normal force, is A sin Ω(y₀ − y), y the time since full compression. Returns A and y₀.
fn hold(rho: f64, e: f64, omega: f64, eta2: f64) -> (f64, f64) {
    if rho <= eta2 {
        // From the first touch: v_t = v_t0 cos Ωτ.
        (rho / (eta2 * omega), PI / omega - FRAC_PI_2)
    } else if rho <= BETA {
        // Since cos τ₁ = (β − r/μ)/(β − η²), during compression.
        let cos = ((BETA - rho) / (BETA - eta2)).min(1.0);
        let sin = sqrt((1.0 - cos) * (1.0 + cos));
        spring(sin, -cos / omega, acos(cos) - FRAC_PI_2, omega)
    } else {
        // Since sin x₁ = (r/μ − β)/(eβ − η²/e), during restitution; x = y/e.
        let sin = ((rho - BETA) / (e * BETA - eta2 / e)).min(1.0);
        let cos = sqrt((1.0 - sin) * (1.0 + sin));
        spring(cos, sin / (e * omega), e * asin(sin), omega)
    }
}

/// Amplitude and zero of A sin Ω(y₀ − y) from A sin and A cos of its phase at time `y`.
fn spring(sin: f64, cos: f64, y: f64, omega: f64) -> (f64, f64) {
    (sqrt(sin * sin + cos * cos), y + atan2(sin, cos) / omega)
}

/// When friction lets go: the first z from full compression, counted back from the end (z = π/2
/// to 0), at which sin z = A sin(`phase` − `k`z). Returns cos z and cos(phase − kz).
///
/// The slip that follows from z is stationary at the root, so an error of 1e-8 in z is one of
/// 1e-16 in the slip.
fn release(amplitude: f64, phase: f64, k: f64) -> (f64, f64) {
    /// Half the digits of a double: the last step's length at which Newton stops.
    const CLOSE: f64 = 1e-8;
    /// Bisection alone ends in about 50.
    const MOST_STEPS: u32 = 60;
    let (mut low, mut high) = (0.0, FRAC_PI_2);
    if k > 0.0 {
        high = high.min(phase / k);
    }
    let mut z = (amplitude * phase / (1.0 + amplitude * k)).clamp(low, high);
    for _ in 0..MOST_STEPS {
        let (sin_z, cos_z) = sin_cos(z);
        let (sin_p, cos_p) = sin_cos(phase - k * z);
        let excess = sin_z - amplitude * sin_p;
        if excess > 0.0 {
            high = z;
        } else {
            low = z;
        }
        let next = z - excess / (cos_z + k * amplitude * cos_p);
        let inside = next >= low && next <= high;
        let step = if inside { next - z } else { 0.5 * (low + high) - z };
        if step.abs() < CLOSE {
            // The cosines one step on, to second order.
            let turn = k * step;
            return (
                cos_z - step * sin_z - 0.5 * step * step * cos_z,
                cos_p + turn * sin_p - 0.5 * turn * turn * cos_p,
            );
        }
        z += step;
    }
    let (_, cos_z) = sin_cos(z);
    let (_, cos_p) = sin_cos(phase - k * z);
    (cos_z, cos_p)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The same two springs stepped through time, with friction as a plastic limit; error about
    /// the step's length.
    fn slip_after_by_steps(rho: f64, e: f64, omega: f64, dt: f64) -> f64 {
        let (mut slip, mut spring, mut time) = (rho, 0.0_f64, 0.0);
        let end = FRAC_PI_2 * (1.0 + e);
        while time < end {
            let middle = time + 0.5 * dt;
            let normal = if middle < FRAC_PI_2 {
                sin_cos(middle).0
            } else {
                sin_cos((middle - FRAC_PI_2) / e).1.max(0.0)
            };
            let limit = BETA * normal / (omega * omega);
            spring = (spring + slip * dt).clamp(-limit, limit);
            slip -= omega * omega * spring * dt;
            time += dt;
        }
        slip
    }

    #[test]
    fn every_regime_agrees_with_the_two_springs_stepped_through_time() {
        /// Steps of 2e-5 in ω_n t leave an error of that order in slips of order 1.
        const STEP: f64 = 2e-5;
        const TOLERANCE: f64 = 4e-4;
        for e in [0.02, 0.3, 0.55, 0.7, 0.85, 1.0] {
            for omega in [1.05, 1.3, 1.7, 1.95] {
                for i in 0..24 {
                    let rho = 0.05 + 0.35 * f64::from(i);
                    let ours = slip_after(rho, e, omega);
                    let stepped = slip_after_by_steps(rho, e, omega, STEP);
                    assert!(
                        (ours - stepped).abs() < TOLERANCE,
                        "e {e}, Ω {omega}, r/μ {rho}: {ours} against {stepped}"
                    );
                }
            }
        }
    }

    #[test]
    fn the_slip_is_continuous_across_the_regimes() {
        const GAP: f64 = 1e-9;
        for e in [0.0, 0.3, 0.7, 0.9, 1.0] {
            for omega in [1.2, 1.7, 1.9] {
                let eta2 = BETA / (omega * omega);
                for edge in [eta2, BETA, (1.0 + e) * BETA - eta2 / e] {
                    if edge > GAP && edge.is_finite() {
                        let jump =
                            slip_after(edge + GAP, e, omega) - slip_after(edge - GAP, e, omega);
                        assert!(jump.abs() < 20.0 * GAP, "e {e}, Ω {omega}, r/μ {edge}: {jump}");
                    }
                }
            }
        }
    }
}
