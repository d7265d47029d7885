//! One step in P: explicit where the equations are not stiff, implicit where they are.

use super::{Jacobian, Squeeze, State, WORK};

impl Squeeze {
    /// One step of Dormand & Prince's 5(4) pair: the new state, its rate, and its error as a
    /// multiple of the error that a step may add.
    #[inline(always)]
    pub(super) fn explicit_step(&self, y: &State, k1: &State, h: f64) -> (State, State, f64) {
        let k2 = self.rate(&sum(y, &[(h * (1.0 / 5.0), k1)]));
        let k3 = self.rate(&sum(y, &[(h * (3.0 / 40.0), k1), (h * (9.0 / 40.0), &k2)]));
        let k4 = self.rate(&sum(
            y,
            &[(h * (44.0 / 45.0), k1), (h * (-56.0 / 15.0), &k2), (h * (32.0 / 9.0), &k3)],
        ));
        let k5 = self.rate(&sum(
            y,
            &[
                (h * (19372.0 / 6561.0), k1),
                (h * (-25360.0 / 2187.0), &k2),
                (h * (64448.0 / 6561.0), &k3),
                (h * (-212.0 / 729.0), &k4),
            ],
        ));
        let k6 = self.rate(&sum(
            y,
            &[
                (h * (9017.0 / 3168.0), k1),
                (h * (-355.0 / 33.0), &k2),
                (h * (46732.0 / 5247.0), &k3),
                (h * (49.0 / 176.0), &k4),
                (h * (-5103.0 / 18656.0), &k5),
            ],
        ));
        let next = sum(
            y,
            &[
                (h * (35.0 / 384.0), k1),
                (h * (500.0 / 1113.0), &k3),
                (h * (125.0 / 192.0), &k4),
                (h * (-2187.0 / 6784.0), &k5),
                (h * (11.0 / 84.0), &k6),
            ],
        );
        let k7 = self.rate(&next);
        let difference = sum(
            &[0.0; 6],
            &[
                (h * (71.0 / 57600.0), k1),
                (h * (-71.0 / 16695.0), &k3),
                (h * (71.0 / 1920.0), &k4),
                (h * (-17253.0 / 339_200.0), &k5),
                (h * (22.0 / 525.0), &k6),
                (h * (-1.0 / 40.0), &k7),
            ],
        );
        (next, k7, self.share(&difference))
    }

    /// An estimated error as a multiple of the error that a step may add.
    #[inline(always)]
    fn share(&self, difference: &State) -> f64 {
        difference.iter().fold(0.0, |worst: f64, d| worst.max(d.abs())) / self.step_error
    }

    /// One step of the Rosenbrock method, with the results of [`Self::explicit_step`].
    pub(super) fn implicit_step(&self, y: &State, rate: &State, h: f64) -> (State, State, f64) {
        let system = System::new(self, &self.jacobian(y), 1.0 / (ros4::GAMMA * h));
        let k1 = system.solve(rate);
        let y2 = sum(y, &[(ros4::A21, &k1)]);
        let k2 = system.solve(&sum(&self.rate(&y2), &[(ros4::C21 / h, &k1)]));
        let y3 = sum(y, &[(ros4::A31, &k1), (ros4::A32, &k2)]);
        let rate3 = self.rate(&y3);
        let k3 = system.solve(&sum(&rate3, &[(ros4::C31 / h, &k1), (ros4::C32 / h, &k2)]));
        let k4 = system.solve(&sum(
            &rate3,
            &[(ros4::C41 / h, &k1), (ros4::C42 / h, &k2), (ros4::C43 / h, &k3)],
        ));
        let next = sum(y, &[(ros4::B1, &k1), (ros4::B2, &k2), (ros4::B3, &k3), (ros4::B4, &k4)]);
        let difference =
            sum(&[0.0; 6], &[(ros4::E1, &k1), (ros4::E2, &k2), (ros4::E3, &k3), (ros4::E4, &k4)]);
        (next, self.rate(&next), self.share(&difference))
    }
}

/// The linear system (I/γh − J) k = b of a step, factorised. The slips form a 4 × 4 block; v_y and
/// the work follow from them.
struct System {
    /// L below the diagonal and U above; the diagonal holds its reciprocals.
    lu: [[f64; 4]; 4],
    /// Row of v_y.
    side: [f64; 4],
    /// Rate of the work with s_x and with c_x.
    work: f64,
    /// γh.
    scale: f64,
}

impl System {
    /// The block is diagonally dominant enough for elimination without pivoting: friction only
    /// damps, and 1/γh is added to the diagonal.
    #[inline(always)]
    fn new(squeeze: &Squeeze, jacobian: &Jacobian, shift: f64) -> Self {
        let mut lu: [[f64; 4]; 4] =
            core::array::from_fn(|i| core::array::from_fn(|j| -jacobian[i][j]));
        for (i, row) in lu.iter_mut().enumerate() {
            row[i] += shift;
        }
        for i in 0..4 {
            lu[i][i] = 1.0 / lu[i][i];
            for r in i + 1..4 {
                lu[r][i] *= lu[i][i];
                for j in i + 1..4 {
                    lu[r][j] -= lu[r][i] * lu[i][j];
                }
            }
        }
        Self { lu, side: jacobian[4], work: squeeze.cos / (1.0 + squeeze.sin), scale: 1.0 / shift }
    }

    #[inline(always)]
    fn solve(&self, b: &State) -> State {
        let mut x = *b;
        for i in 1..4 {
            for j in 0..i {
                x[i] -= self.lu[i][j] * x[j];
            }
        }
        for i in (0..4).rev() {
            for j in i + 1..4 {
                x[i] -= self.lu[i][j] * x[j];
            }
            x[i] *= self.lu[i][i];
        }
        for j in 0..4 {
            x[4] += self.side[j] * x[j];
        }
        x[4] *= self.scale;
        x[WORK] = (x[WORK] + self.work * (x[0] + x[2])) * self.scale;
        x
    }
}

/// y + Σ aᵢkᵢ.
#[inline(always)]
fn sum(y: &State, terms: &[(f64, &State)]) -> State {
    core::array::from_fn(|i| terms.iter().fold(y[i], |sum, (a, k)| sum + a * k[i]))
}

/// The L-stable method of Hairer & Wanner II, table IV.7.2, in the form without products with the
/// Jacobian.
mod ros4 {
    pub(super) const GAMMA: f64 = 0.572_82;
    pub(super) const A21: f64 = 2.0;
    pub(super) const A31: f64 = 1.867_943_637_803_922;
    pub(super) const A32: f64 = 0.234_444_971_139_915_6;
    pub(super) const C21: f64 = -7.137_615_036_412_31;
    pub(super) const C31: f64 = 2.580_708_087_951_457;
    pub(super) const C32: f64 = 0.651_595_007_644_797_5;
    pub(super) const C41: f64 = -2.137_148_994_382_534;
    pub(super) const C42: f64 = -0.321_466_969_123_762_6;
    pub(super) const C43: f64 = -0.694_974_250_178_177_9;
    pub(super) const B1: f64 = 2.255_570_073_418_735;
    pub(super) const B2: f64 = 0.287_049_326_218_679_2;
    pub(super) const B3: f64 = 0.435_317_943_184_018;
    pub(super) const B4: f64 = 1.093_502_252_409_163;
    pub(super) const E1: f64 = -0.281_543_193_214_115_5;
    pub(super) const E2: f64 = -0.072_761_991_249_349_2;
    pub(super) const E3: f64 = -0.108_219_620_149_531_1;
    pub(super) const E4: f64 = -1.093_502_252_409_163;
}
