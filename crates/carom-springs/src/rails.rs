//! Random balls that touch a rail and are hit by a ball.

use serde_json::{Value, json};

use crate::clusters::{USUAL, ball_law, spring_models};
use crate::random::Draws;
use crate::strikes::{AREA, nose_distance};

/// The shot file of case `seed`: a ball touches the left rail, another one hits it, and perhaps more
/// balls touch the first one.
pub fn shot_file(seed: u64) -> String {
    let random = &mut Draws::new(seed);
    let (mass, radius) = USUAL;
    let (reach, nose) = (2.0 * radius, nose_distance(radius));
    let frozen = [nose, 0.72 * AREA[1]];
    let mut places = vec![frozen];
    let mut moving = None;
    let count = 1 + random.below(3);
    for _ in 0..200 {
        if places.len() > count {
            break;
        }
        let (sin, cos) = random.between(-1.57, 1.57).sin_cos();
        let place = [frozen[0] + reach * cos, frozen[1] + reach * sin];
        let is_free = places[1..]
            .iter()
            .all(|p: &[f64; 2]| (p[0] - place[0]).hypot(p[1] - place[1]) - reach > 2e-3);
        let distance = place[0] - nose;
        if is_free && distance > 2e-3 {
            moving.get_or_insert((places.len(), [-cos, -sin]));
            places.push(place);
        }
    }
    let (mover, [x, y]) = moving.expect("there is room for one ball");
    let speed = random.log_between(0.5, 10.0);
    let (sin, cos) = random.between(-1.0, 1.0).sin_cos();
    let velocity = [speed * (x * cos - y * sin), speed * (x * sin + y * cos), 0.0];
    let spin = random.vector(speed / radius);
    let balls: Vec<Value> = places
        .iter()
        .enumerate()
        .map(|(k, at)| {
            let mut ball = json!({"id": k.to_string(), "position": at});
            if k == mover {
                ball["velocity"] = json!(velocity);
                ball["angular_velocity"] = json!(spin.as_slice());
            }
            ball
        })
        .collect();
    let file = json!({
        "format": "carom-shot/1",
        "table": "wpa-9ft",
        "physics": {
            "base": "pool",
            "ball": {"mass": mass, "radius": radius},
            "ball_ball": ball_law(random.choice(&spring_models()), random),
        },
        "balls": balls,
    });
    file.to_string()
}
