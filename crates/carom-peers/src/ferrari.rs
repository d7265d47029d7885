//! The textbook closed form: Ferrari's two quadratics, by Cardano's root of the resolvent cubic.
//!
//! As in handbooks: in real arithmetic, without refinement.

use crate::quartic::{Quartic, Roots};

/// The real roots of a quartic with c₄ ≠ 0.
pub fn real_roots(quartic: &Quartic) -> Roots {
    let [a, b, c, d] = quartic.monic();
    // x = y − a/4 leaves y⁴ + py² + qy + r.
    let shift = 0.25 * a;
    let p = b - 6.0 * shift * shift;
    let q = c - 2.0 * b * shift + 8.0 * shift * shift * shift;
    let r = d - c * shift + b * shift * shift - 3.0 * shift * shift * shift * shift;
    let mut roots = Roots::default();
    let m = resolvent_root(p, q, r);
    if q == 0.0 || m <= 0.0 {
        let discriminant = 0.25 * p * p - r;
        if discriminant >= 0.0 {
            for square in [-0.5 * p + discriminant.sqrt(), -0.5 * p - discriminant.sqrt()] {
                if square >= 0.0 {
                    roots.push(square.sqrt() - shift);
                    roots.push(-square.sqrt() - shift);
                }
            }
        }
        return roots;
    }
    let slope = (2.0 * m).sqrt();
    for sign in [1.0, -1.0] {
        // y² − sign·slope·y + (p/2 + m + sign·q/(2 slope))
        let discriminant = -0.5 * m - 0.5 * p - sign * q / (2.0 * slope);
        if discriminant >= 0.0 {
            let middle = 0.5 * sign * slope;
            roots.push(middle + discriminant.sqrt() - shift);
            roots.push(middle - discriminant.sqrt() - shift);
        }
    }
    roots
}

/// The largest real root of m³ + pm² + (p²/4 − r)m − q²/8.
fn resolvent_root(p: f64, q: f64, r: f64) -> f64 {
    let third = p / 3.0;
    let linear = 0.25 * p * p - r;
    let big_q = third * third - linear / 3.0;
    let big_r = third * third * third - 0.5 * third * linear - q * q / 16.0;
    if big_r * big_r < big_q * big_q * big_q {
        let angle = (big_r / (big_q * big_q * big_q).sqrt()).acos();
        let turn = core::f64::consts::TAU / 3.0;
        -2.0 * big_q.sqrt() * (angle / 3.0 + turn).cos() - third
    } else {
        let root = (big_r * big_r - big_q * big_q * big_q).sqrt();
        let s = -(big_r.abs() + root).cbrt().copysign(big_r);
        let t = if s == 0.0 { 0.0 } else { big_q / s };
        s + t - third
    }
}
