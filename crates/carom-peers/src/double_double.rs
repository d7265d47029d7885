//! Numbers of 106 bits as unevaluated sums of two doubles, for the judge of root finders.
//!
//! By Dekker 1971 (the product) and Knuth's two-sum. The relative error of one operation is a few
//! 2⁻¹⁰⁴.

use std::ops::{Add, Mul, Neg, Sub};

/// hi + lo, with |lo| at most half a unit in the last place of hi.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoubleDouble {
    hi: f64,
    lo: f64,
}

impl DoubleDouble {
    /// The nearest double.
    pub fn value(self) -> f64 {
        self.hi + self.lo
    }

    /// p/q, for whole numbers below 2²⁶.
    pub fn ratio(p: f64, q: f64) -> Self {
        let hi = p / q;
        let rest = DoubleDouble::from(p) - DoubleDouble::from(q) * DoubleDouble::from(hi);
        quick_two_sum(hi, rest.value() / q)
    }

    /// The square root; 0 for negative numbers.
    pub fn sqrt(self) -> Self {
        let hi = self.value().max(0.0).sqrt();
        if hi == 0.0 {
            return DoubleDouble::from(0.0);
        }
        let rest = self - two_product(hi, hi);
        quick_two_sum(hi, rest.value() / (2.0 * hi))
    }
}

impl From<f64> for DoubleDouble {
    fn from(hi: f64) -> Self {
        DoubleDouble { hi, lo: 0.0 }
    }
}

fn two_sum(a: f64, b: f64) -> DoubleDouble {
    let hi = a + b;
    let from_b = hi - a;
    DoubleDouble { hi, lo: (a - (hi - from_b)) + (b - from_b) }
}

/// The sum of two doubles of which `a` has the larger magnitude, or is 0 (Dekker 1971).
fn quick_two_sum(a: f64, b: f64) -> DoubleDouble {
    let hi = a + b;
    DoubleDouble { hi, lo: b - (hi - a) }
}

/// The upper and lower 26 bits.
fn split(a: f64) -> (f64, f64) {
    const SPLITTER: f64 = 134_217_729.0; // 2²⁷ + 1
    let scaled = SPLITTER * a;
    let high = scaled - (scaled - a);
    (high, a - high)
}

fn two_product(a: f64, b: f64) -> DoubleDouble {
    let hi = a * b;
    let ((a1, a2), (b1, b2)) = (split(a), split(b));
    DoubleDouble { hi, lo: ((a1 * b1 - hi) + a1 * b2 + a2 * b1) + a2 * b2 }
}

impl Add for DoubleDouble {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let high = two_sum(self.hi, other.hi);
        let low = two_sum(self.lo, other.lo);
        let sum = quick_two_sum(high.hi, high.lo + low.hi);
        quick_two_sum(sum.hi, sum.lo + low.lo)
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    fn neg(self) -> Self {
        DoubleDouble { hi: -self.hi, lo: -self.lo }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let product = two_product(self.hi, other.hi);
        quick_two_sum(product.hi, product.lo + (self.hi * other.lo + self.lo * other.hi))
    }
}

#[cfg(test)]
mod tests {
    use super::DoubleDouble;

    /// 2⁻¹⁰⁰, four bits above the last.
    const TINY: f64 = 7.888609052210118e-31;

    #[test]
    fn a_sum_keeps_bits_that_a_double_loses() {
        let one = DoubleDouble::from(1.0);
        let tiny = DoubleDouble::from(TINY);
        assert_eq!(((one + tiny) - one).value(), TINY);
    }

    #[test]
    fn a_squared_root_and_a_tripled_third_give_the_number_again() {
        let two = DoubleDouble::from(2.0);
        assert!((two.sqrt() * two.sqrt() - two).value().abs() <= 4.0 * TINY);
        let third = DoubleDouble::ratio(1.0, 3.0);
        assert!((third + third + third - DoubleDouble::from(1.0)).value().abs() <= 4.0 * TINY);
    }

    #[test]
    fn a_product_is_exact_to_106_bits() {
        // (1 + 2⁻⁵⁰)² = 1 + 2⁻⁴⁹ + 2⁻¹⁰⁰
        let x = DoubleDouble::from(1.0 + 2f64.powi(-50));
        let rest = x * x - DoubleDouble::from(1.0) - DoubleDouble::from(2f64.powi(-49));
        assert_eq!(rest.value(), TINY);
    }
}
