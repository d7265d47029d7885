//! Self-play: the features of every position of many frames, and who won. The data to which
//! `scripts/fit_values.py` fits the weights of the logistic regression.
//!
//! ```sh
//! cargo run --release -p carom-mind --example self_play -- eight-ball 0 1000 300 > rows.csv
//! ```
//!
//! The words are the game, the number of the first frame, the number of frames, and the simulations
//! of a decision. The noise of a frame is the Olympiad's times a multiplier that depends on the
//! frame's number, the same for both players.

use std::error::Error;

use carom::Noise;
use carom::runner::Runner;
use carom_mind::value::{Features, Markov, Position};
use carom_mind::{Answer, Budget, Player, SearchSettings, Searcher, Situation};
use carom_plan::Prepared;
use carom_rules::{Frame, FrameSimulator, Options, Play, Request, Rules, Seat};

/// Multipliers of the noise, frame by frame.
const MULTIPLIERS: [f64; 6] = [0.5, 1.0, 2.0, 0.7, 1.4, 2.5];
/// Separates the errors of the executed strikes from the racks' seeds.
const STREAM: u64 = 0x5eed;
/// Points of a frame of straight pool and of three-cushion.
const POINTS: i32 = 15;

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [game, first, count, simulations] = words.as_slice() else {
        return Err("usage: self_play GAME FIRST COUNT SIMULATIONS".into());
    };
    let rules = Rules::read(game)?;
    let (first, count): (u64, u64) = (first.parse()?, count.parse()?);
    let simulations: u64 = simulations.parse()?;
    let runner = Runner::new(None)?;
    // The Markov chain judges the positions, so that the data do not depend on earlier weights.
    let player = || Searcher::new("markov", Box::<Markov>::default(), SearchSettings::default());
    player()?;
    let frames = runner.map(
        first..first + count,
        || (player(), FrameSimulator::new()),
        |(player, simulator), number| match player {
            Ok(player) => play(rules, number, simulations, (player, simulator)),
            Err(error) => Err(error.clone()),
        },
    );
    println!("frame,multiplier,seat,won,{}", carom_mind::value::features::NAMES.join(","));
    for rows in frames {
        rows?.iter().for_each(|row| println!("{row}"));
    }
    Ok(())
}

/// The rows of one frame.
fn play(
    rules: Rules,
    number: u64,
    simulations: u64,
    (player, simulator): (&mut Searcher, &mut FrameSimulator),
) -> Result<Vec<String>, carom::Error> {
    let multiplier = MULTIPLIERS[(number % MULTIPLIERS.len() as u64) as usize];
    let noise = Noise::olympiad(multiplier);
    let options = Options { points: POINTS, ..Options::default() };
    let mut frame = Frame::new(rules, options, None, None, number)?;
    let mut seen: Vec<(Seat, Features)> = Vec::new();
    let mut index = 0;
    while !frame.is_over() {
        index += 1;
        let situation = Situation::new(&frame, noise, number.wrapping_mul(1_000_003) + index);
        if let (Some(turn), false) = (frame.turn(), frame.is_opening()) {
            let position = Position { frame: &frame, noise: &situation.noise };
            seen.push((turn.player, Features::of(&position, turn)));
        }
        match player.decide(&situation, &Budget::simulations(simulations))?.answer {
            Answer::Choice(choice) => {
                frame.choose(choice)?;
            }
            Answer::Concede => {
                frame.concede()?;
            }
            Answer::Play(play) => {
                let struck = Prepared::new(&frame, play.cue_ball)?.struck_ball();
                let strike = noise.draw(&play.strike, &struck, number ^ STREAM, index);
                frame.play_in(simulator, &Play { strike, ..play })?;
            }
        }
    }
    let Request::Over { winner, .. } = frame.request() else { return Ok(Vec::new()) };
    let row = |(seat, features): &(Seat, Features)| {
        let won = winner.map_or(0.5, |winner| f64::from(u8::from(winner == *seat)));
        let numbers: Vec<String> = features.0.iter().map(|x| format!("{x:.5}")).collect();
        format!("{number},{multiplier},{seat},{won},{}", numbers.join(","))
    };
    Ok(seen.iter().map(row).collect())
}
