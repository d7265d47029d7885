//! Chinese eight-ball, heyball.

use super::{CORNER, SIDE, Scenario, assert_fouls, hit};
use crate::games::eight_ball::Group;
use crate::{Call, Choice, Foul, Game, Region};

const NOTHING: Call = Call::Nothing;
const EIGHT: u16 = 8;

/// Player 0 has pocketed a ball on the break.
fn broken() -> Scenario {
    let mut scenario = Scenario::of(Game::ChineseEightBall);
    assert_eq!(scenario.asks(0).hand, Some(Region::BehindHeadString));
    assert!(scenario.play(NOTHING, hit(&[1]).potting(1, CORNER)).is_legal());
    scenario
}

/// Player 0 has the solids.
fn solids() -> Scenario {
    let mut scenario = broken();
    scenario.play(NOTHING, hit(&[2]).potting(2, CORNER));
    assert_eq!(scenario.0.group(0), Some(Group::Solids));
    scenario
}

/// Player 0 has only the eight left.
fn on_the_eight() -> Scenario {
    let mut scenario = solids().without(4..=7);
    scenario.play(NOTHING, hit(&[3]).potting(3, SIDE));
    assert_eq!(scenario.asks(0).on, [EIGHT]);
    scenario
}

#[test]
fn nothing_is_called_and_the_table_is_open_after_the_break() {
    let scenario = broken();
    let turn = scenario.asks(0);
    assert_eq!(turn.calls.names().collect::<Vec<_>>(), ["nothing"]);
    assert_eq!((turn.on.len(), scenario.0.group(0)), (13, None), "all but the 1 and the eight");
}

#[test]
fn the_group_of_the_first_ball_hit_is_that_of_the_player_if_one_of_it_falls() {
    let mut scenario = broken();
    // The 9 falls from a combination with the 10.
    scenario.play(NOTHING, hit(&[10]).potting(9, SIDE));
    assert_eq!(
        [0, 1].map(|seat| scenario.0.group(seat)),
        [Some(Group::Stripes), Some(Group::Solids)]
    );
    scenario.asks(0);
}

#[test]
fn the_table_stays_open_if_only_balls_of_the_other_group_fall() {
    let mut scenario = broken();
    assert!(scenario.play(NOTHING, hit(&[2]).potting(9, SIDE)).is_legal());
    assert_eq!(scenario.0.group(0), None);
    scenario.asks(1);
}

#[test]
fn any_ball_of_the_own_group_in_any_pocket_keeps_the_turn() {
    let mut scenario = solids();
    scenario.play(NOTHING, hit(&[3]).potting(7, SIDE).potting(12, CORNER));
    scenario.asks(0);
    scenario.play(NOTHING, hit(&[3]).potting(13, CORNER));
    scenario.asks(1);
}

#[test]
fn the_eight_wins_in_any_pocket_once_the_group_is_cleared() {
    let mut scenario = on_the_eight();
    scenario.play(NOTHING, hit(&[EIGHT]).potting(EIGHT, CORNER));
    scenario.is_won_by(0);
}

#[test]
fn the_eight_loses_early_with_a_foul_and_off_the_table() {
    let mut early = solids();
    early.play(NOTHING, hit(&[3]).potting(EIGHT, CORNER));
    early.is_won_by(1);
    let mut with_the_last = solids().without(4..=7);
    with_the_last.play(NOTHING, hit(&[3]).potting(3, SIDE).potting(EIGHT, CORNER));
    with_the_last.is_won_by(1);
    let mut foul = on_the_eight();
    foul.play(NOTHING, hit(&[EIGHT]).potting(EIGHT, CORNER).potting(0, SIDE));
    foul.is_won_by(1);
    let mut off = on_the_eight();
    off.play(NOTHING, hit(&[EIGHT]).losing(EIGHT));
    off.is_won_by(1);
}

#[test]
fn a_foul_gives_the_cue_ball_in_hand_anywhere_and_names_its_rule() {
    let mut scenario = solids();
    let ruling = scenario.play(NOTHING, hit(&[9]));
    assert_fouls(&ruling, &[Foul::WrongBallFirst]);
    assert_eq!(scenario.asks(1).hand, Some(Region::Anywhere));
    assert_eq!(scenario.0.facts().rule(Foul::NoRailAfterContact), "heyball 12.2");
}

#[test]
fn an_object_ball_off_the_table_is_a_foul_and_stays_down() {
    let mut scenario = solids();
    assert_fouls(&scenario.play(NOTHING, hit(&[3]).losing(12)), &[Foul::BallOffTable]);
    assert!(scenario.is_down(12));
}

#[test]
fn a_foul_on_the_break_gives_the_cue_ball_in_hand_behind_the_head_string_without_a_choice() {
    for happened in [hit(&[1]).potting(0, SIDE).driving(&[1, 2, 3, 4]), hit(&[1]).losing(5)] {
        let mut scenario = Scenario::of(Game::ChineseEightBall);
        scenario.play(NOTHING, happened.potting(2, SIDE));
        assert_eq!(scenario.asks(1).hand, Some(Region::BehindHeadString));
    }
}

#[test]
fn the_head_string_is_450_mm_from_the_bottom_rail() {
    let scenario = Scenario::of(Game::ChineseEightBall);
    let table = scenario.0.base().table();
    assert!(Region::BehindHeadString.holds(table, [0.6, 0.449]));
    assert!(!Region::BehindHeadString.holds(table, [0.6, 0.451]));
}

#[test]
fn a_soft_break_may_be_played_on_or_repeated() {
    let mut scenario = Scenario::of(Game::ChineseEightBall);
    assert_fouls(&scenario.play(NOTHING, hit(&[1]).driving(&[1, 2, 3])), &[Foul::SoftBreak]);
    scenario.offers(1, &[Choice::PlayOn, Choice::Rebreak, Choice::RebreakByOther]);
}

#[test]
fn the_eight_on_the_break_is_spotted_or_the_break_repeated() {
    let mut scenario = Scenario::of(Game::ChineseEightBall);
    scenario.play(NOTHING, hit(&[1]).potting(EIGHT, SIDE));
    scenario.offers(0, &[Choice::SpotEight, Choice::Rebreak]);
    scenario.choose(Choice::SpotEight);
    let [x, y] = scenario.0.layout().place(EIGHT).expect("it is on the table");
    assert!((x - 0.635).abs() < 1e-9 && y >= 1.905, "on the long string behind the foot spot");
    scenario.asks(0);
}

#[test]
fn the_eight_on_a_break_with_a_foul_is_spotted_for_the_opponent_behind_the_head_string() {
    let mut scenario = Scenario::of(Game::ChineseEightBall);
    scenario.play(NOTHING, hit(&[1]).potting(EIGHT, SIDE).potting(0, CORNER));
    scenario.offers(1, &[Choice::SpotEight, Choice::Rebreak]);
    scenario.choose(Choice::SpotEight);
    let turn = scenario.asks(1);
    assert_eq!((turn.hand, turn.on.len()), (Some(Region::BehindHeadString), 14));
}
