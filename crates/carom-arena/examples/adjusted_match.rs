//! A match in which the estimate of the share of points is corrected for luck.
//!
//! ```sh
//! cargo run --release -p carom-arena --example adjusted_match -- \
//!     carom:3000 pick-pocket:3000 eight-ball poolfiz 1 0 100
//! ```
//!
//! The words are the two players, the game, the table, the multiple of the Computational Olympiad's
//! errors, the number of the first rack and the number of racks. Each rack is played twice, with the
//! seats swapped, and both players break full from the middle of the head string at 8 m/s.
//!
//! The luck of a shot is the value of the position that it left, minus the mean value over other
//! drawn errors of the same play. Its mean is 0, whatever the value, so the points minus the luck of
//! all shots have the same mean as the points alone, and a smaller variance (Burch, Schmid, Moravčík,
//! Morrill & Bowling, *AIVAT*, AAAI 2018). The same draws give the chance that each play keeps the
//! turn. Both frames of a rack have the same break with the same errors, so its luck cancels.

mod judge;

use std::error::Error;

use carom::Noise;
use carom::format::Node;
use carom::noise::Errors;
use carom::resolve::cue_ball::Strike;
use carom_arena::BuiltInPlayer;
use carom_mind::value::{Logistic, Position, Value};
use carom_mind::{Answer, Budget, Player, Situation};
use carom_plan::{Prepared, Sampler};
use carom_rules::{Call, Frame, Game, Options, Play, Request, Seat};
use judge::judge;

/// Drawn errors for the mean value after a play. Their cost is small beside a decision's.
const SAMPLES: u64 = 100;
/// Simulations of a decision for a player whose name has no number.
const USUAL: u32 = 3000;
/// Cue speed (m/s) and height (ball radii) of every break.
const BREAK_SPEED: f64 = 8.0;
const BREAK_HEIGHT: f64 = 0.11;
/// Distance of the cue ball behind the head string in every break, m.
const BEHIND: f64 = 0.03;
/// Separate the errors of executed strikes, and of the draws for the means, from the racks' seeds.
const STREAM: u64 = 0x6164_6a75;
const FRESH: u64 = 0x6d65_616e;
/// Number of standard errors on either side of a 95 % interval.
const WIDE: f64 = 1.96;

/// What is played.
struct Terms {
    game: Game,
    table: String,
    noise: Noise,
}

/// What a player did.
#[derive(Clone, Copy, Default)]
struct Tally {
    decisions: u32,
    simulations: u64,
    safeties: u32,
    pots: u32,
    /// Sum over the pots of the chances that the turn is lost.
    lost: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [one, other, game, table, multiple, first, count] = words.as_slice() else {
        return Err("usage: adjusted_match PLAYER PLAYER GAME TABLE NOISE FIRST COUNT".into());
    };
    let noise = Noise::olympiad(multiple.parse()?);
    let terms = Terms { game: Game::read(game)?, table: table.clone(), noise };
    let (first, count): (u64, u64) = (first.parse()?, count.parse()?);
    let entries = [BuiltInPlayer::read(one)?, BuiltInPlayer::read(other)?];
    let mut players = [entries[0].make()?, entries[1].make()?];
    let simulations = [0, 1].map(|k: usize| u64::from(entries[k].simulations().unwrap_or(USUAL)));
    let mut tallies = [Tally::default(); 2];
    let (mut points, mut adjusted) = (Vec::new(), Vec::new());
    for rack in first..first + count {
        let (mut won, mut luck) = (0.0, 0.0);
        for breaker in 0..2 {
            let mut frame = AdjustedFrame::new(&terms, rack, breaker)?;
            won += 0.5 * frame.play((&mut players, simulations), &mut tallies)?;
            luck += 0.5 * frame.luck;
        }
        points.push(won);
        adjusted.push(won - luck);
    }
    println!("{one} against {other}, {count} pairs: {} points", shown(&points));
    println!("corrected for luck: {}", shown(&adjusted));
    for (name, tally) in [one, other].into_iter().zip(tallies) {
        println!(
            "{name}: {:.0} simulations a decision, {} safeties, {} other shots that lose the turn with \
             {:.1} %",
            tally.simulations as f64 / f64::from(tally.decisions.max(1)),
            tally.safeties,
            tally.pots,
            100.0 * tally.lost / f64::from(tally.pots.max(1)),
        );
    }
    Ok(())
}

/// The mean of the pairs in percent, with its 95 % interval by the normal approximation.
fn shown(pairs: &[f64]) -> String {
    let count = pairs.len() as f64;
    let mean = pairs.iter().sum::<f64>() / count;
    let squares: f64 = pairs.iter().map(|pair| (pair - mean) * (pair - mean)).sum();
    let error = carom::math::sqrt(squares / (count - 1.0) / count);
    format!("{:.1} % ± {:.1}", 100.0 * mean, 100.0 * WIDE * error)
}

/// A frame that is played.
struct AdjustedFrame<'a> {
    terms: &'a Terms,
    frame: Frame,
    sampler: Sampler,
    /// Of the executed strikes.
    errors: Errors,
    rack: u64,
    /// The player who sits at seat 0.
    breaker: usize,
    /// Number of decisions so far.
    decisions: u64,
    /// The first player's luck so far.
    luck: f64,
}

impl<'a> AdjustedFrame<'a> {
    fn new(terms: &'a Terms, rack: u64, breaker: usize) -> Result<Self, carom::Error> {
        let table = Some(Node::from(terms.table.as_str()));
        let frame = Frame::new(terms.game, Options::default(), table, None, rack)?;
        let errors =
            Errors { noise: terms.noise.clone(), seed: rack ^ STREAM << 32, ..Errors::default() };
        let sampler = Sampler::new();
        Ok(Self { terms, frame, sampler, errors, rack, breaker, decisions: 0, luck: 0.0 })
    }

    /// Plays the frame. Returns the first player's points: 1, 0, or half a point without a winner.
    fn play(
        &mut self,
        (players, simulations): (&mut [Box<dyn Player>; 2], [u64; 2]),
        tallies: &mut [Tally; 2],
    ) -> Result<f64, carom::Error> {
        while let Some(seat) = self.frame.player() {
            self.decisions += 1;
            if self.frame.is_opening() {
                let play = self.break_shot();
                self.execute(&play)?;
                continue;
            }
            let player = (seat + self.breaker) % 2;
            let seed = (self.rack << 16) + self.decisions;
            let situation = Situation::new(&self.frame, self.terms.noise.clone(), seed);
            let budget = Budget::simulations(simulations[player]);
            let decision = players[player].decide(&situation, &budget)?;
            let tally = &mut tallies[player];
            tally.decisions += 1;
            tally.simulations += decision.spent.simulations;
            match decision.answer {
                Answer::Choice(choice) => drop(self.frame.choose(choice)?),
                Answer::Concede => drop(self.frame.concede()?),
                Answer::Play(play) => {
                    let (mean, kept) = self.chances(&play)?;
                    if matches!(play.call, Call::Safety) {
                        tally.safeties += 1;
                    } else {
                        tally.pots += 1;
                        tally.lost += 1.0 - kept;
                    }
                    self.execute(&play)?;
                    self.luck += self.value(&self.frame) - mean;
                }
            }
        }
        Ok(match self.frame.request() {
            Request::Over { winner: Some(winner), .. } => {
                f64::from(u8::from(*winner == self.first_seat()))
            }
            _ => 0.5,
        })
    }

    /// The seat of the first player.
    const fn first_seat(&self) -> Seat {
        self.breaker % 2
    }

    /// The chance that the first player wins.
    fn value(&self, frame: &Frame) -> f64 {
        let noise = [self.terms.noise.clone(), self.terms.noise.clone()];
        Logistic.win_chance(&Position { frame, noise: &noise }, self.first_seat())
    }

    /// The full hit from the middle of the head string.
    fn break_shot(&self) -> Play {
        let size = self.frame.base().table().size;
        let azimuth = core::f64::consts::FRAC_PI_2;
        let (speed, height) = (BREAK_SPEED, BREAK_HEIGHT);
        let strike = Strike { speed, azimuth, elevation: 0.0, side: 0.0, height };
        Play::new(strike).from([0.5 * size.x, 0.25 * size.y - BEHIND])
    }

    /// Plays `play` with the next errors of the rack.
    fn execute(&mut self, play: &Play) -> Result<(), carom::Error> {
        let mut successor = self.frame.clone();
        let prepared = Prepared::new(&self.frame, play.cue_ball)?;
        let index = self.decisions;
        self.sampler.simulate_variant(&prepared, &play.strike, &self.errors, index)?;
        self.sampler.rule(&prepared, play.call, &mut successor)?;
        self.frame = successor;
        Ok(())
    }

    /// The mean value after `play`, and the share of draws in which its player shoots again or wins.
    fn chances(&mut self, play: &Play) -> Result<(f64, f64), carom::Error> {
        let frame = 2 * self.rack + self.breaker as u64;
        let seed = (frame << 20) ^ (self.decisions << 1) ^ FRESH << 32;
        let errors = Errors { seed, ..self.errors.clone() };
        let noise = [self.terms.noise.clone(), self.terms.noise.clone()];
        let (position, winner) =
            (Position { frame: &self.frame, noise: &noise }, self.first_seat());
        judge(&mut self.sampler, &position, play, (&errors, SAMPLES), winner)
    }
}
