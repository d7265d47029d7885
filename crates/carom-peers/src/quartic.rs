//! Contacts by roots: expand the quartic and take its smallest root.

use carom_roots::Motion;

/// Up to four real roots, in any order.
#[derive(Clone, Copy, Debug, Default)]
pub struct Roots {
    list: [f64; 4],
    count: usize,
}

impl Roots {
    /// Adds a root.
    pub fn push(&mut self, root: f64) {
        self.list[self.count] = root;
        self.count += 1;
    }

    /// The real roots of x² + αx + β, without cancellation.
    pub fn push_quadratic(&mut self, alpha: f64, beta: f64) {
        let half = -0.5 * alpha;
        let discriminant = half * half - beta;
        if discriminant < 0.0 {
            return;
        }
        let larger = half + discriminant.sqrt().copysign(half);
        self.push(larger);
        self.push(if larger == 0.0 { 0.0 } else { beta / larger });
    }

    /// The roots.
    pub fn as_slice(&self) -> &[f64] {
        &self.list[..self.count]
    }
}

/// c₀ + c₁t + c₂t² + c₃t³ + c₄t⁴.
#[derive(Clone, Copy, Debug)]
pub struct Quartic(pub [f64; 5]);

impl Quartic {
    /// |d + vt + ht²|² − D².
    pub fn of_gap(motion: &Motion<2>, distance: f64) -> Self {
        let Motion { d, v, h } = motion;
        let dot = |a: &[f64; 2], b: &[f64; 2]| a[0] * b[0] + a[1] * b[1];
        Quartic([
            dot(d, d) - distance * distance,
            2.0 * dot(d, v),
            dot(v, v) + 2.0 * dot(d, h),
            2.0 * dot(v, h),
            dot(h, h),
        ])
    }

    /// The first derivative.
    pub fn rate(&self, t: f64) -> f64 {
        let [_, c1, c2, c3, c4] = self.0;
        c1 + t * (2.0 * c2 + t * (3.0 * c3 + t * (4.0 * c4)))
    }

    /// (a, b, c, d) of x⁴ + ax³ + bx² + cx + d.
    pub fn monic(&self) -> [f64; 4] {
        let [c0, c1, c2, c3, c4] = self.0;
        [c3 / c4, c2 / c4, c1 / c4, c0 / c4]
    }
}

/// The real roots. If the leading coefficient is zero, the quartic is solved as a quadratic.
pub fn real_roots(quartic: &Quartic, solve: impl FnOnce(&Quartic) -> Roots) -> Roots {
    let [c0, c1, c2, _, c4] = quartic.0;
    if c4 != 0.0 {
        return solve(quartic);
    }
    let mut roots = Roots::default();
    if c2 != 0.0 {
        roots.push_quadratic(c1 / c2, c0 / c2);
    }
    roots
}

/// The smallest root in [0, horizon] at which the gap falls: the rule of finders that solve for
/// roots. It helps the solvers in two cases: a contact of bodies that touch and approach at t = 0
/// does not depend on the solver, and a quartic without leading coefficient is solved as a
/// quadratic.
pub fn smallest_approaching_root(
    motion: &Motion<2>,
    distance: f64,
    horizon: f64,
    solve: impl FnOnce(&Quartic) -> Roots,
) -> Option<f64> {
    let quartic = Quartic::of_gap(motion, distance);
    let [c0, c1, ..] = quartic.0;
    if c0 <= 0.0 && c1 < 0.0 && horizon >= 0.0 {
        return Some(0.0);
    }
    let roots = real_roots(&quartic, solve);
    let approaching = |&t: &f64| (0.0..=horizon).contains(&t) && quartic.rate(t) < 0.0;
    roots.as_slice().iter().copied().filter(approaching).min_by(f64::total_cmp)
}
