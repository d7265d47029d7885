//! Aiming by ball and pocket.

use carom::resolve::cue_ball::Strike;
use carom::{Shot, Simulator};
use carom_plan::{PotAim, PotLines};

/// A shot at 2 m/s on a nine-foot table with these balls, the cue ball first. The cue points away.
fn shot(balls: &[[f64; 2]], strike: &str) -> Shot {
    let balls: Vec<String> = balls
        .iter()
        .enumerate()
        .map(|(k, [x, y])| format!(r#"{{"id": "{k}", "position": [{x}, {y}]}}"#))
        .collect();
    Shot::from_json(&format!(
        r#"{{"format": "carom-shot/1", "table": "wpa-9ft", "balls": [{}],
            "strike": {{"ball": "0", "azimuth_deg": 270, {strike}}}}}"#,
        balls.join(", ")
    ))
    .expect("a shot")
}

fn pot_aim(shot: &Shot, ball: usize, pocket: usize) -> Result<Option<PotAim>, carom::Error> {
    carom_plan::pot_aim(shot, ball, pocket, PotLines::All)
}

fn pocket(shot: &Shot, name: &str) -> usize {
    shot.table().pockets.iter().position(|p| p.name.name() == name).expect("a pocket")
}

/// The pocket into which ball 1 falls when the azimuth is turned by `by` rad.
fn falls(shot: &Shot, aim: &PotAim, by: f64) -> Option<String> {
    let strike = Strike { azimuth: aim.strike.azimuth + by, ..aim.strike };
    let trace =
        Simulator::new().record(&shot.with_strike(&strike).expect("a strike")).expect("a trace");
    let pocketed = &trace.outcome().pocketed;
    pocketed.iter().find(|(ball, _)| *ball == 1).map(|(_, pocket)| pocket.name().to_owned())
}

const SPINS: [&str; 5] = [
    r#""speed": 2"#,
    r#""speed": 2, "side": 0.4, "height": -0.2"#,
    r#""speed": 4, "side": -0.45"#,
    r#""speed": 1.2, "height": 0.4, "side": 0.2"#,
    r#""speed": 2.5, "side": 0.35, "elevation_deg": 25"#,
];

#[test]
fn a_cut_is_potted_with_any_spin_and_the_margin_is_that_of_the_pocket() {
    for strike in SPINS {
        let shot = shot(&[[0.42, 0.72], [0.86, 1.74]], strike);
        let aim = pot_aim(&shot, 1, pocket(&shot, "top-right")).expect("a goal").expect(strike);
        assert_eq!(aim.route.kind(), "direct", "{strike}");
        let own = shot.strike().expect("a strike").1;
        assert_eq!((aim.strike.speed, aim.strike.side), (own.speed, own.side));
        assert!((5e-4..0.05).contains(&aim.margin), "{strike}: {}", aim.margin);
        for share in [-0.9, -0.5, 0.0, 0.5, 0.9] {
            let found = falls(&shot, &aim, share * aim.margin);
            assert_eq!(found.as_deref(), Some("top-right"), "{strike} at {share}");
        }
        for share in [-1.3, 1.3] {
            let found = falls(&shot, &aim, share * aim.margin);
            assert_ne!(found.as_deref(), Some("top-right"), "{strike} at {share}");
        }
    }
}

#[test]
fn an_aim_that_pots_already_stays_on_its_line() {
    let shot = shot(&[[0.42, 0.72], [0.86, 1.74]], SPINS[1]);
    let goal = pocket(&shot, "top-right");
    let first = pot_aim(&shot, 1, goal).expect("a goal").expect("an aim");
    let turned = Strike { azimuth: first.strike.azimuth + 0.6 * first.margin, ..first.strike };
    let again = pot_aim(&shot.with_strike(&turned).expect("a strike"), 1, goal);
    let again = again.expect("a goal").expect("an aim");
    assert!((again.strike.azimuth - first.strike.azimuth).abs() < 0.2 * first.margin);
}

#[test]
fn a_blocked_ball_is_banked() {
    // Ball 2 stands between ball 1 and the pocket.
    let shot = shot(&[[0.6, 0.5], [0.8, 1.3], [1.0, 1.85]], r#""speed": 3"#);
    let aim = pot_aim(&shot, 1, pocket(&shot, "top-right")).expect("a goal").expect("a bank");
    assert!(aim.route.kind().contains("bank"), "{}", aim.route.kind());
    assert_eq!(falls(&shot, &aim, 0.0).as_deref(), Some("top-right"));
    let side = pot_aim(&shot, 1, pocket(&shot, "top-left")).expect("a goal").expect("a cut");
    assert_eq!(falls(&shot, &side, 0.0).as_deref(), Some("top-left"));
}

#[test]
fn a_pot_that_loses_the_cue_ball_is_aimed_and_told() {
    // Straight in, with follow: the cue ball goes after the ball.
    let shot = shot(&[[0.9, 2.17], [1.1, 2.37]], r#""speed": 3, "height": 0.5"#);
    let aim = pot_aim(&shot, 1, pocket(&shot, "top-right")).expect("a goal").expect("an aim");
    assert!(aim.loses_cue_ball);
    assert_eq!(falls(&shot, &aim, 0.0).as_deref(), Some("top-right"));
}

#[test]
fn a_pocket_behind_the_ball_that_no_line_reaches_gives_none() {
    // Too soft to reach anything.
    let shot = shot(&[[0.42, 0.72], [0.86, 1.74]], r#""speed": 0.1"#);
    assert_eq!(pot_aim(&shot, 1, pocket(&shot, "top-right")).expect("a goal"), None);
}

#[test]
fn the_cue_ball_and_missing_pockets_are_refused() {
    let shot = shot(&[[0.42, 0.72], [0.86, 1.74]], SPINS[0]);
    assert!(pot_aim(&shot, 0, 0).is_err());
    assert!(pot_aim(&shot, 1, 6).is_err());
}

#[test]
fn near_lines_are_those_that_almost_pot_the_ball() {
    let shot = shot(&[[0.42, 0.72], [0.86, 1.74]], SPINS[1]);
    let goal = pocket(&shot, "top-right");
    let near = |shot: &Shot| carom_plan::pot_aim(shot, 1, goal, PotLines::Near).expect("a goal");
    assert_eq!(near(&shot), None);
    let aim = pot_aim(&shot, 1, goal).expect("a goal").expect("an aim");
    let turned = Strike { azimuth: aim.strike.azimuth + 2.5 * aim.margin, ..aim.strike };
    let found = near(&shot.with_strike(&turned).expect("a strike")).expect("an aim");
    assert!((found.strike.azimuth - aim.strike.azimuth).abs() < 0.2 * aim.margin);
}
