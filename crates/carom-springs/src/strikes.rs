//! Random strikes of a cue ball that touches other balls, and perhaps a rail.

use serde_json::{Value, json};

use crate::clusters::{USUAL, ball_law, spring_models};
use crate::random::Draws;

/// The playing area of the table `wpa-9ft`, nose to nose, m: 50 in by 100 in.
pub(crate) const AREA: [f64; 2] = [50.0 * 0.0254, 100.0 * 0.0254];
/// Height of its nose: 63.5 % of a ball's diameter (WPA).
pub(crate) const NOSE: f64 = 0.635 * 2.25 * 0.0254;
/// The miscue limit of the preset `pool`, with a margin, ball radii.
const OFFSET: f64 = 0.5;
/// The most balls that touch the cue ball.
const MOST: usize = 5;

/// Distance from the nose line to the centre of a ball that touches the nose, m.
pub(crate) fn nose_distance(radius: f64) -> f64 {
    (radius * radius - (NOSE - radius) * (NOSE - radius)).sqrt()
}

/// The shot file of strike `seed`.
pub fn shot_file(seed: u64) -> String {
    let random = &mut Draws::new(seed);
    let at_rail = random.chance(0.3);
    let x = if at_rail { nose_distance(USUAL.1) } else { 0.5 * AREA[0] };
    // In the upper half of the long rail, far from the pockets.
    let cue_ball = [x, 0.72 * AREA[1]];
    let mut places = vec![cue_ball];
    let count = random.below(MOST + 1);
    for _ in 0..200 {
        if places.len() > count {
            break;
        }
        let (sin, cos) = random.between(0.0, std::f64::consts::TAU).sin_cos();
        let reach = 2.0 * USUAL.1;
        let place = [cue_ball[0] + reach * cos, cue_ball[1] + reach * sin];
        let is_free = places[1..].iter().all(|p| {
            let apart = (p[0] - place[0]).hypot(p[1] - place[1]) - reach;
            apart > 2e-3
        });
        if is_free && place[0] > nose_distance(USUAL.1) + 2e-3 {
            places.push(place);
        }
    }
    let balls: Vec<Value> = places
        .iter()
        .enumerate()
        .map(|(k, at)| json!({"id": k.to_string(), "position": at}))
        .collect();
    let (sin, cos) = random.between(0.0, std::f64::consts::TAU).sin_cos();
    let offset = OFFSET * random.unit().sqrt();
    let file = json!({
        "format": "carom-shot/1",
        "table": "wpa-9ft",
        "physics": {
            "base": "pool",
            "ball": {"mass": USUAL.0, "radius": USUAL.1},
            "ball_ball": ball_law(random.choice(&spring_models()), random),
        },
        "balls": balls,
        "strike": {
            "ball": "0",
            "speed": random.log_between(0.5, 10.0),
            "azimuth_deg": random.between(0.0, 360.0),
            "elevation_deg": if random.chance(0.3) { 0.0 } else { random.between(0.0, 75.0) },
            "side": offset * cos,
            "height": offset * sin,
            "obstruction": "report",
        },
    });
    file.to_string()
}
