//! Routes of caroms, their patterns and their systems of diamonds.

use carom::format::Node;
use carom::outcome::Touched;
use carom::{Shot, Trace};
use carom_plan::{
    CaromFigure, CaromRoute, DiamondReading, DiamondSystem, RouteSide, counted_touches,
};

/// A strike of the white ball on the match table.
struct Struck {
    balls: [[f64; 2]; 3],
    azimuth_deg: f64,
    speed: f64,
    side: f64,
}

const WIDTH: f64 = 1.42;

impl Struck {
    fn trace(&self) -> Trace {
        let [white, yellow, red] = self.balls;
        let text = format!(
            r#"{{"format": "carom-shot/1", "table": "carom-10ft", "balls": [
                {{"id": "white", "position": {white:?}}}, {{"id": "yellow", "position": {yellow:?}}},
                {{"id": "red", "position": {red:?}}}],
              "strike": {{"ball": "white", "speed": {}, "azimuth_deg": {}, "side": {}, "height": 0.3}}}}"#,
            self.speed, self.azimuth_deg, self.side
        );
        let shot = Shot::from_node(&Node::from_json(&text).expect("JSON")).expect("a shot");
        shot.simulate().expect("a trace")
    }

    fn route(&self) -> CaromRoute {
        CaromRoute::new(&self.trace()).expect("a carom")
    }

    /// The same on the table reflected across its width.
    fn reflected(&self) -> Self {
        Self {
            balls: self.balls.map(|[x, y]| [WIDTH - x, y]),
            azimuth_deg: 180.0 - self.azimuth_deg,
            side: -self.side,
            ..*self
        }
    }
}

/// From the long rail over the short and the other long rail, off the yellow.
const AROUND: Struck = Struck {
    balls: [[0.4, 0.6], [1.1, 0.5], [0.9, 2.2]],
    azimuth_deg: 350.5,
    speed: 4.0,
    side: 0.3,
};

#[test]
fn a_route_names_balls_cushions_hits_side_and_system() {
    let route = AROUND.route();
    assert_eq!((route.pattern.first, route.second), (1, 2));
    assert_eq!(route.pattern.figure, CaromFigure::AroundTheTable);
    assert_eq!(route.pattern.starts_long, Some(true));
    let names: Vec<_> = route.rails.iter().map(|rail| rail.name()).collect();
    assert_eq!((names, route.rails_first), (vec!["right", "bottom", "left"], 0));
    assert_eq!(route.side, RouteSide::Running);
    let system = route.system.expect("a system");
    assert_eq!(system.system, DiamondSystem::CornerFive);
    assert_eq!((system.from.0, system.over.0, system.predicted.0), (3.2, 0.1, 3.1));
    assert!((system.actual.expect("an arrival").0 - 3.1).abs() < 0.5);
}

#[test]
fn the_fullness_is_the_covered_share_of_the_ball() {
    let trace = AROUND.trace();
    let route = AROUND.route();
    for (ball, found) in [route.pattern.first, route.second].into_iter().zip(route.fullness) {
        let event =
            trace.events().find(|event| event.balls == [0, ball] || event.balls == [ball, 0]);
        let event = event.expect("a contact");
        let [own, other] = if event.balls[0] == 0 { [0, 1] } else { [1, 0] };
        let line = event.before[other].position.xy() - event.before[own].position.xy();
        let velocity = event.before[own].velocity.xy();
        let sine = (velocity.cross(line) / (velocity.length() * line.length())).abs();
        // The reach of the balls is the distance of their centres.
        assert!((found.expect("a hit") - (1.0 - sine)).abs() < 1e-6);
    }
}

#[test]
fn a_reflected_shot_has_the_reflected_route() {
    let (route, other) = (AROUND.route(), AROUND.reflected().route());
    assert_eq!(
        (route.pattern, route.second, route.side),
        (other.pattern, other.second, other.side)
    );
    let mirrored: Vec<_> = other.rails.iter().map(|rail| rail.opposite()).collect();
    assert_eq!([route.rails[0], route.rails[2]], [mirrored[0], mirrored[2]]);
    assert_eq!(route.rails[1], other.rails[1]);
    let numbers = |route: &CaromRoute| {
        let system = route.system.as_ref().expect("a system");
        (system.system, system.from.0, system.over.0, system.predicted.0)
    };
    assert_eq!(numbers(&route), numbers(&other));
}

#[test]
fn side_against_the_way_is_reverse_and_little_side_is_none() {
    let across = Struck { azimuth_deg: 354.5, ..AROUND };
    assert_eq!(across.route().side, RouteSide::Reverse);
    assert_eq!(across.reflected().route().side, RouteSide::Reverse);
    let plain = Struck { azimuth_deg: 348.0, side: 0.0, ..AROUND };
    assert_eq!((plain.route().side, plain.route().system), (RouteSide::Without, None));
}

#[test]
fn two_cushions_before_the_first_ball_are_an_umbrella_with_the_plus_system() {
    let umbrella = Struck { azimuth_deg: 319.0, side: -0.3, ..AROUND };
    let route = umbrella.route();
    assert_eq!((route.pattern.figure, route.rails_first), (CaromFigure::Umbrella, 2));
    assert_eq!(route.pattern.starts_long, Some(false));
    let system = route.system.expect("a system");
    assert_eq!(system.system, DiamondSystem::Plus);
    assert!((system.from.0 + system.over.0 - system.predicted.0).abs() < 1e-9);
}

#[test]
fn the_counted_touches_are_those_of_the_route_with_their_events() {
    let (trace, route) = (AROUND.trace(), AROUND.route());
    let touches = counted_touches(&trace);
    let rails: Vec<_> = touches
        .iter()
        .filter_map(|(_, touched)| match touched {
            Touched::Rail(rail) => Some(*rail),
            Touched::Ball(_) => None,
        })
        .collect();
    assert_eq!(rails, route.rails);
    assert_eq!(touches.first().map(|touch| touch.1), Some(Touched::Ball(1)));
    assert_eq!(touches.last().map(|touch| touch.1), Some(Touched::Ball(2)));
    for (number, touched) in touches {
        let event = trace.events().nth(number).expect("an event");
        assert!(event.balls.contains(&0), "{number}: {touched:?}");
    }
}

#[test]
fn the_first_cushion_does_not_count_if_the_ball_is_frozen_to_it() {
    // The white touches the nose of the left rail, which is higher than its centre, and is played into it.
    let frozen = Struck {
        balls: [[0.03012, 0.6], [1.1, 0.5], [0.9, 2.2]],
        azimuth_deg: 100.0,
        speed: 3.0,
        side: 0.0,
    };
    let trace = frozen.trace();
    let touched = &trace.outcome().cue_ball_touched;
    assert_eq!(touched.first(), Some(&Touched::Rail(carom::table::Rail::Left)));
    let counted: Vec<_> = counted_touches(&trace).into_iter().map(|touch| touch.1).collect();
    assert_eq!(counted.first(), touched.get(1));
}

#[test]
fn a_shot_with_one_ball_has_no_route() {
    let trace = Struck { speed: 0.5, azimuth_deg: 351.9, ..AROUND }.trace();
    assert_eq!(trace.outcome().first_contact, Some(1));
    assert!(CaromRoute::new(&trace).is_none());
    let alone = DiamondReading::new(&trace, 9, None);
    assert!(alone.is_none(), "there is no ball 9");
}

#[test]
fn the_node_has_ids_and_kinds_of_rails() {
    let ids = ["white", "yellow", "red"];
    let node = AROUND.route().to_node(|ball| ids[usize::from(ball)]);
    for (key, value) in [
        ("pattern", Node::from("around-the-table")),
        ("first", "yellow".into()),
        ("second", "red".into()),
        ("cushions", Node::list(["long", "short", "long"])),
        ("rails", Node::list(["right", "bottom", "left"])),
        ("side", "running".into()),
    ] {
        assert_eq!(node.get(key), Some(&value));
    }
}
