//! Frames between random players: every frame ends, and the balls and the points always add up.

use carom::math::{Vec2, atan2};
use carom::outcome::{Outcome, Touched};
use carom::resolve::cue_ball::Strike;
use carom_rules::{
    BallIndex, Call, Choice, Frame, FrameSimulator, Game, GameFacts, Objective, Options, Play,
    Prepared, Request, Scoring, Seat, Turn,
};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

/// Tests into which the frames of each game are divided, so that all cores are used.
const SHARDS: u64 = 16;

/// Frames of each game: 1000 in release, fewer in a debug build, 100 000 in `make stress`.
fn frames() -> u64 {
    let asked = std::env::var("CAROM_FRAMES").ok().and_then(|n| n.parse().ok());
    asked.unwrap_or(if cfg!(debug_assertions) { 30 } else { 1000 })
}

/// Width of the distribution of the errors of aim, rad, for even and for odd seeds. Only players
/// with the small error pot enough balls in a row for fourteen to be racked again; only those with
/// the large error miss and foul often enough.
const SPREADS: [f64; 2] = [0.02, 0.002];

/// The same on a table without pockets, rad: nearly all directions, because most caroms go by
/// cushions first.
const SPREAD_OF_CAROMS: f64 = 3.0;

struct Dice {
    random: Pcg64,
    spread: f64,
}

impl Dice {
    fn new(seed: u64) -> Self {
        let spread = SPREADS[usize::from(seed % 2 == 1)];
        Self { random: Pcg64::new(seed.into(), 7), spread }
    }

    fn unit(&mut self) -> f64 {
        (self.random.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    fn below(&mut self, n: usize) -> usize {
        (self.unit() * n as f64) as usize
    }
}

/// A random allowed play: roughly aimed at a ball on, with any allowed call.
fn any_play(frame: &Frame, turn: &Turn, dice: &mut Dice) -> Play {
    let (layout, size) = (frame.layout(), frame.base().table().size);
    let margin = 0.06;
    let cue_ball = turn.hand.map(|region| {
        loop {
            let place = [
                margin + dice.unit() * (size.x - 2.0 * margin),
                margin + dice.unit() * (size.y - 2.0 * margin),
            ];
            let touches = layout.balls().iter().zip(0..).any(|(other, i)| {
                let there = layout.place(i).filter(|_| i != turn.cue);
                there.is_some_and(|there| distance(place, there) < 2.001 * other.ball.radius)
            });
            if region.holds(frame.base().table(), place) && !touches {
                return place;
            }
        }
    });
    let others: Vec<BallIndex> = layout.on_table().filter(|ball| *ball != turn.cue).collect();
    let targets = if turn.on.is_empty() { &others[..] } else { &turn.on[..] };
    let target = targets[dice.below(targets.len())];
    let from = cue_ball.or(layout.place(turn.cue)).unwrap_or_default();
    let to = layout.place(target).unwrap_or_default();
    let (aim, pocket) = aim_to_pot(frame, from, to, dice);
    let pockets = &frame.base().table().pockets;
    let spread = if pockets.is_empty() { SPREAD_OF_CAROMS } else { dice.spread };
    let azimuth = atan2(aim[1] - from[1], aim[0] - from[0]) + spread * (dice.unit() - 0.5);
    let side = 0.4 * (dice.unit() - 0.5);
    let strike =
        Strike { speed: 0.5 + 4.0 * dice.unit(), azimuth, elevation: 0.0, side, height: 0.0 };
    let calls = &turn.calls;
    let call = if calls.push_out && dice.below(3) == 0 {
        Call::PushOut
    } else if calls.nominate {
        Call::On(target)
    } else if calls.safety && dice.below(10) == 0 {
        Call::Safety
    } else if calls.pocket {
        Call::Pocket(target, pockets[pocket].name)
    } else {
        Call::Nothing
    };
    Play { cue_ball, call, ..Play::new(strike) }
}

/// Where to aim from `from` to pot the ball at `to`, and the index of the pocket: a random one of
/// the pockets with a large enough cut. On a table without pockets the aim is the ball itself.
fn aim_to_pot(frame: &Frame, from: [f64; 2], to: [f64; 2], dice: &mut Dice) -> ([f64; 2], usize) {
    let table = frame.base().table();
    let diameter = 2.0 * frame.base().physics().ball.radius;
    let [from_v, to_v] = [from, to].map(|[x, y]| Vec2::new(x, y));
    let mut best = (to, 0, 0.2);
    for (k, pocket) in table.pockets.iter().enumerate() {
        let way = pocket.center + table.center() - to_v;
        let ghost = to_v - way * (diameter / way.length());
        let shot = ghost - from_v;
        let fullness = shot.dot(way) / (shot.length() * way.length()) - 0.3 * dice.unit();
        if fullness > best.2 {
            best = ([ghost.x, ghost.y], k, fullness);
        }
    }
    (best.0, best.1)
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    Vec2::new(b[0] - a[0], b[1] - a[1]).length()
}

/// Checks what holds after every shot and every choice.
fn check(frame: &Frame, from: &Frame) {
    let layout = frame.layout();
    assert_eq!(layout.len(), from.layout().len(), "the number of balls changed");
    for (i, ball) in (0..).zip(layout.balls()) {
        let Some([x, y]) = layout.place(i) else { continue };
        assert!(x.is_finite() && y.is_finite());
        for (j, other) in (0..i).zip(layout.balls()) {
            let Some([u, v]) = layout.place(j) else { continue };
            let gap = distance([x, y], [u, v]) - ball.ball.radius - other.ball.radius;
            assert!(gap > -1e-9, "{} and {} overlap by {} m", ball.id, other.id, -gap);
        }
    }
    match frame.request() {
        Request::Shot(turn) => {
            let cue_lies = !layout.is_down(turn.cue);
            assert!(
                cue_lies || turn.hand.is_some(),
                "the cue ball is neither on the table nor in hand"
            );
            assert!(turn.on.iter().all(|ball| !layout.is_down(*ball)), "a ball on is down");
        }
        Request::Choice { choices, .. } => assert!(choices.len() > 1, "a choice of one"),
        Request::Over { .. } => {}
    }
}

/// Checks that a shot of `player` may score these points.
fn check_points(facts: &GameFacts, player: Seat, points: [i32; 2], legal: bool) {
    let [mine, others] = [points[player], points[1 - player]];
    match (facts.objective, facts.scoring) {
        (Objective::RedsAndColors, _) if !legal => assert!(mine == 0 && (4..=7).contains(&others)),
        (Objective::RedsAndColors, _) => {
            // All reds, or the black.
            let most = (facts.balls as i32 - 7).max(7);
            assert!(others == 0 && (0..=most).contains(&mine));
        }
        (Objective::Caroms { .. }, Scoring::Target { negative: true, .. }) => {
            assert!(others == 0 && (-1..=1).contains(&mine) && legal == (mine >= 0));
        }
        (Objective::Caroms { .. }, _) => assert!(others == 0 && (0..=1).contains(&mine)),
        (_, Scoring::LastBall) if facts.players == 2 => assert_eq!(points, [0, 0]),
        _ => assert!(others == 0 && legal == (mine >= 0)),
    }
}

/// Plays the frames of one shard.
fn play_frames(game: Game, shard: u64) {
    let mut simulator = FrameSimulator::new();
    // 20 points need a second rack of straight pool; random caroms are rare, so 3 must do.
    let facts = GameFacts::of(game);
    let points = if facts.is_carom() { 3 } else { 20 };
    let options = Options { points, ..Options::default() };
    let mut decided = 0;
    for seed in (0..frames()).filter(|seed| seed % SHARDS == shard) {
        let mut dice = Dice::new(seed);
        let mut frame = Frame::new(game, options, None, None, seed).expect("the game's own table");
        let mut shots = 0;
        while !frame.is_over() {
            let before = frame.clone();
            match before.request() {
                Request::Shot(turn) => {
                    let play = any_play(&frame, turn, &mut dice);
                    match frame.play_in(&mut simulator, &play) {
                        Ok((ruling, _)) => {
                            if !ruling.racked {
                                check_points(facts, turn.player, ruling.points, ruling.is_legal());
                            }
                            let gained = [0, 1].map(|p| frame.scores()[p] - before.scores()[p]);
                            assert_eq!(gained, ruling.points);
                        }
                        // A random cue ball may stand in a jaw.
                        Err(error) => {
                            assert!(error.to_string().starts_with("cue_ball"), "{error}");
                        }
                    }
                    shots += 1;
                }
                Request::Choice { choices, .. } => {
                    let choice: Choice = choices[dice.below(choices.len())];
                    frame.choose(choice).unwrap_or_else(|e| panic!("{e}"));
                }
                Request::Over { .. } => unreachable!(),
            }
            check(&frame, &before);
            assert!(shots < 10_000, "{} with seed {seed} does not end", game.name());
        }
        decided += u64::from(matches!(frame.request(), Request::Over { winner: Some(_), .. }));
        assert!(frame.turn().is_none() && frame.player().is_none());
    }
    println!("{}, shard {shard}: {decided} frames decided", game.name());
}

macro_rules! shards {
    ($($name:ident: $shard:expr;)*) => { $(
        #[test]
        fn $name() {
            for game in Game::ALL {
                play_frames(game, $shard);
            }
        }
    )* };
}

shards! {
    random_frames_end_shard_0: 0;
    random_frames_end_shard_1: 1;
    random_frames_end_shard_2: 2;
    random_frames_end_shard_3: 3;
    random_frames_end_shard_4: 4;
    random_frames_end_shard_5: 5;
    random_frames_end_shard_6: 6;
    random_frames_end_shard_7: 7;
    random_frames_end_shard_8: 8;
    random_frames_end_shard_9: 9;
    random_frames_end_shard_10: 10;
    random_frames_end_shard_11: 11;
    random_frames_end_shard_12: 12;
    random_frames_end_shard_13: 13;
    random_frames_end_shard_14: 14;
    random_frames_end_shard_15: 15;
}

/// The outcome of a trace whose ball `k` is ball `balls[k]` of the frame, if the cue ball was not in
/// hand, with the frame's ball indices.
fn of_frame(traced: &Outcome, turn: &Turn, balls: &[BallIndex]) -> Outcome {
    let mut balls = balls.to_vec();
    if !balls.contains(&turn.cue) {
        balls.push(turn.cue);
        balls.sort_unstable();
    }
    let ball = |k: u16| balls[usize::from(k)];
    Outcome {
        cue_ball: traced.cue_ball.map(ball),
        first_contact: traced.first_contact.map(ball),
        pocketed: traced.pocketed.iter().map(|&(k, pocket)| (ball(k), pocket)).collect(),
        off_table: traced.off_table.iter().map(|&k| ball(k)).collect(),
        hanging: traced.hanging.iter().map(|&(k, pocket)| (ball(k), pocket)).collect(),
        jumped: traced.jumped.iter().map(|&(a, b)| (ball(a), ball(b))).collect(),
        rails_after_first_contact: {
            traced.rails_after_first_contact.iter().map(|&(k, rail)| (ball(k), rail)).collect()
        },
        driven_to_rail: traced.driven_to_rail.iter().map(|&k| ball(k)).collect(),
        cue_ball_touched: {
            let touched = |t: &Touched| match *t {
                Touched::Ball(k) => Touched::Ball(ball(k)),
                rail @ Touched::Rail(_) => rail,
            };
            traced.cue_ball_touched.iter().map(touched).collect()
        },
        met_during_strike: traced.met_during_strike.iter().map(|&k| ball(k)).collect(),
        never_resting: traced.never_resting.iter().map(|&k| ball(k)).collect(),
        ..*traced
    }
}

#[test]
fn the_ruling_on_a_trace_equals_the_ruling_on_its_shot() {
    for game in Game::ALL {
        let mut dice = Dice::new(5);
        let mut frame = Frame::new(game, Options::default(), None, None, 5).expect("a rack");
        for _ in 0..20 {
            match *frame.request() {
                Request::Shot(turn) => {
                    let play = any_play(&frame, &turn, &mut dice);
                    let Ok(shot) = frame.shot(&play) else { continue };
                    let trace = shot.simulate().expect("it can be played");
                    let mut same = frame.clone();
                    let balls: Vec<BallIndex> = frame.layout().on_table().collect();
                    let ruling = same.apply(&play, &trace).expect("it is of this shot");
                    let (expected, outcome) = frame.play(&play).expect("it can be played");
                    assert_eq!(ruling, expected);
                    assert_eq!(outcome, of_frame(trace.outcome(), &turn, &balls));
                    assert_eq!(same.to_node(), frame.to_node());
                }
                Request::Choice { choices, .. } => {
                    frame.choose(choices[0]).expect("it is among them");
                }
                Request::Over { .. } => break,
            }
        }
    }
}

/// The environments simulate an intended shot, to name its pocket, only where a ball has fallen.
#[test]
fn no_ruling_depends_on_the_named_pocket_where_no_ball_falls() {
    let mut compared = 0;
    let mut simulator = FrameSimulator::new();
    for game in Game::ALL {
        let mut dice = Dice::new(4);
        let mut frame = Frame::new(game, Options::default(), None, None, 4).expect("a rack");
        for _ in 0..200 {
            match *frame.request() {
                Request::Shot(turn) => {
                    let play = any_play(&frame, &turn, &mut dice);
                    let Ok(prepared) = Prepared::new(&frame, play.cue_ball) else { continue };
                    simulator.simulate(&prepared, &play.strike).expect("it can be played");
                    let rule = |call| {
                        let mut successor = frame.clone();
                        let ruling = simulator.rule(&prepared, call, &mut successor);
                        (ruling.expect("an allowed call"), successor.to_node())
                    };
                    let named = matches!(play.call, Call::Pocket(..));
                    if named && turn.calls.safety && simulator.outcome().pocketed.is_empty() {
                        assert_eq!(rule(play.call), rule(Call::Safety));
                        compared += 1;
                    }
                    let _ = frame.play(&play);
                }
                Request::Choice { choices, .. } => {
                    frame.choose(choices[0]).expect("it is among them");
                }
                Request::Over { .. } => break,
            }
        }
    }
    assert!(compared > 100, "{compared} shots");
}

#[test]
fn a_frame_continues_from_given_places() {
    let frame = |game| Frame::new(game, Options::default(), None, None, 3).expect("a rack");
    let mut middle = frame(Game::NineBall);
    let mut places = vec![None; 10];
    for (ball, y) in [(0, 0.5), (4, 1.0), (9, 1.5)] {
        places[ball] = Some([0.4, y]);
    }
    middle.resume_at(&places, 1).expect("a valid position");
    let turn = middle.turn().expect("a shot");
    assert_eq!((turn.player, turn.hand, &turn.on[..]), (1, None, &[4][..]));
    assert_eq!(
        middle.with_seed(3).expect("the same rack").layout(),
        frame(Game::NineBall).layout()
    );
    // Straight up the table at the 4.
    let up = |speed| {
        let azimuth = core::f64::consts::FRAC_PI_2;
        Play::new(Strike { speed, azimuth, elevation: 0.0, side: 0.0, height: 0.0 })
    };
    let prepared = Prepared::new(&middle, None).expect("a shot");
    let mut simulator = FrameSimulator::new();
    let straight = carom_rules::through_degrees(&up(3.0).strike);
    simulator.simulate(&prepared, &straight).expect("it can be played");
    let mut successor = frame(Game::Snooker);
    let ruling = simulator.rule(&prepared, Call::Nothing, &mut successor).expect("no call");
    let mut same = middle.clone();
    let (expected, outcome) = same.play(&up(3.0)).expect("it can be played");
    assert_eq!((ruling, simulator.outcome()), (expected, &outcome));
    assert_eq!((successor.layout(), successor.to_node()), (same.layout(), same.to_node()));

    let mut nine_down = places.clone();
    nine_down[9] = None;
    assert!(same.resume_at(&nine_down, 0).is_err());
    assert!(same.resume_at(&places[..9], 0).is_err());
    assert!(frame(Game::Snooker).resume_at(&places, 0).is_err());
}

/// The balls on at an open table.
const OPEN_TABLE: [BallIndex; 14] = [1, 2, 3, 4, 5, 6, 7, 9, 10, 11, 12, 13, 14, 15];

#[test]
fn every_game_continues_from_given_places_with_the_right_balls_on() {
    // The rack, with some of its balls taken away.
    let begun = |game: Game, down: &[usize]| {
        let mut frame = Frame::new(game, Options::default(), None, None, 3).expect("a rack");
        let count = frame.layout().len() as BallIndex;
        let mut places: Vec<_> = (0..count).map(|ball| frame.layout().place(ball)).collect();
        // In some racks the cue ball is in hand and has no place.
        places[0] = places[0].or(Some([0.3, 0.3]));
        down.iter().for_each(|ball| places[*ball] = None);
        frame.resume_at(&places, 1).map(|()| frame)
    };
    let all_reds: Vec<usize> = (1..=15).collect();
    let to_blue: Vec<usize> = (1..=18).collect();
    for (game, down, on, nominates) in [
        (Game::EightBall, &[1, 2][..], &OPEN_TABLE[2..], false),
        (Game::TenBall, &[1, 2], &[3], false),
        (Game::StraightPool, &[1, 2, 3], &[], false),
        (Game::Snooker, &all_reds[..13], &[14, 15], false),
        (Game::Snooker, &all_reds, &[16], false),
        (Game::Snooker, &to_blue, &[19], false),
        (Game::ThreeCushion, &[], &[], false),
        (Game::Practice, &[3], &[], false),
    ] {
        let frame = begun(game, down).expect("a valid position");
        let turn = frame.turn().expect("a shot");
        let found = (turn.player, turn.hand, &turn.on[..], turn.calls.nominate);
        assert_eq!(found, (1, None, on, nominates), "{}", game.name());
        assert_eq!(frame.layout().on_table().count(), frame.layout().len() - down.len());
    }
    let all_but_one: Vec<usize> = (1..15).collect();
    for (game, down) in [
        (Game::EightBall, &[8][..]),
        (Game::TenBall, &[10]),
        (Game::StraightPool, &all_but_one),
        (Game::Snooker, &[1, 16]),
        (Game::Snooker, &[21]),
        (Game::ThreeCushion, &[1]),
    ] {
        let refused =
            begun(game, down).expect_err("a position that the game cannot have").to_string();
        assert!(refused.starts_with("places: "), "{refused}");
    }
    let blue_before_green: Vec<usize> = (1..=16).chain([19]).collect();
    let refused = begun(Game::Snooker, &blue_before_green).expect_err("an order").to_string();
    assert!(refused.contains("5 points"), "{refused}");
}
