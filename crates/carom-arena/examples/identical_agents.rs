//! Frames between two identical players: the points and the luck of the first one.
//!
//! ```sh
//! cargo run --release -p carom-arena --example identical_agents -- greedy eight-ball 8 0 20000
//! ```
//!
//! The words are the player, the game, the number of fresh errors of a shot, the first frame and the
//! number of frames. Every frame has a rack and errors of its own, unlike the frames of a pair, which
//! are mirror images if the players are identical. The players begin in turn. Each frame is a line of
//! JSON: its number, the points, and the luck by the built-in value and by a meaningless one.
//! `benches/luck.py` runs this and counts.

use std::error::Error;
use std::io::Write;
use std::sync::Arc;

use carom::Noise;
use carom::format::Node;
use carom_arena::{
    ArenaFrame, BuiltInPlayer, Clock, LuckSettings, LuckValue, Match, MatchSettings, PlayerEntry,
    Secret, play_frame,
};
use carom_plan::Progress;
use carom_rules::{FrameSimulator, Game};

/// Determines racks and errors.
const SECRET: Secret = Secret::new(*b"frames between identical players");
/// Simulations of a decision for a player whose name has no number.
const USUAL: u32 = 100;

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [player, game, draws, first, count] = words.as_slice() else {
        return Err("usage: identical_agents PLAYER GAME DRAWS FIRST COUNT".into());
    };
    let (first, count): (u64, u64) = (first.parse()?, count.parse()?);
    let entry = BuiltInPlayer::read(player)?;
    let of = LuckValue::ALL.map(|value| {
        let simulations = entry.simulations().unwrap_or(USUAL);
        let settings = MatchSettings {
            noise: [const { Noise::olympiad(1.0) }; 2],
            clock: [Clock::simulations(simulations); 2],
            luck: Some(LuckSettings { draws: draws.parse()?, value }),
            ..MatchSettings::new(Game::read(game)?)
        };
        let players = [PlayerEntry::new(player), PlayerEntry::new(player)];
        Ok::<_, Box<dyn Error>>((value, Arc::new(Match::new(settings, players)?)))
    });
    let of = of.into_iter().collect::<Result<Vec<_>, _>>()?;
    let mut simulator = FrameSimulator::new();
    let mut out = std::io::stdout().lock();
    for number in first..first + count {
        let mut line = Node::object([("frame", Node::Integer(i64::try_from(number)?))]);
        for (value, of) in &of {
            let seeds = SECRET.pair_seeds(number);
            let mut frame = ArenaFrame::begin(of.clone(), number, seeds, &mut simulator)?;
            let mut players = [entry.make()?, entry.make()?];
            play_frame(&mut frame, &mut players, &mut simulator, &Progress::default())?;
            line.set("points", frame.points());
            line.set(value.name(), frame.luck());
        }
        writeln!(out, "{}", line.to_json_line())?;
        out.flush()?;
    }
    Ok(())
}
