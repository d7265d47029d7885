//! A match of eight-ball between two players of the literature, in pairs of frames: the same rack and
//! the same errors of each seat, with the seats swapped.
//!
//! ```sh
//! cargo run --release -p carom-mind --example duel -- cue-card pick-pocket 50 2000 1
//! ```
//!
//! The arguments are the two players, the number of racks, the simulations of a decision, and the
//! multiple of the Computational Olympiad's noise. Besides the players of the literature there are
//! `carom`, the searching player, and CueCard with other settings: `cue-card-one-level`,
//! `cue-card-long-level-one` and `cue-card-usual-break`.

use std::error::Error;
use std::time::Instant;

use carom::Noise;
use carom::format::Node;
use carom::runner::Runner;
use carom_mind::literature::{CueCard, CueCardBreak, CueCardSettings, LevelTwo, Literature};
use carom_mind::{Answer, Budget, Player, Searcher, Situation, Spent};
use carom_plan::{Interval, Prepared, wilson};
use carom_rules::{Frame, FrameSimulator, Game, Options, Play, Request};

/// Separates the errors of the strikes from the seeds of the racks.
const STREAM: u64 = 0x6475_656c;
/// Confidence level of the interval.
const LEVEL: f64 = 0.95;

/// What was agreed before the match.
#[derive(Clone)]
struct Terms {
    simulations: u64,
    noise: Noise,
}

/// What happened in a frame.
struct Played {
    /// The player who won, 0 or 1; none if the frame ended undecided.
    winner: Option<usize>,
    /// What each player did and spent.
    costs: [Cost; 2],
}

#[derive(Clone, Copy, Default)]
struct Cost {
    breaks: u32,
    /// Breaks after which the player shot again.
    kept: u32,
    seconds: f64,
    decisions: u32,
    simulations: u64,
}

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [first, second, racks, simulations, multiple] = words.as_slice() else {
        return Err("usage: duel PLAYER PLAYER RACKS SIMULATIONS NOISE".into());
    };
    let names = [first.as_str(), second.as_str()];
    let racks: u64 = racks.parse()?;
    let noise = Noise::olympiad(multiple.parse()?);
    let terms = Terms { simulations: simulations.parse()?, noise };
    let literature = Literature::default();
    // An unknown name is refused before the match.
    make(&literature, names)?;
    let frames = (0..racks).flat_map(|rack| [(rack, 0), (rack, 1)]);
    let played = Runner::default().map(
        frames,
        || make(&literature, names).map(|players| (players, FrameSimulator::new())),
        |worker, (rack, breaker)| match worker {
            Ok((players, simulator)) => play(&terms, (rack, breaker), players, simulator),
            Err(error) => Err(error.clone()),
        },
    );
    let played = played.into_iter().collect::<Result<Vec<_>, _>>()?;
    report(names, &played);
    Ok(())
}

fn make(literature: &Literature, names: [&str; 2]) -> Result<[Box<dyn Player>; 2], carom::Error> {
    let named = |name: &str| -> Result<Box<dyn Player>, carom::Error> {
        let level_two = |level_two| CueCardSettings { level_two, ..CueCardSettings::default() };
        let settings = match name {
            "carom" => return Ok(Box::new(Searcher::default())),
            "cue-card-one-level" => level_two(LevelTwo::Off),
            "cue-card-long-level-one" => level_two(LevelTwo::GivenToLevelOne),
            "cue-card-usual-break" => {
                let break_shot = CueCardBreak::Usual;
                CueCardSettings { break_shot, ..CueCardSettings::default() }
            }
            _ => return literature.player(name),
        };
        Ok(Box::new(CueCard::new(settings)))
    };
    Ok([named(names[0])?, named(names[1])?])
}

/// Plays one frame; player `breaker` sits at seat 0.
fn play(
    terms: &Terms,
    (rack, breaker): (u64, usize),
    players: &mut [Box<dyn Player>; 2],
    simulator: &mut FrameSimulator,
) -> Result<Played, carom::Error> {
    let table = Some(Node::from("poolfiz"));
    let mut frame = Frame::new(Game::EightBall, Options::default(), table, None, rack)?;
    let mut costs = [Cost::default(); 2];
    let mut shots = [0_u64; 2];
    let mut decisions = 0;
    while let Some(seat) = frame.player() {
        let player = (seat + breaker) % 2;
        let cost = &mut costs[player];
        let began = Instant::now();
        let situation = Situation::new(&frame, terms.noise.clone(), (rack << 16) + decisions);
        let budget = Budget::simulations(terms.simulations);
        let decision = players[player].decide(&situation, &budget)?;
        let Spent { simulations, .. } = decision.spent;
        cost.seconds += began.elapsed().as_secs_f64();
        cost.decisions += 1;
        cost.simulations += simulations;
        decisions += 1;
        let is_break = frame.is_opening();
        match decision.answer {
            Answer::Play(meant) => {
                // The seat's own shots count, so both frames of a pair have the same errors.
                let index = (shots[seat] << 1) + seat as u64;
                shots[seat] += 1;
                let struck = Prepared::new(&frame, meant.cue_ball)?.struck_ball();
                let seed = rack ^ STREAM;
                let strike = terms.noise.draw(&meant.strike, &struck, seed, index);
                frame.play_in(simulator, &Play { strike, ..meant })?;
                let keeps = frame.player() == Some(seat);
                cost.breaks += u32::from(is_break);
                cost.kept += u32::from(is_break && keeps);
            }
            Answer::Choice(choice) => {
                frame.choose(choice)?;
            }
            Answer::Concede => {
                frame.concede()?;
            }
        }
    }
    let winner = match frame.request() {
        Request::Over { winner, .. } => winner.map(|seat| (seat + breaker) % 2),
        _ => None,
    };
    Ok(Played { winner, costs })
}

fn report(names: [&str; 2], played: &[Played]) {
    let wins = [0, 1].map(|player| played.iter().filter(|p| p.winner == Some(player)).count());
    // The frames of a pair follow each other; the first player breaks in the first of them.
    let breaks = |(k, frame): (usize, &Played)| frame.winner == Some(k % 2);
    let broken = played.iter().enumerate().filter(|frame| breaks(*frame)).count();
    let decided = wins[0] + wins[1];
    println!("{} {} : {} {}, of {} frames", names[0], wins[0], wins[1], names[1], played.len());
    let share = 100.0 * wins[0] as f64 / decided.max(1) as f64;
    let Interval { low, high } = wilson(wins[0] as u64, decided as u64, LEVEL);
    println!("{} wins {share:.1} % ({:.1} to {:.1})", names[0], 100.0 * low, 100.0 * high);
    println!("the breaker wins {broken} of {decided}");
    for (player, name) in names.iter().enumerate() {
        let mut sum = Cost::default();
        for cost in played.iter().map(|played| played.costs[player]) {
            sum.breaks += cost.breaks;
            sum.kept += cost.kept;
            sum.seconds += cost.seconds;
            sum.decisions += cost.decisions;
            sum.simulations += cost.simulations;
        }
        let decisions = f64::from(sum.decisions.max(1));
        println!(
            "{name}: {:.2} s a frame, {:.1} ms and {:.0} simulations a decision; the turn kept after {} \
             of {} breaks",
            sum.seconds / played.len() as f64,
            1e3 * sum.seconds / decisions,
            sum.simulations as f64 / decisions,
            sum.kept,
            sum.breaks,
        );
    }
}
