//! Sum to three: two balls on a table without pockets. A shot scores if the balls touch and cushions are
//! touched exactly three times in all, by either ball. Who scores goes on; the first to the target wins.
//!
//! The definition is that of pooltool's ruleset `sum_to_three`. It says nothing of a ball that leaves the
//! table; here that scores nothing, and the ball comes back to its spot.

use carom::limits::SMALL_CAPACITY;
use carom::simulate::Simulation;
use carom::{Error, Shot};
use carom_rules::{BallIndex, Calls, Piece, Player, Turn};

use crate::config::Config;
use crate::notes::Notes;
use crate::random::Dice;
use crate::scene::{Bed, Ending, Played, Scene, Standing, Stroke, in_order};

/// Touches of cushions that score.
pub const CUSHIONS: u32 = 3;

const CUE: BallIndex = 0;
const OBJECT: BallIndex = 1;

/// The balls' spots on the long string, as parts of the table's length: the quarter lines.
const SPOTS: [f64; 2] = [0.25, 0.75];

/// How far a ball is put from its spot at the start, at most, along either axis, m: so that no two episodes
/// are the same.
const SPREAD: f64 = 0.05;

/// Two players, two balls.
#[derive(Clone)]
pub(crate) struct SumToThree {
    bed: Bed,
    target: i32,
    patience: u32,
    turn: Turn,
    scores: [i32; 2],
    /// Shots since the last point.
    idle: u32,
    opening: bool,
    ending: Option<Ending>,
}

impl SumToThree {
    pub(crate) fn new(config: &Config) -> Result<Self, Error> {
        let table = config.table.clone().unwrap_or_else(|| "carom-10ft".into());
        let ids = ["cue", "object"].into_iter().map(String::from);
        let bed = Bed::new(table, config.physics.clone(), ids)?;
        if !bed.base.table().pockets.is_empty() || !bed.base.table().size.x.is_finite() {
            return Err(Error::input(
                "table",
                "sum-to-three is played on a table with cushions and without pockets",
                "choose carom-10ft, carom-9ft, or a rectangle",
            ));
        }
        let turn =
            Turn { player: 0, cue: CUE, hand: None, on: vec![OBJECT], calls: Calls::default() };
        Ok(Self {
            bed,
            target: config.options.target,
            patience: config.options.patience,
            turn,
            scores: [0; 2],
            idle: 0,
            opening: true,
            ending: None,
        })
    }

    fn spot(&self, ball: BallIndex) -> [f64; 2] {
        let size = self.bed.base.table().size;
        [0.5 * size.x, SPOTS[usize::from(ball)] * size.y]
    }

    /// Puts back what left the table: on its own spot, or, if the other ball is there, on the other's.
    fn bring_back(&mut self) {
        for ball in [CUE, OBJECT] {
            if self.place(ball).is_some() {
                continue;
            }
            let reach = 2.0 * self.bed.base.physics().ball.radius;
            let is_free = |spot: &[f64; 2]| {
                self.place(1 - ball)
                    .is_none_or(|[x, y]| (x - spot[0]).abs() > reach || (y - spot[1]).abs() > reach)
            };
            let spots = [self.spot(ball), self.spot(1 - ball)];
            self.bed.places[usize::from(ball)] = spots.into_iter().find(is_free);
        }
    }
}

impl Scene for SumToThree {
    fn base(&self) -> &Shot {
        &self.bed.base
    }

    fn pieces(&self) -> &[Piece] {
        &self.bed.pieces
    }

    fn place(&self, ball: BallIndex) -> Option<[f64; 2]> {
        self.bed.places[usize::from(ball)]
    }

    fn turn(&self) -> Option<&Turn> {
        self.ending.is_none().then_some(&self.turn)
    }

    fn ending(&self) -> Option<Ending> {
        self.ending
    }

    fn standing(&self) -> Standing {
        let scores = self.scores.map(|score| f64::from(score) / f64::from(self.target));
        Standing { scores, opening: self.opening, ..Standing::default() }
    }

    fn scores(&self) -> [i32; 2] {
        self.scores
    }

    fn order(&self, _: Player) -> [BallIndex; SMALL_CAPACITY] {
        in_order()
    }

    fn restart(&mut self, seed: u64) -> Result<(), Error> {
        let mut dice = Dice::of_layout(seed);
        for ball in [CUE, OBJECT] {
            let spot = self.spot(ball);
            let place = spot.map(|x| x + dice.between(-SPREAD, SPREAD));
            self.bed.places[usize::from(ball)] = Some(place);
        }
        self.turn.player = 0;
        self.scores = [0; 2];
        self.idle = 0;
        self.opening = true;
        self.ending = None;
        Ok(())
    }

    fn play(
        &mut self,
        simulation: &mut Simulation<SMALL_CAPACITY>,
        stroke: &Stroke,
    ) -> Result<Played, Error> {
        let player = self.turn.player;
        let mut notes = Notes::new(CUE.into());
        self.opening = false;
        if let Err(error) = self.bed.play(simulation, CUE, stroke.struck, &mut notes) {
            self.ending = Some(Ending::Stalemate);
            return Err(error);
        }
        self.bring_back();
        let touched = notes.first_contact.is_some();
        let scored = touched && notes.cushions == CUSHIONS && !notes.left_table;
        let mut points = [0; 2];
        points[player] = scored.into();
        self.scores[player] += points[player];
        self.idle = if scored { 0 } else { self.idle + 1 };
        if self.scores[player] >= self.target {
            self.ending = Some(Ending::Won(player));
        } else if self.idle >= self.patience {
            self.ending = Some(Ending::Stalemate);
        } else if !scored {
            self.turn.player = 1 - player;
        }
        Ok(Played { legal: !notes.left_table, potted: 0, points })
    }

    fn boxed(&self) -> Box<dyn Scene> {
        Box::new(self.clone())
    }
}
