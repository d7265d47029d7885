//! A game in progress.

mod middle;
mod play;
mod progress;
mod state;

use carom::format::Node;
use carom::{Error, Shot};

use crate::Player;
use crate::games::{Law, Options, Rules};
use crate::layout::Layout;
use crate::request::{Choice, Request, Turn};
use crate::ruling::Ruling;

pub(crate) use state::State;

use progress::{Progress, Stalemate};

/// One rack, frame or match of a game between two players.
#[derive(Clone, Debug)]
pub struct Frame {
    rules: Rules,
    law: Law,
    state: State,
    request: Request,
    progress: Progress,
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
        let refuse = |what: &str, remedy| {
            Err(Error::input("table", format!("{} {what}", rules.name()), remedy))
        };
        match (rules.needs_pockets(), base.table().pockets.is_empty()) {
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
        let frame = Self::on_table(rules, options, base, seed)?;
        if frame.base().with_balls(frame.layout().placed(), None).is_err() {
            refuse(
                "has a rack that does not fit on it",
                "choose a larger table, or smaller balls",
            )?;
        }
        Ok(frame)
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
        let mut state = State::new(rules, options, base, seed)?;
        let mut law = Law::new(rules);
        let request = law.game_mut().open(&mut state, 0);
        let progress = Progress::new(&state);
        Ok(Self { rules, law, state, request, progress, shots: 0 })
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

    /// Sets a scene: puts `ball` somewhere, or takes it off the table.
    #[cfg(test)]
    pub(crate) fn put(&mut self, ball: crate::BallIndex, place: Option<[f64; 2]>) {
        self.state.layout.put(ball, place);
    }

    /// Sets a scene.
    #[cfg(test)]
    pub(crate) fn set_scores(&mut self, scores: [i32; 2]) {
        self.state.scores = scores;
    }

    /// What one game has and others have not.
    pub(crate) fn law_node(&self) -> Node {
        self.law.game().to_node(&self.state)
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
        let request = self.law.game_mut().choose(&mut self.state, player, choice);
        Ok(self.settle(request, 0))
    }

    /// The player whose turn it is gives up, and the other wins (WPA 1.11; WPBSA, section 2, rule 1; UMB,
    /// article 26).
    ///
    /// # Errors
    /// [`Error::Input`] if the frame is over.
    pub fn concede(&mut self) -> Result<Ruling, Error> {
        let player = self
            .player()
            .ok_or_else(|| Error::input("concede", "the frame is over", "begin a new frame"))?;
        Ok(self.settle(Request::won(1 - player, "the other player conceded"), 0))
    }

    /// Carries out what the ruling on so many `shots` (one, or none for a choice) says, and sees to it that a
    /// frame without progress ends.
    fn settle(&mut self, request: Request, shots: u32) -> Ruling {
        self.shots += shots;
        self.request = request;
        for (score, points) in self.state.scores.iter_mut().zip(self.state.ruling.points) {
            *score += points;
        }
        if !self.is_over() {
            match self.progress.follow(self.rules, &self.state, shots) {
                Some(Stalemate::Again) => self.begin_again(),
                Some(Stalemate::End) => {
                    let why = "nobody got on: a stalemate";
                    self.request = Request::Over { winner: None, why };
                }
                None => {}
            }
        }
        core::mem::take(&mut self.state.ruling)
    }

    /// The balls are racked again, and the first breaker breaks.
    fn begin_again(&mut self) {
        self.state.rack();
        self.state.fouls = [0; 2];
        if self.rules.is_nullified_by_stalemate() {
            let State { scores, ruling, .. } = &mut self.state;
            ruling.points = [0, 1].map(|player| ruling.points[player] - scores[player]);
            *scores = [0; 2];
        }
        self.progress.restart(&self.state);
        self.law = Law::new(self.rules);
        self.request = self.law.game_mut().open(&mut self.state, 0);
    }
}

/// A shot of one resting ball on the game's table.
fn base(rules: Rules, table: Option<Node>, physics: Option<Node>) -> Result<Shot, Error> {
    let mut file = Node::object([
        ("format", carom::format::SHOT_FORMAT.into()),
        ("table", table.unwrap_or_else(|| rules.rack().table().into())),
    ]);
    if let Some(physics) = physics {
        file.set("physics", physics);
    }
    // Any place will do that is inside every table.
    let ball = |place: [f64; 2]| Node::object([("id", "cue".into()), ("position", place.into())]);
    file.set("balls", Node::list([ball([0.25, 0.25])]));
    Shot::from_node(&file)
}
