//! The flat arrays, and the simulation of one of their shots.

use alloc::sync::Arc;
use alloc::vec::Vec;

use crate::math::Vec3;
use crate::pocket::{OFF_TABLE, PocketRecorder};
use crate::resolve::cue_ball::Strike;
use crate::shot::{Cling, PlacedBall};
use crate::simulate::{Simulation, Surroundings};
use crate::table::TableGeometry;
use crate::{Ball, BallState, MotionState, Physics, Shot, Table};

/// `struck` of a shot without a strike.
pub const NO_STRIKE: u32 = u32::MAX;

/// A ball and its state at the start, in the file's coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct FlatBall {
    /// Mass and radius.
    pub ball: Ball,
    /// State at time 0.
    pub state: BallState,
}

/// A shot; table, physics and balls are indices into the arrays of its [`FlatView`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct FlatShot {
    /// Index of the table.
    pub table: u32,
    /// Index of the physics.
    pub physics: u32,
    /// Index of the first ball.
    pub first_ball: u32,
    /// Number of balls.
    pub balls: u32,
    /// Index of the struck ball among these, or [`NO_STRIKE`].
    pub struck: u32,
    /// The cap on the number of events.
    pub max_events: u32,
    /// The strike; without effect if there is none.
    pub strike: Strike,
    /// The end time, s; [`f64::MAX`] for an end at rest.
    pub until: f64,
    /// The contacts that cling.
    pub cling: Cling,
}

/// The end of a shot.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct FlatEnd {
    /// Time of the last event, s.
    pub duration: f64,
    /// Number of events; 0 if the shot failed. Played on this machine, it has its error.
    pub events: u32,
    /// Not used.
    pub padding: u32,
}

/// The arrays of many shots, borrowed.
#[derive(Clone, Copy, Debug)]
pub struct FlatView<'a> {
    /// The tables.
    pub tables: &'a [TableGeometry],
    /// The physics.
    pub physics: &'a [Physics],
    /// The balls of all shots.
    pub balls: &'a [FlatBall],
    /// The shots.
    pub shots: &'a [FlatShot],
}

/// What shots can share.
type Shared = (Arc<Table>, Arc<Physics>, Arc<[PlacedBall]>);

/// The arrays of many shots. Shots that share a table, physics or balls share their places in the
/// arrays.
#[derive(Clone, Debug, Default)]
pub struct FlatShots {
    /// The tables.
    pub tables: Vec<TableGeometry>,
    /// The physics.
    pub physics: Vec<Physics>,
    /// The balls of all shots.
    pub balls: Vec<FlatBall>,
    /// The shots.
    pub shots: Vec<FlatShot>,
    /// Number of balls of the largest shot.
    pub width: usize,
    /// What the last shot shared, and its places: most shots of a batch share it with the next.
    last: Option<Shared>,
}

impl FlatShots {
    /// Adds `shot` with this strike: the index of the struck ball, and the strike.
    ///
    /// # Panics
    /// If the arrays would have more than 2³² − 1 balls.
    pub fn push(&mut self, shot: &Shot, strike: Option<(usize, Strike)>) {
        let Shot { table, physics, balls, .. } = shot;
        let last = self.last.as_ref();
        if !last.is_some_and(|(last, ..)| Arc::ptr_eq(last, table)) {
            self.tables.push(table.geometry.clone());
        }
        if !last.is_some_and(|(_, last, _)| Arc::ptr_eq(last, physics)) {
            self.physics.push(Physics::clone(physics));
        }
        if !last.is_some_and(|(.., last)| Arc::ptr_eq(last, balls)) {
            let flat = |placed: &PlacedBall| FlatBall { ball: placed.ball, state: placed.state };
            self.balls.extend(balls.iter().map(flat));
        }
        let index = |count: usize| u32::try_from(count).expect("fewer than 2^32 of each");
        let (struck, strike) = match strike {
            Some((struck, strike)) => (index(struck), strike),
            None => (NO_STRIKE, Strike::default()),
        };
        self.width = self.width.max(balls.len());
        self.shots.push(FlatShot {
            table: index(self.tables.len() - 1),
            physics: index(self.physics.len() - 1),
            first_ball: index(self.balls.len() - balls.len()),
            balls: index(balls.len()),
            struck,
            max_events: shot.max_events,
            strike,
            until: shot.until.unwrap_or(f64::MAX),
            cling: *shot.cling(),
        });
        self.last = Some((table.clone(), physics.clone(), balls.clone()));
    }

    /// The arrays, borrowed.
    pub fn view(&self) -> FlatView<'_> {
        let Self { tables, physics, balls, shots, .. } = self;
        FlatView { tables, physics, balls, shots }
    }
}

/// Where the results of a shot are written; one place for each ball.
#[derive(Debug)]
pub struct FlatRow<'a> {
    /// Final centres in the file's coordinates, m.
    pub position: &'a mut [Vec3],
    /// Pockets, as in [`BatchResult::pocket`](crate::batch::BatchResult::pocket).
    pub pocket: &'a mut [i8],
}

impl FlatView<'_> {
    /// Plays the shot with the index `k` in `simulation` and writes its results.
    ///
    /// # Panics
    /// If there is no such shot, or if it has more than `N` balls.
    #[inline]
    pub fn play<const N: usize>(
        &self,
        k: usize,
        simulation: &mut Simulation<N>,
        row: FlatRow<'_>,
    ) -> FlatEnd {
        let shot = &self.shots[k];
        let count = shot.balls as usize;
        let balls = &self.balls[shot.first_ball as usize..][..count];
        let surroundings = Surroundings {
            table: &self.tables[shot.table as usize],
            physics: &self.physics[shot.physics as usize],
            cling: &shot.cling,
            max_events: shot.max_events,
            until: shot.until,
        };
        let strike = (shot.struck != NO_STRIKE).then_some((shot.struck as usize, shot.strike));
        let FlatRow { position, pocket } = row;
        let mut recorder = PocketRecorder::new(&mut pocket[..count]);
        let starts = balls.iter().map(|placed| (&placed.ball, &placed.state));
        let Ok(summary) =
            simulation.play_among(&surroundings, starts, strike, f64::MAX, &mut recorder)
        else {
            return FlatEnd::default();
        };
        for (i, start) in balls.iter().enumerate() {
            let state = simulation.state(i, summary.duration);
            position[i] =
                surroundings.table.to_file_coordinates_from(&start.state, &state).position;
            if state.motion == MotionState::OffTable {
                pocket[i] = OFF_TABLE;
            }
        }
        FlatEnd { duration: summary.duration, events: summary.events, padding: 0 }
    }
}
