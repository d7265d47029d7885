//! Variants of a shot in a game: each is simulated once, and the frame rules on it.

use carom::batch::{BatchResult, OFF_TABLE, ON_TABLE, PADDING};
use carom::noise::Errors;
use carom::resolve::cue_ball::Strike;
use carom::runner::Runner;
use carom::{Error, ErrorKind, MotionState, Shot};
use carom_rules::{Call, Frame, Play, Prepared};

use crate::drawn_tables::DrawnTables;
use crate::sampler::Sampler;

/// A game in which the shot is played.
#[derive(Clone, Copy, Debug)]
pub struct Referee<'a> {
    /// The frame. The shot must be the one that it asks for.
    pub frame: &'a Frame,
    /// The player's call.
    pub call: Call,
}

/// A shot that its frame asks for, with a player's errors.
pub(crate) struct Refereed<'a> {
    prepared: Prepared<'a>,
    call: Call,
    meant: Strike,
    errors: Errors,
}

/// The ruling on a variant.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct VariantRuling {
    /// The shot was legal.
    pub(crate) legal: bool,
    /// The same player has the turn again or has won.
    pub(crate) turn_kept: bool,
}

/// One variant: the end of every ball, and the frame's ruling.
struct RuledVariant {
    ends: Vec<(i8, [f64; 3])>,
    verdict: VariantRuling,
}

impl<'a> Refereed<'a> {
    /// Rejects a shot without a strike, and one that `referee`'s frame does not ask for.
    pub(crate) fn new(shot: &'a Shot, referee: Referee<'a>, errors: Errors) -> Result<Self, Error> {
        let Referee { frame, call } = referee;
        let Some((cue_ball, meant)) = shot.strike() else {
            return Err(ErrorKind::NoStrike.at(
                "strike",
                "the shot has no strike to vary",
                "give it one",
            ));
        };
        let lies = shot.balls()[cue_ball].state.position;
        let in_hand = frame.turn().is_some_and(|turn| turn.hand.is_some());
        let place = in_hand.then_some([lies.x, lies.y]);
        let policy = shot.strike_policy();
        let asked = frame.shot(&Play { cue_ball: place, call, policy, ..Play::new(meant) })?;
        // The strike may differ, because the conversion of angles to degrees rounds them.
        if asked.balls() != shot.balls()
            || asked.table() != shot.table()
            || asked.physics() != shot.physics()
        {
            return Err(ErrorKind::Mismatch.at(
                "frame",
                "it asks for a shot with other balls, table or physics",
                "evaluate the shot that the frame gives: frame.shot(...)",
            ));
        }
        Ok(Self { prepared: Prepared::with_shot(frame, place, shot)?, call, meant, errors })
    }

    /// Plays `count` variants from number `first` on, on `tables` in turn.
    pub(crate) fn simulate(
        &self,
        first: u64,
        count: usize,
        tables: &DrawnTables,
        runner: &Runner,
    ) -> (BatchResult, Vec<VariantRuling>) {
        let shots = tables.shots(self.prepared.shot());
        let (noise, struck) = (&self.errors.noise, self.prepared.struck_ball());
        let worker = || (Sampler::new(), self.prepared.frame().clone());
        self.gather(runner.map(first..first + count as u64, worker, |(sampler, successor), k| {
            let strike = noise.draw(&self.meant, &struck, self.errors.seed, k);
            let shot = &shots[tables.index(k)];
            sampler.simulate_on(&self.prepared, shot, &strike, &self.errors, k)?;
            self.rule(sampler, successor)
        }))
    }

    fn rule(&self, sampler: &Sampler, successor: &mut Frame) -> Result<RuledVariant, Error> {
        let ruling = sampler.rule(&self.prepared, self.call, successor)?;
        let turn_kept = successor.keeps_turn(self.prepared.turn().player);
        let verdict = VariantRuling { legal: ruling.is_legal(), turn_kept };
        Ok(RuledVariant { ends: self.ends(sampler), verdict })
    }

    /// The end of every ball: its pocket, numbered as in a batch, and its position.
    fn ends(&self, sampler: &Sampler) -> Vec<(i8, [f64; 3])> {
        let pockets = &self.prepared.shot().table().pockets;
        let pocket = |ball| {
            let fell = sampler.outcome().pocketed.iter().find(|(b, _)| *b == ball);
            fell.and_then(|(_, name)| pockets.iter().position(|pocket| pocket.name == *name))
        };
        let ends = self.prepared.balls().iter().zip(sampler.last());
        ends.map(|(&ball, state)| {
            let end = match (state.motion, pocket(ball)) {
                (MotionState::OffTable, _) => OFF_TABLE,
                (_, Some(pocket)) => pocket as i8,
                (_, None) => ON_TABLE,
            };
            (end, state.position.to_array())
        })
        .collect()
    }

    fn gather(
        &self,
        played: Vec<Result<RuledVariant, Error>>,
    ) -> (BatchResult, Vec<VariantRuling>) {
        let balls = self.prepared.balls().len();
        let mut all = BatchResult { shots: played.len(), balls, ..BatchResult::default() };
        let mut verdicts = Vec::with_capacity(played.len());
        for (k, one) in played.into_iter().enumerate() {
            match one {
                Ok(RuledVariant { ends, verdict }) => {
                    all.pocket.extend(ends.iter().map(|(pocket, _)| pocket));
                    all.final_position.extend(ends.iter().map(|(_, place)| place));
                    verdicts.push(verdict);
                }
                Err(error) => {
                    all.pocket.extend(std::iter::repeat_n(PADDING, balls));
                    all.final_position.extend(std::iter::repeat_n([f64::NAN; 3], balls));
                    all.errors.push((k, error));
                    verdicts.push(VariantRuling::default());
                }
            }
        }
        (all, verdicts)
    }
}
