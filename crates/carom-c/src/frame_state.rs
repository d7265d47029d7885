//! Requests and rulings of a frame.

use carom_rules::{Choice, MOST_BALLS, Region, Request, Ruling, Seat};

use crate::kinds::CAROM_NONE;

/// The frame asks for a shot.
pub const CAROM_ASKS_SHOT: i32 = 0;
/// The frame asks for a choice.
pub const CAROM_ASKS_CHOICE: i32 = 1;
/// The frame is over.
pub const CAROM_OVER: i32 = 2;

/// The cue ball in hand may be put anywhere on the table.
pub const CAROM_ANYWHERE: i32 = 0;
/// The cue ball in hand may be put behind the head string.
pub const CAROM_BEHIND_HEAD_STRING: i32 = 1;
/// The cue ball in hand may be put in the D.
pub const CAROM_THE_D: i32 = 2;

/// A ball and its pocket may be called.
pub const CAROM_MAY_CALL: i32 = 1;
/// A safety may be called.
pub const CAROM_MAY_CALL_SAFETY: i32 = 2;
/// A ball and its pocket or a safety must be called.
pub const CAROM_MUST_CALL: i32 = 4;
/// A push-out may be announced.
pub const CAROM_MAY_PUSH_OUT: i32 = 8;
/// One of the balls on must be nominated.
pub const CAROM_MUST_NOMINATE: i32 = 16;

/// Shoot, with the balls as they lie.
pub const CAROM_PLAY_ON: i32 = 0;
/// Shoot, with the cue ball in hand behind the head string.
pub const CAROM_PLAY_FROM_HAND: i32 = 1;
/// Let the other player shoot.
pub const CAROM_PASS_BACK: i32 = 2;
/// Rack again, and break.
pub const CAROM_REBREAK: i32 = 3;
/// Rack again, and let the other player break.
pub const CAROM_REBREAK_BY_OTHER: i32 = 4;
/// Spot the eight, and shoot.
pub const CAROM_SPOT_EIGHT: i32 = 5;
/// Put the balls back, and let the other player shoot again.
pub const CAROM_REPLACE: i32 = 6;
/// Spot the cue ball and the balls that touch it, and shoot.
pub const CAROM_SPOT_FROZEN: i32 = 7;
/// Spot the legal ball nearest to the head string, and shoot from behind it.
pub const CAROM_SPOT_NEAREST: i32 = 8;
/// Shoot, with the cue ball in hand anywhere.
pub const CAROM_PLAY_FROM_ANYWHERE: i32 = 9;

/// What a frame asks for.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_request {
    /// CAROM_ASKS_SHOT, CAROM_ASKS_CHOICE or CAROM_OVER.
    pub kind: i32,
    /// Who has to answer, 0 or 1; CAROM_NONE when the frame is over.
    pub player: i32,
    /// Who has won; CAROM_NONE while the frame goes on, and if it ended undecided.
    pub winner: i32,
    /// Of a shot: the cue ball, an index of the frame's balls; else CAROM_NONE.
    pub cue_ball: i32,
    /// Of a shot with the cue ball in hand: CAROM_ANYWHERE to CAROM_THE_D; else CAROM_NONE.
    pub in_hand: i32,
    /// Of a shot: a sum of CAROM_MAY_CALL to CAROM_MUST_NOMINATE.
    pub calls: i32,
    /// Number of balls on.
    pub on_count: i32,
    /// The balls of which one must be hit first, on_count indices; none if any may be.
    pub on: [i32; 22],
    /// Number of choices.
    pub choice_count: i32,
    /// CAROM_PLAY_ON to CAROM_PLAY_FROM_ANYWHERE, choice_count of them.
    pub choices: [i32; 10],
}

/// The referee's ruling on a move.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_ruling {
    /// 1 if there was no foul.
    pub legal: i32,
    /// Number of fouls; carom_frame_ruling_json names them.
    pub foul_count: i32,
    /// Change of each player's score.
    pub points: [i32; 2],
    /// Number of balls that were spotted.
    pub spotted_count: i32,
    /// 1 if balls were racked again.
    pub racked: i32,
}

const _: () = assert!(MOST_BALLS == 22 && Choice::ALL.len() == 10);

fn seat(seat: Option<Seat>) -> i32 {
    seat.map_or(CAROM_NONE, |seat| seat as i32)
}

impl carom_request {
    pub(crate) fn new(request: &Request) -> Self {
        let mut out = Self {
            kind: CAROM_ASKS_SHOT,
            player: CAROM_NONE,
            winner: CAROM_NONE,
            cue_ball: CAROM_NONE,
            in_hand: CAROM_NONE,
            calls: 0,
            on_count: 0,
            on: [CAROM_NONE; MOST_BALLS],
            choice_count: 0,
            choices: [CAROM_NONE; Choice::ALL.len()],
        };
        match request {
            Request::Shot(turn) => {
                (out.player, out.cue_ball) = (seat(Some(turn.player)), turn.cue.into());
                out.in_hand = turn.hand.map_or(CAROM_NONE, |region| match region {
                    Region::Anywhere => CAROM_ANYWHERE,
                    Region::BehindHeadString => CAROM_BEHIND_HEAD_STRING,
                    Region::TheD => CAROM_THE_D,
                });
                let calls = &turn.calls;
                let bits = [
                    (calls.pocket, CAROM_MAY_CALL),
                    (calls.safety, CAROM_MAY_CALL_SAFETY),
                    (calls.required, CAROM_MUST_CALL),
                    (calls.push_out, CAROM_MAY_PUSH_OUT),
                    (calls.nominate, CAROM_MUST_NOMINATE),
                ];
                out.calls = bits.into_iter().filter(|(may, _)| *may).map(|(_, bit)| bit).sum();
                out.on_count = turn.on.len() as i32;
                for (out, ball) in out.on.iter_mut().zip(turn.on.iter()) {
                    *out = (*ball).into();
                }
            }
            Request::Choice { player, choices, .. } => {
                (out.kind, out.player) = (CAROM_ASKS_CHOICE, seat(Some(*player)));
                out.choice_count = choices.len() as i32;
                for (out, choice) in out.choices.iter_mut().zip(choices.iter()) {
                    *out = choice_number(*choice);
                }
            }
            Request::Over { winner, .. } => (out.kind, out.winner) = (CAROM_OVER, seat(*winner)),
        }
        out
    }
}

/// The number of a choice: its place in the list of all choices.
pub(crate) fn choice_number(choice: Choice) -> i32 {
    Choice::ALL.iter().position(|other| *other == choice).map_or(CAROM_NONE, |i| i as i32)
}

impl From<&Ruling> for carom_ruling {
    fn from(ruling: &Ruling) -> Self {
        Self {
            legal: ruling.is_legal().into(),
            foul_count: ruling.fouls.iter().count() as i32,
            points: ruling.points,
            spotted_count: ruling.spotted.len() as i32,
            racked: ruling.racked.into(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn choices_have_the_names_of_their_numbers() {
        for (choice, number, name) in [
            (Choice::PlayOn, CAROM_PLAY_ON, "play-on"),
            (Choice::PlayFromHand, CAROM_PLAY_FROM_HAND, "play-from-hand"),
            (Choice::PassBack, CAROM_PASS_BACK, "pass-back"),
            (Choice::Rebreak, CAROM_REBREAK, "rebreak"),
            (Choice::RebreakByOther, CAROM_REBREAK_BY_OTHER, "rebreak-by-other"),
            (Choice::SpotEight, CAROM_SPOT_EIGHT, "spot-eight"),
            (Choice::Replace, CAROM_REPLACE, "replace"),
            (Choice::SpotFrozen, CAROM_SPOT_FROZEN, "spot-frozen"),
            (Choice::SpotNearest, CAROM_SPOT_NEAREST, "spot-nearest"),
            (Choice::PlayFromAnywhere, CAROM_PLAY_FROM_ANYWHERE, "play-from-anywhere"),
        ] {
            assert_eq!((choice_number(choice), choice.name()), (number, name));
        }
    }
}
