//! Rulings that need more than the outcome of a shot, on simulated shots.

use carom::Noise;
use carom::batch::draw_strikes;
use carom::resolve::cue_ball::Strike;
use carom::shot::{Policy, StrikePolicy};
use carom_rules::{Call, Choice, ErrorSeeds, Foul, Frame, Game, Options, Play, Prepared, Ruling};

/// Straight up the table.
const UP: f64 = core::f64::consts::FRAC_PI_2;

fn frame(game: Game) -> Frame {
    Frame::new(game, Options::default(), None, None, 1).expect("the game's own table")
}

fn break_at(azimuth: f64, speed: f64) -> Ruling {
    let strike = Strike { speed, azimuth, elevation: 0.0, side: 0.0, height: 0.0 };
    let play = Play { cue_ball: Some([0.3, 0.3]), call: Call::Safety, ..Play::new(strike) };
    frame(Game::StraightPool).play(&play).expect("it can be played").0
}

#[test]
fn only_a_cue_ball_that_stops_before_the_head_string_commits_the_head_string_foul() {
    let fouls = |ruling: Ruling| ruling.fouls.iter().collect::<Vec<_>>();
    assert_eq!(
        fouls(break_at(UP, 0.15)),
        [Foul::NoContact, Foul::BehindHeadString, Foul::SoftBreak],
        "it stops before the string"
    );
    assert_eq!(
        fouls(break_at(UP, 2.0)),
        [Foul::NoContact, Foul::SoftBreak],
        "it crosses the string"
    );
}

#[test]
fn a_miscue_is_refused_or_played_as_the_policy_of_the_play_says() {
    let strike = Strike { speed: 3.0, azimuth: UP, elevation: 0.1, side: 0.55, height: 0.0 };
    let refused = Play { call: Call::Safety, ..Play::new(strike) };
    let mut frame = frame(Game::StraightPool);
    let error = frame.play(&refused).expect_err("a miscue").to_string();
    assert!(error.starts_with("strike.side: ") && error.contains("miscue"), "{error}");
    let policy = StrikePolicy { miscue: Policy::Report, ..StrikePolicy::default() };
    let reported = Play { policy, ..refused };
    let raised = frame.at_default_elevation(&reported).expect("the tip does not slip");
    assert!(raised.strike.elevation > 0.05 && raised.policy == policy, "{raised:?}");
    assert!(frame.shot(&reported).expect("the tip does not slip").is_miscue());
    // So are the drawn strikes.
    let prepared = [Prepared::new(&frame, None), Prepared::of_play(&frame, &reported)];
    let [usual, held] = prepared.map(|shot| shot.expect("a shot").struck_ball().largest_offset);
    assert!(usual < 0.55 && held > 0.99, "{usual} {held}");
    frame.play(&reported).expect("the tip does not slip");
    // The policy is that of one shot.
    assert!(frame.base().strike_policy() == StrikePolicy::default());
}

#[test]
fn a_drawn_play_has_the_strike_and_the_cling_of_the_variant_with_the_number_of_the_shot() {
    let noise = Noise { azimuth: 0.001, cling_probability: 0.5, ..Noise::NONE };
    let mut frame = frame(Game::Practice);
    for index in 0..3 {
        let strike = Strike { speed: 2.0, azimuth: UP, elevation: 0.1, side: 0.0, height: 0.0 };
        let meant = Play::new(strike);
        let shot = frame.shot(&meant).expect("a shot");
        let drawn = frame.draw_play(&meant, &noise, ErrorSeeds::Frame(7)).expect("a play");
        assert_eq!(drawn.strike, draw_strikes(&shot, &noise, 1, 7, index).expect("one")[0]);
        assert_eq!(drawn.cling, noise.draw_cling(7, index));
        assert_eq!(*frame.shot(&drawn).expect("a shot").cling(), drawn.cling);
        // Without cling in the noise that of the play remains.
        let clinging = Play { cling: drawn.cling, ..meant };
        let exact = frame.draw_play(&clinging, &Noise::NONE, ErrorSeeds::Frame(7)).expect("a play");
        assert_eq!(exact.cling, drawn.cling);
        frame.play(&drawn).expect("it can be played");
    }
}

/// As in a match: the errors of a seat do not depend on what the other one does.
#[test]
fn with_a_seed_for_each_seat_the_variant_has_the_number_of_the_seat_s_own_shots() {
    let noise = Noise { azimuth: 0.001, ..Noise::NONE };
    let mut frame = frame(Game::ThreeCushion);
    let meant =
        Play::new(Strike { speed: 2.0, azimuth: UP, elevation: 0.1, side: 0.0, height: 0.0 });
    let mut own = [0, 0];
    for _ in 0..5 {
        let seat = frame.player().expect("a shot");
        let shot = frame.shot(&meant).expect("a shot");
        let drawn = frame.draw_play(&meant, &noise, ErrorSeeds::Seats([3, 4])).expect("a play");
        let seed = [3, 4][seat];
        assert_eq!(drawn.strike, draw_strikes(&shot, &noise, 1, seed, own[seat]).expect("one")[0]);
        own[seat] += 1;
        frame.play(&drawn).expect("it can be played");
        if frame.turn().is_none() {
            frame.choose(Choice::PlayOn).expect("it is offered");
        }
        assert_eq!(frame.shots_by_seat().map(u64::from), own);
    }
    assert!(own[0] > 0 && own[1] > 0, "{own:?}");
}

/// The ruling on a stroke up the table, with the blue between the cue ball and a red.
fn over_the_blue(elevation: f64) -> Ruling {
    let mut frame = frame(Game::Snooker);
    let mut places: Vec<_> = (0..22).map(|ball| frame.layout().place(ball)).collect();
    (1..=15).for_each(|red| places[red] = None);
    places[0] = Some([0.6, 1.0]);
    places[19] = Some([0.6, 1.7]);
    places[1] = Some([0.6, 2.6]);
    frame.resume_at(&places, 0).expect("a red is left");
    let strike = Strike { speed: 5.0, azimuth: UP, elevation, side: 0.0, height: 0.0 };
    frame.play(&Play::new(strike)).expect("it can be played").0
}

#[test]
fn in_snooker_a_jump_over_a_ball_is_a_foul_even_if_the_red_is_hit_first() {
    let jump = over_the_blue(0.9);
    assert!(jump.fouls.has(Foul::Jump) && !jump.fouls.has(Foul::WrongBallFirst), "{jump:?}");
    let level = over_the_blue(0.0);
    assert!(level.fouls.has(Foul::WrongBallFirst) && !level.fouls.has(Foul::Jump), "{level:?}");
}

/// The ruling on a stroke at this azimuth: the cue ball touches `ball`, which is up the table from
/// it, and `others` are elsewhere.
fn from_contact(game: Game, ball: usize, others: &[(usize, [f64; 2])], azimuth: f64) -> Ruling {
    let mut frame = frame(game);
    let diameter = 2.0 * frame.base().physics().ball.radius;
    let mut places = vec![None; frame.layout().len()];
    places[0] = Some([0.5, 1.0]);
    places[ball] = Some([0.5, 1.0 + diameter]);
    others.iter().for_each(|(other, place)| places[*other] = Some(*place));
    frame.resume_at(&places, 0).expect("a valid position");
    if frame.turn().is_none() {
        frame.choose(Choice::PlayOn).expect("it is offered");
    }
    let strike = Strike { speed: 2.0, azimuth, elevation: 0.0, side: 0.0, height: 0.0 };
    frame.play(&Play::new(strike)).expect("it can be played").0
}

#[test]
fn in_pool_a_shot_at_a_touching_ball_hits_it_and_a_shot_away_from_it_does_not() {
    let nine = |ball, other, azimuth| {
        let ruling = from_contact(Game::NineBall, ball, &[(other, [0.2, 0.3])], azimuth);
        ruling.fouls.iter().collect::<Vec<_>>()
    };
    assert_eq!(nine(1, 9, UP), []);
    assert_eq!(nine(1, 9, 0.0), [Foul::NoContact]);
    assert_eq!(nine(9, 1, UP), [Foul::WrongBallFirst]);
    assert_eq!(nine(1, 9, -UP), [], "it comes back to the ball from the rail");
}

#[test]
fn in_snooker_a_shot_at_a_touching_ball_is_a_push_and_a_shot_away_counts_as_a_hit() {
    let colors: Vec<(usize, [f64; 2])> =
        (16..22).map(|color| (color, [1.0, 0.1 * color as f64])).collect();
    let red = |azimuth| from_contact(Game::Snooker, 1, &colors, azimuth);
    assert_eq!(red(UP).fouls.iter().collect::<Vec<_>>(), [Foul::Push]);
    assert_eq!(red(UP).points, [0, 4]);
    // Across the table, and slightly away from the ball.
    assert!(red(-0.1).is_legal(), "it touches nothing but rails");
}

#[test]
fn in_three_cushion_a_shot_at_a_frozen_ball_is_a_foul() {
    let red = |azimuth| from_contact(Game::ThreeCushion, 2, &[(1, [1.0, 2.0])], azimuth);
    assert!(red(UP).fouls.has(Foul::Push));
    assert!(red(0.0).is_legal() && red(-UP).is_legal());
}

#[test]
fn a_ball_pressed_into_the_rail_to_which_it_is_frozen_is_not_driven_to_it() {
    let fouls = |gap: f64, speed| {
        let mut frame = frame(Game::NineBall);
        let top = {
            let table = frame.base().table();
            table.size.y - table.reach(frame.base().physics().ball.radius)
        };
        let mut places = vec![None; 10];
        for (ball, place) in [(0, [0.4, 1.8]), (1, [0.4, top - gap]), (9, [0.2, 0.3])] {
            places[ball] = Some(place);
        }
        frame.resume_at(&places, 0).expect("a valid position");
        let strike = Strike { speed, azimuth: UP, elevation: 0.0, side: 0.0, height: 0.0 };
        let ruling = frame.play(&Play::new(strike)).expect("it can be played").0;
        ruling.fouls.iter().collect::<Vec<_>>()
    };
    assert_eq!(fouls(0.0, 0.9), [Foul::NoRailAfterContact]);
    assert_eq!(fouls(0.001, 0.9), [], "it was not frozen");
    assert_eq!(fouls(0.0, 3.0), [], "the cue ball comes to the other end");
}

#[test]
fn in_pool_a_jump_over_a_ball_is_not_a_foul() {
    let mut frame = frame(Game::NineBall);
    let mut places = vec![None; 10];
    for (ball, place) in [(0, [0.6, 0.8]), (2, [0.6, 1.4]), (1, [0.6, 2.25]), (9, [0.2, 0.3])] {
        places[ball] = Some(place);
    }
    frame.resume_at(&places, 0).expect("a valid position");
    let strike = |elevation| Strike { speed: 4.5, azimuth: UP, elevation, side: 0.0, height: 0.0 };
    let mut level = frame.clone();
    let level = level.play(&Play::new(strike(0.0))).expect("it can be played").0;
    assert!(level.fouls.has(Foul::WrongBallFirst));
    let over = frame.play(&Play::new(strike(0.9))).expect("it can be played").0;
    assert!(over.is_legal(), "{over:?}");
}
