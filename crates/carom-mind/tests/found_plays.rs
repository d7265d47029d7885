//! Plays that the searching player once missed, in the positions in which it was seen.

use carom::Noise;
use carom::format::Node;
use carom::math::{Vec2, sin_cos};
use carom::noise::Errors;
use carom::resolve::cue_ball::Strike;
use carom::table::PocketName;
use carom_mind::line::LineKind;
use carom_mind::search::PlayKind;
use carom_mind::value::{Logistic, Position, Value};
use carom_mind::{Answer, Budget, Player, Searcher, Situation};
use carom_plan::{Prepared, Sampler};
use carom_rules::{Frame, Game, Options, Play};

/// Drawn errors by which a chosen play is judged.
const DRAWN: u64 = 1000;

/// Nine-ball on `table`, with these balls where they lie.
fn nine_ball(table: Node, places: &[(usize, [f64; 2])]) -> Frame {
    let mut frame =
        Frame::new(Game::NineBall, Options::default(), Some(table), None, 0).expect("a frame");
    let mut all = vec![None; frame.layout().len()];
    places.iter().for_each(|(ball, place)| all[*ball] = Some(*place));
    frame.resume_at(&all, 0).expect("a position");
    frame
}

/// Errors of the speed (m/s), the azimuth and the elevation (rad), and of the tip to the side and in height (m).
fn noise([speed, azimuth, elevation, side_m, height_m]: [f64; 5]) -> Noise {
    Noise { speed, azimuth, elevation, side_m, height_m, ..Noise::NONE }
}

/// The chosen play and its stated chance of winning.
fn chosen(frame: &Frame, noise: &Noise, (simulations, seed): (u64, u64)) -> (Play, f64) {
    let situation = Situation::new(frame, noise.clone(), seed);
    let decision = Searcher::default().decide(&situation, &Budget::simulations(simulations));
    let decision = decision.expect("a decision");
    let Answer::Play(play) = decision.answer else { panic!("a play") };
    (play, decision.win_chance.expect("a chance"))
}

/// The shares of drawn errors with which a play keeps the turn, and is a foul.
fn counted(frame: &Frame, noise: &Noise, play: &Play) -> [f64; 2] {
    let prepared = Prepared::new(frame, play.cue_ball).expect("a position");
    let (mut sampler, mut after) = (Sampler::new(), frame.clone());
    let errors = Errors { noise: noise.clone(), seed: 0x636f_756e_7465_6400, ..Errors::default() };
    let mut counts = [0_u64; 2];
    for index in 0..DRAWN {
        sampler.simulate_variant(&prepared, &play.strike, &errors, index).expect("a shot");
        let ruling = sampler.rule(&prepared, play.call, &mut after).expect("a ruling");
        counts[0] += u64::from(after.keeps_turn(0));
        counts[1] += u64::from(!ruling.is_legal());
    }
    counts.map(|count| count as f64 / DRAWN as f64)
}

#[test]
fn a_slow_kick_around_a_blocker_is_found() {
    let balls = [
        (0, [0.4833, 0.6293]),
        (3, [0.6879, 1.8029]),
        (6, [0.5989, 1.4060]),
        (9, [0.6555, 1.5964]),
    ];
    let frame = nine_ball(Node::from("bar-7ft"), &balls);
    let noise = noise([0.071829, 0.001127, 0.002835, 0.000949, 0.000865]);
    for seed in 0..3 {
        let (play, _) = chosen(&frame, &noise, (5000, seed));
        let [kept, _] = counted(&frame, &noise, &play);
        // A fast kick keeps the turn in 87 to 93 %.
        assert!(kept > 0.96, "{kept} with seed {seed}: {play:?}");
    }
}

#[test]
fn a_soft_pot_that_kisses_the_rail_before_a_blocked_ball_is_a_candidate() {
    let table = r#"{
        "base": "wpa-9ft", "length": 2.13, "width": 1.17,
        "corner_pocket": {"mouth": 0.109, "shelf": 0.03}, "side_pocket": {"mouth": 0.121},
        "markings": {"head_string": 0.53}
    }"#;
    let balls = [
        (0, [1.067, 2.027]),
        (2, [1.086, 0.210]),
        (8, [1.074, 1.461]),
        (7, [0.706, 0.955]),
        (9, [0.601, 1.289]),
    ];
    let frame = nine_ball(Node::from_json(table).expect("a table"), &balls);
    let noise = Noise::olympiad(0.456);
    for seed in 0..2 {
        let situation = Situation::new(&frame, noise.clone(), seed);
        let list =
            Searcher::default().analyse(&situation, &Budget::simulations(5000), 6).expect("a list");
        let found = list.plays.iter().find(|listed| {
            let off = sin_cos(listed.play.strike.azimuth - 4.85834).0.abs();
            listed.kind == PlayKind::Pot(LineKind::Kick)
                && listed.pot == Some((2, PocketName::BottomRight))
                && off < 0.03
        });
        let found = found.unwrap_or_else(|| panic!("seed {seed}: {list:#?}"));
        let [kept, _] = counted(&frame, &noise, &found.play);
        assert!(kept > 0.93, "{kept} with seed {seed}: {found:?}");
    }
}

#[test]
fn more_thought_does_not_play_a_lone_nine_worse() {
    let frame = nine_ball(Node::from("bar-7ft"), &[(0, [0.4205, 0.5176]), (9, [0.7133, 1.1081])]);
    let noise = noise([0.058444, 0.002028, 0.018756, 0.001401, 0.0006]);
    for simulations in [300, 2000, 5000] {
        for seed in 0..4 {
            let (play, stated) = chosen(&frame, &noise, (simulations, seed));
            let [kept, _] = counted(&frame, &noise, &play);
            let story = format!("{kept} with {simulations} and seed {seed}, stated {stated}");
            // It was 0.89 to 0.96 with 5000 simulations.
            assert!(kept > 0.93, "{story}");
            // With 300 simulations 18 samples state the chance.
            assert!(simulations == 300 || (stated - kept).abs() < 0.06, "{story}");
        }
    }
}

#[test]
fn ball_in_hand_is_not_given_away_on_purpose_with_eight_balls_up() {
    let balls = [
        (0, [0.4699, 1.2237]),
        (1, [0.9647, 2.4699]),
        (2, [0.8168, 2.4441]),
        (3, [0.5561, 0.3984]),
        (4, [0.5623, 1.1900]),
        (5, [0.6849, 1.2091]),
        (7, [0.1349, 2.2092]),
        (8, [1.1812, 1.6231]),
        (9, [0.5201, 1.3503]),
    ];
    let frame = nine_ball(Node::from("wpa-9ft"), &balls);
    let noise = Noise::olympiad(1.0);
    for seed in 0..3 {
        let (play, stated) = chosen(&frame, &noise, (5000, seed));
        let [_, foul] = counted(&frame, &noise, &play);
        // It was a foul in nearly all variants, with 52 % stated where 34 % were won.
        assert!(foul < 0.4 && stated < 0.49, "{foul}, stated {stated}, with seed {seed}");
    }
}

#[test]
fn ball_in_hand_is_worth_more_than_the_best_place_without_it() {
    let noise = [Noise::olympiad(1.0), Noise::olympiad(1.0)];
    let value = |frame: &Frame| {
        let turn = frame.turn().expect("a shot");
        Logistic.of_shot(&Position { frame, noise: &noise }, turn)
    };
    let balls =
        [(3, [0.9, 2.2]), (6, [0.25, 1.9]), (7, [0.3, 0.9]), (8, [1.0, 1.2]), (9, [0.6, 1.6])];
    let at = |place| nine_ball(Node::from("wpa-9ft"), &[&[(0, place)], &balls[..]].concat());
    let places =
        (0..20).flat_map(|i| (0..40).map(move |j| [0.05 * f64::from(i), 0.06 * f64::from(j)]));
    let places = places.map(|[x, y]| [x + 0.1, y + 0.1]);
    let is_free =
        |[x, y]: &[f64; 2]| balls.iter().all(|(_, [a, b])| Vec2::new(x - a, y - b).length() > 0.06);
    let best = places.filter(is_free).map(|place| value(&at(place))).fold(0.0, f64::max);
    // A shot that meets no ball.
    let mut frame = at([0.635, 0.4]);
    let strike = Strike { speed: 0.3, azimuth: 4.7, elevation: 0.0, side: 0.0, height: 0.0 };
    assert!(!frame.play(&Play::new(strike)).expect("a shot").0.is_legal());
    let in_hand = value(&frame);
    assert!(in_hand > best, "{in_hand} and {best}");
}
