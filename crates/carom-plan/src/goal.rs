//! What a strike is to bring about, and by how much one misses that.

use carom::event::{Event, EventKind, Recorder};
use carom::math::Vec2;
use carom::resolve::cue_ball::Strike;
use carom::simulate::Simulation;
use carom::{Error, MotionState, Shot};

use crate::errs::{Chance, Errs};
use crate::places::{Places, distance};
use crate::way::{Log, Way};

/// A miss where the cue ball is lost, which no goal wants, m: more than a table is long, so that nothing
/// else is as bad.
const LOST_CUE_BALL: f64 = 10.0;

/// What a strike is to bring about: all the parts that are there, and the cue ball stays on the table.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Goal {
    /// This ball falls, into that pocket or into any.
    pub pot: Option<(usize, Option<usize>)>,
    /// The cue ball comes to rest with its centre in this disc.
    pub leave: Option<Disc>,
    /// The cue ball touches this ball before any other.
    pub first: Option<usize>,
}

/// A disc on the table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    /// Its centre in the file's frame, m.
    pub center: [f64; 2],
    /// m.
    pub radius: f64,
}

impl Goal {
    /// Refuses goals that no strike of `shot` can have.
    ///
    /// # Errors
    /// [`Error::Input`] for a goal without parts, a ball or pocket that does not exist, the cue ball where
    /// another is meant, a disc without size, and a shot without strike: it says which ball is struck.
    pub fn check(&self, shot: &Shot) -> Result<(), Error> {
        let refuse = |place: &str, what: &str, remedy: &str| Err(Error::input(place, what, remedy));
        let Some((cue_ball, _)) = shot.strike() else {
            return refuse(
                "strike",
                "the shot has none",
                "give it one: it says which ball is struck",
            );
        };
        if *self == Self::default() {
            return refuse(
                "goal",
                "nothing is wanted",
                "say what is to fall, to be left or to be hit",
            );
        }
        let (balls, pockets) = (shot.balls().len(), shot.table().pockets.len());
        for ball in self.pot.iter().map(|(ball, _)| *ball).chain(self.first) {
            if ball >= balls || ball == cue_ball {
                return refuse("goal", "there is no such object ball", "name a ball of the shot");
            }
        }
        if let Some((_, pocket)) = self.pot
            && pocket.map_or(pockets == 0, |pocket| pocket >= pockets)
        {
            return refuse("goal", "the table has no such pocket", "name one of its pockets");
        }
        if let Some(Disc { center: [x, y], radius }) = self.leave
            && !(radius > 0.0 && radius.is_finite() && x.is_finite() && y.is_finite())
        {
            return refuse(
                "goal",
                "the area has no size",
                "give centre and radius in m, radius > 0",
            );
        }
        Ok(())
    }
}

/// What came of one strike.
#[derive(Clone, Debug)]
pub struct Attempt {
    /// How far from the goal, m; 0 if it is met.
    pub miss: f64,
    /// How the cue ball's motion came to the ball that counts.
    pub way: Way,
    /// Where the cue ball is at the end, m, in the file's frame.
    pub cue_ball_end: [f64; 2],
}

impl Attempt {
    /// Whether the goal is met.
    pub fn is_met(&self) -> bool {
        self.miss == 0.0
    }
}

/// Listens to a shot for how near it comes to a goal.
#[derive(Clone, Debug)]
pub(crate) struct Listener {
    goal: Goal,
    cue_ball: usize,
    /// Centres of the pockets that count.
    targets: Vec<(usize, Vec2)>,
    log: Log,
    places: Places,
    /// Least distance of the potted ball's path from a target.
    pot: f64,
    potted: bool,
    moved: bool,
    /// Least gap between the cue ball's path and the ball that it is to reach.
    gap: f64,
    first_touched: Option<usize>,
}

impl Listener {
    pub(crate) fn new(shot: &Shot, goal: Goal) -> Self {
        let cue_ball = shot.cue_ball().unwrap_or_default();
        let places = Places::new(shot);
        let wanted = |i: usize| goal.pot.is_some_and(|(_, pocket)| pocket.is_none_or(|p| p == i));
        let pockets = shot.table().pockets.iter().enumerate();
        let targets = pockets.filter(|(i, _)| wanted(*i)).map(|(i, p)| (i, p.center)).collect();
        Self {
            goal,
            cue_ball,
            targets,
            log: Log::new(cue_ball, &places),
            places,
            pot: f64::INFINITY,
            potted: false,
            moved: false,
            gap: f64::INFINITY,
            first_touched: None,
        }
    }

    /// The ball to be reached by the cue ball.
    fn reached(&self) -> Option<usize> {
        self.goal.first.or(self.goal.pot.map(|(ball, _)| ball))
    }

    /// Ball `i` has come from where it was last to `to`.
    fn follow(&mut self, i: usize, to: Vec2) {
        let from = self.places.go(i, to);
        if self.goal.pot.is_some_and(|(ball, _)| ball == i) {
            for (_, target) in &self.targets {
                self.pot = self.pot.min(distance(from, to, *target));
            }
        }
        let searching =
            if self.goal.first.is_some() { self.first_touched.is_none() } else { !self.moved };
        if i == self.cue_ball
            && searching
            && let Some(ball) = self.reached()
        {
            let reach = self.places.radius(i) + self.places.radius(ball);
            self.gap = self.gap.min((distance(from, to, self.places.last(ball)) - reach).max(0.0));
        }
    }

    /// What came of it; `simulation` is at its end, `duration` after the strike.
    fn finish<const N: usize>(
        &mut self,
        shot: &Shot,
        simulation: &Simulation<N>,
        duration: f64,
    ) -> Attempt {
        for i in 0..self.places.count() {
            let end = simulation.state(i, duration).position.xy();
            self.follow(i, end);
        }
        let state = simulation.file_state(self.cue_ball, shot, duration);
        let end = [state.position.x, state.position.y];
        let mut miss = 0.0;
        if self.goal.pot.is_some() && !self.potted {
            miss += self.pot + if self.moved { 0.0 } else { self.gap };
        }
        if let Some(ball) = self.goal.first
            && self.first_touched != Some(ball)
        {
            // Another ball in the way is a miss even where the gap has closed.
            miss += self.gap.max(self.places.radius(ball));
        }
        if let Some(Disc { center: [x, y], radius }) = self.goal.leave {
            miss += (Vec2::new(end[0] - x, end[1] - y).length() - radius).max(0.0);
        }
        if matches!(state.motion, MotionState::Pocketed | MotionState::OffTable) {
            miss += LOST_CUE_BALL;
        }
        let target = self.goal.pot.map(|(ball, _)| ball).or(self.goal.first);
        let mut way = self.log.way(target, shot.table());
        if let (None, Some(ball)) = (self.goal.pot, self.goal.first) {
            way.end_at(ball);
        }
        Attempt { miss, way, cue_ball_end: end }
    }
}

impl Recorder for Listener {
    fn record(&mut self, event: &Event<'_>) {
        self.log.add(event, &self.places);
        for (ball, state) in event.balls.iter().zip(event.before) {
            self.follow(usize::from(*ball), state.position.xy());
        }
        self.places.settle(event);
        let has = |ball: usize| event.balls.iter().any(|b| usize::from(*b) == ball);
        match event.kind {
            EventKind::BallCollision => {
                if self.first_touched.is_none() && has(self.cue_ball) {
                    let others = event.balls.iter().map(|b| usize::from(*b));
                    let mut others = others.filter(|b| *b != self.cue_ball);
                    // Of balls that are touched at once the wanted one counts.
                    let wanted = self.goal.first.filter(|ball| has(*ball));
                    self.first_touched = wanted.or_else(|| others.next());
                }
                self.moved |= self.goal.pot.is_some_and(|(ball, _)| has(ball));
            }
            EventKind::PocketCollision(pocket) => {
                let into = self.targets.iter().any(|(i, _)| *i == usize::from(pocket));
                self.potted |= into && self.goal.pot.is_some_and(|(ball, _)| has(ball));
            }
            _ => (),
        }
    }
}

/// Plays strikes of one shot for one goal.
pub(crate) struct Player<'a, const N: usize> {
    shot: &'a Shot,
    fresh: Listener,
    simulation: Box<Simulation<N>>,
}

impl<'a, const N: usize> Player<'a, N> {
    pub(crate) fn new(shot: &'a Shot, goal: Goal) -> Self {
        Self { shot, fresh: Listener::new(shot, goal), simulation: Box::new(Simulation::new()) }
    }

    /// What comes of `strike`; none if it cannot be played.
    pub(crate) fn play(&mut self, strike: &Strike) -> Option<Attempt> {
        self.shot.resolve_strike(strike).ok()?;
        let (ball, _) = self.shot.strike()?;
        let mut listener = self.fresh.clone();
        let played = self.simulation.play_strike(self.shot, Some((ball, *strike)), &mut listener);
        Some(listener.finish(self.shot, &self.simulation, played.ok()?.duration))
    }

    /// What comes of `strike` where the balls lie as `seen` has them; none if it cannot be played.
    fn play_on(&mut self, seen: &Shot, strike: &Strike) -> Option<Attempt> {
        let (ball, _) = seen.strike()?;
        let mut listener = Listener::new(seen, self.fresh.goal);
        let played = self.simulation.play_strike(seen, Some((ball, *strike)), &mut listener);
        Some(listener.finish(seen, &self.simulation, played.ok()?.duration))
    }

    /// The chance that `strike` meets the goal.
    pub(crate) fn chance(&mut self, strike: &Strike, errs: &Errs) -> Chance {
        let struck = self.fresh.cue_ball;
        let radius = self.fresh.places.radius(struck);
        errs.count(|k| {
            let strike = errs.noise.draw(strike, radius, errs.seed, k);
            let attempt = if errs.perception.position == 0.0 {
                self.play(&strike)
            } else {
                let places = errs.perception.places(self.shot, errs.seed, k);
                let seen = self.shot.with_balls(places, Some((struck, strike))).ok();
                seen.and_then(|seen| self.play_on(&seen, &strike))
            };
            attempt.is_some_and(|a| a.is_met())
        })
    }
}
