//! `carom_player`: a player that thinks, and the stop that ends it.

use std::ffi::c_char;
use std::sync::atomic::{AtomicBool, Ordering};

use carom::format::{Node, Reader};
use carom::{Error, ErrorKind, Noise};
use carom_arena::{BuiltInPlayer, ThinkingTime};
use carom_mind::{Answer, Budget, Decision, Situation, Spent};
use carom_rules::ErrorSeeds;

use crate::entry::{ErrorText, enter, given, optional_text, runner, text};
use crate::frame::carom_frame;
use crate::frame_state::choice_number;
use crate::kinds::CAROM_NONE;
use crate::play::{carom_default_play_def, carom_play};

/// The decision is a play.
pub const CAROM_DECIDES_PLAY: i32 = 0;
/// The decision is a choice.
pub const CAROM_DECIDES_CHOICE: i32 = 1;
/// The decision is to concede.
pub const CAROM_DECIDES_CONCEDE: i32 = 2;

/// The simulated shots of a decision without another limit.
const USUAL_SIMULATIONS: u64 = 20_000;

/// The simulated shots of a decision that time or rounds limit: with more, a search would not end in
/// any case.
const MOST_SIMULATIONS: u64 = u64::MAX;

/// A built-in player; immutable. Any number of threads may use it at once.
pub struct carom_player(BuiltInPlayer);

/// A signal that ends decisions. Any number of threads may use it at once.
#[derive(Default)]
pub struct carom_stop(AtomicBool);

/// What a player may spend on a decision, and the errors of the strikes. All zero: 20 000 simulated
/// shots or the number in the player's name, and the errors of the Computational Olympiad.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_think_def {
    /// Errors of the player's strikes: the name of a level such as "club", or JSON; null for those of
    /// the player's level, or else the Olympiad's.
    pub noise: *const c_char,
    /// Errors of the opponent's strikes; null for those of the player.
    pub opponent_noise: *const c_char,
    /// Ends the decision after its present round when it is set; null for none.
    pub stop: *const carom_stop,
    /// Time of the decision, s; 0 for no limit.
    pub time: f64,
    /// Seed of the random numbers.
    pub seed: u64,
    /// Largest number of simulated shots; 0 for the default, or for none with a time or with rounds.
    pub simulations: u64,
    /// Largest number of rounds of the search; 0 for no limit.
    pub rounds: u32,
    /// Number of threads; 0 for one on each core. The decision does not depend on it.
    pub threads: i32,
}

/// A player's decision.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_decision {
    /// The play, of CAROM_DECIDES_PLAY.
    pub play: carom_play,
    /// Probability with which the player expects to win the frame; NaN for players that do not
    /// estimate it.
    pub win_chance: f64,
    /// Number of simulated shots.
    pub simulations: u64,
    /// Number of completed rounds. A decision with the same number of rounds is the same.
    pub rounds: u32,
    /// CAROM_DECIDES_PLAY to CAROM_DECIDES_CONCEDE.
    pub kind: i32,
    /// The choice, of CAROM_DECIDES_CHOICE; else CAROM_NONE.
    pub choice: i32,
    /// 1 if the stop ended the decision.
    pub stopped: i32,
}

impl carom_think_def {
    /// The budget's number of simulated shots.
    fn simulations(&self, player: &BuiltInPlayer) -> u64 {
        if self.simulations > 0 {
            return self.simulations;
        }
        let named = player.simulations().map(u64::from);
        let is_limited = self.time > 0.0 || self.rounds > 0;
        named.unwrap_or(if is_limited { MOST_SIMULATIONS } else { USUAL_SIMULATIONS })
    }

    /// Rejects a time below 0 or not finite.
    fn check(&self) -> Result<(), Error> {
        if self.time >= 0.0 && self.time.is_finite() {
            return Ok(());
        }
        let what = format!("{} s is out of range", self.time);
        Err(ErrorKind::OutOfRange.at("def.time", what, "write a time above 0, or 0 for no limit"))
    }

    /// The errors of player and opponent.
    ///
    /// # Safety
    /// The texts are null or end in a zero.
    unsafe fn noise(&self, player: &BuiltInPlayer) -> Result<[Noise; 2], Error> {
        // SAFETY: the caller's promise.
        let [own, other] = unsafe {
            [
                optional_text(self.noise, "def.noise")?,
                optional_text(self.opponent_noise, "def.opponent_noise")?,
            ]
        };
        let usual = || player.noise().unwrap_or_else(|| Noise::olympiad(1.0));
        let own = own.map_or_else(|| Ok(usual()), read_noise)?;
        let other = other.map_or_else(|| Ok(own.clone()), read_noise)?;
        Ok([own, other])
    }
}

/// A noise by the name of a level, or as JSON.
fn read_noise(text: &str) -> Result<Noise, Error> {
    if text.trim_start().starts_with('{') {
        return Noise::read(&Reader::new(&Node::from_json(text)?, "noise"));
    }
    Noise::preset(text).ok_or_else(|| {
        let what = format!("there is no level \"{text}\"");
        let names = carom::noise::SKILLS.iter().map(|skill| skill.0).chain(["olympiad"]);
        let remedy = format!("write one of {}", names.collect::<Vec<_>>().join(", "));
        ErrorKind::UnknownName.at("noise", what, remedy).with("name", text)
    })
}

/// A budget with default values.
///
/// Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_default_think_def() -> carom_think_def {
    carom_think_def {
        noise: std::ptr::null(),
        opponent_noise: std::ptr::null(),
        stop: std::ptr::null(),
        time: 0.0,
        seed: 0,
        simulations: 0,
        rounds: 0,
        threads: 0,
    }
}

/// Makes a player.
///
/// name: "carom", a level such as "level-3", or a player of the literature; a number of simulated shots
/// may follow, as in "carom:2000". Null stands for "carom".
/// Returns the player, or null with the text of the error.
/// Ownership: free it with carom_player_free. Threads: any.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_player_new(
    name: *const c_char,
    error: *mut c_char,
    error_size: i32,
) -> Option<Box<carom_player>> {
    // SAFETY: the caller's promises in the header.
    unsafe {
        enter(&ErrorText::new(error, error_size), || {
            let name = optional_text(name, "name")?.unwrap_or("carom");
            Ok(Some(Box::new(carom_player(BuiltInPlayer::read(name)?))))
        })
    }
}

/// Lets a player think about the request of a frame, and writes its answer into out.
///
/// def: null stands for a budget with default values. The frame stays as it is.
/// Returns 0, or a negative number with the text of the error.
/// Threads: any, while none changes the frame. The call lasts as long as the budget; another thread may
/// end it with carom_stop_set. Players of the literature have one round, which nothing ends.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_player_decide(
    player: Option<&carom_player>,
    frame: Option<&carom_frame>,
    def: Option<&carom_think_def>,
    out: Option<&mut carom_decision>,
    error: *mut c_char,
    error_size: i32,
) -> i32 {
    // SAFETY: the caller's promises in the header.
    unsafe {
        enter(&ErrorText::new(error, error_size), || {
            let (of, frame) = (&given(player, "player")?.0, given(frame, "frame")?.history.frame());
            let (def, out) =
                (def.copied().unwrap_or_else(|| carom_default_think_def()), given(out, "out")?);
            def.check()?;
            let mut noise = def.noise(of)?;
            if frame.player() == Some(1) {
                noise.reverse();
            }
            let stop = def.stop.as_ref();
            let is_stopped = || stop.is_some_and(|stop| stop.0.load(Ordering::Relaxed));
            let time = (def.time > 0.0).then(|| ThinkingTime::begin(def.time));
            let is_over =
                |_: Spent| is_stopped() || time.as_ref().is_some_and(ThinkingTime::is_over);
            let budget = Budget {
                simulations: def.simulations(of),
                rounds: (def.rounds > 0).then_some(def.rounds),
                is_over: &is_over,
                runner: runner(def.threads)?,
            };
            of.check_budget(&budget)?;
            let [own, other] = noise;
            let mut situation = Situation::new(frame, own, def.seed);
            situation.noise[1] = other;
            let decided = of.make()?.decide(&situation, &budget)?;
            *out = carom_decision::new(frame, &decided, is_stopped());
            Ok(0)
        })
    }
}

impl carom_decision {
    fn new(frame: &carom_rules::Frame, decision: &Decision, is_stopped: bool) -> Self {
        let (kind, play, choice) = match decision.answer {
            Answer::Play(play) => (CAROM_DECIDES_PLAY, Some(play), CAROM_NONE),
            Answer::Choice(choice) => (CAROM_DECIDES_CHOICE, None, choice_number(choice)),
            Answer::Concede => (CAROM_DECIDES_CONCEDE, None, CAROM_NONE),
        };
        Self {
            play: play
                .map_or_else(|| carom_default_play_def(), |play| carom_play::new(frame, &play)),
            win_chance: decision.win_chance.unwrap_or(f64::NAN),
            simulations: decision.spent.simulations,
            rounds: decision.spent.rounds,
            kind,
            choice,
            stopped: is_stopped.into(),
        }
    }
}

/// The play that comes out when a player with errors intends one, written into out.
///
/// noise: the name of a level, or JSON. seed: that of the frame's errors; each shot has its own.
/// Returns 0, or a negative number with the text of the error.
/// A noise with cling is refused: a carom_play has no place for it.
/// Threads: any, while none changes the frame.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_frame_draw(
    frame: Option<&carom_frame>,
    play: Option<&carom_play>,
    noise: *const c_char,
    seed: u64,
    out: Option<&mut carom_play>,
    error: *mut c_char,
    error_size: i32,
) -> i32 {
    // SAFETY: the caller's promises in the header.
    unsafe {
        enter(&ErrorText::new(error, error_size), || {
            let (frame, play) = (given(frame, "frame")?.history.frame(), given(play, "play")?);
            let (noise, out) = (read_noise(text(noise, "noise")?)?, given(out, "out")?);
            if noise.cling_probability > 0.0 {
                let what = "balls that cling are not supported here";
                return Err(ErrorKind::Unsupported.at("noise.cling_probability", what, "write 0"));
            }
            let drawn = frame.draw_play(&play.play(frame)?, &noise, ErrorSeeds::Frame(seed))?;
            *out = carom_play::new(frame, &drawn);
            Ok(0)
        })
    }
}

/// Makes a signal that ends decisions, not set.
///
/// Ownership: free it with carom_stop_free, after the decisions that use it. Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_stop_new() -> Option<Box<carom_stop>> {
    enter(&ErrorText::NONE, || Ok(Some(Box::default())))
}

/// Sets a signal (set is not 0) or takes it back (0). Null is passed over.
///
/// Threads: any, also while a decision uses the signal.
#[unsafe(no_mangle)]
pub extern "C" fn carom_stop_set(stop: Option<&carom_stop>, set: i32) {
    enter(&ErrorText::NONE, || {
        if let Some(stop) = stop {
            stop.0.store(set != 0, Ordering::Relaxed);
        }
        Ok(())
    });
}

/// Frees a signal; null is passed over.
///
/// Ownership: the pointer must not be used afterwards. Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_stop_free(stop: Option<Box<carom_stop>>) {
    enter(&ErrorText::NONE, || {
        drop(stop);
        Ok(())
    });
}

/// Frees a player; null is passed over.
///
/// Ownership: the pointer must not be used afterwards. Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_player_free(player: Option<Box<carom_player>>) {
    enter(&ErrorText::NONE, || {
        drop(player);
        Ok(())
    });
}
