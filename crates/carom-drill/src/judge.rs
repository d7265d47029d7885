//! Judges a shot of a drill or a puzzle.

use carom::format::Node;
use carom::{Error, Shot};

use crate::goal::{DrillCondition, DrillGoal, RunOrder, Zone};
use crate::met::Met;
use crate::played::Played;

/// What was wrong with a shot: the first condition that it does not meet, or the loss of the cue ball.
#[derive(Clone, Debug, PartialEq)]
pub enum ShotFault {
    /// The cue ball fell or left the table.
    Scratch,
    /// The condition with this index, and how far outside its area the cue ball stopped, m.
    Need(usize, f64),
    /// The cue ball stopped so far outside the largest zone, m.
    Zone(f64),
    /// A run's shot: another ball was met first than this one, or none.
    WrongFirst(String),
    /// A run's shot: no ball fell that may fall.
    NoPot,
    /// A run's shot: this ball fell too early, or left the table.
    WrongBall(String),
}

/// How a shot went.
#[derive(Clone, Debug, PartialEq)]
pub struct ShotVerdict {
    /// Points of the attempt so far.
    pub points: u32,
    /// None if the shot was good.
    pub fault: Option<ShotFault>,
    /// Balls that a run still has to pot; empty if the attempt is over.
    pub left: Vec<String>,
}

impl ShotVerdict {
    const fn ended(points: u32, fault: Option<ShotFault>) -> Self {
        Self { points, fault, left: Vec::new() }
    }
}

/// Judges a shot that was played. `left` are the balls that a run still has to pot before it.
///
/// # Errors
/// [`Error::Input`] if the shot has no cue ball, or lacks a ball that the goal names.
pub fn judge(
    shot: &Shot,
    played: &Played,
    goal: &DrillGoal,
    left: &[String],
) -> Result<ShotVerdict, Error> {
    let met = Met::of(shot, played)?;
    if met.is_cue_ball_lost() {
        let points = match goal {
            DrillGoal::Run { balls, .. } => balls.len().saturating_sub(left.len()),
            DrillGoal::Shot { .. } => 0,
        };
        return Ok(ShotVerdict::ended(points as u32, Some(ShotFault::Scratch)));
    }
    match goal {
        DrillGoal::Shot { needs, points, zones } => one(&met, needs, *points, zones),
        DrillGoal::Run { balls, order } => run(shot, played, balls, *order, left),
    }
}

fn one(
    met: &Met<'_>,
    needs: &[DrillCondition],
    points: u32,
    zones: &[Zone],
) -> Result<ShotVerdict, Error> {
    if let Some((index, outside)) = met.first_unmet(needs)? {
        let fault = ShotFault::Need(index, outside.unwrap_or(0.0));
        return Ok(ShotVerdict::ended(0, Some(fault)));
    }
    let Some(largest) = zones.last() else { return Ok(ShotVerdict::ended(points, None)) };
    let zone = zones.iter().find(|zone| met.cue_ball_outside(&zone.area) == 0.0);
    Ok(zone.map_or_else(
        || ShotVerdict::ended(0, Some(ShotFault::Zone(met.cue_ball_outside(&largest.area)))),
        |zone| ShotVerdict::ended(zone.points, None),
    ))
}

fn run(
    shot: &Shot,
    played: &Played,
    balls: &[String],
    order: RunOrder,
    left: &[String],
) -> Result<ShotVerdict, Error> {
    let outcome = &played.outcome;
    let Some(last) = balls.last() else { return Ok(ShotVerdict::ended(0, None)) };
    let ends =
        |fault| Ok(ShotVerdict::ended(balls.len().saturating_sub(left.len()) as u32, Some(fault)));
    let mut may_be_met: Vec<&String> = match order {
        RunOrder::Eight => left.iter().filter(|ball| *ball != last).collect(),
        _ => left.iter().take(1).collect(),
    };
    if may_be_met.is_empty() {
        may_be_met.push(last);
    }
    let id = |ball: &u16| &shot.balls()[usize::from(*ball)].id;
    let met = outcome.first_contact.as_ref().map(id);
    if !met.is_some_and(|met| may_be_met.contains(&met)) {
        return ends(ShotFault::WrongFirst(may_be_met[0].clone()));
    }
    if let Some(off) = outcome.off_table.first() {
        return ends(ShotFault::WrongBall(id(off).clone()));
    }
    let fell: Vec<&String> = outcome.pocketed.iter().map(|(ball, _)| id(ball)).collect();
    let is_wrong = |ball: &&&String| match order {
        RunOrder::Sequence => **ball != may_be_met[0],
        RunOrder::Eight => **ball == last && left.iter().any(|one| !fell.contains(&one)),
        RunOrder::Rotation => false,
    };
    if let Some(wrong) = fell.iter().find(is_wrong) {
        return ends(ShotFault::WrongBall((*wrong).clone()));
    }
    if fell.is_empty() {
        return ends(ShotFault::NoPot);
    }
    let wins = order == RunOrder::Rotation && fell.contains(&last);
    let remains = |ball: &&String| !wins && !fell.contains(ball);
    let remaining: Vec<String> = left.iter().filter(remains).cloned().collect();
    let points = balls.len().saturating_sub(remaining.len()) as u32;
    Ok(ShotVerdict { points, fault: None, left: remaining })
}

impl ShotVerdict {
    /// The plain values: `points`, `fault` (null if the shot was good) and `left`. A fault has its `kind`
    /// (`scratch`, `need`, `zone`, `wrong-first`, `no-pot`, `wrong-ball`) and, where it has them, the `index` of the
    /// condition, the `distance` outside an area in m, and the `ball`.
    pub fn to_node(&self) -> Node {
        let fault = self.fault.as_ref().map_or(Node::Null, ShotFault::to_node);
        let points = ("points", self.points.into());
        Node::object([points, ("fault", fault), ("left", Node::list(&self.left))])
    }
}

impl ShotFault {
    fn to_node(&self) -> Node {
        let kind = |kind: &str| ("kind", Node::from(kind));
        match self {
            Self::Scratch => Node::object([kind("scratch")]),
            Self::NoPot => Node::object([kind("no-pot")]),
            Self::Need(index, distance) => Node::object([
                kind("need"),
                ("index", (*index as f64).into()),
                ("distance", (*distance).into()),
            ]),
            Self::Zone(distance) => Node::object([kind("zone"), ("distance", (*distance).into())]),
            Self::WrongFirst(ball) => Node::object([kind("wrong-first"), ("ball", ball.into())]),
            Self::WrongBall(ball) => Node::object([kind("wrong-ball"), ("ball", ball.into())]),
        }
    }
}
