//! A short hash of a player's decisions on fixed positions. Two records with the same hash were most
//! probably made by the same player; a player whose search or settings changed has another one.

use carom::rack::Game;
use carom::{Error, Noise};
use carom_mind::{Answer, Budget, Player, Situation};
use carom_rules::{Call, Choice, Frame, Options, Play};

use crate::secret::sha256;

/// A position: the game, and the balls with their places (m); all other balls are down.
type Position = (Game, &'static [(&'static str, [f64; 2])]);

/// Middle games without a break, which takes a hundred times as long. They have a combination of
/// close balls, balls at cushions and balls in the open.
const POSITIONS: [Position; 3] = [
    (
        Game::EightBall,
        &[
            ("cue", [0.42, 0.63]),
            ("2", [0.31, 1.42]),
            ("5", [0.9, 1.7]),
            ("7", [1.12, 0.4]),
            ("10", [0.7, 2.2]),
            ("13", [0.15, 2.0]),
            ("8", [0.66, 1.15]),
        ],
    ),
    (
        Game::NineBall,
        &[("cue", [0.95, 1.05]), ("4", [0.4, 2.1]), ("7", [0.85, 2.0]), ("9", [0.2, 0.5])],
    ),
    (
        Game::StraightPool,
        &[("cue", [0.7, 0.9]), ("1", [0.5, 1.9]), ("6", [0.9, 1.88]), ("11", [0.6, 2.05])],
    ),
];

/// Simulated shots of a decision: enough for the first rounds of a search, some milliseconds.
const SIMULATIONS: u64 = 60;

/// Digits of the hash. Two players of a tournament agree by chance once in 10¹⁹ times.
const DIGITS: usize = 16;

/// The first [`DIGITS`] hexadecimal digits of the SHA-256 of the decisions of `player`.
pub(crate) fn decision_hash(player: &mut dyn Player) -> String {
    let mut bytes = Vec::new();
    for (seed, (game, balls)) in (1_u64..).zip(POSITIONS) {
        match decided(player, game, balls, seed) {
            Ok(decision) => bytes.extend(decision),
            // A player that does not play a game says so.
            Err(error) => bytes.extend(error.to_string().into_bytes()),
        }
    }
    let mut digits = sha256(&bytes);
    digits.truncate(DIGITS);
    digits
}

fn decided(
    player: &mut dyn Player,
    game: Game,
    balls: &[(&str, [f64; 2])],
    seed: u64,
) -> Result<Vec<u8>, Error> {
    let mut frame = Frame::new(game, Options::default(), None, None, seed)?;
    let mut places = vec![None; frame.layout().len()];
    for (id, place) in balls {
        places[usize::from(frame.ball(id, "balls")?)] = Some(*place);
    }
    frame.resume_at(&places, 0)?;
    let situation = Situation::new(&frame, Noise::olympiad(1.0), seed);
    let decision = player.decide(&situation, &Budget::simulations(SIMULATIONS))?;
    let mut bytes = Vec::new();
    match decision.answer {
        Answer::Play(play) => add_play(&mut bytes, &play),
        Answer::Choice(choice) => bytes.extend(Choice::name(choice).as_bytes()),
        Answer::Concede => bytes.extend(b"concede"),
    }
    add_number(&mut bytes, decision.win_chance.unwrap_or(-1.0));
    bytes.extend(decision.spent.simulations.to_le_bytes());
    Ok(bytes)
}

fn add_play(bytes: &mut Vec<u8>, play: &Play) {
    let strike = &play.strike;
    for number in [strike.speed, strike.azimuth, strike.elevation, strike.side, strike.height] {
        add_number(bytes, number);
    }
    for number in play.cue_ball.iter().flatten() {
        add_number(bytes, *number);
    }
    match play.call {
        Call::Nothing => {}
        Call::Safety => bytes.extend(b"safety"),
        Call::PushOut => bytes.extend(b"push-out"),
        Call::On(ball) => bytes.extend(ball.to_le_bytes()),
        Call::Pocket(ball, pocket) => {
            bytes.extend(ball.to_le_bytes());
            bytes.extend(pocket.name().as_bytes());
        }
    }
}

fn add_number(bytes: &mut Vec<u8>, number: f64) {
    bytes.extend(number.to_bits().to_le_bytes());
}
