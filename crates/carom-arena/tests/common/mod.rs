//! Players for the tests, and the matches that they play.

#![allow(dead_code, reason = "every test file uses some of them")]

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use carom::format::Node;
use carom::math::{Vec2, atan2};
use carom::resolve::cue_ball::Strike;
use carom::runner::Runner;
use carom::{Error, Noise};
use carom_arena::{
    ArenaFrame, Clock, Match, MatchPlan, MatchSettings, PlayerEntry, PlayerIndex, RECORD, Secret,
    play_frame, play_match,
};
use carom_mind::{Answer, Budget, Decision, Player, Situation, Spent};
use carom_plan::Progress;
use carom_rules::FrameSimulator;
use carom_rules::{Call, Frame, Game, Options, Play, Request, Turn};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

pub(crate) struct Dice(Pcg64);

impl Dice {
    pub(crate) fn unit(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn below(&mut self, n: usize) -> usize {
        (self.unit() * n as f64) as usize
    }
}

/// Width of the errors of a random player's aim, rad.
const SPREAD: f64 = 0.02;

/// A random allowed play, roughly aimed to pot a ball on.
pub(crate) fn random_play(frame: &Frame, turn: &Turn, dice: &mut Dice) -> Play {
    let layout = frame.layout();
    let cue_ball = turn.hand.map(|_| free_place(frame, turn, dice));
    let from = cue_ball.or(layout.place(turn.cue)).unwrap_or_default();
    let others: Vec<_> = layout.on_table().filter(|ball| *ball != turn.cue).collect();
    let targets = if turn.on.is_empty() { &others[..] } else { &turn.on[..] };
    let target = targets[dice.below(targets.len())];
    let to = layout.place(target).unwrap_or_default();
    let table = frame.base().table();
    let (from, to) = (Vec2::new(from[0], from[1]), Vec2::new(to[0], to[1]));
    let pockets = &table.pockets;
    let mut aim = (to, 0, 0.2);
    for (k, pocket) in pockets.iter().enumerate() {
        let way = pocket.center + table.center() - to;
        let ghost = to - way * (2.0 * frame.base().physics().ball.radius / way.length());
        let fullness = (ghost - from).dot(way) / ((ghost - from).length() * way.length());
        if fullness - 0.3 * dice.unit() > aim.2 {
            aim = (ghost, k, fullness);
        }
    }
    let way = aim.0 - from;
    let spread = if pockets.is_empty() { 3.0 } else { SPREAD };
    let azimuth = atan2(way.y, way.x) + spread * (dice.unit() - 0.5);
    let (speed, side) = (0.5 + 4.0 * dice.unit(), 0.4 * (dice.unit() - 0.5));
    let strike = Strike { speed, azimuth, elevation: 0.05, side, height: 0.0 };
    let call = if turn.calls.nominate {
        Call::On(target)
    } else if turn.calls.pocket {
        Call::Pocket(target, pockets[aim.1].name)
    } else {
        Call::Nothing
    };
    Play { cue_ball, call, ..Play::new(strike) }
}

/// A random place for a cue ball in hand, which no ball is in the way of.
fn free_place(frame: &Frame, turn: &Turn, dice: &mut Dice) -> [f64; 2] {
    let (layout, table) = (frame.layout(), frame.base().table());
    let Some(region) = turn.hand else { return [0.0; 2] };
    let [low, high] = region.bounds(table);
    let margin = 0.08;
    loop {
        let place = [0, 1].map(|k| {
            let (low, high) =
                (low[k].max(margin), high[k].min([table.size.x, table.size.y][k] - margin));
            low + (high - low) * dice.unit()
        });
        let free = layout.on_table().filter(|ball| *ball != turn.cue).all(|ball| {
            let [x, y] = layout.place(ball).unwrap_or_default();
            Vec2::new(place[0] - x, place[1] - y).length() > 0.08
        });
        if free && region.holds(table, place) {
            return place;
        }
    }
}

/// Plays a random legal direction. Its decisions follow from the seed that it is given.
pub(crate) struct RandomPlayer;

impl Player for RandomPlayer {
    fn name(&self) -> &str {
        "random"
    }

    fn decide(&mut self, situation: &Situation<'_>, _: &Budget<'_>) -> Result<Decision, Error> {
        situation.asked()?;
        let mut dice = Dice(Pcg64::new(situation.seed.into(), 3));
        let answer = match situation.frame.request() {
            Request::Shot(turn) => Answer::Play(random_play(situation.frame, turn, &mut dice)),
            Request::Choice { choices, .. } => Answer::Choice(choices[dice.below(choices.len())]),
            Request::Over { .. } => unreachable!("asked() refuses it"),
        };
        let win_chance = Some(dice.unit());
        Ok(Decision { answer, win_chance, spent: Spent { simulations: 3, rounds: 1 } })
    }
}

/// Gives this answer to every request, and claims to have spent this many simulated shots.
pub(crate) struct Repeater {
    pub(crate) answer: Answer,
    pub(crate) simulations: u64,
}

impl Player for Repeater {
    fn name(&self) -> &str {
        "repeater"
    }

    fn decide(&mut self, _: &Situation<'_>, _: &Budget<'_>) -> Result<Decision, Error> {
        let spent = Spent { simulations: self.simulations, rounds: 1 };
        Ok(Decision { answer: self.answer, win_chance: None, spent })
    }
}

/// Returns an error from the second request on.
pub(crate) struct Failing(pub(crate) u32);

impl Player for Failing {
    fn name(&self) -> &str {
        "failing"
    }

    fn decide(
        &mut self,
        situation: &Situation<'_>,
        budget: &Budget<'_>,
    ) -> Result<Decision, Error> {
        self.0 += 1;
        if self.0 > 1 {
            return Err(carom::ErrorKind::System.at("mind", "it has lost its way", "mend it"));
        }
        RandomPlayer.decide(situation, budget)
    }
}

/// The players of the usual tests: two random ones.
pub(crate) fn random_players(_: PlayerIndex) -> Result<Box<dyn Player>, Error> {
    Ok(Box::new(RandomPlayer))
}

/// Two random players.
pub(crate) fn two_random() -> [Box<dyn Player>; 2] {
    [Box::new(RandomPlayer), Box::new(RandomPlayer)]
}

/// Settings for short frames with errors: 3 points win straight pool and three-cushion, and 25 shots
/// without progress are a stalemate.
pub(crate) fn short(game: Game) -> MatchSettings {
    MatchSettings {
        options: Options { points: 3, patience: 25, ..Options::default() },
        noise: [const { Noise::olympiad(1.0) }; 2],
        clock: [Clock::simulations(100); 2],
        ..MatchSettings::new(game)
    }
}

pub(crate) fn made(settings: MatchSettings) -> Arc<Match> {
    Match::new(settings, [PlayerEntry::new("one"), PlayerEntry::new("other")]).unwrap().into()
}

pub(crate) const SECRET: Secret = Secret::new([42; 32]);

pub(crate) fn plan(settings: MatchSettings, pairs: u64) -> MatchPlan {
    MatchPlan { of: made(settings), pairs, test: None, secret: Some(SECRET) }
}

/// Plays frame `number` of a match between two players.
pub(crate) fn played(
    of: &Arc<Match>,
    number: u64,
    mut players: [Box<dyn Player>; 2],
) -> ArenaFrame {
    let mut simulator = FrameSimulator::new();
    let seeds = SECRET.pair_seeds(number / 2);
    let mut frame = ArenaFrame::begin(of.clone(), number, seeds, &mut simulator).unwrap();
    play_frame(&mut frame, &mut players, &mut simulator, &Progress::default()).unwrap();
    frame
}

/// A folder that is removed with this value.
pub(crate) struct Folder(PathBuf);

impl Folder {
    pub(crate) fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("carom-arena-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        Self(path)
    }

    pub(crate) fn path(&self) -> &Path {
        &self.0
    }

    pub(crate) fn read(&self, name: &str) -> String {
        fs::read_to_string(self.0.join(name)).unwrap()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

pub(crate) fn runner(threads: usize) -> Runner {
    Runner::new(Some(threads)).unwrap()
}

/// The lines of a record, as values.
pub(crate) fn lines(text: &str) -> Vec<Node> {
    text.lines().map(|line| Node::from_json(line).unwrap()).collect()
}

/// The record of the match, which is played in the folder `name`.
pub(crate) fn record(plan: &MatchPlan, name: &str) -> String {
    let folder = Folder::new(name);
    let progress = Progress::default();
    play_match(plan, folder.path(), &random_players, &runner(1), &progress).unwrap();
    folder.read(RECORD)
}

/// `text` with a digit in the middle of the first number behind `key` on line `line` (from 1)
/// changed.
pub(crate) fn with_changed_digit(text: &str, line: usize, key: &str) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let changed = &mut lines[line - 1];
    let start = changed.find(&format!("\"{key}\": ")).unwrap() + key.len() + 4;
    let is_digit = |c: char| c.is_ascii_digit() || "[.-\"abcdef".contains(c);
    let end = start + changed[start..].find(|c| !is_digit(c)).unwrap();
    let digits: Vec<usize> =
        (start..end).filter(|&i| changed.as_bytes()[i].is_ascii_digit()).collect();
    let middle = digits[digits.len() / 2];
    let digit = changed[middle..=middle].parse::<u8>().unwrap();
    changed.replace_range(middle..=middle, &((digit + 1) % 10).to_string());
    lines.join("\n") + "\n"
}
