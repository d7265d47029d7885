//! One shot at balls that lie anywhere.

use carom::limits::SMALL_CAPACITY;
use carom::simulate::Simulation;
use carom::{Error, Shot};
use carom_rules::{BallIndex, Calls, Piece, Player, Turn};

use crate::config::{Config, Target};
use crate::notes::Notes;
use crate::place;
use crate::random::Dice;
use crate::scene::{Bed, Ending, Played, Scene, Standing, Stroke, in_order};

const CUE: BallIndex = 0;

/// The cue ball and some object balls at random; the shot pots, or does not.
#[derive(Clone)]
pub(crate) struct Potting {
    bed: Bed,
    balls: [usize; 2],
    target: Target,
    turn: Turn,
    over: bool,
}

impl Potting {
    pub(crate) fn new(config: &Config) -> Result<Self, Error> {
        let balls = config.balls.unwrap_or([1, 1]);
        let ids = (0..=balls[1]).map(|i| if i == 0 { "cue".into() } else { i.to_string() });
        let table = config.table.clone().unwrap_or_else(|| "wpa-9ft".into());
        let bed = Bed::new(table, config.physics.clone(), ids)?;
        if bed.base.table().pockets.is_empty() {
            return Err(Error::input(
                "table",
                "nothing can be potted on a table without pockets",
                "choose a table with pockets",
            ));
        }
        let turn =
            Turn { player: 0, cue: CUE, hand: None, on: Vec::new(), calls: Calls::default() };
        Ok(Self { bed, balls, target: config.target, turn, over: true })
    }
}

impl Scene for Potting {
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
        (!self.over).then_some(&self.turn)
    }

    fn ending(&self) -> Option<Ending> {
        self.over.then_some(Ending::Drawn)
    }

    fn standing(&self) -> Standing {
        Standing { opening: !self.over, ..Standing::default() }
    }

    fn scores(&self) -> [i32; 2] {
        [0; 2]
    }

    fn order(&self, _: Player) -> [BallIndex; SMALL_CAPACITY] {
        in_order()
    }

    fn restart(&mut self, seed: u64) -> Result<(), Error> {
        let mut dice = Dice::of_layout(seed);
        let [least, most] = self.balls;
        let count = least + dice.below(most - least + 1);
        let wanted: Vec<bool> = (0..=most).map(|ball| ball <= count).collect();
        let table = self.bed.base.table();
        self.bed.places.fill(None);
        place::scatter(table, &self.bed.pieces, &wanted, &mut self.bed.places, &mut dice)?;
        self.turn.on.clear();
        match self.target {
            Target::Any => self.turn.on.extend(1..=count as BallIndex),
            Target::Lowest => self.turn.on.push(1),
        }
        self.over = false;
        Ok(())
    }

    fn play(
        &mut self,
        simulation: &mut Simulation<SMALL_CAPACITY>,
        stroke: &Stroke,
    ) -> Result<Played, Error> {
        self.over = true;
        // Balls are on the table from the first to the last: their numbers are the shot's.
        let mut notes = Notes::new(CUE.into());
        self.bed.play(simulation, CUE, stroke.struck, &mut notes)?;
        let fell = |ball: BallIndex| notes.pots().any(|(down, _)| down == u16::from(ball));
        let legal = !fell(CUE) && !notes.left_table;
        let potted = legal && self.turn.on.iter().any(|ball| fell(*ball));
        Ok(Played { legal, potted: potted.into(), points: [0; 2] })
    }

    fn boxed(&self) -> Box<dyn Scene> {
        Box::new(self.clone())
    }
}
