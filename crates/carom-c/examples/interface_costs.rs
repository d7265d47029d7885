//! What the C interface costs: a batch of 10⁵ strikes and one of 10⁵ shots through C and through Rust, in
//! turns, on one thread; the time of a picture; the memory of objects. Prints JSON. Times are processor
//! time, which other work on the machine disturbs least, and the fastest round counts. For Unix.
//!
//! ```sh
//! cargo run --release -p carom-c --example interface_costs -- SHOT.json ROUNDS
//! ```

use std::error::Error;
use std::ffi::CString;
use std::ptr::{from_ref, null_mut};

use allocation_counter::measure;
use carom::Shot;
use carom::batch::{BatchArrays, simulate_batch_into, simulate_strikes_into};
use carom::format::Node;
use carom::resolve::cue_ball::Strike;
use carom::runner::Runner;
use carom_c::batch::{carom_batch, carom_batch_strikes};
use carom_c::frame::carom_frame_new;
use carom_c::shot::{
    carom_break_shot, carom_shot, carom_shot_from_json, carom_shot_strike, carom_shot_with_strike,
    carom_strike,
};
use carom_c::state::carom_state;
use carom_c::table::carom_table_new;
use carom_c::trace::{
    carom_shot_simulate, carom_trace, carom_trace_duration, carom_trace_events, carom_trace_states,
};
use rustix::time::{ClockId, clock_gettime};

/// Shots of a batch.
const SHOTS: usize = 100_000;
/// Range of the azimuths of a batch around that of the shot, rad.
const RANGE: f64 = 0.05;
/// Time between two pictures, s.
const STEP: f64 = 1.0 / 60.0;

/// Processor time of this thread, ns.
fn now() -> f64 {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    1e9 * time.tv_sec as f64 + time.tv_nsec as f64
}

/// The fastest time of each of two works in `rounds` rounds, in turns, ms.
fn fastest(rounds: usize, mut one: impl FnMut(), mut other: impl FnMut()) -> [f64; 2] {
    let time = |work: &mut dyn FnMut()| {
        let before = now();
        work();
        (now() - before) / 1e6
    };
    (0..rounds)
        .fold([f64::INFINITY; 2], |[a, b], _| [a.min(time(&mut one)), b.min(time(&mut other))])
}

/// The results of a batch.
#[derive(Clone, PartialEq)]
struct Results {
    position: Vec<[f64; 3]>,
    pocket: Vec<i8>,
    events: Vec<i32>,
    balls: usize,
}

impl Results {
    fn new(balls: usize) -> Self {
        let position = vec![[0.0; 3]; SHOTS * balls];
        Self { position, pocket: vec![0; SHOTS * balls], events: vec![0; SHOTS], balls }
    }

    fn arrays(&mut self) -> BatchArrays<'_> {
        let Self { position, pocket, events, balls } = self;
        BatchArrays { balls: *balls, final_position: position, pocket, events }
    }
}

fn row(rust: f64, c: f64) -> Node {
    Node::object([
        ("rust_ms", rust.into()),
        ("c_ms", c.into()),
        ("more_percent", (100.0 * (c / rust - 1.0)).into()),
    ])
}

fn shot_of(json: &str) -> Result<Box<carom_shot>, Box<dyn Error>> {
    let text = CString::new(json)?;
    // SAFETY: the text ends in a zero.
    unsafe { carom_shot_from_json(text.as_ptr(), null_mut(), 0) }
        .ok_or_else(|| "a wrong file".into())
}

fn batches(json: &str, rounds: usize) -> Result<Node, Box<dyn Error>> {
    let (shot, c_shot) = (Shot::from_json(json)?, shot_of(json)?);
    let runner = Runner::new(Some(1))?;
    let mut usual = carom_c::shot::carom_default_strike_def();
    carom_shot_strike(Some(&c_shot), Some(&mut usual));
    let azimuth = |k: usize| usual.azimuth + RANGE * (2.0 * k as f64 / SHOTS as f64 - 1.0);
    let c_strikes: Vec<carom_strike> =
        (0..SHOTS).map(|k| carom_strike { azimuth: azimuth(k), ..usual }).collect();
    let strike = |s: &carom_strike| Strike {
        speed: s.speed,
        azimuth: s.azimuth,
        elevation: s.elevation,
        side: s.side,
        height: s.height,
    };
    let strikes: Vec<Strike> = c_strikes.iter().map(strike).collect();
    let shots: Vec<Shot> = strikes.iter().map(|s| shot.with_strike(s)).collect::<Result<_, _>>()?;
    // SAFETY: the objects live; there is no text of an error.
    let with = |s| unsafe { carom_shot_with_strike(Some(&c_shot), Some(s), null_mut(), 0) };
    let c_shots: Vec<Box<carom_shot>> =
        c_strikes.iter().map(with).collect::<Option<_>>().ok_or("a strike is refused")?;
    let pointers: Vec<*const carom_shot> = c_shots.iter().map(|shot| from_ref(&**shot)).collect();
    let balls = shot.balls().len();
    let (mut ours, mut theirs) = (Results::new(balls), Results::new(balls));
    let of_strikes = fastest(
        rounds,
        || {
            let played =
                simulate_strikes_into(&shot, SHOTS, |k| strikes[k], ours.arrays(), &runner);
            assert_eq!(played, Ok(Vec::new()));
        },
        || {
            let Results { position, pocket, events, .. } = &mut theirs;
            let position = position.as_flattened_mut().as_mut_ptr();
            let (pocket, events) = (pocket.as_mut_ptr(), events.as_mut_ptr());
            // SAFETY: the arrays have the documented lengths.
            let failed = unsafe {
                carom_batch_strikes(
                    Some(&c_shot),
                    c_strikes.as_ptr(),
                    SHOTS,
                    balls as i32,
                    1,
                    position,
                    pocket,
                    events,
                    null_mut(),
                    0,
                )
            };
            assert_eq!(failed, 0);
        },
    );
    assert!(ours == theirs, "C and Rust have the same bits");
    let of_shots = fastest(
        rounds,
        || {
            let played = simulate_batch_into(&shots, ours.arrays(), &runner);
            assert_eq!(played, Ok(Vec::new()));
        },
        || {
            let Results { position, pocket, events, .. } = &mut theirs;
            let position = position.as_flattened_mut().as_mut_ptr();
            let (pocket, events) = (pocket.as_mut_ptr(), events.as_mut_ptr());
            // SAFETY: the arrays have the documented lengths.
            let failed = unsafe {
                carom_batch(
                    pointers.as_ptr(),
                    SHOTS,
                    balls as i32,
                    1,
                    position,
                    pocket,
                    events,
                    null_mut(),
                    0,
                )
            };
            assert_eq!(failed, 0);
        },
    );
    assert!(ours == theirs, "C and Rust have the same bits");
    Ok(Node::object([
        ("shots", (SHOTS as i64).into()),
        ("balls", (balls as i64).into()),
        ("strikes_of_a_shot", row(of_strikes[0], of_strikes[1])),
        ("many_shots", row(of_shots[0], of_shots[1])),
    ]))
}

/// The states of all balls in every picture of a shot, µs for each picture: the mean over the shot, and
/// the mean with the first picture, which computes the orientations.
fn pictures(trace: &carom_trace, balls: usize, rounds: usize) -> Node {
    let state = carom_state {
        position: [0.0; 3],
        velocity: [0.0; 3],
        angular_velocity: [0.0; 3],
        orientation: [0.0; 4],
        motion: 0,
    };
    let mut states = vec![state; balls];
    let count = (carom_trace_duration(Some(trace)) / STEP) as usize + 1;
    let mut draw = || {
        for picture in 0..count {
            let time = picture as f64 * STEP;
            // SAFETY: there is room for every ball.
            let done =
                unsafe { carom_trace_states(Some(trace), time, states.as_mut_ptr(), balls as i32) };
            assert_eq!(done, 0);
        }
    };
    let before = now();
    draw();
    let first = (now() - before) / 1e3 / count as f64;
    let [time, _] = fastest(rounds, draw, || {});
    Node::object([
        ("balls", (balls as i64).into()),
        ("pictures", (count as i64).into()),
        ("us_each", (1e3 * time / count as f64).into()),
        ("us_each_of_the_first_time", first.into()),
    ])
}

/// Bytes that stay allocated for what `make` returns.
fn memory<T>(make: impl FnOnce() -> T) -> (T, i64) {
    let mut made = None;
    let used = measure(|| made = Some(make()));
    (made.expect("it was made"), used.bytes_current)
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [file, rounds] = arguments.as_slice() else {
        return Err("usage: interface_costs SHOT.json ROUNDS".into());
    };
    let rounds = rounds.parse()?;
    // SAFETY: null stands for default values, and there is no text of an error.
    let (table, frame, shot) = unsafe {
        (
            memory(|| carom_table_new(None, null_mut(), 0)),
            memory(|| carom_frame_new(None, null_mut(), 0)),
            memory(|| carom_break_shot(None, null_mut(), 0)),
        )
    };
    let opening = shot.0.ok_or("no break")?;
    // SAFETY: there is no text of an error.
    let simulated = memory(|| unsafe { carom_shot_simulate(Some(&opening), null_mut(), 0) });
    let trace = simulated.0.ok_or("no trace")?;
    let drawn = pictures(&trace, 10, rounds);
    let mut events = carom_c::event::carom_events {
        events: std::ptr::null(),
        balls: std::ptr::null(),
        points: std::ptr::null(),
        event_count: 0,
        ball_count: 0,
        point_count: 0,
    };
    let arrays = memory(|| carom_trace_events(Some(&trace), Some(&mut events)));
    let result = Node::object([
        ("batch", batches(&std::fs::read_to_string(file)?, rounds)?),
        ("pictures_of_a_nine_ball_break", drawn),
        (
            "bytes",
            Node::object([
                ("table", table.1.into()),
                ("frame_of_nine_ball", frame.1.into()),
                ("shot_of_ten_balls", shot.1.into()),
                ("trace_of_a_break", simulated.1.into()),
                ("events_of_a_break", arrays.1.into()),
            ]),
        ),
    ]);
    println!("{}", result.to_json());
    Ok(())
}
