//! The kinds of errors: stable names, for programs.

use alloc::boxed::Box;
use alloc::string::String;
use alloc::vec::Vec;

use super::{Error, InputError};

/// Declares [`ErrorKind`] with the name of each kind, the keys of its details, and its sentence.
macro_rules! kinds {
    ($($kind:ident $name:literal [$($detail:literal),*] $sentence:literal)+) => {
        /// What kind of error it is. A kind keeps its name from version to version; the words of an
        /// error may change.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum ErrorKind {
            $(#[doc = $sentence] $kind,)+
        }

        impl ErrorKind {
            /// Every kind.
            pub const ALL: &[Self] = &[$(Self::$kind),+];

            /// The name of the kind in Python, JavaScript and JSON.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$kind => $name,)+ }
            }

            /// What an error of this kind says.
            pub const fn sentence(self) -> &'static str {
                match self { $(Self::$kind => $sentence,)+ }
            }

            /// The keys that the details of an error of this kind can have.
            pub const fn details(self) -> &'static [&'static str] {
                match self { $(Self::$kind => &[$($detail),*],)+ }
            }
        }
    };
}

kinds! {
    // Texts, files and values.
    Syntax "syntax" ["line", "column"] "A text is not JSON, or does not have the form that is needed."
    Format "format" [] "A file is of another format, or of another version of it."
    Missing "missing" [] "A value that is needed is missing or null."
    UnknownKey "unknown-key" [] "A key does not exist; it is the last part of the place."
    WrongType "wrong-type" [] "A value is of a wrong type, such as a text in place of a number."
    UnknownName "unknown-name" ["name"] "There is nothing with this name: preset, game, pocket, player or setting."
    UnknownBall "unknown-ball" ["ball"] "There is no ball with this id or index."
    OutOfRange "out-of-range" ["value", "low", "high", "open", "unit"] "A number, or a group of numbers, is not finite or out of its range."
    WrongCount "wrong-count" ["count"] "A list, an array or another group has a wrong length or shape."
    Duplicate "duplicate" [] "A value is given twice."
    Conflict "conflict" [] "A value excludes another one, or has no meaning beside it."
    Mismatch "mismatch" [] "Two inputs do not belong together."
    Changed "changed" [] "A record has other results or another hash than the engine computes."
    WrongTable "wrong-table" [] "A description does not make a table."
    // Circumstances.
    Unsupported "unsupported" [] "The table, the game, the player or this build cannot do it."
    WrongState "wrong-state" [] "It cannot be asked at this time, or of this frame."
    Busy "busy" [] "Another program or thread is using it."
    Stopped "stopped" [] "The work was stopped, or came too late."
    System "system" [] "The operating system refuses threads, memory, random numbers or a stream."
    // Balls and strikes.
    BallCount "ball-count" ["count"] "A shot has no balls, or too many."
    DuplicateId "duplicate-id" ["id"] "Two balls have the same id."
    Overlap "overlap" ["ball", "other", "depth"] "Two balls overlap; the depth is in m."
    InCushion "in-cushion" ["rail", "part", "depth"] "A ball is inside a cushion; the depth is in m."
    OverPocket "over-pocket" ["pocket"] "A ball stands over a pocket's hole."
    OutsideTable "outside-table" [] "A ball is outside the table, or beyond its rails."
    InSlate "in-slate" [] "A ball is inside the slate."
    WrongRadius "wrong-radius" [] "A ball of this radius does not suit the table."
    NoRoom "no-room" [] "There is no room for this number of balls."
    Moving "moving" ["ball"] "A ball moves that must be at rest."
    NotOnCloth "not-on-cloth" ["ball"] "A ball is in the air that must lie on the cloth."
    NoStrike "no-strike" [] "The shot has no strike."
    MissesBall "misses-ball" [] "The tip would miss the ball."
    Miscue "miscue" [] "The tip would slip off the ball."
    Unreachable "unreachable" [] "The tip's efficiency is too low for a strike so far off centre."
    CueObstructed "cue-obstructed" ["ball", "rail", "least_elevation_deg"] "The cue would pass through a ball or a rail."
    TooManyEvents "too-many-events" [] "The shot was stopped at its cap of events."
    EndlessMotion "endless-motion" [] "The shot was stopped at its cap of events, and no friction stops its balls."
    NoPlay "no-play" [] "No strike can be played from this position."
    // Rules.
    FrameOver "frame-over" [] "The frame is over."
    NotAMove "not-a-move" [] "It is not a play, a choice or a concession."
    NotAChoice "not-a-choice" ["choice"] "The frame does not offer this choice."
    NoCall "no-call" [] "The shot must be called."
    NoNomination "no-nomination" [] "A ball must be nominated."
    NotCalled "not-called" [] "This shot is not called."
    CalledBallDown "called-ball-down" [] "The called ball is not on the table."
    NoSafety "no-safety" [] "A safety is not called in this shot."
    NoPushOut "no-push-out" [] "A push-out is not allowed in this shot."
    WrongNomination "wrong-nomination" [] "That ball cannot be nominated."
    NotInHand "not-in-hand" [] "The cue ball is not in hand."
    NoPlace "no-place" [] "The cue ball is in hand and has no place."
    OutsideRegion "outside-region" ["region"] "The cue ball is not where it may be put: anywhere on the table, behind-head-string or the-d."
    TouchesBall "touches-ball" [] "The cue ball would touch another ball."
}

/// Longest place and fault of an error, characters. Only keys and words of a file that they repeat
/// make them longer.
const LONGEST: usize = 1000;

/// The start of a text, with `…` if it is longer than [`LONGEST`].
fn clipped(mut text: String) -> String {
    if let Some((end, _)) = text.char_indices().nth(LONGEST) {
        text.truncate(end);
        text.push('…');
    }
    text
}

impl ErrorKind {
    /// Bad input of this kind at `place`: `what` is wrong, `remedy` says what to do.
    pub fn at(
        self,
        place: impl Into<String>,
        what: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Error {
        Error::Input(Box::new(InputError {
            kind: self,
            place: clipped(place.into()),
            what: clipped(what.into()),
            remedy: remedy.into(),
            details: Vec::new(),
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::ErrorKind;

    #[test]
    fn every_kind_has_its_own_name_of_words_and_hyphens() {
        for (i, kind) in ErrorKind::ALL.iter().enumerate() {
            let name = kind.name();
            assert!(name.bytes().all(|byte| byte.is_ascii_lowercase() || byte == b'-'), "{name}");
            assert!(ErrorKind::ALL[..i].iter().all(|other| other.name() != name), "{name}");
            assert!(kind.sentence().ends_with('.'), "{name}");
        }
    }
}
