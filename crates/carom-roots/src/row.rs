//! A row of pairs, turned away together by the proofs of [`crate::cannot_touch`].

use crate::reject::{cannot_touch, passes_by};

/// A row of `L` pairs as structure of arrays: the motions of one body relative to `L` others.
///
/// A lane that holds no pair has a `horizon` of NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Row<const L: usize> {
    /// Separation, m.
    pub dx: [f64; L],
    /// Separation, m.
    pub dy: [f64; L],
    /// Relative velocity, m/s.
    pub vx: [f64; L],
    /// Relative velocity, m/s.
    pub vy: [f64; L],
    /// Half relative acceleration, m/s².
    pub hx: [f64; L],
    /// Half relative acceleration, m/s².
    pub hy: [f64; L],
    /// Distance of the centres in contact, m.
    pub distance: [f64; L],
    /// The last time of interest, s; may be infinite.
    pub horizon: [f64; L],
}

impl<const L: usize> Row<L> {
    /// For each lane, whether it is open: [`crate::cannot_touch`] does not hold. `None` if no lane is.
    ///
    /// Inlined into its caller, so that a caller compiled for wider vectors gets them.
    #[inline(always)]
    pub fn open(&self) -> Option<[bool; L]> {
        // Loops: the closure of `array::from_fn` may be left out of line, and then is compiled for
        // narrow vectors. Whether any lane is open is asked of a flag: one vector test, where
        // comparing arrays would pack them first.
        let mut any = false;
        for i in 0..L {
            any |= !self.ask(passes_by, i);
        }
        // Most rows are far from the path: of them the corridor turns away every lane.
        if !any {
            return None;
        }
        // The corridor's answers are still there: the compiler does not work them out again.
        let mut open = [false; L];
        any = false;
        for (i, open) in open.iter_mut().enumerate() {
            *open = !self.ask(cannot_touch, i);
            any |= *open;
        }
        any.then_some(open)
    }

    /// A proof about lane `i`.
    #[inline(always)]
    fn ask(
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
    fn a_row_says_of_each_lane_what_the_scalar_says() {
        // meets, parts, misses, is too far, is not there
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
