//! Kernel regression over strikes, and the bounds by which KR-UCT chooses among them.
//!
//! T. Yee, V. Lisý, M. Bowling, *Monte Carlo tree search in continuous action spaces with execution
//! uncertainty*, IJCAI 2016. With the number of samples n(b) and the mean value v(b) of every strike
//! b, the value and the density at a strike a are
//!
//! ```text
//! E(a) = Σ K(a, b) n(b) v(b) / W(a),   W(a) = Σ K(a, b) n(b),
//! ```
//!
//! where K is the density of the execution error. The strike with the largest E + C √(ln ΣW / W) is
//! played next, and that with the largest E − C √(ln ΣW / W) is chosen in the end.
//!
//! The few outcomes of strikes that were searched deeper correct E, as a control variate, by their
//! differences d from the values that they had before: E(a) = Σ K n v / W + Σ K (d − u) / (Σ K m + c),
//! with their number m, the usual difference u of all calls, and c = [`CAUTION`].
//!
//! Departures, besides this correction: the regression is over the strikes as they were meant, to
//! which the outcomes belong, and not over those that were executed. K is 1 at the strike itself, so
//! that W is a number of samples, and 0 below [`LEAST_KERNEL`]. Strikes from different places or with
//! different calls share nothing, since a call changes what a motion is worth.

use carom::math::{exp, log, sqrt};
use carom::resolve::cue_ball::Strike;
use carom_rules::Call;

use super::shift::moved;

/// C of the bounds, as a probability of winning. **Guess**: the paper does not give one for values
/// from 0 to 1. After 300 samples of 10 000 the bounds are 1.5 points from E. Larger, and the search
/// samples all candidates alike; smaller, and an unlucky beginning excludes the best one.
const EXPLORATION: f64 = 0.1;
/// Smallest kernel between two strikes that share their samples. Smaller, and every strike has many
/// neighbours that hardly count.
const LEAST_KERNEL: f64 = 0.01;
/// Smallest kernel between a strike and a new one near it: τ of the paper. **Guess**: the new one is at
/// most 2.4 standard deviations away. With 0.3 (1.5 of them) the chosen plays of eight-ball lost 0.3
/// points of the chance of winning, 5000 simulations a decision.
const LEAST_NEAR: f64 = 0.05;

/// Number of differences that count as much as the knowledge that all strikes have about the same
/// one. **Guess**: the differences of outcomes vary by 0.1, those of strikes by 0.02.
const CAUTION: f64 = 25.0;

/// What the samples of a strike say, or with the kernel as weight those of its neighbours too.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Statistics {
    /// Number of samples, and the sum of their values.
    pub(crate) count: f64,
    pub(crate) sum: f64,
    /// Number of simulations that searched outcomes deeper.
    pub(crate) deeper: f64,
    /// Number of these outcomes, and the sum of their differences: those after which the other player
    /// shoots, and those after which the same one does.
    pub(crate) nodes: [f64; 2],
    pub(crate) differences: [f64; 2],
}

impl Statistics {
    /// Adds `share` times the change from `before` to `now`.
    fn add(&mut self, share: f64, before: &Self, now: &Self) {
        self.count += share * (now.count - before.count);
        self.sum += share * (now.sum - before.sum);
        self.deeper += share * (now.deeper - before.deeper);
        for turn in 0..2 {
            self.nodes[turn] += share * (now.nodes[turn] - before.nodes[turn]);
            self.differences[turn] += share * (now.differences[turn] - before.differences[turn]);
        }
    }
}

/// The strikes of one decision, and what their samples say about all of them.
#[derive(Clone, Debug)]
pub(crate) struct KernelRegression {
    /// Standard deviations of azimuth, speed, side and height.
    deviations: [f64; 4],
    arms: Vec<Arm>,
    /// ΣW.
    density: f64,
    /// The usual differences, by the player who shoots.
    usual: [f64; 2],
}

/// A strike.
#[derive(Clone, Debug)]
struct Arm {
    strike: Strike,
    /// Its place and call.
    group: (usize, Call),
    own: Statistics,
    shared: Statistics,
    /// The strikes that share samples with it, itself among them, and the kernels.
    neighbours: Vec<(usize, f64)>,
}

impl KernelRegression {
    /// No strikes yet. `deviations` are the standard deviations of azimuth, speed, side and height.
    pub(crate) const fn new(deviations: [f64; 4]) -> Self {
        Self { deviations, arms: Vec::new(), density: 0.0, usual: [0.0; 2] }
    }

    /// Adds a strike with its place and call, which has no samples yet.
    pub(crate) fn add(&mut self, strike: Strike, group: (usize, Call)) {
        let new = self.arms.len();
        let mut neighbours = vec![(new, 1.0)];
        let nothing = Statistics::default();
        let mut shared = nothing;
        for (k, arm) in self.arms.iter_mut().enumerate() {
            if arm.group != group {
                continue;
            }
            let kernel = kernel(&self.deviations, &arm.strike, &strike);
            if kernel >= LEAST_KERNEL {
                arm.neighbours.push((new, kernel));
                neighbours.push((k, kernel));
                shared.add(kernel, &nothing, &arm.own);
            }
        }
        self.density += shared.count;
        self.arms.push(Arm { strike, group, own: nothing, shared, neighbours });
    }

    /// Sets what the own samples of strike `k` say.
    pub(crate) fn set(&mut self, k: usize, own: Statistics) {
        let before = core::mem::replace(&mut self.arms[k].own, own);
        let neighbours = core::mem::take(&mut self.arms[k].neighbours);
        for (other, kernel) in &neighbours {
            self.arms[*other].shared.add(*kernel, &before, &own);
            self.density += kernel * (own.count - before.count);
        }
        self.arms[k].neighbours = neighbours;
        if own.nodes != [0.0; 2] {
            self.usual = [0, 1].map(|turn| self.usual_difference(turn));
        }
    }

    /// The mean difference over the calls that have one. The first of them alone would correct itself
    /// by nothing, so one more with the difference 0 is added.
    fn usual_difference(&self, turn: usize) -> f64 {
        let mut calls: Vec<((usize, Call), f64, f64)> = Vec::new();
        for arm in self.arms.iter().filter(|arm| arm.own.nodes[turn] > 0.0) {
            let (nodes, sum) = (arm.own.nodes[turn], arm.own.differences[turn]);
            match calls.iter_mut().find(|call| call.0 == arm.group) {
                Some(call) => (call.1, call.2) = (call.1 + nodes, call.2 + sum),
                None => calls.push((arm.group, nodes, sum)),
            }
        }
        let means = calls.iter().map(|(_, nodes, sum)| sum / nodes);
        means.sum::<f64>() / (1.0 + calls.len() as f64)
    }

    /// What the samples of strike `k` and of its neighbours say.
    pub(crate) fn shared(&self, k: usize) -> &Statistics {
        &self.arms[k].shared
    }

    /// The mean value of strike `k`; one half without any sample.
    pub(crate) fn mean(&self, k: usize) -> f64 {
        let Statistics { count, sum, .. } = self.arms[k].shared;
        if count > 0.0 { sum / count } else { 0.5 }
    }

    /// The correction of the mean value of strike `k`.
    pub(crate) fn correction(&self, k: usize) -> f64 {
        let Statistics { nodes, differences, .. } = &self.arms[k].shared;
        let residual = |turn: usize| differences[turn] - nodes[turn] * self.usual[turn];
        (residual(0) + residual(1)) / (nodes[0] + nodes[1] + CAUTION)
    }

    /// E of strike `k`.
    pub(crate) fn value(&self, k: usize) -> f64 {
        self.mean(k) + self.correction(k)
    }

    /// The distance of the bounds from E, for every strike: C √(ln ΣW / W).
    fn radius(&self) -> impl Fn(&Arm) -> f64 {
        let all = EXPLORATION * sqrt(log(self.density.max(1.0)));
        move |arm| all / sqrt(arm.shared.count.max(f64::MIN_POSITIVE))
    }

    /// The strike with the highest upper bound, the first of several; none without strikes.
    pub(crate) fn most_promising(&self) -> Option<usize> {
        let radius = self.radius();
        let mut best: Option<(usize, f64)> = None;
        for (k, arm) in self.arms.iter().enumerate() {
            let bound = self.value(k) + radius(arm);
            if best.is_none_or(|(_, highest)| bound > highest) {
                best = Some((k, bound));
            }
        }
        best.map(|(k, _)| k)
    }

    /// The strikes by their lower bounds, the highest first.
    pub(crate) fn ranked(&self) -> Vec<usize> {
        let radius = self.radius();
        let bound = |k: &usize| self.value(*k) - radius(&self.arms[*k]);
        let mut order: Vec<usize> = (0..self.arms.len()).collect();
        order.sort_by(|a, b| bound(b).total_cmp(&bound(a)));
        order
    }

    /// The strike near strike `k` about which least is known: of those that `steps` lead to, which are
    /// from −1 to 1 in every direction, the allowed one with the smallest W. None if `k` has no
    /// errors.
    pub(crate) fn least_known(
        &self,
        k: usize,
        steps: impl Iterator<Item = [f64; 4]>,
        is_allowed: impl Fn(&Strike) -> bool,
    ) -> Option<Strike> {
        if self.deviations == [0.0; 4] {
            return None;
        }
        let Arm { strike: center, neighbours, .. } = &self.arms[k];
        let reach = sqrt(-2.0 * log(LEAST_NEAR));
        let density = |strike: &Strike| -> f64 {
            let shared = |(other, _): &(usize, f64)| {
                let arm = &self.arms[*other];
                kernel(&self.deviations, &arm.strike, strike) * arm.own.count
            };
            neighbours.iter().map(shared).sum()
        };
        steps
            .map(|step| moved(center, &self.deviations, &step.map(|share| reach * share)))
            .filter(|strike| kernel(&self.deviations, center, strike) >= LEAST_NEAR)
            .filter(is_allowed)
            .map(|strike| (density(&strike), strike))
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map(|(_, strike)| strike)
    }
}

/// K of two strikes: e^(−d²/2), where d is their distance in standard deviations. Parameters without
/// errors have to be equal.
fn kernel(deviations: &[f64; 4], a: &Strike, b: &Strike) -> f64 {
    let differences =
        [a.azimuth - b.azimuth, a.speed - b.speed, a.side - b.side, a.height - b.height];
    let mut squares = 0.0;
    for (difference, deviation) in differences.into_iter().zip(deviations) {
        if difference != 0.0 {
            // Infinite without errors.
            let steps = difference / deviation;
            squares += steps * steps;
        }
    }
    exp(-0.5 * squares)
}

#[cfg(test)]
mod tests {
    use carom::math::exp;
    use carom::resolve::cue_ball::Strike;
    use carom_rules::Call;

    use super::{CAUTION, KernelRegression, LEAST_NEAR, Statistics, kernel};
    use crate::search::pots::sequence_point;

    /// One standard deviation of the azimuth, rad.
    const STEP: f64 = 0.002;
    const DEVIATIONS: [f64; 4] = [STEP, 0.0, 0.0, 0.0];
    const GROUP: (usize, Call) = (0, Call::Nothing);

    fn strike(steps: f64) -> Strike {
        let azimuth = 1.0 + steps * STEP;
        Strike { speed: 2.0, azimuth, elevation: 0.0, side: 0.0, height: 0.0 }
    }

    fn samples(count: f64, mean: f64) -> Statistics {
        Statistics { count, sum: count * mean, ..Statistics::default() }
    }

    #[test]
    fn the_top_of_a_hill_is_found_from_noisy_samples() {
        const TOP: f64 = 1.3;
        let mut regression = KernelRegression::new(DEVIATIONS);
        let places: Vec<f64> = (-20..=20).map(|k| 0.25 * f64::from(k)).collect();
        places.iter().for_each(|place| regression.add(strike(*place), GROUP));
        let mut own = vec![[0.0_f64; 2]; places.len()];
        for index in 0..2000 {
            let k = regression.most_promising().unwrap();
            let chance = 0.3 + 0.4 * exp(-0.1 * (places[k] - TOP) * (places[k] - TOP));
            let is_won = sequence_point(7919 * index)[0] < chance;
            own[k] = [own[k][0] + 1.0, own[k][1] + f64::from(u8::from(is_won))];
            regression.set(k, samples(own[k][0], own[k][1] / own[k][0]));
        }
        let best = regression.ranked()[0];
        assert!((places[best] - TOP).abs() < 0.8, "{}", places[best]);
        assert!((regression.value(best) - 0.7).abs() < 0.05, "{}", regression.value(best));
        // The foot of the hill was left early, and nothing there was sampled often.
        assert!(own[0][0] < 20.0 && own[best][0] > 50.0, "{own:?}");
    }

    #[test]
    fn samples_count_by_the_kernel_and_for_the_same_call_only() {
        let mut regression = KernelRegression::new(DEVIATIONS);
        regression.add(strike(0.0), GROUP);
        regression.set(0, samples(10.0, 0.8));
        regression.add(strike(1.0), GROUP);
        regression.set(1, samples(30.0, 0.4));
        regression.add(strike(0.0), (0, Call::Safety));
        regression.add(strike(0.0), (1, Call::Nothing));
        let shared = 30.0 * exp(-0.5);
        let expected = (8.0 + 0.4 * shared) / (10.0 + shared);
        assert!((regression.value(0) - expected).abs() < 1e-12);
        assert_eq!([2, 3].map(|k| regression.value(k)), [0.5; 2]);
        // A parameter without errors has to be equal.
        let faster = Strike { speed: 2.1, ..strike(0.0) };
        assert_eq!(kernel(&DEVIATIONS, &strike(0.0), &faster), 0.0);
    }

    #[test]
    fn the_bounds_shrink_with_the_samples_of_neighbours() {
        let mut regression = KernelRegression::new(DEVIATIONS);
        [0.0, 0.5, 9.0].into_iter().for_each(|place| regression.add(strike(place), GROUP));
        (0..3).for_each(|k| regression.set(k, samples(10.0, 0.5)));
        // The third is alone and the least certain: the first to be sampled, and the last to be chosen.
        assert_eq!(regression.most_promising(), Some(2));
        assert_eq!(regression.ranked()[2], 2);
    }

    #[test]
    fn what_all_calls_have_in_common_corrects_little() {
        let mut regression = KernelRegression::new(DEVIATIONS);
        let calls = [GROUP, (1, Call::Nothing), (2, Call::Nothing)];
        calls.into_iter().for_each(|group| regression.add(strike(0.0), group));
        let searched = |difference: f64| Statistics {
            nodes: [0.0, 50.0],
            differences: [0.0, 50.0 * difference],
            ..samples(50.0, 0.5)
        };
        let weight = 50.0 / (50.0 + CAUTION);
        regression.set(0, searched(-0.3));
        assert!((regression.correction(0) + 0.15 * weight).abs() < 1e-12);
        regression.set(1, searched(0.0));
        regression.set(2, searched(-0.3));
        // The usual difference is −0.6/4.
        assert!((regression.correction(0) + 0.15 * weight).abs() < 1e-12);
        assert!((regression.correction(1) - 0.15 * weight).abs() < 1e-12);
        assert!((regression.value(1) - regression.value(0) - 0.3 * weight).abs() < 1e-12);
    }

    #[test]
    fn a_new_strike_lies_where_least_is_known() {
        let mut regression = KernelRegression::new(DEVIATIONS);
        regression.add(strike(0.0), GROUP);
        regression.add(strike(1.0), GROUP);
        regression.set(0, samples(10.0, 0.5));
        regression.set(1, samples(100.0, 0.5));
        let steps = || (0..32).map(|k| sequence_point(k).map(|share| 2.0 * share - 1.0));
        let new = regression.least_known(0, steps(), |_| true).unwrap();
        assert!(new.azimuth < strike(-0.5).azimuth, "{}", new.azimuth);
        assert!(kernel(&DEVIATIONS, &new, &strike(0.0)) >= LEAST_NEAR);
        assert_eq!(regression.least_known(0, steps(), |_| false), None);
        // Without errors there is nothing between two strikes.
        let mut regression = KernelRegression::new([0.0; 4]);
        regression.add(strike(0.0), GROUP);
        assert_eq!(regression.least_known(0, steps(), |_| true), None);
    }
}
