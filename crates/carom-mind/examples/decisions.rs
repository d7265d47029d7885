//! Decisions of the searching player in the positions of a file (one `carom-shot/1` per line, eight-ball
//! on an open table), a number of times, on one core. Prints the simulated shots of a pass, and the
//! bits of all its decisions combined: the bindings must find the same.
//!
//! ```sh
//! cargo run --profile bench -p carom-mind --example decisions -- shots.jsonl SIMULATIONS PASSES
//! ```

use std::error::Error;

use carom::Shot;
use carom::noise::SKILLS;
use carom_mind::{Answer, Budget, Player, Searcher, Situation};
use carom_rules::{Frame, Game, Options};

/// The level of play.
const LEVEL: &str = "club";

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [file, simulations, passes] = arguments.as_slice() else {
        return Err("usage: decisions FILE SIMULATIONS PASSES".into());
    };
    let (simulations, passes): (u64, u32) = (simulations.parse()?, passes.parse()?);
    let (_, noise) = SKILLS.iter().find(|(name, _)| *name == LEVEL).ok_or("no such level")?;
    let text = std::fs::read_to_string(file)?;
    let frames = text
        .lines()
        .map(|line| {
            Frame::of_shot(Game::EightBall, Options::default(), &Shot::from_json(line)?, None)
        })
        .collect::<Result<Vec<_>, _>>()?;
    let mut player = Searcher::default();
    let (mut spent, mut bits) = (0, 0_u64);
    for _ in 0..passes {
        (spent, bits) = (0, 0);
        for frame in &frames {
            let situation = Situation::new(frame, noise.clone(), 0);
            let decision = player.decide(&situation, &Budget::simulations(simulations))?;
            spent += decision.spent.simulations;
            bits ^= decision.win_chance.unwrap_or_default().to_bits();
            if let Answer::Play(play) = decision.answer {
                bits ^= play.strike.azimuth.to_bits();
            }
        }
    }
    println!("{spent} {bits:016x}");
    Ok(())
}
