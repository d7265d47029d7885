//! Any sequence of calls of the C interface, with texts, numbers and sizes that no program should send,
//! returns; failures have a text, and no object is lost or freed twice (the address sanitizer looks).
#![no_main]

use std::ffi::{CStr, CString, c_char};
use std::ptr::{from_ref, null, null_mut};

use arbitrary::Arbitrary;
use carom_c::batch::{carom_batch, carom_batch_strikes};
use carom_c::frame::{
    carom_default_frame_def, carom_frame, carom_frame_ball_place, carom_frame_choose,
    carom_frame_concede, carom_frame_free, carom_frame_from_json, carom_frame_hash, carom_frame_move,
    carom_frame_new, carom_frame_play, carom_frame_to_json,
};
use carom_c::play::carom_play;
use carom_c::shot::{
    carom_ball, carom_default_shot_def, carom_shot, carom_shot_ball_count, carom_shot_free,
    carom_shot_from_json, carom_shot_new, carom_shot_to_json, carom_strike,
};
use carom_c::state::carom_state;
use carom_c::table::{carom_table_free, carom_table_new};
use carom_c::text::carom_text_free;
use carom_c::trace::{
    carom_shot_simulate,     carom_trace_events, carom_trace_free, carom_trace_from_json, carom_trace_path,
    carom_trace_state, carom_trace_states, carom_trace_to_json,
};
use libfuzzer_sys::fuzz_target;

/// A strike with any numbers.
#[derive(Arbitrary, Clone, Copy, Debug)]
struct AnyStrike {
    numbers: [f64; 5],
    /// Whether the numbers are brought to where strikes can be played.
    tamed: bool,
    has_elevation: bool,
    policy: i32,
}

#[derive(Arbitrary, Debug)]
enum Call {
    Read(String),
    ReadTrace(String),
    ReadFrame(String),
    Shot { balls: Vec<([f64; 2], bool)>, struck: i32, strike: AnyStrike, until: f64, cap: u32 },
    States { ball: i32, time: f64 },
    Path { ball: i32, tolerance: f64, room: u8 },
    Batch { balls: i8, threads: bool, strikes: Vec<AnyStrike> },
    NewFrame { game: u8, seed: u64, points: i32 },
    Play { strike: AnyStrike, place: Option<[f64; 2]>, call: i32, ball: i32, pocket: i32 },
    Move(String),
    Choose(i32),
    Concede,
}

impl AnyStrike {
    fn strike(self) -> carom_strike {
        let tame = |x: f64, low: f64, high: f64| {
            if self.tamed { low + (high - low) * (x.abs().fract()).clamp(0.0, 1.0) } else { x }
        };
        let [speed, azimuth, elevation, side, height] = self.numbers;
        carom_strike {
            speed: tame(speed, 0.01, 12.0),
            azimuth: tame(azimuth, 0.0, 6.3),
            elevation: tame(elevation, 0.0, 1.2),
            side: tame(side, -0.4, 0.4),
            height: tame(height, -0.4, 0.4),
            has_elevation: self.has_elevation.into(),
            policy: self.policy,
        }
    }
}

/// The text of the last error.
struct ErrorBuffer([c_char; 96]);

impl ErrorBuffer {
    fn check(&self, failed: bool) {
        // SAFETY: the library ends every text in a zero.
        let text = unsafe { CStr::from_ptr(self.0.as_ptr()) }.to_str().expect("UTF-8");
        assert_eq!(failed, text.starts_with('['), "{text}");
        assert!(!text.starts_with("[fault]"), "{text}");
    }
}

/// The objects that the calls share.
#[derive(Default)]
struct Objects {
    shot: Option<Box<carom_shot>>,
    frame: Option<Box<carom_frame>>,
}

fn finish(text: *mut c_char) {
    assert!(!text.is_null());
    // SAFETY: the text belongs to this program.
    unsafe { carom_text_free(text) };
}

impl Objects {
    fn take_shot(&mut self, shot: Option<Box<carom_shot>>, error: &ErrorBuffer) {
        error.check(shot.is_none());
        if let Some(shot) = shot {
            finish(carom_shot_to_json(Some(&shot)));
            carom_shot_free(self.shot.replace(shot));
        }
    }

    fn take_frame(&mut self, frame: Option<Box<carom_frame>>, error: &ErrorBuffer) {
        error.check(frame.is_none());
        if let Some(frame) = frame {
            carom_frame_free(self.frame.replace(frame));
        }
    }

    /// # Safety
    /// None beyond that of the interface: every pointer here is what its type says.
    unsafe fn run(&mut self, call: Call) {
        let mut error = ErrorBuffer([1; 96]);
        let (text, size) = (error.0.as_mut_ptr(), 96);
        unsafe {
            match call {
                Call::Read(json) => {
                    let Ok(json) = CString::new(json) else { return };
                    let shot = carom_shot_from_json(json.as_ptr(), text, size);
                    self.take_shot(shot, &error);
                }
                Call::ReadTrace(json) => {
                    let Ok(json) = CString::new(json) else { return };
                    let trace = carom_trace_from_json(json.as_ptr(), text, size);
                    error.check(trace.is_none());
                    carom_trace_free(trace);
                }
                Call::ReadFrame(json) => {
                    let Ok(json) = CString::new(json) else { return };
                    let frame = carom_frame_from_json(json.as_ptr(), text, size);
                    self.take_frame(frame, &error);
                }
                Call::Shot { balls, struck, strike, until, cap } => {
                    let table = carom_table_new(None, null_mut(), 0);
                    let placed = |&([x, y], tamed): &([f64; 2], bool)| carom_ball {
                        id: null(),
                        position: if tamed {
                            [0.1 + x.abs().fract(), 0.1 + 2.3 * y.abs().fract(), 0.0]
                        } else {
                            [x, y, 0.0]
                        },
                        velocity: [0.0; 3],
                        angular_velocity: [0.0; 3],
                        mass: 0.0,
                        radius: 0.0,
                    };
                    let balls: Vec<carom_ball> = balls.iter().take(22).map(placed).collect();
                    let mut def = carom_default_shot_def();
                    (def.balls, def.ball_count) = (balls.as_ptr(), balls.len() as i32);
                    (def.struck, def.strike, def.until) = (struck, strike.strike(), until);
                    def.max_events = cap % 20_000;
                    let shot = carom_shot_new(table.as_deref(), Some(&def), text, size);
                    carom_table_free(table);
                    self.take_shot(shot, &error);
                }
                Call::States { ball, time } => {
                    let trace = carom_shot_simulate(self.shot.as_deref(), text, size);
                    error.check(trace.is_none());
                    let Some(trace) = trace else { return };
                    let mut states: Vec<carom_state> = Vec::new();
                    let count = carom_shot_ball_count(self.shot.as_deref());
                    states.resize_with(count as usize, || std::mem::zeroed());
                    let all = carom_trace_states(Some(&trace), time, states.as_mut_ptr(), count);
                    assert_eq!(all == 0, time >= 0.0 && time.is_finite());
                    for state in states.iter().filter(|_| all == 0) {
                        assert!(state.position.iter().chain(&state.orientation).all(|x| x.is_finite()));
                    }
                    carom_trace_state(Some(&trace), ball, time, states.first_mut());
                    let mut events = std::mem::zeroed();
                    assert!(carom_trace_events(Some(&trace), Some(&mut events)) >= 0);
                    finish(carom_trace_to_json(Some(&trace)));
                    carom_trace_free(Some(trace));
                }
                Call::Path { ball, tolerance, room } => {
                    let trace = carom_shot_simulate(self.shot.as_deref(), null_mut(), 0);
                    let mut path = vec![0.0; 4 * usize::from(room)];
                    // A finer path of a whole break is a test of patience.
                    let tolerance = if tolerance < 1e-6 { tolerance - 1e-6 } else { tolerance };
                    let room = i32::from(room);
                    carom_trace_path(trace.as_deref(), ball, tolerance, path.as_mut_ptr(), room);
                    carom_trace_free(trace);
                }
                Call::Batch { balls, threads, strikes } => {
                    let n = strikes.len().min(64);
                    let strikes: Vec<carom_strike> =
                        strikes.into_iter().take(n).map(AnyStrike::strike).collect();
                    let width = usize::try_from(balls).unwrap_or_default();
                    let mut position = vec![0.0; 3 * n * width];
                    let (mut pocket, mut events) = (vec![0; n * width], vec![0; n]);
                    let threads = if threads { 2 } else { 1 };
                    carom_batch_strikes(
                        self.shot.as_deref(), strikes.as_ptr(), n, balls.into(), threads,
                        position.as_mut_ptr(), pocket.as_mut_ptr(), events.as_mut_ptr(), text, size,
                    );
                    let shots = [self.shot.as_deref().map_or(null(), from_ref)];
                    carom_batch(
                        shots.as_ptr(), 1, balls.into(), 1, null_mut(), null_mut(), null_mut(), text, size,
                    );
                }
                Call::NewFrame { game, seed, points } => {
                    const GAMES: [&CStr; 6] = [
                        c"eight-ball", c"nine-ball", c"snooker", c"three-cushion", c"straight-pool", c"x",
                    ];
                    let mut def = carom_default_frame_def();
                    def.game = GAMES[usize::from(game) % GAMES.len()].as_ptr();
                    (def.seed, def.points) = (seed, points);
                    let frame = carom_frame_new(Some(&def), text, size);
                    self.take_frame(frame, &error);
                }
                Call::Play { strike, place, call, ball, pocket } => {
                    let play = carom_play {
                        strike: strike.strike(),
                        cue_ball: place.unwrap_or_default(),
                        has_cue_ball: place.is_some().into(),
                        call,
                        call_ball: ball,
                        call_pocket: pocket,
                    };
                    let before = carom_frame_hash(self.frame.as_deref());
                    let frame = self.frame.as_deref_mut();
                    let mut trace = None;
                    let done = carom_frame_play(frame, Some(&play), None, Some(&mut trace), text, size);
                    error.check(done < 0);
                    assert_eq!(trace.is_some(), done == 0);
                    assert!(done == 0 || before == carom_frame_hash(self.frame.as_deref()));
                    carom_trace_free(trace);
                }
                Call::Move(json) => {
                    let Ok(json) = CString::new(json) else { return };
                    let frame = self.frame.as_deref_mut();
                    let done = carom_frame_move(frame, json.as_ptr(), None, None, text, size);
                    error.check(done < 0);
                }
                Call::Choose(choice) => {
                    carom_frame_choose(self.frame.as_deref_mut(), choice, None, text, size);
                    let mut place = [0.0; 2];
                    carom_frame_ball_place(self.frame.as_deref(), choice, Some(&mut place));
                }
                Call::Concede => {
                    let done = carom_frame_concede(self.frame.as_deref_mut(), None, text, size);
                    error.check(done < 0);
                }
            }
        }
    }
}

fuzz_target!(|calls: Vec<Call>| {
    let mut objects = Objects::default();
    for call in calls.into_iter().take(24) {
        // SAFETY: every pointer is what its type says.
        unsafe { objects.run(call) };
    }
    if let Some(frame) = &objects.frame {
        let record = carom_frame_to_json(Some(frame));
        // SAFETY: the record is a text of the library.
        let again = unsafe { carom_frame_from_json(record, null_mut(), 0) };
        assert_eq!(carom_frame_hash(again.as_deref()), carom_frame_hash(Some(frame)), "a saved game");
        carom_frame_free(again);
        finish(record);
    }
    carom_frame_free(objects.frame);
    carom_shot_free(objects.shot);
});
