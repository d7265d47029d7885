//! Balls that are too large for a pocket, or nearly so.

use core::f64::consts::PI;

use carom::event::EventKind;
use carom::math::sin_cos;
use carom::{MotionState, Shot};
use carom_check::CheckRecorder;
use carom_check::random::Random;

use crate::owned_event::{OwnedEvent, events};

/// Largest allowed number of events; shots like these once reached the cap of 100 000.
const MOST_EVENTS: u64 = 40_000;

/// Distance of the aimed ball from the corner along both axes, m.
const AWAY: f64 = 0.5;

/// A ball of the density of a pool ball.
fn ball(id: &str, radius: f64, position: [f64; 3], rest: &str) -> String {
    let mass = 7286.0 * radius * radius * radius;
    format!(
        r#"{{"id": "{id}", "position": {position:?}, "radius": {radius:?}, "mass": {mass:?}{rest}}}"#
    )
}

fn shot(table: &str, balls: &[String], strike: &str) -> Shot {
    let balls = balls.join(", ");
    let file =
        format!(r#"{{"format": "carom-shot/1", "table": {table}, "balls": [{balls}]{strike}}}"#);
    Shot::from_json(&file).unwrap_or_else(|e| panic!("{e}\n{file}"))
}

/// A ball struck towards the bottom left corner.
fn into_the_corner(table: &str, radius: f64, speed: f64, azimuth_deg: f64) -> Shot {
    let cue = ball("cue", radius, [AWAY, AWAY, radius], "");
    let strike = format!(
        r#", "strike": {{"ball": "cue", "speed": {speed:?}, "azimuth_deg": {azimuth_deg:?},
            "elevation_deg": 0}}"#
    );
    shot(table, &[cue], &strike)
}

/// A ball that flies towards the bottom left corner.
fn flight(id: &str, radius: f64, random: &mut Random) -> String {
    let (far, speed) = (random.between(0.08, 0.25), random.between(0.3, 3.0));
    let (sin, cos) = sin_cos(1.25 * PI + random.between(-0.07, 0.07));
    let (x, y) = (speed * cos, speed * sin);
    let (z, rise) = (radius + random.between(0.001, 0.15), random.between(0.0, 2.0));
    let spin: [f64; 3] = core::array::from_fn(|_| random.between(-30.0, 30.0));
    let motion = format!(r#", "velocity": [{x:?}, {y:?}, {rise:?}], "angular_velocity": {spin:?}"#);
    ball(id, radius, [far, far, z], &motion)
}

/// Checks the shot, and returns whether a ball jammed.
fn ends_without_fault(shot: &Shot, name: &str) -> bool {
    let checker = CheckRecorder::run(shot);
    assert!(checker.faults.is_empty(), "{name}: {:#?}", checker.faults);
    assert!(checker.events < MOST_EVENTS, "{name}: {} events", checker.events);
    // A ball jams at a contact; one that flies across the border touches nothing at that time.
    let all = events(shot);
    let jams = |pair: &[OwnedEvent]| {
        let flies = pair[1].before[0].motion == MotionState::Airborne;
        pair[1].kind == EventKind::OffTable && flies && pair[0].time == pair[1].time
    };
    all.windows(2).any(jams)
}

/// Seen: a ball of 47 to 54 mm in a corner of `wpa-9ft`, or of 42 to 52 mm in one of a snooker or
/// English table, climbed between the facings and met them until the cap on events. Expected: it
/// comes to rest there. Cause: facings that converge carry a ball whose radius is larger than half
/// their distance; with the lip, or with its least speed of separation, it bounces there for ever.
#[test]
fn a_ball_too_fat_for_its_pocket_jams_and_comes_to_rest() {
    for (table, fattest) in [("wpa-9ft", 60), ("english-7ft", 51), ("snooker-12ft", 53)] {
        let mut jams = 0;
        for radius in (40..=fattest).map(|mm| 1e-3 * f64::from(mm)) {
            for speed in [0.5, 1.0, 2.0, 4.0, 8.0] {
                for azimuth in [224.0, 225.3, 226.2] {
                    let name = format!("{table}, R = {radius}, {speed} m/s at {azimuth}°");
                    let shot = into_the_corner(&format!("{table:?}"), radius, speed, azimuth);
                    jams += u32::from(ends_without_fault(&shot, &name));
                }
            }
        }
        assert!(jams > 3, "{table}: {jams} jams");
    }
}

/// The kin: balls of usual size in corners hardly wider than they are jam between the lip and the
/// facings; noses of all heights, and flights that come down on the facings.
#[test]
fn balls_that_hardly_fit_into_a_pocket_come_to_rest() {
    let mut random = Random::new(1);
    let mut jams = 0;
    for mouth in [0.060, 0.063, 0.066, 0.070, 0.073, 0.076, 0.080, 0.090] {
        for nose in [0.030, 0.0363, 0.044] {
            let side = mouth + 0.01;
            let table = format!(
                r#"{{"base": "wpa-9ft", "corner_pocket": {{"mouth": {mouth:?}}},
                    "side_pocket": {{"mouth": {side:?}}}, "cushion_height": {nose:?}}}"#
            );
            for radius in [0.024, 0.02625, 0.028575, 0.0305, 0.034] {
                let name = format!("mouth {mouth}, nose {nose}, R = {radius}");
                for _ in 0..3 {
                    let (speed, azimuth) = (random.between(0.3, 6.0), random.between(222.0, 228.0));
                    let rolled = into_the_corner(&table, radius, speed, azimuth);
                    let flown = shot(&table, &[flight("cue", radius, &mut random)], "");
                    jams += u32::from(ends_without_fault(&rolled, &name));
                    jams += u32::from(ends_without_fault(&flown, &name));
                }
            }
        }
    }
    assert!(jams > 3, "{jams} jams");
}

/// The kin: two balls of different radii in one corner, one of them in the air.
#[test]
fn two_balls_of_different_radii_come_to_rest_in_one_corner() {
    let mut random = Random::new(2);
    let mut jams = 0;
    for _ in 0..600 {
        let table = ["wpa-9ft", "english-7ft", "snooker-12ft"][random.below(3)];
        let (first, second) = (random.between(0.02, 0.05), random.between(0.02, 0.05));
        let speed = random.between(0.3, 4.0);
        let (sin, cos) = sin_cos(1.25 * PI + random.between(-0.05, 0.05));
        let motion = format!(r#", "velocity": [{:?}, {:?}, 0.0]"#, speed * cos, speed * sin);
        let rolled = ball("a", first, [AWAY, AWAY, first], &motion);
        let balls = [rolled, flight("b", second, &mut random)];
        let shot = shot(&format!("{table:?}"), &balls, "");
        jams += u32::from(ends_without_fault(&shot, &{
            let n = format!("{table}, R = {first}, {second}");
            if first > 0.0408006 && first < 0.0408007 {
                eprintln!("SHOT {balls:?}");
            }
            n
        }));
    }
    assert!(jams > 3, "{jams} jams");
}

/// In the corners of Russian pyramid, 73 mm for balls of 68 mm, no ball jams.
#[test]
fn a_pyramid_ball_does_not_jam_in_a_corner_of_73_mm() {
    for nose in [0.030, 0.0363, 0.040] {
        let table = format!(
            r#"{{"base": "wpa-9ft", "corner_pocket": {{"mouth": 0.073}}, "cushion_height": {nose:?}}}"#
        );
        for speed in [0.5, 1.0, 2.0, 4.0, 8.0] {
            for azimuth in [222.0, 224.0, 224.9, 225.3, 226.2] {
                let shot = into_the_corner(&table, 0.034, speed, azimuth);
                let name = format!("nose {nose}, {speed} m/s at {azimuth}°");
                assert!(!ends_without_fault(&shot, &name), "{name}");
            }
        }
    }
}
