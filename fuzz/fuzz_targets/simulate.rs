//! Any shot that passes the checks ends, has finite states and no overlapping balls, and gives the
//! same result twice.
#![no_main]

use arbitrary::Arbitrary;
use carom::format::{Node, SHOT_FORMAT};
use carom::{Shot, table};
use libfuzzer_sys::fuzz_target;

/// Numbers from which a shot is made; most of them make a valid one.
#[derive(Arbitrary, Debug)]
struct ShotNumbers {
    table: u8,
    ideal: bool,
    balls: Vec<(u16, u16, bool)>,
    struck: u8,
    speed: u16,
    azimuth: u16,
    elevation: u8,
    side: i8,
    height: i8,
}

/// Largest overlap of balls at an event, m: the rounding error of positions on a large table.
const OVERLAP: f64 = 1e-12;

fn fraction(x: u16) -> f64 {
    f64::from(x) / f64::from(u16::MAX)
}

fn shot(numbers: &ShotNumbers) -> Option<Shot> {
    let name = table::PRESETS[usize::from(numbers.table) % table::PRESETS.len()];
    let size = carom::Table::preset(name)?.size;
    let mut balls: Vec<Node> = Vec::new();
    let mut last = [0.0, 0.0];
    for (i, &(x, y, frozen)) in numbers.balls.iter().take(22).enumerate() {
        // Frozen to the ball before it, or anywhere.
        let position = if frozen && i > 0 {
            let radius = carom::Physics::preset(&carom::Table::preset(name)?.description?.physics)?.ball.radius;
            let (sin, cos) = carom::math::sin_cos(6.3 * fraction(x));
            [last[0] + 2.0 * radius * cos, last[1] + 2.0 * radius * sin]
        } else {
            [size.x * fraction(x), size.y * fraction(y)]
        };
        last = position;
        balls.push(Node::object([("id", format!("{i}").into()), ("position", position.into())]));
    }
    let struck = usize::from(numbers.struck) % balls.len().max(1);
    let mut file = Node::object([
        ("format", SHOT_FORMAT.into()),
        ("table", name.into()),
        ("balls", Node::List(balls)),
        (
            "strike",
            Node::object([
                ("ball", format!("{struck}").into()),
                ("speed", (0.001 + 12.0 * fraction(numbers.speed)).into()),
                ("azimuth_deg", (360.0 * fraction(numbers.azimuth)).into()),
                ("elevation_deg", (f64::from(numbers.elevation) / 3.0).into()),
                ("side", (f64::from(numbers.side) / 360.0).into()),
                ("height", (f64::from(numbers.height) / 360.0).into()),
            ]),
        ),
    ]);
    if numbers.ideal {
        file.set("physics", "ideal");
    }
    Shot::from_node(&file).ok()
}

fuzz_target!(|numbers: ShotNumbers| {
    let Some(shot) = shot(&numbers) else { return };
    let trace = shot.simulate().unwrap_or_else(|e| panic!("{e}: {}", shot.to_json()));
    for event in trace.events() {
        for state in event.before.iter().chain(event.after) {
            assert!(state.position.is_finite() && state.velocity.is_finite(), "{}", shot.to_json());
            assert!(state.angular_velocity.is_finite(), "{}", shot.to_json());
        }
        let states = trace.at(event.time).expect("a time of the shot");
        for (i, a) in states.iter().enumerate().filter(|(_, a)| a.motion.in_play()) {
            for (j, b) in states[..i].iter().enumerate().filter(|(_, b)| b.motion.in_play()) {
                let apart = (a.position - b.position).length();
                let contact = shot.balls()[i].ball.radius + shot.balls()[j].ball.radius;
                // A file may let balls overlap by a nanometre at the start.
                let placed = shot.balls()[i].state.position - shot.balls()[j].state.position;
                let least = contact.min(placed.length()) - OVERLAP;
                assert!(apart >= least, "{} {}", event.time, shot.to_json());
            }
        }
    }
    let again = shot.simulate().expect("the shot has ended once");
    assert_eq!(trace.first_difference(&again), None, "{}", shot.to_json());
});
