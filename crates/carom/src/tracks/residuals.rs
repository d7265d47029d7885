//! Differences of simulated positions from tracks.

use alloc::format;
use alloc::vec;
use alloc::vec::Vec;

use super::CHUNK;
use super::ball_tracks::{BallTracks, SortedTrack, TrackPoint};
use super::follow::{Follower, Leg, Observer, PlanLeg};
use crate::candidates::Candidates;
use crate::error::{Error, ErrorKind};
use crate::math::{Vec2, sin_cos};
use crate::range::Range;
use crate::runner::Runner;
use crate::{BallState, Shot, Table};

/// How the frame of the tracks lies on the table: the point p of a track is at
/// c + scale·R(rotation)(p − c) + offset, where c is the centre of the playing area, or the origin on
/// unbounded cloth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrackFrame {
    /// Displacement, m.
    pub offset: [f64; 2],
    /// Rotation, counter-clockwise, rad.
    pub rotation: f64,
    /// Scale, > 0.
    pub scale: f64,
}

impl Default for TrackFrame {
    fn default() -> Self {
        Self { offset: [0.0; 2], rotation: 0.0, scale: 1.0 }
    }
}

/// Which residuals are wanted.
#[derive(Clone, Debug, PartialEq)]
pub struct TrackQuestion<'a> {
    /// Time of the strike on the clock of the tracks, s: one, or one for each candidate.
    pub clocks: &'a [f64],
    /// The frame of the tracks: one, or one for each candidate.
    pub frames: &'a [TrackFrame],
    /// Times on the clock of the tracks, s, in ascending order, infinite for no limit. Samples behind
    /// the last one are left out, and nothing is simulated for them.
    pub horizons: &'a [f64],
    /// Whether the residuals of single samples are wanted, and not only their sums.
    pub samples: bool,
}

/// Residuals of candidates: simulated minus observed positions, divided by σ.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Residuals {
    /// Samples of the longest tracks.
    pub samples: usize,
    /// Tracks of balls in the tracks with the most.
    pub tracks: usize,
    /// Residuals in x and y, candidate by candidate, `samples` each, in the given order of balls and
    /// samples; 0 behind the last horizon and where the tracks have fewer samples. NaN if the
    /// candidate failed. Empty if they are not wanted.
    pub residual: Vec<[f64; 2]>,
    /// Sums of x² + y² of the residuals up to each horizon, in the order candidate, track, horizon;
    /// NaN if the candidate failed.
    pub sum: Vec<f64>,
    /// Number of samples of each track, within the last horizon, at whose time the simulated ball is
    /// in a pocket or off the table. It is compared with the place where it is then.
    pub out_of_play: Vec<u32>,
    /// The candidates that failed, by index, in ascending order.
    pub errors: Vec<(usize, Error)>,
}

/// The residuals of every candidate, on the threads of `runner`. `tracks` are those of all
/// candidates, or one for each of [`Candidates::shots`]. Before the strike a ball is at its start.
///
/// # Errors
/// [`Error::Input`] for a wrong number of tracks, clocks or frames, a track whose ball a shot does not
/// have, and horizons that do not ascend. A clock or a frame that is out of range is an error of its
/// candidate.
pub fn track_residuals(
    candidates: &Candidates,
    tracks: &[&BallTracks],
    question: &TrackQuestion<'_>,
    runner: &Runner,
) -> Result<Residuals, Error> {
    check(candidates, tracks, question)?;
    let plans: Vec<Plan<'_>> = (candidates.shots().iter().enumerate())
        .map(|(s, shot)| Plan::new(shot, s, tracks, question))
        .collect::<Result<_, _>>()?;
    let most = |of: fn(&BallTracks) -> usize| tracks.iter().map(|t| of(t)).max().unwrap_or(0);
    let (samples, width) = (most(BallTracks::len), most(|tracks| tracks.ids().len()));
    let sums = width * question.horizons.len();
    let count = candidates.len();
    let mut result = Residuals {
        samples,
        tracks: width,
        residual: vec![[0.0; 2]; if question.samples { count * samples } else { 0 }],
        sum: vec![0.0; count * sums],
        out_of_play: vec![0; count * width],
        errors: Vec::new(),
    };
    if samples == 0 || sums == 0 {
        return Ok(result);
    }
    let Residuals { residual, sum, out_of_play, errors, .. } = &mut result;
    let mut residuals = residual.chunks_mut(CHUNK * samples);
    let chunks = sum.chunks_mut(CHUNK * sums).zip(out_of_play.chunks_mut(CHUNK * width));
    let chunks = chunks.enumerate().map(|(c, (sum, out_of_play))| {
        (c * CHUNK, residuals.next().unwrap_or_default(), sum, out_of_play)
    });
    let found = runner.map(chunks, Worker::default, |worker, (first, residual, sum, out)| {
        let mut failed = Vec::new();
        let rows = sum.chunks_mut(sums).zip(out.chunks_mut(width));
        for (k, (sum, out_of_play)) in rows.enumerate() {
            let residual = residual.get_mut(k * samples..(k + 1) * samples).unwrap_or_default();
            let mut row = Row { residual, sum, out_of_play };
            let plan = &plans[candidates.shot_of(first + k)];
            if let Err(error) = worker.fill(candidates, first + k, plan, &mut row) {
                row.residual.fill([f64::NAN; 2]);
                row.sum.fill(f64::NAN);
                row.out_of_play.fill(0);
                failed.push((first + k, error));
            }
        }
        failed
    });
    *errors = found.into_iter().flatten().collect();
    Ok(result)
}

fn check(
    candidates: &Candidates,
    tracks: &[&BallTracks],
    question: &TrackQuestion<'_>,
) -> Result<(), Error> {
    let TrackQuestion { clocks, frames, horizons, .. } = question;
    let (count, shots) = (candidates.len(), candidates.shots().len());
    for (place, found, all) in [
        ("tracks", tracks.len(), shots),
        ("clocks", clocks.len(), count),
        ("frames", frames.len(), count),
    ] {
        if found != 1 && found != all {
            let remedy = format!("give one, or {all}");
            let error = ErrorKind::WrongCount.at(place, format!("found {found}"), remedy);
            return Err(error.with("count", found as f64));
        }
    }
    if horizons.is_empty() || horizons.iter().any(|h| h.is_nan()) || !horizons.is_sorted() {
        let what = "not times in ascending order";
        return Err(ErrorKind::OutOfRange.at("horizons", what, "sort them"));
    }
    Ok(())
}

/// What the residuals of one shot's candidates need.
struct Plan<'a> {
    question: &'a TrackQuestion<'a>,
    tracks: &'a [SortedTrack],
    /// For each ball of the shot the index of its track.
    track_of: Vec<Option<usize>>,
    /// Number of samples of each track within each horizon.
    within: Vec<usize>,
    /// Time of the last of these samples, s; −∞ if there is none.
    last: f64,
}

impl<'a> Plan<'a> {
    fn new(
        shot: &Shot,
        index: usize,
        tracks: &[&'a BallTracks],
        question: &'a TrackQuestion<'a>,
    ) -> Result<Self, Error> {
        let tracks = if tracks.len() == 1 { tracks[0] } else { tracks[index] };
        if let Some(id) = tracks.ids().find(|id| shot.ball_index(id).is_none()) {
            let what = format!("shot {index} has no ball \"{id}\"");
            let remedy = "leave its track out, or give it the id of the ball";
            return Err(ErrorKind::UnknownBall.at("tracks", what, remedy).with("ball", id));
        }
        let track_of =
            shot.balls().iter().map(|b| tracks.ids().position(|id| id == b.id)).collect();
        let horizons = question.horizons;
        let within: Vec<usize> = (0..tracks.tracks.len())
            .flat_map(|track| horizons.iter().map(move |horizon| tracks.count(track, *horizon)))
            .collect();
        let plan = Self { question, tracks: &tracks.tracks, track_of, within, last: 0.0 };
        let times = (0..plan.tracks.len())
            .filter_map(|track| plan.used(track).last().map(|sample| sample.time));
        let last = times.fold(f64::NEG_INFINITY, f64::max);
        Ok(Self { last, ..plan })
    }

    /// Number of samples of a track within each horizon.
    fn within(&self, track: usize) -> &[usize] {
        let horizons = self.question.horizons.len();
        &self.within[track * horizons..(track + 1) * horizons]
    }

    /// The samples of a track within the last horizon, in the order of time.
    fn used(&self, track: usize) -> &'a [TrackPoint] {
        &self.tracks[track].samples[..self.within(track).last().copied().unwrap_or(0)]
    }
}

/// The results of a candidate.
struct Row<'a> {
    residual: &'a mut [[f64; 2]],
    sum: &'a mut [f64],
    out_of_play: &'a mut [u32],
}

/// What a thread needs.
#[derive(Default)]
struct Worker {
    follower: Follower,
    done: Vec<usize>,
}

impl Worker {
    fn fill(
        &mut self,
        candidates: &Candidates,
        k: usize,
        plan: &Plan<'_>,
        row: &mut Row<'_>,
    ) -> Result<(), Error> {
        let shot = candidates.shot(k)?;
        let TrackQuestion { clocks, frames, horizons, .. } = *plan.question;
        let clock = if clocks.len() == 1 { clocks[0] } else { clocks[k] };
        Range::any(" s").check(|| "clock".into(), clock)?;
        let frame = if frames.len() == 1 { &frames[0] } else { &frames[k] };
        let frame = Affine::new(frame, shot.table())?;
        if plan.last == f64::NEG_INFINITY {
            return Ok(());
        }
        self.done.clear();
        self.done.resize(plan.tracks.len(), 0);
        let mut observer = ResidualObserver { plan, clock, frame, row, done: &mut self.done };
        self.follower.play(&shot, (plan.last - clock).max(0.0), &mut observer)?;
        for sums in observer.row.sum.chunks_mut(horizons.len()) {
            let mut total = 0.0;
            for sum in sums {
                total += *sum;
                *sum = total;
            }
        }
        Ok(())
    }
}

/// A frame as a map p ↦ (ax − by + cx, bx + ay + cy). The identity changes no bit.
#[derive(Clone, Copy)]
struct Affine {
    a: f64,
    b: f64,
    c: Vec2,
}

impl Affine {
    fn new(frame: &TrackFrame, table: &Table) -> Result<Self, Error> {
        let TrackFrame { offset, rotation, scale } = *frame;
        for x in offset {
            Range::any(" m").check(|| "offset".into(), x)?;
        }
        Range::any(" rad").check(|| "rotation".into(), rotation)?;
        Range::positive("").check(|| "scale".into(), scale)?;
        let (sin, cos) = sin_cos(rotation);
        let (a, b, center) = (scale * cos, scale * sin, table.center());
        let turned = Vec2::new(a * center.x - b * center.y, b * center.x + a * center.y);
        Ok(Self { a, b, c: center - turned + Vec2::new(offset[0], offset[1]) })
    }

    #[inline(always)]
    fn apply(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.a * x - self.b * y + self.c.x, self.b * x + self.a * y + self.c.y]
    }
}

struct ResidualObserver<'a, 'r> {
    plan: &'a Plan<'a>,
    clock: f64,
    frame: Affine,
    row: &'a mut Row<'r>,
    /// For each track, how many of its samples are done.
    done: &'a mut [usize],
}

impl ResidualObserver<'_, '_> {
    /// Takes the samples of a track before `end`, s since the strike. At a negative time the ball is
    /// at its start.
    fn take(&mut self, track: usize, end: f64, in_play: bool, leg: PlanLeg) {
        let plan = self.plan;
        let (samples, from) = (plan.used(track), self.done[track]);
        let left = samples[from..].partition_point(|sample| sample.time - self.clock < end);
        let (mut done, until) = (from, from + left);
        for (h, within) in plan.within(track).iter().enumerate() {
            let stop = until.min(*within);
            if done < stop {
                let part = &samples[done..stop];
                let sum = if plan.question.samples {
                    self.squares::<true>(part, leg)
                } else {
                    self.squares::<false>(part, leg)
                };
                self.row.sum[track * plan.question.horizons.len() + h] += sum;
                done = stop;
            }
        }
        self.done[track] = until;
        if !in_play {
            self.row.out_of_play[track] += left as u32;
        }
    }

    /// The sum of squares of the residuals of `samples`, which are stored if `STORE`.
    #[inline(always)]
    fn squares<const STORE: bool>(&mut self, samples: &[TrackPoint], leg: PlanLeg) -> f64 {
        let (clock, frame) = (self.clock, self.frame);
        let mut sum = 0.0;
        for sample in samples {
            let time = sample.time - clock;
            let simulated = leg.position_at(if time > 0.0 { time } else { 0.0 });
            let [x, y] = frame.apply(sample.position);
            let rx = (simulated.x - x) * sample.weight;
            let ry = (simulated.y - y) * sample.weight;
            sum += rx * rx + ry * ry;
            if STORE {
                self.row.residual[sample.index] = [rx, ry];
            }
        }
        sum
    }
}

impl Observer for ResidualObserver<'_, '_> {
    #[inline]
    fn wants_before(&self, ball: usize, end: f64) -> bool {
        let Some(track) = self.plan.track_of[ball] else { return false };
        let next = self.plan.used(track).get(self.done[track]);
        next.is_some_and(|sample| sample.time - self.clock < end)
    }

    fn observe(&mut self, ball: usize, leg: &Leg<'_>, end: f64) {
        if let Some(track) = self.plan.track_of[ball] {
            self.take(track, end, leg.in_play(), leg.in_plan());
        }
    }

    fn observe_end(&mut self, ball: usize, state: &BallState) {
        if let Some(track) = self.plan.track_of[ball] {
            let leg = PlanLeg::at_rest(state.position.xy());
            self.take(track, f64::INFINITY, state.motion.in_play(), leg);
        }
    }
}
