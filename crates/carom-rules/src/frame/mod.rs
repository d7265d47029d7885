//! A game in progress.

mod hash;
mod legal;
mod play;
mod prepared;
mod resume;
mod saved;
mod simulator;
mod stalemate;

use std::sync::Arc;

use carom::format::Node;
use carom::rack::Game;
use carom::{Error, ErrorKind, Shot};

use crate::games::GameState;
use crate::games::eight_ball::Group;
use crate::games::snooker::On;
use crate::games::{GameFacts, Stalemate};
use crate::layout::{BallIndex, FrameLayout};
use crate::options::Options;
use crate::request::{Choice, Request, Turn};
use crate::ruling::Ruling;
use crate::seat::{self, Seat};
use crate::state::FrameState;

pub use prepared::Prepared;
pub use simulator::FrameSimulator;
use stalemate::StalemateCounter;

/// One rack, frame or match of a game between two players. [`Clone::clone_from`] allocates nothing.
#[derive(Debug)]
pub struct Frame {
    game: Game,
    game_state: GameState,
    state: FrameState,
    request: Request,
    stalemates: StalemateCounter,
    shots: [u32; 2],
}

impl Clone for Frame {
    fn clone(&self) -> Self {
        Self { state: self.state.clone(), ..*self }
    }

    fn clone_from(&mut self, source: &Self) {
        let Self { game, game_state, state, request, stalemates, shots } = self;
        state.clone_from(&source.state);
        (*game, *game_state, *request) = (source.game, source.game_state, source.request);
        (*stalemates, *shots) = (source.stalemates, source.shots);
    }
}

impl Frame {
    /// A new frame: the balls are racked, with gaps drawn from `seed`, and seat 0 begins. `table`
    /// and `physics` have the form of these keys in a shot file; by default the game's own table
    /// and the table's own physics.
    ///
    /// # Errors
    /// [`Error::Input`] for a table or physics that a shot file could not have, for a table on
    /// which the game cannot be played, and for options out of range.
    pub fn new(
        game: Game,
        options: Options,
        table: Option<Node>,
        physics: Option<Node>,
        seed: u64,
    ) -> Result<Self, Error> {
        options.check()?;
        let table = table.unwrap_or_else(|| game.table().into());
        let base = Arc::new(Shot::bare(table, physics)?);
        let refuse = |what: &str, remedy| {
            Err(ErrorKind::Unsupported.at("table", format!("{} {what}", game.name()), remedy))
        };
        match (!GameFacts::of(game).is_carom(), base.table().pockets.is_empty()) {
            (true, true) => refuse(
                "is played on a table with pockets",
                "choose a table with pockets, or three-cushion",
            )?,
            (false, false) => refuse(
                "is played on a table without pockets",
                "choose a table without, or another game",
            )?,
            _ => {}
        }
        let frame = Self::on_table(game, options, base, seed)?;
        if frame.base().with_balls(frame.layout().placed(), None).is_err() {
            refuse(
                "has a rack that does not fit on it",
                "choose a larger table, or smaller balls",
            )?;
        }
        Ok(frame)
    }

    /// A new frame of the same game on the same table, racked with `seed`. Equal to the frame of
    /// [`Self::new`], but table and physics are not read again.
    ///
    /// # Errors
    /// None if [`Self::new`] had none.
    pub fn with_seed(&self, seed: u64) -> Result<Self, Error> {
        Self::on_table(self.game, self.state.options, self.state.base.clone(), seed)
    }

    fn on_table(game: Game, options: Options, base: Arc<Shot>, seed: u64) -> Result<Self, Error> {
        let mut state = FrameState::new(game, options, base, seed)?;
        let mut game_state = (GameFacts::of(game).state)();
        let request = game_state.rules_mut().start(&mut state, 0);
        let stalemates = StalemateCounter::new(&state);
        Ok(Self { game, game_state, state, request, stalemates, shots: [0; 2] })
    }

    /// The same frame, in which every shot has this cap on its number of events.
    #[must_use]
    pub fn with_max_events(mut self, max_events: u32) -> Self {
        self.state.base = std::sync::Arc::new(self.state.base.with_max_events(max_events));
        self
    }

    /// The frame as a player sees it who sees the balls at `places` (one entry for each ball of
    /// the layout, file coordinates, m; `None` for a ball that is not on the table). Everything
    /// else is the same.
    ///
    /// # Errors
    /// [`Error::Input`] if another set of balls is on the table. Overlapping balls are reported by
    /// the next shot.
    pub fn seen_at(&self, places: &[Option<[f64; 2]>]) -> Result<Self, Error> {
        let own = (0..).map(|ball| self.state.layout.is_down(ball));
        let same = places.len() == self.state.layout.len()
            && places.iter().zip(own).all(|(place, is_down)| place.is_none() == is_down);
        if !same {
            let what = "they are not those of the balls on the table";
            return Err(ErrorKind::WrongCount.at(
                "places",
                what,
                "displace every ball on the table",
            ));
        }
        let mut seen = self.clone();
        for (ball, place) in (0..).zip(places) {
            seen.state.layout.put(ball, *place);
        }
        Ok(seen)
    }

    /// The game.
    pub const fn game(&self) -> Game {
        self.game
    }

    /// The facts of the game.
    pub const fn facts(&self) -> &'static GameFacts {
        GameFacts::of(self.game)
    }

    /// The group of `seat`; none while the table is open, for a seat other than 0 and 1, and in
    /// games without groups.
    pub fn group(&self, seat: Seat) -> Option<Group> {
        self.game_state.rules().group(seat)
    }

    /// The kind of ball that is on in snooker; none in other games.
    pub fn kind_on(&self) -> Option<On> {
        self.game_state.rules().kind_on()
    }

    /// Points for `ball` in snooker: 1 for a red, 2 to 7 for a colour; 0 for the cue ball and in
    /// other games.
    pub fn value(&self, ball: BallIndex) -> i32 {
        self.game_state.rules().value(&self.state.layout, ball)
    }

    /// The options that were agreed before the start.
    pub const fn options(&self) -> &Options {
        &self.state.options
    }

    /// The next request.
    pub const fn request(&self) -> &Request {
        &self.request
    }

    /// The shot that the frame asks for; none if it asks for a choice or is over.
    pub const fn turn(&self) -> Option<&Turn> {
        match &self.request {
            Request::Shot(turn) => Some(turn),
            _ => None,
        }
    }

    /// The seat whose turn it is; none when the frame is over.
    pub const fn player(&self) -> Option<Seat> {
        match &self.request {
            Request::Shot(turn) => Some(turn.player),
            Request::Choice { player, .. } => Some(*player),
            Request::Over { .. } => None,
        }
    }

    /// Whether `seat` has the turn or has won: after its own shot, whether it kept the turn. A
    /// break of eight-ball that pots the eight keeps it, because the player who broke chooses what
    /// follows.
    pub fn keeps_turn(&self, seat: Seat) -> bool {
        match self.request {
            Request::Over { winner, .. } => winner == Some(seat),
            Request::Shot(_) | Request::Choice { .. } => self.player() == Some(seat),
        }
    }

    /// Whether the frame is over.
    pub const fn is_over(&self) -> bool {
        matches!(self.request, Request::Over { .. })
    }

    /// The balls and their places.
    pub const fn layout(&self) -> &FrameLayout {
        &self.state.layout
    }

    /// The score of each seat; 0 in games without points.
    pub const fn scores(&self) -> [i32; 2] {
        self.state.scores
    }

    /// Whether the next shot is the opening shot of a rack: a break, or the first shot of
    /// three-cushion.
    pub fn is_opening(&self) -> bool {
        self.turn().is_some() && self.game_state.rules().is_opening()
    }

    /// Number of consecutive fouls of each seat.
    pub const fn fouls_in_a_row(&self) -> [u32; 2] {
        self.state.fouls
    }

    /// Number of shots played so far.
    pub const fn shots(&self) -> u32 {
        self.shots[0] + self.shots[1]
    }

    /// Number of shots that each seat has played so far.
    pub const fn shots_by_seat(&self) -> [u32; 2] {
        self.shots
    }

    /// The box around the region in which the cue ball may be placed, for the D around the half
    /// disk: lower left and upper right corner (file coordinates, m). None unless the cue ball is
    /// in hand.
    pub fn hand_bounds(&self) -> Option<[[f64; 2]; 2]> {
        Some(self.turn()?.hand?.bounds(self.base().table()))
    }

    /// A shot on the frame's table with its physics; its balls are not those of the frame.
    pub fn base(&self) -> &Shot {
        &self.state.base
    }

    /// The state that only this game has: groups, innings, the ball on.
    pub const fn game_state(&self) -> &GameState {
        &self.game_state
    }

    /// Places `ball`, or takes it off the table.
    #[cfg(test)]
    pub(crate) fn put(&mut self, ball: crate::BallIndex, place: Option<[f64; 2]>) {
        self.state.layout.put(ball, place);
    }

    #[cfg(test)]
    pub(crate) fn set_scores(&mut self, scores: [i32; 2]) {
        self.state.scores = scores;
    }

    /// The state that only this game has, for reports.
    pub(crate) fn game_state_node(&self) -> Node {
        self.game_state.rules().to_node(&self.state)
    }

    /// Answers a choice.
    ///
    /// # Errors
    /// [`Error::Input`] if the frame does not ask for a choice, or does not offer this one.
    pub fn choose(&mut self, choice: Choice) -> Result<Ruling, Error> {
        let (player, choices) = match &self.request {
            Request::Choice { player, choices, .. } => (*player, choices),
            _ => {
                return Err(ErrorKind::WrongState.at(
                    "choice",
                    "the frame does not ask for a choice now",
                    "look at its request",
                ));
            }
        };
        if !choices.contains(&choice) {
            let names: Vec<&str> = choices.iter().map(|c| c.name()).collect();
            return Err(ErrorKind::NotAChoice.at(
                "choice",
                format!("\"{}\" is not among the choices", choice.name()),
                format!("write one of {}", names.join(", ")),
            ));
        }
        let request = self.game_state.rules_mut().choose(&mut self.state, player, choice);
        Ok(self.settle(request, None))
    }

    /// The player whose turn it is concedes, and the other wins (WPA 1.11; WPBSA, section 2, rule
    /// 1; UMB, article 26).
    ///
    /// # Errors
    /// [`Error::Input`] if the frame is over.
    pub fn concede(&mut self) -> Result<Ruling, Error> {
        let player = self.player().ok_or_else(|| {
            ErrorKind::FrameOver.at("concede", "the frame is over", "begin a new frame")
        })?;
        Ok(self.settle(Request::won(seat::opponent(player), "the other player conceded"), None))
    }

    /// Completes a shot of `shooter`, or a choice (none): updates the scores and the request, and
    /// ends a stalemate. Returns the ruling.
    fn settle(&mut self, request: Request, shooter: Option<Seat>) -> Ruling {
        if let Some(seat) = shooter {
            self.shots[seat] += 1;
        }
        let shots = u32::from(shooter.is_some());
        debug_assert!(request.is_known(), "{request:?} has a reason that REASONS lacks");
        self.request = request;
        for (score, points) in self.state.scores.iter_mut().zip(self.state.ruling.points) {
            *score += points;
        }
        if !self.is_over() {
            match self.stalemates.update(self.facts(), &self.state, shots) {
                Some(stalemate @ (Stalemate::Rerack | Stalemate::Restart)) => {
                    self.rerack(stalemate)
                }
                Some(Stalemate::End) => {
                    let why = "a stalemate: there was no progress";
                    self.request = Request::Over { winner: None, why };
                }
                None => {}
            }
        }
        core::mem::take(&mut self.state.ruling)
    }

    /// Starts again after a stalemate: the balls are racked, and the first breaker breaks.
    fn rerack(&mut self, stalemate: Stalemate) {
        self.state.rack();
        self.state.fouls = [0; 2];
        if stalemate == Stalemate::Restart {
            let FrameState { scores, ruling, .. } = &mut self.state;
            ruling.points = [0, 1].map(|seat| ruling.points[seat] - scores[seat]);
            *scores = [0; 2];
        }
        self.stalemates.restart(&self.state);
        self.game_state = (self.facts().state)();
        self.request = self.game_state.rules_mut().start(&mut self.state, 0);
    }
}

/// `table` and `physics` of a new frame as a record keeps them: the game's own table is named, and
/// presets have their dated names, so that the record replays when the presets have other values.
/// Without `physics` if the table's name implies it.
pub fn recorded_setup(game: Game, table: Option<Node>, physics: Option<Node>) -> Node {
    let mut file = Node::object([("table", table.unwrap_or_else(|| game.table().into()))]);
    if let Some(physics) = physics {
        file.set("physics", physics);
    }
    carom::format::with_dated_names(&file)
}
