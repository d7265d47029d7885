//! A game in progress.

use carom::outcome::Outcome;
use carom::shot::Node;
use carom::simulate::{SMALL, Simulation};
use carom::trace::What;
use carom::{BallState, Error, MotionState, Shot, Trace};

use crate::facts::{Facts, Witness};
use crate::games::{Law, Options, Played, Rules};
use crate::layout::Layout;
use crate::play::{Call, Play};
use crate::request::{Choice, Request, Turn};
use crate::ruling::Ruling;
use crate::{BallIndex, Player};

/// Of a stalemate's two ends, racking again comes first; the second stalemate of a frame ends it.
const STALEMATES: u32 = 2;

/// What every game keeps.
#[derive(Clone, Debug)]
pub(crate) struct State {
    pub(crate) options: Options,
    /// Any shot on this table, under these physics.
    pub(crate) base: Shot,
    pub(crate) layout: Layout,
    pub(crate) scores: [i32; 2],
    /// Fouls in a row.
    pub(crate) fouls: [u32; 2],
    seed: u64,
    racks: u64,
}

impl State {
    /// Racks the balls, another way each time.
    pub(crate) fn rack(&mut self, rules: Rules) {
        self.layout = self.fresh_rack(rules);
    }

    pub(crate) fn fresh_rack(&mut self, rules: Rules) -> Layout {
        let seed = self.next_seed();
        // What was racked at the start of the frame can be racked again.
        Layout::rack(rules.rack(), &self.base, seed).unwrap_or_else(|_| self.layout.clone())
    }

    pub(crate) fn next_seed(&mut self) -> u64 {
        self.racks += 1;
        // An odd number: no two racks of a frame, and hardly two of any frames, get the same seed.
        self.seed.wrapping_add((self.racks - 1).wrapping_mul(0x9e37_79b9_7f4a_7c15))
    }
}

/// One rack, frame or match of a game between two players.
#[derive(Clone, Debug)]
pub struct Frame {
    rules: Rules,
    law: Law,
    state: State,
    request: Request,
    /// Shots since the last progress, the fewest balls and the best scores so far.
    idle: u32,
    fewest: usize,
    best: [i32; 2],
    stalemates: u32,
    shots: u32,
}

impl Frame {
    /// A new frame: the balls are racked (`seed` says how exactly), and player 0 begins. `table` and
    /// `physics` are what a shot file says under these keys; the game's own table and the table's own
    /// physics where they are not given.
    ///
    /// # Errors
    /// [`Error::Input`] for a table or physics that a shot file would be refused for, for a table that
    /// the game cannot be played on, and for options out of range.
    pub fn new(
        rules: Rules,
        options: Options,
        table: Option<Node>,
        physics: Option<Node>,
        seed: u64,
    ) -> Result<Self, Error> {
        options.check()?;
        let base = base(rules, table, physics)?;
        if rules.needs_pockets() && base.table().pockets.is_empty() {
            return Err(Error::input(
                "table",
                format!("{} is played on a table with pockets", rules.name()),
                "choose a table with pockets, or three-cushion",
            ));
        }
        Self::on_table(rules, options, base, seed)
    }

    /// A new frame of the same game on the same table, racked by `seed`: what [`Self::new`] would give,
    /// without reading table and physics again.
    ///
    /// # Errors
    /// None that [`Self::new`] has not had.
    pub fn another(&self, seed: u64) -> Result<Self, Error> {
        Self::on_table(self.rules, self.state.options, self.state.base.clone(), seed)
    }

    fn on_table(rules: Rules, options: Options, base: Shot, seed: u64) -> Result<Self, Error> {
        let layout = Layout::rack(rules.rack(), &base, seed)?;
        let fewest = layout.len();
        let mut state =
            State { options, base, layout, scores: [0; 2], fouls: [0; 2], seed, racks: 1 };
        let mut law = Law::new(rules);
        let request = law.open(&mut state, 0);
        Ok(Self {
            rules,
            law,
            state,
            request,
            idle: 0,
            fewest,
            best: [0; 2],
            stalemates: 0,
            shots: 0,
        })
    }

    /// Goes on as if the break had left the balls at `places` (one for each ball of the layout, in the
    /// file's frame, m; none for a ball that is down), and `player` shoots next: to begin in the middle of
    /// a rack.
    ///
    /// # Errors
    /// [`Error::Input`] but for eight-ball, nine-ball and ten-ball, for another number of places than of
    /// balls, and if the ball that decides the game is down. Whether balls overlap, the next shot says.
    pub fn scatter(&mut self, places: &[Option<[f64; 2]>], player: Player) -> Result<(), Error> {
        let wrong = |what: String, remedy: &str| Err(Error::input("places", what, remedy));
        let last = match self.rules {
            Rules::EightBall => 8,
            Rules::NineBall => 9,
            Rules::TenBall => 10,
            other => {
                let what = format!("{} is not begun in the middle", other.name());
                return wrong(what, "choose eight-ball, nine-ball or ten-ball");
            }
        };
        if places.len() != self.state.layout.len() {
            let what = format!("{} for {} balls", places.len(), self.state.layout.len());
            return wrong(what, "give one for every ball");
        }
        if places[last].is_none() {
            return wrong(format!("the {last} is down"), "put it on the table");
        }
        for (ball, place) in (0..).zip(places) {
            self.state.layout.put(ball, *place);
        }
        self.fewest = self.state.layout.on_table().count();
        self.request = self.law.after_break(&self.state, player);
        Ok(())
    }

    /// Which game.
    pub const fn rules(&self) -> Rules {
        self.rules
    }

    /// What is asked next, and of whom.
    pub const fn request(&self) -> &Request {
        &self.request
    }

    /// The shot that is asked, if it is one.
    pub const fn turn(&self) -> Option<&Turn> {
        match &self.request {
            Request::Shot(turn) => Some(turn),
            _ => None,
        }
    }

    /// Whose turn it is; none when the frame is over.
    pub const fn player(&self) -> Option<Player> {
        match &self.request {
            Request::Shot(turn) => Some(turn.player),
            Request::Choice { player, .. } => Some(*player),
            Request::Over { .. } => None,
        }
    }

    /// Whether the frame is over.
    pub const fn is_over(&self) -> bool {
        matches!(self.request, Request::Over { .. })
    }

    /// Where the balls are.
    pub const fn layout(&self) -> &Layout {
        &self.state.layout
    }

    /// The players' scores; games without points count none.
    pub const fn scores(&self) -> [i32; 2] {
        self.state.scores
    }

    /// How many fouls each player has made in a row.
    pub const fn fouls_in_a_row(&self) -> [u32; 2] {
        self.state.fouls
    }

    /// Shots played so far.
    pub const fn shots(&self) -> u32 {
        self.shots
    }

    /// A shot on the frame's table, under its physics.
    pub const fn base(&self) -> &Shot {
        &self.state.base
    }

    /// What the game keeps besides: groups, pushes, the ball on.
    pub const fn law(&self) -> &Law {
        &self.law
    }

    /// The shot that `play` is, ready to simulate.
    ///
    /// # Errors
    /// [`Error::Input`] if no shot is asked, for a call that is missing or not to be made, for a cue
    /// ball put where it must not be, and for a strike that a shot file would be refused for.
    pub fn shot(&self, play: &Play) -> Result<Shot, Error> {
        let turn = self.asked_turn()?;
        self.check_call(turn, play.call)?;
        let mut layout = self.state.layout.clone();
        let place = play.cue_ball.or_else(|| layout.place(turn.cue));
        self.check_cue_ball(turn, play.cue_ball, place)?;
        layout.put(turn.cue, place);
        let cue = layout.on_table().position(|ball| ball == turn.cue).unwrap_or_default();
        let shot = self.state.base.with_balls(layout.placed(), Some((cue, play.strike)));
        shot.map_err(|error| of_cue_ball(error, cue))
    }

    fn asked_turn(&self) -> Result<&Turn, Error> {
        self.turn().ok_or_else(|| {
            Error::input(
                "play",
                "no shot is asked now",
                "look at the frame's request: answer the choice, or begin a new frame",
            )
        })
    }

    fn check_call(&self, turn: &Turn, call: Call) -> Result<(), Error> {
        let calls = &turn.calls;
        let wrong = |what: &str, remedy: &str| Err(Error::input("call", what, remedy));
        match call {
            Call::Nothing if calls.required => {
                wrong("nothing is called", "call a ball and its pocket, or a safety")
            }
            Call::Nothing if calls.nominate => {
                wrong("no ball is nominated", "nominate one of the balls on")
            }
            Call::Pocket(ball, _) => {
                if !calls.pocket {
                    return wrong("no ball is called in this shot", "leave the call out");
                }
                let known = usize::from(ball) < self.state.layout.len() && ball != turn.cue;
                if !known || self.state.layout.is_down(ball) {
                    return wrong(
                        "the called ball is not on the table",
                        "call an object ball that is",
                    );
                }
                Ok(())
            }
            Call::Safety if !calls.safety => {
                wrong("no safety is called in this game", "leave the call out")
            }
            Call::PushOut if !calls.push_out => wrong(
                "a push-out is allowed in the first shot after a legal break alone",
                "leave the call out",
            ),
            Call::On(ball) if !calls.nominate || !turn.on.contains(&ball) => wrong(
                "that ball cannot be nominated",
                "nominate one of the balls on, if it is asked",
            ),
            _ => Ok(()),
        }
    }

    fn check_cue_ball(
        &self,
        turn: &Turn,
        put: Option<[f64; 2]>,
        place: Option<[f64; 2]>,
    ) -> Result<(), Error> {
        let wrong = |what: String, remedy: &str| Err(Error::input("cue_ball", what, remedy));
        let Some(region) = turn.hand else {
            return match put {
                Some(_) => wrong("the cue ball is not in hand".into(), "play it where it lies"),
                None => Ok(()),
            };
        };
        let Some(place) = place else {
            return wrong("the cue ball is in hand".into(), "say where it is put");
        };
        if !region.holds(self.state.base.table(), place) {
            let what = format!("[{:?}, {:?}] is not {}", place[0], place[1], region.words());
            return wrong(what, "put it there");
        }
        if !self.state.layout.is_free(turn.cue, place) {
            return wrong("it would touch another ball".into(), "put it where there is room");
        }
        Ok(())
    }

    /// Plays a shot: simulates it, rules, and asks anew.
    ///
    /// # Errors
    /// As [`Self::shot`], and if the simulation reaches its cap of events. The frame is unchanged then.
    pub fn play(&mut self, play: &Play) -> Result<(Ruling, Outcome), Error> {
        self.play_in(&mut Simulation::new(), play)
    }

    /// [`Self::play`] in a simulation that is used again and again.
    ///
    /// # Errors
    /// As [`Self::play`].
    pub fn play_in(
        &mut self,
        simulation: &mut Simulation<SMALL>,
        play: &Play,
    ) -> Result<(Ruling, Outcome), Error> {
        let shot = self.shot(play)?;
        self.play_shot(simulation, play, &shot)
    }

    /// [`Self::play_in`] with a shot that is made already: what [`Self::shot`] gave for the same cue ball's
    /// place, whatever the strike and the call. For programs that look first at what a strike would do, and
    /// call, or err, accordingly.
    ///
    /// # Errors
    /// As [`Self::play`].
    pub fn play_prepared(
        &mut self,
        simulation: &mut Simulation<SMALL>,
        play: &Play,
        prepared: &Shot,
    ) -> Result<(Ruling, Outcome), Error> {
        self.check_call(self.asked_turn()?, play.call)?;
        self.play_shot(simulation, play, &prepared.with_strike(&play.strike)?)
    }

    /// `shot` is the shot that `play` is.
    fn play_shot(
        &mut self,
        simulation: &mut Simulation<SMALL>,
        play: &Play,
        shot: &Shot,
    ) -> Result<(Ruling, Outcome), Error> {
        let mut witness = Witness::new(shot);
        let summary =
            simulation.play(shot, &mut witness).map_err(|failure| shot.explain(failure, None))?;
        let last: Vec<BallState> =
            (0..shot.balls().len()).map(|i| simulation.state(i, summary.duration)).collect();
        let (outcome, reached) = witness.finish(shot, &last);
        let last: Vec<BallState> =
            (0..).zip(&last).map(|(i, s)| shot.to_file_frame(i, s)).collect();
        Ok((self.rule(play, &outcome, reached, &last)?, outcome))
    }

    /// Rules on a shot that was simulated elsewhere: `trace` is of the shot that [`Self::shot`] gives for
    /// `play`.
    ///
    /// # Errors
    /// As [`Self::shot`], and [`Error::Input`] if `trace` is of another shot.
    pub fn apply(&mut self, play: &Play, trace: &Trace) -> Result<Ruling, Error> {
        if *trace.shot() != self.shot(play)? {
            return Err(Error::input(
                "trace",
                "it is of another shot than the one that is played",
                "simulate the shot that the frame gives for this play",
            ));
        }
        let cue = trace.shot().cue_ball().unwrap_or_default() as u16;
        let mut reached = f64::NEG_INFINITY;
        for event in trace.events() {
            let Some(k) = event.balls.iter().position(|ball| *ball == cue) else { continue };
            reached = reached.max(event.before[k].position.y);
            if event.what == What::BallCollision {
                break;
            }
        }
        self.rule(play, trace.outcome(), reached, trace.last())
    }

    /// `last` are the final states, in the file's frame.
    fn rule(
        &mut self,
        play: &Play,
        outcome: &Outcome,
        cue_reached: f64,
        last: &[BallState],
    ) -> Result<Ruling, Error> {
        let turn = self.asked_turn()?.clone();
        let layout = &mut self.state.layout;
        layout.put(turn.cue, play.cue_ball.or_else(|| layout.place(turn.cue)));
        let balls: Vec<BallIndex> = layout.on_table().collect();
        let facts = Facts::new(outcome, &balls, turn.cue, cue_reached);
        let started = layout.clone();
        for (&ball, state) in balls.iter().zip(last) {
            let gone = matches!(state.motion, MotionState::Pocketed | MotionState::OffTable);
            layout.put(ball, (!gone).then_some([state.position.x, state.position.y]));
        }
        Ok(self.decide(&turn, play, &facts, &started))
    }

    /// Rules on what happened; the balls already lie where they came to rest.
    pub(crate) fn decide(
        &mut self,
        turn: &Turn,
        play: &Play,
        facts: &Facts,
        before: &Layout,
    ) -> Ruling {
        self.shots += 1;
        let mut ruling = Ruling::default();
        let shot = Played { turn, play, facts, before };
        let request = self.law.judge(&mut self.state, &shot, &mut ruling);
        self.settle(request, ruling)
    }

    /// Sets a scene: puts `ball` somewhere, or takes it off the table.
    #[cfg(test)]
    pub(crate) fn put(&mut self, ball: BallIndex, place: Option<[f64; 2]>) {
        self.state.layout.put(ball, place);
    }

    /// Sets a scene.
    #[cfg(test)]
    pub(crate) fn set_scores(&mut self, scores: [i32; 2]) {
        self.state.scores = scores;
    }

    /// Answers a choice.
    ///
    /// # Errors
    /// [`Error::Input`] if no choice is asked, or not this one.
    pub fn choose(&mut self, choice: Choice) -> Result<Ruling, Error> {
        let (player, choices) = match &self.request {
            Request::Choice { player, choices, .. } => (*player, choices),
            _ => {
                return Err(Error::input(
                    "choice",
                    "no choice is asked now",
                    "look at the frame's request",
                ));
            }
        };
        if !choices.contains(&choice) {
            let names: Vec<&str> = choices.iter().map(|c| c.name()).collect();
            return Err(Error::input(
                "choice",
                format!("\"{}\" is not among the choices", choice.name()),
                format!("write one of {}", names.join(", ")),
            ));
        }
        let mut ruling = Ruling::default();
        let request = self.law.choose(&mut self.state, player, choice, &mut ruling);
        Ok(self.settle(request, ruling))
    }

    /// Carries out what the ruling says, and sees to it that a frame without progress ends.
    fn settle(&mut self, request: Request, mut ruling: Ruling) -> Ruling {
        self.request = request;
        for (score, points) in self.state.scores.iter_mut().zip(ruling.points) {
            *score += points;
        }
        let left = self.state.layout.on_table().count();
        let better = (0..2).any(|player| self.state.scores[player] > self.best[player]);
        let progress = if self.rules.is_scored_by_shots() { better } else { left < self.fewest };
        self.fewest = self.fewest.min(left);
        self.best = [0, 1].map(|player| self.best[player].max(self.state.scores[player]));
        self.idle = if progress { 0 } else { self.idle + 1 };
        if self.idle >= self.state.options.patience && !self.is_over() {
            self.stalemate(&mut ruling);
        }
        ruling
    }

    /// Nobody gets on (WPA 1.12): the balls are racked again, and the first breaker breaks; the second
    /// time, or in a game without racks, the frame ends undecided.
    fn stalemate(&mut self, ruling: &mut Ruling) {
        self.stalemates += 1;
        self.idle = 0;
        if self.stalemates >= STALEMATES || !self.rules.is_racked_after_stalemate() {
            self.request = Request::Over { winner: None, why: "nobody got on: a stalemate" };
            return;
        }
        self.state.rack(self.rules);
        self.fewest = self.state.layout.len();
        self.law = Law::new(self.rules);
        self.state.fouls = [0; 2];
        ruling.racked = true;
        self.request = self.law.open(&mut self.state, 0);
    }
}

/// A shot of one resting ball on the game's table.
fn base(rules: Rules, table: Option<Node>, physics: Option<Node>) -> Result<Shot, Error> {
    let mut file = Node::object([
        ("format", carom::shot::FORMAT.into()),
        ("table", table.unwrap_or_else(|| rules.rack().table().into())),
    ]);
    if let Some(physics) = physics {
        file.set("physics", physics);
    }
    // Any place will do that is inside every table.
    let ball = |place: [f64; 2]| Node::object([("id", "cue".into()), ("position", place.into())]);
    file.set("balls", Node::list([ball([0.25, 0.25])]));
    Shot::from_node(file)
}

/// What is wrong with the cue ball's place, as such.
fn of_cue_ball(error: Error, cue: usize) -> Error {
    match error {
        Error::Input(e) if e.place == format!("balls[{cue}].position") => {
            Error::input("cue_ball", e.what, e.remedy)
        }
        other => other,
    }
}
