//! The potting task: one shot at randomly placed balls.

use carom::{Error, Shot};
use carom_rules::{BallIndex, BallList, Calls, FrameBall, FrameSimulator, Turn};

use crate::bare_table::BareTable;
use crate::config::Config;
use crate::episode::{Ending, Episode, NoisyStrike, ShotResult, Standing};
use crate::modes::TargetBall;
use crate::placement;
use crate::random::Dice;
use crate::task_recorder::TaskRecorder;

const CUE: BallIndex = 0;

/// The cue ball and some object balls at random places, for one shot.
#[derive(Clone)]
pub(crate) struct Potting {
    table: BareTable,
    /// Smallest and largest number of object balls.
    balls: [usize; 2],
    target_ball: TargetBall,
    turn: Turn,
    over: bool,
}

impl Potting {
    pub(crate) fn new(config: &Config) -> Result<Self, Error> {
        let balls = config.balls.unwrap_or([1, 1]);
        let ids = (0..=balls[1]).map(|i| if i == 0 { "cue".into() } else { i.to_string() });
        let table = config.table.clone().unwrap_or_else(|| "wpa-9ft".into());
        let table = BareTable::new(table, config.physics.clone(), ids)?;
        if table.base.table().pockets.is_empty() {
            return Err(Error::input(
                "table",
                "a table without pockets has no pots",
                "choose a table with pockets",
            ));
        }
        let turn =
            Turn { player: 0, cue: CUE, hand: None, on: BallList::new(), calls: Calls::default() };
        Ok(Self { table, balls, target_ball: config.target_ball, turn, over: true })
    }
}

impl Episode for Potting {
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

    fn restart(&mut self, seed: u64) -> Result<(), Error> {
        let mut dice = Dice::of_layout(seed);
        let [least, most] = self.balls;
        let count = least + dice.below(most - least + 1);
        let wanted: Vec<bool> = (0..=most).map(|ball| ball <= count).collect();
        let BareTable { base, balls, places } = &mut self.table;
        places.fill(None);
        placement::scatter(base.table(), balls, &wanted, places, &mut dice)?;
        self.turn.on.clear();
        match self.target_ball {
            TargetBall::Any => self.turn.on.extend(1..=count as BallIndex),
            TargetBall::Lowest => self.turn.on.push(1),
        }
        self.over = false;
        Ok(())
    }

    fn play(
        &mut self,
        simulator: &mut FrameSimulator,
        strike: &NoisyStrike,
    ) -> Result<ShotResult, Error> {
        self.over = true;
        // The balls on the table are 0 to `count`, so their indices are those of the shot.
        let mut recorder = TaskRecorder::new(CUE.into());
        self.table.play(simulator.simulator_mut(), CUE, strike, &mut recorder)?;
        let fell = |ball: BallIndex| recorder.pots.iter().any(|(down, _)| *down == ball);
        let legal = !fell(CUE) && !recorder.left_table;
        let potted = legal && self.turn.on.iter().any(|ball| fell(*ball));
        Ok(ShotResult { legal, potted: potted.into(), points: [0; 2] })
    }

    fn boxed(&self) -> Box<dyn Episode> {
        Box::new(self.clone())
    }
}
