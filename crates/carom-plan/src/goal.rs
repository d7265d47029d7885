//! Goals of a strike, and the distance by which a strike misses its goal.

use carom::event::{Event, EventKind, Recorder};
use carom::math::Vec2;
use carom::noise::StruckBall;
use carom::resolve::cue_ball::Strike;
use carom::{Error, ErrorKind, MotionState, Shot, Simulator};

use crate::drawn_tables::DrawnTables;
use crate::error_model::{ChanceByTable, ErrorModel};
use crate::places::{Places, distance};
use crate::progress::Progress;
use crate::reach::Reach;
use crate::route::{Route, RouteLog};

/// Added to the miss when the cue ball is pocketed or leaves the table, m. It exceeds the length of
/// every table, so that losing the cue ball is worse than any other miss.
const LOST_CUE_BALL: f64 = 10.0;

/// The goal of a strike. All parts that are given must be met, and the cue ball must stay on the
/// table.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Goal {
    /// This ball falls: into that pocket, or into any if None.
    pub pot: Option<(usize, Option<usize>)>,
    /// The cue ball comes to rest with its centre in this disc.
    pub leave: Option<Disc>,
    /// The cue ball touches this ball before any other.
    pub first: Option<usize>,
}

/// A disc on the table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    /// Its centre in the file's coordinates, m.
    pub center: [f64; 2],
    /// Its radius, m.
    pub radius: f64,
}

impl Goal {
    /// Rejects goals that no strike of `shot` can reach.
    ///
    /// # Errors [`Error::Input`] for a goal without parts, a ball or pocket that does not exist,
    /// the cue ball as object ball, a disc without size, and a shot without a strike, which names
    /// the cue ball.
    pub fn check(&self, shot: &Shot) -> Result<(), Error> {
        let refuse = |kind: ErrorKind, place: &str, what: &str, remedy: &str| {
            Err(kind.at(place, what, remedy))
        };
        let Some((cue_ball, _)) = shot.strike() else {
            return refuse(
                ErrorKind::NoStrike,
                "strike",
                "the shot has no strike",
                "give it one: it names the ball that is struck",
            );
        };
        if *self == Self::default() {
            return refuse(
                ErrorKind::Missing,
                "goal",
                "it is empty",
                "name a ball to pot, a disc to leave the cue ball in, or a ball to hit first",
            );
        }
        let (balls, pockets) = (shot.balls().len(), shot.table().pockets.len());
        for ball in self.pot.iter().map(|(ball, _)| *ball).chain(self.first) {
            if ball >= balls || ball == cue_ball {
                return refuse(
                    ErrorKind::UnknownBall,
                    "goal",
                    "there is no such object ball",
                    "name a ball of the shot",
                );
            }
        }
        if let Some((_, pocket)) = self.pot
            && pocket.map_or(pockets == 0, |pocket| pocket >= pockets)
        {
            return refuse(
                ErrorKind::UnknownName,
                "goal",
                "the table has no such pocket",
                "name one of its pockets",
            );
        }
        if let Some(Disc { center: [x, y], radius }) = self.leave
            && !(radius > 0.0 && radius.is_finite() && x.is_finite() && y.is_finite())
        {
            return refuse(
                ErrorKind::OutOfRange,
                "goal",
                "the disc to leave the cue ball in has no size",
                "give its centre and radius in m, radius > 0",
            );
        }
        Ok(())
    }
}

/// The result of one strike.
#[derive(Clone, Debug)]
pub struct Attempt {
    /// The distance from the goal, m; 0 if it is met.
    pub miss: f64,
    /// The route to the ball that the goal names.
    pub route: Route,
    /// Where the cue ball ends, m, in the file's coordinates.
    pub cue_ball_end: [f64; 2],
    /// Whether it falls into a pocket or leaves the table.
    pub loses_cue_ball: bool,
}

impl Attempt {
    /// Whether the goal is met.
    pub fn is_met(&self) -> bool {
        self.miss == 0.0
    }
}

/// Records how near a shot comes to a goal.
#[derive(Clone, Debug)]
pub(crate) struct GoalRecorder {
    goal: Goal,
    cue_ball: usize,
    /// Index and centre of each pocket that the goal accepts.
    targets: Vec<(usize, Vec2)>,
    log: RouteLog,
    places: Places,
    /// Least distance of the object ball's path from a target, m.
    pot: f64,
    /// Whether the object ball fell into a target.
    potted: bool,
    /// Whether any ball has hit the object ball.
    moved: bool,
    /// Least gap between the cue ball's path and the ball that it must reach, m.
    gap: f64,
    /// The first ball that the cue ball touched.
    first_touched: Option<usize>,
    /// Whether the cue ball may leave the table.
    lets_scratch: bool,
}

impl GoalRecorder {
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
            log: RouteLog::new(cue_ball, &places),
            places,
            pot: f64::INFINITY,
            potted: false,
            moved: false,
            gap: f64::INFINITY,
            first_touched: None,
            lets_scratch: false,
        }
    }

    /// The ball that the cue ball must reach.
    fn reached(&self) -> Option<usize> {
        self.goal.first.or(self.goal.pot.map(|(ball, _)| ball))
    }

    /// Updates the least distances with the path of ball `i` from its last place to `to`.
    fn follow(&mut self, i: usize, to: Vec2) {
        let from = self.places.replace(i, to);
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

    /// The result. `simulator` has played the shot, which ended `duration` after the strike.
    fn finish(&mut self, shot: &Shot, simulator: &Simulator, duration: f64) -> Attempt {
        for i in 0..self.places.count() {
            let end = simulator.state(i, duration).position.xy();
            self.follow(i, end);
        }
        let state = simulator.file_state(self.cue_ball, shot, duration);
        let end = [state.position.x, state.position.y];
        let mut miss = 0.0;
        if self.goal.pot.is_some() && !self.potted {
            miss += self.pot + if self.moved { 0.0 } else { self.gap };
        }
        if let Some(ball) = self.goal.first
            && self.first_touched != Some(ball)
        {
            // A hit on another ball first is a miss even if the gap has closed later.
            miss += self.gap.max(self.places.radius(ball));
        }
        if let Some(Disc { center: [x, y], radius }) = self.goal.leave {
            miss += (Vec2::new(end[0] - x, end[1] - y).length() - radius).max(0.0);
        }
        let is_lost = matches!(state.motion, MotionState::Pocketed | MotionState::OffTable);
        if is_lost && !self.lets_scratch {
            miss += LOST_CUE_BALL;
        }
        let target = self.goal.pot.map(|(ball, _)| ball).or(self.goal.first);
        let mut route = self.log.route(target, shot.table());
        if let (None, Some(ball)) = (self.goal.pot, self.goal.first) {
            route.end_at(ball);
        }
        Attempt { miss, route, cue_ball_end: end, loses_cue_ball: is_lost }
    }
}

impl Recorder for GoalRecorder {
    fn record(&mut self, event: &Event<'_>) {
        self.log.add(event, &self.places);
        for (ball, state) in event.balls.iter().zip(event.before) {
            self.follow(usize::from(*ball), state.position.xy());
        }
        self.places.update_resting(event);
        let has = |ball: usize| event.balls.iter().any(|b| usize::from(*b) == ball);
        let has_potted = self.goal.pot.is_some_and(|(ball, _)| has(ball));
        if event.is_ball_contact() {
            if self.first_touched.is_none() && has(self.cue_ball) {
                // If several balls are touched at once, the one that the goal names counts.
                let wanted = self.goal.first.filter(|ball| has(*ball));
                let nearest = || event.nearest_to(self.cue_ball as u16).map(usize::from);
                self.first_touched = wanted.or_else(nearest);
            }
            self.moved |= has_potted;
        }
        if let EventKind::PocketCollision(pocket) = event.kind {
            let into = self.targets.iter().any(|(i, _)| *i == usize::from(pocket));
            self.potted |= into && has_potted;
        }
    }
}

/// Plays strikes of one shot and compares the results with one goal.
pub(crate) struct GoalTester<'a> {
    shot: &'a Shot,
    fresh: GoalRecorder,
    simulator: Simulator,
    reach: Reach,
}

impl<'a> GoalTester<'a> {
    pub(crate) fn new(shot: &'a Shot, goal: Goal) -> Self {
        let (fresh, simulator) = (GoalRecorder::new(shot, goal), Simulator::new());
        Self { shot, fresh, simulator, reach: Reach::default() }
    }

    /// The same for strikes within `reach`: others cannot be played.
    pub(crate) fn within(self, reach: Reach) -> Self {
        Self { reach, ..self }
    }

    /// The same without the demand that the cue ball stays on the table.
    pub(crate) fn letting_scratch(shot: &'a Shot, goal: Goal) -> Self {
        let mut tester = Self::new(shot, goal);
        tester.fresh.lets_scratch = true;
        tester
    }

    pub(crate) const fn shot(&self) -> &Shot {
        self.shot
    }

    /// The result of `strike`; None if it cannot be played, or is out of reach.
    pub(crate) fn play(&mut self, strike: &Strike) -> Option<Attempt> {
        self.reach.allows(strike, self.shot).then(|| self.execute(strike))?
    }

    /// The result of `strike`, which an error may have moved out of reach; None if it cannot be
    /// played.
    fn execute(&mut self, strike: &Strike) -> Option<Attempt> {
        self.shot.resolve_strike(strike).ok()?;
        let (ball, _) = self.shot.strike()?;
        let mut recorder = self.fresh.clone();
        let played = self.simulator.play_strike(self.shot, Some((ball, *strike)), &mut recorder);
        Some(recorder.finish(self.shot, &self.simulator, played.ok()?.duration))
    }

    /// The result of `strike` in another variant of the shot; None if it cannot be played.
    fn play_on(&mut self, layout: &Shot, strike: &Strike) -> Option<Attempt> {
        layout.resolve_strike(strike).ok()?;
        let (ball, _) = layout.strike()?;
        let mut recorder = GoalRecorder::new(layout, self.fresh.goal);
        let played = self.simulator.play_strike(layout, Some((ball, *strike)), &mut recorder);
        Some(recorder.finish(layout, &self.simulator, played.ok()?.duration))
    }

    /// The probability that `strike` meets the goal, on each of `tables`. A stopped `progress` ends
    /// the count early.
    pub(crate) fn chance(
        &mut self,
        strike: &Strike,
        model: &ErrorModel,
        tables: &DrawnTables,
        progress: &Progress,
    ) -> ChanceByTable {
        let struck = self.fresh.cue_ball;
        let ball = StruckBall::of(self.shot, &self.shot.balls()[struck].ball);
        let errors = model.errors();
        let (shots, plain) = (tables.shots(self.shot), *tables == DrawnTables::default());
        model.count(tables.count(), progress, |k| {
            let strike = model.noise.draw(strike, &ball, model.seed, k);
            let attempt = if plain && errors.are_of_the_strike() {
                self.execute(&strike)
            } else {
                let table = &shots[tables.index(k)];
                let variant = errors.shot(table, Some((struck, strike)), k).ok();
                variant.and_then(|variant| self.play_on(&variant, &strike))
            };
            attempt.is_some_and(|a| a.is_met())
        })
    }
}
