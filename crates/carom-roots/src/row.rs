//! A row of pairs that the proofs of [`crate::cannot_touch`] reject together.

use crate::reject::{cannot_touch, passes_by};

/// A row of `L` pairs as a structure of arrays: the motions of `L` bodies relative to one.
///
/// A lane without a pair has a `horizon` of NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Row<const L: usize> {
    /// Separation along x, m.
    pub dx: [f64; L],
    /// Separation along y, m.
    pub dy: [f64; L],
    /// Relative velocity along x, m/s.
    pub vx: [f64; L],
    /// Relative velocity along y, m/s.
    pub vy: [f64; L],
    /// Half the relative acceleration along x, m/s².
    pub hx: [f64; L],
    /// Half the relative acceleration along y, m/s².
    pub hy: [f64; L],
    /// Distance of the centres in contact, m.
    pub distance: [f64; L],
    /// End of the search, s; may be infinite.
    pub horizon: [f64; L],
}

impl<const L: usize> Row<L> {
    /// For each lane, whether it stays open because [`crate::cannot_touch`] proves nothing. `None`
    /// if no lane is open.
    ///
    /// Inlined, so that a caller compiled for wider vectors uses them here.
    #[inline(always)]
    pub fn open(&self) -> Option<[bool; L]> {
        // Loops, because the closure of `array::from_fn` may not be inlined and would then be
        // compiled for narrow vectors. A flag for any open lane is one vector test; comparing
        // arrays would pack them first.
        let mut any = false;
        for i in 0..L {
            any |= !self.proved(passes_by, i);
        }
        // Most rows are far from the path, and the corridor test rejects every lane.
        if !any {
            return None;
        }
        // The compiler reuses the results of the corridor test.
        let mut open = [false; L];
        any = false;
        for (i, open) in open.iter_mut().enumerate() {
            *open = !self.proved(cannot_touch, i);
            any |= *open;
        }
        any.then_some(open)
    }

    /// The result of a proof for lane `i`.
    #[inline(always)]
    fn proved(
        &self,
        proof: impl Fn(f64, f64, f64, f64, f64, f64, f64, f64) -> bool,
        i: usize,
    ) -> bool {
        proof(
            self.dx[i],
            self.dy[i],
            self.vx[i],
            self.vy[i],
            self.hx[i],
            self.hy[i],
            self.distance[i],
            self.horizon[i],
        )
    }
}

#[cfg(test)]
mod tests {
    use super::Row;

    #[test]
    fn a_row_gives_each_lane_the_result_of_the_scalar_function() {
        // meets, separates, misses, is too far away, is absent
        let row = Row {
            dx: [3.0, 3.0, 3.0, 3.0, 3.0],
            dy: [0.0, 0.0, 1.5, 0.0, 0.0],
            vx: [-2.0, 2.0, -2.0, -2.0, -2.0],
            vy: [0.0; 5],
            hx: [0.1; 5],
            hy: [0.0; 5],
            distance: [1.0; 5],
            horizon: [2.0, 2.0, 2.0, 0.5, f64::NAN],
        };
        assert_eq!(row.open(), Some([true, false, false, false, false]));
        assert_eq!(Row { horizon: [f64::NAN; 5], ..row }.open(), None);
    }
}
