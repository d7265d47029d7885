//! States of balls at given times.

use alloc::format;
use alloc::vec;
use alloc::vec::Vec;

use super::CHUNK;
use super::follow::{Follower, Leg, Observer};
use crate::BallState;
use crate::candidates::Candidates;
use crate::error::{Error, ErrorKind};
use crate::runner::Runner;

/// Which states are wanted.
#[derive(Clone, Debug, PartialEq)]
pub struct StateQuestion<'a> {
    /// Times since the strike, s, in any order: `count` common ones, or `count` for each candidate.
    /// At a time that is NaN the state is NaN.
    pub times: &'a [f64],
    /// Number of times of a candidate.
    pub count: usize,
    /// Indices of the balls.
    pub balls: &'a [usize],
    /// Whether velocities are wanted.
    pub velocity: bool,
    /// Whether spins are wanted.
    pub angular_velocity: bool,
}

/// States, in the order candidate, time, ball. The rows of a failed candidate, and of a ball that a
/// shot does not have, are NaN and not in play.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SampledStates {
    /// Centres in the file's coordinates, m.
    pub position: Vec<[f64; 3]>,
    /// Velocities, m/s; empty if they are not wanted.
    pub velocity: Vec<[f64; 3]>,
    /// Spins, rad/s; empty if they are not wanted.
    pub angular_velocity: Vec<[f64; 3]>,
    /// Whether the ball takes part in the shot: it is in no pocket, and on the table.
    pub in_play: Vec<bool>,
    /// The candidates that failed, by index, in ascending order.
    pub errors: Vec<(usize, Error)>,
}

/// The states of `question` for every candidate, on the threads of `runner`. The states of a
/// candidate have the bits of [`Trace::at`](crate::Trace::at) for
/// [`Candidates::shot`](crate::candidates::Candidates::shot).
///
/// # Errors
/// [`Error::Input`] for a time that is negative or infinite, for a wrong number of times, and for a
/// ball that no shot has.
pub fn sample_states(
    candidates: &Candidates,
    question: &StateQuestion<'_>,
    runner: &Runner,
) -> Result<SampledStates, Error> {
    check(candidates, question)?;
    let StateQuestion { times, count, balls, .. } = *question;
    let width = count * balls.len();
    let numbers = candidates.len() * width;
    let nan = |wanted: bool| vec![[f64::NAN; 3]; if wanted { numbers } else { 0 }];
    let mut result = SampledStates {
        position: nan(true),
        velocity: nan(question.velocity),
        angular_velocity: nan(question.angular_velocity),
        in_play: vec![false; numbers],
        errors: Vec::new(),
    };
    if width == 0 {
        return Ok(result);
    }
    let common = (times.len() == count).then(|| in_order(times));
    let SampledStates { position, velocity, angular_velocity, in_play, errors } = &mut result;
    let rows = CHUNK * width;
    let mut velocities = velocity.chunks_mut(rows);
    let mut spins = angular_velocity.chunks_mut(rows);
    let chunks = position.chunks_mut(rows).zip(in_play.chunks_mut(rows)).enumerate();
    let chunks = chunks.map(|(c, (position, in_play))| {
        let velocity = velocities.next().unwrap_or_default();
        let spin = spins.next().unwrap_or_default();
        (c * CHUNK, Rows { position, velocity, spin, in_play })
    });
    let found = runner.map(chunks, Worker::default, |worker, (first, mut rows)| {
        let mut failed = Vec::new();
        let in_chunk = rows.position.len() / width;
        for k in 0..in_chunk {
            let own;
            let (times, order) = match &common {
                Some(order) => (times, order),
                None => {
                    let times = &times[(first + k) * count..(first + k + 1) * count];
                    own = in_order(times);
                    (times, &own)
                }
            };
            let wanted = Wanted { times, order, balls };
            let row = rows.row(k, width);
            if let Err(error) = worker.fill(candidates, first + k, &wanted, row) {
                rows.row(k, width).forget();
                failed.push((first + k, error));
            }
        }
        failed
    });
    *errors = found.into_iter().flatten().collect();
    Ok(result)
}

fn check(candidates: &Candidates, question: &StateQuestion<'_>) -> Result<(), Error> {
    let StateQuestion { times, count, balls, .. } = question;
    if times.len() != *count && times.len() != count * candidates.len() {
        let what = format!("found {} times", times.len());
        let remedy =
            format!("give {count}, or {count} for each of {} candidates", candidates.len());
        return Err(ErrorKind::WrongCount.at("times", what, remedy));
    }
    if let Some(k) = times.iter().position(|t| *t < 0.0 || t.is_infinite()) {
        let what = format!("{:?} s is out of range", times[k]);
        let remedy = "give finite times ≥ 0, or NaN for no time";
        return Err(ErrorKind::OutOfRange.at(format!("times[{k}]"), what, remedy));
    }
    if let Some(&ball) = balls.iter().find(|ball| **ball >= candidates.balls()) {
        let what = format!("there is no ball {ball}");
        let remedy = format!("count the {} balls from 0", candidates.balls());
        return Err(ErrorKind::UnknownBall.at("balls", what, remedy).with("ball", ball as f64));
    }
    if let Some(k) = (1..balls.len()).find(|&k| balls[..k].contains(&balls[k])) {
        let what = format!("ball {} is there twice", balls[k]);
        return Err(ErrorKind::Duplicate.at(format!("balls[{k}]"), what, "leave one out"));
    }
    Ok(())
}

/// The indices of times that are not NaN, in the order of time.
fn in_order(times: &[f64]) -> Vec<u32> {
    let mut order: Vec<u32> = (0..times.len() as u32).collect();
    order.retain(|&k| !times[k as usize].is_nan());
    order.sort_by(|&a, &b| times[a as usize].total_cmp(&times[b as usize]));
    order
}

struct Wanted<'a> {
    times: &'a [f64],
    order: &'a [u32],
    balls: &'a [usize],
}

/// The results of some candidates, or of one.
struct Rows<'a> {
    position: &'a mut [[f64; 3]],
    velocity: &'a mut [[f64; 3]],
    spin: &'a mut [[f64; 3]],
    in_play: &'a mut [bool],
}

impl Rows<'_> {
    /// Row `k` of `width` entries.
    fn row(&mut self, k: usize, width: usize) -> Rows<'_> {
        let range = k * width..(k + 1) * width;
        Rows {
            position: &mut self.position[range.clone()],
            velocity: self.velocity.get_mut(range.clone()).unwrap_or_default(),
            spin: self.spin.get_mut(range.clone()).unwrap_or_default(),
            in_play: &mut self.in_play[range],
        }
    }

    /// Removes what is known of a candidate that failed.
    fn forget(self) {
        self.position.fill([f64::NAN; 3]);
        self.velocity.fill([f64::NAN; 3]);
        self.spin.fill([f64::NAN; 3]);
        self.in_play.fill(false);
    }

    fn set(&mut self, index: usize, state: &BallState) {
        self.position[index] = state.position.to_array();
        if let Some(velocity) = self.velocity.get_mut(index) {
            *velocity = state.velocity.to_array();
        }
        if let Some(spin) = self.spin.get_mut(index) {
            *spin = state.angular_velocity.to_array();
        }
        self.in_play[index] = state.motion.in_play();
    }
}

/// What a thread needs.
#[derive(Default)]
struct Worker {
    follower: Follower,
    cursors: Vec<Cursor>,
}

/// What is wanted of a ball.
#[derive(Clone, Copy)]
struct Cursor {
    /// Its place in [`StateQuestion::balls`].
    column: usize,
    /// How many of its times are done, in the order of time.
    done: usize,
}

impl Worker {
    fn fill(
        &mut self,
        candidates: &Candidates,
        k: usize,
        wanted: &Wanted<'_>,
        row: Rows<'_>,
    ) -> Result<(), Error> {
        let shot = candidates.shot(k)?;
        let Some(&last) = wanted.order.last() else { return Ok(()) };
        let cursor = |ball: usize| {
            let column = wanted.balls.iter().position(|wanted| *wanted == ball);
            let done = if column.is_some() { 0 } else { wanted.order.len() };
            Cursor { column: column.unwrap_or(0), done }
        };
        self.cursors.clear();
        self.cursors.extend((0..shot.balls().len()).map(cursor));
        let mut observer = StateObserver { wanted, row, cursors: &mut self.cursors };
        self.follower.play(&shot, wanted.times[last as usize], &mut observer)
    }
}

struct StateObserver<'a> {
    wanted: &'a Wanted<'a>,
    row: Rows<'a>,
    cursors: &'a mut [Cursor],
}

impl StateObserver<'_> {
    /// Takes the times of ball `ball` before `end`, s.
    #[inline(always)]
    fn take(&mut self, ball: usize, end: f64, mut set: impl FnMut(&mut Rows<'_>, usize, f64)) {
        let Wanted { times, order, balls } = *self.wanted;
        let Cursor { column, done } = &mut self.cursors[ball];
        while let Some(&index) = order.get(*done) {
            let time = times[index as usize];
            if time >= end {
                break;
            }
            set(&mut self.row, index as usize * balls.len() + *column, time);
            *done += 1;
        }
    }
}

impl Observer for StateObserver<'_> {
    fn wants_before(&self, ball: usize, end: f64) -> bool {
        let next = self.wanted.order.get(self.cursors[ball].done);
        next.is_some_and(|&index| self.wanted.times[index as usize] < end)
    }

    fn observe(&mut self, ball: usize, leg: &Leg<'_>, end: f64) {
        if self.row.velocity.is_empty() && self.row.spin.is_empty() {
            let in_play = leg.in_play();
            self.take(ball, end, |row, index, time| {
                row.position[index] = leg.position_at(time).to_array();
                row.in_play[index] = in_play;
            });
        } else {
            self.take(ball, end, |row, index, time| row.set(index, &leg.state_at(time)));
        }
    }

    fn observe_end(&mut self, ball: usize, state: &BallState) {
        self.take(ball, f64::INFINITY, |row, index, _| row.set(index, state));
    }
}
