//! The route of a carom: the first ball, the cushions in order, the second ball, and how the balls are hit; and the
//! pattern by which players group such routes.

use carom::format::Node;
use carom::math::sqrt;
use carom::outcome::Touched;
use carom::resolve::cue_ball::TIP;
use carom::table::Rail;
use carom::trace::{TraceEvent, TraceEventKind};
use carom::{Shot, Trace};
use carom_rules::{BallIndex, CaromWay};

use crate::ball_way::{BallWay, Obstacle};
use crate::diamonds::{DiamondReading, DiamondSystem};

/// Least sidespin that is named, ball radii: half a tip.
const LEAST_SIDE: f64 = TIP / 2.0;
/// The ball moves along a cushion if that part of its velocity is above this share: 6°. A ball that meets a cushion
/// squarely runs where its spin sends it.
const ALONG: f64 = 0.1;
/// Largest difference of a system from the engine, diamonds, with which a player would still use it: about as much as
/// players allow for a table and for their English. With more, sums would be shown that send the ball elsewhere.
const FITS: f64 = 1.0;

/// The order of long and short rails of a carom.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CaromFigure {
    /// No cushion.
    Direct,
    /// One cushion.
    OneCushion,
    /// Two cushions.
    TwoCushions,
    /// Three rails one after the other around the table.
    AroundTheTable,
    /// A rail, its neighbour, and the same rail again.
    DoubleTheRail,
    /// A rail, the one opposite, and the same rail again.
    AcrossTheTable,
    /// A rail, the one opposite, and a neighbour.
    AcrossThenCorner,
    /// A rail, its neighbour, and the one opposite this.
    CornerThenAcross,
    /// One cushion before the first ball, and the same cushion behind it.
    Ticky,
    /// One cushion before the first ball.
    CushionFirst,
    /// Two cushions before the first ball.
    Umbrella,
    /// Three cushions or more before the first ball.
    CushionsFirst,
    /// A rail twice in a row.
    SameRail,
}

impl CaromFigure {
    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Direct => "direct",
            Self::OneCushion => "one-cushion",
            Self::TwoCushions => "two-cushions",
            Self::AroundTheTable => "around-the-table",
            Self::DoubleTheRail => "double-the-rail",
            Self::AcrossTheTable => "across-the-table",
            Self::AcrossThenCorner => "across-then-corner",
            Self::CornerThenAcross => "corner-then-across",
            Self::Ticky => "ticky",
            Self::CushionFirst => "cushion-first",
            Self::Umbrella => "umbrella",
            Self::CushionsFirst => "cushions-first",
            Self::SameRail => "same-rail",
        }
    }

    /// The figure of the first three rails, of which `rails_first` or more come before the first ball.
    fn of(rails_first: usize, rails: [Option<Rail>; 3]) -> Self {
        match (rails_first, rails) {
            (0, [None, ..]) => Self::Direct,
            (0, [_, None, _]) => Self::OneCushion,
            (0, [_, _, None]) => Self::TwoCushions,
            (0, [Some(a), Some(b), Some(c)]) if a == b || b == c => Self::SameRail,
            (0, [Some(a), Some(b), Some(c)]) => {
                match (b == a.opposite(), c == b.opposite(), c == a) {
                    (true, true, _) => Self::AcrossTheTable,
                    (true, false, _) => Self::AcrossThenCorner,
                    (false, true, _) => Self::CornerThenAcross,
                    (false, false, true) => Self::DoubleTheRail,
                    (false, false, false) => Self::AroundTheTable,
                }
            }
            (1, [first, behind, _]) if first == behind => Self::Ticky,
            (1, _) => Self::CushionFirst,
            (2, _) => Self::Umbrella,
            _ => Self::CushionsFirst,
        }
    }
}

/// What players count as one way to score: the first ball, the figure, and the kind of its first rail.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct CaromPattern {
    /// The first object ball.
    pub first: BallIndex,
    /// The order of the rails.
    pub figure: CaromFigure,
    /// Whether the first cushion is that of a long rail; none without a cushion.
    pub starts_long: Option<bool>,
}

impl CaromPattern {
    /// The pattern of the way that reaches two object balls; `None` for another way.
    pub fn of(way: &CaromWay<'_>) -> Option<Self> {
        let (first, _) = way.first().zip(way.second())?;
        let mut rails = way.rails();
        let rails = [rails.next(), rails.next(), rails.next()];
        let figure = CaromFigure::of(way.rails_first(), rails);
        Some(Self { first, figure, starts_long: rails[0].map(Rail::is_long) })
    }
}

/// How the sidespin acts at the first cushion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RouteSide {
    /// Less than half a tip, or no cushion is met.
    Without,
    /// It speeds the ball up along the cushion.
    Running,
    /// It slows the ball down along the cushion.
    Reverse,
}

impl RouteSide {
    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Without => "none",
            Self::Running => "running",
            Self::Reverse => "reverse",
        }
    }
}

/// The route of a carom. Balls are indices of the shot.
#[derive(Clone, Debug, PartialEq)]
pub struct CaromRoute {
    /// The pattern, with the first object ball.
    pub pattern: CaromPattern,
    /// The second object ball.
    pub second: BallIndex,
    /// The rails of the cushions up to the second object ball, in order.
    pub rails: Vec<Rail>,
    /// Number of those before the first object ball.
    pub rails_first: usize,
    /// How much of the first and of the second ball the cue ball covers as it meets them, 1 (full) to 0; none in a
    /// contact of several balls.
    pub fullness: [Option<f64>; 2],
    /// How the sidespin acts.
    pub side: RouteSide,
    /// The system with which a player would reckon the way over the cushions; none if none fits.
    pub system: Option<DiamondReading>,
}

/// The way of the cue ball of a recorded shot; `None` without a strike.
fn way(trace: &Trace) -> Option<CaromWay<'_>> {
    let cue = trace.outcome().cue_ball?;
    let placed = &trace.shot().balls()[usize::from(cue)];
    let start = placed.state.position;
    let table = trace.shot().table();
    Some(CaromWay::new(trace.outcome(), table, [start.x, start.y], placed.ball.radius))
}

/// What the cue ball of a recorded shot touches up to its second object ball, as a referee of carom counts it: the
/// numbers of the events, with the touches.
pub fn counted_touches(trace: &Trace) -> Vec<(usize, Touched)> {
    let Some((way, cue)) = way(trace).zip(trace.outcome().cue_ball) else { return Vec::new() };
    let mut touches = trace.outcome().cue_ball_touched.iter().enumerate().peekable();
    let mut found = Vec::new();
    for (number, event) in trace.events().enumerate().filter(|(_, e)| e.balls.contains(&cue)) {
        let is_of_event = |touched: &Touched| match (touched, event.kind) {
            (Touched::Rail(rail), TraceEventKind::RailCollision { rail: hit, .. }) => *rail == hit,
            (Touched::Rail(_), _) | (_, TraceEventKind::RailCollision { .. }) => false,
            (Touched::Ball(ball), _) => event.balls.contains(ball),
        };
        while let Some((k, touched)) = touches.next_if(|(_, touched)| is_of_event(touched)) {
            if way.counted().contains(&k) {
                found.push((number, *touched));
            }
        }
    }
    found
}

impl CaromRoute {
    /// The route of a shot whose cue ball meets two object balls; `None` for another one.
    pub fn new(trace: &Trace) -> Option<Self> {
        let shot = trace.shot();
        let cue = trace.outcome().cue_ball?;
        let way = way(trace)?;
        let pattern = CaromPattern::of(&way)?;
        let second = way.second()?;
        let whole = BallWay::new(trace, cue, None)?;
        let fullness = [pattern.first, second].map(|ball| fullness(shot, &whole, cue, ball));
        let side = side(shot, &whole);
        Some(Self {
            pattern,
            second,
            rails: way.rails().collect(),
            rails_first: way.rails_first(),
            fullness,
            side,
            system: system(trace, cue, &way, side),
        })
    }

    /// The route as a tree of values, for the bindings; `ids` are the names of the balls.
    pub fn to_node<'a>(&self, id: impl Fn(BallIndex) -> &'a str) -> Node {
        let kind = |rail: &Rail| if rail.is_long() { "long" } else { "short" };
        Node::object([
            ("pattern", self.pattern.figure.name().into()),
            ("first", id(self.pattern.first).into()),
            ("second", id(self.second).into()),
            ("cushions", Node::list(self.rails.iter().map(kind))),
            ("rails", Node::list(self.rails.iter().map(|rail| rail.name()))),
            ("cushions_first", (self.rails_first as u32).into()),
            ("fullness", Node::list(self.fullness.map(|x| x.map_or(Node::Null, Node::from)))),
            ("side", self.side.name().into()),
            ("system", self.system.as_ref().map_or(Node::Null, DiamondReading::to_node)),
        ])
    }
}

/// How much of `ball` the cue ball covers when it first meets it: for equal balls one minus the sine of the cut angle.
fn fullness(shot: &Shot, way: &BallWay, cue: BallIndex, ball: BallIndex) -> Option<f64> {
    let met = way.meetings.iter().find_map(|meeting| match meeting.with {
        Obstacle::Ball(other, place) if other == ball => Some((meeting, place)),
        _ => None,
    });
    let (meeting, place) = met?;
    let [x, y] = [place[0] - meeting.at[0], place[1] - meeting.at[1]];
    let [vx, vy] = meeting.by;
    let speed = sqrt(vx * vx + vy * vy);
    let radius = |ball: BallIndex| shot.balls()[usize::from(ball)].ball.radius;
    let across = (vx * y - vy * x).abs() / (speed * (radius(cue) + radius(ball)));
    (speed > 0.0).then(|| (1.0 - across).max(0.0))
}

/// How the sidespin of the strike acts at the first cushion.
fn side(shot: &Shot, way: &BallWay) -> RouteSide {
    let Some((_, strike)) = shot.strike() else { return RouteSide::Without };
    let cushion = way.meetings.iter().find_map(|meeting| match meeting.with {
        Obstacle::Cushion(rail) => Some((rail, meeting.by)),
        _ => None,
    });
    let Some((rail, [vx, vy])) = cushion.filter(|_| strike.side.abs() >= LEAST_SIDE) else {
        return RouteSide::Without;
    };
    // Right of centre turns the ball counter-clockwise: friction at the left rail then sends it to the top.
    let sent = match rail.whole() {
        Rail::Left => vy,
        Rail::Right => -vy,
        Rail::Bottom => -vx,
        _ => vx,
    };
    let along = sent * strike.side.signum();
    if along < -ALONG * sqrt(vx * vx + vy * vy) { RouteSide::Reverse } else { RouteSide::Running }
}

/// The system that fits the way between the first ball and the second, or up to the first one if cushions come first.
fn system(
    trace: &Trace,
    cue: BallIndex,
    way: &CaromWay<'_>,
    side: RouteSide,
) -> Option<DiamondReading> {
    let is_hit = |event: TraceEvent<'_>| {
        event.kind == TraceEventKind::BallCollision && event.balls.contains(&cue)
    };
    let from = match way.rails_first() {
        0 => Some(trace.events().position(is_hit)?),
        _ => None,
    };
    let reading = DiamondReading::new(trace, cue, from)?;
    let rails = if from.is_some() { way.rails().count() } else { way.rails_first() };
    let is_meant = match reading.system {
        // It tells the second rail at most.
        DiamondSystem::TwoToOne => side == RouteSide::Without && rails <= 2,
        DiamondSystem::CornerFive | DiamondSystem::Plus => side == RouteSide::Running,
    };
    let is_near = reading.actual.is_some_and(|(at, _)| (at - reading.predicted.0).abs() <= FITS);
    let is_read = reading.over.0 >= 0.0
        && [reading.from, reading.predicted].iter().all(|(_, at)| is_on_rail(trace, *at));
    Some(reading).filter(|_| is_meant && is_near && is_read)
}

/// Whether a place on a line of sights lies beside the cloth, where players read numbers.
fn is_on_rail(trace: &Trace, [x, y]: [f64; 2]) -> bool {
    let table = trace.shot().table();
    let setback =
        table.description.as_ref().and_then(|it| it.sights).map_or(0.0, |sights| sights.setback);
    let room = setback + 1e-9;
    let is_within = |at: f64, size: f64| (-room..=size + room).contains(&at);
    is_within(x, table.size.x) && is_within(y, table.size.y)
}

#[cfg(test)]
mod tests {
    use super::*;
    use Rail::{Bottom, Left, Right, Top};

    #[test]
    fn the_figure_follows_from_the_order_of_the_rails() {
        for (rails_first, rails, figure) in [
            (0, &[][..], CaromFigure::Direct),
            (0, &[Left], CaromFigure::OneCushion),
            (0, &[Left, Top], CaromFigure::TwoCushions),
            (0, &[Left, Top, Right], CaromFigure::AroundTheTable),
            (0, &[Bottom, Left, Top], CaromFigure::AroundTheTable),
            (0, &[Left, Top, Left], CaromFigure::DoubleTheRail),
            (0, &[Left, Right, Left], CaromFigure::AcrossTheTable),
            (0, &[Top, Bottom, Left], CaromFigure::AcrossThenCorner),
            (0, &[Left, Bottom, Top], CaromFigure::CornerThenAcross),
            (0, &[Left, Left, Top], CaromFigure::SameRail),
            (1, &[Left, Left, Top], CaromFigure::Ticky),
            (1, &[Left, Top, Right], CaromFigure::CushionFirst),
            (1, &[Left], CaromFigure::CushionFirst),
            (2, &[Left, Top, Right], CaromFigure::Umbrella),
            (3, &[Left, Top, Right], CaromFigure::CushionsFirst),
        ] {
            let three = [0, 1, 2].map(|k| rails.get(k).copied());
            assert_eq!(CaromFigure::of(rails_first, three), figure, "{rails:?}");
        }
    }
}
