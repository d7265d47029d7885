//! Ruled successors of mid-game positions of eight-ball, one thread: how many a second. Prints the
//! rate of the bare simulation beside it.
//!
//! The positions come from random play with a fixed seed; the errors are those of the Olympiad. Every
//! position has one strike, of which variants are drawn, simulated and ruled on.
//!
//!     cargo run --release -p carom-plan --example successors -- [VARIANTS [draw|simulate|rule|records]]
//!
//! With the name of a step the variants are only taken so far, once, and nothing is timed:
//! `valgrind --tool=callgrind` counts the instructions of a step by differences. `records` prints each
//! position as the record of its frame, `carom-frame/1`, with its play, for measurements of the
//! bindings: a list, JSON.

use std::process::exit;
use std::time::Instant;

use carom::event::NullRecorder;
use carom::format::Node;
use carom::math::{Vec2, atan2};
use carom::noise::Errors;
use carom::resolve::cue_ball::Strike;
use carom::{Error, Noise, Simulator};
use carom_plan::{Prepared, Sampler};
use carom_rules::{BallIndex, Call, Frame, Game, Options, Play, Request, Turn};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

/// Positions. Enough that no single one weighs much.
const POSITIONS: usize = 60;
/// Fewest and most balls on the table in a position: the middle of a rack.
const BALLS: std::ops::RangeInclusive<usize> = 6..=12;
/// Repetitions of the measurement, of which the median is printed.
const REPETITIONS: usize = 9;
/// A place for a cue ball in hand that is off the table, m.
const HEAD_SPOT: [f64; 2] = [0.635, 0.635];

struct Dice(Pcg64);

impl Dice {
    fn unit(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    fn below(&mut self, n: usize) -> usize {
        (self.unit() * n as f64) as usize
    }
}

fn main() {
    let given: Vec<String> = std::env::args().skip(1).collect();
    let variants = given.first().map_or(Ok(2000), |n| n.parse());
    let Ok(variants) = variants else {
        eprintln!("usage: successors [VARIANTS [draw|simulate|rule|records]]");
        exit(2);
    };
    if let Err(error) = run(variants, given.get(1).map(String::as_str)) {
        eprintln!("{error}");
        exit(2);
    }
}

fn run(variants: u64, step: Option<&str>) -> Result<(), Error> {
    let positions = positions()?;
    let prepared: Vec<(Prepared<'_>, Play)> = positions
        .iter()
        .map(|Position { frame, play, .. }| Ok((Prepared::new(frame, play.cue_ball)?, *play)))
        .collect::<Result<_, Error>>()?;
    match step {
        Some("draw") => println!("{}", draw(&prepared, variants)),
        Some("simulate") => println!("{}", simulate(&prepared, variants)?),
        Some("rule") => println!("{}", rule(&prepared, variants)?),
        Some("records") => {
            println!("{}", Node::list(positions.iter().map(Position::node)).to_json());
        }
        _ => {
            let balls: usize = prepared.iter().map(|(shot, _)| shot.balls().len()).sum();
            println!(
                "{} positions, {:.1} balls on average, {:.1} events a shot",
                prepared.len(),
                balls as f64 / prepared.len() as f64,
                simulate(&prepared, 20)? as f64 / (20 * prepared.len()) as f64
            );
            let count = variants * prepared.len() as u64;
            let bare = rate(count, || simulate(&prepared, variants))?;
            let ruled = rate(count, || rule(&prepared, variants))?;
            println!("strikes drawn and simulated: {bare:.0} a second");
            println!("successors drawn, simulated and ruled on: {ruled:.0} a second");
        }
    }
    Ok(())
}

/// The median of the rates of several runs of `work`, which does `count` things: per second.
fn rate(count: u64, mut work: impl FnMut() -> Result<u64, Error>) -> Result<f64, Error> {
    let mut rates = Vec::new();
    for _ in 0..REPETITIONS {
        let began = Instant::now();
        std::hint::black_box(work()?);
        rates.push(count as f64 / began.elapsed().as_secs_f64());
    }
    rates.sort_by(f64::total_cmp);
    Ok(rates[REPETITIONS / 2])
}

const ERRORS: Errors = Errors {
    noise: Noise::olympiad(1.0),
    perception: carom::noise::Perception::round(0.0),
    seed: 1,
};

/// Draws every variant. Returns the sum of the bits of the speeds.
fn draw(prepared: &[(Prepared<'_>, Play)], variants: u64) -> u64 {
    let mut sum = 0_u64;
    for (prepared, play) in prepared {
        for k in 0..variants {
            let strike = ERRORS.noise.draw(&play.strike, &prepared.struck_ball(), ERRORS.seed, k);
            sum = sum.wrapping_add(strike.speed.to_bits());
        }
    }
    sum
}

/// Draws and simulates every variant. Returns the number of events.
fn simulate(prepared: &[(Prepared<'_>, Play)], variants: u64) -> Result<u64, Error> {
    let mut simulator = Simulator::new();
    let mut events = 0;
    for (prepared, play) in prepared {
        let shot = prepared.shot();
        for k in 0..variants {
            let strike = ERRORS.noise.draw(&play.strike, &prepared.struck_ball(), ERRORS.seed, k);
            let struck = shot.strike().map(|(ball, _)| (ball, strike));
            let summary = simulator.play_strike(shot, struck, &mut NullRecorder)?;
            events += u64::from(summary.events);
        }
    }
    Ok(events)
}

/// Draws and simulates every variant, and rules on it. Returns how often the player shoots again.
fn rule(prepared: &[(Prepared<'_>, Play)], variants: u64) -> Result<u64, Error> {
    let mut sampler = Sampler::new();
    let Some((first, _)) = prepared.first() else { return Ok(0) };
    let mut successor = first.frame().clone();
    let mut kept = 0;
    for (prepared, play) in prepared {
        for k in 0..variants {
            sampler.simulate_variant(prepared, &play.strike, &ERRORS, k)?;
            sampler.rule(prepared, play.call, &mut successor)?;
            kept += u64::from(successor.player() == prepared.frame().player());
        }
    }
    Ok(kept)
}

/// A position with a play, and how the frame came there: the seed of its racks and its moves.
struct Position {
    frame: Frame,
    play: Play,
    seed: u64,
    moves: Vec<Node>,
}

impl Position {
    /// The record of the frame, and the play as it is written there.
    fn node(&self) -> Node {
        let mut setup = carom_rules::recorded_setup(Game::EightBall, None, None);
        let Options { points, miss, patience } = *self.frame.options();
        setup.set("game", Game::EightBall.name());
        setup.set("seed", self.seed as f64);
        setup.set("points", f64::from(points));
        setup.set("miss", miss);
        setup.set("patience", patience);
        let record = Node::object([
            ("format", "carom-frame/1".into()),
            ("setup", setup),
            ("moves", Node::list(self.moves.iter().cloned())),
        ]);
        Node::object([("record", record), ("play", play_node(&self.frame, &self.play))])
    }
}

fn play_node(frame: &Frame, play: &Play) -> Node {
    let Strike { speed, azimuth, elevation, side, height } = play.strike;
    let strike = Node::object([
        ("speed", speed.into()),
        ("azimuth", azimuth.into()),
        ("elevation", elevation.into()),
        ("side", side.into()),
        ("height", height.into()),
    ]);
    let mut node = Node::object([("strike", strike)]);
    if let Some(place) = play.cue_ball {
        node.set("cue_ball", Node::list(place));
    }
    if let Call::Pocket(ball, pocket) = play.call {
        let ball = Node::from(&frame.layout().balls()[usize::from(ball)].id);
        let call = [("kind", "pocket".into()), ("ball", ball), ("into", pocket.name().into())];
        node.set("call", Node::object(call));
    }
    node
}

/// Positions in the middle of racks of eight-ball, with a play of each.
fn positions() -> Result<Vec<Position>, Error> {
    let mut dice = Dice(Pcg64::new(7, 3));
    let mut found = Vec::new();
    let (mut seed, mut moves) = (0, Vec::new());
    let mut frame = Frame::new(Game::EightBall, Options::default(), None, None, seed)?;
    while found.len() < POSITIONS {
        let is_new_rack = match *frame.request() {
            Request::Shot(turn) => {
                let play = any_play(&frame, &turn, &mut dice);
                let before = frame.clone();
                // Refused if the head spot is taken, or the cue ball stands in a jaw: another rack.
                let is_played = frame.play(&play).is_ok();
                if is_played {
                    let made = Node::object([("play", play_node(&before, &play))]);
                    if BALLS.contains(&before.layout().on_table().count()) {
                        let moves = moves.clone();
                        found.push(Position { frame: before, play, seed, moves });
                    }
                    moves.push(made);
                }
                !is_played
            }
            Request::Choice { choices, .. } => {
                let choice = choices[dice.below(choices.len())];
                frame.choose(choice)?;
                moves.push(Node::object([("choice", choice.name().into())]));
                false
            }
            Request::Over { .. } => true,
        };
        if is_new_rack {
            seed = dice.below(1 << 20) as u64;
            frame = frame.with_seed(seed)?;
            moves.clear();
        }
    }
    Ok(found)
}

/// A strike at one of the balls on, at a usual speed, with that ball called into some pocket.
fn any_play(frame: &Frame, turn: &Turn, dice: &mut Dice) -> Play {
    let layout = frame.layout();
    let cue_ball = turn.hand.map(|_| HEAD_SPOT).filter(|_| layout.is_down(turn.cue));
    let others: Vec<BallIndex> = layout.on_table().filter(|ball| *ball != turn.cue).collect();
    let targets = if turn.on.is_empty() { &others[..] } else { &turn.on[..] };
    let target = targets[dice.below(targets.len())];
    let [from, to] = [cue_ball.or(layout.place(turn.cue)), layout.place(target)]
        .map(|place| place.map_or(Vec2::ZERO, |[x, y]| Vec2::new(x, y)));
    let way = to - from;
    let azimuth = atan2(way.y, way.x) + 0.02 * (dice.unit() - 0.5);
    let break_shot = frame.shots() == 0;
    let speed = if break_shot { 8.0 } else { 1.0 + 3.0 * dice.unit() };
    let (side, height) = (0.3 * (dice.unit() - 0.5), 0.5 * (dice.unit() - 0.5));
    let strike = Strike { speed, azimuth, elevation: 0.052, side, height };
    let pockets = &frame.base().table().pockets;
    let call = match turn.calls.pocket {
        true => Call::Pocket(target, pockets[dice.below(pockets.len())].name),
        false => Call::Nothing,
    };
    Play { cue_ball, call, ..Play::new(strike) }
}
