//! The eigenvalues of the companion matrix, balanced and by the QR algorithm: what GSL's
//! `gsl_poly_complex_solve` does, and with it FastFiz.

use nalgebra::Matrix4;
use nalgebra::linalg::{Schur, balancing::balance_parlett_reinsch};

use crate::quartic::{Quartic, Roots};

/// A root whose imaginary part is less is taken as real, 1/s; the value that FastFiz uses.
const REAL: f64 = 1e-11;

/// More QR sweeps than a matrix of order four needs; a failure to converge finds no roots.
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
