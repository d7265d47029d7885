//! Symmetries of mechanics in whole shots, most of them to the last bit: the engine's origin is the
//! table's centre, and none of its formulas prefers a side.

use carom::event::EventKind;
use carom::math::{Vec2, Vec3};
use carom::{BallState, MotionState, Shot};
use proptest::prelude::*;

use crate::owned_event::{OwnedEvent, events};
use crate::plan::{Ground, Plan, any_plan, plan};

/// Whether two events are of the same kind, at any part of the table.
fn same_kind(a: EventKind, b: EventKind) -> bool {
    match (a, b) {
        (EventKind::RailCollision(_), EventKind::RailCollision(_))
        | (EventKind::PocketCollision(_), EventKind::PocketCollision(_)) => true,
        _ => a == b,
    }
}

/// Asserts that `ours` equals `theirs` after `change`, to the bit, with times multiplied by
/// `clock`.
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

/// Mirrors left and right. The spin is an axial vector, so its other components change sign.
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

/// Approach speed below which restitution depends on the speed (`carom::resolve::restitution`),
/// m/s, with a margin for a change by a factor of two.
const GENTLE: f64 = 3.0 * carom::resolve::restitution::FULL;

/// Whether the result of an event may depend on a speed, time or stiffness of its own: a slow
/// contact, a ball that tips over an edge, or several balls at once.
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

/// Largest difference (m, or s) between a shot restarted in its middle and the whole shot over the
/// next [`FOLLOWED`] events: the rounding of a start from a file, amplified tenfold by each
/// contact.
const RESTARTED: f64 = 1e-9;
const FOLLOWED: usize = 5;

/// The state of `plan` at `time`: the balls still in play, and their indices.
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

    /// With doubled speeds and fourfold accelerations the places are the same in half the time.
    /// They agree to the bit, since the factors are powers of two, up to the first contact that is
    /// so slow that its restitution depends on the speed.
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
    fn a_shot_restarted_in_its_middle_continues_like_the_whole_shot(
        plan in any_plan(5), part in 0.05..0.95,
    ) {
        let shot = plan.shot();
        let whole = events(&shot);
        let time = part * whole.last().map_or(0.0, |e| e.time);
        let (rest, balls) = resumed(&plan, &shot, time);
        prop_assume!(!balls.is_empty());
        // A shot file cannot hold a ball that rolls on a rail's top or falls into a hole.
        let on_top = |s: &BallState| s.motion != MotionState::Airborne && s.position.z > 0.04;
        prop_assume!(!rest.balls.iter().any(on_top) && rest.read().is_ok());
        let ours = events(&rest.shot());
        let theirs: Vec<&OwnedEvent> = whole.iter().filter(|e| e.time > time).collect();
        // Events closer to each other than rounding could change their order.
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
    fn the_order_of_the_balls_in_a_file_only_changes_the_order_of_simultaneous_events(
        (plan, order) in any_plan(8).prop_flat_map(|plan| {
            let order: Vec<u16> = (0..plan.balls.len() as u16).collect();
            (Just(plan), Just(order).prop_shuffle())
        })
    ) {
        let shuffled = Plan {
            balls: order.iter().map(|&i| plan.balls[usize::from(i)]).collect(),
            ..plan.clone()
        };
        // Compares with the first order's indices; the balls of an event, and simultaneous events,
        // are sorted.
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
