//! Diamond systems: where a ball arrives after cushions by a player's rule, and where it does arrive.
//!
//! A system counts diamonds where the lines of a ball cross the lines of sights, which lie behind the noses:
//!
//! - Corner five, long rail, short rail, long rail: from the number S of the starting rail over the number F of the
//!   first rail the ball heads for S − F, with running English (D. G. Alciatore, TP 7.2; B. Jewett, Billiards Digest,
//!   June 2010).
//! - Plus system, short rail, long rail, long rail: from the diamond S over the number N of the short rail the ball
//!   comes back to S + N, with a tip of English (N. Varner, Billiards Digest, February 2009).
//! - Two to one, one rail: from S over F of the opposite rail the ball comes back to 2F − S, which is the mirror image
//!   in the line of sights (D. G. Alciatore, The Illustrated Principles of Pool and Billiards, 2004, chapter 6).
//!
//! The row DS-corner of the validation compares the first one with the engine.

use carom::Trace;
use carom::format::Node;
use carom::table::Rail;

use crate::ball_way::{BallWay, Meeting, Obstacle};

/// Players count in tenths of a diamond: so the sum that is shown is right as it is written.
const TENTHS: f64 = 10.0;

/// A system of diamonds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DiamondSystem {
    /// Over a long, a short and a long rail, with running English.
    CornerFive,
    /// Over a short and two long rails, with English.
    Plus,
    /// Over one rail, without English.
    TwoToOne,
}

impl DiamondSystem {
    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::CornerFive => "corner-five",
            Self::Plus => "plus",
            Self::TwoToOne => "two-to-one",
        }
    }

    const fn arrival(self, from: f64, over: f64) -> f64 {
        match self {
            Self::CornerFive => from - over,
            Self::Plus => from + over,
            Self::TwoToOne => 2.0 * over - from,
        }
    }
}

/// A number at a diamond.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiamondNumber {
    /// Place on the line of sights, m, file coordinates.
    pub at: [f64; 2],
    /// The number.
    pub number: f64,
    /// Whether it is a number of the target, which has another scale than those of the lines.
    pub is_target: bool,
}

/// What a system says of the way of a ball. Numbers are diamonds of the system, places are on the lines of sights, m,
/// file coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct DiamondReading {
    /// The system.
    pub system: DiamondSystem,
    /// The number from which the ball comes, to a tenth, and its place.
    pub from: (f64, [f64; 2]),
    /// The number over which it goes, to a tenth, and its place.
    pub over: (f64, [f64; 2]),
    /// Where it arrives by the system.
    pub predicted: (f64, [f64; 2]),
    /// Where it arrives by the engine; none if it falls, stops or meets a ball before.
    pub actual: Option<(f64, [f64; 2])>,
    /// The diamonds with their numbers.
    pub numbers: Vec<DiamondNumber>,
}

/// Places are in diamonds of the long rail, from the bottom left corner of the noses.
type Place = [f64; 2];

/// A table in diamonds of its long rail.
#[derive(Clone, Copy)]
struct Cloth {
    /// A diamond, m.
    unit: f64,
    width: f64,
    length: f64,
    /// The lines of sights behind the noses.
    back: f64,
}

impl DiamondReading {
    /// What a system says of the way of ball number `ball` behind event number `from`, or from the beginning, up to its
    /// contact with another ball. `None` if no system fits it, and on tables without sights. The first two systems
    /// suppose sidespin.
    pub fn new(trace: &Trace, ball: u16, from: Option<usize>) -> Option<Self> {
        Self::of_way(trace, BallWay::new(trace, ball, from)?)
    }

    pub(crate) fn of_way(trace: &Trace, way: BallWay) -> Option<Self> {
        let cloth = Cloth::of(trace)?;
        let scaled = |[x, y]: [f64; 2]| [x / cloth.unit, y / cloth.unit];
        let start = scaled(way.start);
        let meet = |m: &Meeting| Meeting { at: scaled(m.at), by: scaled(m.by), ..*m };
        let meetings: Vec<Meeting> = way.meetings.iter().map(meet).collect();
        let rail = |k: usize| match meetings.get(k)?.with {
            Obstacle::Cushion(rail) => Some(rail),
            _ => None,
        };
        let first = rail(0)?;
        let second = rail(1);
        let third = second.and_then(|_| rail(2));
        let (system, last, home) = match second {
            None => (DiamondSystem::TwoToOne, 1, first.opposite()),
            Some(second) if second == first.opposite() => (DiamondSystem::TwoToOne, 1, second),
            // The third cushion may be missed: the ball still heads for the rail.
            Some(_) if third == Some(first) => return None,
            Some(_) if first.is_long() => (DiamondSystem::CornerFive, 2, first.opposite()),
            Some(second) => (DiamondSystem::Plus, 2, second.opposite()),
        };
        let at = meetings[0].at;
        let line = [at[0] - start[0], at[1] - start[1]];
        let scale = Scale::new(system, cloth, line, first, home);
        let own = cloth.crossing(start, line, home)?;
        let over = cloth.crossing(start, line, first)?;
        // The mirror image also holds for lines that come from beyond the rail.
        let number = scale.along(own);
        let is_on_rail = number > -cloth.back && number <= scale.end + cloth.back + 1e-9;
        if !is_on_rail && system != DiamondSystem::TwoToOne {
            return None;
        }
        let heads = meetings.get(last).and_then(|next| {
            let towards = match home {
                Rail::Left => -next.by[0],
                Rail::Right => next.by[0],
                Rail::Bottom => -next.by[1],
                _ => next.by[1],
            };
            if towards > 0.0 { cloth.crossing(next.at, next.by, home) } else { None }
        });
        Some(scale.reading(own, over, heads))
    }

    /// The reading as a tree of values, for the bindings.
    pub fn to_node(&self) -> Node {
        let place = |(_, place): (f64, [f64; 2])| Node::list(place);
        let numbers = self.numbers.iter().map(|one| {
            Node::object([
                ("at", Node::list(one.at)),
                ("number", one.number.into()),
                ("scale", if one.is_target { "target" } else { "line" }.into()),
            ])
        });
        Node::object([
            ("system", self.system.name().into()),
            ("from", self.from.0.into()),
            ("over", self.over.0.into()),
            ("predicted", self.predicted.0.into()),
            ("actual", self.actual.map_or(Node::Null, |actual| actual.0.into())),
            ("numbers", Node::list(numbers)),
            (
                "places",
                Node::object([
                    ("from", place(self.from)),
                    ("over", place(self.over)),
                    ("predicted", place(self.predicted)),
                    ("actual", self.actual.map_or(Node::Null, place)),
                ]),
            ),
        ])
    }
}

impl Cloth {
    fn of(trace: &Trace) -> Option<Self> {
        let table = trace.shot().table();
        let sights = table.description.as_ref()?.sights?;
        let along = f64::from(sights.along_length);
        let unit = table.size.y / along;
        Some(Self { unit, width: table.size.x / unit, length: along, back: sights.setback / unit })
    }

    /// The line of sights of a rail.
    fn line(&self, rail: Rail) -> f64 {
        match rail {
            Rail::Left | Rail::Bottom => -self.back,
            Rail::Right => self.width + self.back,
            _ => self.length + self.back,
        }
    }

    /// Where the line through a place in a direction crosses the line of sights of a rail.
    fn crossing(&self, [x, y]: Place, [vx, vy]: Place, rail: Rail) -> Option<Place> {
        let (at, speed) = if rail.is_long() { (x, vx) } else { (y, vy) };
        let time = (self.line(rail) - at) / speed;
        (speed != 0.0).then_some([x + time * vx, y + time * vy])
    }
}

/// Diamonds along the rails that a ball meets.
struct Scale {
    system: DiamondSystem,
    cloth: Cloth,
    first: Rail,
    /// The rail of the start and of the arrival.
    home: Rail,
    /// Diamonds of the home rail.
    end: f64,
    /// Whether the numbers along the home rail and the one opposite count from the end at the top or on the right.
    is_reversed: bool,
}

impl Scale {
    /// Numbers count from the end of the home rail towards which the ball goes at first. In the plus system they begin
    /// at the short rail that is met first.
    fn new(system: DiamondSystem, cloth: Cloth, line: Place, first: Rail, home: Rail) -> Self {
        let is_reversed = match system {
            DiamondSystem::Plus => first == Rail::Top,
            _ => line[usize::from(home.is_long())] >= 0.0,
        };
        let end = if home.is_long() { cloth.length } else { cloth.width };
        Self { system, cloth, first, home, end, is_reversed }
    }

    /// Along the home rail and the one opposite.
    fn along(&self, place: Place) -> f64 {
        let at = place[usize::from(self.home.is_long())];
        if self.is_reversed { self.end - at } else { at }
    }

    /// The place of a number along a rail, m. The home rail's direction counts.
    fn placed(&self, rail: Rail, number: f64) -> [f64; 2] {
        let turned = self.is_reversed && rail.is_long() == self.home.is_long();
        self.place(rail, if turned { self.end - number } else { number })
    }

    /// A place on the line of sights of a rail, m.
    fn place(&self, rail: Rail, at: f64) -> [f64; 2] {
        let line = self.cloth.line(rail);
        self.metres(if rail.is_long() { [line, at] } else { [at, line] })
    }

    fn metres(&self, [x, y]: Place) -> [f64; 2] {
        [x * self.cloth.unit, y * self.cloth.unit]
    }

    /// The number where the ball starts: 5 is the corner in corner five, and each diamond is half a number.
    fn start(&self, at: f64) -> f64 {
        match self.system {
            DiamondSystem::CornerFive => 5.0 - (self.end - at) / 2.0,
            _ => at,
        }
    }

    /// The number on the first rail. The diamonds of the short rail have 7, 5 and 3 in the plus system, the lowest
    /// farthest from the home rail.
    fn over(&self, place: Place) -> f64 {
        match self.system {
            DiamondSystem::Plus if self.home == Rail::Left => 9.0 - 2.0 * place[0],
            DiamondSystem::Plus => 9.0 - 2.0 * (self.cloth.width - place[0]),
            _ => self.along(place),
        }
    }

    fn reading(&self, own: Place, over: Place, heads: Option<Place>) -> DiamondReading {
        // The sum removes the sign of a zero.
        let tenths = |x: f64| (TENTHS * x).round() / TENTHS + 0.0;
        let from = tenths(self.start(self.along(own)));
        let number = tenths(self.over(over));
        let predicted = tenths(self.system.arrival(from, number));
        DiamondReading {
            system: self.system,
            from: (from, self.metres(own)),
            over: (number, self.metres(over)),
            predicted: (predicted, self.placed(self.home, predicted)),
            actual: heads.map(|place| (self.along(place), self.metres(place))),
            numbers: self.numbers(),
        }
    }

    fn numbers(&self) -> Vec<DiamondNumber> {
        let between = |end: f64| (1_u32..).map(f64::from).take_while(move |at| *at < end);
        let target = between(self.end).map(|at| DiamondNumber {
            at: self.placed(self.home, at),
            number: at,
            is_target: true,
        });
        let line = |at, number| DiamondNumber { at, number, is_target: false };
        let mut numbers: Vec<DiamondNumber> = match self.system {
            DiamondSystem::Plus => between(self.cloth.width)
                .map(|at| line(self.place(self.first, at), self.over([at, 0.0])))
                .collect(),
            _ => between(self.end).map(|at| line(self.placed(self.first, at), at)).collect(),
        };
        if self.system == DiamondSystem::CornerFive {
            let starts = between(self.end + 1.0);
            numbers.extend(starts.map(|at| line(self.placed(self.home, at), self.start(at))));
        }
        numbers.extend(target);
        numbers
    }
}
