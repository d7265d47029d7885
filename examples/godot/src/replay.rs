//! A trace in Godot's axes: y is up, so carom's (x, y, z) is (x, z, -y).

use carom::Trace;
use carom::math::Vec3;
use carom::shot::PlacedBall;
use carom::trace::{Orientations, TraceEvent};
use godot::builtin::{Basis, Quaternion, Transform3D, Vector2, Vector3};

/// A trace and the orientations of its balls, which are computed once.
pub struct Replay {
    pub trace: Trace,
    orientations: Orientations,
}

impl Replay {
    pub fn new(trace: Trace) -> Self {
        Self { orientations: trace.orientations(), trace }
    }

    pub fn balls(&self) -> impl Iterator<Item = &PlacedBall> {
        self.trace.shot().balls().iter()
    }

    /// Width and length of the playing surface, m.
    pub fn table_size(&self) -> Vector2 {
        let center = self.trace.shot().table().center();
        Vector2::new(2.0 * center.x as f32, 2.0 * center.y as f32)
    }

    /// The place and the turn of every ball. A time before the shot is its start.
    pub fn transforms(&self, time: f64) -> impl Iterator<Item = Transform3D> {
        let time = if time.is_finite() { time.max(0.0) } else { self.trace.duration() };
        let states = self.trace.at(time).expect("the time is finite and not negative");
        states.into_iter().enumerate().map(move |(ball, state)| {
            let turn = quaternion(self.orientations.at(ball, time));
            Transform3D::new(Basis::from_quaternion(turn), vector(state.position))
        })
    }

    /// The largest impulse that a ball gets, N s.
    pub fn strength(&self, event: &TraceEvent<'_>) -> f64 {
        self.trace.impulses(event).iter().map(|impulse| impulse.length()).fold(0.0, f64::max)
    }
}

fn vector(v: Vec3) -> Vector3 {
    Vector3::new(v.x as f32, v.z as f32, -v.y as f32)
}

fn quaternion([x, y, z, w]: [f64; 4]) -> Quaternion {
    Quaternion::new(x as f32, z as f32, -y as f32, w as f32).normalized()
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom::Shot;

    const SHOT: &str = r#"{
        "format": "carom-shot/1",
        "table": "wpa-9ft",
        "balls": [{"id": "cue", "position": [0.45, 0.75]}, {"id": "8", "position": [0.80, 1.45]}],
        "strike": {"ball": "cue", "speed": 1.84, "azimuth_deg": 62.92, "side": 0.07, "height": -0.23}
    }"#;

    fn replay() -> Replay {
        Replay::new(Shot::from_json(SHOT).unwrap().simulate().unwrap())
    }

    #[test]
    fn a_ball_lies_on_the_cloth_at_its_place() {
        let start: Vec<Transform3D> = replay().transforms(-1.0).collect();
        let radius = replay().balls().next().unwrap().ball.radius as f32;
        assert_eq!(start[0].origin, Vector3::new(0.45, radius, -0.75));
        assert_eq!(start[0].basis, Basis::IDENTITY);
    }

    #[test]
    fn a_ball_turns_about_the_axis_of_its_spin() {
        let replay = replay();
        let trace = &replay.trace;
        let (mut tested, step) = (0, 5e-3);
        for part in 1..20 {
            let time = trace.duration() * f64::from(part) / 20.0;
            let state = trace.at(time).unwrap()[1];
            let speed = state.angular_velocity.length();
            if speed < 1.0 || trace.events().any(|e| (e.time - time).abs() < 2.0 * step) {
                continue;
            }
            let [from, to] = [time, time + step]
                .map(|t| replay.transforms(t).nth(1).unwrap().basis.get_quaternion());
            let turn = to * from.inverse();
            let axis = (Vector3::new(turn.x, turn.y, turn.z) * turn.w.signum()).normalized();
            let expected = vector(state.angular_velocity).normalized();
            assert!(axis.dot(expected) > 0.999, "{axis} and {expected} at {time} s");
            tested += 1;
        }
        assert!(tested > 3, "{tested}");
    }

    #[test]
    fn only_impacts_have_a_strength() {
        let replay = replay();
        for event in replay.trace.events() {
            assert_eq!(replay.strength(&event) > 0.0, event.is_impact(), "{:?}", event.kind);
        }
    }

    #[test]
    fn the_surface_has_the_size_of_the_table() {
        assert_eq!(replay().table_size(), Vector2::new(1.27, 2.54));
    }
}
