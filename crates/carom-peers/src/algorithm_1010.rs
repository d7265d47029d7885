//! Orellana & De Michele 2020, "Algorithm 1010: Boosting efficiency in solving quartic equations
//! with no compromise in accuracy", ACM Trans. Math. Softw. 46(2), 20, written from the method's
//! formulas.
//!
//! x⁴ + ax³ + bx² + cx + d = (x² + l₁x + l₃)² + d₂(x + l₂)², the LDLᵀ factorisation of the
//! symmetric matrix of the quartic in (x², x, 1), made singular by a root φ of its resolvent cubic.
//! For d₂ < 0 it splits into (x² + α₁x + β₁)(x² + α₂x + β₂), which Newton's method then refines.
//! Departures: no rescaling against overflow, which motions on a table do not need.

use nalgebra::Complex;

use crate::quartic::{Quartic, Roots};

/// A complex root with a smaller imaginary part, relative to its size, counts as real: a double
/// root is known only to the square root of a rounding.
const REAL: f64 = 1e-9;

/// Limit of refinements of φ and of the factors; each stops when it no longer improves.
const MAX_REFINEMENTS: usize = 8;

/// The real roots of a quartic with c₄ ≠ 0.
pub fn real_roots(quartic: &Quartic) -> Roots {
    let [a, b, c, d] = quartic.monic();
    let phi = dominant_root(a * c - 4.0 * d - b * b / 3.0, {
        b * (a * c / 3.0 + 8.0 / 3.0 * d - 2.0 / 27.0 * b * b) - c * c - a * a * d
    });
    let l1 = 0.5 * a;
    let l3 = b / 6.0 + 0.5 * phi;
    let (d2, l2, error) = second_row([a, b, c, d], phi, l1, l3);
    let mut roots = Roots::default();
    // d₂ is zero if both factors have the same middle, as on a straight path. Then its sign is
    // decided by rounding, and the factors without it are more accurate.
    let flat = flat_factors([a, b, c, d], l1, l3);
    let flat_error = flat.map_or(f64::INFINITY, |flat| flat.error([a, b, c, d]));
    if d2 < 0.0 {
        let split = real_factors([a, b, c, d], (-d2).sqrt(), l1, l2, l3);
        let best = flat.filter(|_| flat_error < split.error([a, b, c, d])).unwrap_or(split);
        best.refined([a, b, c, d]).push_roots(&mut roots);
    } else if let Some(flat) = flat.filter(|_| d2 == 0.0 || flat_error < error) {
        flat.refined([a, b, c, d]).push_roots(&mut roots);
    } else if d2 > 0.0 {
        push_nearly_real(&mut roots, d2.sqrt(), l1, l2, l3);
    }
    roots
}

/// The root of largest magnitude of φ³ + gφ + h.
fn dominant_root(g: f64, h: f64) -> f64 {
    let (q, r) = (-g / 3.0, 0.5 * h);
    let cube = q * q * q;
    let mut phi = if r * r < cube {
        let angle = (r.abs() / cube.sqrt()).min(1.0).acos();
        -(2.0 * q.sqrt() * (angle / 3.0).cos()).copysign(r)
    } else {
        let s = -(r.abs() + (r * r - cube).sqrt()).cbrt().copysign(r);
        if s == 0.0 { 0.0 } else { s + q / s }
    };
    let mut residue = (phi * phi + g) * phi + h;
    for _ in 0..MAX_REFINEMENTS {
        let slope = 3.0 * phi * phi + g;
        if residue == 0.0 || slope == 0.0 {
            break;
        }
        let next = phi - residue / slope;
        let next_residue = (next * next + g) * next + h;
        if next_residue.abs() >= residue.abs() {
            break;
        }
        (phi, residue) = (next, next_residue);
    }
    phi
}

/// |x − y|, relative to y unless that is zero.
fn deviation(x: f64, y: f64) -> f64 {
    if y == 0.0 { x.abs() } else { ((x - y) / y).abs() }
}

/// d₂ and l₂ by the one of the three equivalent formulas that reproduces the coefficients best, and
/// its error.
fn second_row([a, b, c, d]: [f64; 4], phi: f64, l1: f64, l3: f64) -> (f64, f64, f64) {
    let delta2 = 0.5 * c - l1 * l3;
    let d2 = 2.0 / 3.0 * b - phi - l1 * l1;
    let l2 = 2.0 * (d - l3 * l3) / (c - a * l3);
    let with_error = |(d2, l2): (f64, f64)| {
        let error = deviation(d2 + l1 * l1 + 2.0 * l3, b)
            + deviation(2.0 * (d2 * l2 + l1 * l3), c)
            + deviation(d2 * l2 * l2 + l3 * l3, d);
        // A formula that divides by zero is not chosen.
        (d2, l2, if error.is_nan() { f64::INFINITY } else { error })
    };
    let candidates = [(d2, delta2 / d2), (delta2 / l2, l2), (d2, l2)].map(with_error);
    candidates.into_iter().min_by(|one, two| one.2.total_cmp(&two.2)).unwrap_or(candidates[0])
}

/// (x² + α₁x + β₁)(x² + α₂x + β₂).
#[derive(Clone, Copy)]
struct Factors {
    alpha: [f64; 2],
    beta: [f64; 2],
}

/// The factors for d₂ < 0, γ = √−d₂; the smaller of each pair from the product or sum of both.
fn real_factors([a, b, c, d]: [f64; 4], gamma: f64, l1: f64, l2: f64, l3: f64) -> Factors {
    let mut beta = [l3 + gamma * l2, l3 - gamma * l2];
    let small = usize::from(beta[1].abs() < beta[0].abs());
    if beta[1 - small] != 0.0 {
        beta[small] = d / beta[1 - small];
    }
    let mut alpha = [l1 + gamma, l1 - gamma];
    let i = usize::from(alpha[1].abs() < alpha[0].abs());
    let (other, b_i, b_other) = (alpha[1 - i], beta[i], beta[1 - i]);
    let candidates =
        [a - other, (c - b_i * other) / b_other, (b - b_i - b_other) / other, alpha[i]];
    let error = |&x: &f64| {
        let e = deviation(b_i * other + x * b_other, c)
            + deviation(b_i + x * other + b_other, b)
            + deviation(x + other, a);
        if e.is_nan() { f64::INFINITY } else { e }
    };
    alpha[i] = candidates
        .into_iter()
        .min_by(|one, two| error(one).total_cmp(&error(two)))
        .unwrap_or(alpha[i]);
    Factors { alpha, beta }
}

/// The factors if d₂ is zero: (x² + l₁x + l₃)² + d₃.
fn flat_factors([_, _, _, d]: [f64; 4], l1: f64, l3: f64) -> Option<Factors> {
    let d3 = d - l3 * l3;
    if d3 > 0.0 {
        return None;
    }
    let large = l3 + (-d3).sqrt().copysign(l3);
    Some(Factors { alpha: [l1; 2], beta: [large, if large == 0.0 { 0.0 } else { d / large }] })
}

impl Factors {
    fn error(&self, [a, b, c, d]: [f64; 4]) -> f64 {
        let Factors { alpha: [a1, a2], beta: [b1, b2] } = *self;
        deviation(b1 * b2, d)
            + deviation(b1 * a2 + a1 * b2, c)
            + deviation(b1 + a1 * a2 + b2, b)
            + deviation(a1 + a2, a)
    }

    /// Newton's method on the four equations between the factors and the coefficients.
    fn refined(self, coefficients: [f64; 4]) -> Self {
        let [a, b, c, d] = coefficients;
        let mut best = self;
        let mut error = best.error(coefficients);
        for _ in 0..MAX_REFINEMENTS {
            let Factors { alpha: [a1, a2], beta: [b1, b2] } = best;
            let r1 = a - a1 - a2;
            let r2 = b - b1 - a1 * a2 - b2 - a1 * r1;
            let (p, q) = (a1 - a2, b1 - b2);
            let s3 = c - b1 * a2 - a1 * b2 - b1 * r1 - a1 * r2;
            let s4 = d - b1 * b2 - b1 * r2;
            let determinant = -(b1 * p * p - a1 * p * q + q * q);
            if error == 0.0 || determinant == 0.0 {
                break;
            }
            let by_b1 = (s3 * b1 * p - (a1 * p - q) * s4) / determinant;
            let by_a1 = (q * s3 - p * s4) / determinant;
            let next = Factors {
                alpha: [a1 + by_a1, a2 + r1 - by_a1],
                beta: [b1 + by_b1, b2 + r2 - by_b1 + p * by_a1],
            };
            let next_error = next.error(coefficients);
            if next_error.is_nan() || next_error >= error {
                break;
            }
            (best, error) = (next, next_error);
        }
        best
    }

    fn push_roots(&self, roots: &mut Roots) {
        roots.push_quadratic(self.alpha[0], self.beta[0]);
        roots.push_quadratic(self.alpha[1], self.beta[1]);
    }
}

/// d₂ > 0: two conjugate factors, whose roots are real only if they coincide.
fn push_nearly_real(roots: &mut Roots, gamma: f64, l1: f64, l2: f64, l3: f64) {
    let half = Complex::new(-0.5 * l1, -0.5 * gamma);
    let beta = Complex::new(l3, gamma * l2);
    let root = (half * half - beta).sqrt();
    let first =
        if (half + root).norm_sqr() > (half - root).norm_sqr() { half + root } else { half - root };
    for x in [first, beta / first] {
        if x.im.abs() <= REAL * x.norm() {
            roots.push(x.re);
        }
    }
}
