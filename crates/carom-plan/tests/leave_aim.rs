//! Position play with the pot kept.

use carom::math::Vec2;
use carom::{Shot, Simulator};
use carom_plan::{ErrorModel, LeaveAim, leave_aim};

const SPEEDS: [f64; 2] = [0.5, 6.0];
const OFFSET: f64 = 0.45;

/// A half-ball cut of ball 1 into the top right pocket.
fn shot() -> Shot {
    Shot::from_json(
        r#"{"format": "carom-shot/1", "table": "wpa-9ft",
            "balls": [{"id": "cue", "position": [0.42, 0.72]}, {"id": "1", "position": [0.86, 1.74]}],
            "strike": {"ball": "cue", "azimuth_deg": 66.8, "speed": 2}}"#,
    )
    .expect("a shot")
}

fn top_right(shot: &Shot) -> usize {
    shot.table().pockets.iter().position(|p| p.name.name() == "top-right").expect("a pocket")
}

fn aim(shot: &Shot, place: [f64; 2]) -> Option<LeaveAim> {
    let model = ErrorModel { variants: 64, ..ErrorModel::default() };
    leave_aim(shot, 1, top_right(shot), place, SPEEDS, OFFSET, &model).expect("a goal")
}

/// What an exact strike does: the pocket of ball 1, and where the cue ball stops.
fn played(shot: &Shot, aim: &LeaveAim) -> (Option<String>, [f64; 2]) {
    let trace = Simulator::new()
        .record(&shot.with_strike(&aim.strike).expect("a strike"))
        .expect("a trace");
    let fell = trace.outcome().pocketed.iter().find(|(ball, _)| *ball == 1);
    let end = trace.last()[0].position;
    (fell.map(|(_, pocket)| pocket.name().to_owned()), [end.x, end.y])
}

#[test]
fn places_on_both_sides_of_the_natural_line_are_reached_with_the_ball_potted() {
    let shot = shot();
    for place in [[0.3, 2.0], [0.5, 1.2], [0.7, 0.5]] {
        let aim = aim(&shot, place).expect("a strike");
        let (pocket, end) = played(&shot, &aim);
        assert_eq!(pocket.as_deref(), Some("top-right"), "{place:?}");
        let away = Vec2::new(end[0] - place[0], end[1] - place[1]).length();
        assert!((away - aim.distance).abs() < 1e-9, "{place:?}: {away}, {}", aim.distance);
        assert!(aim.is_reached && away <= 0.02, "{place:?}: {away} m");
        assert!(aim.chance.met > 0, "{place:?}");
    }
}

#[test]
fn a_place_out_of_reach_gives_the_nearest_stop_and_keeps_the_pot() {
    // Behind the cue ball in the kitchen's corner, beyond the draw of a half-ball cut at 1 m/s.
    let shot = shot();
    let model = ErrorModel { variants: 16, ..ErrorModel::default() };
    let aim = leave_aim(&shot, 1, top_right(&shot), [0.1, 0.1], [0.9, 1.1], OFFSET, &model)
        .expect("a goal");
    let aim = aim.expect("a pot");
    assert!(!aim.is_reached && aim.distance > 0.3, "{}", aim.distance);
    assert_eq!(played(&shot, &aim).0.as_deref(), Some("top-right"));
}

#[test]
fn a_range_of_speeds_without_width_is_refused_with_a_remedy() {
    let shot = shot();
    let error = leave_aim(&shot, 1, 0, [0.5, 0.5], [2.0, 2.0], 0.4, &ErrorModel::default());
    assert!(error.expect_err("an error").to_string().contains("give 0 < least < most <= 50"));
}
