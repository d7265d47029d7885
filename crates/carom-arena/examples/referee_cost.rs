//! Frames of prepared plays, for counting what the referee adds to the simulation of the shots.
//!
//! ```sh
//! cargo run --release -p carom-arena --example referee_cost -- nine-ball 2 1
//! ```
//!
//! The words are a game, how often all frames are played, and how often each of their shots is then
//! simulated alone. The program prints the number of shots of one pass.

use std::sync::Arc;

use carom::event::NullRecorder;
use carom::resolve::cue_ball::Strike;
use carom::{Error, Noise, Shot};
use carom_arena::{
    ArenaFrame, Ask, Clock, Effect, Match, MatchSettings, NextStep, PlayerEntry, Secret,
};
use carom_mind::{Answer, Decision, Spent};
use carom_rules::{FrameSimulator, Game, Play, Request, through_degrees};

/// Frames of a pass.
const FRAMES: u64 = 8;
/// Requests of a frame, which then is conceded.
const REQUESTS: u64 = 40;

fn main() -> Result<(), Error> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [game, passes, alone] = words.as_slice() else { panic!("give a game and two numbers") };
    let number = |word: &String| word.parse::<u32>().expect("a number");
    let settings = MatchSettings {
        noise: [const { Noise::olympiad(1.0) }; 2],
        clock: [Clock::simulations(1); 2],
        ..MatchSettings::new(Game::read(game)?)
    };
    let of = Arc::new(Match::new(settings, ["one", "other"].map(PlayerEntry::new))?);
    let mut simulator = FrameSimulator::new();
    let mut shots = Vec::new();
    for pass in 0..number(passes) {
        for k in 0..FRAMES {
            let seeds = Secret::new([7; 32]).pair_seeds(k);
            let mut frame = ArenaFrame::begin(of.clone(), 0, seeds, &mut simulator)?;
            play(&mut frame, &mut simulator, (pass == 0).then_some(&mut shots))?;
        }
    }
    for _ in 0..number(alone) {
        for shot in &shots {
            simulator.simulator_mut().play(shot, &mut NullRecorder)?;
        }
    }
    println!("{}", shots.len());
    Ok(())
}

/// Plays a frame with prepared plays, and keeps its shots.
fn play(
    frame: &mut ArenaFrame,
    simulator: &mut FrameSimulator,
    mut shots: Option<&mut Vec<Shot>>,
) -> Result<(), Error> {
    while let NextStep::Ask(ask) = frame.next() {
        let answer = answer(&ask);
        let before = shots.as_ref().map(|_| frame.frame().clone());
        let decision = Decision { answer, win_chance: None, spent: Spent::default() };
        let done = frame.answer(simulator, &decision, 0.0)?;
        if let (Some(shots), Some(before), Answer::Play(play)) = (&mut shots, before, answer)
            && let Effect::Played { execution, .. } = &done.effect
        {
            let shot = before.shot(&play)?.with_cling(execution.cling);
            shots.push(shot.with_strike(&through_degrees(&execution.strike))?);
        }
    }
    Ok(())
}

/// The answer to a request: hits in all directions, and the first of the choices.
fn answer(ask: &Ask<'_>) -> Answer {
    if ask.id >= REQUESTS || ask.refused.is_some() {
        return Answer::Concede;
    }
    match ask.situation.frame.request() {
        Request::Choice { choices, .. } => Answer::Choice(choices[0]),
        _ => {
            let in_hand = ask.situation.frame.turn().is_some_and(|turn| turn.hand.is_some());
            let (speed, azimuth) = if in_hand {
                (5.0, 1.5 + 0.01 * (ask.id % 9) as f64)
            } else {
                (3.0, 0.064 * ask.id as f64)
            };
            let strike = Strike { speed, azimuth, elevation: 0.1, side: 0.0, height: 0.0 };
            let play = Play::new(strike);
            Answer::Play(if in_hand { play.from([0.5, 0.3]) } else { play })
        }
    }
}
