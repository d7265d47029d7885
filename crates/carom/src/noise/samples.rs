//! Errors of strikes that were measured.

use alloc::format;
use alloc::sync::Arc;
use alloc::vec::Vec;

use super::RANGES;
use crate::error::{Error, ErrorKind};

/// The most samples. A million would take 40 MB in every copy that a file or a record has.
const MOST: usize = 100_000;

/// Measured errors, executed minus intended: speed (m/s), azimuth (rad), elevation (rad), side (m) and
/// height (m). Every drawn strike has the error of one of them, all equally likely.
#[derive(Clone, Debug, PartialEq)]
pub struct Samples(Arc<Table>);

#[derive(Debug, PartialEq)]
struct Table {
    rows: Vec<[f64; 5]>,
    mean: [f64; 5],
    covariance: [[f64; 5]; 5],
    has_error: [bool; 5],
}

impl Samples {
    /// The errors with these rows.
    ///
    /// # Errors
    /// [`Error::Input`] at `noise.samples` for no rows or more than 100 000, and for a number that is
    /// not finite or too large for its parameter.
    pub fn new(rows: Vec<[f64; 5]>) -> Result<Self, Error> {
        if !(1..=MOST).contains(&rows.len()) {
            let what = format!("{} samples are out of range", rows.len());
            let remedy = format!("write from 1 to {MOST} rows of five numbers");
            return Err(ErrorKind::WrongCount.at("noise.samples", what, remedy));
        }
        for (i, row) in rows.iter().enumerate() {
            for (k, number) in row.iter().enumerate() {
                RANGES[k].either_sign().check(|| format!("noise.samples[{i}][{k}]"), *number)?;
            }
        }
        let count = rows.len() as f64;
        let mean = core::array::from_fn(|k| rows.iter().map(|row| row[k]).sum::<f64>() / count);
        let product = |i: usize, j: usize| -> f64 {
            let of_row = |row: &[f64; 5]| (row[i] - mean[i]) * (row[j] - mean[j]);
            rows.iter().map(of_row).sum::<f64>() / count
        };
        let covariance = core::array::from_fn(|i| core::array::from_fn(|j| product(i, j)));
        let has_error = core::array::from_fn(|k| rows.iter().any(|row| row[k] != 0.0));
        Ok(Self(Arc::new(Table { rows, mean, covariance, has_error })))
    }

    /// The errors, a row for each.
    pub fn rows(&self) -> &[[f64; 5]] {
        &self.0.rows
    }

    /// The error that belongs to a normal deviate: its quantile among the rows, in their order.
    pub(super) fn at(&self, deviate: f64) -> [f64; 5] {
        let share = 0.5 * libm::erfc(-deviate * core::f64::consts::FRAC_1_SQRT_2);
        let count = self.0.rows.len();
        self.0.rows[((share * count as f64) as usize).min(count - 1)]
    }

    pub(super) fn mean(&self) -> &[f64; 5] {
        &self.0.mean
    }

    pub(super) fn covariance(&self) -> &[[f64; 5]; 5] {
        &self.0.covariance
    }

    pub(super) fn has_error(&self) -> &[bool; 5] {
        &self.0.has_error
    }

    pub(super) fn scaled(&self, multiplier: f64) -> Self {
        let mut rows = self.0.rows.clone();
        rows.iter_mut().flatten().for_each(|number| *number *= multiplier);
        let mean = self.0.mean.map(|number| number * multiplier);
        let covariance =
            self.0.covariance.map(|row| row.map(|number| number * multiplier * multiplier));
        let has_error = if multiplier == 0.0 { [false; 5] } else { self.0.has_error };
        Self(Arc::new(Table { rows, mean, covariance, has_error }))
    }
}
