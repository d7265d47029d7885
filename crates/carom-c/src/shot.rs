//! `carom_shot`: everything that is decided before a shot starts.

use std::ffi::{CString, c_char};
use std::sync::Arc;

use carom::format::Node;
use carom::math::Vec3;
use carom::rack::{Break, Game, break_shot};
use carom::resolve::cue_ball::Strike;
use carom::shot::{PlacedBall, Policy, StrikePolicy};
use carom::{Ball, BallState, Error, Shot, ShotFile};

use crate::entry::{
    ErrorText, c_text, enter, flag, given, index, optional_text, slice, text, to_c,
};
use crate::kinds::CAROM_NONE;
use crate::table::carom_table;

/// The cue passes through no ball or rail, or the strike is refused.
pub const CAROM_REFUSE_OBSTRUCTION: i32 = 1;
/// A tip offset past the miscue limit is played as if the tip did not slip.
pub const CAROM_REPORT_MISCUE: i32 = 2;

/// A shot; immutable. Any number of threads may use it at once.
pub struct carom_shot {
    pub(crate) file: Arc<ShotFile>,
    ids: Vec<CString>,
}

/// A strike of the cue. All zero but the speed: level unless that would touch a rail or a ball, along
/// +x, at the ball's centre.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_strike {
    /// The cue's speed, m/s, above 0 and at most 50. 0 in a definition: there is no strike.
    pub speed: f64,
    /// Direction in which the cue moves, rad, counter-clockwise from +x, seen from above.
    pub azimuth: f64,
    /// The butt's angle above the horizontal, rad, from 0 to less than π/2; read if has_elevation is not 0.
    pub elevation: f64,
    /// Offset of the contact point to the right, ball radii.
    pub side: f64,
    /// Offset of the contact point upwards, ball radii.
    pub height: f64,
    /// 0: the default elevation, the least at which the cue clears rails and balls. Else: elevation.
    pub has_elevation: i32,
    /// A sum of CAROM_REFUSE_OBSTRUCTION and CAROM_REPORT_MISCUE, or 0. A batch has that of its shot.
    pub policy: i32,
}

/// A ball of a shot.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_ball {
    /// Its unique name; null stands for its index.
    pub id: *const c_char,
    /// Centre, m; z 0 stands for a ball on the cloth.
    pub position: [f64; 3],
    /// m/s
    pub velocity: [f64; 3],
    /// Spin, rad/s.
    pub angular_velocity: [f64; 3],
    /// kg; 0 stands for that of the physics.
    pub mass: f64,
    /// m; 0 stands for that of the physics.
    pub radius: f64,
}

/// What a shot is made of. All zero but balls and ball_count: no strike, until every ball is at rest.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_shot_def {
    /// The balls, ball_count of them.
    pub balls: *const carom_ball,
    /// Number of balls, at least 1.
    pub ball_count: i32,
    /// Index of the struck ball.
    pub struck: i32,
    /// The strike; with the speed 0 there is none, and the balls' velocities start the motion.
    pub strike: carom_strike,
    /// End time, s since the strike; 0: until every ball is at rest.
    pub until: f64,
    /// Cap on the number of events; 0: 100 000.
    pub max_events: u32,
}

/// The opening shot of a game. All zero: the break of nine-ball.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_break_def {
    /// The game's name; null for "nine-ball".
    pub game: *const c_char,
    /// The table preset's name; null for that of the game.
    pub table: *const c_char,
    /// A way of players to open the game, by name; null for a strike in the middle.
    pub preset: *const c_char,
    /// The cue's speed, m/s; 0: the usual one.
    pub speed: f64,
    /// Seed of the gaps in the rack.
    pub seed: u64,
}

impl carom_strike {
    const ZERO: Self = Self {
        speed: 0.0,
        azimuth: 0.0,
        elevation: 0.0,
        side: 0.0,
        height: 0.0,
        has_elevation: 0,
        policy: 0,
    };

    /// The strike, at elevation 0 if it has the default one.
    pub(crate) fn strike(&self) -> Strike {
        let Self { speed, azimuth, elevation, side, height, .. } = *self;
        let elevation = if flag(self.has_elevation) { elevation } else { 0.0 };
        Strike { speed, azimuth, elevation, side, height }
    }

    /// The strike on the struck ball of `shot`.
    pub(crate) fn strike_on(&self, shot: &Shot) -> Strike {
        let strike = self.strike();
        if flag(self.has_elevation) {
            return strike;
        }
        // Numbers out of range are refused with the strike; no elevation belongs to them.
        let is_finite = [strike.speed, strike.azimuth, strike.side, strike.height]
            .into_iter()
            .all(f64::is_finite);
        let elevation = if is_finite { shot.default_elevation(&strike) } else { 0.0 };
        Strike { elevation, ..strike }
    }

    pub(crate) fn policy(&self) -> StrikePolicy {
        let usual = StrikePolicy::default();
        let has = |bit| self.policy & bit != 0;
        StrikePolicy {
            obstruction: if has(CAROM_REFUSE_OBSTRUCTION) {
                Policy::Refuse
            } else {
                usual.obstruction
            },
            miscue: if has(CAROM_REPORT_MISCUE) { Policy::Report } else { usual.miscue },
        }
    }

    pub(crate) fn new(strike: &Strike, policy: StrikePolicy) -> Self {
        let Strike { speed, azimuth, elevation, side, height } = *strike;
        let refuses = (policy.obstruction == Policy::Refuse) as i32 * CAROM_REFUSE_OBSTRUCTION;
        let reports = (policy.miscue == Policy::Report) as i32 * CAROM_REPORT_MISCUE;
        let policy = refuses + reports;
        Self { speed, azimuth, elevation, side, height, has_elevation: 1, policy }
    }
}

impl carom_ball {
    /// # Safety
    /// `id` is null or ends in a zero.
    unsafe fn placed(&self, number: usize, usual: Ball) -> Result<PlacedBall, Error> {
        let or = |value: f64, usual| if value == 0.0 { usual } else { value };
        let ball = Ball { mass: or(self.mass, usual.mass), radius: or(self.radius, usual.radius) };
        let [x, y, z] = self.position;
        // SAFETY: the caller's promise.
        let id = unsafe { optional_text(self.id, &format!("balls[{number}].id")) }?;
        Ok(PlacedBall {
            id: id.map_or_else(|| number.to_string(), String::from),
            ball,
            state: BallState {
                position: Vec3::new(x, y, or(z, ball.radius)),
                velocity: self.velocity.into(),
                angular_velocity: self.angular_velocity.into(),
                ..BallState::default()
            },
        })
    }
}

impl carom_shot {
    pub(crate) fn new(file: Arc<ShotFile>) -> Result<Self, Error> {
        let ids = file.balls().iter().map(|ball| c_text(ball.id.clone()));
        Ok(Self { ids: ids.collect::<Result<_, _>>()?, file })
    }

    pub(crate) fn boxed(file: impl Into<ShotFile>) -> Result<Option<Box<Self>>, Error> {
        Self::new(Arc::new(file.into())).map(Box::new).map(Some)
    }

    /// # Safety
    /// The pointers of `def` are null or as the header says.
    unsafe fn of_def(table: &carom_table, def: &carom_shot_def) -> Result<Shot, Error> {
        let count = usize::try_from(def.ball_count).unwrap_or_default();
        // SAFETY: the caller's promise.
        let balls = unsafe { slice(def.balls, count, "def.balls") }?;
        let usual = table.base.physics().ball;
        let placed = balls.iter().enumerate();
        // SAFETY: the caller's promise.
        let placed = placed.map(|(number, ball)| unsafe { ball.placed(number, usual) });
        let placed = placed.collect::<Result<Vec<_>, _>>()?;
        let mut shot = table.base.with_balls(placed, None)?;
        if def.max_events > 0 {
            shot = shot.with_max_events(def.max_events);
        }
        if def.until != 0.0 {
            shot = shot.with_until(Some(def.until))?;
        }
        if def.strike.speed == 0.0 {
            return Ok(shot);
        }
        let shot = shot.with_strike_policy(def.strike.policy())?;
        let struck = index(def.struck, count, "struck")?;
        if flag(def.strike.has_elevation) {
            return shot.with_balls(shot.balls().to_vec(), Some((struck, def.strike.strike())));
        }
        let level = Strike { speed: def.strike.speed, ..PLACEHOLDER };
        let shot = shot.with_balls(shot.balls().to_vec(), Some((struck, level)))?;
        shot.with_default_elevation(&def.strike.strike())
    }
}

/// A level strike at the centre.
const PLACEHOLDER: Strike =
    Strike { speed: 1.0, azimuth: 0.0, elevation: 0.0, side: 0.0, height: 0.0 };

/// A strike with default values: none.
///
/// Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_default_strike_def() -> carom_strike {
    carom_strike::ZERO
}

/// A definition of a shot with default values, without balls.
///
/// Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_default_shot_def() -> carom_shot_def {
    carom_shot_def {
        balls: std::ptr::null(),
        ball_count: 0,
        struck: 0,
        strike: carom_strike::ZERO,
        until: 0.0,
        max_events: 0,
    }
}

/// A definition of an opening shot with default values.
///
/// Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_default_break_def() -> carom_break_def {
    let null = std::ptr::null();
    carom_break_def { game: null, table: null, preset: null, speed: 0.0, seed: 0 }
}

/// Makes a shot on a table.
///
/// Returns the shot, or null with the text of the error.
/// Ownership: free it with carom_shot_free. What def points to is copied. Threads: any.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_shot_new(
    table: Option<&carom_table>,
    def: Option<&carom_shot_def>,
    error: *mut c_char,
    error_size: i32,
) -> Option<Box<carom_shot>> {
    // SAFETY: the caller's promises in the header.
    unsafe {
        enter(&ErrorText::new(error, error_size), || {
            carom_shot::boxed(carom_shot::of_def(given(table, "table")?, given(def, "def")?)?)
        })
    }
}

/// Reads a shot file, carom-shot/1.
///
/// Returns the shot, or null with the text of the error.
/// Ownership: free it with carom_shot_free. The text is read in the call. Threads: any.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_shot_from_json(
    json: *const c_char,
    error: *mut c_char,
    error_size: i32,
) -> Option<Box<carom_shot>> {
    // SAFETY: the caller's promises in the header.
    unsafe {
        enter(&ErrorText::new(error, error_size), || {
            carom_shot::boxed(ShotFile::from_json(text(json, "json")?)?)
        })
    }
}

/// The opening shot of a game.
///
/// def: null stands for a definition with default values.
/// Returns the shot, or null with the text of the error.
/// Ownership: free it with carom_shot_free. Threads: any.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_break_shot(
    def: Option<&carom_break_def>,
    error: *mut c_char,
    error_size: i32,
) -> Option<Box<carom_shot>> {
    // SAFETY: the caller's promises in the header.
    unsafe {
        enter(&ErrorText::new(error, error_size), || {
            let def = def.copied().unwrap_or_else(|| carom_default_break_def());
            let game = Game::read(optional_text(def.game, "def.game")?.unwrap_or("nine-ball"))?;
            let preset = optional_text(def.preset, "def.preset")?;
            let table = optional_text(def.table, "def.table")?;
            let usual = Break::named(game, preset, def.seed)?;
            let speed = Some(def.speed).filter(|speed| *speed != 0.0).or(usual.speed);
            carom_shot::boxed(break_shot(&Break { table, speed, ..usual })?)
        })
    }
}

/// The same shot with another strike on the same ball. The policy of the strike is not read.
///
/// Returns the shot, or null with the text of the error.
/// Ownership: free it with carom_shot_free; the first shot stays. Threads: any.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_shot_with_strike(
    shot: Option<&carom_shot>,
    strike: Option<&carom_strike>,
    error: *mut c_char,
    error_size: i32,
) -> Option<Box<carom_shot>> {
    // SAFETY: the caller's promises in the header.
    unsafe {
        enter(&ErrorText::new(error, error_size), || {
            let (file, strike) = (&given(shot, "shot")?.file, given(strike, "strike")?);
            carom_shot::boxed(if flag(strike.has_elevation) {
                file.with_strike(&strike.strike())?
            } else {
                file.with_default_elevation(&strike.strike())?
            })
        })
    }
}

/// The shot file as JSON, with the elevation that is used; it reads back to the same bits.
///
/// Returns the text, or null for a null pointer.
/// Ownership: free the text with carom_text_free. Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_shot_to_json(shot: Option<&carom_shot>) -> *mut c_char {
    enter(&ErrorText::NONE, || to_c(given(shot, "shot")?.file.to_json()))
}

/// The table and the physics of a shot.
///
/// Returns the table, or null for a null pointer.
/// Ownership: free it with carom_table_free. Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_shot_table(shot: Option<&carom_shot>) -> Option<Box<carom_table>> {
    enter(&ErrorText::NONE, || Ok(Some(Box::new((&given(shot, "shot")?.file).into()))))
}

/// Number of balls.
///
/// Returns the number, or a negative number for a null pointer.
/// Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_shot_ball_count(shot: Option<&carom_shot>) -> i32 {
    enter(&ErrorText::NONE, || Ok(given(shot, "shot")?.ids.len() as i32))
}

/// Writes ball number ball, at the start of the shot, into out.
///
/// Returns 0, or a negative number if there is no such ball.
/// Ownership: out->id belongs to the shot, and lives as long. Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_shot_ball(
    shot: Option<&carom_shot>,
    ball: i32,
    out: Option<&mut carom_ball>,
) -> i32 {
    enter(&ErrorText::NONE, || {
        let (shot, out) = (given(shot, "shot")?, given(out, "out")?);
        let ball = index(ball, shot.ids.len(), "ball")?;
        let PlacedBall { ball: Ball { mass, radius }, state, .. } = &shot.file.balls()[ball];
        *out = carom_ball {
            id: shot.ids[ball].as_ptr(),
            position: state.position.to_array(),
            velocity: state.velocity.to_array(),
            angular_velocity: state.angular_velocity.to_array(),
            mass: *mass,
            radius: *radius,
        };
        Ok(0)
    })
}

/// The index of the ball with this id.
///
/// Returns the index, or a negative number if there is none.
/// Threads: any.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_shot_ball_index(
    shot: Option<&carom_shot>,
    id: *const c_char,
) -> i32 {
    enter(&ErrorText::NONE, || {
        // SAFETY: the caller's promise in the header.
        let id = unsafe { text(id, "id") }?;
        Ok(given(shot, "shot")?.file.ball_index(id).map_or(CAROM_NONE, |ball| ball as i32))
    })
}

/// Writes the strike, with its elevation, into out.
///
/// Returns the index of the struck ball, or CAROM_NONE if the shot has no strike.
/// Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_shot_strike(
    shot: Option<&carom_shot>,
    out: Option<&mut carom_strike>,
) -> i32 {
    enter(&ErrorText::NONE, || {
        let (shot, out) = (given(shot, "shot")?, given(out, "out")?);
        let Some((ball, strike)) = shot.file.strike() else { return Ok(CAROM_NONE) };
        *out = carom_strike::new(&strike, shot.file.strike_policy());
        Ok(ball as i32)
    })
}

/// Frees a shot; null is passed over.
///
/// Ownership: the pointer must not be used afterwards. Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_shot_free(shot: Option<Box<carom_shot>>) {
    enter(&ErrorText::NONE, || {
        drop(shot);
        Ok(())
    });
}

/// Which kinds of fault an error may name, JSON: a list of objects with "kind" and "sentence".
///
/// Ownership: free the text with carom_text_free. Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_error_kinds_json() -> *mut c_char {
    enter(&ErrorText::NONE, || {
        let kinds = carom::ErrorKind::ALL.iter().map(|kind| {
            Node::object([("kind", kind.name().into()), ("sentence", kind.sentence().into())])
        });
        to_c(Node::list(kinds).to_json())
    })
}
