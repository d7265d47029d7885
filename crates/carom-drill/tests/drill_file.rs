//! Drill files are read strictly, and read back to the same drill.

use carom::format::Node;
use carom::{Error, ErrorKind, Simulator};
use carom_drill::{Drill, DrillOrder, Played, ShotFault, judge};

const DRILL: &str = r#"{
  "format": "carom-drill/1", "name": "Two shots", "text": "Pot and stop.", "table": "wpa-9ft", "cue": "cue",
  "attempts": 6, "misses": 2, "order": "ladder",
  "steps": [
    {"balls": [{"id": "cue", "position": [0.635, 1.905]}, {"id": "1", "position": [0.9525, 2.2225]}],
     "goal": {"kind": "shot", "points": 3, "needs": [
       {"kind": "pot", "ball": "1", "pocket": "top-right"},
       {"kind": "stop", "area": {"center": [0.9525, 2.2225], "radius": 0.3}}]}},
    {"balls": [{"id": "cue", "position": [0.3, 0.6]}, {"id": "1", "position": [0.6, 0.6]},
               {"id": "2", "position": [0.9, 0.9]}],
     "hand": {"from": [0, 0], "to": [1.27, 0.635]}, "speed": 2.5,
     "goal": {"kind": "run", "balls": ["1", "2"], "order": "rotation"}}
  ]}"#;

fn refused(change: impl Fn(&str) -> String) -> (ErrorKind, String) {
    match Drill::from_json(&change(DRILL)) {
        Err(Error::Input(error)) => (error.kind, error.place),
        Err(other) => panic!("{other}"),
        Ok(drill) => panic!("not refused: {}", drill.to_node().to_json()),
    }
}

#[test]
fn a_drill_reads_back_to_the_same_plain_values() {
    let drill = Drill::from_json(DRILL).unwrap();
    assert_eq!((drill.attempts, drill.misses, drill.order), (6, Some(2), DrillOrder::Ladder));
    let node = drill.to_node();
    assert_eq!(Drill::from_node(&node).unwrap().to_node(), node);
    assert_eq!(node.get("text"), Some(&Node::from("Pot and stop.")));
}

#[test]
fn what_is_wrong_is_named_with_its_place() {
    let replaced =
        |from: &'static str, to: &'static str| refused(move |text| text.replacen(from, to, 1));
    let cases = [
        (("carom-drill/1", "carom-drill/2"), ErrorKind::Format, "format"),
        (("\"wpa-9ft\"", "\"moon\""), ErrorKind::UnknownName, "table"),
        (("\"attempts\": 6", "\"attempts\": 0"), ErrorKind::OutOfRange, "attempts"),
        (("\"attempts\": 6", "\"attempts\": 101"), ErrorKind::OutOfRange, "attempts"),
        (("\"order\": \"ladder\"", "\"order\": \"up\""), ErrorKind::UnknownName, "order"),
        (("\"misses\"", "\"mises\""), ErrorKind::UnknownKey, "mises"),
        (
            ("[0.635, 1.905]", "[0.635, 1.905, 0.5]"),
            ErrorKind::WrongType,
            "steps[0].balls[0].position",
        ),
        (("[0.9525, 2.2225]}]", "[9, 9]}]"), ErrorKind::OutsideTable, "steps[0].balls[1].position"),
        (
            ("\"ball\": \"1\"", "\"ball\": \"7\""),
            ErrorKind::UnknownBall,
            "steps[0].goal.needs[0].ball",
        ),
        (("top-right", "top-top"), ErrorKind::UnknownName, "steps[0].goal.needs[0].pocket"),
        (
            ("\"radius\": 0.3", "\"radius\": 0"),
            ErrorKind::OutOfRange,
            "steps[0].goal.needs[1].area.radius",
        ),
        (
            ("\"kind\": \"stop\"", "\"kind\": \"halt\""),
            ErrorKind::UnknownName,
            "steps[0].goal.needs[1].kind",
        ),
        (("[\"1\", \"2\"]", "[\"1\", \"5\"]"), ErrorKind::UnknownBall, "steps[1].goal.balls"),
        (
            ("\"to\": [1.27, 0.635]", "\"to\": [0, 0.635]"),
            ErrorKind::OutOfRange,
            "steps[1].hand.to",
        ),
    ];
    for ((from, to), kind, place) in cases {
        assert_eq!(replaced(from, to), (kind, place.to_string()), "{from} → {to}");
    }
}

#[test]
fn sizes_are_bounded() {
    let long = "x".repeat(101);
    assert_eq!(refused(|text| text.replacen("Two shots", &long, 1)).1, "name");
    let huge = " ".repeat(300 * 1024);
    assert_eq!(refused(|text| format!("{text}{huge}")).0, ErrorKind::WrongCount);
    let step = &DRILL[DRILL.find("{\"balls\"").unwrap()..DRILL.find("]}},").unwrap() + 3];
    let many = vec![step; 31].join(",");
    assert_eq!(
        refused(|text| format!("{}[{many}]}}", &text[..text.find("[\n").unwrap()])),
        (ErrorKind::WrongCount, "steps".into())
    );
}

#[test]
fn an_attempt_gives_the_points_of_its_goal() {
    let drill = Drill::from_json(DRILL).unwrap();
    let step = &drill.steps[0];
    let (_, strike) = step.shot.strike().unwrap();
    let mut simulator = Simulator::new();
    let mut verdict = |height: f64, speed: f64| {
        let strike = carom::resolve::cue_ball::Strike { height, speed, ..strike };
        let played = Played::of(&mut simulator, &step.shot, Some(&strike)).unwrap();
        judge(&step.shot, &played, &step.goal, &[]).unwrap()
    };
    assert_eq!((verdict(-0.3, 2.0).points, verdict(-0.3, 2.0).fault), (3, None));
    // Without spin the cue ball follows the ball, far or into the pocket.
    let followed = verdict(0.5, 3.0);
    assert_eq!(followed.points, 0);
    assert!(matches!(followed.fault, Some(ShotFault::Scratch | ShotFault::Need(1, _))));
    // Too soft: the ball does not reach the pocket.
    assert_eq!(verdict(0.0, 0.05).fault, Some(ShotFault::Need(0, 0.0)));
}

#[test]
fn a_ladder_goes_up_after_success_and_down_after_a_miss() {
    let after = |order: DrillOrder, made: &[bool]| {
        made.iter().fold(0, |step, made| order.next(step, 3, *made))
    };
    assert_eq!(after(DrillOrder::Ladder, &[true, true, true]), 2);
    assert_eq!(after(DrillOrder::Ladder, &[true, false, false]), 0);
    assert_eq!(after(DrillOrder::Turns, &[false, true, false]), 0);
    assert_eq!(after(DrillOrder::Same, &[true, true]), 0);
}
