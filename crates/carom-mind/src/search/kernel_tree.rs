//! KR-UCT with double progressive widening, as an alternative to the race.
//!
//! - T. Yee, V. Lisý, M. Bowling, *Monte Carlo tree search in continuous action spaces with execution
//!   uncertainty*, IJCAI 2016: the choice of strikes by kernel regression, and new strikes near good ones.
//! - A. Couëtoux, J.-B. Hoock, N. Sokolovska, O. Teytaud, N. Bonnard, *Continuous upper confidence
//!   trees*, LION 2011: progressive widening of the outcomes of a strike as well.
//!
//! A decision node has strikes, and a strike has outcomes, which are drawn with the player's errors.
//! Outcome i has the same errors below all strikes of a node. An outcome has the value of its position
//! until it becomes a decision node of the player who is to shoot there. The values of a node are those
//! of its player, v, and 1 − v for the other one.
//!
//! Departures from the papers, all **guesses**, because their outcomes were cheap to search and ours
//! are cheap to value:
//!
//! - The simulations below a strike and its neighbours, weighted by the kernel, count as its visits,
//!   those that look for plays included. So the widening alone divides them between new outcomes and
//!   deeper search, whatever a search costs.
//! - The mean of a strike counts every outcome once, by the value of its position. The few outcomes that
//!   have become nodes correct it (see `kernel_regression`).
//! - A node is worth E of the strike that it would choose, and not the mean of its simulations, most of
//!   which explore.
//! - A node is visited [`VISITS`] times before the next outcome of the strike becomes one, and later
//!   only if no other outcome can.
//! - The prior of a play counts as some samples, so that candidates without samples have a value.
//! - Nodes that ask for a choice or for an opening shot keep the value of the position.
//!
//! The losses beside the constants, here and in `kernel_regression`, are means over 150 positions of
//! eight-ball. They were measured once, to choose the constants, with a program that is not kept.
//!
//! The search is sequential: every visit depends on all visits before it. The runner of the budget is
//! not used.

use carom::Error;
use carom::math::pow;
use carom::resolve::cue_ball::Strike;
use carom_plan::{Prepared, Sampler};
use carom_rules::{Frame, Play, Seat};

use super::candidate::{Candidate, PRIOR_SAMPLES};
use super::kernel_regression::{KernelRegression, Statistics};
use super::pots::{largest_offset, sequence_point};
use super::race::Race;
use super::replies::{QuickPlays, quick_plays};
use super::shift::deviations;
use crate::player::Situation;

/// A strike with n simulations has at most FACTOR n^POWER outcomes: 6 of 10, 50 of 100, 400 of 1000.
/// **Guess**: Couëtoux et al. have powers from 0.1 to 0.5. Smaller, and the chance of a pot has a large
/// error; nearer to 1, and nothing is searched deeper.
const OUTCOME_FACTOR: f64 = 0.8;
const OUTCOME_POWER: f64 = 0.9;
/// A node with n visits gets a new strike while it has at most n^POWER. **Guess**: Yee et al. have √n,
/// and far fewer candidates at the start. With √n the chosen plays of eight-ball lost 0.7 points of
/// the chance of winning, 5000 simulations a decision; with n^0.8 they lost 0.5.
const STRIKE_POWER: f64 = 0.7;
/// New strikes that are considered, of which the least known is taken.
const NEW_STRIKES: u64 = 16;
/// Visits of a node before another outcome of the same strike becomes one. **Guess**: enough to tell
/// its best few plays apart.
const VISITS: u64 = 40;
/// Strikes of the root that stay from one round to the next.
const KEPT: usize = 64;
/// The speed, m/s, for which the kernel takes the errors that grow with the speed: that of a usual shot.
const USUAL_SPEED: f64 = 2.0;
/// Makes a seed of the number of an outcome: 2^64 / φ. Otherwise the errors after an outcome would be
/// those that led to it.
const SEED_STEP: u64 = 0x9e37_79b9_7f4a_7c15;

/// The tree of a search.
#[derive(Clone, Debug, Default)]
pub(crate) struct KernelTree {
    root: Option<DecisionNode>,
}

impl KernelTree {
    /// Adds candidates and searches with at most `simulations` simulations. `per_node` simulations look
    /// for the plays of a node. Returns the number of simulations.
    ///
    /// # Errors
    /// As [`Sampler::simulate_variant`].
    pub(crate) fn search(
        &mut self,
        race: &Race<'_>,
        candidates: Vec<Candidate>,
        (simulations, per_node): (u64, u64),
    ) -> Result<u64, Error> {
        let mut root = DecisionNode::new(race);
        if let Some(before) = self.root.take() {
            (root.visits, root.tried) = (before.visits, before.tried);
            let order = before.regression.ranked();
            let mut actions: Vec<Option<Action>> = before.actions.into_iter().map(Some).collect();
            for k in order.into_iter().take(KEPT) {
                actions[k].take().into_iter().for_each(|action| root.add(action));
            }
        }
        candidates.into_iter().for_each(|candidate| root.add(Action::new(candidate)));
        let mut scratch =
            Scratch { sampler: Sampler::new(), successor: race.situation.frame.clone(), per_node };
        let mut spent = 0;
        while spent < simulations && !root.actions.is_empty() {
            spent += root.visit(race, &mut scratch, simulations - spent)?;
        }
        self.root = Some(root);
        Ok(spent)
    }

    /// The plays of the root, the best first.
    pub(crate) fn ranked(&self) -> Vec<Candidate> {
        let Some(root) = &self.root else { return Vec::new() };
        let order = root.regression.ranked();
        let corrected = |k: usize| Candidate {
            correction: root.regression.correction(k),
            ..root.actions[k].candidate.clone()
        };
        order.into_iter().map(corrected).collect()
    }
}

/// Memory that is used again.
struct Scratch {
    sampler: Sampler,
    successor: Frame,
    per_node: u64,
}

/// A position in which a player shoots.
#[derive(Clone, Debug)]
struct DecisionNode {
    actions: Vec<Action>,
    regression: KernelRegression,
    visits: u64,
    /// Number of strikes that the widening has considered.
    tried: u64,
}

impl DecisionNode {
    fn new(race: &Race<'_>) -> Self {
        let noise = &race.situation.noise[race.seat];
        let deviations = deviations(noise, USUAL_SPEED, cue_radius(race));
        let regression = KernelRegression::new(deviations);
        Self { actions: Vec::new(), regression, visits: 0, tried: 0 }
    }

    fn add(&mut self, action: Action) {
        let Candidate { play, place, .. } = &action.candidate;
        self.regression.add(play.strike, (*place, play.call));
        self.actions.push(action);
        self.share(self.actions.len() - 1);
    }

    /// Passes the samples of an action on to its neighbours.
    fn share(&mut self, k: usize) {
        self.regression.set(k, self.actions[k].statistics);
    }

    /// E of the play that the node would choose; none without plays.
    fn value(&self) -> Option<f64> {
        self.regression.ranked().first().map(|k| self.regression.value(*k))
    }

    /// Plays one of the actions, a new one if there are few. Returns the number of simulations, at
    /// most `left`.
    fn visit(&mut self, race: &Race<'_>, scratch: &mut Scratch, left: u64) -> Result<u64, Error> {
        let Some(mut k) = self.regression.most_promising() else { return Ok(0) };
        self.visits += 1;
        if self.actions.len() as f64 <= pow(self.visits as f64, STRIKE_POWER) {
            k = self.widen(race, k).unwrap_or(k);
        }
        let action = &mut self.actions[k];
        let spent = match action.to_search(self.regression.shared(k), scratch.per_node, left) {
            Some(outcome) => action.search(outcome, race, scratch, left)?,
            None => action.draw(race, scratch)?,
        };
        self.share(k);
        Ok(spent)
    }

    /// Adds the strike near action `k` about which least is known. Returns its number.
    fn widen(&mut self, race: &Race<'_>, k: usize) -> Option<usize> {
        let candidate = &self.actions[k].candidate;
        let meant = candidate.play.strike;
        let shot = race.prepared[candidate.place].shot();
        let noise = &race.situation.noise[race.seat];
        let most = largest_offset(shot, noise, cue_radius(race)).max(meant.offset());
        let is_allowed = |strike: &Strike| {
            strike.speed > 0.0 && strike.offset() <= most && shot.check_strike(strike).is_ok()
        };
        let first = self.tried;
        self.tried += NEW_STRIKES;
        let steps =
            (first..self.tried).map(|index| sequence_point(index).map(|share| 2.0 * share - 1.0));
        let strike = self.regression.least_known(k, steps, is_allowed)?;
        let play = Play { strike, ..candidate.play };
        let (samples, fresh, prior) = (Vec::new(), Vec::new(), self.regression.mean(k));
        let new = Candidate { play, prior, samples, fresh, correction: 0.0, ..candidate.clone() };
        self.add(Action::new(new));
        Some(self.actions.len() - 1)
    }
}

/// A strike that a node considers.
#[derive(Clone, Debug)]
struct Action {
    candidate: Candidate,
    /// The outcomes, one for each sample of the candidate.
    outcomes: Vec<Outcome>,
    /// What its own outcomes say.
    statistics: Statistics,
}

/// What follows a strike with certain errors.
#[derive(Clone, Debug)]
enum Outcome {
    /// The value of the position stands for it.
    Valued,
    /// It may become a node.
    Open,
    Searched(Box<Successor>),
}

impl Action {
    fn new(candidate: Candidate) -> Self {
        let (count, sum) = (PRIOR_SAMPLES, PRIOR_SAMPLES * candidate.prior);
        let statistics = Statistics { count, sum, ..Statistics::default() };
        Self { candidate, outcomes: Vec::new(), statistics }
    }

    /// The outcome that is searched next; none if another one is to be drawn.
    fn to_search(&self, shared: &Statistics, per_node: u64, left: u64) -> Option<usize> {
        if shared.count < allowed(shared, 1) {
            return None;
        }
        let nodes = || {
            self.outcomes.iter().enumerate().filter_map(|(k, outcome)| match outcome {
                Outcome::Searched(successor) => Some((k, successor.node.visits)),
                _ => None,
            })
        };
        if let Some((k, _)) = nodes().find(|(_, visits)| *visits < VISITS) {
            return Some(k);
        }
        let open = self.outcomes.iter().position(|outcome| matches!(outcome, Outcome::Open));
        let cost = 1 + per_node + VISITS;
        match open {
            Some(_) if left < cost || shared.count < allowed(shared, cost) => None,
            Some(k) => Some(k),
            None => nodes().min_by_key(|(_, visits)| *visits).map(|(k, _)| k),
        }
    }

    /// Draws an outcome.
    fn draw(&mut self, race: &Race<'_>, scratch: &mut Scratch) -> Result<u64, Error> {
        let index = self.outcomes.len() as u64;
        let memory = (&mut scratch.sampler, &mut scratch.successor);
        let samples = race.play(&self.candidate, memory, index..index + 1)?;
        self.statistics.count += 1.0;
        self.statistics.sum += samples.iter().map(|sample| sample.value).sum::<f64>();
        self.candidate.samples.extend(samples);
        let is_shot = scratch.successor.turn().is_some() && !scratch.successor.is_opening();
        self.outcomes.push(if is_shot { Outcome::Open } else { Outcome::Valued });
        Ok(1)
    }

    /// Makes a node of outcome `k`, or visits it if it is one.
    fn search(
        &mut self,
        k: usize,
        race: &Race<'_>,
        scratch: &mut Scratch,
        left: u64,
    ) -> Result<u64, Error> {
        let estimated = self.candidate.samples[k].value;
        let spent = match &mut self.outcomes[k] {
            Outcome::Searched(successor) => successor.visit(race, scratch, (k, left))?,
            outcome => {
                let (spent, found) = Successor::new(&self.candidate, race, scratch, k)?;
                *outcome = found.map_or(Outcome::Valued, Outcome::Searched);
                spent
            }
        };
        if let Outcome::Searched(successor) = &mut self.outcomes[k] {
            successor.compare(race.seat, estimated, &mut self.statistics);
        }
        self.statistics.deeper += spent as f64;
        Ok(spent)
    }
}

/// An outcome that has become a node.
#[derive(Clone, Debug)]
struct Successor {
    frame: Frame,
    seat: Seat,
    place: Option<[f64; 2]>,
    node: DecisionNode,
    /// Value of the node less the estimate of its position, for the player before it.
    difference: Option<f64>,
}

impl Successor {
    /// Makes a node of outcome `index` of a candidate. Returns the number of simulations too; no node
    /// without plays.
    fn new(
        candidate: &Candidate,
        race: &Race<'_>,
        scratch: &mut Scratch,
        index: usize,
    ) -> Result<(u64, Option<Box<Self>>), Error> {
        let memory = (&mut scratch.sampler, &mut scratch.successor);
        race.play(candidate, memory, index as u64..index as u64 + 1)?;
        let frame = scratch.successor.clone();
        let Some(turn) = frame.turn() else { return Ok((1, None)) };
        let situation = after(race.situation, &frame, index);
        let QuickPlays { place, plays, simulations } =
            quick_plays(&situation, race.value, turn, scratch.per_node)?;
        if plays.is_empty() {
            return Ok((1 + simulations, None));
        }
        let (seat, prepared) = (turn.player, [Prepared::new(&frame, place)?]);
        let race = Race { situation: &situation, prepared: &prepared, seat, ..*race };
        let mut node = DecisionNode::new(&race);
        plays.into_iter().for_each(|candidate| node.add(Action::new(candidate)));
        let successor = Self { frame, seat, place, node, difference: None };
        Ok((1 + simulations, Some(Box::new(successor))))
    }

    /// Visits the node of outcome `index`.
    fn visit(
        &mut self,
        race: &Race<'_>,
        scratch: &mut Scratch,
        (index, left): (usize, u64),
    ) -> Result<u64, Error> {
        let situation = after(race.situation, &self.frame, index);
        let prepared = [Prepared::new(&self.frame, self.place)?];
        let race = Race { situation: &situation, prepared: &prepared, seat: self.seat, ..*race };
        self.node.visit(&race, scratch, left)
    }

    /// Compares the value of the node with the estimate of its position, for `seat`.
    fn compare(&mut self, seat: Seat, estimated: f64, statistics: &mut Statistics) {
        let Some(value) = self.node.value() else { return };
        let is_same = self.seat == seat;
        let difference = if is_same { value } else { 1.0 - value } - estimated;
        let turn = usize::from(is_same);
        statistics.nodes[turn] += f64::from(u8::from(self.difference.is_none()));
        statistics.differences[turn] += difference - self.difference.unwrap_or(0.0);
        self.difference = Some(difference);
    }
}

/// The number of outcomes near a strike that the widening allows after `more` simulations.
fn allowed(shared: &Statistics, more: u64) -> f64 {
    OUTCOME_FACTOR * pow(shared.count + shared.deeper + more as f64, OUTCOME_POWER)
}

/// The situation after outcome `index` of a strike.
fn after<'a>(before: &Situation<'_>, frame: &'a Frame, index: usize) -> Situation<'a> {
    let step = SEED_STEP.wrapping_mul(index as u64 + 1);
    Situation { frame, seed: before.seed.wrapping_add(step), ..before.clone() }
}

/// The radius of the cue ball, m.
fn cue_radius(race: &Race<'_>) -> f64 {
    race.prepared.first().map_or(0.0, |prepared| prepared.struck_ball().radius)
}

#[cfg(test)]
mod tests {
    use carom::Noise;
    use carom::resolve::cue_ball::Strike;
    use carom::runner::Runner;
    use carom_plan::{Prepared, Sampler};
    use carom_rules::{Call, Frame, Options, Play, Rules, Turn};

    use super::{KernelTree, Outcome, STRIKE_POWER, VISITS, allowed, pow};
    use crate::player::Situation;
    use crate::search::race::Race;
    use crate::search::replies::quick_plays;
    use crate::search::{Candidate, PlayKind};
    use crate::settings::Allocation;
    use crate::value::{Logistic, Position, Value};

    const PER_NODE: u64 = 40;

    /// A frame of nine-ball with these balls.
    fn nine_ball(places: &[(usize, [f64; 2])]) -> Frame {
        let mut frame = Frame::new(Rules::NineBall, Options::default(), None, None, 0).unwrap();
        let mut all = vec![None; frame.layout().len()];
        places.iter().for_each(|(ball, place)| all[*ball] = Some(*place));
        frame.resume_at(&all, 0).unwrap();
        frame
    }

    /// The tree of `candidates` after each of these numbers of simulations, one after the other.
    fn searched(
        situation: &Situation<'_>,
        value: &dyn Value,
        candidates: Vec<Candidate>,
        simulations: &[u64],
    ) -> KernelTree {
        let prepared = [Prepared::new(situation.frame, None).unwrap()];
        let race = Race {
            foul_correction: 0.0,
            situation,
            value,
            prepared: &prepared,
            seat: 0,
            runner: &Runner::new(Some(1)).unwrap(),
            common_errors: true,
            allocation: Allocation::Halving,
        };
        let (mut tree, mut candidates) = (KernelTree::default(), candidates);
        for wanted in simulations {
            let new = core::mem::take(&mut candidates);
            let spent = tree.search(&race, new, (*wanted, PER_NODE)).unwrap();
            // A search for plays may cost a few simulations more than it should.
            assert!((*wanted..wanted + 10).contains(&spent), "{spent} of {wanted}");
        }
        tree
    }

    fn eight_and_nine() -> Frame {
        nine_ball(&[(0, [0.4, 0.6]), (8, [0.8, 1.4]), (9, [0.3, 1.9])])
    }

    fn two_balls(simulations: &[u64]) -> KernelTree {
        let frame = eight_and_nine();
        let situation = Situation::new(&frame, Noise::olympiad(1.0), 5);
        let found = quick_plays(&situation, &Logistic, frame.turn().unwrap(), 100).unwrap();
        searched(&situation, &Logistic, found.plays, simulations)
    }

    #[test]
    fn strikes_and_outcomes_are_widened_by_their_powers() {
        let tree = two_balls(&[4000]);
        let root = tree.root.unwrap();
        let most = pow(root.visits as f64, STRIKE_POWER) + 1.0;
        let count = root.actions.len() as f64;
        assert!(count <= most && count > most - 2.0, "{count} of {most}");
        let is_node = |outcome: &&Outcome| matches!(outcome, Outcome::Searched(_));
        let mut nodes = 0;
        for (k, action) in root.actions.iter().enumerate() {
            assert_eq!(action.outcomes.len(), action.candidate.samples.len());
            nodes += action.outcomes.iter().filter(is_node).count();
            // An action saves for the next node, and at the end there may not be enough left for one.
            let node = 1 + PER_NODE + VISITS;
            let shared = root.regression.shared(k);
            let most = allowed(shared, node) + node as f64;
            assert!(shared.count <= most, "{} of {most}", shared.count);
        }
        assert!(nodes > 3, "{nodes}");
    }

    #[test]
    fn the_same_search_gives_the_same_bits() {
        let [one, other] = [0, 1].map(|_| two_balls(&[3000, 3000]).ranked());
        assert_eq!(one, other);
        assert!(one.iter().any(|candidate| candidate.correction != 0.0));
    }

    /// Says that a nine near a pocket is bad for the player who may pot it.
    struct Misleading;

    impl Value for Misleading {
        fn name(&self) -> &'static str {
            "misleading"
        }

        fn of_shot(&self, position: &Position<'_>, _: &Turn) -> f64 {
            0.45 + 0.1 * distance_to_pocket(position.frame).min(1.0)
        }
    }

    /// Distance of the nine to the nearest pocket, m.
    fn distance_to_pocket(frame: &Frame) -> f64 {
        let Some([x, y]) = frame.layout().place(9) else { return 0.0 };
        let [width, length] = [1.27, 2.54];
        let across = x.min(width - x);
        let along = [y, (y - 0.5 * length).abs(), length - y].into_iter().fold(9.0, f64::min);
        carom::math::sqrt(across * across + along * along)
    }

    fn safety(strike: Strike) -> Candidate {
        Candidate {
            play: Play::new(strike),
            kind: PlayKind::Safety,
            line: None,
            legs: Vec::new(),
            pot: None,
            place: 0,
            prior: 0.5,
            end: None,
            samples: Vec::new(),
            fresh: Vec::new(),
            correction: 0.0,
        }
    }

    #[test]
    fn a_second_ply_corrects_a_value_that_misleads() {
        let frame = nine_ball(&[(0, [0.4, 0.6]), (9, [0.635, 0.9])]);
        let prepared = Prepared::new(&frame, None).unwrap();
        let (mut sampler, mut successor) = (Sampler::new(), frame.clone());
        let mut safeties = Vec::new();
        for k in 0..400 {
            let azimuth = 0.75 + 0.001 * f64::from(k);
            let strike = Strike { speed: 1.5, azimuth, elevation: 0.05, side: 0.0, height: 0.0 };
            sampler.simulate(&prepared, &strike).unwrap();
            let ruling = sampler.rule(&prepared, Call::Nothing, &mut successor).unwrap();
            if ruling.is_legal() && successor.player() == Some(1) {
                safeties.push((distance_to_pocket(&successor), safety(strike)));
            }
        }
        safeties.sort_by(|a, b| a.0.total_cmp(&b.0));
        let [(least, near), .., (most, far)] = safeties.as_slice() else { panic!("no safeties") };
        assert!(*least < 0.15 && *most > 0.5, "{least} to {most}");
        let noise = [Noise::NONE, Noise::olympiad(3.0)];
        let situation = Situation { noise, ..Situation::new(&frame, Noise::NONE, 1) };
        let best = |simulations| {
            let candidates = vec![near.clone(), far.clone()];
            let tree = searched(&situation, &Misleading, candidates, &[simulations]);
            tree.ranked()[0].play
        };
        assert_eq!(best(60), near.play);
        assert_eq!(best(8000), far.play);
    }
}
