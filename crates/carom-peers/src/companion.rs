//! Roots as eigenvalues of the balanced companion matrix, by the QR algorithm: the method of GSL's
//! `gsl_poly_complex_solve`, which FastFiz uses.

use nalgebra::Matrix4;
use nalgebra::linalg::{Schur, balancing::balance_parlett_reinsch};

use crate::quartic::{Quartic, Roots};

/// A root with a smaller imaginary part counts as real, s; the value of FastFiz.
const REAL: f64 = 1e-11;

/// Limit of QR sweeps, more than a matrix of order four needs. Without convergence no roots are
/// returned.
const MAX_SWEEPS: usize = 500;

/// The real roots of a quartic with c₄ ≠ 0.
pub fn real_roots(quartic: &Quartic) -> Roots {
    let [a, b, c, d] = quartic.monic();
    let mut roots = Roots::default();
    if ![a, b, c, d].iter().all(|x| x.is_finite()) {
        return roots;
    }
    #[rustfmt::skip]
    let mut companion = Matrix4::new(
        0.0, 0.0, 0.0, -d,
        1.0, 0.0, 0.0, -c,
        0.0, 1.0, 0.0, -b,
        0.0, 0.0, 1.0, -a,
    );
    balance_parlett_reinsch(&mut companion);
    if let Some(schur) = Schur::try_new(companion, f64::EPSILON, MAX_SWEEPS) {
        for root in schur.complex_eigenvalues().iter().filter(|root| root.im.abs() < REAL) {
            roots.push(root.re);
        }
    }
    roots
}
