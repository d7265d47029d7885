//! Lower bounds of polynomials on an interval from their Bernstein coefficients: a polynomial lies
//! in the convex hull of its coefficients (Farouki & Rajan 1987). The engine finds contacts by
//! Newton's and Halley's methods, so the checker uses another one.

/// A polynomial of degree D = N − 1 on [0, 1], by its Bernstein coefficients.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bernstein<const N: usize>(pub(crate) [f64; N]);

impl<const N: usize> Bernstein<N> {
    /// The polynomial c₀ + c₁t + … on t ∈ [0, `length`]: bᵢ = Σⱼ C(i, j)/C(D, j) cⱼ lengthʲ, by
    /// rows of Pascal's triangle.
    pub(crate) fn from_monomials(mut c: [f64; N], length: f64) -> Self {
        let degree = (N - 1) as f64;
        let mut scale = 1.0;
        for (j, c) in c.iter_mut().enumerate() {
            *c *= scale;
            let j = j as f64;
            scale *= length * (j + 1.0) / (degree - j).max(1.0);
        }
        for row in 1..N {
            for i in (row..N).rev() {
                c[i] += c[i - 1];
            }
        }
        Self(c)
    }

    /// The smallest coefficient, a lower bound of the polynomial on [0, 1].
    pub(crate) fn lower(&self) -> f64 {
        self.0.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// The polynomial on both halves of the interval (de Casteljau 1959). The first coefficient of
    /// the second half is the value in the middle.
    pub(crate) fn halves(&self) -> (Self, Self) {
        let (mut left, mut right) = (self.0, self.0);
        for level in 1..N {
            for i in (level..N).rev() {
                left[i] = 0.5 * (left[i - 1] + left[i]);
            }
        }
        for level in 1..N {
            for i in 0..N - level {
                right[i] = 0.5 * (right[i] + right[i + 1]);
            }
        }
        (Self(left), Self(right))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coefficients_bound_the_polynomial_and_halves_meet_in_the_middle() {
        let c = [0.3, -2.0, 1.5, 0.7, -0.2];
        let length = 1.7;
        let value = |t: f64| c.iter().rev().fold(0.0, |s, c| s * t + c);
        let b = Bernstein::from_monomials(c, length);
        let (left, right) = b.halves();
        assert!((left.0[4] - value(0.5 * length)).abs() < 1e-14);
        assert!((right.0[0] - value(0.5 * length)).abs() < 1e-14);
        assert!((b.0[0] - value(0.0)).abs() < 1e-14 && (b.0[4] - value(length)).abs() < 1e-14);
        for k in 0..=100 {
            let v = value(length * f64::from(k) / 100.0);
            assert!(b.lower() <= v + 1e-14);
        }
    }
}
