//! Eight-ball (WPA, section 3).

use super::{CORNER, SIDE, Scenario, assert_fouls, hit};
use crate::games::eight_ball::Group;
use crate::{Call, Choice, Foul, Game, Region, Seat};

/// After a break that pocketed the 3: player 0 shoots again, and the table is open.
fn open_table() -> Scenario {
    let mut scenario = Scenario::of(Game::EightBall);
    let ruling = scenario.play(Call::Nothing, hit(&[1]).potting(3, CORNER));
    assert!(ruling.is_legal());
    assert_eq!(scenario.asks(0).hand, None);
    assert_eq!(group(&scenario, 0), None, "a break decides no group (3.3c)");
    scenario
}

/// Player 0 has the solids and shoots again.
fn solids() -> Scenario {
    let mut scenario = open_table();
    scenario.play(Call::Pocket(1, CORNER), hit(&[1]).potting(1, CORNER));
    assert_eq!(group(&scenario, 0), Some(Group::Solids));
    assert_eq!(group(&scenario, 1), Some(Group::Stripes));
    assert_eq!(group(&scenario, 2), None, "there is no third seat");
    scenario
}

fn group(scenario: &Scenario, seat: Seat) -> Option<Group> {
    scenario.0.group(seat)
}

#[test]
fn the_break_is_from_behind_the_head_string_without_a_call() {
    let scenario = Scenario::of(Game::EightBall);
    let turn = scenario.asks(0);
    assert_eq!(turn.hand, Some(Region::BehindHeadString));
    assert!(!turn.calls.pocket && !turn.calls.required);
}

#[test]
fn a_break_without_a_pocketed_ball_needs_four_balls_to_a_rail() {
    let mut scenario = Scenario::of(Game::EightBall);
    let ruling = scenario.play(Call::Nothing, hit(&[1]).driving(&[1, 2, 3]));
    assert_fouls(&ruling, &[Foul::SoftBreak]);
    scenario.offers(1, &[Choice::PlayOn, Choice::Rebreak, Choice::RebreakByOther]);

    let mut scenario = Scenario::of(Game::EightBall);
    assert!(scenario.play(Call::Nothing, hit(&[1]).driving(&[1, 2, 3, 4])).is_legal());
    scenario.asks(1);
}

#[test]
fn after_a_soft_break_the_other_player_may_choose_who_breaks_again() {
    for (choice, breaker) in [(Choice::Rebreak, 1), (Choice::RebreakByOther, 0)] {
        let mut scenario = Scenario::of(Game::EightBall);
        scenario.play(Call::Nothing, hit(&[1]).driving(&[1]));
        assert!(scenario.choose(choice).racked);
        assert_eq!(scenario.asks(breaker).hand, Some(Region::BehindHeadString));
    }
    let mut scenario = Scenario::of(Game::EightBall);
    scenario.play(Call::Nothing, hit(&[1]).driving(&[1]));
    scenario.choose(Choice::PlayOn);
    assert_eq!(scenario.asks(1).hand, None);
}

#[test]
fn after_the_eight_on_the_break_the_breaker_chooses_to_spot_it_or_to_break_again() {
    let mut scenario = Scenario::of(Game::EightBall);
    assert!(scenario.play(Call::Nothing, hit(&[1]).potting(8, SIDE)).is_legal());
    scenario.offers(0, &[Choice::SpotEight, Choice::Rebreak]);
    assert!(scenario.0.keeps_turn(0) && !scenario.0.keeps_turn(1));
    assert_eq!(scenario.choose(Choice::SpotEight).spotted, [8]);
    assert!(!scenario.is_down(8));
    assert_eq!(scenario.asks(0).hand, None);
}

#[test]
fn after_the_eight_and_a_scratch_on_the_break_the_other_player_chooses() {
    let mut scenario = Scenario::of(Game::EightBall);
    let ruling = scenario.play(Call::Nothing, hit(&[1]).potting(8, SIDE).potting(0, CORNER));
    assert_fouls(&ruling, &[Foul::Scratch]);
    scenario.offers(1, &[Choice::SpotEight, Choice::Rebreak]);
    scenario.choose(Choice::SpotEight);
    assert_eq!(scenario.asks(1).hand, Some(Region::BehindHeadString));
}

#[test]
fn after_a_scratch_on_the_break_the_other_player_shoots_from_hand_without_a_choice() {
    let mut scenario = Scenario::of(Game::EightBall);
    scenario.play(Call::Nothing, hit(&[1]).potting(3, SIDE).potting(0, CORNER));
    assert_eq!(scenario.asks(1).hand, Some(Region::BehindHeadString));
    assert!(scenario.is_down(3), "a pocketed ball stays down");
}

#[test]
fn a_ball_off_the_table_on_the_break_stays_off_and_the_eight_is_spotted() {
    let mut scenario = Scenario::of(Game::EightBall);
    let ruling = scenario.play(Call::Nothing, hit(&[1]).losing(5).losing(8).driving(&[1, 2]));
    assert_fouls(&ruling, &[Foul::BallOffTable]);
    assert_eq!(ruling.spotted, [8]);
    assert!(scenario.is_down(5) && !scenario.is_down(8));
    scenario.offers(1, &[Choice::PlayOn, Choice::PlayFromHand]);
}

#[test]
fn the_table_stays_open_until_a_called_ball_is_pocketed() {
    let mut scenario = open_table();
    scenario.play(Call::Pocket(9, CORNER), hit(&[9]).potting(4, SIDE));
    assert_eq!(group(&scenario, 0), None);
    scenario.asks(1);
    scenario.play(Call::Pocket(9, CORNER), hit(&[9]).potting(9, CORNER));
    assert_eq!(group(&scenario, 1), Some(Group::Stripes));
    scenario.asks(1);
}

#[test]
fn on_an_open_table_any_ball_but_the_eight_may_be_hit_first() {
    for first in [1, 9] {
        let mut scenario = open_table();
        assert!(scenario.play(Call::Pocket(9, CORNER), hit(&[first, 9])).is_legal());
    }
    let mut scenario = open_table();
    let ruling = scenario.play(Call::Pocket(9, CORNER), hit(&[8, 9]).potting(9, CORNER));
    assert_fouls(&ruling, &[Foul::WrongBallFirst]);
    assert_eq!(group(&scenario, 0), None, "a foul decides no group");
    assert_eq!(scenario.asks(1).hand, Some(Region::Anywhere));
}

#[test]
fn on_an_open_table_a_cleared_group_may_be_claimed_by_calling_the_eight() {
    let claiming = || {
        let mut scenario = open_table().without([1, 2, 4, 5, 6, 7]);
        scenario.play(Call::Safety, hit(&[9]));
        assert!(scenario.asks(1).on.contains(&8));
        scenario
    };
    let mut scenario = claiming();
    scenario.play(Call::Pocket(8, SIDE), hit(&[8]).potting(8, SIDE));
    scenario.is_won_by(1);
    let mut scenario = claiming();
    scenario.play(Call::Pocket(9, SIDE), hit(&[8]).potting(8, SIDE));
    scenario.is_won_by(0);
}

#[test]
fn a_player_who_claims_a_cleared_group_must_hit_the_eight_first_and_others_must_not() {
    let open = || {
        let mut scenario = open_table().without([1, 2, 4, 5, 6, 7]);
        scenario.play(Call::Safety, hit(&[9]));
        scenario
    };
    let mut scenario = open();
    let ruling = scenario.play(Call::Pocket(8, SIDE), hit(&[9, 8]).potting(8, SIDE));
    assert_fouls(&ruling, &[Foul::WrongBallFirst]);
    scenario.is_won_by(0);
    let mut scenario = open();
    let ruling = scenario.play(Call::Pocket(9, SIDE), hit(&[8, 9]).potting(9, SIDE));
    assert_fouls(&ruling, &[Foul::WrongBallFirst]);
    assert_eq!(group(&scenario, 1), None);
    for first in [8, 9] {
        assert!(open().play(Call::Safety, hit(&[first])).is_legal());
    }
    let mut scenario = open_table().without((1..=15).filter(|ball| *ball != 8));
    scenario.play(Call::Safety, hit(&[8]));
    assert_eq!(scenario.asks(1).on, [8], "the only ball left");
    scenario.play(Call::Pocket(8, SIDE), hit(&[8]).potting(8, SIDE));
    scenario.is_won_by(1);
}

#[test]
fn the_called_ball_decides_when_balls_of_both_groups_are_pocketed() {
    let mut scenario = open_table();
    let happened = hit(&[1, 9]).potting(1, SIDE).potting(9, CORNER);
    scenario.play(Call::Pocket(9, CORNER), happened);
    assert_eq!(group(&scenario, 0), Some(Group::Stripes));
    scenario.asks(0);
}

#[test]
fn a_safety_on_an_open_table_decides_no_group() {
    let mut scenario = open_table();
    scenario.play(Call::Safety, hit(&[1]).potting(1, SIDE));
    assert_eq!(group(&scenario, 0), None);
    scenario.asks(1);
}

#[test]
fn a_group_cleared_by_the_other_player_counts_as_cleared() {
    let mut scenario = solids().without([10, 11, 12, 13, 14, 15]);
    scenario.play(Call::Pocket(2, SIDE), hit(&[2, 9]).potting(9, CORNER));
    assert_eq!(scenario.asks(1).on, [8]);
    scenario.play(Call::Pocket(8, SIDE), hit(&[8]).potting(8, SIDE));
    scenario.is_won_by(1);
}

#[test]
fn pocketing_the_eight_on_a_safety_loses() {
    let mut scenario = on_the_eight();
    scenario.play(Call::Safety, hit(&[8]).potting(8, SIDE));
    scenario.is_won_by(1);
    let mut scenario = open_table();
    scenario.play(Call::Pocket(8, SIDE), hit(&[9, 8]).potting(8, SIDE));
    scenario.is_won_by(1);
}

#[test]
fn hitting_another_ball_before_the_eight_is_a_foul() {
    let mut scenario = on_the_eight();
    let ruling = scenario.play(Call::Pocket(8, SIDE), hit(&[9, 8]).potting(8, SIDE));
    assert_fouls(&ruling, &[Foul::WrongBallFirst]);
    scenario.is_won_by(1);
}

#[test]
fn balls_of_the_own_group_driven_off_the_table_count_as_pocketed() {
    let mut scenario = solids().without([2, 4, 5, 6]);
    let ruling = scenario.play(Call::Pocket(7, CORNER), hit(&[7]).losing(7));
    assert_fouls(&ruling, &[Foul::BallOffTable]);
    assert_eq!(scenario.asks(1).hand, Some(Region::Anywhere));
    scenario.play(Call::Safety, hit(&[9]));
    assert_eq!(scenario.asks(0).on, [8]);
}

#[test]
fn a_player_who_breaks_again_has_the_choices_of_a_breaker() {
    let mut scenario = Scenario::of(Game::EightBall);
    scenario.play(Call::Nothing, hit(&[1]).driving(&[1]));
    scenario.choose(Choice::Rebreak);
    scenario.play(Call::Nothing, hit(&[1]).potting(8, SIDE));
    scenario.offers(1, &[Choice::SpotEight, Choice::Rebreak]);
    scenario.choose(Choice::SpotEight);
    assert_eq!(scenario.asks(1).hand, None);
}

#[test]
fn after_a_foul_on_the_break_the_table_may_be_played_as_it_lies() {
    let mut scenario = Scenario::of(Game::EightBall);
    scenario.play(Call::Nothing, hit(&[1]).potting(3, SIDE).losing(4));
    scenario.choose(Choice::PlayOn);
    assert_eq!(scenario.asks(1).hand, None);
    assert!(scenario.turn().calls.required && group(&scenario, 1).is_none());
}

#[test]
fn the_head_string_restricts_only_the_first_shot_after_the_break() {
    let mut scenario = solids();
    scenario.play(Call::Safety, hit(&[2]).potting(0, CORNER));
    assert_eq!(scenario.asks(1).hand, Some(Region::Anywhere));
    scenario.0.put(9, Some([0.3, 0.3]));
    assert!(scenario.play(Call::Safety, hit(&[9]).staying_below(0.4)).is_legal());
}

#[test]
fn a_soft_break_with_another_foul_offers_a_new_break_or_the_cue_ball_in_hand() {
    let mut scenario = Scenario::of(Game::EightBall);
    let ruling = scenario.play(Call::Nothing, hit(&[1]).driving(&[1]).potting(0, CORNER));
    assert_fouls(&ruling, &[Foul::Scratch, Foul::SoftBreak]);
    scenario.offers(1, &[Choice::PlayFromHand, Choice::Rebreak, Choice::RebreakByOther]);

    let mut scenario = Scenario::of(Game::EightBall);
    let ruling = scenario.play(Call::Nothing, hit(&[]).no_rail());
    assert_fouls(&ruling, &[Foul::NoContact, Foul::SoftBreak]);
    let all = [Choice::PlayOn, Choice::PlayFromHand, Choice::Rebreak, Choice::RebreakByOther];
    scenario.offers(1, &all);
}

#[test]
fn balls_off_the_table_count_as_driven_to_a_rail() {
    let mut scenario = Scenario::of(Game::EightBall);
    let ruling = scenario.play(Call::Nothing, hit(&[1]).driving(&[1, 2, 3]).losing(4));
    assert_fouls(&ruling, &[Foul::BallOffTable]);
}

#[test]
fn after_the_eight_on_a_break_with_a_foul_the_cue_ball_is_in_hand() {
    let mut scenario = Scenario::of(Game::EightBall);
    let ruling = scenario.play(Call::Nothing, hit(&[1]).potting(8, SIDE).losing(4));
    assert_fouls(&ruling, &[Foul::BallOffTable]);
    let mut racked = Scenario(scenario.0.clone());
    assert_eq!(scenario.choose(Choice::SpotEight).spotted, [8]);
    assert_eq!(scenario.asks(1).hand, Some(Region::BehindHeadString));
    assert!(racked.choose(Choice::Rebreak).racked);
    racked.asks(1);
}

#[test]
fn a_scratch_after_contact_is_not_also_a_foul_for_missing_rails() {
    let mut scenario = solids();
    let ruling = scenario.play(Call::Pocket(2, CORNER), hit(&[2]).no_rail().potting(0, SIDE));
    assert_fouls(&ruling, &[Foul::Scratch]);
}

#[test]
fn a_called_ball_of_the_other_group_ends_the_turn() {
    let mut scenario = solids();
    assert!(scenario.play(Call::Pocket(9, SIDE), hit(&[2, 9]).potting(9, SIDE)).is_legal());
    scenario.asks(1);
    assert!(scenario.is_down(9));
}

#[test]
fn pocketing_the_eight_with_the_last_ball_of_the_group_loses() {
    let mut scenario = solids().without([2, 4, 5, 6]);
    scenario.play(Call::Pocket(7, CORNER), hit(&[7]).potting(7, CORNER).potting(8, SIDE));
    scenario.is_won_by(1);
}

#[test]
fn consecutive_fouls_do_not_count_in_eight_ball() {
    let mut scenario = solids();
    for _ in 0..4 {
        scenario.play(Call::Safety, hit(&[]));
        scenario.play(Call::Safety, hit(&[9]));
    }
    assert_eq!(scenario.0.fouls_in_a_row(), [0, 0]);
}

#[test]
fn with_all_legal_balls_behind_the_head_string_the_nearest_may_be_spotted() {
    let mut scenario =
        Scenario::of(Game::EightBall).without((1..=15).filter(|b| ![3, 8, 9].contains(b)));
    scenario.0.put(3, Some([0.3, 0.3]));
    scenario.0.put(9, Some([0.9, 0.4]));
    scenario.play(Call::Nothing, hit(&[3]).driving(&[1, 2, 4, 5]).potting(0, CORNER));
    scenario.offers(1, &[Choice::PlayFromHand, Choice::SpotNearest]);
    assert_eq!(scenario.choose(Choice::SpotNearest).spotted, [9]);
    assert_eq!(scenario.asks(1).hand, Some(Region::BehindHeadString));
    assert_eq!(scenario.0.layout().place(3), Some([0.3, 0.3]));
}

#[test]
fn a_shot_must_be_called() {
    let scenario = open_table();
    assert!(scenario.turn().calls.required);
}

#[test]
fn a_ball_in_an_uncalled_pocket_ends_the_turn_without_a_foul() {
    let mut scenario = solids();
    let ruling = scenario.play(Call::Pocket(2, CORNER), hit(&[2]).potting(2, SIDE));
    assert!(ruling.is_legal());
    scenario.asks(1);
    assert!(scenario.is_down(2), "only the eight is ever spotted (3.7)");
}

#[test]
fn after_a_called_safety_the_other_player_shoots_even_if_a_ball_was_pocketed() {
    let mut scenario = solids();
    scenario.play(Call::Safety, hit(&[2]).potting(2, CORNER));
    scenario.asks(1);
}

#[test]
fn hitting_the_other_group_first_gives_ball_in_hand_anywhere() {
    let mut scenario = solids();
    let ruling = scenario.play(Call::Pocket(2, CORNER), hit(&[9, 2]).potting(2, CORNER));
    assert_fouls(&ruling, &[Foul::WrongBallFirst]);
    assert_eq!(scenario.asks(1).hand, Some(Region::Anywhere));
}

#[test]
fn without_a_rail_or_a_pocketed_ball_a_shot_is_a_foul() {
    let mut scenario = solids();
    let ruling = scenario.play(Call::Pocket(2, CORNER), hit(&[2]).no_rail());
    assert_fouls(&ruling, &[Foul::NoRailAfterContact]);
    let mut scenario = solids();
    assert!(
        scenario.play(Call::Pocket(2, CORNER), hit(&[2]).no_rail().potting(2, CORNER)).is_legal()
    );
    let mut scenario = solids();
    assert_fouls(&scenario.play(Call::Pocket(2, CORNER), hit(&[])), &[Foul::NoContact]);
}

/// Player 0 has the eight on.
fn on_the_eight() -> Scenario {
    let mut scenario = solids().without([2, 4, 5, 6]);
    scenario.play(Call::Pocket(7, CORNER), hit(&[7]).potting(7, CORNER));
    assert_eq!(scenario.asks(0).on, [8]);
    scenario
}

#[test]
fn the_called_eight_wins() {
    let mut scenario = on_the_eight();
    scenario.play(Call::Pocket(8, SIDE), hit(&[8]).potting(8, SIDE));
    scenario.is_won_by(0);
}

#[test]
fn a_player_who_pockets_the_eight_with_a_foul_uncalled_or_too_early_or_drives_it_off_loses() {
    let mut scenario = on_the_eight();
    scenario.play(Call::Pocket(8, SIDE), hit(&[8]).potting(8, SIDE).potting(0, CORNER));
    scenario.is_won_by(1);
    let mut scenario = on_the_eight();
    scenario.play(Call::Pocket(8, SIDE), hit(&[8]).potting(8, CORNER));
    scenario.is_won_by(1);
    let mut scenario = solids();
    scenario.play(Call::Pocket(8, SIDE), hit(&[2, 8]).potting(8, SIDE));
    scenario.is_won_by(1);
    let mut scenario = on_the_eight();
    scenario.play(Call::Pocket(8, SIDE), hit(&[8]).losing(8));
    scenario.is_won_by(1);
}

#[test]
fn a_foul_without_the_eight_does_not_lose_the_rack() {
    let mut scenario = on_the_eight();
    scenario.play(Call::Pocket(8, SIDE), hit(&[8]).potting(0, CORNER));
    assert_eq!(scenario.asks(1).hand, Some(Region::Anywhere));
}

#[test]
fn from_behind_the_head_string_a_ball_behind_it_must_not_be_hit_directly() {
    let mut scenario = Scenario::of(Game::EightBall);
    scenario.play(Call::Nothing, hit(&[1]).potting(3, SIDE).potting(0, CORNER));
    scenario.0.put(9, Some([0.3, 0.3]));
    let ruling = scenario.play(Call::Pocket(9, SIDE), hit(&[9]).reaching(0.4));
    assert_fouls(&ruling, &[Foul::BehindHeadString]);

    let mut scenario = Scenario::of(Game::EightBall);
    scenario.play(Call::Nothing, hit(&[1]).potting(3, SIDE).potting(0, CORNER));
    scenario.0.put(9, Some([0.3, 0.3]));
    assert!(scenario.play(Call::Pocket(9, SIDE), hit(&[9]).reaching(1.2)).is_legal());
}

#[test]
fn from_behind_the_head_string_the_cue_ball_must_cross_it_or_hit_a_ball_beyond_it() {
    let from_hand = || {
        let mut scenario = Scenario::of(Game::EightBall);
        scenario.play(Call::Nothing, hit(&[1]).potting(3, SIDE).potting(0, CORNER));
        scenario
    };
    let ruling = from_hand().play(Call::Safety, hit(&[]).staying_below(0.6));
    assert_fouls(&ruling, &[Foul::NoContact, Foul::BehindHeadString]);
    assert!(from_hand().play(Call::Safety, hit(&[9]).staying_below(0.6)).is_legal());
}
