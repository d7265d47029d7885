//! The potting task: one shot at randomly placed balls.

use carom::{Error, ErrorKind, Shot};
use carom_rules::{
    BallIndex, BallList, Calls, Foul, Fouls, FrameBall, FrameSimulator, StateBytes, Turn,
};

use crate::bare_table::BareTable;
use crate::config::Config;
use crate::episode::{Ending, Episode, EpisodeStart, NoisyStrike, ShotResult, Standing};
use crate::modes::TargetBall;
use crate::placement;
use crate::random::Dice;
use crate::setup::Setup;
use crate::task::Task;
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
    pub(crate) fn new(config: &Config, setup: &Setup) -> Result<Self, Error> {
        let balls = config.balls.unwrap_or([1, 1]);
        let ids = (0..=balls[1]).map(|i| if i == 0 { "cue".into() } else { i.to_string() });
        let table = setup.table.clone().unwrap_or_else(|| Task::Potting.table().into());
        let table = BareTable::new(table, setup.physics.clone(), ids)?;
        if table.base.table().pockets.is_empty() {
            return Err(ErrorKind::Unsupported.at(
                "table",
                "a table without pockets has no pots",
                "choose a table with pockets",
            ));
        }
        let turn =
            Turn { player: 0, cue: CUE, hand: None, on: BallList::new(), calls: Calls::default() };
        Ok(Self { table, balls, target_ball: config.target_ball, turn, over: true })
    }

    /// Determines the balls on: those on the table, or the 1.
    fn set_targets(&mut self) {
        let on_table = (1..).zip(&self.table.places[1..]).filter(|(_, place)| place.is_some());
        self.turn.on = match self.target_ball {
            TargetBall::Any => on_table.map(|(ball, _)| ball).collect(),
            TargetBall::Lowest => BallList::from(&[1][..]),
        };
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
        self.set_targets();
        self.over = false;
        Ok(())
    }

    fn why(&self) -> Option<&'static str> {
        self.over.then_some("the shot was played")
    }

    fn set_up(&mut self, setup: &Setup, config: &Config) -> Result<(), Error> {
        *self = Self::new(config, setup)?;
        Ok(())
    }

    fn start_at(&mut self, start: &EpisodeStart, config: &Config) -> Result<(), Error> {
        self.over = true;
        self.table.start_at(start, config)?;
        let is_missing = |ball: usize| self.table.places[ball].is_none();
        let target = match self.target_ball {
            TargetBall::Any => self.table.places[1..].iter().all(Option::is_none),
            TargetBall::Lowest => is_missing(1),
        };
        if is_missing(CUE.into()) || target {
            let missing = if target { "a ball to pot" } else { "the cue ball" };
            let what = format!("{missing} is missing");
            return Err(ErrorKind::Missing.at(
                "balls",
                what,
                "give the balls \"cue\" and \"1\" at least",
            ));
        }
        self.set_targets();
        self.over = false;
        Ok(())
    }

    fn write_to(&self, out: &mut Vec<u8>) {
        self.table.write_to(out);
        self.over.write_to(out);
    }

    fn read_from(&mut self, bytes: &mut &[u8]) -> Option<()> {
        self.table.read_from(bytes)?;
        self.set_targets();
        self.over = StateBytes::read_from(bytes)?;
        Some(())
    }

    fn play(
        &mut self,
        simulator: &mut FrameSimulator,
        strike: &NoisyStrike,
        shots: Option<&mut Vec<Shot>>,
    ) -> Result<ShotResult, Error> {
        self.over = true;
        let on_table: BallList =
            (0..).zip(&self.table.places).filter(|(_, at)| at.is_some()).map(|(i, _)| i).collect();
        let mut recorder = TaskRecorder::new(CUE.into());
        self.table.play(simulator.simulator_mut(), CUE, strike, &mut recorder, shots)?;
        let fell = |ball: BallIndex| {
            recorder.pots.iter().any(|(down, _)| on_table[usize::from(*down)] == ball)
        };
        let scratch = fell(CUE).then_some(Foul::Scratch);
        let left = recorder.left_table.then_some(Foul::BallOffTable);
        let fouls: Fouls = scratch.into_iter().chain(left).collect();
        let legal = fouls.is_empty();
        let potted = legal && self.turn.on.iter().any(|ball| fell(*ball));
        Ok(ShotResult { legal, potted: potted.into(), points: [0; 2], fouls })
    }

    fn boxed(&self) -> Box<dyn Episode> {
        Box::new(self.clone())
    }
}
