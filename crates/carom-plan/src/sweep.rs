//! The rows of a table of shots: their parameters and their results.
//!
//! A row has a layout, values that replace parts of it, numbers of its strike, and an error of that
//! strike if it is played with noise. Its result depends only on these: not on other rows, on their
//! order or on the number of threads.

use core::ops::Range;

use carom::batch::{OFF_TABLE, PADDING, PocketRecorder, draw_variant};
use carom::device::{Device, FlatEnds, FlatShots};
use carom::format::{KeyPath, Node};
use carom::math::{degrees, radians};
use carom::noise::StruckBall;
use carom::outcome::{OutcomeRecorder, Touched};
use carom::resolve::cue_ball::Strike;
use carom::{Error, MotionState, Noise, Outcome, Shot, ShotFile, Simulator, Summary};

/// The numbers of a strike, with the names and units of a shot file: m/s, degrees, ball radii.
pub const STRIKE: [&str; 5] = ["speed", "azimuth_deg", "elevation_deg", "side", "height"];

/// Stands for a ball or a number that does not exist, such as the first contact of a shot without
/// one.
pub const NONE: i16 = -1;

/// The parameters of rows, column by column.
#[derive(Clone, Copy, Debug)]
pub struct SweepRows<'a> {
    /// The layouts to choose from.
    pub layouts: &'a [&'a ShotFile],
    /// The index of each row's layout.
    pub layout: &'a [i32],
    /// The values that replace parts of the layout, in this order.
    pub columns: &'a [Column<'a>],
    /// The numbers of the strike that differ from the layout's: an index into [`STRIKE`], and a
    /// number per row.
    pub strike: &'a [(usize, &'a [f64])],
    /// The noise of the strike, its seed, and the index of each row's error.
    pub noise: Option<(&'a Noise, u64, &'a [i64])>,
}

impl<'a> SweepRows<'a> {
    /// The layout with the row's values.
    fn make(&self, row: usize, layout: &ShotFile) -> Result<ShotFile, Error> {
        let strike = (self.strike.iter())
            .map(|&(key, numbers)| {
                Ok((KeyPath::parse(&format!("strike.{}", STRIKE[key]))?, numbers))
            })
            .collect::<Result<Vec<_>, Error>>()?;
        let column = |column: &Column<'a>| (column.path, column.values.at(row));
        let mut values: Vec<_> = self.columns.iter().map(column).collect();
        match layout.with_values(values.clone()) {
            // Rows that differ only in their strikes share the shot that was made. The layout's own
            // strike may be impossible with these values where the row's is possible.
            Err(_) if !strike.is_empty() => {
                values.extend(strike.iter().map(|(path, n)| (path, Node::Number(n[row]))));
                layout.with_values(values)
            }
            made => made,
        }
    }

    /// The intended strike: that of `shot`, `own`, with the row's numbers. A default elevation
    /// follows them.
    fn meant(&self, row: usize, shot: &Shot, own: Strike) -> Strike {
        let mut numbers = [own.speed, own.azimuth, own.elevation, own.side, own.height];
        for &(key, values) in self.strike {
            let is_angle = STRIKE[key].ends_with("_deg");
            numbers[key] = if is_angle { radians(values[row]) } else { values[row] };
        }
        let [speed, azimuth, elevation, side, height] = numbers;
        let strike = Strike { speed, azimuth, elevation, side, height };
        let has_elevation = self.strike.iter().any(|&(key, _)| STRIKE[key] == "elevation_deg");
        if has_elevation { strike } else { shot.at_own_elevation(&strike) }
    }
}

/// Values that replace one part of a layout.
#[derive(Clone, Copy, Debug)]
pub struct Column<'a> {
    /// The place of that part.
    pub path: &'a KeyPath,
    /// Its values.
    pub values: Values<'a>,
}

/// One value per row.
#[derive(Clone, Copy, Debug)]
pub enum Values<'a> {
    /// A number per row.
    Numbers(&'a [f64]),
    /// A list per row, of this many numbers.
    Lists(usize, &'a [f64]),
    /// One of these values per row, by its index.
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

/// The results of rows, column by column. Columns per ball have `balls` values per row.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RowResults {
    /// Number of values per row in columns per ball.
    pub balls: usize,
    /// Number of events; 0 where the shot failed.
    pub events: Vec<i32>,
    /// Time of the last event, s; NaN where the shot failed.
    pub duration: Vec<f64>,
    /// Per ball: the pocket it fell into, or [`ON_TABLE`](carom::batch::ON_TABLE), [`OFF_TABLE`],
    /// [`PADDING`].
    pub pocket: Vec<i8>,
    /// Per ball: the final centre in the file's coordinates, m; NaN for padding and where the shot
    /// failed.
    pub end: [Vec<f64>; 3],
    /// Index of the cue ball: the struck ball, else the ball with the id `cue`, else [`NONE`].
    pub cue_ball: Vec<i16>,
    /// The strike that was played, in the units of [`STRIKE`]; empty without noise.
    pub strike: [Vec<f64>; 5],
    /// The outcome of each shot; empty unless outcomes were requested.
    pub outcomes: Vec<OutcomeColumns>,
    /// The rows that failed, with their errors.
    pub errors: Vec<(usize, Error)>,
}

/// An [`Outcome`] in numbers. Balls are indices into the shot's balls.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OutcomeColumns {
    /// The first ball that the cue ball touched, or [`NONE`].
    pub first_contact: i16,
    /// Whether the cue ball fell.
    pub scratch: bool,
    /// Number of cushions that the cue ball touched before its first contact.
    pub rails_before_contact: i16,
    /// Number of contacts of any ball with a cushion after the first contact.
    pub rails_after_contact: i16,
    /// Number of balls that were driven to a rail.
    pub driven_to_rail: i16,
    /// Number of different balls that the cue ball touched.
    pub balls_touched: i16,
    /// Number of cushions that the cue ball touched before the second of them, or [`NONE`].
    pub rails_before_second_ball: i16,
    /// Number of balls over which another ball flew.
    pub jumped: i16,
    /// Number of balls that hang over the edge of a pocket.
    pub hanging: i16,
}

impl Default for OutcomeColumns {
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

impl From<&Outcome> for OutcomeColumns {
    fn from(outcome: &Outcome) -> Self {
        let count = |n: usize| i16::try_from(n).unwrap_or(i16::MAX);
        let index = |ball: u16| i16::try_from(ball).unwrap_or(NONE);
        let mut columns = Self {
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
                    columns.balls_touched += 1;
                    if columns.balls_touched == 2 {
                        columns.rails_before_second_ball = rails;
                    }
                }
            }
        }
        columns
    }
}

/// Plays every row. `balls` is the number of balls of the largest shot. With `outcomes`, also
/// computes [`RowResults::outcomes`], which takes more time.
pub fn play(rows: &SweepRows<'_>, balls: usize, outcomes: bool) -> RowResults {
    RowPlayer::new(rows, balls, outcomes).play()
}

/// As [`play`] without outcomes, on `device`. What it cannot play is played here, as in
/// [`carom::batch`].
///
/// # Errors
/// [`Error::Input`] if the device fails.
pub fn play_on(
    rows: &SweepRows<'_>,
    balls: usize,
    device: &dyn Device,
) -> Result<RowResults, Error> {
    let mut player = RowPlayer::new(rows, balls, false);
    let most = device.most_shots().max(1);
    let count = rows.layout.len();
    for first in (0..count).step_by(most) {
        player.waiting = Some(Waiting { most_balls: device.most_balls(), ..Waiting::default() });
        player.play_rows(first..count.min(first + most));
        let waiting = player.waiting.take().unwrap_or_default();
        let ends = device.play(&waiting.flat)?;
        for (place, shot) in waiting.shots.iter().enumerate() {
            player.copy(shot, &ends, place);
        }
    }
    Ok(player.results)
}

/// The shot of one row: its layout with the row's values, and the strike that is played.
///
/// # Errors
/// [`Error::Input`] as in [`RowResults::errors`].
pub fn shot(rows: &SweepRows<'_>, row: usize) -> Result<ShotFile, Error> {
    let layout = rows.layouts[rows.layout[row] as usize];
    let made = rows.make(row, layout)?;
    let Some((_, own)) = made.strike() else {
        return Ok(made);
    };
    let meant = rows.meant(row, &made, own);
    made.resolve_strike(&meant)?;
    let made = made.with_strike(&meant)?;
    rows.noise.map_or(Ok(made.clone()), |(noise, seed, index)| {
        draw_variant(&made, noise, seed, index[row] as u64)
    })
}

/// Plays rows one after the other.
struct RowPlayer<'a> {
    rows: &'a SweepRows<'a>,
    outcomes: bool,
    /// A recorder for each layout. Making one takes longer than cloning it.
    recorders: Vec<Option<OutcomeRecorder<'a>>>,
    simulator: Simulator,
    /// The last shot that was made from a layout and values, and the row for which it was made.
    made: Option<(usize, ShotFile)>,
    /// Where shots wait for a device, if there is one.
    waiting: Option<Waiting>,
    results: RowResults,
}

/// Shots that a device will play.
#[derive(Default)]
struct Waiting {
    most_balls: usize,
    flat: FlatShots,
    shots: Vec<WaitingShot>,
}

/// A shot that a device will play: its row, and what is played here if the device cannot.
struct WaitingShot {
    row: usize,
    shot: Shot,
    strike: Option<(usize, Strike)>,
}

impl<'a> RowPlayer<'a> {
    fn new(rows: &'a SweepRows<'a>, balls: usize, outcomes: bool) -> Self {
        let n = rows.layout.len();
        let nothing = || vec![f64::NAN; n * balls];
        let strikes = if rows.noise.is_some() { n } else { 0 };
        let results = RowResults {
            balls,
            events: vec![0; n],
            duration: vec![f64::NAN; n],
            pocket: vec![PADDING; n * balls],
            end: [nothing(), nothing(), nothing()],
            cue_ball: vec![NONE; n],
            strike: core::array::from_fn(|_| vec![f64::NAN; strikes]),
            outcomes: vec![OutcomeColumns::default(); if outcomes { n } else { 0 }],
            errors: Vec::new(),
        };
        let recorders = vec![None; rows.layouts.len()];
        let simulator = Simulator::new();
        Self { rows, outcomes, recorders, simulator, made: None, waiting: None, results }
    }

    fn play(mut self) -> RowResults {
        self.play_rows(0..self.rows.layout.len());
        self.results
    }

    fn play_rows(&mut self, rows: Range<usize>) {
        for row in rows {
            let played = self.row(row);
            self.note(row, played);
        }
    }

    /// Notes the error of a row that failed.
    fn note(&mut self, row: usize, played: Result<(), Error>) {
        if let Err(error) = played {
            let balls = self.results.balls;
            self.results.pocket[row * balls..][..balls].fill(PADDING);
            self.results.errors.push((row, error));
        }
    }

    /// Writes the row of a shot with the results of a device; a shot that failed is played here.
    fn copy(&mut self, waiting: &WaitingShot, ends: &FlatEnds, place: usize) {
        let WaitingShot { row, shot, strike } = waiting;
        let end = ends.end[place];
        if end.events == 0 {
            let played = self.simulate(*row, shot, *strike, None);
            self.note(*row, played);
            self.results.errors.sort_by_key(|(row, _)| *row);
            return;
        }
        let (count, first, from) =
            (shot.balls().len(), row * self.results.balls, place * ends.width);
        self.results.events[*row] = end.events as i32;
        self.results.duration[*row] = end.duration;
        self.results.pocket[first..][..count].copy_from_slice(&ends.pocket[from..][..count]);
        for (i, position) in ends.position[from..][..count].iter().enumerate() {
            for (column, x) in self.results.end.iter_mut().zip(position.to_array()) {
                column[first + i] = x;
            }
        }
    }

    fn row(&mut self, row: usize) -> Result<(), Error> {
        let rows = self.rows;
        let number = rows.layout[row] as usize;
        let layout = rows.layouts[number];
        if rows.columns.is_empty() {
            let recorder = self.outcomes.then(|| {
                let kept = &mut self.recorders[number];
                kept.get_or_insert_with(|| OutcomeRecorder::new(layout)).clone()
            });
            return self.shot(row, layout, recorder);
        }
        let is_same = |&(other, _): &(usize, ShotFile)| {
            rows.layout[other] == rows.layout[row]
                && rows.columns.iter().all(|column| column.values.same(other, row))
        };
        let made = match self.made.take().filter(is_same) {
            Some(made) => made,
            None => (row, rows.make(row, layout)?),
        };
        let recorder = self.outcomes.then(|| OutcomeRecorder::new(&made.1));
        let result = self.shot(row, &made.1, recorder);
        self.made = Some(made);
        result
    }

    /// Plays `shot` with the row's strike.
    fn shot(
        &mut self,
        row: usize,
        shot: &Shot,
        outcome: Option<OutcomeRecorder<'_>>,
    ) -> Result<(), Error> {
        let Some((struck, own)) = shot.strike() else {
            return self.simulate(row, shot, None, outcome);
        };
        let mut strike = self.rows.meant(row, shot, own);
        shot.resolve_strike(&strike)?;
        if let Some((noise, seed, index)) = self.rows.noise {
            let ball = StruckBall::of(shot, &shot.balls()[struck].ball);
            strike = noise.draw(&strike, &ball, seed, index[row] as u64);
            let Strike { speed, azimuth, elevation, side, height } = strike;
            let drawn = [speed, degrees(azimuth), degrees(elevation), side, height];
            for (column, value) in self.results.strike.iter_mut().zip(drawn) {
                column[row] = value;
            }
            shot.resolve_strike(&strike)?;
            let variant = noise.with_cling(shot, seed, index[row] as u64);
            return self.simulate(row, &variant, Some((struck, strike)), outcome);
        }
        self.simulate(row, shot, Some((struck, strike)), outcome)
    }

    fn simulate(
        &mut self,
        row: usize,
        shot: &Shot,
        strike: Option<(usize, Strike)>,
        outcome: Option<OutcomeRecorder<'_>>,
    ) -> Result<(), Error> {
        let count = shot.balls().len();
        let cue_ball = shot.cue_ball().and_then(|i| i16::try_from(i).ok());
        self.results.cue_ball[row] = cue_ball.unwrap_or(NONE);
        if let Some(waiting) = &mut self.waiting
            && count <= waiting.most_balls
        {
            waiting.flat.push(shot, strike);
            waiting.shots.push(WaitingShot { row, shot: shot.clone(), strike });
            return Ok(());
        }
        let first = row * self.results.balls;
        let pockets = &mut self.results.pocket[first..][..count];
        let pockets = PocketRecorder::new(pockets);
        let Summary { duration, events } = if let Some(outcome) = outcome {
            let mut recorder = (pockets, outcome);
            let played = self.simulator.play_strike(shot, strike, &mut recorder)?;
            let last = |i| self.simulator.state(i, played.duration);
            let last: Vec<_> = (0..count).map(last).collect();
            self.results.outcomes[row] = OutcomeColumns::from(&recorder.1.finish(&last));
            played
        } else {
            let mut pockets = pockets;
            self.simulator.play_strike(shot, strike, &mut pockets)?
        };
        self.results.events[row] = events as i32;
        self.results.duration[row] = duration;
        for i in 0..count {
            let state = self.simulator.file_state(i, shot, duration);
            for (column, x) in self.results.end.iter_mut().zip(state.position.to_array()) {
                column[first + i] = x;
            }
            if state.motion == MotionState::OffTable {
                self.results.pocket[first + i] = OFF_TABLE;
            }
        }
        Ok(())
    }
}
