//! Straight pool (WPA, section 4).

use super::{CORNER, SIDE, Scenario, assert_fouls, hit};
use crate::{BallIndex, Call, Choice, Foul, Game, Options, Region};

const SAFE: Call = Call::Safety;

/// After a safe opening break: player 1 shoots.
fn opened() -> Scenario {
    let mut scenario = Scenario::of(Game::StraightPool);
    assert!(scenario.play(SAFE, hit(&[5]).driving(&[1, 2])).is_legal());
    assert_eq!(scenario.asks(1).hand, None);
    scenario
}

#[test]
fn the_opening_break_drives_the_cue_ball_and_two_balls_to_a_rail() {
    for driven in [&[1][..], &[]] {
        let mut scenario = Scenario::of(Game::StraightPool);
        let ruling = scenario.play(SAFE, hit(&[5]).driving(driven));
        assert_fouls(&ruling, &[Foul::SoftBreak]);
        assert_eq!(ruling.points, [-2, 0]);
        scenario.offers(1, &[Choice::PlayOn, Choice::RebreakByOther]);
        assert!(scenario.choose(Choice::RebreakByOther).racked);
        scenario.asks(0);
    }
}

#[test]
fn on_the_opening_break_the_cue_ball_must_touch_a_rail_after_the_rack() {
    let mut scenario = Scenario::of(Game::StraightPool);
    let ruling = scenario.play(SAFE, hit(&[]).driving(&[1, 2]).touching(&[-1, 5]));
    assert_fouls(&ruling, &[Foul::SoftBreak]);
    let mut scenario = Scenario::of(Game::StraightPool);
    assert!(scenario.play(SAFE, hit(&[]).driving(&[1, 2]).touching(&[5, -1])).is_legal());
}

#[test]
fn on_the_opening_break_pocketed_balls_count_as_driven_to_a_rail() {
    let mut scenario = Scenario::of(Game::StraightPool);
    let ruling = scenario.play(SAFE, hit(&[5]).driving(&[1]).potting(2, SIDE));
    assert!(ruling.is_legal());
    assert_eq!((ruling.points, &ruling.spotted[..]), ([0, 0], &[2][..]));
}

#[test]
fn a_called_ball_satisfies_the_opening_break_even_with_a_foul() {
    let mut scenario = Scenario::of(Game::StraightPool);
    let happened = hit(&[5]).driving(&[]).potting(5, CORNER).potting(0, SIDE);
    let ruling = scenario.play(Call::Pocket(5, CORNER), happened);
    assert_fouls(&ruling, &[Foul::Scratch]);
    assert_eq!((ruling.points, &ruling.spotted[..]), ([-1, 0], &[5][..]));
    assert_eq!(scenario.asks(1).hand, Some(Region::BehindHeadString));
}

#[test]
fn a_breaking_foul_includes_a_scratch_and_does_not_count_towards_three_fouls() {
    let mut scenario = Scenario::of(Game::StraightPool);
    let ruling = scenario.play(SAFE, hit(&[5]).driving(&[]).potting(0, SIDE));
    assert_fouls(&ruling, &[Foul::Scratch, Foul::SoftBreak]);
    assert_eq!(ruling.points, [-2, 0]);
    assert_eq!(scenario.0.fouls_in_a_row(), [0, 0]);
    scenario.offers(1, &[Choice::PlayFromHand, Choice::RebreakByOther]);
    scenario.choose(Choice::PlayFromHand);
    assert_eq!(scenario.asks(1).hand, Some(Region::BehindHeadString));
}

#[test]
fn a_cue_ball_that_stays_behind_the_head_string_gives_the_cue_ball_in_hand() {
    let scratched = || {
        let mut scenario = opened();
        scenario.play(SAFE, hit(&[3]).potting(0, SIDE));
        scenario.0.put(3, Some([0.3, 0.3]));
        scenario
    };
    let mut scenario = scratched();
    let ruling = scenario.play(SAFE, hit(&[3]).staying_below(0.5));
    assert_fouls(&ruling, &[Foul::BehindHeadString]);
    assert_eq!(ruling.points, [-1, 0]);
    assert_eq!(scenario.asks(1).hand, Some(Region::BehindHeadString));
    let mut scenario = scratched();
    assert_fouls(&scenario.play(SAFE, hit(&[3]).reaching(0.5)), &[Foul::BehindHeadString]);
    assert_eq!(scenario.asks(1).hand, None, "it crossed the string later");
}

#[test]
fn with_all_balls_behind_the_head_string_the_nearest_may_be_spotted() {
    let scratched = || {
        let mut scenario = opened().without(3..=15);
        scenario.0.put(1, Some([0.3, 0.3]));
        scenario.0.put(2, Some([0.9, 0.4]));
        scenario.play(SAFE, hit(&[1]).potting(0, SIDE));
        scenario.offers(0, &[Choice::PlayFromHand, Choice::SpotNearest]);
        scenario
    };
    let mut scenario = scratched();
    assert_eq!(scenario.choose(Choice::SpotNearest).spotted, [2]);
    scenario.lies_at(2, FOOT);
    assert_eq!(scenario.asks(0).hand, Some(Region::BehindHeadString));
    let mut scenario = scratched();
    assert!(scenario.choose(Choice::PlayFromHand).spotted.is_empty());
    scenario.asks(0);
}

#[test]
fn spotted_balls_line_up_on_the_long_string() {
    let mut scenario = opened().without(1..=15);
    for ball in [1, 2, 3] {
        scenario.0.put(ball, Some([0.2, 0.3 * f64::from(ball)]));
    }
    scenario.0.put(0, Some([0.635, 1.93]));
    let ruling = scenario.play(SAFE, hit(&[1]).losing(2).potting(1, SIDE));
    assert_eq!(ruling.spotted, [1, 2]);
    let (diameter, table) = (2.0 * scenario.0.base().physics().ball.radius, FOOT);
    let [one, two] = [1, 2].map(|ball| scenario.0.layout().place(ball).expect("it is spotted"));
    assert!(one[0] == table[0] && two[0] == table[0], "on the long string");
    let off = one[1] - 1.93 - diameter;
    assert!(off > 0.0 && off < 1e-3, "behind the cue ball without touching it: {off}");
    assert!((two[1] - one[1] - diameter).abs() < super::SPOTTED, "against the other");
}

#[test]
fn balls_pocketed_on_a_safety_are_spotted() {
    let mut scenario = opened();
    let ruling = scenario.play(SAFE, hit(&[3]).potting(3, CORNER));
    assert_eq!((ruling.points, &ruling.spotted[..]), ([0, 0], &[3][..]));
    scenario.asks(0);
}

#[test]
fn every_ball_pocketed_by_a_legal_called_shot_counts_one() {
    let mut scenario = opened();
    let ruling =
        scenario.play(Call::Pocket(3, CORNER), hit(&[3]).potting(3, CORNER).potting(7, SIDE));
    assert_eq!(ruling.points, [0, 2]);
    scenario.asks(1);
}

#[test]
fn balls_pocketed_uncalled_or_with_a_foul_are_spotted() {
    let mut scenario = opened();
    let ruling = scenario.play(Call::Pocket(3, CORNER), hit(&[3]).potting(3, SIDE));
    assert_eq!((ruling.points, &ruling.spotted[..]), ([0, 0], &[3][..]));
    scenario.asks(0);
    let mut scenario = opened();
    let ruling =
        scenario.play(Call::Pocket(3, CORNER), hit(&[3]).potting(3, CORNER).potting(0, SIDE));
    assert_eq!((ruling.points, &ruling.spotted[..]), ([0, -1], &[3][..]));
    assert_eq!(scenario.asks(0).hand, Some(Region::BehindHeadString));
}

#[test]
fn a_foul_costs_a_point_and_the_cue_ball_stays_where_it_is() {
    let mut scenario = opened();
    let ruling = scenario.play(SAFE, hit(&[3]).no_rail());
    assert_fouls(&ruling, &[Foul::NoRailAfterContact]);
    assert_eq!(ruling.points, [0, -1]);
    assert_eq!(scenario.asks(0).hand, None);
}

#[test]
fn the_third_foul_in_a_row_costs_fifteen_more_and_a_new_opening_break() {
    let mut scenario = opened();
    for _ in 0..2 {
        scenario.play(SAFE, hit(&[3]).no_rail());
        scenario.play(SAFE, hit(&[3]));
    }
    let ruling = scenario.play(SAFE, hit(&[3]).no_rail());
    assert_eq!(ruling.points, [0, -16]);
    assert!(ruling.racked);
    assert_eq!(scenario.asks(1).hand, Some(Region::BehindHeadString));
    assert_eq!(scenario.0.fouls_in_a_row(), [0, 0]);
    assert_eq!(scenario.0.scores(), [0, -18]);
}

#[test]
fn reaching_the_points_wins() {
    let mut scenario = opened();
    let mut made = 0;
    while !scenario.0.is_over() {
        let ball = scenario.0.layout().on_table().find(|b| *b != 0).expect("the rack is renewed");
        scenario.play(Call::Pocket(ball, CORNER), hit(&[ball]).potting(ball, CORNER));
        made += 1;
    }
    scenario.is_won_by(1);
    assert_eq!((made, scenario.0.scores()), (40, [0, 40]));
}

/// Player 1 pockets the last ball but `break_ball`, which lies at `place`, with the cue ball at
/// `cue`.
fn fourteen_down(break_ball: BallIndex, place: [f64; 2], cue: [f64; 2]) -> Scenario {
    let last = if break_ball == 1 { 2 } else { 1 };
    let others = (1..=15).filter(|b| *b != last && *b != break_ball);
    let mut scenario = opened().without(others);
    scenario.0.put(break_ball, Some(place));
    scenario.0.put(last, Some([0.2, 2.0]));
    scenario.0.put(0, Some(cue));
    let ruling = scenario.play(Call::Pocket(last, CORNER), hit(&[last]).potting(last, CORNER));
    assert!(ruling.racked);
    assert_eq!(scenario.0.layout().on_table().filter(|b| *b != 0).count(), 15);
    scenario.asks(1);
    scenario
}

const FOOT: [f64; 2] = [0.635, 1.905];
const HEAD: [f64; 2] = [0.635, 0.635];
const CENTER: [f64; 2] = [0.635, 1.27];
const IN_RACK: [f64; 2] = [0.635, 2.0];
const FAR: [f64; 2] = [0.3, 1.4];

#[test]
fn fourteen_balls_are_racked_without_the_apex_and_the_other_balls_stay() {
    let scenario = fourteen_down(7, FAR, [0.9, 1.0]);
    let layout = scenario.0.layout();
    assert_eq!(layout.place(7), Some(FAR));
    assert_eq!(layout.place(0), Some([0.9, 1.0]));
    assert!(layout.is_free(0, FOOT), "no ball on the foot spot");
}

#[test]
fn a_ball_that_lies_in_the_rack_of_fourteen_is_moved_by_rule_4_8() {
    // The fifteenth ball in the rack: head spot, foot spot with the cue ball in hand, or center
    // spot.
    assert_eq!(fourteen_down(7, IN_RACK, FAR).0.layout().place(7), Some(HEAD));
    assert_eq!(fourteen_down(7, IN_RACK, HEAD).0.layout().place(7), Some(CENTER));
    let both = fourteen_down(7, [0.635, 1.96], [0.635, 2.05]);
    assert_eq!(both.0.layout().place(7), Some(FOOT));
    assert_eq!(both.turn().hand, Some(Region::BehindHeadString));
    // The cue ball in the rack: in hand, on the head spot, or on the center spot.
    assert_eq!(fourteen_down(7, FAR, IN_RACK).turn().hand, Some(Region::BehindHeadString));
    assert_eq!(fourteen_down(7, [0.3, 0.3], IN_RACK).0.layout().place(0), Some(HEAD));
    let blocking = [HEAD[0], HEAD[1] - 0.01];
    assert_eq!(fourteen_down(7, blocking, IN_RACK).0.layout().place(0), Some(CENTER));
    let on_the_string = fourteen_down(7, HEAD, IN_RACK);
    assert_eq!(on_the_string.turn().hand, Some(Region::BehindHeadString), "not behind it (4.8d)");
}

#[test]
fn with_the_fifteenth_ball_pocketed_too_all_are_racked() {
    let mut scenario = opened().without(3..=15);
    let ruling =
        scenario.play(Call::Pocket(1, CORNER), hit(&[1, 2]).potting(1, CORNER).potting(2, SIDE));
    assert_eq!(ruling.points, [0, 2]);
    assert!(!scenario.0.layout().is_free(0, FOOT), "a ball on the foot spot");
    scenario.asks(1);
}

#[test]
fn a_breaker_repeats_a_bad_break_and_loses_two_points_each_time() {
    let mut scenario = Scenario::of(Game::StraightPool);
    for times in 1..=4 {
        scenario.play(SAFE, hit(&[5]).driving(&[]));
        assert_eq!(scenario.0.scores(), [-2 * times, 0]);
        scenario.choose(Choice::RebreakByOther);
        assert_eq!(scenario.asks(0).hand, Some(Region::BehindHeadString));
    }
    assert!(scenario.play(SAFE, hit(&[5]).driving(&[1, 2])).is_legal());
    scenario.asks(1);
}

#[test]
fn a_player_who_accepts_the_table_after_a_breaking_foul_has_no_opening_requirements() {
    let mut scenario = Scenario::of(Game::StraightPool);
    scenario.play(SAFE, hit(&[5]).driving(&[]));
    scenario.choose(Choice::PlayOn);
    assert!(scenario.play(SAFE, hit(&[5])).is_legal());
    scenario.asks(0);
}

#[test]
fn an_uncalled_pocketed_ball_satisfies_the_rail_requirement() {
    let mut scenario = opened();
    let ruling = scenario.play(Call::Pocket(3, CORNER), hit(&[3]).no_rail().potting(7, SIDE));
    assert!(ruling.is_legal());
    assert_eq!((ruling.points, &ruling.spotted[..]), ([0, 0], &[7][..]));
    scenario.asks(0);
}

#[test]
fn a_legal_shot_resets_the_count_of_consecutive_fouls() {
    let mut scenario = opened();
    for legal in [false, false, true, false, false] {
        let happened = if legal { hit(&[3]) } else { hit(&[3]).no_rail() };
        scenario.play(SAFE, happened);
        scenario.play(SAFE, hit(&[3]));
    }
    assert_eq!((scenario.0.fouls_in_a_row(), scenario.0.scores()), ([0, 2], [0, -4]));
    assert_eq!(scenario.play(SAFE, hit(&[]).no_rail()).points, [0, -16]);
    scenario.asks(1);
}

#[test]
fn after_the_third_foul_the_opening_requirements_apply_again() {
    let mut scenario = opened();
    for _ in 0..2 {
        scenario.play(SAFE, hit(&[3]).no_rail());
        scenario.play(SAFE, hit(&[3]));
    }
    scenario.play(SAFE, hit(&[3]).potting(0, SIDE).potting(5, CORNER));
    assert_eq!(scenario.0.layout().on_table().count(), 16, "all are racked");
    assert_fouls(&scenario.play(SAFE, hit(&[5]).driving(&[1])), &[Foul::SoftBreak]);
    scenario.offers(0, &[Choice::PlayOn, Choice::RebreakByOther]);
}

#[test]
fn balls_off_the_table_are_a_foul_and_are_spotted_even_if_the_called_ball_was_pocketed() {
    let mut scenario = opened();
    let happened = hit(&[3]).potting(3, CORNER).losing(4);
    let ruling = scenario.play(Call::Pocket(3, CORNER), happened);
    assert_fouls(&ruling, &[Foul::BallOffTable]);
    assert_eq!((ruling.points, &ruling.spotted[..]), ([0, -1], &[3, 4][..]));
    assert_eq!(scenario.asks(0).hand, None);
}

#[test]
fn pocketing_the_last_but_one_ball_with_a_foul_does_not_rack() {
    let mut scenario = opened().without(3..=15);
    scenario.0.put(1, Some([0.3, 1.3]));
    scenario.0.put(2, Some([0.9, 1.3]));
    let happened = hit(&[1]).potting(1, CORNER).potting(0, SIDE);
    let ruling = scenario.play(Call::Pocket(1, CORNER), happened);
    assert!(!ruling.racked);
    assert_eq!(ruling.spotted, [1]);
}

#[test]
fn with_both_last_balls_down_a_cue_ball_in_the_rack_is_in_hand() {
    let mut scenario = opened().without(3..=15);
    scenario.0.put(1, Some([0.3, 1.3]));
    scenario.0.put(2, Some([0.9, 1.3]));
    scenario.0.put(0, Some(IN_RACK));
    let happened = hit(&[1, 2]).potting(1, CORNER).potting(2, SIDE);
    let ruling = scenario.play(Call::Pocket(1, CORNER), happened);
    assert_eq!((ruling.points, ruling.racked), ([0, 2], true));
    assert_eq!(scenario.asks(1).hand, Some(Region::BehindHeadString));
    assert!(scenario.play(SAFE, hit(&[5])).is_legal(), "it is not an opening break");
}

#[test]
fn reaching_the_points_wins_in_the_middle_of_a_rack() {
    let options = Options { points: 2, ..Options::default() };
    let mut scenario = Scenario::with(Game::StraightPool, options);
    let happened = hit(&[5]).potting(5, CORNER).potting(6, SIDE);
    scenario.play(Call::Pocket(5, CORNER), happened);
    scenario.is_won_by(0);
}
