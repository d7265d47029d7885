//! Compares what players choose in the same positions: every play gets the same fresh errors, and is
//! worth the mean value of the positions that it leaves.
//!
//! ```sh
//! cargo run --release -p carom-arena --example compare_plays -- \
//!     RECORD 53 1000 carom:3000 'carom[first-round=600]:3000'
//! ```
//!
//! The words are the record of a finished match, a number k (about every k-th request for a
//! shot is a position), the number of fresh errors, and the players. The differences are those to the first player. One
//! shot of a frame decides little, so differences of a tenth of a point show here that matches
//! would need tens of thousands of frames for.

mod judge;

use std::error::Error;

use carom::noise::Errors;
use carom::runner::Runner;
use carom_arena::{Ask, BuiltInPlayer, positions};
use carom_mind::value::Position;
use carom_mind::{Answer, Budget, Situation};
use carom_plan::Sampler;
use carom_rules::Call;
use judge::judge;

/// Separates the fresh errors from those that the players draw.
const FRESH: u64 = 0x0066_7265_7368;
/// Simulations of a decision for a player whose name has no number.
const USUAL: u32 = 3000;
/// Number of standard errors on either side of a 95 % interval.
const WIDE: f64 = 1.96;

/// What a play is worth.
#[derive(Clone, Copy, Debug)]
struct Worth {
    /// Mean value of what it leaves.
    value: f64,
    /// Share of the errors with which the player keeps the turn.
    kept: f64,
    is_safety: bool,
    simulations: u64,
    seconds: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [record, every, errors, names @ ..] = words.as_slice() else {
        return Err("usage: compare_plays RECORD EVERY ERRORS PLAYER ...".into());
    };
    let (every, errors): (u64, u64) = (every.parse()?, errors.parse()?);
    let players = names.iter().map(|name| BuiltInPlayer::read(name));
    let players = players.collect::<Result<Vec<_>, _>>()?;
    let text = std::fs::read_to_string(record)?;
    let see = |ask: &Ask<'_>| {
        let Situation { frame, seed, .. } = ask.situation;
        let is_shot = frame.turn().is_some() && !frame.is_opening();
        (is_shot && seed % every == 0).then(|| worths(&ask.situation, &players, errors))
    };
    let frames = positions(&text, &Runner::new(None)?, see)?;
    let mut rows: Vec<Vec<Worth>> = Vec::new();
    for row in frames.into_iter().flat_map(|(row, _)| row).flatten() {
        rows.push(row?);
    }
    println!("{} positions", rows.len());
    for (k, name) in names.iter().enumerate() {
        let of = |f: &dyn Fn(&Worth) -> f64| mean(rows.iter().map(|row| f(&row[k]))).0;
        let (difference, error) = mean(rows.iter().map(|row| row[k].value - row[0].value));
        println!(
            "{name:50} value {:.2} %, difference {:+.2} ± {:.2}, keeps the turn {:.2} %, safeties {:.1} %, \
             {:.0} simulations, {:.2} ms",
            100.0 * of(&|w| w.value),
            100.0 * difference,
            100.0 * WIDE * error,
            100.0 * of(&|w| w.kept),
            100.0 * of(&|w| f64::from(u8::from(w.is_safety))),
            of(&|w| w.simulations as f64),
            1000.0 * of(&|w| w.seconds),
        );
    }
    Ok(())
}

/// The mean and its standard error.
fn mean(numbers: impl Iterator<Item = f64> + Clone) -> (f64, f64) {
    let count = numbers.clone().count() as f64;
    let mean = numbers.clone().sum::<f64>() / count;
    let squares: f64 = numbers.map(|x| (x - mean) * (x - mean)).sum();
    (mean, carom::math::sqrt(squares / (count - 1.0) / count))
}

/// What the plays of all players are worth in a situation.
fn worths(
    situation: &Situation<'_>,
    players: &[BuiltInPlayer],
    errors: u64,
) -> Result<Vec<Worth>, carom::Error> {
    let Situation { frame, noise, perception, seed } = situation.clone();
    let (position, seat) = (Position { frame, noise: &noise }, frame.player().unwrap_or(0));
    let drawn = Errors { noise: noise[seat].clone(), perception, seed: seed ^ FRESH };
    let worth = |player: &BuiltInPlayer| {
        let simulations = u64::from(player.simulations().unwrap_or(USUAL));
        let mut made = player.make()?;
        let start = std::time::Instant::now();
        let decision = made.decide(situation, &Budget::simulations(simulations))?;
        let seconds = start.elapsed().as_secs_f64();
        let Answer::Play(play) = decision.answer else {
            let worth = Worth { value: 0.0, kept: 0.0, is_safety: false, simulations: 0, seconds };
            return Ok(worth);
        };
        let (value, kept) = judge(&mut Sampler::new(), &position, &play, (&drawn, errors), seat)?;
        let is_safety = matches!(play.call, Call::Safety);
        Ok(Worth { value, kept, is_safety, simulations: decision.spent.simulations, seconds })
    };
    players.iter().map(worth).collect()
}
