//! Symmetries of mechanics that whole shots must keep, most of them to the last bit: the engine's
//! origin is the table's centre, and no formula of it prefers a side.

use carom::event::EventKind;
use carom::math::{Vec2, Vec3};
use carom::{BallState, MotionState, Shot};
use proptest::prelude::*;

use crate::owned_event::{OwnedEvent, events};
use crate::plan::{Ground, Plan, any_plan, plan};

/// Events are of one kind wherever they are on the table.
fn same_kind(a: EventKind, b: EventKind) -> bool {
    match (a, b) {
        (EventKind::RailCollision(_), EventKind::RailCollision(_))
        | (EventKind::PocketCollision(_), EventKind::PocketCollision(_)) => true,
        _ => a == b,
    }
}

/// `ours` is what `change` makes of `theirs`, to the bit; times by `clock`.
fn assert_same(
    ours: &[OwnedEvent],
    theirs: &[OwnedEvent],
    change: impl Fn(&BallState) -> BallState,
    clock: f64,
) -> Result<(), TestCaseError> {
    prop_assert_eq!(ours.len(), theirs.len());
    for (k, (a, b)) in ours.iter().zip(theirs).enumerate() {
        prop_assert!(same_kind(a.kind, b.kind), "event {}: {:?}, {:?}", k, a.kind, b.kind);
        prop_assert_eq!(&a.balls, &b.balls, "event {}", k);
        prop_assert_eq!(a.time, b.time * clock, "event {}", k);
        let changed = |states: &[BallState]| states.iter().map(&change).collect::<Vec<_>>();
        prop_assert_eq!(&a.before, &changed(&b.before), "event {} {:?}", k, a.kind);
        prop_assert_eq!(&a.after, &changed(&b.after), "event {} {:?}", k, a.kind);
    }
    Ok(())
}

/// Left for right: of a spin, which is an axial vector, the other components change sign.
fn left_right(s: &BallState) -> BallState {
    let flip = |v: Vec3, side: f64| Vec3::new(-side * v.x, side * v.y, side * v.z);
    BallState {
        position: flip(s.position, 1.0),
        velocity: flip(s.velocity, 1.0),
        angular_velocity: flip(s.angular_velocity, -1.0),
        motion: s.motion,
    }
}

fn quarter_turn(s: &BallState) -> BallState {
    let turn = |v: Vec3| Vec3::new(-v.y, v.x, v.z);
    BallState {
        position: turn(s.position),
        velocity: turn(s.velocity),
        angular_velocity: turn(s.angular_velocity),
        motion: s.motion,
    }
}

fn half_turn(s: &BallState) -> BallState {
    quarter_turn(&quarter_turn(s))
}

/// Approach speed of a contact below which restitution depends on the speed
/// (`carom::resolve::restitution`), m/s, with room for a change by a factor of two.
const GENTLE: f64 = 3.0 * carom::resolve::restitution::FULL;

/// Whether it is a contact in which restitution could depend on the speed, or one with a time or a
/// stiffness of its own: of a ball that tips over an edge, or of several balls at once.
fn gentle(shot: &Shot, event: &OwnedEvent) -> bool {
    match event.kind {
        EventKind::RailCollision(part) => {
            let s = &event.before[0];
            let into = shot.table().normal_at(usize::from(part), s.position.xy());
            s.velocity.xy().dot(into).abs() < GENTLE
        }
        EventKind::BallCollision if event.balls.len() > 2 => true,
        EventKind::BallCollision => {
            let [a, b] = [event.before[0], event.before[1]];
            let along = (b.position - a.position).xy();
            (b.velocity - a.velocity).xy().dot(along).abs() < GENTLE * along.length()
        }
        EventKind::SlateCollision => true,
        EventKind::MotionTransition { to, .. } => to == MotionState::Airborne,
        _ => false,
    }
}

/// Lengths, in m, to which a shot started anew in its middle agrees with the whole one over its
/// next [`FOLLOWED`] events: the rounding of a start from a file, amplified tenfold per contact.
const RESTARTED: f64 = 1e-9;
const FOLLOWED: usize = 5;

/// The shot `plan` as it is at `time`: the balls that are still in play, and which those are.
fn resumed(plan: &Plan, shot: &Shot, time: f64) -> (Plan, Vec<u16>) {
    let center = shot.table().center();
    let states = shot.simulate().expect("it ends").at(time).expect("a time");
    let in_play = || (0_u16..).zip(&states).filter(|(_, s)| s.motion.in_play());
    let moved = |s: &BallState| BallState { position: s.position - center.with_z(0.0), ..*s };
    let balls = in_play().map(|(_, s)| moved(s)).collect();
    (Plan { balls, ..plan.clone() }, in_play().map(|(i, _)| i).collect())
}

proptest! {
    #[test]
    fn a_mirrored_shot_on_a_table_with_pockets_has_mirrored_bits(plan in plan(Ground::Pool, 8)) {
        let (ours, theirs) = (events(&plan.map(left_right).shot()), events(&plan.shot()));
        assert_same(&ours, &theirs, left_right, 1.0)?;
    }

    #[test]
    fn a_shot_turned_half_round_on_a_table_with_pockets_has_the_same_bits_turned(
        plan in plan(Ground::Pool, 8)
    ) {
        let (ours, theirs) = (events(&plan.map(half_turn).shot()), events(&plan.shot()));
        assert_same(&ours, &theirs, half_turn, 1.0)?;
    }

    #[test]
    fn a_shot_turned_a_quarter_round_on_a_square_table_has_the_same_bits_turned(
        plan in plan(Ground::Square, 8)
    ) {
        let (ours, theirs) = (events(&plan.map(quarter_turn).shot()), events(&plan.shot()));
        assert_same(&ours, &theirs, quarter_turn, 1.0)?;
    }

    /// All speeds doubled, gravity and what else makes accelerations fourfold: the same places, in
    /// half the time, to the bit, for these factors are powers of two; up to the first contact so
    /// gentle that restitution depends on its speed.
    #[test]
    fn twice_the_speeds_under_four_times_the_gravity_give_the_same_places(
        plan in any_plan(6), restitution in 0.7..1.0,
    ) {
        let slow = Plan {
            changes: vec![
                ("ball_ball", "restitution", restitution),
                ("ball_ball", "friction", 0.06),
                ("cushion", "restitution", 0.9 * restitution),
                ("cushion", "friction", 0.14),
                ("cloth", "spin_deceleration", 10.0),
            ],
            ..plan
        };
        let twice = |s: &BallState| BallState {
            velocity: s.velocity * 2.0,
            angular_velocity: s.angular_velocity * 2.0,
            ..*s
        };
        let mut fast = slow.map(twice);
        fast.gravity *= 4.0;
        fast.changes.last_mut().expect("spin").2 *= 4.0;
        let shot = slow.shot();
        let (theirs, ours) = (events(&shot), events(&fast.shot()));
        let until = theirs.iter().position(|e| gentle(&shot, e)).unwrap_or(theirs.len());
        prop_assert!(ours.len() >= until);
        assert_same(&ours[..until], &theirs[..until], twice, 0.5)?;
    }

    #[test]
    fn a_shot_started_anew_in_its_middle_goes_on_as_it_would_have(
        plan in any_plan(5), part in 0.05..0.95,
    ) {
        let shot = plan.shot();
        let whole = events(&shot);
        let time = part * whole.last().map_or(0.0, |e| e.time);
        let (rest, balls) = resumed(&plan, &shot, time);
        prop_assume!(!balls.is_empty());
        // A shot file has no ball that rolls on a rail's top, and none that falls into a hole.
        let on_top = |s: &BallState| s.motion != MotionState::Airborne && s.position.z > 0.04;
        prop_assume!(!rest.balls.iter().any(on_top) && rest.read().is_ok());
        let ours = events(&rest.shot());
        let theirs: Vec<&OwnedEvent> = whole.iter().filter(|e| e.time > time).collect();
        // Events closer to each other than their rounding could come in another order.
        let times: Vec<f64> = theirs.iter().map(|e| e.time - time).take(FOLLOWED + 1).collect();
        prop_assume!(times.windows(2).all(|w| w[1] - w[0] > RESTARTED) && times.first().is_none_or(|t| *t > RESTARTED));
        for (a, b) in ours.iter().zip(&theirs).take(FOLLOWED) {
            prop_assert_eq!(a.kind, b.kind, "at {} s", b.time);
            let named: Vec<u16> = a.balls.iter().map(|&i| balls[usize::from(i)]).collect();
            prop_assert_eq!(&named, &b.balls);
            prop_assert!((a.time + time - b.time).abs() < RESTARTED, "{} {}", a.time + time, b.time);
            for (s, t) in a.after.iter().zip(&b.after) {
                let off: Vec2 = (s.position - t.position).xy();
                prop_assert!(off.length() < RESTARTED, "{:?}: {} m", b.kind, off.length());
            }
        }
    }

    #[test]
    fn the_order_in_which_balls_are_listed_decides_the_order_of_ties_and_nothing_else(
        (plan, order) in any_plan(8).prop_flat_map(|plan| {
            let order: Vec<u16> = (0..plan.balls.len() as u16).collect();
            (Just(plan), Just(order).prop_shuffle())
        })
    ) {
        let shuffled = Plan {
            balls: order.iter().map(|&i| plan.balls[usize::from(i)]).collect(),
            ..plan.clone()
        };
        // By the balls' names in the first order; an event's balls, and events of one instant, in
        // ascending order.
        let tied = |a: &OwnedEvent, b: &OwnedEvent| a.time.total_cmp(&b.time).then(a.balls.cmp(&b.balls));
        let (mut ours, mut theirs) = (events(&shuffled.shot()), events(&plan.shot()));
        for event in &mut ours {
            let name = |i: u16| order[usize::from(i)];
            let mut rows: Vec<_> = (0..event.balls.len())
                .map(|k| (name(event.balls[k]), event.before[k], event.after[k]))
                .collect();
            rows.sort_by_key(|row| row.0);
            event.balls = rows.iter().map(|r| r.0).collect();
            event.before = rows.iter().map(|r| r.1).collect();
            event.after = rows.iter().map(|r| r.2).collect();
        }
        ours.sort_by(tied);
        theirs.sort_by(tied);
        assert_same(&ours, &theirs, |s| *s, 1.0)?;
    }
}
