//! Episodes of a game with a referee.

use carom::resolve::cue_ball::Strike;
use carom::{Error, ErrorKind, Shot};
use carom_arena::{Execution, LastShot};
use carom_rules::games::eight_ball::{EIGHT, Group};
use carom_rules::{
    BallIndex, Call, Choice, Fouls, Frame, FrameBall, FrameSimulator, Game, Prepared, Request,
    Ruling, Scoring, Seat, StateBytes, Turn, through_degrees,
};

use crate::config::Config;
use crate::episode::{
    Ending, Episode, EpisodeStart, NoisyStrike, ShotResult, Standing, UNPLAYABLE, check_same_place,
};
use crate::placement;
use crate::random::Dice;
use crate::setup::Setup;
use crate::task::Task;
use crate::task_recorder::TaskRecorder;

/// Consecutive fouls that lose a rack of nine-ball.
const SERIOUS: f64 = 3.0;

/// The answers to choices: the first of these that is offered. After a foul on the break the cue
/// ball is played from hand, an eight on the break is spotted, and otherwise the balls are played
/// as they lie.
const ANSWERS: [Choice; 3] = [Choice::PlayFromHand, Choice::SpotEight, Choice::PlayOn];

/// An episode of a game with a referee: one frame.
#[derive(Clone)]
pub(crate) struct FrameEpisode {
    frame: Frame,
    /// Points that win.
    points: i32,
    /// Smallest and largest number of object balls at the start; none if it starts with a rack.
    balls: Option<[usize; 2]>,
    /// The seat that answers its choices itself: that of a player.
    chooser: Option<Seat>,
    /// The last shot, if there is such a seat.
    last: Option<LastMove>,
    /// Whether a shot could not be played.
    failed: bool,
}

/// A shot, as everybody at the table has seen it.
#[derive(Clone)]
struct LastMove {
    seat: Seat,
    call: Call,
    execution: Execution,
    ruling: Ruling,
    /// The choice that a player has made since.
    choice: Option<Choice>,
}

impl FrameEpisode {
    pub(crate) fn new(game: Game, config: &Config, setup: &Setup) -> Result<Self, Error> {
        let table = setup.table.clone().unwrap_or_else(|| Task::Game(game).table().into());
        let (table, physics) = (Some(table), setup.physics.clone());
        let frame = Frame::new(game, config.options, table, physics, 0)?;
        let (points, balls) = (config.options.points, config.balls);
        Ok(Self { frame, points, balls, chooser: None, last: None, failed: false })
    }

    /// Whether the shooter may pot `ball` in this turn.
    fn may_pot(&self, turn: &Turn, ball: BallIndex) -> bool {
        ball != turn.cue && self.frame.facts().may_pot(&turn.on, ball)
    }

    /// The call for a shot without an expected pot.
    fn default_call(turn: &Turn) -> Call {
        if turn.calls.nominate {
            Call::On(turn.on[0])
        } else if turn.calls.required {
            Call::Safety
        } else {
            Call::Nothing
        }
    }

    /// The call for a shot: the pot, or the first ball hit, of the `intended` strike without noise.
    fn call(
        &self,
        simulator: &mut FrameSimulator,
        prepared: &Prepared<'_>,
        intended: &Strike,
    ) -> Call {
        let (turn, shot) = (prepared.turn(), prepared.shot());
        let default = Self::default_call(turn);
        if default == Call::Nothing {
            return default;
        }
        let struck = shot.strike().map(|(ball, _)| (ball, *intended));
        let mut expected = TaskRecorder::new(shot.cue_ball().unwrap_or_default());
        if simulator.simulator_mut().play_strike(shot, struck, &mut expected).is_err() {
            return default;
        }
        let ball = |k: u16| prepared.balls()[usize::from(k)];
        if turn.calls.nominate {
            let first = expected.first_contact.map(ball);
            return first.filter(|first| turn.on.contains(first)).map_or(default, Call::On);
        }
        let pockets = &self.frame.base().table().pockets;
        let pot = expected.pots.iter().find(|(k, _)| self.may_pot(turn, ball(*k)));
        pot.map_or(default, |&(k, pocket)| Call::Pocket(ball(k), pockets[usize::from(pocket)].name))
    }

    /// Answers the choices of the seats that do not answer themselves.
    fn answer_choices(&mut self) -> Result<(), Error> {
        while let Request::Choice { player, choices, .. } = self.frame.request()
            && Some(*player) != self.chooser
        {
            let usual = ANSWERS.into_iter().find(|answer| choices.contains(answer));
            let Some(answer) = usual.or_else(|| choices.first().copied()) else { break };
            self.frame.choose(answer)?;
            self.note_choice(answer);
        }
        Ok(())
    }

    fn note_choice(&mut self, choice: Choice) {
        if let Some(last) = &mut self.last {
            last.choice = Some(choice);
        }
    }

    fn try_play(
        &mut self,
        simulator: &mut FrameSimulator,
        strike: &NoisyStrike,
        shots: Option<&mut Vec<Shot>>,
    ) -> Result<ShotResult, Error> {
        let Some(turn) = self.frame.turn().copied() else {
            return Err(ErrorKind::WrongState.at(
                "step",
                "the episode is over",
                "reset the environment",
            ));
        };
        let prepared = Prepared::new(&self.frame, strike.cue_ball)?;
        let [intended, actual] = [strike.intended, strike.actual].map(|s| through_degrees(&s));
        prepared.shot().resolve_strike(&intended)?;
        if strike.cling.is_empty() {
            simulator.simulate(&prepared, &actual)?;
        } else {
            // The call is chosen without noise.
            let clung = prepared.shot().with_cling(strike.cling);
            simulator.simulate_shot(&prepared, &clung, &actual)?;
        }
        let call = match strike.call {
            Some(call) => call,
            // Where no ball falls, no ruling depends on a call that names a pocket. Opponents see it.
            None if simulator.outcome().pocketed.is_empty()
                && !turn.calls.nominate
                && self.chooser.is_none() =>
            {
                Self::default_call(&turn)
            }
            None => self.call(simulator, &prepared, &intended),
        };
        if let Some(shots) = shots {
            let shot = prepared.shot().with_cling(strike.cling).with_strike(&actual)?;
            shots.push(shot);
        }
        let mut successor = self.frame.clone();
        let ruling = simulator.rule(&prepared, call, &mut successor)?;
        let legal = ruling.is_legal();
        let pocketed = &simulator.outcome().pocketed;
        let may_pot = |(ball, _): &&(BallIndex, _)| self.may_pot(&turn, *ball);
        let potted = if legal { pocketed.iter().filter(may_pot).count() as u32 } else { 0 };
        self.frame = successor;
        self.last = self.chooser.map(|_| LastMove {
            seat: turn.player,
            call,
            execution: Execution { strike: actual, cue_ball: strike.cue_ball, cling: strike.cling },
            ruling,
            choice: None,
        });
        self.answer_choices()?;
        Ok(ShotResult { legal, potted, points: ruling.points, fouls: ruling.fouls })
    }

    fn try_choose(&mut self, choice: Option<Choice>) -> Result<ShotResult, Error> {
        let ruling = match choice {
            Some(choice) => self.frame.choose(choice)?,
            None => self.frame.concede()?,
        };
        if let Some(choice) = choice {
            self.note_choice(choice);
        }
        self.answer_choices()?;
        Ok(ShotResult { legal: true, potted: 0, points: ruling.points, fouls: Fouls::NONE })
    }
}

impl Episode for FrameEpisode {
    fn base(&self) -> &Shot {
        self.frame.base()
    }

    fn balls(&self) -> &[FrameBall] {
        self.frame.layout().balls()
    }

    fn place(&self, ball: BallIndex) -> Option<[f64; 2]> {
        self.frame.layout().place(ball)
    }

    fn turn(&self) -> Option<&Turn> {
        if self.failed { None } else { self.frame.turn() }
    }

    fn ending(&self) -> Option<Ending> {
        match self.frame.request() {
            _ if self.failed => Some(Ending::Stalemate),
            Request::Over { winner: Some(player), .. } => Some(Ending::Won(*player)),
            Request::Over { winner: None, .. } => {
                let reached = self.frame.scores().iter().any(|score| *score >= self.points);
                let drawn = self.frame.facts().has_equal_innings() && reached;
                Some(if drawn { Ending::Drawn } else { Ending::Stalemate })
            }
            _ => None,
        }
    }

    fn standing(&self) -> Standing {
        let whole = f64::from(match self.frame.facts().scoring {
            Scoring::Points { maximum } => maximum,
            Scoring::LastBall | Scoring::Target { .. } => self.points,
        });
        Standing {
            scores: self.frame.scores().map(|score| f64::from(score) / whole),
            fouls: self.frame.fouls_in_a_row().map(|fouls| f64::from(fouls) / SERIOUS),
            opening: self.frame.shots() == 0 && self.balls.is_none(),
        }
    }

    fn scores(&self) -> [i32; 2] {
        self.frame.scores()
    }

    fn ball_seen(&self, viewer: Seat, k: BallIndex) -> BallIndex {
        let stripes = || self.frame.group(viewer) == Some(Group::Stripes);
        match k {
            // Order: the viewer's cue ball, the other cue ball, the red.
            0 | 1 if self.frame.facts().own_cue_balls => k ^ BallIndex::from(viewer == 1),
            // Order: the viewer's group, the eight, the other group.
            1..=7 if stripes() => k + EIGHT,
            9..=15 if stripes() => k - EIGHT,
            _ => k,
        }
    }

    fn why(&self) -> Option<&'static str> {
        match self.frame.request() {
            _ if self.failed => Some(UNPLAYABLE),
            Request::Over { why, .. } => Some(why),
            _ => None,
        }
    }

    fn set_up(&mut self, setup: &Setup, config: &Config) -> Result<(), Error> {
        *self = Self::new(self.frame.game(), config, setup)?;
        Ok(())
    }

    fn start_at(&mut self, start: &EpisodeStart, config: &Config) -> Result<(), Error> {
        match start {
            EpisodeStart::Shot(shot) => {
                check_same_place(self.frame.base(), shot, config)?;
                let places = self.frame.places_of(shot)?;
                self.frame.resume_at(&places, 0)?;
            }
            EpisodeStart::Frame(frame) => {
                let wrong =
                    |kind: ErrorKind, what: String, remedy| Err(kind.at("frame", what, remedy));
                let game = self.frame.game();
                if frame.game() != game {
                    let what = format!("it is {}, not {}", frame.game().name(), game.name());
                    return wrong(
                        ErrorKind::Mismatch,
                        what,
                        "give a frame of the environment's game",
                    );
                }
                check_same_place(self.frame.base(), frame.base(), config)?;
                if frame.is_over() {
                    return wrong(
                        ErrorKind::FrameOver,
                        "it is over".into(),
                        "give one that asks for a shot or a choice",
                    );
                }
                let counts = frame.facts().has_target();
                if counts && frame.options().points != self.points {
                    let what = format!("it is to {} points", frame.options().points);
                    return wrong(
                        ErrorKind::Mismatch,
                        what,
                        "make the environment with the same points=",
                    );
                }
                self.frame.clone_from(frame);
            }
        }
        self.answer_choices()
    }

    fn set_chooser(&mut self, chooser: Option<Seat>) {
        self.chooser = chooser;
    }

    fn reseed(&mut self, seed: u64) {
        self.frame.reseed(seed);
    }

    fn call_of(&self, simulator: &mut FrameSimulator, strike: &NoisyStrike) -> Call {
        let prepared = Prepared::new(&self.frame, strike.cue_ball);
        let intended = through_degrees(&strike.intended);
        prepared.map_or(Call::Nothing, |prepared| self.call(simulator, &prepared, &intended))
    }

    fn write_to(&self, out: &mut Vec<u8>) {
        self.failed.write_to(out);
        self.frame.write_to(out);
    }

    fn read_from(&mut self, bytes: &mut &[u8]) -> Option<()> {
        self.failed = StateBytes::read_from(bytes)?;
        self.last = None;
        self.frame = self.frame.read_same(bytes)?;
        Some(())
    }

    fn restart(&mut self, seed: u64) -> Result<(), Error> {
        self.frame = self.frame.with_seed(seed)?;
        (self.last, self.failed) = (None, false);
        let Some([least, most]) = self.balls else { return Ok(()) };
        let mut dice = Dice::of_layout(seed);
        let layout = self.frame.layout();
        let Some(start) = self.frame.facts().random_start else { return Ok(()) };
        let mut wanted = vec![false; layout.len()];
        start.always.iter().for_each(|ball| wanted[usize::from(*ball)] = true);
        let mut missing = least + dice.below(most - least + 1) - (start.always.len() - 1);
        while let (1.., Some([first, last])) = (missing, start.drawn) {
            let ball = usize::from(first) + dice.below(usize::from(last - first) + 1);
            missing -= usize::from(!wanted[ball]);
            wanted[ball] = true;
        }
        let is_spotted =
            |ball| start.racked.is_some_and(|[first, last]| (first..=last).contains(&ball));
        let mut places: Vec<_> = (0..layout.len() as BallIndex)
            .map(|ball| layout.place(ball).filter(|_| is_spotted(ball)))
            .collect();
        let table = self.frame.base().table();
        placement::scatter(table, layout.balls(), &wanted, &mut places, &mut dice)?;
        self.frame.resume_at(&places, 0)
    }

    fn frame(&self) -> Option<&Frame> {
        (!self.failed).then_some(&self.frame)
    }

    fn last_shot(&self) -> Option<LastShot<'_>> {
        let LastMove { seat, call, execution, ruling, choice } = self.last.as_ref()?;
        Some(LastShot { seat: *seat, call: *call, execution, ruling, choice: *choice })
    }

    fn choose(&mut self, choice: Option<Choice>) -> Result<ShotResult, Error> {
        let result = self.try_choose(choice);
        self.failed |= result.is_err();
        result
    }

    fn play(
        &mut self,
        simulator: &mut FrameSimulator,
        strike: &NoisyStrike,
        shots: Option<&mut Vec<Shot>>,
    ) -> Result<ShotResult, Error> {
        let result = self.try_play(simulator, strike, shots);
        self.failed |= result.is_err();
        result
    }

    fn boxed(&self) -> Box<dyn Episode> {
        Box::new(self.clone())
    }
}
