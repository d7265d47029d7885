//! `carom_frame`: a game with a referee.

use std::ffi::{CString, c_char};

use carom::Error;
use carom::format::Node;
use carom::rack::Game;
use carom_rules::{Choice, FrameHistory, Options, Request, Ruling};

use crate::entry::{
    ErrorText, c_text, enter, flag, given, index, name_or_object, optional_text, text, to_c,
};
use crate::frame_state::{carom_request, carom_ruling};
use crate::play::carom_play;
use crate::shot::carom_shot;
use crate::trace::carom_trace;

/// A game in progress, with its history. One thread uses it at a time; functions that only read it may
/// run on several threads at once.
pub struct carom_frame {
    pub(crate) history: FrameHistory,
    ids: Vec<CString>,
    ruling: Option<Node>,
}

/// What a frame starts with. All zero: nine-ball with the usual options.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_frame_def {
    /// The game's name; null for "nine-ball".
    pub game: *const c_char,
    /// The name of a preset, or an object as JSON; null for the game's own table.
    pub table: *const c_char,
    /// The name of a preset, or an object as JSON; null for the physics of the table.
    pub physics: *const c_char,
    /// Seed of the racks.
    pub seed: u64,
    /// Points that win, in games with a target; 0 for the default.
    pub points: i32,
    /// Not 0: no foul and a miss is called in snooker.
    pub no_miss: i32,
    /// Shots in a row without progress that make a stalemate; 0 for the default.
    pub patience: u32,
}

impl carom_frame_def {
    fn options(&self) -> Options {
        let usual = Options::default();
        Options {
            points: if self.points == 0 { usual.points } else { self.points },
            miss: !flag(self.no_miss),
            patience: if self.patience == 0 { usual.patience } else { self.patience },
        }
    }

    /// # Safety
    /// The texts are null or end in a zero.
    unsafe fn game(&self) -> Result<Game, Error> {
        // SAFETY: the caller's promise.
        Game::read(unsafe { optional_text(self.game, "def.game") }?.unwrap_or("nine-ball"))
    }
}

impl carom_frame {
    fn boxed(history: FrameHistory) -> Result<Option<Box<Self>>, Error> {
        let balls = history.frame().layout().balls();
        let ids = balls.iter().map(|ball| c_text(ball.id.clone())).collect::<Result<_, _>>()?;
        Ok(Some(Box::new(Self { history, ids, ruling: None })))
    }

    fn ruled(&mut self, ruling: &Ruling, out: Option<&mut carom_ruling>) {
        self.ruling = Some(self.history.frame().ruling_node(ruling));
        if let Some(out) = out {
            *out = ruling.into();
        }
    }
}

/// A definition of a frame with default values.
///
/// Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_default_frame_def() -> carom_frame_def {
    let null = std::ptr::null();
    carom_frame_def {
        game: null,
        table: null,
        physics: null,
        seed: 0,
        points: 0,
        no_miss: 0,
        patience: 0,
    }
}

/// Racks a new frame.
///
/// def: null stands for a definition with default values.
/// Returns the frame, or null with the text of the error.
/// Ownership: free it with carom_frame_free. What def points to is copied. Threads: any.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_frame_new(
    def: Option<&carom_frame_def>,
    error: *mut c_char,
    error_size: i32,
) -> Option<Box<carom_frame>> {
    // SAFETY: the caller's promises in the header.
    unsafe {
        enter(&ErrorText::new(error, error_size), || {
            let def = def.copied().unwrap_or_else(|| carom_default_frame_def());
            let part = |pointer, place| {
                let given = optional_text(pointer, place)?;
                given.map(|text| name_or_object(text, place)).transpose()
            };
            let (table, physics) = (part(def.table, "table")?, part(def.physics, "physics")?);
            let game = def.game()?;
            let history = FrameHistory::new(game, def.options(), table, physics, def.seed);
            carom_frame::boxed(history?)
        })
    }
}

/// A frame that starts from the balls of a shot, on its table, with its physics. In games in which each
/// player has a cue ball, the player whose cue ball the shot strikes begins; otherwise player 0.
///
/// def: table, physics and seed are not read; null stands for a definition with default values.
/// Returns the frame, or null with the text of the error.
/// Ownership: free it with carom_frame_free; the shot stays. Threads: any.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_frame_of_shot(
    def: Option<&carom_frame_def>,
    shot: Option<&carom_shot>,
    error: *mut c_char,
    error_size: i32,
) -> Option<Box<carom_frame>> {
    // SAFETY: the caller's promises in the header.
    unsafe {
        enter(&ErrorText::new(error, error_size), || {
            let def = def.copied().unwrap_or_else(|| carom_default_frame_def());
            let shot = &given(shot, "shot")?.file;
            carom_frame::boxed(FrameHistory::of_shot(def.game()?, def.options(), shot, None)?)
        })
    }
}

/// The frame of a record, carom-frame/1, with every move repeated: a saved game.
///
/// Returns the frame, or null with the text of the error.
/// Ownership: free it with carom_frame_free. The text is read in the call. Threads: any.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_frame_from_json(
    json: *const c_char,
    error: *mut c_char,
    error_size: i32,
) -> Option<Box<carom_frame>> {
    // SAFETY: the caller's promises in the header.
    unsafe {
        enter(&ErrorText::new(error, error_size), || {
            let record = Node::from_json(text(json, "json")?)?;
            carom_frame::boxed(FrameHistory::replay(&record)?)
        })
    }
}

/// The record of a frame, carom-frame/1: its start and all its moves. Python and JavaScript read it too.
///
/// Returns the text, or null for a null pointer.
/// Ownership: free the text with carom_text_free. Threads: any, while none changes the frame.
#[unsafe(no_mangle)]
pub extern "C" fn carom_frame_to_json(frame: Option<&carom_frame>) -> *mut c_char {
    enter(&ErrorText::NONE, || to_c(given(frame, "frame")?.history.record().to_json()))
}

/// The last move, JSON on one line, as carom_frame_move takes it: what two programs in lockstep send.
///
/// Returns the text, or null before the first move.
/// Ownership: free the text with carom_text_free. Threads: any, while none changes the frame.
#[unsafe(no_mangle)]
pub extern "C" fn carom_frame_last_move_json(frame: Option<&carom_frame>) -> *mut c_char {
    enter(&ErrorText::NONE, || match given(frame, "frame")?.history.moves().last() {
        Some(made) => to_c(made.to_json_line()),
        None => Ok(std::ptr::null_mut()),
    })
}

/// An independent copy of a frame.
///
/// Returns the copy, or null for a null pointer.
/// Ownership: free it with carom_frame_free. Threads: any, while none changes the frame.
#[unsafe(no_mangle)]
pub extern "C" fn carom_frame_copy(frame: Option<&carom_frame>) -> Option<Box<carom_frame>> {
    enter(&ErrorText::NONE, || carom_frame::boxed(given(frame, "frame")?.history.clone()))
}

/// The hash over everything that decides how the frame goes on. The same version of the engine gives
/// the same value in every language and on every platform.
///
/// Returns the hash, or 0 for a null pointer.
/// Threads: any, while none changes the frame.
#[unsafe(no_mangle)]
pub extern "C" fn carom_frame_hash(frame: Option<&carom_frame>) -> u64 {
    enter(&ErrorText::NONE, || Ok(given(frame, "frame")?.history.frame().hash()))
}

/// Game, request, scores and balls of a frame, JSON.
///
/// Returns the text, or null for a null pointer.
/// Ownership: free the text with carom_text_free. Threads: any, while none changes the frame.
#[unsafe(no_mangle)]
pub extern "C" fn carom_frame_state_json(frame: Option<&carom_frame>) -> *mut c_char {
    enter(&ErrorText::NONE, || to_c(given(frame, "frame")?.history.frame().to_node().to_json()))
}

/// The last ruling with its fouls in words and the rules that they break, JSON.
///
/// Returns the text, or null before the first move after the start or the reading of a record.
/// Ownership: free the text with carom_text_free. Threads: any, while none changes the frame.
#[unsafe(no_mangle)]
pub extern "C" fn carom_frame_ruling_json(frame: Option<&carom_frame>) -> *mut c_char {
    enter(&ErrorText::NONE, || match &given(frame, "frame")?.ruling {
        Some(ruling) => to_c(ruling.to_json()),
        None => Ok(std::ptr::null_mut()),
    })
}

/// Writes what the frame asks for into out.
///
/// Returns 0, or a negative number for a null pointer.
/// Threads: any, while none changes the frame.
#[unsafe(no_mangle)]
pub extern "C" fn carom_frame_request(
    frame: Option<&carom_frame>,
    out: Option<&mut carom_request>,
) -> i32 {
    enter(&ErrorText::NONE, || {
        *given(out, "out")? = carom_request::new(given(frame, "frame")?.history.frame().request());
        Ok(0)
    })
}

/// Number of balls of a frame, on the table or not.
///
/// Returns the number, or a negative number for a null pointer.
/// Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_frame_ball_count(frame: Option<&carom_frame>) -> i32 {
    enter(&ErrorText::NONE, || Ok(given(frame, "frame")?.ids.len() as i32))
}

/// The id of ball number ball.
///
/// Returns the id, or null if there is no such ball.
/// Ownership: the text belongs to the frame, and lives as long. Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_frame_ball_id(frame: Option<&carom_frame>, ball: i32) -> *const c_char {
    enter(&ErrorText::NONE, || {
        let ids = &given(frame, "frame")?.ids;
        Ok(ids[index(ball, ids.len(), "ball")?].as_ptr())
    })
}

/// Writes the centre (x and y, m) of ball number ball into out, room for two numbers.
///
/// Returns 1 if the ball is on the table, 0 if it is not; or a negative number if there is no such
/// ball.
/// Threads: any, while none changes the frame.
#[unsafe(no_mangle)]
pub extern "C" fn carom_frame_ball_place(
    frame: Option<&carom_frame>,
    ball: i32,
    out: Option<&mut [f64; 2]>,
) -> i32 {
    enter(&ErrorText::NONE, || {
        let (frame, out) = (given(frame, "frame")?, given(out, "out")?);
        let ball = index(ball, frame.ids.len(), "ball")?;
        let place = frame.history.frame().layout().place(ball as u16);
        *out = place.unwrap_or([f64::NAN; 2]);
        Ok(place.is_some().into())
    })
}

/// The shot that a play would be, to draw or to simulate; the frame stays as it is.
///
/// Returns the shot, or null with the text of the error. Its balls are those on the table, in the order
/// of the frame.
/// Ownership: free it with carom_shot_free. Threads: any, while none changes the frame.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_frame_shot(
    frame: Option<&carom_frame>,
    play: Option<&carom_play>,
    error: *mut c_char,
    error_size: i32,
) -> Option<Box<carom_shot>> {
    // SAFETY: the caller's promises in the header.
    unsafe {
        enter(&ErrorText::new(error, error_size), || {
            let (frame, play) = (given(frame, "frame")?.history.frame(), given(play, "play")?);
            carom_shot::boxed(frame.shot(&play.play(frame)?)?)
        })
    }
}

/// Plays a shot, and rules on it.
///
/// ruling and trace may be null. A trace that is wanted is written into trace; null on failure.
/// Returns 0, or a negative number with the text of the error; the frame stays as it was then.
/// Ownership: free the trace with carom_trace_free. Threads: one at a time for each frame.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_frame_play(
    frame: Option<&mut carom_frame>,
    play: Option<&carom_play>,
    ruling: Option<&mut carom_ruling>,
    mut trace: Option<&mut Option<Box<carom_trace>>>,
    error: *mut c_char,
    error_size: i32,
) -> i32 {
    // SAFETY: the caller's promises in the header.
    unsafe {
        enter(&ErrorText::new(error, error_size), || {
            clear(&mut trace);
            let (frame, play) = (given(frame, "frame")?, given(play, "play")?);
            let play = play.play(frame.history.frame())?;
            let (ruled, played) = frame.history.play(&play)?;
            frame.ruled(&ruled, ruling);
            give(trace, played);
            Ok(0)
        })
    }
}

/// Makes a move in the form of a record, JSON: {"play": {"strike": {...}}}, {"choice": "play-on"} or
/// {"concede": true}.
///
/// ruling and trace may be null. A trace that is wanted is written into trace; null on failure, and
/// for a move that is not a play.
/// Returns 0, or a negative number with the text of the error; the frame stays as it was then.
/// Ownership: free the trace with carom_trace_free. Threads: one at a time for each frame.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_frame_move(
    frame: Option<&mut carom_frame>,
    json: *const c_char,
    ruling: Option<&mut carom_ruling>,
    mut trace: Option<&mut Option<Box<carom_trace>>>,
    error: *mut c_char,
    error_size: i32,
) -> i32 {
    // SAFETY: the caller's promises in the header.
    unsafe {
        enter(&ErrorText::new(error, error_size), || {
            clear(&mut trace);
            let frame = given(frame, "frame")?;
            let (ruled, played) = frame.history.make(&Node::from_json(text(json, "json")?)?)?;
            frame.ruled(&ruled, ruling);
            if let Some(played) = played {
                give(trace, played);
            }
            Ok(0)
        })
    }
}

/// What a caller's variable holds before the call is not an object of ours: it is not freed.
fn clear(trace: &mut Option<&mut Option<Box<carom_trace>>>) {
    if let Some(trace) = trace {
        std::mem::forget(trace.take());
    }
}

fn give(trace: Option<&mut Option<Box<carom_trace>>>, played: carom::Trace) {
    if let Some(trace) = trace {
        let shot = carom::ShotFile::from(played.shot().clone());
        *trace = Some(Box::new(carom_trace::new(played, shot.into())));
    }
}

/// Answers the choice that the frame asks for.
///
/// choice: the choice's number, one of those in carom_request. ruling may be null.
/// Returns 0, or a negative number with the text of the error; the frame stays as it was then.
/// Threads: one at a time for each frame.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_frame_choose(
    frame: Option<&mut carom_frame>,
    choice: i32,
    ruling: Option<&mut carom_ruling>,
    error: *mut c_char,
    error_size: i32,
) -> i32 {
    // SAFETY: the caller's promises in the header.
    unsafe {
        enter(&ErrorText::new(error, error_size), || {
            let frame = given(frame, "frame")?;
            let choice = Choice::ALL[index(choice, Choice::ALL.len(), "choice")?];
            let ruled = frame.history.choose(choice)?;
            frame.ruled(&ruled, ruling);
            Ok(0)
        })
    }
}

/// The player whose turn it is concedes.
///
/// ruling may be null.
/// Returns 0, or a negative number with the text of the error.
/// Threads: one at a time for each frame.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_frame_concede(
    frame: Option<&mut carom_frame>,
    ruling: Option<&mut carom_ruling>,
    error: *mut c_char,
    error_size: i32,
) -> i32 {
    // SAFETY: the caller's promises in the header.
    unsafe {
        enter(&ErrorText::new(error, error_size), || {
            let frame = given(frame, "frame")?;
            let ruled = frame.history.concede()?;
            frame.ruled(&ruled, ruling);
            Ok(0)
        })
    }
}

/// Why the frame asks for a choice, or why it is over, in words.
///
/// Returns the text, or null if the frame asks for a shot.
/// Ownership: free the text with carom_text_free. Threads: any, while none changes the frame.
#[unsafe(no_mangle)]
pub extern "C" fn carom_frame_why(frame: Option<&carom_frame>) -> *mut c_char {
    enter(&ErrorText::NONE, || match given(frame, "frame")?.history.frame().request() {
        Request::Shot(_) => Ok(std::ptr::null_mut()),
        Request::Choice { why, .. } | Request::Over { why, .. } => to_c((*why).into()),
    })
}

/// Frees a frame; null is passed over.
///
/// Ownership: the pointer must not be used afterwards, nor the ids of its balls. Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_frame_free(frame: Option<Box<carom_frame>>) {
    enter(&ErrorText::NONE, || {
        drop(frame);
        Ok(())
    });
}
