//! A frame of a game with a referee.

use core::ops::Range;

use carom::limits::SMALL_CAPACITY;
use carom::simulate::Simulation;
use carom::{Error, Shot};
use carom_rules::games::Law;
use carom_rules::games::eight_ball::Group;
use carom_rules::{BallIndex, Call, Choice, Frame, Piece, Play, Player, Request, Rules, Turn};

use crate::config::Config;
use crate::notes::Notes;
use crate::place;
use crate::random::Dice;
use crate::scene::{Ending, Played, Scene, Standing, Stroke, in_order};

const EIGHT: BallIndex = 8;

/// What a score is measured by in snooker: the largest break.
const MAXIMUM_BREAK: f64 = 147.0;

/// Fouls in a row that lose a rack of nine-ball.
const SERIOUS: f64 = 3.0;

/// How choices are answered: the first of these that is offered. A foul on the break is answered with the cue
/// ball in hand; an eight on the break is spotted; else the balls are played as they lie.
const ANSWERS: [Choice; 3] = [Choice::PlayFromHand, Choice::SpotEight, Choice::PlayOn];

/// A frame.
#[derive(Clone)]
pub(crate) struct FrameScene {
    frame: Frame,
    target: i32,
    /// Object balls at the start, where it does not begin with a rack.
    balls: Option<[usize; 2]>,
    failed: bool,
}

impl FrameScene {
    pub(crate) fn new(rules: Rules, config: &Config) -> Result<Self, Error> {
        let (table, physics) = (config.table.clone(), config.physics.clone());
        let frame = Frame::new(rules, config.options, table, physics, 0)?;
        Ok(Self { frame, target: config.options.target, balls: config.balls, failed: false })
    }

    /// Whether `ball` is the shooter's to pot in this turn.
    fn may_pot(&self, turn: &Turn, ball: BallIndex) -> bool {
        if ball == turn.cue {
            return false;
        }
        match self.frame.rules() {
            Rules::EightBall if turn.on.is_empty() => ball != EIGHT,
            Rules::EightBall | Rules::Snooker => turn.on.contains(&ball),
            _ => true,
        }
    }

    /// The numbers of the shot's balls in the frame.
    fn balls_of_shot(&self, turn: &Turn) -> Vec<BallIndex> {
        let layout = self.frame.layout();
        (0..layout.len() as BallIndex)
            .filter(|ball| *ball == turn.cue || !layout.is_down(*ball))
            .collect()
    }

    /// What the player announces if nothing is foreseen.
    fn nothing_foreseen(turn: &Turn) -> Call {
        if turn.calls.nominate {
            Call::On(turn.on[0])
        } else if turn.calls.required {
            Call::Safety
        } else {
            Call::Nothing
        }
    }

    /// What the player announces: what the shot would do if it came out as it is `meant`.
    fn call(
        &self,
        simulation: &mut Simulation<SMALL_CAPACITY>,
        turn: &Turn,
        meant: &Shot,
        balls: &[BallIndex],
    ) -> Call {
        let nothing = Self::nothing_foreseen(turn);
        let mut foresight = Notes::new(meant.cue_ball().unwrap_or_default());
        // Where nothing can be foreseen, nothing is promised.
        if nothing == Call::Nothing || simulation.play(meant, &mut foresight).is_err() {
            return nothing;
        }
        let ball = |k: u16| balls[usize::from(k)];
        if turn.calls.nominate {
            let first = foresight.first_contact.map(ball);
            return first.filter(|first| turn.on.contains(first)).map_or(nothing, Call::On);
        }
        let pockets = &self.frame.base().table().pockets;
        let pot = foresight.pots().find(|(k, _)| self.may_pot(turn, ball(*k)));
        pot.map_or(nothing, |(k, pocket)| Call::Pocket(ball(k), pockets[usize::from(pocket)].name))
    }

    fn answer_choices(&mut self) -> Result<(), Error> {
        while let Request::Choice { choices, .. } = self.frame.request() {
            let usual = ANSWERS.into_iter().find(|answer| choices.contains(answer));
            let Some(answer) = usual.or_else(|| choices.first().copied()) else { break };
            self.frame.choose(answer)?;
        }
        Ok(())
    }

    fn try_play(
        &mut self,
        simulation: &mut Simulation<SMALL_CAPACITY>,
        stroke: &Stroke,
    ) -> Result<Played, Error> {
        let Some(turn) = self.frame.turn().cloned() else {
            return Err(Error::input("step", "the episode is over", "reset the environment"));
        };
        let balls = self.balls_of_shot(&turn);
        let Stroke { meant, struck, cue_ball } = *stroke;
        let prepared = Play { strike: meant, cue_ball, call: Self::nothing_foreseen(&turn) };
        let prepared = self.frame.shot(&prepared)?;
        let call = self.call(simulation, &turn, &prepared, &balls);
        let play = Play { strike: struck, cue_ball, call };
        let (ruling, outcome) = self.frame.play_prepared(simulation, &play, &prepared)?;
        let legal = ruling.is_legal();
        let mine = |(k, _): &&(u16, _)| self.may_pot(&turn, balls[usize::from(*k)]);
        let potted = if legal { outcome.pocketed.iter().filter(mine).count() as u32 } else { 0 };
        self.answer_choices()?;
        Ok(Played { legal, potted, points: ruling.points })
    }
}

impl Scene for FrameScene {
    fn base(&self) -> &Shot {
        self.frame.base()
    }

    fn pieces(&self) -> &[Piece] {
        self.frame.layout().pieces()
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
                let reached = self.frame.scores().iter().any(|score| *score >= self.target);
                let drawn = self.frame.rules() == Rules::ThreeCushion && reached;
                Some(if drawn { Ending::Drawn } else { Ending::Stalemate })
            }
            _ => None,
        }
    }

    fn standing(&self) -> Standing {
        let whole = match self.frame.rules() {
            Rules::Snooker => MAXIMUM_BREAK,
            _ => f64::from(self.target),
        };
        Standing {
            scores: self.frame.scores().map(|score| f64::from(score) / whole),
            fouls: self.frame.fouls_in_a_row().map(|fouls| f64::from(fouls) / SERIOUS),
            opening: self.frame.shots() == 0 && self.balls.is_none(),
        }
    }

    fn scores(&self) -> [i32; 2] {
        self.frame.scores()
    }

    fn order(&self, viewer: Player) -> [BallIndex; SMALL_CAPACITY] {
        let mut order = in_order();
        match self.frame.law() {
            // The own group, the eight, the other's.
            Law::EightBall(game) if game.group(viewer) == Some(Group::Stripes) => {
                for k in 1..EIGHT {
                    order.swap(usize::from(k), usize::from(k + EIGHT));
                }
            }
            // The own cue ball, the other's, the red.
            Law::ThreeCushion(_) => order.swap(0, viewer),
            _ => {}
        }
        order
    }

    fn restart(&mut self, seed: u64) -> Result<(), Error> {
        self.frame = self.frame.another(seed)?;
        self.failed = false;
        let Some([least, most]) = self.balls else { return Ok(()) };
        let mut dice = Dice::of_layout(seed);
        let layout = self.frame.layout();
        let (always, others, spotted) = placed_at_random(self.frame.rules(), layout.len());
        let mut wanted = vec![false; layout.len()];
        always.iter().for_each(|ball| wanted[*ball] = true);
        let mut missing = least + dice.below(most - least + 1) - (always.len() - 1);
        while missing > 0 {
            let ball = others.start + dice.below(others.len());
            missing -= usize::from(!wanted[ball]);
            wanted[ball] = true;
        }
        let stands = |ball| spotted.contains(&usize::from(ball));
        let mut places: Vec<_> = (0..layout.len() as BallIndex)
            .map(|ball| layout.place(ball).filter(|_| stands(ball)))
            .collect();
        let table = self.frame.base().table();
        place::scatter(table, layout.pieces(), &wanted, &mut places, &mut dice)?;
        self.frame.scatter(&places, 0)
    }

    fn play(
        &mut self,
        simulation: &mut Simulation<SMALL_CAPACITY>,
        stroke: &Stroke,
    ) -> Result<Played, Error> {
        let played = self.try_play(simulation, stroke);
        self.failed |= played.is_err();
        played
    }

    fn boxed(&self) -> Box<dyn Scene> {
        Box::new(self.clone())
    }
}

/// Of a game that begins in the middle, with `count` balls: which of them lie at random in any case, among
/// which the others are drawn that do, and which stand where they are racked.
const fn placed_at_random(
    rules: Rules,
    count: usize,
) -> (&'static [usize], Range<usize>, Range<usize>) {
    match rules {
        Rules::EightBall => (&[0, 8], 1..count, 0..0),
        Rules::NineBall => (&[0, 9], 1..count, 0..0),
        Rules::TenBall => (&[0, 10], 1..count, 0..0),
        Rules::Snooker => (&[0], 1..16, 16..count),
        Rules::ThreeCushion => (&[0, 1, 2], 0..0, 0..0),
        Rules::StraightPool | Rules::Practice => (&[0], 1..count, 0..0),
    }
}
