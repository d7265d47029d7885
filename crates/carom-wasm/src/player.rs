//! `Player`: decisions and analyses of the built-in players, one round of the search at a time.

use carom::format::Node;
use carom::math::sqrt;
use carom::noise::Perception;
use carom::{Error, ErrorKind, Noise};
use carom_arena::{BuiltInPlayer, TimeLimit};
use carom_mind::search::Rounds;
use carom_mind::{Analysis, Answer, Budget, Decision, Recommendation, Searcher, Situation, Spent};
use carom_plan::{CaromRoute, Chance, Moments, wilson};
use carom_rules::BallIndex;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::batch::read_json;
use crate::error::to_exception;
use crate::rules::Frame;

/// Confidence level of the chances, as in Python.
const LEVEL: f64 = 0.95;

#[wasm_bindgen]
extern "C" {
    /// Time, ms. WebAssembly has no clock of its own.
    #[wasm_bindgen(js_namespace = performance)]
    fn now() -> f64;
}

/// The names of the built-in players.
#[wasm_bindgen]
pub fn players() -> Vec<String> {
    BuiltInPlayer::names().map(String::from).collect()
}

/// The errors, the seed and the budget of a decision.
#[wasm_bindgen]
#[derive(Clone)]
pub struct Thinking {
    noise: [Noise; 2],
    perception: Perception,
    seed: u64,
    simulations: u64,
    rounds: Option<u32>,
    time: Option<f64>,
}

#[wasm_bindgen]
impl Thinking {
    /// The errors of the player and of the opponent and of the perceived positions, JSON; the time in
    /// seconds.
    #[wasm_bindgen(constructor)]
    pub fn new(
        noise: &str,
        opponent_noise: &str,
        perception: Option<String>,
        seed: u64,
        simulations: u64,
        rounds: Option<u32>,
        time: Option<f64>,
    ) -> Result<Self, JsValue> {
        let read = || {
            let own = read_json(noise, "noise", Noise::read)?;
            let other = read_json(opponent_noise, "opponentNoise", Noise::read)?;
            let perception = match &perception {
                Some(json) => read_json(json, "perception", Perception::read)?,
                None => Perception::default(),
            };
            Ok(Self { noise: [own, other], perception, seed, simulations, rounds, time })
        };
        read().map_err(|e: Error| to_exception(&e))
    }
}

/// A built-in player.
#[wasm_bindgen]
pub struct Player(BuiltInPlayer);

#[wasm_bindgen]
impl Player {
    /// The player of a name; a number of simulated shots may follow, as in `carom:2000`.
    #[wasm_bindgen(constructor)]
    pub fn new(name: &str) -> Result<Self, JsValue> {
        BuiltInPlayer::read(name).map(Self).map_err(|e| to_exception(&e))
    }

    /// Its name, without the number.
    pub fn name(&self) -> String {
        self.0.name().into()
    }

    /// The errors of the strikes of a level of strength, JSON.
    pub fn noise(&self) -> Option<String> {
        self.0.noise().map(|noise| noise.to_node().to_json())
    }

    /// The simulated shots that the name gives.
    pub fn simulations(&self) -> Option<u32> {
        self.0.simulations()
    }

    /// Begins to think about the answer to the frame's request; or, with a number of `plays`, about
    /// the best plays.
    pub fn begin(
        &self,
        frame: &Frame,
        thinking: &Thinking,
        plays: Option<usize>,
    ) -> Result<Thought, JsValue> {
        Thought::begin(self.0.clone(), frame, thinking, plays).map_err(|e| to_exception(&e))
    }
}

/// How far a player has thought.
enum Stage {
    /// Between two rounds of the searching player.
    Rounds(Box<(Searcher, Rounds)>),
    /// Before and after the decision of a player that decides in one step.
    OneStep(Option<Decision>),
}

/// A player that thinks, round by round: [`Self::play_round`] until it returns false, then
/// [`Self::into_decision`] or [`Self::into_analysis`].
#[wasm_bindgen]
pub struct Thought {
    of: BuiltInPlayer,
    frame: carom_rules::Frame,
    /// With the errors by seat.
    thinking: Thinking,
    /// When it began, ms.
    began: f64,
    limit: Option<TimeLimit>,
    stage: Stage,
}

impl Thought {
    fn begin(
        of: BuiltInPlayer,
        frame: &Frame,
        thinking: &Thinking,
        plays: Option<usize>,
    ) -> Result<Self, Error> {
        let frame = frame.0.clone();
        let mut thinking = thinking.clone();
        if frame.player() == Some(1) {
            thinking.noise.reverse();
        }
        let (began, limit) = (now(), thinking.time.map(TimeLimit::new));
        let stage = Stage::OneStep(None);
        let mut thought = Self { of, frame, thinking, began, limit, stage };
        let searches = thought.of.is_searcher() && thought.frame.turn().is_some();
        if plays.is_some() || searches {
            let searcher = thought.of.searcher()?;
            let count = plays.unwrap_or(searcher.settings().stated);
            let rounds = thought.with_budget(|situation, budget| {
                Ok::<_, Error>(searcher.search(situation, budget, count)?.into_rounds())
            })?;
            thought.stage = Stage::Rounds(Box::new((searcher, rounds)));
        }
        Ok(thought)
    }

    /// Calls `work` with what the player knows and may spend.
    fn with_budget<T>(&self, work: impl FnOnce(&Situation<'_>, &Budget<'_>) -> T) -> T {
        let Thinking { noise, perception, seed, simulations, rounds, .. } = &self.thinking;
        let (noise, perception) = (noise.clone(), perception.clone());
        let situation = Situation { frame: &self.frame, noise, perception, seed: *seed };
        let is_over = |_: Spent| {
            self.limit.as_ref().is_some_and(|limit| limit.is_over((now() - self.began) / 1e3))
        };
        let budget =
            Budget { rounds: *rounds, is_over: &is_over, ..Budget::simulations(*simulations) };
        work(&situation, &budget)
    }

    fn go_on(&mut self) -> Result<bool, Error> {
        // Taken out, because the work borrows the rest.
        let mut stage = std::mem::replace(&mut self.stage, Stage::OneStep(None));
        let of = &self.of;
        let went_on = self.with_budget(|situation, budget| match &mut stage {
            Stage::Rounds(search) => {
                let (searcher, rounds) = &mut **search;
                let mut search = searcher.resume(rounds.clone(), situation, budget)?;
                let is_played = search.play_round()?;
                *rounds = search.into_rounds();
                Ok(is_played)
            }
            Stage::OneStep(Some(_)) => Ok(false),
            Stage::OneStep(decision) => {
                of.check_budget(budget)?;
                *decision = Some(of.make()?.decide(situation, budget)?);
                Ok(true)
            }
        });
        self.stage = stage;
        went_on
    }

    fn decide(&mut self) -> Result<Decision, Error> {
        if matches!(self.stage, Stage::OneStep(None)) {
            self.go_on()?;
        }
        match std::mem::replace(&mut self.stage, Stage::OneStep(None)) {
            Stage::OneStep(Some(decision)) => Ok(decision),
            Stage::Rounds(search) => {
                let (searcher, rounds) = *search;
                self.with_budget(|situation, budget| {
                    searcher.resume(rounds, situation, budget)?.decision()
                })
            }
            Stage::OneStep(None) => unreachable!("the decision was made above"),
        }
    }

    fn analyse(self) -> Result<Analysis, Error> {
        let Self { stage, .. } = &self;
        let Stage::Rounds(search) = stage else {
            let what = "this is a decision, not an analysis";
            return Err(ErrorKind::WrongState.at("thought", what, "begin with a number of plays"));
        };
        let (searcher, rounds) = &**search;
        let rounds = rounds.clone();
        self.with_budget(|situation, budget| searcher.resume(rounds, situation, budget)?.analysis())
    }
}

#[wasm_bindgen]
impl Thought {
    /// Plays the next round if the budget allows one. Returns whether it was played. Players without
    /// rounds decide in the first call.
    #[wasm_bindgen(js_name = playRound)]
    pub fn play_round(&mut self) -> Result<bool, JsValue> {
        self.go_on().map_err(|e| to_exception(&e))
    }

    /// What was found and spent so far, JSON: `play` (null if there is none), `win_chance`,
    /// `simulations` and `rounds`.
    pub fn progress(&self) -> String {
        let (best, spent) = match &self.stage {
            Stage::Rounds(search) => (search.1.best(), search.1.spent()),
            Stage::OneStep(decision) => {
                (None, decision.as_ref().map_or(Spent::default(), |decision| decision.spent))
            }
        };
        let mut node = Node::object([
            ("play", best.map_or(Node::Null, |best| self.frame.play_node(&best.play))),
            ("win_chance", best.map_or(Node::Null, |best| best.stated_win().into())),
        ]);
        add_spent(&mut node, spent);
        node.to_json()
    }

    /// The decision, JSON. Without play and choice it is a concession.
    #[wasm_bindgen(js_name = intoDecision)]
    pub fn into_decision(mut self) -> Result<String, JsValue> {
        let decision = self.decide().map_err(|e| to_exception(&e))?;
        let (play, choice) = match decision.answer {
            Answer::Play(play) => (self.frame.play_node(&play), Node::Null),
            Answer::Choice(choice) => (Node::Null, choice.name().into()),
            Answer::Concede => (Node::Null, Node::Null),
        };
        let win_chance = optional(decision.win_chance);
        let mut node =
            Node::object([("play", play), ("choice", choice), ("win_chance", win_chance)]);
        add_spent(&mut node, decision.spent);
        Ok(node.to_json())
    }

    /// The analysis, JSON.
    #[wasm_bindgen(js_name = intoAnalysis)]
    pub fn into_analysis(self) -> Result<String, JsValue> {
        let frame = self.frame.clone();
        let Analysis { plays, spent } = self.analyse().map_err(|e| to_exception(&e))?;
        let plays = plays.iter().map(|found| recommendation_node(&frame, found));
        let mut node = Node::object([("plays", Node::list(plays))]);
        add_spent(&mut node, spent);
        Ok(node.to_json())
    }
}

fn add_spent(node: &mut Node, spent: Spent) {
    node.set("simulations", spent.simulations as f64);
    node.set("rounds", spent.rounds);
}

/// A number; null for none and for NaN, which JSON does not have.
fn optional(x: impl Into<Option<f64>>) -> Node {
    x.into().filter(|x| !x.is_nan()).map_or(Node::Null, Node::from)
}

fn id(frame: &carom_rules::Frame, ball: BallIndex) -> Node {
    Node::from(&frame.layout().balls()[usize::from(ball)].id)
}

fn recommendation_node(frame: &carom_rules::Frame, found: &Recommendation) -> Node {
    let legs = found.legs.iter();
    let legs = legs.map(|leg| Node::List(vec![id(frame, leg.0), u32::from(leg.1).into()]));
    let (ball, pocket) = match found.pot {
        Some((ball, pocket)) => (id(frame, ball), pocket.name().into()),
        None => (Node::Null, Node::Null),
    };
    Node::object([
        ("kind", found.kind.name().into()),
        ("ball", ball),
        ("pocket", pocket),
        ("legs", Node::list(legs)),
        ("route", found.route.as_ref().map_or(Node::Null, |route| route_node(frame, route))),
        ("play", frame.play_node(&found.play)),
        ("win_chance", found.win.into()),
        ("error", found.error.into()),
        ("samples", (found.kept.variants as f64).into()),
        ("kept", chance_node(&found.kept)),
        ("foul", chance_node(&found.foul)),
        ("win_if_kept", optional(found.win_if_kept)),
        ("win_if_missed", optional(found.win_if_missed)),
        ("leave", leave_node(&found.leave)),
    ])
}

/// In games of carom the shot has all balls of the frame.
fn route_node(frame: &carom_rules::Frame, route: &CaromRoute) -> Node {
    route.to_node(|ball| &frame.layout().balls()[usize::from(ball)].id)
}

fn chance_node(chance: &Chance) -> Node {
    let interval = wilson(chance.met, chance.variants, LEVEL);
    Node::object([
        ("probability", optional(chance.met as f64 / chance.variants as f64)),
        ("low", interval.low.into()),
        ("high", interval.high.into()),
    ])
}

fn leave_node(leave: &Moments) -> Node {
    let [xx, xy, yy] = leave.covariance();
    let row = |row: [f64; 2]| Node::list(row.map(optional));
    Node::object([
        ("count", (leave.count() as f64).into()),
        ("mean", row(leave.mean())),
        ("covariance", Node::List(vec![row([xx, xy]), row([xy, yy])])),
        ("spread", optional(sqrt(xx + yy))),
    ])
}
