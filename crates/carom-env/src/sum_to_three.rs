//! Sum to three: two balls on a table without pockets. A shot scores if the balls touch and the
//! number of cushion contacts of both balls together is exactly three. A player who scores shoots
//! again; the first to reach the points of the options wins.
//!
//! The definition is that of pooltool's ruleset `sum_to_three`, which does not mention balls that
//! leave the table. Here such a shot scores nothing, and the ball is put back on its spot.

use carom::{Error, ErrorKind, Shot};
use carom_rules::{
    BallIndex, BallList, Calls, Foul, Fouls, FrameBall, FrameSimulator, StateBytes, Turn,
};

use crate::bare_table::BareTable;
use crate::config::Config;
use crate::episode::{
    Ending, Episode, EpisodeStart, NoisyStrike, ShotResult, Standing, UNPLAYABLE,
};
use crate::random::Dice;
use crate::setup::Setup;
use crate::task::Task;
use crate::task_recorder::TaskRecorder;

/// Number of cushion contacts in a shot that scores.
pub const CUSHIONS: u32 = 3;

const CUE: BallIndex = 0;
const OBJECT: BallIndex = 1;

/// The balls' spots on the long string, as fractions of the table's length.
const SPOTS: [f64; 2] = [0.25, 0.75];

/// Largest random distance of a ball from its spot at the start, along each axis, m. It makes
/// episodes differ.
const SPREAD: f64 = 0.05;

/// A match of sum to three.
#[derive(Clone)]
pub(crate) struct SumToThree {
    table: BareTable,
    /// Points that win.
    points: i32,
    patience: u32,
    turn: Turn,
    scores: [i32; 2],
    /// Shots since the last point.
    idle: u32,
    opening: bool,
    ending: Option<Ending>,
}

impl SumToThree {
    pub(crate) fn new(config: &Config, setup: &Setup) -> Result<Self, Error> {
        let table = setup.table.clone().unwrap_or_else(|| Task::SumToThree.table().into());
        let ids = ["cue", "object"].into_iter().map(String::from);
        let table = BareTable::new(table, setup.physics.clone(), ids)?;
        if !table.base.table().pockets.is_empty() || !table.base.table().size.x.is_finite() {
            return Err(ErrorKind::Unsupported.at(
                "table",
                "sum-to-three is played on a table with cushions and without pockets",
                "choose carom-10ft, carom-9ft, or a rectangle",
            ));
        }
        let turn = Turn {
            player: 0,
            cue: CUE,
            hand: None,
            on: BallList::from(&[OBJECT][..]),
            calls: Calls::default(),
        };
        Ok(Self {
            table,
            points: config.options.points,
            patience: config.options.patience,
            turn,
            scores: [0; 2],
            idle: 0,
            opening: true,
            ending: None,
        })
    }

    fn spot(&self, ball: BallIndex) -> [f64; 2] {
        let size = self.table.base.table().size;
        [0.5 * size.x, SPOTS[usize::from(ball)] * size.y]
    }

    /// Spots balls that left the table: each on its own spot, or on the other ball's if that is
    /// occupied.
    fn spot_lost_balls(&mut self) {
        for ball in [CUE, OBJECT] {
            if self.place(ball).is_some() {
                continue;
            }
            let reach = 2.0 * self.table.base.physics().ball.radius;
            let is_free = |spot: &[f64; 2]| {
                self.place(1 - ball)
                    .is_none_or(|[x, y]| (x - spot[0]).abs() > reach || (y - spot[1]).abs() > reach)
            };
            let spots = [self.spot(ball), self.spot(1 - ball)];
            self.table.places[usize::from(ball)] = spots.into_iter().find(is_free);
        }
    }
}

impl Episode for SumToThree {
    fn base(&self) -> &Shot {
        &self.table.base
    }

    fn balls(&self) -> &[FrameBall] {
        &self.table.balls
    }

    fn place(&self, ball: BallIndex) -> Option<[f64; 2]> {
        self.table.places[usize::from(ball)]
    }

    fn turn(&self) -> Option<&Turn> {
        self.ending.is_none().then_some(&self.turn)
    }

    fn ending(&self) -> Option<Ending> {
        self.ending
    }

    fn standing(&self) -> Standing {
        let scores = self.scores.map(|score| f64::from(score) / f64::from(self.points));
        Standing { scores, opening: self.opening, ..Standing::default() }
    }

    fn scores(&self) -> [i32; 2] {
        self.scores
    }

    fn why(&self) -> Option<&'static str> {
        Some(match self.ending? {
            Ending::Won(_) => "the target was reached",
            _ if self.idle >= self.patience => "a stalemate: there was no progress",
            _ => UNPLAYABLE,
        })
    }

    fn set_up(&mut self, setup: &Setup, config: &Config) -> Result<(), Error> {
        *self = Self::new(config, setup)?;
        Ok(())
    }

    fn start_at(&mut self, start: &EpisodeStart, config: &Config) -> Result<(), Error> {
        self.table.start_at(start, config)?;
        if self.table.places.contains(&None) {
            let remedy = "give both, \"cue\" and \"object\"";
            return Err(ErrorKind::Missing.at("balls", "a ball is missing", remedy));
        }
        Ok(())
    }

    fn write_to(&self, out: &mut Vec<u8>) {
        self.table.write_to(out);
        self.turn.player.write_to(out);
        self.scores.write_to(out);
        self.idle.write_to(out);
        self.opening.write_to(out);
        let ending = match self.ending {
            None => 0_u8,
            Some(Ending::Won(seat)) => 1 + seat as u8,
            Some(Ending::Drawn) => 3,
            Some(Ending::Stalemate) => 4,
        };
        ending.write_to(out);
    }

    fn read_from(&mut self, bytes: &mut &[u8]) -> Option<()> {
        self.table.read_from(bytes)?;
        self.turn.player = StateBytes::read_from(bytes)?;
        self.scores = StateBytes::read_from(bytes)?;
        self.idle = StateBytes::read_from(bytes)?;
        self.opening = StateBytes::read_from(bytes)?;
        self.ending = match u8::read_from(bytes)? {
            0 => None,
            seat @ 1..=2 => Some(Ending::Won(usize::from(seat) - 1)),
            3 => Some(Ending::Drawn),
            4 => Some(Ending::Stalemate),
            _ => return None,
        };
        Some(())
    }

    fn restart(&mut self, seed: u64) -> Result<(), Error> {
        let mut dice = Dice::of_layout(seed);
        for ball in [CUE, OBJECT] {
            let spot = self.spot(ball);
            let place = spot.map(|x| x + dice.between(-SPREAD, SPREAD));
            self.table.places[usize::from(ball)] = Some(place);
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
        simulator: &mut FrameSimulator,
        strike: &NoisyStrike,
        shots: Option<&mut Vec<Shot>>,
    ) -> Result<ShotResult, Error> {
        let seat = self.turn.player;
        let mut recorder = TaskRecorder::new(CUE.into());
        self.opening = false;
        let played = self.table.play(simulator.simulator_mut(), CUE, strike, &mut recorder, shots);
        if let Err(error) = played {
            self.ending = Some(Ending::Stalemate);
            return Err(error);
        }
        self.spot_lost_balls();
        let touched = recorder.first_contact.is_some();
        let scored = touched && recorder.cushions == CUSHIONS && !recorder.left_table;
        let mut points = [0; 2];
        points[seat] = scored.into();
        self.scores[seat] += points[seat];
        self.idle = if scored { 0 } else { self.idle + 1 };
        if self.scores[seat] >= self.points {
            self.ending = Some(Ending::Won(seat));
        } else if self.idle >= self.patience {
            self.ending = Some(Ending::Stalemate);
        } else if !scored {
            self.turn.player = 1 - seat;
        }
        let fouls: Fouls = recorder.left_table.then_some(Foul::BallOffTable).into_iter().collect();
        Ok(ShotResult { legal: fouls.is_empty(), potted: 0, points, fouls })
    }

    fn boxed(&self) -> Box<dyn Episode> {
        Box::new(self.clone())
    }
}
