//! The balls that a turn asks for: which may be hit first, which are worth potting, and the calls.

use carom::table::PocketName;
use carom_rules::games::eight_ball::{EIGHT, Group};
use carom_rules::{BallIndex, BallList, Call, Frame, Objective, Seat, Turn};

/// The balls that a turn asks for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Targets {
    /// The cue ball.
    pub cue: BallIndex,
    /// The balls that the cue ball may hit first.
    pub first: BallList,
    /// The balls that the player may pot to continue.
    pub objects: BallList,
}

impl Targets {
    /// The balls that `turn` of `frame` asks for.
    pub fn of(frame: &Frame, turn: &Turn) -> Self {
        let others = || frame.layout().on_table().filter(|ball| *ball != turn.cue);
        let first = if turn.on.is_empty() { others().collect() } else { turn.on };
        let objects = match frame.facts().objective {
            // Any ball may follow the lowest into a pocket.
            Objective::LowestFirst => others().collect(),
            Objective::Caroms { .. } => BallList::new(),
            Objective::AnyBall | Objective::Groups | Objective::RedsAndColors => first,
        };
        Self { cue: turn.cue, first, objects }
    }
}

/// The call with which a shot that is to pot `object` into `pocket`, after a hit of `first`, is
/// played in this turn.
pub fn call_of(turn: &Turn, first: BallIndex, pot: Option<(BallIndex, PocketName)>) -> Call {
    match pot {
        _ if turn.calls.nominate => Call::On(first),
        Some((object, pocket)) if turn.calls.pocket => Call::Pocket(object, pocket),
        None if turn.calls.safety => Call::Safety,
        _ => Call::Nothing,
    }
}

/// Number of balls that `seat` still has to pot to win the rack: in eight-ball its group and the
/// eight, on an open table the smaller number; in other games all object balls.
pub fn balls_left(frame: &Frame, seat: Seat) -> usize {
    let layout = frame.layout();
    let left =
        |group: Group| layout.on_table().filter(|ball| Group::of(*ball) == Some(group)).count();
    match frame.facts().objective {
        Objective::Groups => {
            let group = match frame.group(seat) {
                Some(group) => left(group),
                None => left(Group::Solids).min(left(Group::Stripes)),
            };
            group + usize::from(!layout.is_down(EIGHT))
        }
        Objective::Caroms { .. } => 0,
        Objective::AnyBall | Objective::LowestFirst | Objective::RedsAndColors => {
            layout.on_table().filter(|ball| *ball != 0).count()
        }
    }
}
