//! Proofs that two bodies cannot touch within a horizon, cheap enough to run on every pair.
//!
//! With f = |d + vt + ht²|² − D², any of three will do:
//!
//! * **sign**: f′/2 = d·v + (v² + 2d·h)t + 3(v·h)t² + 2h²t³ is at least 0 on [0, T], so that the bodies
//!   never approach;
//! * **corridor**: across the direction of v the separation is d × v + t²(h × v), which runs from one
//!   end to the other monotonically; it stays beyond D|v| on one side;
//! * **axis**: along n = d/|d| the separation is a quadratic in t; it stays beyond D.
//!
//! They are written without branches, roots or divisions, so that a loop over a row of pairs becomes
//! vector instructions, each lane with the bits of the scalar.

/// A horizon that stands in for infinity: 0 × ∞ is not a number. In any unit of time.
const LONGEST: f64 = 1e60;

/// Whether two bodies at separation (dx, dy), relative velocity (vx, vy) and half relative
/// acceleration (hx, hy) provably do not touch while approaching within `horizon` (s, perhaps
/// infinite), `distance` (m) being that of their centres in contact.
///
/// `false` says nothing: ask [`crate::first_contact`].
#[inline(always)]
#[allow(clippy::too_many_arguments)] // one scalar per array of a row
pub fn cannot_touch(
    dx: f64,
    dy: f64,
    vx: f64,
    vy: f64,
    hx: f64,
    hy: f64,
    distance: f64,
    horizon: f64,
) -> bool {
    // Selected, not `min`, which has its own rule for NaN and costs three instructions for it.
    let t = if horizon < LONGEST { horizon } else { LONGEST };
    let squared = distance * distance;
    let dd = dx * dx + dy * dy;
    let dv = dx * vx + dy * vy;
    let dh = dx * hx + dy * hy;
    let vv = vx * vx + vy * vy;
    let vh = vx * hx + vy * hy;

    let g1 = vv + 2.0 * dh;
    let g2 = 3.0 * vh;
    let least_g1 = if g1 < 0.0 { g1 } else { 0.0 };
    let least_g2 = if g2 < 0.0 { g2 } else { 0.0 };
    let sign = dv + t * (least_g1 + t * least_g2) >= 0.0;

    let across = dx * vy - dy * vx;
    let across_later = across + (t * t) * (hx * vy - hy * vx);
    let width = squared * vv;
    let corridor = (across * across > width)
        & (across_later * across_later > width)
        & (across * across_later > 0.0);

    // The quadratic |d|² + (d·v)t + (d·h)t² against D|d|, at both ends and at a least point between.
    let reach = squared * dd;
    let later = dd + t * (dv + t * dh);
    let least = 4.0 * dh * dd - dv * dv;
    let least_is_inside = (dv < 0.0) & (dv + 2.0 * (t * dh) > 0.0);
    let least_is_beyond = (least > 0.0) & (least * least > 16.0 * (dh * dh) * reach);
    let axis = (dd > squared)
        & (later > 0.0)
        & (later * later > reach)
        & (!least_is_inside | least_is_beyond);

    sign | corridor | axis
}

/// A row of `L` pairs as structure of arrays: the motions of one body relative to `L` others.
///
/// Lanes that hold no pair are best given `horizon` 0 and `d` far away.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Row<const L: usize> {
    /// Separation, m.
    pub dx: [f64; L],
    /// Separation, m.
    pub dy: [f64; L],
    /// Relative velocity, m/s.
    pub vx: [f64; L],
    /// Relative velocity, m/s.
    pub vy: [f64; L],
    /// Half relative acceleration, m/s².
    pub hx: [f64; L],
    /// Half relative acceleration, m/s².
    pub hy: [f64; L],
    /// Distance of the centres in contact, m.
    pub distance: [f64; L],
    /// The last time of interest, s; may be infinite.
    pub horizon: [f64; L],
}

impl<const L: usize> Row<L> {
    /// For each lane, whether [`cannot_touch`] holds.
    ///
    /// Inlined into its caller, so that a caller compiled for wider vectors gets them.
    #[inline(always)]
    pub fn cannot_touch(&self) -> [bool; L] {
        core::array::from_fn(|i| {
            cannot_touch(
                self.dx[i],
                self.dy[i],
                self.vx[i],
                self.vy[i],
                self.hx[i],
                self.hy[i],
                self.distance[i],
                self.horizon[i],
            )
        })
    }
}

#[cfg(test)]
mod tests {
    use super::cannot_touch;

    fn proved(d: [f64; 2], v: [f64; 2], h: [f64; 2], horizon: f64) -> bool {
        cannot_touch(d[0], d[1], v[0], v[1], h[0], h[1], 1.0, horizon)
    }

    const NEVER: f64 = f64::INFINITY;

    #[test]
    fn bodies_that_separate_cannot_touch() {
        assert!(proved([2.0, 0.0], [1.0, 0.5], [0.0, 0.0], NEVER));
        assert!(proved([1.0, 0.0], [1.0, 0.5], [0.0, 0.0], NEVER));
        assert!(proved([1.0, 0.0], [0.0, 0.0], [0.0, 0.0], NEVER));
        assert!(!proved([1.0, 0.0], [1.0, 0.0], [-1.0, 0.0], NEVER));
        assert!(proved([1.0, 0.0], [1.0, 0.0], [-1.0, 0.0], 0.4));
    }

    #[test]
    fn bodies_that_pass_wide_cannot_touch() {
        assert!(proved([9.0, 1.1], [-2.0, 0.0], [0.0, 0.0], NEVER));
        assert!(!proved([9.0, 0.9], [-2.0, 0.0], [0.0, 0.0], NEVER));
        // bent into the way after three seconds
        assert!(proved([9.0, 1.1], [-2.0, 0.0], [0.0, -0.01], 3.0));
        assert!(!proved([9.0, 1.1], [-2.0, 0.0], [0.0, -0.01], 4.5));
    }

    #[test]
    fn bodies_that_stop_short_or_come_too_late_cannot_touch() {
        assert!(proved([3.0, 0.0], [-2.0, 0.0], [0.51, 0.0], NEVER));
        assert!(!proved([3.0, 0.0], [-2.0, 0.0], [0.49, 0.0], NEVER));
        assert!(proved([3.0, 0.0], [-2.0, 0.0], [0.0, 0.0], 0.99));
        assert!(!proved([3.0, 0.0], [-2.0, 0.0], [0.0, 0.0], 1.01));
    }

    #[test]
    fn nothing_is_proved_of_what_is_not_a_number() {
        assert!(!proved([f64::NAN, 0.0], [-2.0, 0.0], [0.5, 0.0], 1.0));
    }
}
