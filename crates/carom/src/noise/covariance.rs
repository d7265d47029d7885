//! Errors of a strike's parameters that depend on each other.

use alloc::format;
use alloc::sync::Arc;

use super::RANGES;
use crate::error::{Error, ErrorKind};
use crate::math::sqrt;

/// Largest difference of two numbers that should be equal, and largest negative variance, as a share
/// of the variances: rounding of a matrix that was computed or printed with nine digits. Smaller, and
/// such matrices are refused; larger, and mistakes pass.
const ROUNDING: f64 = 1e-9;

/// A covariance matrix of speed (m/s), azimuth (rad), elevation (rad), side (m) and height (m):
/// finite, symmetric, and positive semidefinite.
#[derive(Clone, Debug, PartialEq)]
pub struct Covariance(Arc<[[f64; 5]; 5]>);

impl Covariance {
    /// The covariance with this matrix.
    ///
    /// # Errors
    /// [`Error::Input`] at `noise.covariance` if a number is not finite, if a variance is negative or
    /// too large for its parameter, if the matrix is not symmetric, or if it is not positive
    /// semidefinite: a combination of the parameters would have a negative variance.
    pub fn new(matrix: [[f64; 5]; 5]) -> Result<Self, Error> {
        let place = |i, j| format!("noise.covariance[{i}][{j}]");
        for (i, row) in matrix.iter().enumerate() {
            for (j, number) in row.iter().enumerate() {
                if !number.is_finite() {
                    let what = format!("{number:?} is not a covariance");
                    return Err(ErrorKind::OutOfRange.at(
                        place(i, j),
                        what,
                        "write a finite number",
                    ));
                }
            }
            RANGES[i].squared().check(|| place(i, i), row[i])?;
        }
        let mut exact = matrix;
        for i in 0..5 {
            for j in 0..i {
                let [a, b] = [matrix[i][j], matrix[j][i]];
                let scale = sqrt(matrix[i][i] * matrix[j][j]).max(a.abs());
                if (a - b).abs() > ROUNDING * scale {
                    let what = format!("{a:?} differs from {b:?} at [{j}][{i}]");
                    let remedy = "write a symmetric matrix, such as numpy.cov(errors.T)";
                    return Err(ErrorKind::Conflict.at(place(i, j), what, remedy));
                }
                exact[i][j] = 0.5 * (a + b);
                exact[j][i] = exact[i][j];
            }
        }
        match factor(&exact) {
            Some(_) => Ok(Self(Arc::new(exact))),
            None => Err(ErrorKind::OutOfRange.at("noise.covariance",
                "the matrix is not positive semidefinite, so a combination of errors would have a \
                 negative variance",
                "write the covariance of measured errors, such as numpy.cov(errors.T), with all its \
                 digits",
            )),
        }
    }

    pub(super) fn scaled(&self, multiplier: f64) -> Self {
        let square = multiplier * multiplier;
        Self(Arc::new(self.0.map(|row| row.map(|number| number * square))))
    }

    /// The matrix, symmetric to the bit.
    pub fn matrix(&self) -> &[[f64; 5]; 5] {
        &self.0
    }
}

/// The lower triangular factor L of a positive semidefinite matrix LLᵀ (Cholesky); None if a pivot is
/// negative by more than rounding. A parameter that depends on those before it has a zero pivot.
fn factor(matrix: &[[f64; 5]; 5]) -> Option<[[f64; 5]; 5]> {
    let mut lower = [[0.0; 5]; 5];
    for j in 0..5 {
        let of_column = |i: usize, lower: &[[f64; 5]; 5]| -> f64 {
            (0..j).map(|k| lower[i][k] * lower[j][k]).sum()
        };
        let pivot = matrix[j][j] - of_column(j, &lower);
        if pivot < -ROUNDING * matrix[j][j] {
            return None;
        }
        let is_dependent = pivot <= ROUNDING * matrix[j][j];
        let root = if is_dependent { 0.0 } else { sqrt(pivot) };
        lower[j][j] = root;
        for i in j + 1..5 {
            let rest = matrix[i][j] - of_column(i, &lower);
            if !is_dependent {
                lower[i][j] = rest / root;
            } else if rest * rest > ROUNDING * matrix[i][i] * matrix[j][j] {
                return None;
            }
        }
    }
    Some(lower)
}

/// The error with these independent deviates of variance 1, under the covariance `matrix`.
pub(super) fn correlated(matrix: &[[f64; 5]; 5], deviates: &[f64; 5]) -> [f64; 5] {
    let lower = factor(matrix).expect("a covariance plus variances is positive semidefinite");
    core::array::from_fn(|i| (0..=i).map(|k| lower[i][k] * deviates[k]).sum())
}
