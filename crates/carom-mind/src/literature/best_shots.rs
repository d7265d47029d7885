//! The value of a position by its best shots.
//!
//! PickPocket and CueCard rate a position by the probabilities of the best shots that it offers to
//! the player at the table, with falling weights (Smith 2007; Archibald, Altman & Shoham 2009).

use std::sync::Arc;

use carom_rules::{BallIndex, Frame, Request, Seat, Turn};

use super::pot_table::PotTable;
use crate::line;
use crate::scene::Scene;
use crate::targets::Targets;
use crate::value::{Lanes, Markov, Position, Value};

/// Number of shots that are counted.
pub(crate) const COUNTED: usize = 3;

/// The value of a position by the best shots of the player at the table.
#[derive(Clone, Debug)]
pub(crate) struct BestShots {
    /// The potting probabilities of seat 0 and seat 1.
    pub(crate) tables: [Arc<PotTable>; 2],
    /// The weights of the best shots, the best first.
    pub(crate) weights: [f64; COUNTED],
}

impl BestShots {
    /// The weighted mean of the probabilities of the best direct shots of different balls, 0 to 1.
    pub(crate) fn promise(&self, position: &Position<'_>, turn: &Turn) -> f64 {
        let best = self.best(position, turn);
        let sum: f64 = best.iter().zip(self.weights).map(|(chance, weight)| weight * chance).sum();
        // At the end of a rack fewer balls are left than shots are counted.
        let count = Targets::of(position.frame, turn).objects.len().clamp(1, COUNTED);
        (sum / self.weights[..count].iter().sum::<f64>()).min(1.0)
    }

    /// The probabilities of the best direct shots of different balls, the best first.
    pub(crate) fn best(&self, position: &Position<'_>, turn: &Turn) -> [f64; COUNTED] {
        let frame = position.frame;
        if turn.hand.is_some() {
            return Lanes::of(frame, turn, &position.noise[turn.player]).chances;
        }
        let scene = Scene::new(frame);
        let mut lines = Vec::new();
        line::direct(&scene, &Targets::of(frame, turn), &mut lines);
        let radius = frame.layout().balls()[usize::from(turn.cue)].ball.radius;
        let table = &self.tables[turn.player];
        let mut best: [(f64, Option<BallIndex>); COUNTED] = [(0.0, None); COUNTED];
        for line in &lines {
            let chance = table.chance(line, radius);
            // The lines of a ball follow each other, so its better line replaces the worse one.
            let known = best.iter().position(|(_, ball)| *ball == Some(line.object));
            let last = known.unwrap_or(COUNTED - 1);
            if chance > best[last].0 {
                best[last] = (chance, Some(line.object));
                best.sort_by(|a, b| b.0.total_cmp(&a.0));
            }
        }
        best.map(|(chance, _)| chance)
    }

    /// What a shot that leaves `position` is worth for `seat`, for players that look at their own
    /// shots only: 1 for a win, −1 for a loss, 0 if the other player comes to the table, and
    /// otherwise [`Self::promise`]. Guess: the papers do not print the values of wins and losses.
    pub(crate) fn gain(&self, position: &Position<'_>, seat: Seat) -> f64 {
        match position.frame.request() {
            Request::Over { winner, .. } => {
                winner.map_or(0.0, |winner| if winner == seat { 1.0 } else { -1.0 })
            }
            Request::Shot(turn) if turn.player == seat => self.promise(position, turn),
            Request::Choice { player, .. } if *player == seat => self.win_chance(position, seat),
            _ => 0.0,
        }
    }
}

impl Value for BestShots {
    fn name(&self) -> &'static str {
        "best-shots"
    }

    /// The promise of the player at the table stands for its probability of winning. Positions
    /// without pots on the table (openings, carom games) are valued by the Markov chain.
    fn of_shot(&self, position: &Position<'_>, turn: &Turn) -> f64 {
        let frame: &Frame = position.frame;
        if frame.is_opening() || frame.facts().is_carom() {
            return Markov::default().of_shot(position, turn);
        }
        self.promise(position, turn)
    }
}
