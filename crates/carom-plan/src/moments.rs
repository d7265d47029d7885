//! Mean and covariance of points in the plane, updated point by point.

/// Mean and covariance of the points so far (Welford 1962, in two dimensions).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Moments {
    count: u64,
    mean: [f64; 2],
    /// Sums of (x − x̄)², (x − x̄)(y − ȳ), (y − ȳ)².
    sums: [f64; 3],
}

impl Moments {
    /// Adds one point.
    pub fn add(&mut self, [x, y]: [f64; 2]) {
        self.count += 1;
        let n = self.count as f64;
        let (dx, dy) = (x - self.mean[0], y - self.mean[1]);
        self.mean[0] += dx / n;
        self.mean[1] += dy / n;
        let (ex, ey) = (x - self.mean[0], y - self.mean[1]);
        self.sums[0] += dx * ex;
        self.sums[1] += dx * ey;
        self.sums[2] += dy * ey;
    }

    /// The number of points.
    pub const fn count(&self) -> u64 {
        self.count
    }

    /// The mean of the points; NaN without points.
    pub fn mean(&self) -> [f64; 2] {
        if self.count == 0 { [f64::NAN; 2] } else { self.mean }
    }

    /// The unbiased covariance: xx, xy, yy. NaN for fewer than two points.
    pub fn covariance(&self) -> [f64; 3] {
        if self.count < 2 {
            return [f64::NAN; 3];
        }
        let n = (self.count - 1) as f64;
        self.sums.map(|sum| sum / n)
    }
}

#[cfg(test)]
mod tests {
    use super::Moments;

    #[test]
    fn moments_agree_with_their_definition() {
        let points = [[1.0, 5.0], [2.0, 1.0], [4.0, 2.0], [1.0, 0.0]];
        let mut moments = Moments::default();
        points.into_iter().for_each(|p| moments.add(p));
        assert_eq!(moments.mean(), [2.0, 2.0]);
        let [xx, xy, yy] = moments.covariance();
        assert!((xx - 2.0).abs() < 1e-15);
        assert!((xy + 1.0 / 3.0).abs() < 1e-15);
        assert!((yy - 14.0 / 3.0).abs() < 1e-15);
    }

    #[test]
    fn moments_of_too_few_points_are_nan() {
        let mut moments = Moments::default();
        assert!(moments.mean()[0].is_nan());
        moments.add([1.0, 2.0]);
        assert_eq!(moments.mean(), [1.0, 2.0]);
        assert!(moments.covariance()[0].is_nan());
    }
}
