//! Random play, for positions from every part of every game.

use carom::Simulator;
use carom::math::{Vec2, atan2};
use carom::resolve::cue_ball::Strike;
use carom_rules::{BallIndex, Call, Frame, Game, Options, Play, Request, Turn};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

/// Gap kept between a cue ball in hand and everything else, m.
const ROOM: f64 = 0.004;

pub(crate) struct Dice(Pcg64);

impl Dice {
    pub(crate) fn new(seed: u64) -> Self {
        Self(Pcg64::new(seed.into(), 11))
    }

    pub(crate) fn unit(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    pub(crate) fn below(&mut self, n: usize) -> usize {
        (self.unit() * n as f64) as usize
    }
}

/// A place for a cue ball in hand.
fn place(frame: &Frame, turn: &Turn, dice: &mut Dice) -> Option<[f64; 2]> {
    let (region, layout, table) = (turn.hand?, frame.layout(), frame.base().table());
    let radius = layout.balls()[usize::from(turn.cue)].ball.radius;
    let [[left, bottom], [right, top]] = region.bounds(table);
    let margin = table.reach(radius) + ROOM;
    loop {
        let x = left + dice.unit() * (right - left);
        let y = bottom + dice.unit() * (top - bottom);
        let inside = (margin..table.size.x - margin).contains(&x)
            && (margin..table.size.y - margin).contains(&y);
        let free = layout.on_table().filter(|ball| *ball != turn.cue).all(|ball| {
            let there = layout.place(ball).unwrap_or_default();
            Vec2::new(x - there[0], y - there[1]).length() > 2.0 * radius + ROOM
        });
        if inside && free && region.holds(table, [x, y]) {
            return Some([x, y]);
        }
    }
}

/// A random allowed play that hits a ball on, or is near to hitting it.
pub(crate) fn any_play(frame: &Frame, turn: &Turn, dice: &mut Dice) -> Play {
    let layout = frame.layout();
    let cue_ball = place(frame, turn, dice);
    let others: Vec<BallIndex> = layout.on_table().filter(|ball| *ball != turn.cue).collect();
    let targets = if turn.on.is_empty() { &others[..] } else { &turn.on[..] };
    let target = targets[dice.below(targets.len())];
    let [from, to] = [cue_ball.or(layout.place(turn.cue)), layout.place(target)];
    let (from, to) = (from.unwrap_or_default(), to.unwrap_or_default());
    let azimuth = atan2(to[1] - from[1], to[0] - from[0]) + 0.06 * (dice.unit() - 0.5);
    // Some cues are raised, for jumps.
    let elevation = if dice.below(8) == 0 { 0.7 * dice.unit() } else { 0.05 };
    let (side, height) = (0.5 * (dice.unit() - 0.5), 0.5 * (dice.unit() - 0.5));
    let speed = 0.4 + 6.0 * dice.unit();
    let strike = Strike { speed, azimuth, elevation, side, height };
    let calls = any_calls(frame, turn, dice);
    Play { cue_ball, call: calls[dice.below(calls.len())], ..Play::new(strike) }
}

/// Some of the calls that are allowed.
pub(crate) fn any_calls(frame: &Frame, turn: &Turn, dice: &mut Dice) -> Vec<Call> {
    let mut calls = Vec::new();
    if turn.calls.nominate {
        calls.extend(turn.on.iter().map(|ball| Call::On(*ball)));
        return calls;
    }
    if !turn.calls.required {
        calls.push(Call::Nothing);
    }
    if turn.calls.safety {
        calls.push(Call::Safety);
    }
    if turn.calls.push_out {
        calls.push(Call::PushOut);
    }
    if turn.calls.pocket {
        let on_table = frame.layout().on_table().filter(|ball| *ball != turn.cue);
        let pockets = &frame.base().table().pockets;
        calls.extend(on_table.map(|b| Call::Pocket(b, pockets[dice.below(pockets.len())].name)));
    }
    calls
}

/// Frames that ask for a shot, with a play of each: `count` shots of random play of a game.
/// A frame that ends is followed by another.
pub(crate) fn positions(game: Game, seed: u64, count: usize) -> Vec<(Frame, Play)> {
    let mut dice = Dice::new(seed);
    // A few points and a short patience, so that frames end.
    let options = Options { points: 8, patience: 8, ..Options::default() };
    let racked = |seed| Frame::new(game, options, None, None, seed).expect("the game's own table");
    let mut frame = racked(seed);
    let mut found = Vec::new();
    while found.len() < count {
        match *frame.request() {
            Request::Shot(turn) => {
                let play = any_play(&frame, &turn, &mut dice);
                let Ok(shot) = frame.shot(&play) else { continue };
                found.push((frame.clone(), play));
                // The frames go on as the trace of the shot says.
                let trace = Simulator::new().record(&shot).expect("it can be played");
                frame.apply(&play, &trace).expect("it is of this shot");
            }
            Request::Choice { choices, .. } => {
                frame.choose(choices[dice.below(choices.len())]).expect("it is offered");
            }
            Request::Over { .. } => frame = racked(seed + found.len() as u64),
        }
    }
    found
}
