//! Whether a shot meets the goal of a task.

use carom::format::Node;
use carom::{Error, Trace};

use crate::goal::DrillCondition;
use crate::met::Met;
use crate::played::Played;

/// How a shot stands to a goal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TaskVerdict {
    /// It meets every condition.
    Met,
    /// It loses the cue ball: into a pocket or off the table.
    CueBallLost,
    /// It does not meet a condition.
    Missed {
        /// Index of the first one.
        condition: usize,
        /// How far outside its area the ball stopped, m; `None` for other conditions, and for a ball that is
        /// not on the table.
        distance: Option<f64>,
    },
}

impl TaskVerdict {
    /// As JSON and Python have it: `met`, `fault`, and of a missed condition `condition` and `distance`.
    pub fn to_node(self) -> Node {
        let (fault, condition, distance) = match self {
            Self::Met => (Node::Null, Node::Null, Node::Null),
            Self::CueBallLost => ("cue-ball-lost".into(), Node::Null, Node::Null),
            Self::Missed { condition, distance } => {
                let condition = Node::Integer(condition as i64);
                ("condition".into(), condition, distance.map_or(Node::Null, Node::from))
            }
        };
        Node::object([
            ("met", Node::Bool(self == Self::Met)),
            ("fault", fault),
            ("condition", condition),
            ("distance", distance),
        ])
    }
}

/// How a simulated shot stands to a goal about it.
///
/// # Errors
/// [`Error::Input`] if the shot has no strike, or lacks a ball that the goal names.
pub fn judge(trace: &Trace, goal: &[DrillCondition]) -> Result<TaskVerdict, Error> {
    let played = Played::of_trace(trace);
    let met = Met::of(trace.shot(), &played)?;
    if met.is_cue_ball_lost() {
        return Ok(TaskVerdict::CueBallLost);
    }
    let unmet = met.first_unmet(goal)?;
    Ok(unmet.map_or(TaskVerdict::Met, |(condition, distance)| TaskVerdict::Missed {
        condition,
        distance,
    }))
}
