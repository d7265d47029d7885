//! A row of pairs, turned away together by the proofs of [`crate::cannot_touch`].

use crate::reject::{keeps_off, passes_by};

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
    /// For each lane, whether [`crate::cannot_touch`] holds.
    ///
    /// Inlined into its caller, so that a caller compiled for wider vectors gets them.
    #[inline(always)]
    pub fn cannot_touch(&self) -> [bool; L] {
        // Loops: the closure of `array::from_fn` may be left out of line, and then is compiled for
        // narrow vectors.
        let mut result = [false; L];
        let mut all = true;
        for (i, result) in result.iter_mut().enumerate() {
            *result = self.ask(passes_by, i);
            all &= *result;
        }
        // Most rows are far from the path: of them the corridor turns away every lane. Asked of a flag:
        // one vector test, where comparing arrays would pack them first.
        if all {
            return result;
        }
        for (i, result) in result.iter_mut().enumerate() {
            *result |= self.ask(keeps_off, i);
        }
        result
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
        assert_eq!(row.cannot_touch(), [false, true, true, true, true]);
    }
}
