//! carom for GDScript, as a `GDExtension` for Godot 4: shots, and the balls at any time of them.

mod replay;

use std::cell::RefCell;

use carom::rack::{Break, Game, break_shot};
use carom::{Error, Shot};
use godot::prelude::*;

use replay::Replay;

struct CaromExtension;

#[gdextension]
unsafe impl ExtensionLibrary for CaromExtension {}

thread_local! {
    /// The last error of this thread.
    static LAST_ERROR: RefCell<String> = const { RefCell::new(String::new()) };
}

/// A simulated shot. Balls have the numbers of `ball_ids`; lengths are metres and times seconds. In
/// Godot's axes y is up: carom's (x, y, z) is `Vector3(x, z, -y)`.
#[derive(GodotClass)]
#[class(no_init, base = RefCounted)]
struct CaromTrace {
    replay: Replay,
}

#[godot_api]
impl CaromTrace {
    /// Simulates a shot file. Null if the file is wrong: `last_error` says why.
    #[func]
    fn simulate(json: GString) -> Option<Gd<Self>> {
        Self::made(Shot::from_json(&json.to_string()))
    }

    /// Simulates the opening shot of a game, such as "nine-ball". Null if there is no such game.
    #[func]
    fn break_shot(game: GString, seed: i64) -> Option<Gd<Self>> {
        let opening = |game| break_shot(&Break::new(game, seed.unsigned_abs()));
        Self::made(Game::read(&game.to_string()).and_then(opening))
    }

    /// The sentence of the last error in this thread: its kind, place, fault and remedy.
    #[func]
    fn last_error() -> GString {
        LAST_ERROR.with_borrow(|text| text.as_str().into())
    }

    /// Time from the strike to the end, s.
    #[func]
    fn duration(&self) -> f64 {
        self.replay.trace.duration()
    }

    /// Width (along x) and length (along z) of the playing surface, m.
    #[func]
    fn table_size(&self) -> Vector2 {
        self.replay.table_size()
    }

    /// The identifiers of the balls.
    #[func]
    fn ball_ids(&self) -> PackedStringArray {
        self.replay.balls().map(|ball| GString::from(ball.id.as_str())).collect()
    }

    /// The radii of the balls, m.
    #[func]
    fn ball_radii(&self) -> PackedFloat32Array {
        self.replay.balls().map(|ball| ball.ball.radius as f32).collect()
    }

    /// The place and the turn of every ball at a time of the shot (s, from 0), exact to rounding.
    #[func]
    fn transforms(&self, time: f64) -> Array<Transform3D> {
        self.replay.transforms(time).collect()
    }

    /// What happens, in order: dictionaries with `time` (s), `kind`, `strength` (the largest impulse that a
    /// ball gets, N s; 0 if nothing meets) and `balls`.
    #[func]
    fn events(&self) -> Array<VarDictionary> {
        let trace = &self.replay.trace;
        trace
            .events()
            .map(|event| {
                let balls: PackedInt32Array = event.balls.iter().map(|&b| i32::from(b)).collect();
                vdict! {
                    "time" => event.time,
                    "kind" => event.kind.name(),
                    "strength" => self.replay.strength(&event),
                    "balls" => &balls,
                }
            })
            .collect()
    }

    /// A hash of the whole shot. Two computers with the same version of carom have the same.
    #[func]
    fn shot_hash(&self) -> GString {
        format!("{:016x}", self.replay.trace.hash()).as_str().into()
    }

    fn made(shot: Result<Shot, Error>) -> Option<Gd<Self>> {
        match shot.and_then(|shot| shot.simulate()) {
            Ok(trace) => Some(Gd::from_object(Self { replay: Replay::new(trace) })),
            Err(error) => {
                godot_error!("carom: {error}");
                LAST_ERROR.set(error.to_string());
                None
            }
        }
    }
}
