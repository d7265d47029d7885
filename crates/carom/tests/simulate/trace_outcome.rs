//! The outcome holds what a referee asks for, from nothing but the order of events.

use carom::outcome::{Collector, Outcome, Touched};
use carom::table::{Part, PocketName, Rail};
use carom::trace::What;
use carom::{BallState, MotionState};

const HIT: What = What::BallCollision;

const fn nose(rail: Rail) -> What {
    What::RailCollision { rail, part: Part::Nose }
}

fn collected(cue_ball: Option<u16>, events: &[(What, &[u16])]) -> Outcome {
    let mut collector = Collector::new(cue_ball);
    for (what, balls) in events {
        collector.add(*what, balls);
    }
    collector.finish(&[])
}

#[test]
fn the_first_contact_is_the_cue_balls_and_not_the_tables() {
    let outcome = collected(Some(0), &[(HIT, &[3, 4]), (HIT, &[0, 2]), (HIT, &[0, 1])]);
    assert_eq!(outcome.first_contact, Some(2));
    assert_eq!(outcome.cue_ball_touched, [Touched::Ball(2), Touched::Ball(1)]);
}

#[test]
fn a_contact_of_several_balls_touches_each_of_them() {
    let outcome = collected(Some(1), &[(HIT, &[0, 1, 2])]);
    assert_eq!(outcome.first_contact, Some(0));
    assert_eq!(outcome.cue_ball_touched, [Touched::Ball(0), Touched::Ball(2)]);
    let elsewhere = collected(Some(5), &[(HIT, &[0, 1, 2])]);
    assert_eq!(elsewhere.first_contact, None);
}

#[test]
fn rails_count_from_the_first_contact_on() {
    let outcome = collected(
        Some(0),
        &[
            (nose(Rail::Left), &[0]),
            (nose(Rail::Top), &[3]),
            (HIT, &[3, 2]),
            (nose(Rail::Bottom), &[2]),
            (HIT, &[0, 1]),
            (nose(Rail::Right), &[1]),
            (What::RailCollision { rail: Rail::Right, part: Part::Facing }, &[1]),
            (nose(Rail::Top), &[0]),
        ],
    );
    assert_eq!(
        outcome.rails_after_first_contact,
        [(1, Rail::Right), (1, Rail::Right), (0, Rail::Top)]
    );
    assert!(outcome.rails_before_first_contact().eq([Rail::Left]));
    assert_eq!(outcome.driven_to_rail, [0, 3, 2, 1]);
    assert_eq!(
        outcome.cue_ball_touched,
        [Touched::Rail(Rail::Left), Touched::Ball(1), Touched::Rail(Rail::Top)]
    );
}

#[test]
fn without_a_cue_ball_rails_count_from_the_first_collision_of_any_balls() {
    let events: &[(What, &[u16])] =
        &[(nose(Rail::Top), &[0]), (HIT, &[0, 1]), (nose(Rail::Left), &[1])];
    let outcome = collected(None, events);
    assert_eq!(outcome.first_contact, None);
    assert_eq!(outcome.rails_after_first_contact, [(1, Rail::Left)]);
    assert!(outcome.cue_ball_touched.is_empty());
    assert!(!outcome.cue_ball_scratched());
}

#[test]
fn pocketed_balls_stand_in_the_order_of_their_fall_and_a_scratch_is_seen() {
    let events: &[(What, &[u16])] = &[
        (What::CueStrike, &[2]),
        (What::PocketCollision(PocketName::Left), &[4]),
        (What::PocketCollision(PocketName::TopRight), &[2]),
        (What::PocketCollision(PocketName::Left), &[0]),
    ];
    let outcome = collected(Some(2), events);
    let (left, top_right) = (PocketName::Left, PocketName::TopRight);
    assert_eq!(outcome.pocketed, [(4, left), (2, top_right), (0, left)]);
    assert!(outcome.cue_ball_scratched());
    assert!(!collected(Some(3), events).cue_ball_scratched());
    assert_eq!(outcome.events, 4);
}

#[test]
fn only_balls_that_still_move_at_the_end_never_rest() {
    let with = |motion| BallState { motion, ..BallState::default() };
    let last = [
        with(MotionState::Stationary),
        with(MotionState::Rolling),
        with(MotionState::Pocketed),
        with(MotionState::Spinning),
        with(MotionState::OffTable),
    ];
    assert_eq!(Collector::new(None).finish(&last).never_resting, [1, 3]);
}
