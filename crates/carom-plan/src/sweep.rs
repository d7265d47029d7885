//! Rows of a table of shots: what each is, and what comes of it.
//!
//! A row is a layout, values put into it where paths say, numbers of its strike, and an error of that strike if it
//! is played with noise. What comes of it is a function of these alone: of no other row, no order, no
//! number of threads.

use carom::batch::{OFF_TABLE, PADDING, PocketRecorder};
use carom::event::{Event, Recorder};
use carom::format::{KeyPath, Node};
use carom::limits::{MAX_BALLS, SMALL_CAPACITY};
use carom::math::{degrees, radians};
use carom::outcome::{OutcomeRecorder, Touched};
use carom::resolve::cue_ball::Strike;
use carom::simulate::Simulation;
use carom::{Error, MotionState, Noise, Outcome, Shot, ShotFile, Summary};

/// The numbers of a strike as a shot file has them: m/s, degrees, ball radii.
pub const STRIKE: [&str; 5] = ["speed", "azimuth_deg", "elevation_deg", "side", "height"];

/// Where no ball or rail is counted: there is no such contact.
pub const NONE: i16 = -1;

/// Rows of parameters, column by column.
#[derive(Clone, Copy, Debug)]
pub struct Rows<'a> {
    /// The layouts to choose from.
    pub layouts: &'a [&'a ShotFile],
    /// Which of them each row is.
    pub layout: &'a [i32],
    /// What is put into it, in this order.
    pub columns: &'a [Column<'a>],
    /// The numbers of the strike that differ from the layout's: which of [`STRIKE`], and one per row.
    pub strike: &'a [(usize, &'a [f64])],
    /// With what noise the strike is played, with which seed, and which of that seed's errors each row has.
    pub noise: Option<(Noise, u64, &'a [i64])>,
}

impl<'a> Rows<'a> {
    /// The layout with the row's values in it.
    fn make(&self, row: usize, layout: &ShotFile) -> Result<ShotFile, Error> {
        let strike = (self.strike.iter())
            .map(|&(key, numbers)| {
                Ok((KeyPath::parse(&format!("strike.{}", STRIKE[key]))?, numbers))
            })
            .collect::<Result<Vec<_>, Error>>()?;
        let column = |column: &Column<'a>| (column.path, column.values.at(row));
        let mut values: Vec<_> = self.columns.iter().map(column).collect();
        match layout.with_values(values.clone()) {
            // Rows that only differ in their strikes share what was made. The layout's own strike may be
            // one that cannot be played here, and the row's one that can.
            Err(_) if !strike.is_empty() => {
                values.extend(strike.iter().map(|(path, n)| (path, Node::Number(n[row]))));
                layout.with_values(values)
            }
            made => made,
        }
    }

    /// The strike that is meant: a shot's own, with the row's numbers.
    fn meant(&self, row: usize, own: Strike) -> Strike {
        let mut numbers = [own.speed, own.azimuth, own.elevation, own.side, own.height];
        for &(key, values) in self.strike {
            let is_angle = STRIKE[key].ends_with("_deg");
            numbers[key] = if is_angle { radians(values[row]) } else { values[row] };
        }
        let [speed, azimuth, elevation, side, height] = numbers;
        Strike { speed, azimuth, elevation, side, height }
    }
}

/// Values that are put into a layout at one path.
#[derive(Clone, Copy, Debug)]
pub struct Column<'a> {
    /// Where.
    pub path: &'a KeyPath,
    /// What.
    pub values: Values<'a>,
}

/// One value per row.
#[derive(Clone, Copy, Debug)]
pub enum Values<'a> {
    /// A number each.
    Numbers(&'a [f64]),
    /// A list of so many numbers each.
    Lists(usize, &'a [f64]),
    /// One of a few values each, by its index.
    Choices(&'a [Node], &'a [i32]),
}

impl Values<'_> {
    fn at(&self, row: usize) -> Node {
        match *self {
            Self::Numbers(numbers) => Node::Number(numbers[row]),
            Self::Lists(width, numbers) => {
                Node::list(numbers[row * width..][..width].iter().copied())
            }
            Self::Choices(choices, index) => choices[index[row] as usize].clone(),
        }
    }

    fn same(&self, row: usize, other: usize) -> bool {
        let same_bits =
            |a: &[f64], b: &[f64]| a.iter().map(|x| x.to_bits()).eq(b.iter().map(|x| x.to_bits()));
        match *self {
            Self::Numbers(numbers) => same_bits(&numbers[row..=row], &numbers[other..=other]),
            Self::Lists(width, numbers) => {
                same_bits(&numbers[row * width..][..width], &numbers[other * width..][..width])
            }
            Self::Choices(_, index) => index[row] == index[other],
        }
    }
}

/// What came of rows, column by column; `balls` values per row where it is said so.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Played {
    /// Values per row in what is per ball.
    pub balls: usize,
    /// Number of events; 0 where the shot failed.
    pub events: Vec<i32>,
    /// When the last event was, s; NaN where the shot failed.
    pub duration: Vec<f64>,
    /// Per ball: the pocket it fell into, or [`ON_TABLE`], [`OFF_TABLE`], [`PADDING`].
    pub pocket: Vec<i8>,
    /// Per ball: the final centre in the file's frame, m; NaN for padding and where the shot failed.
    pub end: [Vec<f64>; 3],
    /// The cue ball: the struck ball, else the one with the id `cue`, else [`NONE`].
    pub cue_ball: Vec<i16>,
    /// The strike that was played, in the units of [`STRIKE`], where there is noise.
    pub strike: [Vec<f64>; 5],
    /// What a referee needs, if it was asked for.
    pub facts: Vec<Facts>,
    /// Rows that failed, and why.
    pub errors: Vec<(usize, Error)>,
}

/// What a referee needs of a shot, in numbers. Balls are indices into the shot's balls.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Facts {
    /// The first ball that the cue ball touched, or [`NONE`].
    pub first_contact: i16,
    /// Whether the cue ball fell.
    pub scratch: bool,
    /// Cushions that the cue ball touched before its first contact.
    pub rails_before_contact: i16,
    /// Touches of any ball with a cushion after the first contact.
    pub rails_after_contact: i16,
    /// Balls that were driven to a rail.
    pub driven_to_rail: i16,
    /// Different balls that the cue ball touched.
    pub balls_touched: i16,
    /// Cushions that the cue ball touched before the second of them, or [`NONE`].
    pub rails_before_second_ball: i16,
    /// Balls over which another one flew.
    pub jumped: i16,
    /// Balls that hang over the edge of a pocket.
    pub hanging: i16,
}

impl Default for Facts {
    fn default() -> Self {
        Self {
            first_contact: NONE,
            scratch: false,
            rails_before_contact: 0,
            rails_after_contact: 0,
            driven_to_rail: 0,
            balls_touched: 0,
            rails_before_second_ball: NONE,
            jumped: 0,
            hanging: 0,
        }
    }
}

impl Facts {
    fn of(outcome: &Outcome) -> Self {
        let count = |n: usize| i16::try_from(n).unwrap_or(i16::MAX);
        let index = |ball: u16| i16::try_from(ball).unwrap_or(NONE);
        let mut facts = Self {
            first_contact: outcome.first_contact.map_or(NONE, index),
            scratch: outcome.cue_ball_scratched(),
            rails_before_contact: count(outcome.rails_before_first_contact().count()),
            rails_after_contact: count(outcome.rails_after_first_contact.len()),
            driven_to_rail: count(outcome.driven_to_rail.len()),
            jumped: count(outcome.jumped.len()),
            hanging: count(outcome.hanging.len()),
            ..Self::default()
        };
        let touched = &outcome.cue_ball_touched;
        let mut rails = 0;
        for (k, touch) in touched.iter().enumerate() {
            match touch {
                Touched::Rail(_) => rails += 1,
                ball if touched[..k].contains(ball) => {}
                Touched::Ball(_) => {
                    facts.balls_touched += 1;
                    if facts.balls_touched == 2 {
                        facts.rails_before_second_ball = rails;
                    }
                }
            }
        }
        facts
    }
}

/// Plays every row. `balls` is how many balls the largest shot has; `facts` says whether a referee's facts are
/// wanted, which cost time.
pub fn play(rows: &Rows<'_>, balls: usize, facts: bool) -> Played {
    if balls <= SMALL_CAPACITY {
        Player::<SMALL_CAPACITY>::new(rows, balls, facts).play()
    } else {
        Player::<MAX_BALLS>::new(rows, balls, facts).play()
    }
}

/// The shot of one row: its layout with the row's values, and the strike that is played. The strike's angles
/// are kept as in [`Shot::with_strike`], which moves some by one rounding.
///
/// # Errors
/// [`Error::Input`] as in [`Played::errors`].
pub fn shot(rows: &Rows<'_>, row: usize) -> Result<ShotFile, Error> {
    let layout = rows.layouts[rows.layout[row] as usize];
    let made = rows.make(row, layout)?;
    let Some((struck, own)) = made.strike() else {
        return Ok(made);
    };
    let meant = rows.meant(row, own);
    made.resolve_strike(&meant)?;
    let played = rows.noise.map_or(meant, |(noise, seed, index)| {
        noise.draw(&meant, made.balls()[struck].ball.radius, seed, index[row] as u64)
    });
    made.with_strike(&played)
}

struct Player<'a, const N: usize> {
    rows: &'a Rows<'a>,
    facts: bool,
    /// A referee for each layout who has looked at its balls, which takes longer than to be copied.
    referees: Vec<Option<OutcomeRecorder<'a>>>,
    simulation: Box<Simulation<N>>,
    /// The last shot that was made of a layout and values, and for which row.
    made: Option<(usize, ShotFile)>,
    played: Played,
}

impl<'a, const N: usize> Player<'a, N> {
    fn new(rows: &'a Rows<'a>, balls: usize, facts: bool) -> Self {
        let n = rows.layout.len();
        let nothing = || vec![f64::NAN; n * balls];
        let strikes = if rows.noise.is_some() { n } else { 0 };
        let played = Played {
            balls,
            events: vec![0; n],
            duration: vec![f64::NAN; n],
            pocket: vec![PADDING; n * balls],
            end: [nothing(), nothing(), nothing()],
            cue_ball: vec![NONE; n],
            strike: core::array::from_fn(|_| vec![f64::NAN; strikes]),
            facts: vec![Facts::default(); if facts { n } else { 0 }],
            errors: Vec::new(),
        };
        let referees = vec![None; rows.layouts.len()];
        let simulation = Box::new(Simulation::new());
        Self { rows, facts, referees, simulation, made: None, played }
    }

    fn play(mut self) -> Played {
        for row in 0..self.rows.layout.len() {
            if let Err(error) = self.row(row) {
                let balls = self.played.balls;
                self.played.pocket[row * balls..][..balls].fill(PADDING);
                self.played.errors.push((row, error));
            }
        }
        self.played
    }

    fn row(&mut self, row: usize) -> Result<(), Error> {
        let rows = self.rows;
        let number = rows.layout[row] as usize;
        let layout = rows.layouts[number];
        if rows.columns.is_empty() {
            let referee = self.facts.then(|| {
                let looked = &mut self.referees[number];
                looked.get_or_insert_with(|| OutcomeRecorder::new(layout)).clone()
            });
            return self.shot(row, layout, referee);
        }
        let again = |&(other, _): &(usize, ShotFile)| {
            rows.layout[other] == rows.layout[row]
                && rows.columns.iter().all(|column| column.values.same(other, row))
        };
        let made = match self.made.take().filter(again) {
            Some(made) => made,
            None => (row, rows.make(row, layout)?),
        };
        let referee = self.facts.then(|| OutcomeRecorder::new(&made.1));
        let result = self.shot(row, &made.1, referee);
        self.made = Some(made);
        result
    }

    /// Plays `shot` with the row's strike.
    fn shot(
        &mut self,
        row: usize,
        shot: &Shot,
        referee: Option<OutcomeRecorder<'_>>,
    ) -> Result<(), Error> {
        let Some((struck, own)) = shot.strike() else {
            return self.simulate(row, shot, None, referee);
        };
        let mut strike = self.rows.meant(row, own);
        shot.resolve_strike(&strike)?;
        if let Some((noise, seed, index)) = self.rows.noise {
            let radius = shot.balls()[struck].ball.radius;
            strike = noise.draw(&strike, radius, seed, index[row] as u64);
            let Strike { speed, azimuth, elevation, side, height } = strike;
            let drawn = [speed, degrees(azimuth), degrees(elevation), side, height];
            for (column, value) in self.played.strike.iter_mut().zip(drawn) {
                column[row] = value;
            }
            shot.resolve_strike(&strike)?;
        }
        self.simulate(row, shot, Some((struck, strike)), referee)
    }

    fn simulate(
        &mut self,
        row: usize,
        shot: &Shot,
        strike: Option<(usize, Strike)>,
        referee: Option<OutcomeRecorder<'_>>,
    ) -> Result<(), Error> {
        let count = shot.balls().len();
        let first = row * self.played.balls;
        let pockets = &mut self.played.pocket[first..][..count];
        let explain = |failure| shot.explain(failure, strike.as_ref().map(|(_, s)| s));
        let Summary { duration, events } = if let Some(referee) = referee {
            let mut ears = Ears { pockets: PocketRecorder::new(pockets), referee };
            let played = self.simulation.play_strike(shot, strike, &mut ears).map_err(explain)?;
            let last = |i| self.simulation.state(i, played.duration);
            let last: Vec<_> = (0..count).map(last).collect();
            self.played.facts[row] = Facts::of(&ears.referee.finish(&last));
            played
        } else {
            let mut pockets = PocketRecorder::new(pockets);
            self.simulation.play_strike(shot, strike, &mut pockets).map_err(explain)?
        };
        let cue_ball = shot.cue_ball().and_then(|i| i16::try_from(i).ok());
        self.played.cue_ball[row] = cue_ball.unwrap_or(NONE);
        self.played.events[row] = events as i32;
        self.played.duration[row] = duration;
        for i in 0..count {
            let state = self.simulation.file_state(i, shot, duration);
            for (column, x) in self.played.end.iter_mut().zip(state.position.to_array()) {
                column[first + i] = x;
            }
            if state.motion == MotionState::OffTable {
                self.played.pocket[first + i] = OFF_TABLE;
            }
        }
        Ok(())
    }
}

/// Notes the pockets, and all that a referee needs.
struct Ears<'a> {
    pockets: PocketRecorder<'a>,
    referee: OutcomeRecorder<'a>,
}

impl Recorder for Ears<'_> {
    fn record(&mut self, event: &Event<'_>) {
        self.pockets.record(event);
        self.referee.record(event);
    }
}
