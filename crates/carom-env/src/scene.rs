//! What an environment asks of a game.

use std::sync::Arc;

use carom::event::Recorder;
use carom::format::{Node, SHOT_FORMAT};
use carom::limits::SMALL_CAPACITY;
use carom::math::Vec3;
use carom::resolve::cue_ball::Strike;
use carom::shot::PlacedBall;
use carom::simulate::Simulation;
use carom::{BallState, Error, MotionState, Shot};
use carom_rules::{BallIndex, Piece, Player, Turn};

/// A shot, as it is played.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stroke {
    /// What the player meant.
    pub(crate) meant: Strike,
    /// What came of it.
    pub(crate) struck: Strike,
    /// Where the cue ball is put first, if it is in hand.
    pub(crate) cue_ball: Option<[f64; 2]>,
}

/// What came of a shot.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Played {
    /// No foul.
    pub(crate) legal: bool,
    /// Balls potted, by a legal shot, that were the shooter's to pot.
    pub(crate) potted: u32,
    /// What the players' scores changed by.
    pub(crate) points: [i32; 2],
}

/// How an episode ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ending {
    /// This player won.
    Won(Player),
    /// Nobody did, by the rules of the game.
    Drawn,
    /// Nobody got on.
    Stalemate,
}

/// How the players stand, as numbers from about 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Standing {
    /// Scores, by what a player would be proud of.
    pub(crate) scores: [f64; 2],
    /// Fouls in a row, by the three that lose a rack.
    pub(crate) fouls: [f64; 2],
    /// Whether no shot has been played.
    pub(crate) opening: bool,
}

/// A table with balls and something to do.
pub(crate) trait Scene: Send + Sync {
    /// A shot on this table, under its physics.
    fn base(&self) -> &Shot;
    /// The balls, on the table or not.
    fn pieces(&self) -> &[Piece];
    /// Where a ball lies, if it is on the table.
    fn place(&self, ball: BallIndex) -> Option<[f64; 2]>;
    /// The shot that is asked; none when the episode is over.
    fn turn(&self) -> Option<&Turn>;
    /// How the episode ended; none while it goes on.
    fn ending(&self) -> Option<Ending>;
    /// How the players stand.
    fn standing(&self) -> Standing;
    /// The players' points.
    fn scores(&self) -> [i32; 2];
    /// The balls in the order in which `viewer` sees them: their own first.
    fn order(&self, viewer: Player) -> [BallIndex; SMALL_CAPACITY];
    /// Begins another episode.
    fn restart(&mut self, seed: u64) -> Result<(), Error>;
    /// Plays a shot, and answers every choice that follows from it. After an error the episode is over.
    fn play(
        &mut self,
        simulation: &mut Simulation<SMALL_CAPACITY>,
        stroke: &Stroke,
    ) -> Result<Played, Error>;
    /// The same once more.
    fn boxed(&self) -> Box<dyn Scene>;
}

impl Clone for Box<dyn Scene> {
    fn clone(&self) -> Self {
        self.as_ref().boxed()
    }
}

impl dyn Scene + '_ {
    /// The other balls on the table: number, centre (m, in the file's frame), radius (m).
    pub(crate) fn others(
        &self,
        ball: BallIndex,
    ) -> impl Iterator<Item = (BallIndex, [f64; 2], f64)> + '_ {
        (0..)
            .zip(self.pieces())
            .filter(move |(i, _)| *i != ball)
            .filter_map(|(i, piece)| self.place(i).map(|place| (i, place, piece.ball.radius)))
    }

    /// The balls to aim at: those of which one must be hit first, or else every object ball.
    pub(crate) fn targets<'a>(
        &'a self,
        turn: &'a Turn,
    ) -> impl Iterator<Item = (BallIndex, [f64; 2], f64)> + 'a {
        self.others(turn.cue).filter(|(ball, ..)| turn.on.is_empty() || turn.on.contains(ball))
    }
}

/// In their usual order.
pub(crate) fn in_order() -> [BallIndex; SMALL_CAPACITY] {
    core::array::from_fn(|i| i as BallIndex)
}

/// A table with balls that no rules of carom-rules look after.
#[derive(Clone)]
pub(crate) struct Bed {
    pub(crate) base: Shot,
    pub(crate) pieces: Arc<[Piece]>,
    pub(crate) places: Vec<Option<[f64; 2]>>,
}

impl Bed {
    /// A bare table; `table` and `physics` as a shot file has them.
    pub(crate) fn new(
        table: Node,
        physics: Option<Node>,
        ids: impl Iterator<Item = String>,
    ) -> Result<Self, Error> {
        let anywhere = Node::from([0.25, 0.25]);
        let ball = Node::object([("id", "cue".into()), ("position", anywhere)]);
        let mut file = Node::object([
            ("format", SHOT_FORMAT.into()),
            ("table", table),
            ("balls", Node::list([ball])),
        ]);
        if let Some(physics) = physics {
            file.set("physics", physics);
        }
        let base = Shot::from_node(&file)?;
        let ball = base.physics().ball;
        let pieces: Arc<[Piece]> = ids.map(|id| Piece { id, ball }).collect();
        let places = vec![None; pieces.len()];
        Ok(Self { base, pieces, places })
    }

    /// Plays `strike` on `cue`; the balls lie then where they came to rest.
    pub(crate) fn play(
        &mut self,
        simulation: &mut Simulation<SMALL_CAPACITY>,
        cue: BallIndex,
        strike: Strike,
        recorder: &mut impl Recorder,
    ) -> Result<(), Error> {
        let on_table = |ball: &usize| self.places[*ball].is_some();
        let balls: Vec<usize> = (0..self.pieces.len()).filter(on_table).collect();
        let placed = balls.iter().filter_map(|&ball| {
            let ([x, y], piece) = (self.places[ball]?, &self.pieces[ball]);
            let position = Vec3::new(x, y, piece.ball.radius);
            let state = BallState { position, ..BallState::default() };
            Some(PlacedBall { id: piece.id.clone(), ball: piece.ball, state })
        });
        let struck = balls.iter().position(|ball| *ball == usize::from(cue)).unwrap_or_default();
        let shot = self.base.with_balls(placed.collect(), Some((struck, strike)))?;
        let summary =
            simulation.play(&shot, recorder).map_err(|failure| shot.explain(failure, None))?;
        for (i, &ball) in balls.iter().enumerate() {
            let state = simulation.file_state(i, &shot, summary.duration);
            let gone = matches!(state.motion, MotionState::Pocketed | MotionState::OffTable);
            self.places[ball] = (!gone).then_some([state.position.x, state.position.y]);
        }
        Ok(())
    }
}
