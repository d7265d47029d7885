//! How good are the chosen plays of endings, beside a search of nearly all plays?
//!
//! ```sh
//! cargo run --release -p carom-mind --example endings -- lone-nine 0 100 20000 > lone-nine.jsonl
//! ```
//!
//! The words are the ending, the number of the first position, the number of positions, and the
//! simulations of the player's decision. An ending is `last-ball-and-eight` (eight-ball on an open
//! table: a solid, a stripe and the eight), `lone-nine` (nine-ball) or `three-balls` (nine-ball with
//! the 7, 8 and 9). The balls are at random places, and the errors those of the Olympiad.
//!
//! The search uses no part of the player's: on a lattice of 12 speeds, 5 heights and 3 sides it tries
//! every azimuth within a few degrees of a pot by geometry, in steps of 0.06°, and 90 directions of
//! the whole table for safeties. The middle of every range of azimuths that pots a ball, and every
//! legal safety, is played with 40 drawn errors, the best 60 with 400, and the best 6 and the chosen
//! play with 4000 others. All are judged by the default value of positions. A line of JSON gives the
//! chances of winning after the chosen play and after the best.

use std::error::Error;

use carom::Noise;
use carom::math::{Vec2, atan2};
use carom::noise::Errors;
use carom::resolve::cue_ball::Strike;
use carom_mind::line::{self, Line};
use carom_mind::scene::Scene;
use carom_mind::targets::{Targets, call_of};
use carom_mind::value::{Logistic, Position, Value};
use carom_mind::{Answer, Budget, Player, Searcher, Situation};
use carom_plan::{Prepared, Sampler};
use carom_rules::{Call, Frame, Game, Options, Play, Seat};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

const SPEEDS: [f64; 12] = [0.5, 0.7, 0.9, 1.2, 1.5, 1.9, 2.3, 2.8, 3.4, 4.1, 5.0, 6.0];
const HEIGHTS: [f64; 5] = [-0.33, -0.17, 0.0, 0.17, 0.33];
const SIDES: [f64; 3] = [-0.2, 0.0, 0.2];
/// Azimuths on either side of a line, and their step, rad.
const REACH: f64 = 0.05;
const STEP: f64 = 0.001;
/// Directions of safeties.
const DIRECTIONS: u32 = 90;
/// Drawn errors of each heat, and the number of plays that go on.
const HEATS: [(u64, usize); 3] = [(40, 60), (400, 6), (4000, 1)];
/// Number of the first drawn errors of the last heat.
const FRESH: u64 = 1 << 41;
/// Room around a ball at a random place, m.
const ROOM: f64 = 0.005;

/// A play and its value so far.
type Rated = (Play, f64);

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [ending, first, count, simulations] = words.as_slice() else {
        return Err("usage: endings ENDING FIRST COUNT SIMULATIONS".into());
    };
    let (game, balls): (Game, &[usize]) = match ending.as_str() {
        "last-ball-and-eight" => (Game::EightBall, &[0, 1, 8, 9]),
        "lone-nine" => (Game::NineBall, &[0, 9]),
        "three-balls" => (Game::NineBall, &[0, 7, 8, 9]),
        _ => return Err("ENDING is last-ball-and-eight, lone-nine or three-balls".into()),
    };
    let (first, count): (u64, u64) = (first.parse()?, count.parse()?);
    let simulations: u64 = simulations.parse()?;
    for number in first..first + count {
        let frame = random_frame(game, balls, number)?;
        let noise = Noise::olympiad(1.0);
        let situation = Situation::new(&frame, noise.clone(), number);
        let decision = Searcher::default().decide(&situation, &Budget::simulations(simulations))?;
        let Answer::Play(chosen) = decision.answer else { continue };
        let brute = Brute::new(&frame, noise, number)?;
        let (best, tried) = brute.search(chosen)?;
        let own = brute.mean(&chosen, FRESH, HEATS[2].0)?;
        println!(
            "{{\"ending\": \"{ending}\", \"number\": {number}, \"chosen\": {own:.4}, \"best\": \
             {:.4}, \"tried\": {tried}, \"chosen_play\": {}, \"best_play\": {}}}",
            best.1,
            words_of(&chosen),
            words_of(&best.0)
        );
    }
    Ok(())
}

/// A play as JSON: speed (m/s), azimuth (degrees), side and height (ball radii), and the call.
fn words_of(play: &Play) -> String {
    let Strike { speed, azimuth, side, height, .. } = play.strike;
    format!(
        "{{\"speed\": {speed:.3}, \"azimuth_deg\": {:.3}, \"side\": {side:.3}, \"height\": {height:.3}, \
         \"call\": \"{:?}\"}}",
        azimuth.to_degrees(),
        play.call
    )
}

/// A frame with these balls at random places.
fn random_frame(game: Game, balls: &[usize], number: u64) -> Result<Frame, carom::Error> {
    let mut frame = Frame::new(game, Options::default(), None, None, 0)?;
    let mut random = Pcg64::new(u128::from(number), 0x656e_6469_6e67);
    let mut unit = || (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64;
    let radius = frame.layout().balls()[0].ball.radius;
    let size = frame.base().table().size;
    let near = radius + ROOM;
    let mut places: Vec<Option<[f64; 2]>> = vec![None; frame.layout().len()];
    for ball in balls {
        places[*ball] = loop {
            let [x, y] = [size.x, size.y].map(|side| near + unit() * (side - 2.0 * near));
            let is_free = places
                .iter()
                .flatten()
                .all(|[a, b]| Vec2::new(x - a, y - b).length() > 2.0 * radius + ROOM);
            if is_free {
                break Some([x, y]);
            }
        };
    }
    frame.resume_at(&places, 0)?;
    Ok(frame)
}

/// The search of nearly all plays of a frame.
struct Brute<'a> {
    frame: &'a Frame,
    prepared: Prepared<'a>,
    noise: [Noise; 2],
    seat: Seat,
    seed: u64,
}

impl<'a> Brute<'a> {
    fn new(frame: &'a Frame, noise: Noise, seed: u64) -> Result<Self, Box<dyn Error>> {
        let prepared = Prepared::new(frame, None)?;
        let seat = frame.player().ok_or("the frame is over")?;
        Ok(Self { frame, prepared, noise: [noise.clone(), noise], seat, seed })
    }

    /// The best play, its value with fresh errors, and the number of plays that were tried with
    /// errors.
    fn search(&self, chosen: Play) -> Result<(Rated, usize), Box<dyn Error>> {
        let mut plays = self.plays()?;
        let tried = plays.len();
        let mut first = 0;
        for (k, (samples, left)) in HEATS.into_iter().enumerate() {
            let is_last = k + 1 == HEATS.len();
            if is_last {
                plays.push((chosen, 0.0));
                first = FRESH;
            }
            for (play, value) in &mut plays {
                *value = self.mean(play, first, samples)?;
            }
            plays.sort_by(|a, b| b.1.total_cmp(&a.1));
            plays.truncate(left);
            first += samples;
        }
        Ok((plays[0], tried))
    }

    /// The plays that pot a ball without errors, and legal safeties.
    fn plays(&self) -> Result<Vec<Rated>, Box<dyn Error>> {
        let turn = self.frame.turn().ok_or("the frame requests no shot")?;
        let scene = Scene::of(&self.prepared);
        let targets = Targets::of(self.frame, turn);
        let mut lines: Vec<Line> = Vec::new();
        line::direct(&scene, &targets, &mut lines);
        line::banks(&scene, &targets, &mut lines);
        line::combinations(&scene, &targets, &mut lines);
        let table = self.prepared.shot().table();
        let (mut sampler, mut successor) = (Sampler::new(), self.frame.clone());
        let mut plays = Vec::new();
        for speed in SPEEDS {
            for height in HEIGHTS {
                for side in SIDES {
                    let spin = [speed, height, side];
                    for line in &lines {
                        let pot = Some((line.object, table.pockets[line.pocket].name));
                        let call = call_of(turn, line.first, pot);
                        let steps = (2.0 * REACH / STEP) as u32;
                        let mut from: Option<f64> = None;
                        for step in 0..=steps {
                            let azimuth = line.azimuth - REACH + STEP * f64::from(step);
                            let strike = self.strike(spin, azimuth);
                            let pots = sampler.simulate(&self.prepared, &strike).is_ok()
                                && sampler.rule(&self.prepared, call, &mut successor)?.is_legal()
                                && successor.keeps_turn(self.seat);
                            match (pots, from) {
                                (true, None) => from = Some(azimuth),
                                (false, Some(start)) => {
                                    let middle = 0.5 * (start + azimuth - STEP);
                                    plays.push((self.play(spin, middle, call), 0.0));
                                    from = None;
                                }
                                _ => {}
                            }
                        }
                    }
                }
            }
        }
        let balls = scene.balls().iter().filter(|ball| targets.first.contains(&ball.index));
        let cue = scene.ball(turn.cue).ok_or("no cue ball")?;
        let middles: Vec<f64> =
            balls.map(|ball| ball.center - cue.center).map(|way| atan2(way.y, way.x)).collect();
        let first = targets.first.first().copied().unwrap_or_default();
        let call = call_of(turn, first, None);
        for [speed, height, side] in [[0.7, 0.0, 0.0], [1.2, 0.0, 0.0], [2.0, 0.0, 0.0]] {
            for k in 0..DIRECTIONS {
                let share = f64::from(k) / f64::from(DIRECTIONS);
                let around = core::iter::once(core::f64::consts::TAU * share);
                let near = middles.iter().map(|middle| middle + 0.2 * (share - 0.5));
                for azimuth in around.chain(near) {
                    let strike = self.strike([speed, height, side], azimuth);
                    if sampler.simulate(&self.prepared, &strike).is_ok()
                        && sampler.rule(&self.prepared, call, &mut successor)?.is_legal()
                    {
                        plays.push((self.play([speed, height, side], azimuth, call), 0.0));
                    }
                }
            }
        }
        Ok(plays)
    }

    fn strike(&self, [speed, height, side]: [f64; 3], azimuth: f64) -> Strike {
        let strike = Strike { speed, azimuth, elevation: 0.0, side, height };
        Strike { elevation: self.prepared.shot().default_elevation(&strike), ..strike }
    }

    fn play(&self, spin: [f64; 3], azimuth: f64, call: Call) -> Play {
        Play { call, ..Play::new(self.strike(spin, azimuth)) }
    }

    /// The mean value of a play over `samples` drawn errors from number `first` on.
    fn mean(&self, play: &Play, first: u64, samples: u64) -> Result<f64, carom::Error> {
        let (mut sampler, mut successor) = (Sampler::new(), self.frame.clone());
        let errors =
            Errors { noise: self.noise[self.seat].clone(), seed: !self.seed, ..Errors::default() };
        let mut sum = 0.0;
        for index in first..first + samples {
            sampler.simulate_variant(&self.prepared, &play.strike, &errors, index)?;
            sampler.rule(&self.prepared, play.call, &mut successor)?;
            let position = Position { frame: &successor, noise: &self.noise };
            sum += Logistic.win_chance(&position, self.seat);
        }
        Ok(sum / samples as f64)
    }
}
