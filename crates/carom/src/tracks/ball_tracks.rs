//! Observed positions of balls.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use crate::error::{Error, ErrorKind};
use crate::range::Range;

/// Standard deviation of an observed coordinate.
const SIGMA: Range = Range::positive(" m");

/// Observed positions of one ball. The three lists have the same length.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BallTrack {
    /// The ball's id.
    pub id: String,
    /// Times on the clock of the tracks, s, in any order.
    pub times: Vec<f64>,
    /// Positions x, y in the frame of the tracks, m.
    pub positions: Vec<[f64; 2]>,
    /// Standard deviations of each coordinate, m. With 1 a residual is in metres.
    pub sigmas: Vec<f64>,
}

/// Observed positions of some balls of a shot.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BallTracks {
    pub(super) tracks: Vec<SortedTrack>,
    samples: usize,
}

/// The samples of a ball in the order of time.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SortedTrack {
    pub(super) id: String,
    pub(super) samples: Vec<TrackPoint>,
}

/// An observed position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TrackPoint {
    pub(super) time: f64,
    pub(super) position: [f64; 2],
    /// 1/σ.
    pub(super) weight: f64,
    /// Index among all samples, in the given order.
    pub(super) index: usize,
}

impl BallTracks {
    /// The tracks of some balls, at most one for each ball.
    ///
    /// # Errors
    /// [`Error::Input`] at `<id>.times[k]` and the like if a number is not finite or a σ not above 0,
    /// if the lists of a ball differ in length, and if a ball has two tracks.
    pub fn new(tracks: Vec<BallTrack>) -> Result<Self, Error> {
        let mut sorted: Vec<SortedTrack> = Vec::with_capacity(tracks.len());
        let mut first = 0;
        for track in tracks {
            if sorted.iter().any(|other| other.id == track.id) {
                let what = "the ball has two tracks";
                return Err(ErrorKind::Duplicate.at(track.id, what, "join them"));
            }
            check(&track).map_err(|error| error.inside(&track.id))?;
            let columns = track.times.iter().zip(&track.positions).zip(&track.sigmas);
            let mut samples: Vec<TrackPoint> = columns
                .enumerate()
                .map(|(k, ((&time, &position), &sigma))| TrackPoint {
                    time,
                    position,
                    weight: 1.0 / sigma,
                    index: first + k,
                })
                .collect();
            samples.sort_by(|a, b| a.time.total_cmp(&b.time));
            first += samples.len();
            sorted.push(SortedTrack { id: track.id, samples });
        }
        Ok(Self { tracks: sorted, samples: first })
    }

    /// The balls' ids, in the given order.
    pub fn ids(&self) -> impl ExactSizeIterator<Item = &str> {
        self.tracks.iter().map(|track| &*track.id)
    }

    /// Number of samples of all balls.
    pub const fn len(&self) -> usize {
        self.samples
    }

    /// Whether there is no sample.
    pub const fn is_empty(&self) -> bool {
        self.samples == 0
    }

    /// Number of samples of track `track` up to `horizon`, s on the clock of the tracks.
    ///
    /// # Panics
    /// If there is no such track.
    pub fn count(&self, track: usize, horizon: f64) -> usize {
        self.tracks[track].samples.partition_point(|sample| sample.time <= horizon)
    }
}

fn check(track: &BallTrack) -> Result<(), Error> {
    let BallTrack { times, positions, sigmas, .. } = track;
    for (key, length) in [("positions", positions.len()), ("sigmas", sigmas.len())] {
        if length != times.len() {
            let what = format!("found {length} entries for {} times", times.len());
            let error = ErrorKind::WrongCount.at(key, what, "give one for each time");
            return Err(error.with("count", length as f64));
        }
    }
    for (k, time) in times.iter().enumerate() {
        Range::any(" s").check(|| format!("times[{k}]"), *time)?;
    }
    for (k, position) in positions.iter().enumerate() {
        for x in position {
            Range::any(" m").check(|| format!("positions[{k}]"), *x)?;
        }
    }
    for (k, sigma) in sigmas.iter().enumerate() {
        SIGMA.check(|| format!("sigmas[{k}]"), *sigma)?;
    }
    Ok(())
}
