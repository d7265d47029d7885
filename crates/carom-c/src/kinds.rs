//! The numbers of kinds: motions, events, rails, parts of cushions, pockets. Each has its name in
//! traces.

use carom::table::{Part, PocketName, Rail};
use carom::trace::TraceEventKind;

/// No rail, no pocket, no ball, no player.
pub const CAROM_NONE: i32 = -1;

/// At rest on the cloth.
pub const CAROM_STATIONARY: i32 = 0;
/// Spinning about the vertical without moving.
pub const CAROM_SPINNING: i32 = 1;
/// Rolling without slip.
pub const CAROM_ROLLING: i32 = 2;
/// Sliding on the cloth.
pub const CAROM_SLIDING: i32 = 3;
/// In the air.
pub const CAROM_AIRBORNE: i32 = 4;
/// In a pocket.
pub const CAROM_POCKETED: i32 = 5;
/// Off the table.
pub const CAROM_OFF_TABLE: i32 = 6;

/// The cue meets the cue ball.
pub const CAROM_CUE_STRIKE: i32 = 0;
/// Two balls collide, or several in one contact.
pub const CAROM_BALL_COLLISION: i32 = 1;
/// A ball meets a cushion.
pub const CAROM_RAIL_COLLISION: i32 = 2;
/// A ball falls into a pocket.
pub const CAROM_POCKET_COLLISION: i32 = 3;
/// A ball bounces on the slate.
pub const CAROM_SLATE_COLLISION: i32 = 4;
/// A ball leaves the table.
pub const CAROM_LEFT_TABLE: i32 = 5;
/// A motion ends by the passage of time.
pub const CAROM_MOTION_TRANSITION: i32 = 6;

/// y = 0.
pub const CAROM_BOTTOM: i32 = 0;
/// y = length.
pub const CAROM_TOP: i32 = 1;
/// x = 0, of a table without side pockets.
pub const CAROM_LEFT: i32 = 2;
/// x = width, of a table without side pockets.
pub const CAROM_RIGHT: i32 = 3;
/// x = 0, below the side pocket.
pub const CAROM_LEFT_LOWER: i32 = 4;
/// x = 0, above the side pocket.
pub const CAROM_LEFT_UPPER: i32 = 5;
/// x = width, below the side pocket.
pub const CAROM_RIGHT_LOWER: i32 = 6;
/// x = width, above the side pocket.
pub const CAROM_RIGHT_UPPER: i32 = 7;

/// The straight nose of a cushion.
pub const CAROM_NOSE: i32 = 0;
/// The straight side of a pocket's jaw.
pub const CAROM_FACING: i32 = 1;
/// The rounded corner between nose and facing.
pub const CAROM_POINT: i32 = 2;
/// The top of a rail.
pub const CAROM_RAIL_TOP: i32 = 3;
/// The wall of a pocket.
pub const CAROM_LINER: i32 = 4;

/// A shot ended with every ball at rest.
pub const CAROM_END_REST: i32 = 0;
/// A shot ended at its end time.
pub const CAROM_END_UNTIL: i32 = 1;
/// A shot ended at its cap of events.
pub const CAROM_END_CAP: i32 = 2;

pub(crate) const fn event_kind(kind: TraceEventKind) -> i32 {
    match kind {
        TraceEventKind::CueStrike { .. } => CAROM_CUE_STRIKE,
        TraceEventKind::BallCollision => CAROM_BALL_COLLISION,
        TraceEventKind::RailCollision { .. } => CAROM_RAIL_COLLISION,
        TraceEventKind::PocketCollision(_) => CAROM_POCKET_COLLISION,
        TraceEventKind::SlateCollision => CAROM_SLATE_COLLISION,
        TraceEventKind::OffTable => CAROM_LEFT_TABLE,
        TraceEventKind::MotionTransition { .. } => CAROM_MOTION_TRANSITION,
    }
}

pub(crate) const fn rail(rail: Rail) -> i32 {
    match rail {
        Rail::Bottom => CAROM_BOTTOM,
        Rail::Top => CAROM_TOP,
        Rail::Left => CAROM_LEFT,
        Rail::Right => CAROM_RIGHT,
        Rail::LeftLower => CAROM_LEFT_LOWER,
        Rail::LeftUpper => CAROM_LEFT_UPPER,
        Rail::RightLower => CAROM_RIGHT_LOWER,
        Rail::RightUpper => CAROM_RIGHT_UPPER,
    }
}

pub(crate) const fn part(part: Part) -> i32 {
    match part {
        Part::Nose => CAROM_NOSE,
        Part::Facing => CAROM_FACING,
        Part::Point => CAROM_POINT,
        Part::Top => CAROM_RAIL_TOP,
        Part::Liner => CAROM_LINER,
    }
}

/// The index of the pocket on `table`; −1 if it has none of this name.
pub(crate) fn pocket(table: &carom::Table, name: PocketName) -> i32 {
    table.pockets.iter().position(|pocket| pocket.name == name).map_or(CAROM_NONE, |i| i as i32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom::MotionState;

    #[test]
    fn motions_have_the_numbers_of_the_engine() {
        let here = [
            CAROM_STATIONARY,
            CAROM_SPINNING,
            CAROM_ROLLING,
            CAROM_SLIDING,
            CAROM_AIRBORNE,
            CAROM_POCKETED,
            CAROM_OFF_TABLE,
        ];
        assert_eq!(MotionState::ALL.map(|motion| motion as i32), here);
    }
}
